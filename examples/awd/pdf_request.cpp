// SPDX-License-Identifier: Apache-2.0
#include "pdf_request.h"

#include <charconv>
#include <string_view>

#include "console.h"
#include "failure.h"

namespace command {
namespace {

constexpr uint32_t kImageSize = 256;

/// Takes a number off the front of `text`.
bool takeNumber(std::string_view& text, uint32_t& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc();
}

bool hasLearned(const awd::Field& field, uint32_t patch) {
  return field.patchInfo(patch).learned > 0;
}

std::string describe(uint32_t patch, bool spatial) {
  if (spatial) return "patch " + std::to_string(patch);
  return "patch " + std::to_string(patch & ~AWD_PATCH_BACK) +
         (patch & AWD_PATCH_BACK ? ", back side" : ", front side");
}

}  // namespace

PdfRequest::PdfRequest(const std::string& text) : text_("--pdf " + text) {
  std::string_view rest = text;
  bool good = takeNumber(rest, patch_);
  if (good && !rest.empty() && rest.front() == ',') {
    kind_ = kPixel;
    x_ = patch_;
    rest.remove_prefix(1);
    good = takeNumber(rest, y_);
  } else if (good && !rest.empty() && rest.front() == 'b') {
    kind_ = kBackSide;
    rest.remove_prefix(1);
  }
  if (!good || rest.size() < 2 || rest.front() != ':') {
    throw UsageError(text_ +
                     ": give PATCH:FILE.png, where PATCH is a number, a number and b for "
                     "the back side, or X,Y for the patch under a pixel");
  }
  file_ = rest.substr(1);
}

void PdfRequest::resolve(const awd::Scene& scene, awd::Render& render, bool spatial) {
  spatial_ = spatial;
  if (kind_ == kPixel) {
    const awd::FilmInfo film = render.filmInfo();
    if (x_ >= film.width || y_ >= film.height) {
      throw UsageError(text_ + ": the image has " + std::to_string(film.width) + " x " +
                       std::to_string(film.height) + " pixels");
    }
    patch_ = render.pixelPatch(x_, y_);
    if (patch_ == AWD_INVALID_ID) throw UsageError(text_ + ": nothing is seen in that pixel");
    return;
  }
  if (spatial) return;  // what numbers there will be is not known yet
  if (patch_ >= scene.info().patches) throw UsageError(text_ + ": the scene has no such patch");
  if (kind_ == kBackSide) patch_ |= AWD_PATCH_BACK;
}

void PdfRequest::write(const awd::Render& render, const awd::Field& field) const {
  uint32_t patch = kind_ == kPixel ? render.pixelPatch(x_, y_) : patch_;
  if (kind_ == kEitherSide && !spatial_ && !hasLearned(field, patch) &&
      hasLearned(field, patch | AWD_PATCH_BACK)) {
    patch |= AWD_PATCH_BACK;
  }
  note(file_ + ": " + describe(patch, spatial_) +
       (hasLearned(field, patch) ? "" : ", which has learned nothing: its start density"));
  awd::Image::ofPatch(field, patch, kImageSize).writePNG(file_);
}

}  // namespace command
