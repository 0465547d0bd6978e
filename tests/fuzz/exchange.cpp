// SPDX-License-Identifier: Apache-2.0
// Numbers of fields and of parts of passes, as another process may send them: what was exported,
// and changes of it. First byte: bit 0, of a pass.
#include <algorithm>
#include <cstring>

#include "bounded_device.h"
#include "bytes.h"
#include "field_use.h"
#include "render_use.h"
#include "require.h"
#include "scratch_file.h"
#include "support/films.h"
#include "support/random.h"
#include "support/scenes.h"
#include "target.h"

namespace fuzz {

namespace {

using awdtest::Field;
using awdtest::Render;
using awdtest::Scene;
using Numbers = std::vector<uint64_t>;

AWDScene room() {
  static const Scene scene = awdtest::lampRoom().commit(BoundedDevice::shared().get());
  return scene;
}

/// Each at a place that the bytes say: another number, a sum, or bits that differ.
void change(Bytes& bytes, Numbers& numbers) {
  constexpr uint64_t kSpecial[] = {0,
                                   1,
                                   ~uint64_t{0},
                                   uint64_t{1} << 63,
                                   (uint64_t{1} << 63) - 1,
                                   uint64_t{1} << 32,
                                   uint64_t{1} << 60,
                                   0x7fefffffffffffffu,   // as double: the largest
                                   0x7ff0000000000000u,   // infinity
                                   0x7ff8000000000000u,   // NaN
                                   0x3ff0000000000000u};  // 1
  for (int i = 0; i < 12 && !bytes.empty(); ++i) {
    const size_t far = size_t{bytes.byte()} << 8;
    const size_t at = (far | bytes.byte()) % numbers.size();
    const uint32_t how = bytes.byte();
    uint64_t number = kSpecial[bytes.below(sizeof kSpecial / sizeof *kSpecial)];
    if (how & 8) number = uint64_t{bytes.integer()} << bytes.below(64);
    uint64_t& target = numbers[at];
    target = how & 1 ? target + number : how & 2 ? target ^ number : number;
    if (how & 16)
      std::fill(numbers.begin() + static_cast<std::ptrdiff_t>(at), numbers.end(), number);
  }
  if (!bytes.empty() && bytes.byte() == 255) numbers.resize(bytes.below(255));
}

void exchangeField(const Bounds& bounds, Bytes& bytes) {
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  const bool spatial = bytes.below(2) != 0;
  desc.basis = "haar";
  desc.startLevel = AWD_LEVEL(1);
  desc.maxLevel = AWD_LEVEL(2);
  desc.patchSamples = 30;
  desc.lightCount = spatial ? 3 : 0;
  desc.estimator = bytes.below(4) ? 0 : AWD_ESTIMATOR_RATIO;
  desc.patches = spatial ? AWD_PATCHES_SPATIAL : AWD_PATCHES_HOST;
  if (spatial) desc.upper[0] = desc.upper[1] = desc.upper[2] = 1.0f;
  const Field field = awdtest::newField(bounds.device(), &desc);
  recordField(field, 40, 3);
  awdtest::must(awdAdaptField(field, nullptr));
  recordField(field, 20, 4);
  const uint32_t patches[] = {0, 1, 2, 7};
  const uint32_t* list = spatial ? nullptr : patches;
  const size_t listed = spatial ? 0 : 4;
  size_t sums = 0, maxima = 0;
  awdtest::must(awdExportField(field, list, listed, nullptr, 0, &sums, &maxima));
  Numbers numbers(sums + maxima);
  awdtest::must(
      awdExportField(field, list, listed, numbers.data(), numbers.size(), &sums, &maxima));
  change(bytes, numbers);
  oneOf(awdImportField(field, list, listed, numbers.data(), numbers.size()),
        {AWD_ERROR_INVALID_ARGUMENT, AWD_ERROR_OUT_OF_MEMORY}, "import");
  useField(bounds, field);
}

void exchangePass(const Bounds& bounds, Bytes& bytes) {
  const AWDCamera camera = awdtest::lampRoomCamera(3);
  const AWDScene scene = room();
  const auto guide = static_cast<AWDGuide>(bytes.below(2));
  AWDFieldDesc small = AWD_FIELD_DESC_INIT;
  small.basis = "haar";
  small.startLevel = AWD_LEVEL(1);
  small.maxLevel = AWD_LEVEL(1);
  Field field;
  awdtest::must(awdNewSceneField(scene, &small, field.out()));
  const Render render = awdtest::newRender(scene, awdtest::renderDesc(camera, guide, 3), field);
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  const uint32_t passes[] = {1, 2, 1};
  schedule.samplesPerPass = passes;
  schedule.passCount = 3;
  for (int pass = 0; pass < 3; ++pass) {
    uint32_t samples = 0;
    if (!oneOf(awdRenderPassPart(render, &schedule, 0, 1, &samples),
               {AWD_ERROR_CANCELLED, AWD_ERROR_OUT_OF_MEMORY}, "part")) {
      break;
    }
    if (samples == 0) break;
    size_t sums = 0, maxima = 0;
    awdtest::must(awdExportPass(render, nullptr, 0, &sums, &maxima));
    Numbers numbers(sums + maxima);
    awdtest::must(awdExportPass(render, numbers.data(), numbers.size(), &sums, &maxima));
    change(bytes, numbers);
    oneOf(awdImportPass(render, numbers.data(), numbers.size(), nullptr),
          {AWD_ERROR_INVALID_ARGUMENT, AWD_ERROR_OUT_OF_MEMORY}, "import");
  }
  lookAt(render);
  const std::string path = scratchPath("exchanged");
  // A part may wait to be imported.
  if (oneOf(awdSaveRender(render, path.c_str()), {AWD_ERROR_INVALID_OPERATION}, "save")) {
    Render copy;
    oneOf(awdLoadRender(scene, path.c_str(), nullptr, nullptr, copy.out()),
          {AWD_ERROR_OUT_OF_MEMORY}, "what was saved");
  }
  if (guide == AWD_GUIDE_ADAPTIVE) useField(bounds, field);
}

void run(const uint8_t* data, std::size_t size) {
  room();
  const Bounds bounds;
  Bytes bytes(data, size);
  bytes.below(2) ? exchangePass(bounds, bytes) : exchangeField(bounds, bytes);
}

std::vector<Input> seeds() {
  std::vector<Input> result;
  awdtest::Random random(8);
  for (uint8_t i = 0; i < 24; ++i) {
    Input input = {i, static_cast<uint8_t>(i / 2), static_cast<uint8_t>(i / 4)};
    for (int k = 0; k < 5 * (i % 4); ++k) input.push_back(static_cast<uint8_t>(random.bits()));
    result.push_back(std::move(input));
  }
  return result;
}

}  // namespace

const Target kExchange = {"exchange", run, seeds};

}  // namespace fuzz
