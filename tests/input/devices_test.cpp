// SPDX-License-Identifier: Apache-2.0
// Two devices share nothing, and objects of two devices don't mix.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "awd/basis.h"
#include "support/expect.h"
#include "support/films.h"
#include "support/scenes.h"

namespace {

using namespace awdtest;

// A family for one device alone: boxes, as Haar's scaling functions.
uint32_t boxCount(uint32_t level) { return 1u << level; }
void boxSupport(uint32_t level, uint32_t j, double ab[2]) {
  ab[0] = std::ldexp(j, -static_cast<int>(level));
  ab[1] = std::ldexp(j + 1.0, -static_cast<int>(level));
}
double boxWeight(uint32_t level, uint32_t) { return std::ldexp(1.0, -static_cast<int>(level)); }
uint32_t boxEval(uint32_t level, double x, uint32_t* first, double* values) {
  const double n = boxCount(level);
  *first = static_cast<uint32_t>(std::min(x * n, n - 1.0));
  values[0] = 1.0;
  return 1;
}
double boxSample(uint32_t level, uint32_t j, const double* u) {
  return std::ldexp(j + u[0], -static_cast<int>(level));
}
uint32_t boxTwoScale(uint32_t, uint32_t j, uint32_t* first, double* h) {
  *first = 2 * j;
  h[0] = h[1] = 1.0;
  return 2;
}
const AWDBasisFamily kBox = {sizeof kBox,
                             "test.box",
                             "boxes",
                             AWD_BASIS_ORTHOGONAL | AWD_BASIS_NESTED,
                             1,
                             1,
                             0,
                             6,
                             boxCount,
                             boxCount,
                             boxSupport,
                             boxWeight,
                             boxEval,
                             boxSample,
                             boxTwoScale,
                             nullptr,
                             0};
const AWDBasisFamily* const kFamilies[] = {&kBox};
const AWDBasisModule kModule = {sizeof kModule, AWD_BASIS_ABI, 1, "1.0", "Apache-2.0", kFamilies};

AWDDeviceDesc logging(std::vector<std::string>& log) {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.log = [](void* user, int32_t, const char* text) {
    static_cast<std::vector<std::string>*>(user)->push_back(text);
  };
  desc.logUser = &log;
  return desc;
}

TEST(Devices, AFamilyIsKnownWhereItWasRegistered) {
  const Device a = newDevice(1u), b = newDevice(1u);
  must(awdRegisterBasisModule(a, &kModule));
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.basis = "test.box";
  const Field known = newField(a, &desc);
  AWDField field;
  expectFailure(awdNewField(b, &desc, &field), AWD_ERROR_UNSUPPORTED, {"test.box"});
  must(awdRegisterBasisModule(a, &kModule));  // it is there already
  const AWDBasisModule other = kModule;
  expectFailure(awdRegisterBasisModule(a, &other), AWD_ERROR_PLUGIN_NAME_TAKEN, {"test.box"});
  must(awdRegisterBasisModule(b, &kModule));
  must(awdNewField(b, &desc, &field));
  awdReleaseField(field);
}

TEST(Devices, LogsAreTheirOwn) {
  std::vector<std::string> logA, logB;
  const AWDDeviceDesc descA = logging(logA), descB = logging(logB);
  const Device a = newDevice(&descA), b = newDevice(&descB);
  SceneBuilder dark;
  dark.quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, dark.material(grey(0.5)));
  const Scene scene = dark.commit(b);
  EXPECT_EQ(logA.size(), 0u);
  EXPECT_EQ(logB.size(), 1u);
}

TEST(Devices, ObjectsOfTwoDontMix) {
  const Device a = newDevice(1u), b = newDevice(1u);
  const Scene scene = lampRoom().commit(a);
  const Field field = newField(b);
  const AWDCamera view = lampRoomCamera(4);
  const AWDRenderDesc desc = renderDesc(view, AWD_GUIDE_ADAPTIVE, 1);
  Render render;
  expectFailure(awdNewRender(scene, field, &desc, render.out()), AWD_ERROR_INVALID_ARGUMENT,
                {"field", "device"});
}

TEST(Devices, AChildKeepsItsParents) {
  Device device = newDevice(1u);
  Scene scene = lampRoom().commit(device);
  const AWDCamera view = lampRoomCamera(4);
  const Render render = newRender(scene, renderDesc(view, AWD_GUIDE_ADAPTIVE, 1));
  device = Device();
  scene = Scene();
  Field field;
  must(awdGetRenderField(render, field.out()));
  must(awdRenderPass(render, 2, nullptr));
  must(awdAdaptField(field, nullptr));
}

TEST(Devices, MessagesAreAThreadsOwnAndNameTheFunction) {
  AWDScene scene;
  expectFailure(awdNewScene(nullptr, &scene), AWD_ERROR_INVALID_ARGUMENT,
                {"awdNewScene", "device", "NULL"});
}

}  // namespace
