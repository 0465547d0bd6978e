// SPDX-License-Identifier: Apache-2.0
// Fields from bytes that anyone may have made. First byte: 1, the frame is repaired.
#include "field_use.h"
#include "frame.h"
#include "require.h"
#include "target.h"

namespace fuzz {

namespace {

using awdtest::Field;

std::vector<AWDFieldDesc> fieldDescs() {
  const auto with = [](AWDEstimator estimator, const char* basis, AWDPatches patches) {
    AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
    desc.estimator = estimator;
    desc.basis = basis;
    desc.startLevel = AWD_LEVEL(1);
    desc.maxLevel = AWD_LEVEL(2);
    desc.patches = patches;
    desc.patchSamples = 30;
    if (patches == AWD_PATCHES_SPATIAL) desc.upper[0] = desc.upper[1] = desc.upper[2] = 1.0f;
    return desc;
  };
  std::vector<AWDFieldDesc> descs = {
      with(0, "haar", AWD_PATCHES_SPATIAL), with(0, nullptr, AWD_PATCHES_HOST),
      with(AWD_ESTIMATOR_PAPER, "haar", AWD_PATCHES_HOST),
      with(AWD_ESTIMATOR_RATIO, "quadratic-bspline", AWD_PATCHES_HOST),
      with(AWD_ESTIMATOR_QUASI, "m2", AWD_PATCHES_SPATIAL)};
  descs[0].lightCount = 3;
  descs[1].target = AWD_TARGET_RMS;
  return descs;
}

Field trained(const AWDFieldDesc& desc, AWDDevice device) {
  Field field = awdtest::newField(device, &desc);
  for (uint64_t pass = 0; pass < 2; ++pass) {
    recordField(field, 60, pass);
    awdtest::must(awdAdaptField(field, nullptr));
  }
  recordField(field, 10, 5);
  awdtest::must(awdMarkField(field));
  recordField(field, 10, 6);
  return field;
}

void run(const uint8_t* data, std::size_t size) {
  if (size < 2) return;
  Input bytes(data + 1, data + size);
  const Bounds bounds(std::size_t{48} << 20);
  static const Input like = savedField(awdtest::newField(bounds.device()));
  if (data[0] & 1) repairFrame(bytes, 0, bytes.size(), like);
  Field field;
  if (oneOf(awdLoadField(bounds.device(), bytes.data(), bytes.size(), field.out()),
            {AWD_ERROR_IO, AWD_ERROR_UNSUPPORTED, AWD_ERROR_OUT_OF_MEMORY}, "load")) {
    useField(bounds, field);
  }
}

std::vector<Input> seeds() {
  std::vector<Input> result;
  for (const AWDFieldDesc& desc : fieldDescs()) {
    Input bytes = savedField(trained(desc, BoundedDevice::shared().get()));
    bytes.insert(bytes.begin(), 1);
    result.push_back(std::move(bytes));
  }
  return result;
}

}  // namespace

const Target kSavedField = {"saved-field", run, seeds};

}  // namespace fuzz
