// SPDX-License-Identifier: Apache-2.0
#include "api/handles.h"
#include "api/render_at_work.h"
#include "api/saved_bytes.h"
#include "awd/render.h"
#include "render/render.h"
#include "util/file_bytes.h"

using namespace awd;

extern "C" {

AWDResult AWD_CALL awdSaveRender(AWDRender render, const char* path) noexcept {
  return guard(__func__, [&] { idleWithField(render).save(need(path, "path")); });
}

AWDResult AWD_CALL awdLoadRender(AWDScene scene, const char* path, AWDField field,
                                 const AWDRenderDesc* desc, AWDRender* render) noexcept {
  return guard(__func__, [&] {
    clearOutput(render, "render");
    Scene& known = object(scene, "scene");
    Device& device = known.device();
    const Ref<Geometry> geometry = known.shareGeometry();
    AWDRenderDesc settings = AWD_RENDER_DESC_INIT;
    AWDCamera camera = AWD_CAMERA_INIT;
    if (desc) {
      settings = readStruct(desc, "desc", "AWD_RENDER_DESC_INIT");
      camera = readStruct(settings.camera, "desc->camera", "AWD_CAMERA_INIT");
      settings.camera = &camera;
    }
    const auto bytes = readFile(device.context().memory(), need(path, "path"));
    try {
      give(render, Render::load(device.shareContext(), geometry, bytes.data(), bytes.size(),
                                findersOf(device), desc ? &settings : nullptr, behind(field)));
    } catch (const Error& error) {
      fail(error.code(), "can't load \"%s\": %s", path, error.what());
    }
  });
}

}  // extern "C"
