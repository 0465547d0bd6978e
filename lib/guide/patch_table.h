// SPDX-License-Identifier: Apache-2.0
// Patches by number, made on first touch by any thread without a lock, and found again in four
// steps. Memory grows with the patches touched, not with the numbers possible.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory_resource>

#include "util/context.h"

namespace awd {

/// A radix tree over the four bytes of a number. T must be constructible by a function given to
/// touch(); a T that loses the race to be the first is destroyed.
template <class T>
class PatchTable {
 public:
  explicit PatchTable(std::pmr::memory_resource* memory) : memory_(memory) {}
  ~PatchTable() { clear(root_, 0); }
  PatchTable(const PatchTable&) = delete;
  PatchTable& operator=(const PatchTable&) = delete;

  T* find(uint32_t number) const {
    const Node* node = &root_;
    for (int shift = 24; shift > 0; shift -= 8) {
      node = static_cast<const Node*>(node->slot(number >> shift).load(std::memory_order_acquire));
      if (!node) return nullptr;
    }
    return static_cast<T*>(node->slot(number).load(std::memory_order_acquire));
  }

  /// The patch of that number; made by makePatch() -> T* if there is none.
  template <class Make>
  T& touch(uint32_t number, Make&& makePatch) {
    Node* node = &root_;
    for (int shift = 24; shift > 0; shift -= 8) {
      node = &reach<Node>(node->slot(number >> shift), [&] { return make<Node>(memory_); });
    }
    return reach<T>(node->slot(number), makePatch);
  }

  /// Makes touch() of this number need no memory but the patch's own.
  void reserve(uint32_t number) {
    Node* node = &root_;
    for (int shift = 24; shift > 0; shift -= 8) {
      node = &reach<Node>(node->slot(number >> shift), [&] { return make<Node>(memory_); });
    }
  }

  /// Calls visit(number, patch) in ascending order of numbers. Patches that others touch meanwhile
  /// are visited or not.
  template <class Visit>
  void forEach(Visit&& visit) const {
    walk(root_, 0, 0, visit);
  }

  /// Destroys the patches of which gone(patch) holds. Exclusive.
  template <class Gone>
  void removeIf(Gone&& gone) {
    prune(root_, 0, gone);
  }

  /// Memory of the tree itself, without the patches.
  std::size_t bytes() const { return nodes_.load(std::memory_order_relaxed) * sizeof(Node); }

 private:
  struct Node {
    std::atomic<void*> slots[256] = {};
    std::atomic<void*>& slot(uint32_t byte) { return slots[byte & 255u]; }
    const std::atomic<void*>& slot(uint32_t byte) const { return slots[byte & 255u]; }
  };

  template <class U, class Make>
  U& reach(std::atomic<void*>& slot, Make&& makeOne) {
    void* present = slot.load(std::memory_order_acquire);
    if (present) return *static_cast<U*>(present);
    U* made = makeOne();
    if (slot.compare_exchange_strong(present, made, std::memory_order_acq_rel)) {
      if (std::is_same_v<U, Node>) nodes_.fetch_add(1, std::memory_order_relaxed);
      return *made;
    }
    unmake(memory_, made);
    return *static_cast<U*>(present);
  }

  template <class Visit>
  void walk(const Node& node, int depth, uint32_t prefix, Visit& visit) const {
    for (uint32_t byte = 0; byte < 256; ++byte) {
      void* below = node.slots[byte].load(std::memory_order_acquire);
      if (!below) continue;
      const uint32_t number = prefix << 8 | byte;
      if (depth == 3) {
        visit(number, *static_cast<T*>(below));
      } else {
        walk(*static_cast<const Node*>(below), depth + 1, number, visit);
      }
    }
  }

  template <class Gone>
  void prune(Node& node, int depth, Gone& gone) {
    for (std::atomic<void*>& slot : node.slots) {
      void* below = slot.load(std::memory_order_relaxed);
      if (!below) continue;
      if (depth < 3) {
        prune(*static_cast<Node*>(below), depth + 1, gone);
      } else if (gone(*static_cast<T*>(below))) {
        slot.store(nullptr, std::memory_order_relaxed);
        unmake(memory_, static_cast<T*>(below));
      }
    }
  }

  void clear(Node& node, int depth) {
    for (std::atomic<void*>& slot : node.slots) {
      void* below = slot.load(std::memory_order_relaxed);
      if (!below) continue;
      if (depth == 3) {
        unmake(memory_, static_cast<T*>(below));
      } else {
        clear(*static_cast<Node*>(below), depth + 1);
        unmake(memory_, static_cast<Node*>(below));
      }
    }
  }

  std::pmr::memory_resource* memory_;
  Node root_;
  std::atomic<std::size_t> nodes_{1};
};

}  // namespace awd
