// SPDX-License-Identifier: Apache-2.0
// What plots are drawn with: texts, lines and markers, on SVG or PNG, by Cairo.
#pragma once

#include <cairo.h>

#include <cstddef>
#include <functional>
#include <string>

namespace bench {

struct PlotColor {
  double r, g, b;
};

enum class PlotAlign { kLeft, kCentre, kRight };

/// Lengths are points, y goes downwards, and texts stand on theirs.
class PlotCanvas {
 public:
  explicit PlotCanvas(cairo_t* cairo);

  void text(double x, double y, const std::string& words, double size, PlotAlign align,
            bool bold = false) const;
  /// Centred, along a line that goes up.
  void upwards(double x, double y, const std::string& words, double size) const;
  double width(const std::string& words, double size, bool bold = false) const;

  void line(double x0, double y0, double x1, double y1, PlotColor color, double thickness) const;
  void frame(double x, double y, double width, double height, PlotColor color) const;
  /// One marker a style, so that colour isn't all that tells.
  void marker(double x, double y, std::size_t style) const;

  static PlotColor colorOf(std::size_t style);

 private:
  void set(PlotColor color) const;
  void font(double size, bool bold) const;
  double advance(const std::string& words) const;
  void polygon(double x, double y, double radius, int corners, double turn) const;

  cairo_t* cairo_;
};

using DrawPlot = std::function<void(const PlotCanvas&)>;

/// For what must be measured before it is drawn.
void drawNowhere(const DrawPlot& draw);
/// The bytes of a file.
std::string drawSvg(double width, double height, const DrawPlot& draw);
std::string drawPng(double width, double height, const DrawPlot& draw);

}  // namespace bench
