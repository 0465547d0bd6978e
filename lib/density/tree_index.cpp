// SPDX-License-Identifier: Apache-2.0
#include "density/tree_index.h"

#include <algorithm>

namespace awd {

TreeIndex::TreeIndex(const Tree& tree) : entries_(tree.nodes().get_allocator()) {
  const uint32_t d = tree.dimensions();
  // Axes get bits by how often the leaves have been halved along them.
  double wanted[kMaxDimensions] = {};
  tree.walk([&](uint32_t node, const TreeBox& box) {
    if (!tree.nodes()[node].leaf()) return;
    for (uint32_t a = 0; a < d; ++a) wanted[a] += static_cast<double>(box.depth[a]) / tree.leaves();
  });
  uint32_t total = 0;
  while (uint64_t{2} << total <= tree.leaves()) {
    const auto axis = static_cast<uint32_t>(std::max_element(wanted, wanted + d) - wanted);
    if (wanted[axis] <= 0.0) break;
    wanted[axis] -= 1.0;
    ++bits_[axis];
    ++total;
  }
  entries_.resize(std::size_t{1} << total);
  for (std::size_t cell = 0; cell < entries_.size(); ++cell) {
    // Down to the first split that is finer than the grid.
    Entry& entry = entries_[cell];
    uint32_t place[kMaxDimensions];
    std::size_t rest = cell;
    for (uint32_t a = d; a-- > 0; rest >>= bits_[a]) {
      place[a] = static_cast<uint32_t>(rest & ((std::size_t{1} << bits_[a]) - 1));
    }
    const TreeNode* node = tree.nodes().data();
    while (!node->leaf() && entry.depth[node->axis] < bits_[node->axis]) {
      const uint32_t axis = node->axis;
      ++entry.depth[axis];
      entry.node = node->child + (place[axis] >> (bits_[axis] - entry.depth[axis]) & 1);
      node = &tree.nodes()[entry.node];
    }
  }
}

}  // namespace awd
