// SPDX-License-Identifier: Apache-2.0
// What stands in for awd/scene.h, awd/render.h and awd/image.h in a build without the renderer, so
// that every libawd of one soname exports the same functions: a host that was linked with one runs
// with the other, and is told.
#include "api/guard.h"
#include "awd/image.h"
#include "awd/render.h"
#include "awd/scene.h"

namespace {

/// Fails as unsupported; outputs that a host would release or read are NULL.
template <class... Output>
AWDResult refuse(const char* function, Output**... outputs) noexcept {
  ((outputs ? void(*outputs = nullptr) : void()), ...);
  return awd::guard(function, [] {
    awd::fail(AWD_ERROR_UNSUPPORTED,
              "this libawd was built without the renderer and images (AWD_RENDER=OFF): install one "
              "that was built with AWD_RENDER=ON");
  });
}

}  // namespace

extern "C" {

// awd/scene.h

AWDResult AWD_CALL awdNewScene(AWDDevice, AWDScene* scene) noexcept {
  return refuse(__func__, scene);
}
void AWD_CALL awdRetainScene(AWDScene) noexcept {}
void AWD_CALL awdReleaseScene(AWDScene) noexcept {}
AWDResult AWD_CALL awdAddMaterial(AWDScene, const AWDMaterialDesc*, uint32_t*) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdAddMesh(AWDScene, const AWDMeshDesc*, uint32_t*) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdCommitScene(AWDScene) noexcept { return refuse(__func__); }
AWDResult AWD_CALL awdGetSceneInfo(AWDScene, AWDSceneInfo*) noexcept { return refuse(__func__); }
AWDResult AWD_CALL awdIntersect(AWDScene, const AWDRay*, size_t, AWDHit*) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdOccluded(AWDScene, const AWDRay*, size_t, uint8_t*) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdGetTrianglePatch(AWDScene, uint32_t, uint32_t, int32_t, uint32_t*) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdGetPointPatch(AWDScene, const float*, uint32_t*) noexcept {
  return refuse(__func__);
}

// awd/render.h

AWDResult AWD_CALL awdNewSceneField(AWDScene, const AWDFieldDesc*, AWDField* field) noexcept {
  return refuse(__func__, field);
}
AWDResult AWD_CALL awdNewRender(AWDScene, AWDField, const AWDRenderDesc*,
                                AWDRender* render) noexcept {
  return refuse(__func__, render);
}
void AWD_CALL awdRetainRender(AWDRender) noexcept {}
void AWD_CALL awdReleaseRender(AWDRender) noexcept {}
AWDResult AWD_CALL awdGetRenderField(AWDRender, AWDField* field) noexcept {
  return refuse(__func__, field);
}
AWDResult AWD_CALL awdRenderPass(AWDRender, uint32_t, AWDPassStatistics*) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdRenderPasses(AWDRender, const AWDSchedule*) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdSaveRender(AWDRender, const char*) noexcept { return refuse(__func__); }
AWDResult AWD_CALL awdLoadRender(AWDScene, const char*, AWDField, const AWDRenderDesc*,
                                 AWDRender* render) noexcept {
  return refuse(__func__, render);
}
AWDResult AWD_CALL awdRenderPassPart(AWDRender, const AWDSchedule*, uint32_t, uint32_t,
                                     uint32_t*) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdExportPass(AWDRender, uint64_t*, size_t, size_t*, size_t*) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdImportPass(AWDRender, const uint64_t*, size_t, AWDPassStatistics*) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdGetQualitySchedule(AWDQuality, AWDSchedule*) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdGetPassCount(AWDRender, uint32_t*) noexcept { return refuse(__func__); }
AWDResult AWD_CALL awdGetPassStatistics(AWDRender, uint32_t, AWDPassStatistics*) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdGetRenderStatistics(AWDRender, AWDPassStatistics*) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdReadFilm(AWDRender, AWDFilmLayer, float*, size_t, size_t) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdGetFilmInfo(AWDRender, uint32_t*, uint32_t*, uint64_t*) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdGetRenderError(AWDRender, AWDRenderError*) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdGetPixelPatch(AWDRender, uint32_t, uint32_t, uint32_t*) noexcept {
  return refuse(__func__);
}

// awd/image.h

AWDResult AWD_CALL awdNewImage(AWDDevice, uint32_t, uint32_t, AWDImage* image) noexcept {
  return refuse(__func__, image);
}
AWDResult AWD_CALL awdNewFilmImage(AWDRender, AWDImage* image) noexcept {
  return refuse(__func__, image);
}
AWDResult AWD_CALL awdNewPatchImage(AWDField, uint32_t, uint32_t, AWDImage* image) noexcept {
  return refuse(__func__, image);
}
AWDResult AWD_CALL awdReadImage(AWDDevice, const char*, AWDImage* image) noexcept {
  return refuse(__func__, image);
}
void AWD_CALL awdRetainImage(AWDImage) noexcept {}
void AWD_CALL awdReleaseImage(AWDImage) noexcept {}
AWDResult AWD_CALL awdGetImageInfo(AWDImage, uint32_t*, uint32_t*, uint32_t*) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdGetImageChannelName(AWDImage, uint32_t, const char** name) noexcept {
  return refuse(__func__, name);
}
AWDResult AWD_CALL awdSetImageChannel(AWDImage, const char*, const float*, size_t,
                                      size_t) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdGetImageChannel(AWDImage, const char*, float*, size_t, size_t) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdSetImageMetadata(AWDImage, const char*, const char*) noexcept {
  return refuse(__func__);
}
AWDResult AWD_CALL awdGetImageMetadata(AWDImage, const char*, const char** value) noexcept {
  return refuse(__func__, value);
}
AWDResult AWD_CALL awdWriteImageEXR(AWDImage, const char*) noexcept { return refuse(__func__); }
AWDResult AWD_CALL awdWriteImagePNG(AWDImage, const char*, const AWDPNGDesc*) noexcept {
  return refuse(__func__);
}

}  // extern "C"
