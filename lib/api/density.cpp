// SPDX-License-Identifier: Apache-2.0
#include "awd/density.h"

#include <algorithm>
#include <cmath>

#include "api/handles.h"
#include "api/saved_bytes.h"
#include "basis/device.h"
#include "density/density.h"
#include "density/refit_bytes.h"

using namespace awd;

namespace {

/// Arrays of d + 1 doubles a point must be addressable.
constexpr size_t kMostPoints = SIZE_MAX / (sizeof(double) * (kMaxDimensions + 1));

void checkCount(size_t count) {
  if (count > kMostPoints) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "count is %zu: at most %zu points can be addressed", count,
         kMostPoints);
  }
}

/// Names the first of `count` points with a coordinate for which good() is false.
template <class Good>
void checkCoordinates(const double* values, size_t count, uint32_t each, const char* argument,
                      const char* range, Good&& good) {
  if (count > 0) need(values, argument);
  for (size_t i = 0; i < count * each; ++i) {
    if (!good(values[i])) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "%s[%zu] is %g: it must be %s (number %zu of point %zu)",
           argument, i, values[i], range, i % each, i / each);
    }
  }
}

void checkPoints(const double* points, size_t count, uint32_t dimensions) {
  checkCoordinates(points, count, dimensions, "points", "in [0,1]",
                   [](double x) { return x >= 0.0 && x <= 1.0; });
}

void checkComponents(const Density& density, size_t count, const uint32_t* components) {
  if (density.settings().learning.estimator != AWD_ESTIMATOR_PAPER) return;
  const size_t n = density.model().coefficients().size();
  if (count > 0 && !components) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "components is NULL: the estimator paper wants what awdSampleDensity gave");
  }
  for (size_t i = 0; i < count; ++i) {
    if (components[i] >= n) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "components[%zu] is %u: the density has %zu components", i,
           components[i], n);
    }
  }
}

}  // namespace

extern "C" {

AWDResult AWD_CALL awdNewDensity(AWDDevice device, const AWDDensityDesc* desc,
                                 AWDDensity* density) noexcept {
  return guard(__func__, [&] {
    clearOutput(density, "density");
    Device& owner = object(device, "device");
    const AWDDensityDesc known = readStruct(desc, "desc", "AWD_DENSITY_DESC_INIT");
    if (known.dimensions < 1 || known.dimensions > kMaxDimensions) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "desc->dimensions is %u: 1 to %u is allowed",
           known.dimensions, kMaxDimensions);
    }
    const AWDBasisFamily* families[kMaxDimensions];
    for (uint32_t a = 0; a < known.dimensions; ++a) {
      const char* name = known.axes ? known.axes[a].basis : nullptr;
      families[a] = &owner.registry().find(name ? name : defaultBasis(known.structure));
    }
    DensitySettings settings = settle(known, families);
    if (settings.learning.estimator == AWD_ESTIMATOR_REFIT) {
      settings.learning.refitter.solver = &findSolver(&owner, known.refitSolver);
    }
    Ref<Context> context = owner.shareContext();
    Ref<DensityBases> bases = compileBases(context->memory(), settings, families);
    fitRefitBytes(*bases, settings);
    give(density, Density::make(std::move(context), std::move(bases), settings));
  });
}

void AWD_CALL awdRetainDensity(AWDDensity density) noexcept {
  if (density) behind(density)->retain();
}

void AWD_CALL awdReleaseDensity(AWDDensity density) noexcept {
  if (density) behind(density)->release();
}

AWDResult AWD_CALL awdForkDensity(AWDDensity density, AWDDensity* fork) noexcept {
  return guard(__func__, [&] {
    clearOutput(fork, "fork");
    give(fork, Density::fork(object(density, "density")));
  });
}

AWDResult AWD_CALL awdJoinDensity(AWDDensity density, AWDDensity fork) noexcept {
  return guard(__func__, [&] { idle(density, "density").join(idle(fork, "fork")); });
}

AWDResult AWD_CALL awdSampleDensity(AWDDensity density, size_t count, const double* uniforms,
                                    double* points, double* pdfs, uint32_t* components) noexcept {
  return guard(__func__, [&] {
    const Density& known = object(density, "density");
    checkCount(count);
    checkCoordinates(uniforms, count, known.uniforms(), "uniforms", "in [0,1)",
                     [](double u) { return u >= 0.0 && u < 1.0; });
    if (count > 0) need(points, "points");
    known.sample(count, uniforms, points, pdfs, components);
  });
}

AWDResult AWD_CALL awdGetDensityPdf(AWDDensity density, size_t count, const double* points,
                                    double* pdfs) noexcept {
  return guard(__func__, [&] {
    const Density& known = object(density, "density");
    checkCount(count);
    checkPoints(points, count, known.dimensions());
    if (count > 0) need(pdfs, "pdfs");
    known.model().pdf(count, points, pdfs);
  });
}

AWDResult AWD_CALL awdRecordDensity(AWDDensity density, size_t count, const double* points,
                                    const double* pdfs, const uint32_t* components,
                                    const double* values) noexcept {
  return guard(__func__, [&] {
    Density& known = idle(density, "density");
    checkCount(count);
    checkPoints(points, count, known.dimensions());
    if (pdfs) {
      checkCoordinates(pdfs, count, 1, "pdfs", "positive and finite",
                       [](double p) { return p > 0.0 && std::isfinite(p); });
    }
    checkComponents(known, count, components);
    if (count > 0) need(values, "values");
    known.record(count, points, pdfs, components, values);
  });
}

AWDResult AWD_CALL awdAdaptDensity(AWDDensity density, AWDDensityReport* report) noexcept {
  return guard(__func__, [&] {
    const AtWork<Density> known(&object(density, "density"), "density");
    AWDDensityReport made = AWD_DENSITY_REPORT_INIT;
    // A bad output struct must be found before anything is changed.
    if (report) writeStruct(report, made, "report", "AWD_DENSITY_REPORT_INIT");
    made = known->adapt();
    if (report) writeStruct(report, made, "report", "AWD_DENSITY_REPORT_INIT");
  });
}

AWDResult AWD_CALL awdRefineDensity(AWDDensity density, uint32_t axis) noexcept {
  return guard(__func__, [&] { idle(density, "density").refine(axis); });
}

AWDResult AWD_CALL awdGetDensityEstimate(AWDDensity density,
                                         AWDDensityEstimate* estimate) noexcept {
  return guard(__func__, [&] {
    const Estimate made = idle(density, "density").estimate();
    AWDDensityEstimate out = AWD_DENSITY_ESTIMATE_INIT;
    out.integral = made.integral;
    out.standardError = made.standardError;
    out.samples = made.samples;
    out.passes = made.passes;
    writeStruct(estimate, out, "estimate", "AWD_DENSITY_ESTIMATE_INIT");
  });
}

AWDResult AWD_CALL awdGetDensityInfo(AWDDensity density, AWDDensityInfo* info) noexcept {
  return guard(__func__, [&] {
    writeStruct(info, idle(density, "density").info(), "info", "AWD_DENSITY_INFO_INIT");
  });
}

AWDResult AWD_CALL awdGetDensityAxisInfo(AWDDensity density, uint32_t axis,
                                         AWDDensityAxisInfo* info) noexcept {
  return guard(__func__, [&] {
    writeStruct(info, object(density, "density").axisInfo(axis), "info",
                "AWD_DENSITY_AXIS_INFO_INIT");
  });
}

AWDResult AWD_CALL awdGetDensityCoefficients(AWDDensity density, AWDCoefficientForm form,
                                             double* coefficients, size_t capacity) noexcept {
  return guard(__func__, [&] {
    const Coefficients values = object(density, "density").coefficients(form);
    if (capacity < values.size()) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "capacity is %zu: the density has %zu coefficients",
           capacity, values.size());
    }
    std::copy(values.begin(), values.end(), need(coefficients, "coefficients"));
  });
}

AWDResult AWD_CALL awdSetDensityCoefficients(AWDDensity density, const double* coefficients,
                                             size_t count) noexcept {
  return guard(__func__, [&] {
    idle(density, "density").setCoefficients(need(coefficients, "coefficients"), count);
  });
}

AWDResult AWD_CALL awdGetDensityIntegral(AWDDensity density, const double* lower,
                                         const double* upper, double* integral) noexcept {
  return guard(__func__, [&] {
    const Density& known = object(density, "density");
    need(integral, "integral");
    if (!lower != !upper) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "%s is NULL: give both ends of the box or neither",
           lower ? "upper" : "lower");
    }
    double from[kMaxDimensions] = {};
    double to[kMaxDimensions] = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
    for (uint32_t a = 0; lower && a < known.dimensions(); ++a) {
      if (!(lower[a] >= 0.0 && lower[a] <= upper[a] && upper[a] <= 1.0)) {
        fail(AWD_ERROR_INVALID_ARGUMENT,
             "the box reaches from lower[%u] = %g to upper[%u] = %g: it must rise within [0,1]", a,
             lower[a], a, upper[a]);
      }
      from[a] = lower[a];
      to[a] = upper[a];
    }
    *integral = known.model().mass(from, to);
  });
}

AWDResult AWD_CALL awdGetDensityLeaves(AWDDensity density, double* boxes, size_t capacity,
                                       size_t* count) noexcept {
  return guard(__func__, [&] {
    const Density& known = object(density, "density");
    const Model& model = known.model();
    const uint32_t d = known.dimensions();
    *need(count, "count") = model.leaves();
    if (capacity > 0) need(boxes, "boxes");
    const auto write = [&](size_t leaf, const TreeBox& box) {
      if (leaf >= capacity) return;
      double* lower = boxes + 2 * leaf * d;
      for (uint32_t a = 0; a < d; ++a) {
        lower[a] = box.lower[a];
        lower[d + a] = box.lower[a] + box.size(a);
      }
    };
    if (model.grid) {
      write(0, TreeBox{});
      return;
    }
    const Tree& tree = model.tree->tree();
    tree.walk([&](uint32_t node, const TreeBox& box) {
      if (tree.nodes()[node].leaf()) write(tree.nodes()[node].child, box);
    });
  });
}

AWDResult AWD_CALL awdGetDensityDetailEnergy(AWDDensity density, double* energies, size_t capacity,
                                             size_t* count) noexcept {
  return guard(__func__, [&] {
    const Coefficients values = object(density, "density").detailEnergy();
    *need(count, "count") = values.size();
    if (capacity > 0) need(energies, "energies");
    std::copy_n(values.begin(), std::min(capacity, values.size()), energies);
  });
}

AWDResult AWD_CALL awdExportDensityStatistics(AWDDensity density, void* bytes, size_t capacity,
                                              size_t* size) noexcept {
  return guard(__func__, [&] {
    const Density& known = idle(density, "density");
    giveBytes(known.statisticsBytes(), bytes, capacity, need(size, "size"));
  });
}

AWDResult AWD_CALL awdAddDensityStatistics(AWDDensity density, const void* bytes,
                                           size_t size) noexcept {
  return guard(__func__,
               [&] { idle(density, "density").takeStatistics(need(bytes, "bytes"), size, false); });
}

AWDResult AWD_CALL awdImportDensityStatistics(AWDDensity density, const void* bytes,
                                              size_t size) noexcept {
  return guard(__func__,
               [&] { idle(density, "density").takeStatistics(need(bytes, "bytes"), size, true); });
}

AWDResult AWD_CALL awdSaveDensity(AWDDensity density, void* bytes, size_t capacity,
                                  size_t* size) noexcept {
  return guard(__func__, [&] {
    const Density& known = idle(density, "density");
    giveBytes(known.bytesOf(), bytes, capacity, need(size, "size"));
  });
}

AWDResult AWD_CALL awdLoadDensity(AWDDevice device, const void* bytes, size_t size,
                                  AWDDensity* density) noexcept {
  return guard(__func__, [&] {
    clearOutput(density, "density");
    Device& owner = object(device, "device");
    give(density,
         Density::load(owner.shareContext(), need(bytes, "bytes"), size, findersOf(owner)));
  });
}

}  // extern "C"
