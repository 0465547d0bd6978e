// SPDX-License-Identifier: Apache-2.0
// OpenEXR files that anyone may have made.
#include <limits>

#include "bounded_device.h"
#include "exr_seeds.h"
#include "require.h"
#include "scratch_file.h"
#include "support/handles.h"
#include "target.h"

namespace fuzz {

namespace {

using awdtest::Image;

void run(const uint8_t* data, std::size_t size) {
  const std::string path = scratchPath("image.exr");
  writeScratch(path, {data, data + size});
  const Bounds bounds(std::size_t{256} << 20);
  Image image;
  if (!oneOf(awdReadImage(bounds.device(), path.c_str(), image.out()),
             {AWD_ERROR_IO, AWD_ERROR_UNSUPPORTED, AWD_ERROR_OUT_OF_MEMORY}, "read")) {
    return;
  }
  uint32_t width = 0, height = 0, channels = 0;
  require(awdGetImageInfo(image, &width, &height, &channels) == AWD_SUCCESS, "no size");
  require(width >= 1 && width <= 65536 && height >= 1 && height <= 65536, "no such size");
  for (uint32_t i = 0; i < channels; ++i) {
    const char* name = nullptr;
    require(awdGetImageChannelName(image, i, &name) == AWD_SUCCESS && name, "no name");
  }
  if (uint64_t{width} * height * channels > 1u << 16) return;
  oneOf(awdWriteImagePNG(image, scratchPath("image.png").c_str(), nullptr),
        {AWD_ERROR_INVALID_OPERATION, AWD_ERROR_UNSUPPORTED}, "png");
  // A file may have names that we don't write, but then it says so.
  if (oneOf(awdWriteImageEXR(image, path.c_str()),
            {AWD_ERROR_INVALID_OPERATION, AWD_ERROR_INVALID_ARGUMENT, AWD_ERROR_IO}, "exr")) {
    Image again;
    require(awdReadImage(bounds.device(), path.c_str(), again.out()) == AWD_SUCCESS,
            "what was written can't be read");
  }
}

std::vector<Input> seeds() {
  std::vector<Input> result;
  for (const std::string& file : awdtest::exrSeeds(scratchPath("seed.exr"))) {
    result.push_back(inputOf(file));
  }
  return result;
}

}  // namespace

const Target kExr = {"exr", run, seeds};

}  // namespace fuzz
