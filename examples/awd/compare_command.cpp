// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>

#include "commands.h"
#include "console.h"
#include "device.h"
#include "failure.h"
#include "metrics.h"
#include "statistics_json.h"

namespace command {
namespace {

struct CompareOptions {
  std::string image, reference;
  bool json = false;
};

/// Channels R G B of a file; all its pixels must be finite.
RgbImage readRgb(const awd::Device& device, const std::string& path) {
  const awd::Image file = awd::Image::read(device, path);
  RgbImage image;
  image.width = file.info().width;
  image.height = file.info().height;
  image.values.resize(std::size_t{3} * image.width * image.height);
  const char* const channels[] = {"R", "G", "B"};
  for (std::size_t c = 0; c < 3; ++c) {
    const awd::ChannelPixels pixels(image.values.data() + c, image.width, image.height,
                                    3 * sizeof(float));
    named(path, [&] { file.readChannel(channels[c], pixels); });
  }
  if (const std::size_t bad = countNonFinite(image)) {
    throw Failure(path + ": " + std::to_string(bad) + " of " +
                  std::to_string(image.values.size() / 3) + " pixels are NaN or infinite");
  }
  return image;
}

std::string describeSize(const std::string& path, const RgbImage& image) {
  return path + " has " + std::to_string(image.width) + " x " + std::to_string(image.height) +
         " pixels";
}

/// Averages the larger of two images down to the size of the other.
void matchSizes(const CompareOptions& options, RgbImage& image, RgbImage& reference) {
  const bool imageIsLarger = image.width > reference.width;
  RgbImage& large = imageIsLarger ? image : reference;
  const RgbImage& small = imageIsLarger ? reference : image;
  const std::optional<uint32_t> ratio = sizeRatio(large, small);
  if (!ratio) {
    throw Failure(describeSize(options.image, image) + " but " +
                  describeSize(options.reference, reference) +
                  ": one must be a whole number of times as large as the other");
  }
  if (*ratio == 1) return;
  large = boxFilter(large, *ratio);
  note((imageIsLarger ? options.image : options.reference) + " is averaged over " +
       std::to_string(*ratio) + " x " + std::to_string(*ratio) + " pixels to match");
}

void printText(const Metrics& metrics) {
  std::printf("L1              %.6g\n", metrics.l1);
  std::printf("relMSE          %.6g\n", metrics.relMse);
  std::printf("relMSE trimmed  %.6g\n", metrics.relMseTrimmed);
  const std::array<double, 3>&a = metrics.mean, &r = metrics.meanReference;
  std::printf("mean RGB        %.6g %.6g %.6g\n", a[0], a[1], a[2]);
  std::printf("reference RGB   %.6g %.6g %.6g\n", r[0], r[1], r[2]);
}

int compare(const CompareOptions& options) {
  const awd::Device device = openDevice();
  RgbImage image = readRgb(device, options.image);
  RgbImage reference = readRgb(device, options.reference);
  matchSizes(options, image, reference);
  const Metrics metrics = compareImages(image, reference);
  if (std::isnan(metrics.relMse)) {
    warn(options.reference + " is black: there is no relative error");
  }
  if (options.json) {
    // NaN becomes null.
    std::fputs(toText({{"l1", metrics.l1},
                       {"relmse", metrics.relMse},
                       {"relmse_trimmed", metrics.relMseTrimmed},
                       {"mean_a", metrics.mean},
                       {"mean_ref", metrics.meanReference}})
                   .c_str(),
               stdout);
  } else {
    printText(metrics);
  }
  return kDone;
}

}  // namespace

void addCompareCommand(CLI::App& program, Action& action) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command =
      program.add_subcommand("compare", "Tell how far an image is from a reference");
  command->footer(
      "L1: mean absolute difference. relMSE: mean of squared differences relative to the "
      "reference;\n"
      "trimmed: without the worst 0.1 % of the pixels. The larger of two images of different size "
      "is\n"
      "averaged down. Images with NaN or infinite pixels are refused.");
  command->add_option("A", options->image, "OpenEXR file")->required();
  command->add_option("REF", options->reference, "OpenEXR file of the reference")->required();
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&action, options] { action = [options] { return compare(*options); }; });
}

}  // namespace command
