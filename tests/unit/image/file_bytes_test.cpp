// SPDX-License-Identifier: Apache-2.0
#include "image/file_bytes.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "support.h"

namespace awd {
namespace {

using test::errorOf;

using FileBytes = test::ImageTest;

TEST_F(FileBytes, ReadsAllOfAFile) {
  std::string bytes(100000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 31 >> 3);
  for (const std::size_t length : {std::size_t{0}, std::size_t{1}, bytes.size()}) {
    test::writeBytes(path(), bytes.substr(0, length));
    const auto read = readFile(context().memory(), path().c_str());
    EXPECT_EQ(std::string(read.begin(), read.end()), bytes.substr(0, length));
  }
}

TEST_F(FileBytes, SaysWhatIsWrong) {
  const auto read = [&](const std::string& name) {
    return errorOf(AWD_ERROR_IO, [&] { readFile(context().memory(), name.c_str()); });
  };
  EXPECT_CONTAINS(read(path("missing")), "missing\": No such file");
  EXPECT_CONTAINS(read(path("")), "Is a directory");
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_CONTAINS(read(path("pipe")), "not a regular file");
  EXPECT_CONTAINS(read("/dev/zero"), "not a regular file");
}

}  // namespace
}  // namespace awd
