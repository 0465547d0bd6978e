// SPDX-License-Identifier: Apache-2.0
// --pdf PATCH:FILE: the density of a patch as a picture.
#pragma once

#include <cstdint>
#include <string>

#include "awd/awd.hpp"

namespace command {

class PdfRequest {
 public:
  /// PATCH is a number; a number and "b" for the back side; or X,Y for the patch under a pixel.
  /// Throws a UsageError if it is none of these or FILE is missing.
  explicit PdfRequest(const std::string& text);

  const std::string& file() const { return file_; }

  /// Finds the patch, before any work is done. Throws a UsageError if there is none. spatial:
  /// patches are the library's, so that only pixels can be told from one another yet.
  void resolve(const awd::Scene& scene, awd::Render& render, bool spatial);

  /// Writes the picture. If no side was asked for it shows the front side, or the back side if
  /// that alone has learned, and notes which.
  void write(const awd::Render& render, const awd::Field& field) const;

 private:
  std::string text_, file_;
  enum { kEitherSide, kBackSide, kPixel } kind_ = kEitherSide;
  bool spatial_ = false;
  uint32_t x_ = 0, y_ = 0, patch_ = 0;
};

}  // namespace command
