// SPDX-License-Identifier: Apache-2.0
#include "refit/cuthill_mckee.h"

#include <algorithm>

namespace awd {

namespace {

/// Breadth-first search over A's graph, neighbours of low degree first (Cuthill and McKee 1969).
class Search {
 public:
  explicit Search(const Quadratic& quadratic)
      : quadratic_(quadratic), degree_(quadratic.size()), seen_(quadratic.size(), 0) {
    for (uint32_t j = 0; j < quadratic.size(); ++j) {
      quadratic.forEachEntry(j, [&](uint32_t, double) { ++degree_[j]; });
    }
  }

  uint32_t degree(uint32_t j) const { return degree_[j]; }

  /// Appends root's component to order; returns where in it the last rung begins.
  std::size_t run(uint32_t root, std::vector<uint32_t>& order) {
    ++round_;
    const std::size_t begin = order.size();
    order.push_back(root);
    seen_[root] = round_;
    std::size_t rung = begin, rungEnd = order.size();
    for (std::size_t at = begin; at < order.size(); ++at) {
      if (at == rungEnd) {
        rung = rungEnd;
        rungEnd = order.size();
      }
      const std::size_t found = order.size();
      quadratic_.forEachEntry(order[at], [&](uint32_t k, double) {
        if (seen_[k] == round_) return;
        seen_[k] = round_;
        order.push_back(k);
      });
      std::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(found), order.end(),
                       [&](uint32_t a, uint32_t b) { return degree_[a] < degree_[b]; });
    }
    return rung;
  }

 private:
  const Quadratic& quadratic_;
  std::vector<uint32_t> degree_;
  std::vector<uint32_t> seen_;  ///< the last round that saw an unknown
  uint32_t round_ = 0;
};

}  // namespace

std::vector<uint32_t> reverseCuthillMcKee(const Quadratic& quadratic) {
  Search search(quadratic);
  std::vector<uint32_t> order;
  std::vector<uint8_t> done(quadratic.size(), 0);
  for (uint32_t j = 0; j < quadratic.size(); ++j) {
    if (done[j]) continue;
    // From the far end of a search the rungs are many and small.
    uint32_t root = j;
    const std::size_t begin = order.size();
    for (int turn = 0; turn < 2; ++turn) {
      const std::size_t rung = search.run(root, order);
      root = *std::min_element(
          order.begin() + static_cast<std::ptrdiff_t>(rung), order.end(),
          [&](uint32_t a, uint32_t b) { return search.degree(a) < search.degree(b); });
      order.resize(begin);
    }
    search.run(root, order);
    for (std::size_t i = begin; i < order.size(); ++i) done[order[i]] = 1;
  }
  std::reverse(order.begin(), order.end());
  return order;
}

}  // namespace awd
