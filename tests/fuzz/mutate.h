// SPDX-License-Identifier: Apache-2.0
// Changes of an input: those of a fuzzer without its feedback, and some of numbers, in binary and
// in text, that a fuzzer would take long to find.
#pragma once

#include "support/random.h"
#include "target.h"

namespace fuzz {

/// One to four changes; at most `longest` bytes come out.
Input mutated(const Input& input, std::size_t longest, awdtest::Random& random);

}  // namespace fuzz
