// SPDX-License-Identifier: Apache-2.0
#include "plot_canvas.h"

#include <cairo-svg.h>

#include <cmath>
#include <iterator>
#include <memory>
#include <stdexcept>

namespace bench {
namespace {

constexpr double kPixelsPerPoint = 1.5;  // of the PNG

/// Okabe and Ito's colours, which the colour-blind can tell apart, without the yellow, which is
/// weak on white.
constexpr PlotColor kColors[] = {{0.0, 0.0, 0.0},      {0.835, 0.369, 0.0}, {0.0, 0.447, 0.698},
                                 {0.0, 0.62, 0.451},   {0.8, 0.475, 0.655}, {0.902, 0.624, 0.0},
                                 {0.337, 0.706, 0.914}};
constexpr PlotColor kText = {0.1, 0.1, 0.1};

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

cairo_status_t append(void* text, const unsigned char* bytes, unsigned count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw std::runtime_error(std::string("Cairo: ") + cairo_status_to_string(status));
}

void drawOn(cairo_surface_t* surface, double scale, const DrawPlot& draw) {
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo(cairo_create(surface),
                                                                 cairo_destroy);
  cairo_scale(cairo.get(), scale, scale);
  draw(PlotCanvas(cairo.get()));
  check(cairo_status(cairo.get()));
}

Surface newImage(int width, int height) {
  return {cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), cairo_surface_destroy};
}

}  // namespace

PlotCanvas::PlotCanvas(cairo_t* cairo) : cairo_(cairo) {
  set({1.0, 1.0, 1.0});
  cairo_paint(cairo_);
}

void PlotCanvas::text(double x, double y, const std::string& words, double size, PlotAlign align,
                      bool bold) const {
  font(size, bold);
  set(kText);
  const double before = align == PlotAlign::kLeft ? 0.0 : align == PlotAlign::kRight ? 1.0 : 0.5;
  cairo_move_to(cairo_, x - before * advance(words), y);
  cairo_show_text(cairo_, words.c_str());
}

void PlotCanvas::upwards(double x, double y, const std::string& words, double size) const {
  cairo_save(cairo_);
  cairo_translate(cairo_, x, y);
  cairo_rotate(cairo_, -M_PI / 2.0);
  text(0.0, 0.0, words, size, PlotAlign::kCentre);
  cairo_restore(cairo_);
}

double PlotCanvas::width(const std::string& words, double size, bool bold) const {
  font(size, bold);
  return advance(words);
}

void PlotCanvas::line(double x0, double y0, double x1, double y1, PlotColor color,
                      double thickness) const {
  set(color);
  cairo_set_line_width(cairo_, thickness);
  cairo_move_to(cairo_, x0, y0);
  cairo_line_to(cairo_, x1, y1);
  cairo_stroke(cairo_);
}

void PlotCanvas::frame(double x, double y, double width, double height, PlotColor color) const {
  set(color);
  cairo_set_line_width(cairo_, 0.8);
  cairo_rectangle(cairo_, x, y, width, height);
  cairo_stroke(cairo_);
}

void PlotCanvas::marker(double x, double y, std::size_t style) const {
  constexpr double r = 2.8;
  set(colorOf(style));
  switch (style % 6) {
    case 0:
      cairo_arc(cairo_, x, y, r, 0.0, 2.0 * M_PI);
      break;
    case 1:
      cairo_rectangle(cairo_, x - r, y - r, 2.0 * r, 2.0 * r);
      break;
    case 2:
      polygon(x, y, 1.25 * r, 3, M_PI / 2.0);
      break;
    case 3:
      polygon(x, y, 1.25 * r, 4, 0.0);
      break;
    case 4:
      polygon(x, y, 1.25 * r, 3, -M_PI / 2.0);
      break;
    default:
      cairo_set_line_width(cairo_, 1.2);
      cairo_move_to(cairo_, x - r, y - r);
      cairo_line_to(cairo_, x + r, y + r);
      cairo_move_to(cairo_, x - r, y + r);
      cairo_line_to(cairo_, x + r, y - r);
      cairo_stroke(cairo_);
      return;
  }
  cairo_fill(cairo_);
}

PlotColor PlotCanvas::colorOf(std::size_t style) { return kColors[style % std::size(kColors)]; }

void PlotCanvas::set(PlotColor color) const {
  cairo_set_source_rgb(cairo_, color.r, color.g, color.b);
}

void PlotCanvas::font(double size, bool bold) const {
  cairo_select_font_face(cairo_, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo_, size);
}

double PlotCanvas::advance(const std::string& words) const {
  cairo_text_extents_t extents;
  cairo_text_extents(cairo_, words.c_str(), &extents);
  return extents.x_advance;
}

void PlotCanvas::polygon(double x, double y, double radius, int corners, double turn) const {
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + 2.0 * M_PI * i / corners;
    cairo_line_to(cairo_, x + radius * std::cos(angle), y - radius * std::sin(angle));
  }
  cairo_close_path(cairo_);
}

void drawNowhere(const DrawPlot& draw) { drawOn(newImage(1, 1).get(), 1.0, draw); }

std::string drawSvg(double width, double height, const DrawPlot& draw) {
  std::string text;
  const Surface surface(cairo_svg_surface_create_for_stream(append, &text, width, height),
                        cairo_surface_destroy);
  drawOn(surface.get(), 1.0, draw);
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
  return text;
}

std::string drawPng(double width, double height, const DrawPlot& draw) {
  const Surface surface = newImage(static_cast<int>(std::ceil(width * kPixelsPerPoint)),
                                   static_cast<int>(std::ceil(height * kPixelsPerPoint)));
  drawOn(surface.get(), kPixelsPerPoint, draw);
  std::string bytes;
  check(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
  return bytes;
}

}  // namespace bench
