// SPDX-License-Identifier: Apache-2.0
#include "paper.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "png_bytes.h"

namespace bench::paper {

LoadedScene loadReferenced(const Study& study, const std::string& name) {
  const auto files = sceneFiles("");
  const auto file = files.find(name);
  if (file == files.end()) throw std::runtime_error("no scene " + name);
  const Options& options = study.options;
  std::optional<Reference> reference;
  if (!options.references.empty()) {
    reference = averageReference(study.device.get(), options.references, name);
  }
  LoadedScene loaded = loadScene(study.device, name, file->second,
                                 reference ? reference->mean.width : options.width);
  if (reference) {
    loaded.reference = std::move(*reference);
  } else if (!takeReference(study.device, options.folder, options.referenceSamples, loaded)) {
    throw Cancelled();
  }
  return loaded;
}

std::string greyPng(const std::vector<float>& values, uint32_t width) {
  command::RgbImage image = {width, static_cast<uint32_t>(values.size() / width), {}};
  const float largest = *std::max_element(values.begin(), values.end());
  for (const float value : values) {
    image.values.insert(image.values.end(), 3, largest > 0.0f ? value / largest : 0.0f);
  }
  return pngOf(image);
}

std::string moreOrLess(double ratio) {
  char text[48];
  std::snprintf(text, sizeof text, "%.1f %% %s", 100.0 * (ratio < 1.0 ? 1.0 - ratio : ratio - 1.0),
                ratio < 1.0 ? "less" : "more");
  return text;
}

}  // namespace bench::paper
