// SPDX-License-Identifier: Apache-2.0
#include "image/exr_names.h"

#include <ImfHeader.h>
#include <gtest/gtest.h>

namespace awd {
namespace {

TEST(ExrNames, ReservesEveryAttributeOfAHeader) {
  Imf::Header header;
  header.setTileDescription({});
  header.setVersion(1);
  header.setChunkCount(1);
  header.setName("name");
  header.setType("scanlineimage");
  header.setView("view");
  int count = 0;
  for (auto i = header.begin(); i != header.end(); ++i, ++count) {
    EXPECT_TRUE(isReservedAttribute(i.name())) << i.name();
  }
  EXPECT_EQ(count, 14);
}

TEST(ExrNames, ReservesStandardAttributesThatAreNotText) {
  for (const char* name : {"chromaticities", "whiteLuminance", "timeCode", "worldToCamera"}) {
    EXPECT_TRUE(isReservedAttribute(name)) << name;
  }
  for (const char* name : {"owner", "comments", "capDate", "wrapmodes", "awd.seed", "Channels",
                           "channel", "name2", ""}) {
    EXPECT_FALSE(isReservedAttribute(name)) << name;
  }
}

}  // namespace
}  // namespace awd
