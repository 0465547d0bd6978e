// SPDX-License-Identifier: Apache-2.0
// Checkpoints of renders that anyone may have made. First byte: bit 0, frame and scene are
// repaired; bit 1, so is the frame of the field within.
#include <algorithm>
#include <cstring>

#include "bounded_device.h"
#include "field_use.h"
#include "frame.h"
#include "render_use.h"
#include "require.h"
#include "scratch_file.h"
#include "support/films.h"
#include "support/scenes.h"
#include "target.h"

namespace fuzz {

namespace {

using awdtest::Field;
using awdtest::Render;
using awdtest::Scene;

constexpr uint8_t kRepaired = 1, kFieldRepaired = 2;
/// Digest of the scene and number of its triangles.
constexpr std::size_t kSceneBytes = 16;

AWDScene room() {
  static const Scene scene = awdtest::lampRoom().commit(BoundedDevice::shared().get());
  return scene;
}

Input checkpoint(AWDGuide guide, AWDPreset preset) {
  const AWDCamera camera = awdtest::lampRoomCamera(3);
  AWDRenderDesc desc = awdtest::renderDesc(camera, guide, 3);
  desc.preset = preset;
  AWDFieldDesc small = AWD_FIELD_DESC_INIT;
  small.startLevel = AWD_LEVEL(1);
  small.maxLevel = AWD_LEVEL(1);
  small.basis = "haar";
  small.preset = preset;
  Field field;
  awdtest::must(awdNewSceneField(room(), &small, field.out()));
  const Render render = awdtest::newRender(room(), desc, field);
  awdtest::runPasses(render, {1, 2, 1});
  const std::string path = scratchPath("seed");
  awdtest::must(awdSaveRender(render, path.c_str()));
  return readScratch(path);
}

const Input& like() {
  static const Input bytes = checkpoint(AWD_GUIDE_ADAPTIVE, AWD_PRESET_DEFAULT);
  return bytes;
}

/// The field within begins where its magic stands, and its length stands before it.
void repairField(Input& bytes) {
  static const Input fieldLike = savedField(awdtest::newField(BoundedDevice::shared().get()));
  const auto at = std::search(bytes.begin(), bytes.end(), fieldLike.begin(), fieldLike.begin() + 8);
  if (at == bytes.end()) return;
  const auto begin = static_cast<std::size_t>(at - bytes.begin());
  uint64_t length = 0;
  if (begin < sizeof length) return;
  std::memcpy(&length, &bytes[begin - sizeof length], sizeof length);
  if (length <= bytes.size() - begin) repairFrame(bytes, begin, begin + length, fieldLike);
}

void run(const uint8_t* data, std::size_t size) {
  if (size < 2) return;
  room();
  like();
  const Bounds bounds(std::size_t{64} << 20);
  Input bytes(data + 1, data + size);
  if (data[0] & kFieldRepaired) repairField(bytes);
  bool ours = false;
  if (data[0] & kRepaired && bytes.size() >= kFrame + kSceneBytes) {
    std::copy_n(like().begin() + kFrame, kSceneBytes, bytes.begin() + kFrame);
    ours = repairFrame(bytes, 0, bytes.size(), like());
  }
  const std::string path = scratchPath("checkpoint");
  writeScratch(path, bytes);
  Render render;
  const AWDResult result = awdLoadRender(room(), path.c_str(), nullptr, nullptr, render.out());
  // Only of another scene is it an argument that is wrong.
  if (ours) require(result != AWD_ERROR_INVALID_ARGUMENT, "damage is told as a wrong argument");
  if (!oneOf(result,
             {AWD_ERROR_IO, AWD_ERROR_UNSUPPORTED, AWD_ERROR_OUT_OF_MEMORY,
              AWD_ERROR_INVALID_ARGUMENT},
             "load")) {
    return;
  }
  lookAt(render);
  const auto again = [&] {
    require(awdSaveRender(render, path.c_str()) == AWD_SUCCESS, "can't be saved again");
    Render copy;
    oneOf(awdLoadRender(room(), path.c_str(), nullptr, nullptr, copy.out()),
          {AWD_ERROR_OUT_OF_MEMORY}, "what was saved");
  };
  again();
  Field field;
  require(awdGetRenderField(render, field.out()) == AWD_SUCCESS, "no field");
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  const uint32_t one = 1;
  schedule.samplesPerPass = &one;
  schedule.passCount = 1;
  for (int pass = 0; pass < 2; ++pass) {
    oneOf(awdRenderPasses(render, &schedule),
          {AWD_ERROR_OUT_OF_MEMORY, AWD_ERROR_CANCELLED, AWD_ERROR_INVALID_OPERATION}, "pass");
  }
  lookAt(render);
  again();
  if (field) useField(bounds, field);
}

std::vector<Input> seeds() {
  std::vector<Input> result;
  for (Input bytes : {checkpoint(AWD_GUIDE_ADAPTIVE, AWD_PRESET_DEFAULT),
                      checkpoint(AWD_GUIDE_ADAPTIVE, AWD_PRESET_PAPER),
                      checkpoint(AWD_GUIDE_COSINE, AWD_PRESET_DEFAULT)}) {
    bytes.insert(bytes.begin(), kRepaired | kFieldRepaired);
    result.push_back(std::move(bytes));
  }
  return result;
}

}  // namespace

const Target kCheckpoint = {"checkpoint", run, seeds};

}  // namespace fuzz
