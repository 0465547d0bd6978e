// SPDX-License-Identifier: Apache-2.0
// Line plots as small multiples; chart.h draws them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace bench {

struct PlotPoint {
  double x, y;
  double low, high;  ///< the interval of y; both y if there is none
};

struct PlotSeries {
  std::string name;
  std::vector<PlotPoint> points;  ///< ascending in x
};

struct PlotPanel {
  std::string title;
  std::vector<PlotSeries> series;
};

struct PlotAxis {
  std::string label;  ///< with its unit
  bool logarithmic = true;
};

/// Panels fill rows of `columns`; a panel without series stays empty.
struct Plot {
  std::string title, subtitle;
  PlotAxis x, y;
  std::size_t columns = 1;
  /// Of series, in the order of colours and markers, so that plots can agree; others come after.
  std::vector<std::string> names;
  /// Panels of a row share the scale of y, and those of a column that of x; else each has its own.
  bool shared = true;
  std::vector<PlotPanel> panels;
};

}  // namespace bench
