// SPDX-License-Identifier: Apache-2.0
// What the test scripts need besides the shell: looks into JSON and OpenEXR files, makes images.
//   cli-tool json FILE POINTER            the value at a JSON pointer, or exit code 1
//   cli-tool make FILE WIDTH HEIGHT V...  an image of R G B, the numbers repeated to fill it
//   cli-tool pixel FILE X Y               R G B
//   cli-tool channels FILE                names of channels, one a line
//   cli-tool metadata FILE KEY            its text, or exit code 1
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "awd/awd.h"

namespace {

void check(AWDResult result) {
  if (result == AWD_SUCCESS) return;
  std::fprintf(stderr, "%s\n", awdGetLastErrorMessage());
  std::exit(2);
}

AWDDevice device() {
  AWDDevice device = nullptr;
  check(awdNewDevice(nullptr, &device));
  return device;
}

AWDImage open(const char* path) {
  const AWDDevice opener = device();
  AWDImage image = nullptr;
  check(awdReadImage(opener, path, &image));
  awdReleaseDevice(opener);
  return image;
}

int json(const char* path, const char* pointer) {
  std::ifstream file(path);
  const nlohmann::json value = nlohmann::json::parse(file, nullptr, false);
  if (value.is_discarded()) return 1;
  const nlohmann::json::json_pointer place(pointer);
  if (!value.contains(place)) return 1;
  std::puts(value.at(place).dump().c_str());
  return 0;
}

int make(const char* path, const char* width, const char* height, char** values, int valueCount) {
  const uint32_t w = static_cast<uint32_t>(std::atoi(width));
  const uint32_t h = static_cast<uint32_t>(std::atoi(height));
  std::vector<float> pixels(std::size_t{3} * w * h);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    pixels[i] = std::strtof(values[i % static_cast<std::size_t>(valueCount)], nullptr);
  }
  const AWDDevice opener = device();
  AWDImage image = nullptr;
  check(awdNewImage(opener, w, h, &image));
  const char* const names[] = {"R", "G", "B"};
  for (std::size_t c = 0; c < 3; ++c) {
    check(awdSetImageChannel(image, names[c], pixels.data() + c, 3 * sizeof(float),
                             std::size_t{3} * w * sizeof(float)));
  }
  check(awdWriteImageEXR(image, path));
  awdReleaseImage(image);
  awdReleaseDevice(opener);
  return 0;
}

int pixel(const char* path, const char* x, const char* y) {
  const AWDImage image = open(path);
  uint32_t width = 0, height = 0;
  check(awdGetImageInfo(image, &width, &height, nullptr));
  std::vector<float> channel(std::size_t{1} * width * height);
  for (const char* name : {"R", "G", "B"}) {
    check(awdGetImageChannel(image, name, channel.data(), 0, 0));
    const std::size_t index =
        static_cast<std::size_t>(std::atoi(y)) * width + static_cast<std::size_t>(std::atoi(x));
    std::printf("%.7g%s", static_cast<double>(channel.at(index)), *name == 'B' ? "\n" : " ");
  }
  awdReleaseImage(image);
  return 0;
}

int channels(const char* path) {
  const AWDImage image = open(path);
  uint32_t count = 0;
  check(awdGetImageInfo(image, nullptr, nullptr, &count));
  for (uint32_t i = 0; i < count; ++i) {
    const char* name = nullptr;
    check(awdGetImageChannelName(image, i, &name));
    std::puts(name);
  }
  awdReleaseImage(image);
  return 0;
}

int metadata(const char* path, const char* key) {
  const AWDImage image = open(path);
  const char* value = nullptr;
  check(awdGetImageMetadata(image, key, &value));
  if (value) std::puts(value);
  const int code = value ? 0 : 1;
  awdReleaseImage(image);
  return code;
}

}  // namespace

int main(int count, char** words) {
  const std::string what = count > 2 ? words[1] : "";
  if (what == "json" && count == 4) return json(words[2], words[3]);
  if (what == "make" && count > 5) return make(words[2], words[3], words[4], words + 5, count - 5);
  if (what == "pixel" && count == 5) return pixel(words[2], words[3], words[4]);
  if (what == "channels" && count == 3) return channels(words[2]);
  if (what == "metadata" && count == 4) return metadata(words[2], words[3]);
  std::fputs("cli-tool: see its source\n", stderr);
  return 2;
}
