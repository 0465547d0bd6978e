// SPDX-License-Identifier: Apache-2.0
// How much of a long test is run: a sample of it in ./run check, all of it in ./run soak.
#pragma once

#include <cstddef>
#include <cstdlib>

namespace awdtest {

/// Whether this is ./run soak, which sets AWD_SOAK.
inline bool wholeSoak() { return std::getenv("AWD_SOAK") != nullptr; }

/// The size of a test: samples, steps, faults. What is sampled must be part of the whole.
inline size_t soakSize(size_t sampled, size_t whole) { return wholeSoak() ? whole : sampled; }

}  // namespace awdtest
