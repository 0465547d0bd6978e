// SPDX-License-Identifier: Apache-2.0
// One good object of each kind, for tests that then ask something impossible of it.
#pragma once

#include "support/expect.h"
#include "support/films.h"
#include "support/scenes.h"

namespace awdtest {

class Arguments : public testing::Test {
 protected:
  Arguments()
      : device_(newDevice(1u)),
        scene_(lampRoom().commit(device_)),
        field_(newField(device_)),
        camera_(lampRoomCamera(4)),
        desc_(renderDesc(camera_, AWD_GUIDE_ADAPTIVE, 1)),
        render_(newRender(scene_, desc_, field_)) {
    must(awdNewImage(device_, 2, 2, image_.out()));
  }

  void expectNoRender(const AWDRenderDesc& desc, const std::vector<std::string>& parts) {
    AWDRender render = render_;
    expectFailure(awdNewRender(scene_, nullptr, &desc, &render), AWD_ERROR_INVALID_ARGUMENT, parts);
    EXPECT_EQ(render, nullptr);
  }

  Device device_;
  Scene scene_;
  Field field_;
  AWDCamera camera_;
  AWDRenderDesc desc_;
  Render render_;
  Image image_;
  const float up_[3] = {0, 0, 1};
  const double uniforms_[3] = {0.5, 0.5, 0.5};
  float floats_[64] = {};
};

}  // namespace awdtest
