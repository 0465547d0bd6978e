// SPDX-License-Identifier: Apache-2.0
// Fields under each estimator but the paper's.
#pragma once

#include <string>
#include <vector>

#include "field/learning.h"

namespace awdtest {

inline std::vector<AWDEstimator> estimators() {
  std::vector<AWDEstimator> all = {AWD_ESTIMATOR_MIXTURE, AWD_ESTIMATOR_RATIO, AWD_ESTIMATOR_QUASI};
#ifdef AWD_TEST_REFIT
  all.push_back(AWD_ESTIMATOR_REFIT);
#endif
  return all;
}

inline std::string nameOfEstimator(const testing::TestParamInfo<AWDEstimator>& info) {
  const char* const names[] = {"Default", "Paper", "Mixture", "Ratio", "Quasi", "Refit"};
  return names[info.param];
}

class Estimators : public FedField<AWDEstimator> {
 protected:
  AWDFieldDesc desc(const char* basis, uint32_t startLevel, uint32_t maxLevel, double tau = 0.0) {
    AWDFieldDesc result = fieldDesc(AWD_MAP_CONCENTRIC_COSINE, startLevel, maxLevel, tau);
    result.estimator = GetParam();
    result.basis = basis;
    return result;
  }
};

}  // namespace awdtest
