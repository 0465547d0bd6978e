// SPDX-License-Identifier: Apache-2.0
#include "render_reference.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "support/handles.h"

namespace bench {
namespace {

namespace fs = std::filesystem;
using awdtest::must;
using command::RgbImage;

constexpr const char* kColors[] = {"R", "G", "B"};
constexpr const char* kVariances[] = {"variance.R", "variance.G", "variance.B"};

RgbImage readImage(AWDDevice device, const std::string& path, const char* const (&channels)[3]) {
  awdtest::Image file;
  must(awdReadImage(device, path.c_str(), file.out()));
  RgbImage image;
  must(awdGetImageInfo(file, &image.width, &image.height, nullptr));
  image.values.resize(std::size_t{3} * image.width * image.height);
  for (std::size_t c = 0; c < 3; ++c) {
    must(awdGetImageChannel(file, channels[c], &image.values[c], 3 * sizeof(float),
                            std::size_t{3} * image.width * sizeof(float)));
  }
  return image;
}

/// relMSE of an image whose pixels vary that much.
double errorOf(const RgbImage& mean, const RgbImage& variance) {
  RgbImage off = mean;
  for (std::size_t i = 0; i < off.values.size(); ++i)
    off.values[i] += std::sqrt(variance.values[i]);
  return command::compareImages(off, mean).relMse;
}

std::vector<std::string> filesOf(const std::string& folder, const std::string& scene) {
  if (!fs::is_directory(folder)) throw std::runtime_error("no folder of references: " + folder);
  std::vector<std::string> files;
  for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
    const std::string stem = file.path().stem().string();
    const std::size_t dash = stem.rfind('-');
    if (file.path().extension() == ".exr" && dash != std::string::npos &&
        stem.substr(0, dash) == scene) {
      files.push_back(file.path().string());
    }
  }
  std::sort(files.begin(), files.end());  // sums by the same order everywhere
  return files;
}

}  // namespace

std::optional<Reference> averageReference(AWDDevice device, const std::string& folder,
                                          const std::string& scene) {
  const std::vector<std::string> files = filesOf(folder, scene);
  if (files.empty()) return std::nullopt;
  Reference reference;
  RgbImage& mean = reference.mean;
  // By Welford's updates, which do not cancel where the files hardly differ.
  std::vector<double> means, squares;
  double count = 0.0;
  for (const std::string& file : files) {
    const RgbImage image = readImage(device, file, kColors);
    if (count == 0.0) {
      mean = {image.width, image.height, std::vector<float>(image.values.size())};
      means.resize(image.values.size());
      squares.resize(image.values.size());
    } else if (image.width != mean.width || image.height != mean.height) {
      throw std::runtime_error(file + ": not of the size of " + files.front());
    }
    count += 1.0;
    for (std::size_t i = 0; i < means.size(); ++i) {
      const double before = image.values[i] - means[i];
      means[i] += before / count;
      squares[i] += before * (image.values[i] - means[i]);
    }
  }
  const auto toFloat = [](double value) { return static_cast<float>(value); };
  std::transform(means.begin(), means.end(), mean.values.begin(), toFloat);
  reference.files = files.size();
  if (files.size() == 1) return reference;
  reference.variance = mean;
  std::transform(squares.begin(), squares.end(), reference.variance.values.begin(),
                 [&](double sum) { return toFloat(sum / (count * (count - 1.0))); });
  reference.relMse = errorOf(mean, reference.variance);
  return reference;
}

std::optional<Reference> committedReference(AWDDevice device, const std::string& sceneFile,
                                            const AWDCamera& camera) {
  const fs::path path = fs::path(sceneFile).parent_path() / "reference.exr";
  if (!fs::exists(path)) return std::nullopt;
  Reference reference;
  reference.mean = readImage(device, path.string(), kColors);
  const auto ratio = command::sizeRatio(reference.mean, {camera.width, camera.height, {}});
  if (!ratio) throw std::runtime_error(path.string() + ": no multiple of the image's size");
  if (*ratio > 1) reference.mean = command::boxFilter(reference.mean, *ratio);
  return reference;
}

Reference readFilm(AWDDevice device, const std::string& path) {
  Reference reference;
  reference.mean = readImage(device, path, kColors);
  reference.variance = readImage(device, path, kVariances);
  reference.relMse = errorOf(reference.mean, reference.variance);
  return reference;
}

}  // namespace bench
