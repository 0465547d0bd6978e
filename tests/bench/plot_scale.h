// SPDX-License-Identifier: Apache-2.0
// One axis of a plot: from values to places, and where its ticks are.
#pragma once

#include <string>
#include <vector>

namespace bench {

struct PlotTick {
  double value;
  std::string label;  ///< "" of a lesser one
};

class PlotScale {
 public:
  explicit PlotScale(bool logarithmic) : logarithmic_(logarithmic) {}

  bool shows(double value) const;
  /// Widens the scale to take in a value; one that isn't shown is no matter.
  void include(double value);
  /// Room at both ends; a scale with no extent gets some.
  void settle();

  /// 0 at the lower end, 1 at the upper.
  double place(double value) const;
  std::vector<PlotTick> ticks() const;

 private:
  double map(double value) const;

  bool logarithmic_;
  double low_ = 0.0, high_ = 0.0;  // mapped
  bool empty_ = true;
};

}  // namespace bench
