// SPDX-License-Identifier: Apache-2.0
#include "awd/field.h"

#include <cmath>

#include "api/field_checks.h"
#include "api/field_maker.h"
#include "api/handles.h"
#include "api/strides.h"
#include "basis/device.h"
#include "density/refit_solvers.h"
#include "guide/field.h"

using namespace awd;

Ref<Field> awd::makeField(Device& device, const AWDFieldDesc& desc) {
  Registry& registry = device.registry();
  const AWDBasisFamily& family =
      registry.find(desc.basis ? desc.basis : defaultFieldBasis(desc.preset));
  FieldSettings settings = settle(device.context().memory(), desc, family);
  if (settings.learning.estimator == AWD_ESTIMATOR_REFIT) {
    settings.learning.refitter.solver =
        &findRefitSolver(refitFolders(registry.ignoresEnvironment()), desc.refitSolver);
  }
  return Field::make(device.shareContext(), family, settings);
}

extern "C" {

AWDResult AWD_CALL awdNewField(AWDDevice device, const AWDFieldDesc* desc,
                               AWDField* field) noexcept {
  return guard(__func__, [&] {
    clearOutput(field, "field");
    Device& owner = object(device, "device");
    AWDFieldDesc known = AWD_FIELD_DESC_INIT;
    if (desc) known = readStruct(desc, "desc", "AWD_FIELD_DESC_INIT");
    give(field, makeField(owner, known));
  });
}

void AWD_CALL awdRetainField(AWDField field) noexcept {
  if (field) behind(field)->retain();
}

void AWD_CALL awdReleaseField(AWDField field) noexcept {
  if (field) behind(field)->release();
}

AWDResult AWD_CALL awdFindPatch(AWDField field, const float position[3], const float normal[3],
                                uint32_t* patch) noexcept {
  return guard(__func__, [&] {
    const Field& known = object(field, "field");
    const Vec3f point = finitePoint(position, "position");
    checkSpatial(known);
    *need(patch, "patch") = known.findPatch(point, unitVector(normal, "normal"));
  });
}

AWDResult AWD_CALL awdSampleField(AWDField field, uint32_t patch, const float normal[3],
                                  const double uniforms[3], AWDDirectionSample* sample) noexcept {
  return guard(__func__, [&] {
    checkUniforms(uniforms);
    *need(sample, "sample") =
        object(field, "field").sample(patch, unitVector(normal, "normal"), uniforms);
  });
}

AWDResult AWD_CALL awdGetFieldPdf(AWDField field, uint32_t patch, const float normal[3],
                                  const float direction[3], float* pdf) noexcept {
  return guard(__func__, [&] {
    *need(pdf, "pdf") =
        object(field, "field")
            .pdf(patch, unitVector(normal, "normal"), unitVector(direction, "direction"));
  });
}

AWDResult AWD_CALL awdRecordField(AWDField field, uint32_t patch, const AWDDirectionSample* sample,
                                  double value) noexcept {
  return guard(__func__, [&] {
    const AWDDirectionSample& known = *need(sample, "sample");
    Field& into = idle(field, "field");
    checkSample(into, known);
    into.record(patch, known, value);
  });
}

AWDResult AWD_CALL awdSetFieldScale(AWDField field, double magnitude) noexcept {
  return guard(__func__, [&] {
    if (!(magnitude > 0.0 && std::isfinite(magnitude))) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "magnitude is %g: it must be positive and finite",
           magnitude);
    }
    idle(field, "field").setScale(magnitude);
  });
}

AWDResult AWD_CALL awdAdaptField(AWDField field, AWDFieldStatistics* statistics) noexcept {
  return guard(__func__, [&] {
    const AtWork<Field> known(&object(field, "field"), "field");
    AWDFieldStatistics figures = AWD_FIELD_STATISTICS_INIT;
    // A bad output struct must be found before anything is changed.
    if (statistics) writeStruct(statistics, figures, "statistics", "AWD_FIELD_STATISTICS_INIT");
    figures = known->adapt();
    if (statistics) writeStruct(statistics, figures, "statistics", "AWD_FIELD_STATISTICS_INIT");
  });
}

AWDResult AWD_CALL awdMarkField(AWDField field) noexcept {
  return guard(__func__, [&] { idle(field, "field").mark(); });
}

AWDResult AWD_CALL awdRevertField(AWDField field) noexcept {
  return guard(__func__, [&] { idle(field, "field").revert(); });
}

AWDResult AWD_CALL awdGetFieldStatistics(AWDField field, AWDFieldStatistics* statistics) noexcept {
  return guard(__func__, [&] {
    writeStruct(statistics, idle(field, "field").statistics(), "statistics",
                "AWD_FIELD_STATISTICS_INIT");
  });
}

AWDResult AWD_CALL awdGetFieldPatches(AWDField field, uint32_t* patches, size_t capacity,
                                      size_t* count) noexcept {
  return guard(__func__, [&] {
    const auto numbers = object(field, "field").patches();
    *need(count, "count") = numbers.size();
    if (capacity > 0) need(patches, "patches");
    for (size_t i = 0; i < capacity && i < numbers.size(); ++i) patches[i] = numbers[i];
  });
}

AWDResult AWD_CALL awdGetPatchInfo(AWDField field, uint32_t patch, AWDPatchInfo* info) noexcept {
  return guard(__func__, [&] {
    writeStruct(info, object(field, "field").patchInfo(patch), "info", "AWD_PATCH_INFO_INIT");
  });
}

AWDResult AWD_CALL awdGetPatchCoefficients(AWDField field, uint32_t patch, double* coefficients,
                                           size_t capacity) noexcept {
  return guard(__func__, [&] {
    const auto& values = object(field, "field").density(patch).coefficients();
    if (capacity < values.size()) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "capacity is %zu: patch %u has %zu coefficients", capacity,
           patch, values.size());
    }
    std::copy(values.begin(), values.end(), need(coefficients, "coefficients"));
  });
}

AWDResult AWD_CALL awdGetPatchMean(AWDField field, uint32_t patch, float* mean) noexcept {
  return guard(__func__, [&] {
    const Field& known = object(field, "field");
    float* out = need(mean, "mean");
    const PatchView view = known.view(patch);
    const bool kept = known.settings().learning.estimator != AWD_ESTIMATOR_PAPER;
    *out = view.known && kept ? view.mean : -1.0f;
  });
}

AWDResult AWD_CALL awdGetContinuation(AWDField field, uint32_t patch, float throughput,
                                      float expected, uint32_t maxSplit, float* rays) noexcept {
  return guard(__func__, [&] {
    const Field& known = object(field, "field");
    float* out = need(rays, "rays");
    if (!(throughput >= 0.0f && std::isfinite(throughput))) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "throughput is %g: it must be finite and not negative",
           throughput);
    }
    if (!(expected > 0.0f && std::isfinite(expected))) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "expected is %g: it must be positive and finite", expected);
    }
    const uint32_t most = settleSplit(maxSplit, "maxSplit");
    const PatchView view = known.view(patch);
    const bool kept = known.settings().learning.estimator != AWD_ESTIMATOR_PAPER;
    *out = view.known && kept
               ? continuation(throughput, view.mean, expected, static_cast<float>(most))
               : -1.0f;
  });
}

AWDResult AWD_CALL awdGetPatchPdf(AWDField field, uint32_t patch, uint32_t n, float* pixels,
                                  size_t rowStride) noexcept {
  return guard(__func__, [&] {
    const Field& known = object(field, "field");
    if (n < 1 || n > 16384) fail(AWD_ERROR_INVALID_ARGUMENT, "n is %u: 1 to 16384 is allowed", n);
    const Strides strides(0, rowStride, sizeof(float), n, n);
    known.pdfImage(patch, n, need(pixels, "pixels"), strides.row);
  });
}

}  // extern "C"
