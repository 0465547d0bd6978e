// SPDX-License-Identifier: Apache-2.0
#include "refit_densities.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace bench::refit {
namespace {

constexpr int kManyPasses = 4;
/// Beyond them a space is left out, at all numbers of samples: means over cells stay comparable.
constexpr uint64_t kMostCoefficients = 1100;
constexpr uint64_t kMostOfTimes = 5000;
/// Ceres takes so much longer that it gets the first seed alone; its results are those of descent.
constexpr int kCeresSeeds = 1;

struct Cell {
  Task task;
  double ratio;  ///< samples a coefficient
};

/// What one part measures: the product of all of these.
struct Plan {
  std::vector<Space> spaces;
  std::vector<double> ratios;
  std::vector<Noise> noises;
  std::vector<const Function*> functions;
  std::vector<double> shrinkages;
  int passes = 1;
  int seeds = 1;
  uint64_t mostCoefficients = kMostCoefficients;
};

struct Family {
  const char* basis;
  AWDDensityStructure structure;
};
constexpr Family kFamilies[] = {{"haar", AWD_STRUCTURE_GRID},
                                {"linear-bspline", AWD_STRUCTURE_GRID},
                                {"quadratic-bspline", AWD_STRUCTURE_GRID},
                                {"m2", AWD_STRUCTURE_GRID},
                                {"m3", AWD_STRUCTURE_GRID},
                                {"haar", AWD_STRUCTURE_TREE},
                                {"m2", AWD_STRUCTURE_TREE}};
constexpr Family kFewFamilies[] = {{"haar", AWD_STRUCTURE_GRID},
                                   {"linear-bspline", AWD_STRUCTURE_GRID},
                                   {"quadratic-bspline", AWD_STRUCTURE_GRID},
                                   {"haar", AWD_STRUCTURE_TREE},
                                   {"m2", AWD_STRUCTURE_TREE}};

struct Size {
  int dimensions;
  uint32_t level;
};

template <class Families, class Sizes>
void addSpaces(Plan& plan, const Families& families, const Sizes& sizes) {
  for (const Size size : sizes) {
    for (const Family& family : families) {
      plan.spaces.push_back({family.basis, family.structure, size.dimensions, size.level});
    }
  }
}

Plan planOf(Part part) {
  Plan plan;
  plan.shrinkages = {0.0};
  plan.noises.assign(std::begin(kNoises), std::end(kNoises));
  for (const Function& function : functions()) plan.functions.push_back(&function);
  switch (part) {
    case Part::kShrinkage:
      addSpaces(plan, kFamilies, std::vector<Size>{{1, 5}, {2, 3}, {3, 2}});
      plan.ratios = {1.0, 4.0, 16.0, 64.0};
      plan.shrinkages = {0.0, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0};
      plan.seeds = 3;
      break;
    case Part::kFirst:
      addSpaces(plan, kFamilies, std::vector<Size>{{1, 5}, {2, 3}, {2, 4}, {3, 2}, {4, 1}});
      plan.ratios = {1.0, 2.0, 4.0, 8.0, 16.0, 64.0, 256.0};
      plan.seeds = 3;
      break;
    case Part::kAdaptive:
      addSpaces(plan, kFewFamilies, std::vector<Size>{{2, 4}});
      plan.ratios = {1.0, 4.0, 16.0, 64.0};
      plan.passes = kManyPasses;
      plan.seeds = 3;
      break;
    case Part::kTime:
      addSpaces(plan, kFewFamilies,
                std::vector<Size>{{2, 2}, {2, 3}, {2, 4}, {2, 5}, {3, 2}, {3, 3}});
      plan.ratios = {16.0};
      plan.noises = {Noise::kExponential};
      plan.functions.resize(1);
      plan.seeds = 3;
      plan.mostCoefficients = kMostOfTimes;
      break;
  }
  return plan;
}

Plan quickPlanOf(Part part) {
  Plan plan = planOf(part);
  plan.spaces = {{"linear-bspline", AWD_STRUCTURE_GRID, 2, 3}, {"haar", AWD_STRUCTURE_TREE, 2, 3}};
  plan.ratios = {4.0, 16.0};
  plan.noises = {Noise::kNone, Noise::kExponential};
  plan.functions.resize(std::min<std::size_t>(2, plan.functions.size()));
  if (plan.shrinkages.size() > 1) plan.shrinkages = {0.0, 0.5, 2.0};
  plan.seeds = 2;
  if (part == Part::kTime) plan.spaces.push_back({"linear-bspline", AWD_STRUCTURE_GRID, 2, 4});
  return plan;
}

std::vector<Cell> cellsOf(AWDDevice device, const Plan& plan, const std::vector<int>& dimensions) {
  std::vector<Cell> cells;
  for (const Space& space : plan.spaces) {
    const auto wanted = std::find(dimensions.begin(), dimensions.end(), space.dimensions);
    if (wanted == dimensions.end()) continue;
    const uint64_t n = coefficientsOf(device, space);
    if (n > plan.mostCoefficients) continue;
    for (const Function* function : plan.functions) {
      if (space.dimensions < function->leastDimensions) continue;
      for (const Noise noise : plan.noises) {
        for (const double ratio : plan.ratios) {
          const double samples = std::max(2.0, ratio * static_cast<double>(n));
          for (const double shrinkage : plan.shrinkages) {
            cells.push_back(
                {{space, function, noise, static_cast<uint64_t>(samples), plan.passes, shrinkage},
                 ratio});
          }
        }
      }
    }
  }
  return cells;
}

bool isCeres(const Method& method) {
  return method.solver && std::string(method.solver) == "ceres";
}

/// Whether a part is about this method.
bool concerns(Part part, const Method& method) {
  const bool shrinks =
      method.estimator == AWD_ESTIMATOR_QUASI || method.estimator == AWD_ESTIMATOR_REFIT;
  if (part == Part::kShrinkage) return shrinks && !isCeres(method);
  return part != Part::kTime || shrinks;
}

/// The largest difference of coefficients, relative to the largest of them.
double differenceOf(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return 1.0;
  double most = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, std::fabs(a[i] - b[i]));
    largest = std::max(largest, std::fabs(a[i]));
  }
  return most / largest;
}

Row rowOf(Part part, const Cell& cell, const Method& method, const std::vector<Learned>& runs) {
  const auto spread = [&](const auto& pick) {
    std::vector<double> values(runs.size());
    std::transform(runs.begin(), runs.end(), values.begin(), pick);
    return spreadOf(values);
  };
  const Task& task = cell.task;
  const double recorded = static_cast<double>(task.samples) * task.passes;
  const auto n = [](const Learned& run) { return static_cast<double>(run.report.coefficients); };
  Row row = {{"part", nameOf(part)},
             {"basis", task.space.basis},
             {"structure", task.space.structure == AWD_STRUCTURE_TREE ? "tree" : "grid"},
             {"dimensions", task.space.dimensions},
             {"level", task.space.level},
             {"function", task.function->name},
             {"noise", nameOf(task.noise)},
             {"passes", task.passes},
             {"samples", task.samples},
             {"samples_per_coefficient", cell.ratio},
             {"method", method.name},
             {"seeds", runs.size()}};
  if (part == Part::kShrinkage) row["shrinkage"] = task.shrinkage;  // 0: the default
  row["coefficients"] = spread(n).median;
  setSpread(row, "l2", spread([](const Learned& run) { return run.distance.l2; }));
  setSpread(row, "variance", spread([](const Learned& run) { return run.distance.variance; }));
  double worst = 0.0;
  for (const Learned& run : runs) worst = std::max(worst, run.distance.variance);
  row["variance_worst"] = worst;
  row["negative"] = spread([&](const Learned& run) {
                      return static_cast<double>(run.report.negative) / n(run);
                    }).median;
  row["record_ns"] =
      spread([&](const Learned& run) { return 1e9 * run.recordSeconds / recorded; }).median;
  row["adapt_ms"] =
      spread([&](const Learned& run) { return 1e3 * run.adaptSeconds / task.passes; }).median;
  if (method.estimator != AWD_ESTIMATOR_REFIT) return row;
  const auto share = [&](AWDRefitStatus status) {
    const auto count = std::count_if(runs.begin(), runs.end(), [&](const Learned& run) {
      return run.report.refitStatus == status;
    });
    return static_cast<double>(count) / static_cast<double>(runs.size());
  };
  row["converged"] = share(AWD_REFIT_CONVERGED);
  row["limit"] = share(AWD_REFIT_LIMIT);
  row["failed"] = share(AWD_REFIT_FAILED);
  row["iterations"] = spread([](const Learned& run) {
                        return static_cast<double>(run.report.refitIterations);
                      }).median;
  row["at_bound"] = spread([&](const Learned& run) {
                      return static_cast<double>(run.report.refitAtBound) / n(run);
                    }).median;
  row["lambda"] = spread([](const Learned& run) { return run.report.refitLambda; }).median;
  row["objective"] = spread([](const Learned& run) { return run.report.refitObjective; }).median;
  return row;
}

std::vector<Row> measureCell(AWDDevice device, const std::vector<Method>& methods, Part part,
                             const Cell& cell, int seeds, const Truth& truth) {
  const bool tree = cell.task.space.structure == AWD_STRUCTURE_TREE;
  std::map<std::string, std::vector<Learned>> runs;
  for (int seed = 1; seed <= seeds; ++seed) {
    const Samples samples(cell.task, static_cast<uint64_t>(seed));
    for (const Method& method : methods) {
      if (isCeres(method) && seed > kCeresSeeds) continue;
      // Components to draw from are a grid's alone.
      if (tree && method.estimator == AWD_ESTIMATOR_PAPER) continue;
      runs[method.name].push_back(
          learn(device, cell.task, method, samples, truth, static_cast<uint64_t>(seed)));
    }
  }
  std::vector<Row> rows;
  for (const Method& method : methods) {
    if (runs[method.name].empty()) continue;
    rows.push_back(rowOf(part, cell, method, runs[method.name]));
    if (!isCeres(method) || cell.task.passes > 1) continue;
    const std::vector<Learned>&descent = runs["refit-descent"], &ceres = runs[method.name];
    double most = 0.0;
    for (std::size_t i = 0; i < std::min(descent.size(), ceres.size()); ++i) {
      most = std::max(most, differenceOf(descent[i].coefficients, ceres[i].coefficients));
    }
    if (!descent.empty()) rows.back()["differs_from_descent"] = most;
  }
  return rows;
}

}  // namespace

const char* nameOf(Part part) {
  constexpr const char* kNames[] = {"shrinkage", "first", "adaptive", "time"};
  return kNames[static_cast<int>(part)];
}

std::vector<Row> measurePart(AWDDevice device, const std::vector<Method>& methods, Part part,
                             const PartOptions& options, const Watch& watch) {
  std::vector<Method> concerned;
  std::copy_if(methods.begin(), methods.end(), std::back_inserter(concerned),
               [&](const Method& method) { return concerns(part, method); });
  const Plan plan = options.quick ? quickPlanOf(part) : planOf(part);
  const std::vector<Cell> cells = cellsOf(device, plan, options.dimensions);
  std::vector<Row> rows;
  // Neighbouring cells have one function in one number of dimensions.
  std::unique_ptr<Truth> truth;
  const Task* known = nullptr;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!watch(i, cells.size())) break;
    const Task& task = cells[i].task;
    if (!known || known->function != task.function ||
        known->space.dimensions != task.space.dimensions) {
      truth = std::make_unique<Truth>(*task.function, task.space.dimensions);
      known = &task;
    }
    for (Row& row : measureCell(device, concerned, part, cells[i], plan.seeds, *truth)) {
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace bench::refit
