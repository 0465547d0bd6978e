// SPDX-License-Identifier: Apache-2.0
#include "plot_scale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bench {
namespace {

constexpr double kRoom = 0.04;  // of the extent, at each end
constexpr double kMostLabels = 5.0;

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

/// 0.01 to 1000 as such, others as powers of ten.
std::string decade(int exponent) {
  if (exponent >= -2 && exponent <= 3) return number(std::pow(10.0, exponent));
  constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += kDigits[digit - '0'];
  return text;
}

/// 1, 2 or 5 times a power of ten, such that `extent` has at most so many of them.
double niceStep(double extent, double most) {
  const double least = extent / most;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace

bool PlotScale::shows(double value) const {
  return std::isfinite(value) && (!logarithmic_ || value > 0.0);
}

double PlotScale::map(double value) const { return logarithmic_ ? std::log10(value) : value; }

void PlotScale::include(double value) {
  if (!shows(value)) return;
  const double mapped = map(value);
  low_ = empty_ ? mapped : std::min(low_, mapped);
  high_ = empty_ ? mapped : std::max(high_, mapped);
  empty_ = false;
}

void PlotScale::settle() {
  const double least = logarithmic_ ? 0.5 : 1e-9 + 0.1 * std::fabs(high_);
  const double missing = std::max(0.0, least - (high_ - low_));
  const double room = kRoom * (high_ - low_ + missing) + 0.5 * missing;
  low_ -= room;
  high_ += room;
}

double PlotScale::place(double value) const { return (map(value) - low_) / (high_ - low_); }

std::vector<PlotTick> PlotScale::ticks() const {
  std::vector<PlotTick> ticks;
  if (!logarithmic_) {
    const double step = niceStep(high_ - low_, kMostLabels);
    for (double k = std::ceil(low_ / step); k * step <= high_; k += 1.0) {
      ticks.push_back({k * step, number(k * step)});
    }
    return ticks;
  }
  const int first = static_cast<int>(std::floor(low_));
  const int last = static_cast<int>(std::ceil(high_));
  const int every = std::max(1, static_cast<int>(std::ceil((high_ - low_) / kMostLabels)));
  // A scale that a decade or less would leave with a single label gets more of them.
  const bool narrow = std::floor(high_) - std::ceil(low_) < 1.0;
  for (int exponent = first; exponent <= last; ++exponent) {
    for (int digit = 1; digit <= 9; ++digit) {
      const double value = digit * std::pow(10.0, exponent);
      if (map(value) < low_ || map(value) > high_) continue;
      if (digit == 1) {
        ticks.push_back({value, exponent % every == 0 ? decade(exponent) : ""});
      } else if (every == 1) {
        ticks.push_back({value, narrow && (digit == 2 || digit == 5) ? number(value) : ""});
      }
    }
  }
  return ticks;
}

}  // namespace bench
