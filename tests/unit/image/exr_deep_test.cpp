// SPDX-License-Identifier: Apache-2.0
#include "image/exr_deep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exr_files.h"
#include "image/exr_read.h"
#include "support.h"

namespace awd {
namespace {

using test::DeepSample;
using test::FileKind;

class ExrDeep : public test::ImageTest {
 protected:
  Ref<Image> written(const FileKind& kind, bool tiles,
                     const std::vector<std::vector<DeepSample>>& samples) {
    test::writeDeep(path(), kind, tiles, samples);
    return readExr(context(), path().c_str());
  }
};

TEST_F(ExrDeep, CompositesEveryPixelFromNearToFar) {
  for (const Imf::Compression compression :
       {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION}) {
    for (const bool tiles : {false, true}) {
      FileKind kind;
      kind.compression = compression;
      kind.left = -7;
      kind.top = 100;
      const auto samples = test::someSamples(kind);
      const Ref<Image> image = written(kind, tiles, samples);
      ASSERT_EQ(image->channels().size(), 3u);
      for (std::size_t i = 0; i < samples.size(); ++i) {
        // From far to near, the other way round than in the library.
        auto sorted = samples[i];
        std::sort(sorted.begin(), sorted.end(),
                  [](const DeepSample& a, const DeepSample& b) { return a.z > b.z; });
        double red = 0, alpha = 0;
        for (const DeepSample& sample : sorted) {
          red = sample.r + (1 - sample.a) * red;
          alpha = sample.a + (1 - sample.a) * alpha;
        }
        EXPECT_NEAR((*image->channel("R"))[i], red, 1e-6) << i;
        EXPECT_NEAR((*image->channel("A"))[i], alpha, 1e-6) << i;
        EXPECT_EQ((*image->channel("Z"))[i], sorted.empty() ? 0 : sorted.back().z) << i;
      }
    }
  }
}

TEST_F(ExrDeep, OddSamples) {
  FileKind kind;
  kind.width = 5;
  kind.height = 1;
  kind.compression = Imf::ZIPS_COMPRESSION;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::vector<DeepSample> many(1000, {5, 0, 0.001f});
  many[500] = {1, 1, 0.25f};
  const Ref<Image> image = written(kind, false,
                                   {{{NAN, 1, 7}, {infinity, 1, 3}, {2, 0.5f, 1}},
                                    {{-1, 0, 1}, {-2, 0, 2}},
                                    many,
                                    {{1, 1, infinity}, {2, 1, 5}},
                                    {}});
  const std::vector<float> red = {2.5f, 3, 0.25f, infinity, 0};
  EXPECT_TRUE(test::sameBits(image->channel("R"), red));
  const std::vector<float> depth = {2, -2, 1, 1, 0};
  EXPECT_TRUE(test::sameBits(image->channel("Z"), depth));
}

TEST_F(ExrDeep, RefusesSampleCountsThatTheFileCantHold) {
  FileKind kind;
  kind.width = kind.height = 4;
  kind.compression = Imf::NO_COMPRESSION;
  const std::vector<std::vector<DeepSample>> one(16, {{1, 1, 1}});
  test::writeDeep(path(), kind, false, one);
  std::string bytes = test::readBytes(path());
  // A row's counts add up: 1 2 3 4. It claims 2^24 samples instead, with as many bytes.
  const std::string counts("\1\0\0\0\2\0\0\0\3\0\0\0\4\0\0\0", 16);
  const std::size_t at = bytes.find(counts);
  ASSERT_NE(at, std::string::npos);
  bytes[at + 15] = 1;
  bytes[at - 8 + 3] = 0x20;
  test::writeBytes(path(), bytes);
  EXPECT_CONTAINS(test::errorOf(AWD_ERROR_IO, [&] { readExr(context(), path().c_str()); }),
                  "sample counts");
  EXPECT_LT(counter_.peak, 1u << 20);
}

}  // namespace
}  // namespace awd
