// SPDX-License-Identifier: Apache-2.0
#include "trade_methods.h"

#include <sstream>

#include "guide_methods.h"

namespace bench::trade {

const std::vector<std::string>& defaultMethods() {
  static const std::vector<std::string> names = {
      "cosine",       "adaptive", "haar",  "quadratic-bspline", "level-2", "level-3",
      "haar+level-2", "mixture",  "quasi", "haar+quasi",        "paper",   "two-passes",
      "alpha-0.03",   "alpha-0.3"};
  return names;
}

guide::Contender contender(const std::string& name) {
  Settings settings;
  std::istringstream parts(name);
  for (std::string part; std::getline(parts, part, '+');) {
    guide::methodNamed(part).change(settings);
  }
  return {name,
          [settings](const awd::Device&, const LoadedScene& loaded, uint32_t samples, uint64_t seed,
                     Shot& shot) { return shoot(loaded, settings, samples, seed, shot); }};
}

}  // namespace bench::trade
