// SPDX-License-Identifier: Apache-2.0
// The two functions of awd/image.h that make images of films and of densities.
#include <string>

#include "api/handles.h"
#include "awd/device.h"
#include "awd/image.h"
#include "awd/render.h"
#include "image/image.h"
#include "render/render.h"

using namespace awd;

namespace {

const char* nameOf(AWDGuide guide) {
  return guide == AWD_GUIDE_ADAPTIVE ? "adaptive"
         : guide == AWD_GUIDE_COSINE ? "cosine"
                                     : "uniform";
}

const char* nameOfMap(const Field& field) {
  switch (field.settings().map) {
    case AWD_MAP_SPHERICAL:
      return "spherical";
    case AWD_MAP_CYLINDRICAL:
      return "cylindrical";
    case AWD_MAP_COSINE:
      return "cosine";
    default:
      return "concentric-cosine";
  }
}

const char* nameOfEstimator(const Field& field) {
  switch (field.settings().learning.estimator) {
    case AWD_ESTIMATOR_MIXTURE:
      return "mixture";
    case AWD_ESTIMATOR_RATIO:
      return "ratio";
    case AWD_ESTIMATOR_QUASI:
      return "quasi";
    case AWD_ESTIMATOR_LUMPED:
      return "lumped";
    case AWD_ESTIMATOR_REFIT:
      return "refit";
    default:
      return "paper";
  }
}

std::string version() {
  return std::to_string(AWD_VERSION_MAJOR) + "." + std::to_string(AWD_VERSION_MINOR) + "." +
         std::to_string(AWD_VERSION_PATCH);
}

void describe(const Render& render, Image& image) {
  image.setMetadata("awd.version", version());
  image.setMetadata("awd.guide", nameOf(render.settings().guide));
  image.setMetadata("awd.preset", render.preset() == AWD_PRESET_PAPER ? "paper" : "default");
  image.setMetadata("awd.seed", std::to_string(render.seed()));
  image.setMetadata("awd.shadowRays", std::to_string(render.settings().shadowRays));
  image.setMetadata("awd.samples", std::to_string(render.film().samples()));
  std::string passes;
  for (const AWDPassStatistics& pass : render.statistics()) {
    passes += (passes.empty() ? "" : ",") + std::to_string(pass.samplesPerPixel);
  }
  image.setMetadata("awd.passes", passes);
  if (render.field()) {
    const Field& field = *render.field();
    image.setMetadata("awd.basis", field.family().name());
    image.setMetadata("awd.map", nameOfMap(field));
    image.setMetadata("awd.estimator", nameOfEstimator(field));
    image.setMetadata("awd.maxLevel", std::to_string(field.settings().maxLevel));
  }
}

}  // namespace

extern "C" {

AWDResult AWD_CALL awdNewFilmImage(AWDRender render, AWDImage* image) noexcept {
  return guard(__func__, [&] {
    clearOutput(image, "image");
    const Render& known = object(render, "render");
    const Film& film = known.film();
    Ref<Image> made = Image::make(known.context(), film.width(), film.height());
    const char* names[] = {"R", "G", "B", "variance.R", "variance.G", "variance.B"};
    for (int c = 0; c < 6; ++c) {
      Image::Pixels& pixels = made->addChannel(names[c]);
      for (size_t i = 0; i < pixels.size(); ++i) {
        const Rgb value = c < 3 ? film.mean(i) : film.variance(i);
        pixels[i] = (&value.x)[c % 3];
      }
    }
    Image::Pixels& samples = made->addChannel("samples.Y");
    std::fill(samples.begin(), samples.end(), static_cast<float>(film.samples()));
    describe(known, *made);
    give(image, std::move(made));
  });
}

AWDResult AWD_CALL awdNewPatchImage(AWDField field, uint32_t patch, uint32_t n,
                                    AWDImage* image) noexcept {
  return guard(__func__, [&] {
    clearOutput(image, "image");
    const Field& known = object(field, "field");
    if (n < 1 || n > 16384) fail(AWD_ERROR_INVALID_ARGUMENT, "n is %u: 1 to 16384 is allowed", n);
    Ref<Image> made = Image::make(known.context(), n, n);
    Image::Pixels& pixels = made->addChannel("Y");
    known.pdfImage(patch, n, pixels.data(), n * sizeof(float));
    const AWDPatchInfo info = known.patchInfo(patch);
    made->setMetadata("awd.version", version());
    made->setMetadata("awd.patch", std::to_string(patch & ~AWD_PATCH_BACK));
    made->setMetadata("awd.side", patch & AWD_PATCH_BACK ? "back" : "front");
    made->setMetadata("awd.basis", info.basis);
    made->setMetadata("awd.level", std::to_string(info.level));
    made->setMetadata("awd.map", nameOfMap(known));
    give(image, std::move(made));
  });
}

}  // extern "C"
