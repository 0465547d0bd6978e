// SPDX-License-Identifier: Apache-2.0
#include "plot.h"

#ifdef AWD_BENCH_CAIRO
#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include "plot_canvas.h"
#include "plot_scale.h"
#include "write_file.h"

namespace bench {
namespace {

// In points.
constexpr double kPanelWidth = 168.0, kPanelHeight = 132.0;
constexpr double kGap = 12.0;         // between panels that share their scales
constexpr double kTickRoom = 40.0;    // left of labelled panels
constexpr double kTickHeight = 16.0;  // below them
constexpr double kPanelTitle = 17.0;  // above each panel
constexpr double kMargin = 14.0;
constexpr double kLeastWidth = 440.0;
constexpr double kLine = 17.0;  // of title, legend and axis labels
constexpr double kTitleSize = 14.0, kTextSize = 10.5, kTickSize = 9.0;

constexpr PlotColor kGrid = {0.9, 0.9, 0.9}, kFrame = {0.4, 0.4, 0.4};

struct Box {
  double x, y, width, height;
};

/// Where everything is, which SVG and PNG share.
class Layout {
 public:
  explicit Layout(const Plot& plot) : plot_(plot), names_(plot.names) {
    for (const PlotPanel& panel : plot.panels) {
      for (const PlotSeries& series : panel.series) {
        const std::size_t number = style(series.name);
        if (number == names_.size()) names_.push_back(series.name);
        used_.insert(number);
      }
    }
    columns_ = std::max<std::size_t>(1, std::min(plot.columns, plot.panels.size()));
    rows_ = (plot.panels.size() + columns_ - 1) / columns_;
    strideX_ = kPanelWidth + (plot.shared ? kGap : kTickRoom + kGap);
    strideY_ = kPanelTitle + kPanelHeight + kGap + (plot.shared ? 0.0 : kTickHeight);
    left_ = kMargin + kLine + kTickRoom;
    panelsWidth_ = strideX_ * static_cast<double>(columns_ - 1) + kPanelWidth;
    // Narrow plots have room for their title and legend.
    width_ = std::max(kLeastWidth, left_ + panelsWidth_ + kMargin);
    settleScales();
  }

  /// Draws all.
  void draw(const PlotCanvas& canvas) const {
    double y = kMargin + kTitleSize;
    canvas.text(kMargin, y, plot_.title, kTitleSize, PlotAlign::kLeft, true);
    for (const std::string& line : wrapped(canvas, plot_.subtitle)) {
      canvas.text(kMargin, y += kLine, line, kTextSize, PlotAlign::kLeft);
    }
    y = drawLegend(canvas, y + kLine);
    const double top = y + 6.0;
    for (std::size_t i = 0; i < plot_.panels.size(); ++i) drawPanel(canvas, i, top);
    const double bottom = top + strideY_ * static_cast<double>(rows_) + kTickHeight;
    canvas.text(left_ + 0.5 * panelsWidth_, bottom, plot_.x.label, kTextSize, PlotAlign::kCentre);
    canvas.upwards(kMargin + kTextSize - 2.0, 0.5 * (top + bottom), plot_.y.label, kTextSize);
  }

  double width() const { return width_; }
  double height(const PlotCanvas& canvas) const {
    const double lines =
        (plot_.subtitle.empty() ? 1.0 : 2.0) + static_cast<double>(legendLines(canvas)) + 1.0;
    return 2.0 * kMargin + kTitleSize + lines * kLine + strideY_ * static_cast<double>(rows_);
  }

 private:
  std::size_t style(const std::string& name) const {
    return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
  }

  void settleScales() {
    xs_.assign(plot_.panels.size(), PlotScale(plot_.x.logarithmic));
    ys_.assign(plot_.panels.size(), PlotScale(plot_.y.logarithmic));
    for (std::size_t i = 0; i < xs_.size(); ++i) {
      for (std::size_t k = 0; k < xs_.size(); ++k) {
        const bool sameX = i == k || (plot_.shared && i % columns_ == k % columns_);
        const bool sameY = i == k || (plot_.shared && i / columns_ == k / columns_);
        for (const PlotSeries& series : plot_.panels[k].series) {
          for (const PlotPoint& point : series.points) {
            if (!shows(i, point)) continue;
            if (sameX) xs_[i].include(point.x);
            if (!sameY) continue;
            ys_[i].include(point.y);
            ys_[i].include(point.low);
            ys_[i].include(point.high);
          }
        }
      }
    }
    for (PlotScale& scale : xs_) scale.settle();
    for (PlotScale& scale : ys_) scale.settle();
  }

  bool shows(std::size_t panel, const PlotPoint& point) const {
    return xs_[panel].shows(point.x) && ys_[panel].shows(point.y);
  }

  /// Lines of words that fit into the width.
  std::vector<std::string> wrapped(const PlotCanvas& canvas, const std::string& text) const {
    std::vector<std::string> lines;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
      const std::string longer = lines.empty() ? word : lines.back() + " " + word;
      const bool fits = canvas.width(longer, kTextSize) <= width_ - 2.0 * kMargin;
      if (lines.empty() || !fits) {
        lines.push_back(word);
      } else {
        lines.back() = longer;
      }
    }
    return lines;
  }

  static double entryWidth(const PlotCanvas& canvas, const std::string& name) {
    return 30.0 + canvas.width(name, kTextSize) + 16.0;
  }

  std::size_t legendLines(const PlotCanvas& canvas) const {
    std::size_t lines = 1;
    double x = kMargin;
    for (const std::size_t i : used_) {
      const double width = entryWidth(canvas, names_[i]);
      if (x > kMargin && x + width > width_) {
        x = kMargin;
        ++lines;
      }
      x += width;
    }
    return lines;
  }

  double drawLegend(const PlotCanvas& canvas, double y) const {
    double x = kMargin;
    for (const std::size_t i : used_) {
      const double width = entryWidth(canvas, names_[i]);
      if (x > kMargin && x + width > width_) {
        x = kMargin;
        y += kLine;
      }
      canvas.line(x, y - 3.5, x + 24.0, y - 3.5, PlotCanvas::colorOf(i), 1.4);
      canvas.marker(x + 12.0, y - 3.5, i);
      canvas.text(x + 30.0, y, names_[i], kTextSize, PlotAlign::kLeft);
      x += width;
    }
    return y;
  }

  void drawPanel(const PlotCanvas& canvas, std::size_t index, double top) const {
    const PlotPanel& panel = plot_.panels[index];
    if (panel.series.empty()) return;
    const std::size_t column = index % columns_, row = index / columns_;
    const Box box = {left_ + strideX_ * static_cast<double>(column),
                     top + strideY_ * static_cast<double>(row) + kPanelTitle, kPanelWidth,
                     kPanelHeight};
    const bool last =
        index + columns_ >= plot_.panels.size() || plot_.panels[index + columns_].series.empty();
    drawTicks(canvas, index, box, !plot_.shared || column == 0, !plot_.shared || last);
    canvas.frame(box.x, box.y, box.width, box.height, kFrame);
    canvas.text(box.x + 0.5 * box.width, box.y - 4.5, panel.title, kTextSize, PlotAlign::kCentre);
    for (const PlotSeries& series : panel.series) drawSeries(canvas, index, box, series);
  }

  void drawTicks(const PlotCanvas& canvas, std::size_t index, const Box& box, bool left,
                 bool below) const {
    for (const PlotTick& tick : xs_[index].ticks()) {
      const double x = box.x + box.width * xs_[index].place(tick.value);
      const bool major = !tick.label.empty();
      if (major) canvas.line(x, box.y, x, box.y + box.height, kGrid, 0.7);
      canvas.line(x, box.y + box.height, x, box.y + box.height - (major ? 4.0 : 2.0), kFrame, 0.7);
      if (below) {
        canvas.text(x, box.y + box.height + 11.0, tick.label, kTickSize, PlotAlign::kCentre);
      }
    }
    for (const PlotTick& tick : ys_[index].ticks()) {
      const double y = box.y + box.height * (1.0 - ys_[index].place(tick.value));
      const bool major = !tick.label.empty();
      if (major) canvas.line(box.x, y, box.x + box.width, y, kGrid, 0.7);
      canvas.line(box.x, y, box.x + (major ? 4.0 : 2.0), y, kFrame, 0.7);
      if (left) canvas.text(box.x - 4.0, y + 3.2, tick.label, kTickSize, PlotAlign::kRight);
    }
  }

  void drawSeries(const PlotCanvas& canvas, std::size_t index, const Box& box,
                  const PlotSeries& series) const {
    const std::size_t number = style(series.name);
    const PlotColor color = PlotCanvas::colorOf(number);
    const auto up = [&](double y) { return box.y + box.height * (1.0 - ys_[index].place(y)); };
    bool drawing = false;
    double lastX = 0.0, lastY = 0.0;
    for (const PlotPoint& point : series.points) {
      if (!shows(index, point)) {
        drawing = false;
        continue;
      }
      const double x = box.x + box.width * xs_[index].place(point.x), y = up(point.y);
      if (drawing) canvas.line(lastX, lastY, x, y, color, 1.4);
      if (point.high > point.low && ys_[index].shows(point.low) && ys_[index].shows(point.high)) {
        canvas.line(x, up(point.low), x, up(point.high), color, 0.9);
      }
      canvas.marker(x, y, number);
      drawing = true;
      lastX = x;
      lastY = y;
    }
  }

  const Plot& plot_;
  std::vector<std::string> names_;
  std::set<std::size_t> used_;  // of names_
  std::size_t columns_ = 1, rows_ = 1;
  double strideX_ = 0.0, strideY_ = 0.0, left_ = 0.0, panelsWidth_ = 0.0, width_ = 0.0;
  std::vector<PlotScale> xs_, ys_;
};

}  // namespace

bool canPlot() { return true; }

void writePlot(const Plot& plot, const std::string& folder, const std::string& name) {
  const Layout layout(plot);
  double height = 0.0;  // how long texts are is known to a canvas alone
  drawNowhere([&](const PlotCanvas& canvas) { height = layout.height(canvas); });
  const DrawPlot draw = [&](const PlotCanvas& canvas) { layout.draw(canvas); };
  const std::string path = (std::filesystem::path(folder) / name).string();
  command::writeFile(path + ".svg", drawSvg(layout.width(), height, draw));
  command::writeFile(path + ".png", drawPng(layout.width(), height, draw));
}

}  // namespace bench

#else

namespace bench {

bool canPlot() { return false; }
void writePlot(const Plot&, const std::string&, const std::string&) {}

}  // namespace bench
#endif
