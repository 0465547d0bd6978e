// SPDX-License-Identifier: Apache-2.0
#include "chart.h"

#include <algorithm>
#include <set>

#include "chart_marks.h"
#include "plot_scale.h"
#include "report.h"

namespace bench {
namespace {

constexpr double kMargin = 8.0, kLine = 19.0;
constexpr double kOnlyWidth = 430.0, kPanelWidth = 250.0;  // of one panel, and of one of a row
constexpr double kPanelHeight = 190.0, kPanelTitle = 22.0;
constexpr double kLabelRoom = 24.0;  // of the label of y
constexpr double kTickWidth = 46.0, kTickHeight = 20.0, kGap = 18.0;
/// A chart shrinks so far, then its container scrolls.
constexpr double kLeastScale = 0.78;

struct Box {
  double x, y, width, height;
};

class Layout {
 public:
  explicit Layout(const Plot& plot) : plot_(plot), names_(plot.names) {
    for (const PlotPanel& panel : plot.panels) {
      for (const PlotSeries& series : panel.series) {
        if (std::find(names_.begin(), names_.end(), series.name) == names_.end()) {
          names_.push_back(series.name);
        }
        used_.insert(style(series.name));
      }
    }
    columns_ = std::max<std::size_t>(1, std::min(plot.columns, plot.panels.size()));
    rows_ = (plot.panels.size() + columns_ - 1) / columns_;
    panelWidth_ = columns_ == 1 ? kOnlyWidth : kPanelWidth;
    strideX_ = panelWidth_ + kGap + (plot.shared ? 0.0 : kTickWidth);
    strideY_ = kPanelTitle + kPanelHeight + (plot.shared ? 10.0 : kTickHeight + 8.0);
    left_ = kMargin + kLabelRoom + kTickWidth;
    panelsWidth_ = strideX_ * static_cast<double>(columns_ - 1) + panelWidth_;
    width_ = left_ + panelsWidth_ + kMargin + kGap;
    settleScales();
  }

  std::string svg() const {
    double y = kMargin;
    std::string body;
    for (const std::string& line : lines(plot_.title)) {
      body += chartText(kMargin, y += kLine, line, ChartAnchor::kStart, "chart-title");
    }
    for (const std::string& line : lines(plot_.subtitle)) {
      body += chartText(kMargin, y += kLine, line, ChartAnchor::kStart, "chart-label");
    }
    body += legend(y += kLine + 4.0);
    const double top = y + 8.0;
    for (std::size_t i = 0; i < plot_.panels.size(); ++i) body += panel(i, top);
    const double bottom =
        top + strideY_ * static_cast<double>(rows_) + (plot_.shared ? kTickHeight + 6.0 : 10.0);
    body += chartText(left_ + 0.5 * panelsWidth_, bottom, plot_.x.label, ChartAnchor::kMiddle,
                      "chart-label");
    body += chartTextUpwards(kMargin + kChartText, 0.5 * (top + bottom), plot_.y.label);
    const std::string height = chartLength(bottom + kMargin + 4.0);
    return "<svg class=\"chart\" role=\"img\" viewBox=\"0 0 " + chartLength(width_) + " " + height +
           "\" style=\"max-width:" + chartLength(width_) +
           "px;min-width:" + chartLength(kLeastScale * width_) + "px\"><title>" +
           htmlEscape(plot_.title) + "</title><desc>" + htmlEscape(description()) + "</desc>\n" +
           body + "</svg>";
  }

 private:
  std::size_t style(const std::string& name) const {
    return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
  }

  std::vector<std::string> lines(const std::string& words) const {
    return chartWrapped(words, kChartText, width_ - 2.0 * kMargin);
  }

  std::string description() const {
    std::string text = plot_.y.label + " against " + plot_.x.label + " for";
    for (const std::size_t i : used_) text += (i == *used_.begin() ? " " : ", ") + names_[i];
    return text + ".";
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

  /// At y, which moves down by the lines that it takes.
  std::string legend(double& y) const {
    std::string body;
    double x = kMargin;
    for (const std::size_t i : used_) {
      const double width = 34.0 + chartWidth(names_[i], kChartText) + 14.0;
      if (x > kMargin && x + width > width_) {
        x = kMargin;
        y += kLine;
      }
      body += chartLine(x, y - 4.5, x + 26.0, y - 4.5, "chart-line " + chartColour(i)) +
              chartMarker(x + 13.0, y - 4.5, i) +
              chartText(x + 32.0, y, names_[i], ChartAnchor::kStart, "chart-label");
      x += width;
    }
    return body;
  }

  std::string panel(std::size_t index, double top) const {
    const PlotPanel& panel = plot_.panels[index];
    if (panel.series.empty()) return "";
    const std::size_t column = index % columns_, row = index / columns_;
    const Box box = {left_ + strideX_ * static_cast<double>(column),
                     top + strideY_ * static_cast<double>(row) + kPanelTitle, panelWidth_,
                     kPanelHeight};
    const std::size_t below = index + columns_;
    const bool last = below >= plot_.panels.size() || plot_.panels[below].series.empty();
    std::string body = ticks(index, box, !plot_.shared || column == 0, !plot_.shared || last);
    body += "<rect class=\"chart-frame\" x=\"" + chartLength(box.x) + "\" y=\"" +
            chartLength(box.y) + "\" width=\"" + chartLength(box.width) + "\" height=\"" +
            chartLength(box.height) + "\"/>";
    body += chartText(box.x + 0.5 * box.width, box.y - 6.0, panel.title, ChartAnchor::kMiddle,
                      "chart-label");
    for (const PlotSeries& series : panel.series) body += curve(index, box, series);
    return body + "\n";
  }

  std::string ticks(std::size_t index, const Box& box, bool left, bool below) const {
    std::string body;
    const double bottom = box.y + box.height;
    for (const PlotTick& tick : xs_[index].ticks()) {
      const double x = box.x + box.width * xs_[index].place(tick.value);
      const bool major = !tick.label.empty();
      if (major) body += chartLine(x, box.y, x, bottom, "chart-grid");
      body += chartLine(x, bottom, x, bottom - (major ? 5.0 : 3.0), "chart-tick");
      if (below)
        body += chartText(x, bottom + 15.0, tick.label, ChartAnchor::kMiddle, "chart-number");
    }
    for (const PlotTick& tick : ys_[index].ticks()) {
      const double y = box.y + box.height * (1.0 - ys_[index].place(tick.value));
      const bool major = !tick.label.empty();
      if (major) body += chartLine(box.x, y, box.x + box.width, y, "chart-grid");
      body += chartLine(box.x, y, box.x + (major ? 5.0 : 3.0), y, "chart-tick");
      if (left)
        body += chartText(box.x - 6.0, y + 4.0, tick.label, ChartAnchor::kEnd, "chart-number");
    }
    return body;
  }

  /// A line through the points that are shown, broken where one isn't; whiskers; markers above.
  std::string curve(std::size_t index, const Box& box, const PlotSeries& series) const {
    const std::size_t number = style(series.name);
    const std::string colour = chartColour(number);
    const auto up = [&](double y) { return box.y + box.height * (1.0 - ys_[index].place(y)); };
    std::string path, whiskers, markers;
    bool drawing = false;
    for (const PlotPoint& point : series.points) {
      if (!shows(index, point)) {
        drawing = false;
        continue;
      }
      const double x = box.x + box.width * xs_[index].place(point.x), y = up(point.y);
      path += (drawing ? "L" : "M") + chartLength(x) + " " + chartLength(y);
      drawing = true;
      std::string value = series.name + ": " + shortNumber(point.y);
      if (point.high > point.low && ys_[index].shows(point.low) && ys_[index].shows(point.high)) {
        const double low = up(point.low), high = up(point.high);
        for (const double end : {low, high}) {
          whiskers += chartLine(x - 3.0, end, x + 3.0, end, "chart-whisker " + colour);
        }
        whiskers += chartLine(x, low, x, high, "chart-whisker " + colour);
        value += " [" + shortNumber(point.low) + ", " + shortNumber(point.high) + "]";
      }
      markers += "<g><title>" + htmlEscape(value + " at " + shortNumber(point.x)) + "</title>" +
                 chartMarker(x, y, number) + "</g>";
    }
    return "<path class=\"chart-line " + colour + "\" d=\"" + path + "\"/>" + whiskers + markers;
  }

  const Plot& plot_;
  std::vector<std::string> names_;
  std::set<std::size_t> used_;  // of names_
  std::size_t columns_ = 1, rows_ = 1;
  double panelWidth_ = 0.0, strideX_ = 0.0, strideY_ = 0.0;
  double left_ = 0.0, panelsWidth_ = 0.0, width_ = 0.0;
  std::vector<PlotScale> xs_, ys_;
};

}  // namespace

std::string chartSvg(const Plot& plot) { return Layout(plot).svg(); }

}  // namespace bench
