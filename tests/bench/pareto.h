// SPDX-License-Identifier: Apache-2.0
// What a plane of cost and error says: which points are worth their cost, and where two methods
// meet. Pure functions.
#pragma once

#include <limits>
#include <vector>

namespace bench {

/// What a method has at one budget.
struct CostPoint {
  double seconds, error;
};

/// Which points no other beats: another is at most as large in all figures, and smaller in one.
/// All points have the same figures, of which less is better; one with a figure that isn't finite
/// is never on the front, and beats none.
std::vector<bool> paretoFront(const std::vector<std::vector<double>>& points);

/// Never reached.
constexpr double kNever = std::numeric_limits<double>::infinity();

/// Seconds until a method's error is at most `target`, linear in the logarithms between
/// neighbouring budgets; kNever if it isn't within them. `reachedAtFirst`, unless it is NULL, is
/// set to whether the first budget has that error already: the seconds are then an upper bound.
/// The points ascend in seconds; errors of 0 or less are no errors, but noise of the reference,
/// and left out.
double timeToError(const std::vector<CostPoint>& points, double target,
                   bool* reachedAtFirst = nullptr);

/// Error after so many seconds, in the same way; NaN outside of the budgets.
double errorAtTime(const std::vector<CostPoint>& points, double seconds);

/// From when on a method has less error than the baseline at equal time.
struct BreakEven {
  /// Of the method's: kNever if it is not better at its last time that can be compared, NaN if
  /// there is no time at which both are known.
  double seconds;
  bool fromFirst;  ///< it is better at each such time: it may be from an earlier one on, too
};

/// Both ascend in seconds. Compared at all times of both where both are known, and linear in the
/// logarithms between them.
BreakEven breakEven(const std::vector<CostPoint>& method, const std::vector<CostPoint>& baseline);

}  // namespace bench
