// SPDX-License-Identifier: Apache-2.0
// NULL where something must be, NULL where it may be, and what outputs hold after a failure.
#include <gtest/gtest.h>

#include <functional>

#include "input/objects.h"

namespace {

using namespace awdtest;

constexpr AWDResult kInvalid = AWD_ERROR_INVALID_ARGUMENT;

TEST_F(Arguments, NullHandles) {
  const AWDMaterialDesc material = AWD_MATERIAL_DESC_INIT;
  const AWDMeshDesc mesh = AWD_MESH_DESC_INIT;
  const AWDRay ray = {{0, 0, 0}, 0, {0, 0, 1}, 1};
  AWDHit hit;
  AWDScene scene;
  AWDField field;
  AWDRender render;
  AWDImage image;
  AWDBasisInfo basisInfo = AWD_BASIS_INFO_INIT;
  AWDSceneInfo sceneInfo = AWD_SCENE_INFO_INIT;
  AWDPatchInfo patchInfo = AWD_PATCH_INFO_INIT;
  AWDFieldStatistics fieldFigures = AWD_FIELD_STATISTICS_INIT;
  AWDPassStatistics passFigures = AWD_PASS_STATISTICS_INIT;
  AWDRenderError renderError = AWD_RENDER_ERROR_INIT;
  AWDDirectionSample sample = {};
  must(awdSampleField(field_, 0, up_, uniforms_, &sample));
  uint8_t occluded;
  uint32_t id;
  size_t count;
  double coefficients[64];
  const char* text;
  const std::function<AWDResult()> calls[] = {
      [&] { return awdLoadBasisModule(nullptr, "/nowhere"); },
      [&] { return awdGetBasisCount(nullptr, &count); },
      [&] { return awdGetBasisInfo(nullptr, 0, &basisInfo); },
      [&] { return awdNewScene(nullptr, &scene); },
      [&] { return awdAddMaterial(nullptr, &material, &id); },
      [&] { return awdAddMesh(nullptr, &mesh, &id); },
      [&] { return awdCommitScene(nullptr); },
      [&] { return awdGetSceneInfo(nullptr, &sceneInfo); },
      [&] { return awdIntersect(nullptr, &ray, 1, &hit); },
      [&] { return awdOccluded(nullptr, &ray, 1, &occluded); },
      [&] { return awdGetTrianglePatch(nullptr, 0, 0, 0, &id); },
      [&] { return awdGetPointPatch(nullptr, up_, &id); },
      [&] { return awdNewField(nullptr, nullptr, &field); },
      [&] { return awdSampleField(nullptr, 0, up_, uniforms_, &sample); },
      [&] { return awdGetFieldPdf(nullptr, 0, up_, up_, floats_); },
      [&] { return awdRecordField(nullptr, 0, &sample, 1.0); },
      [&] { return awdMapDirection(nullptr, 0, up_, up_, &sample); },
      [&] { return awdFindPatches(nullptr, 1, up_, up_, &id); },
      [&] { return awdSampleFieldBatch(nullptr, 1, &id, up_, uniforms_, &sample); },
      [&] { return awdGetFieldPdfs(nullptr, 1, &id, up_, up_, floats_); },
      [&] { return awdRecordFieldBatch(nullptr, 1, &id, &sample, uniforms_); },
      [&] { return awdRecordFieldPath(nullptr, 0, nullptr, nullptr, floats_); },
      [&] { return awdSaveField(nullptr, nullptr, 0, &count); },
      [&] { return awdLoadField(nullptr, "", 1, &field); },
      [&] { return awdWriteField(nullptr, "/nowhere"); },
      [&] { return awdReadField(nullptr, "/nowhere", &field); },
      [&] { return awdMergeField(nullptr, field_); },
      [&] { return awdSetFieldScale(nullptr, 1.0); },
      [&] { return awdMarkField(nullptr); },
      [&] { return awdRevertField(nullptr); },
      [&] { return awdAdaptField(nullptr, &fieldFigures); },
      [&] { return awdGetFieldStatistics(nullptr, &fieldFigures); },
      [&] { return awdGetFieldPatches(nullptr, nullptr, 0, &count); },
      [&] { return awdGetPatchInfo(nullptr, 0, &patchInfo); },
      [&] { return awdGetPatchCoefficients(nullptr, 0, coefficients, 64); },
      [&] { return awdGetPatchPdf(nullptr, 0, 2, floats_, 0); },
      [&] { return awdGetPatchMean(nullptr, 0, floats_); },
      [&] { return awdGetContinuation(nullptr, 0, 1.0f, 1.0f, 0, floats_); },
      [&] { return awdChooseLight(nullptr, 0, 0.5, &id, floats_, nullptr); },
      [&] { return awdGetLightChance(nullptr, 0, 0, floats_); },
      [&] { return awdRecordLight(nullptr, 0, 0, 1.0); },
      [&] { return awdGetPatchLight(nullptr, 0, floats_); },
      [&] { return awdNewSceneField(nullptr, nullptr, &field); },
      [&] { return awdNewRender(nullptr, nullptr, &desc_, &render); },
      [&] { return awdGetRenderField(nullptr, &field); },
      [&] { return awdRenderPass(nullptr, 1, &passFigures); },
      [&] { return awdRenderPasses(nullptr, nullptr); },
      [&] { return awdGetPassCount(nullptr, &id); },
      [&] { return awdGetPassStatistics(nullptr, 0, &passFigures); },
      [&] { return awdGetRenderStatistics(nullptr, &passFigures); },
      [&] { return awdReadFilm(nullptr, AWD_FILM_RADIANCE, floats_, 0, 0); },
      [&] { return awdGetFilmInfo(nullptr, &id, nullptr, nullptr); },
      [&] { return awdGetPixelPatch(nullptr, 0, 0, &id); },
      [&] { return awdGetRenderError(nullptr, &renderError); },
      [&] { return awdNewImage(nullptr, 1, 1, &image); },
      [&] { return awdNewFilmImage(nullptr, &image); },
      [&] { return awdNewPatchImage(nullptr, 0, 2, &image); },
      [&] { return awdReadImage(nullptr, "/nowhere", &image); },
      [&] { return awdGetImageInfo(nullptr, &id, nullptr, nullptr); },
      [&] { return awdGetImageChannelName(nullptr, 0, &text); },
      [&] { return awdSetImageChannel(nullptr, "Y", floats_, 0, 0); },
      [&] { return awdGetImageChannel(nullptr, "Y", floats_, 0, 0); },
      [&] { return awdSetImageMetadata(nullptr, "key", "value"); },
      [&] { return awdGetImageMetadata(nullptr, "key", &text); },
      [&] { return awdWriteImageEXR(nullptr, "/nowhere"); },
      [&] { return awdWriteImagePNG(nullptr, "/nowhere", nullptr); },
  };
  int number = 0;
  for (const auto& call : calls) {
    SCOPED_TRACE(number++);
    expectFailure(call(), kInvalid, {"NULL"});
  }
}

TEST_F(Arguments, NullOutputsAndInputs) {
  const AWDRay ray = {{0, 0, 0}, 0, {0, 0, 1}, 1};
  AWDHit hit;
  AWDDirectionSample sample = {};
  uint8_t occluded;
  uint32_t id;
  size_t count;
  const char* text;
  AWDField field;
  AWDRender render;
  must(awdSetImageChannel(image_, "Y", floats_, 0, 0));
  const std::function<AWDResult()> calls[] = {
      [&] { return awdNewDevice(nullptr, nullptr); },
      [&] { return awdLoadBasisModule(device_, nullptr); },
      [&] { return awdRegisterBasisModule(device_, nullptr); },
      [&] { return awdGetBasisCount(device_, nullptr); },
      [&] { return awdGetBasisInfo(device_, 0, nullptr); },
      [&] { return awdNewScene(device_, nullptr); },
      [&] { return awdAddMaterial(scene_, nullptr, &id); },
      [&] { return awdAddMesh(scene_, nullptr, &id); },
      [&] { return awdGetSceneInfo(scene_, nullptr); },
      [&] { return awdIntersect(scene_, nullptr, 1, &hit); },
      [&] { return awdIntersect(scene_, &ray, 1, nullptr); },
      [&] { return awdOccluded(scene_, nullptr, 1, &occluded); },
      [&] { return awdOccluded(scene_, &ray, 1, nullptr); },
      [&] { return awdGetTrianglePatch(scene_, 0, 0, 0, nullptr); },
      [&] { return awdGetPointPatch(scene_, nullptr, &id); },
      [&] { return awdGetPointPatch(scene_, up_, nullptr); },
      [&] { return awdNewField(device_, nullptr, nullptr); },
      [&] { return awdSampleField(field_, 0, nullptr, uniforms_, &sample); },
      [&] { return awdSampleField(field_, 0, up_, nullptr, &sample); },
      [&] { return awdSampleField(field_, 0, up_, uniforms_, nullptr); },
      [&] { return awdGetFieldPdf(field_, 0, nullptr, up_, floats_); },
      [&] { return awdGetFieldPdf(field_, 0, up_, nullptr, floats_); },
      [&] { return awdGetFieldPdf(field_, 0, up_, up_, nullptr); },
      [&] { return awdRecordField(field_, 0, nullptr, 1.0); },
      [&] { return awdMapDirection(field_, 0, nullptr, up_, &sample); },
      [&] { return awdMapDirection(field_, 0, up_, nullptr, &sample); },
      [&] { return awdMapDirection(field_, 0, up_, up_, nullptr); },
      [&] { return awdSampleFieldBatch(field_, 1, nullptr, up_, uniforms_, &sample); },
      [&] { return awdSampleFieldBatch(field_, 1, &id, nullptr, uniforms_, &sample); },
      [&] { return awdSampleFieldBatch(field_, 1, &id, up_, nullptr, &sample); },
      [&] { return awdSampleFieldBatch(field_, 1, &id, up_, uniforms_, nullptr); },
      [&] { return awdGetFieldPdfs(field_, 1, nullptr, up_, up_, floats_); },
      [&] { return awdGetFieldPdfs(field_, 1, &id, nullptr, up_, floats_); },
      [&] { return awdGetFieldPdfs(field_, 1, &id, up_, nullptr, floats_); },
      [&] { return awdGetFieldPdfs(field_, 1, &id, up_, up_, nullptr); },
      [&] { return awdRecordFieldBatch(field_, 1, nullptr, &sample, uniforms_); },
      [&] { return awdRecordFieldBatch(field_, 1, &id, nullptr, uniforms_); },
      [&] { return awdRecordFieldBatch(field_, 1, &id, &sample, nullptr); },
      [&] { return awdRecordFieldPath(field_, 1, nullptr, nullptr, floats_); },
      [&] { return awdSaveField(field_, nullptr, 0, nullptr); },
      [&] { return awdSaveField(field_, nullptr, 1 << 20, &count); },
      [&] { return awdLoadField(device_, nullptr, 1, &field); },
      [&] { return awdLoadField(device_, "", 1, nullptr); },
      [&] { return awdWriteField(field_, nullptr); },
      [&] { return awdReadField(device_, nullptr, &field); },
      [&] { return awdReadField(device_, "/nowhere", nullptr); },
      [&] { return awdMergeField(field_, nullptr); },
      [&] { return awdGetFieldStatistics(field_, nullptr); },
      [&] { return awdGetFieldPatches(field_, nullptr, 1, &count); },
      [&] { return awdGetFieldPatches(field_, &id, 1, nullptr); },
      [&] { return awdGetPatchInfo(field_, 0, nullptr); },
      [&] { return awdGetPatchCoefficients(field_, 0, nullptr, 4096); },
      [&] { return awdGetPatchPdf(field_, 0, 2, nullptr, 0); },
      [&] { return awdNewRender(scene_, nullptr, nullptr, &render); },
      [&] { return awdNewRender(scene_, nullptr, &desc_, nullptr); },
      [&] { return awdGetRenderField(render_, nullptr); },
      [&] { return awdGetPassCount(render_, nullptr); },
      [&] { return awdGetRenderStatistics(render_, nullptr); },
      [&] { return awdReadFilm(render_, AWD_FILM_RADIANCE, nullptr, 0, 0); },
      [&] { return awdGetPixelPatch(render_, 0, 0, nullptr); },
      [&] { return awdNewImage(device_, 1, 1, nullptr); },
      [&] { return awdNewFilmImage(render_, nullptr); },
      [&] { return awdNewPatchImage(field_, 0, 2, nullptr); },
      [&] { return awdReadImage(device_, "/nowhere", nullptr); },
      [&] { return awdReadImage(device_, nullptr, image_.out()); },
  };
  int number = 0;
  for (const auto& call : calls) {
    SCOPED_TRACE(number++);
    expectFailure(call(), kInvalid, {"NULL"});
  }
  must(awdNewImage(device_, 2, 2, image_.out()));
  must(awdSetImageChannel(image_, "Y", floats_, 0, 0));
  const std::function<AWDResult()> imageCalls[] = {
      [&] { return awdGetImageChannelName(image_, 0, nullptr); },
      [&] { return awdSetImageChannel(image_, nullptr, floats_, 0, 0); },
      [&] { return awdSetImageChannel(image_, "Y", nullptr, 0, 0); },
      [&] { return awdGetImageChannel(image_, nullptr, floats_, 0, 0); },
      [&] { return awdGetImageChannel(image_, "Y", nullptr, 0, 0); },
      [&] { return awdSetImageMetadata(image_, nullptr, "value"); },
      [&] { return awdGetImageMetadata(image_, nullptr, &text); },
      [&] { return awdGetImageMetadata(image_, "key", nullptr); },
      [&] { return awdWriteImageEXR(image_, nullptr); },
      [&] { return awdWriteImagePNG(image_, nullptr, nullptr); },
  };
  for (const auto& call : imageCalls) {
    SCOPED_TRACE(number++);
    expectFailure(call(), kInvalid, {"NULL"});
  }
}

TEST_F(Arguments, NullWhereItMeansNothingIsFine) {
  awdRetainDevice(nullptr), awdReleaseDevice(nullptr);
  awdRetainScene(nullptr), awdReleaseScene(nullptr);
  awdRetainField(nullptr), awdReleaseField(nullptr);
  awdRetainRender(nullptr), awdReleaseRender(nullptr);
  awdRetainImage(nullptr), awdReleaseImage(nullptr);
  EXPECT_EQ(awdIntersect(scene_, nullptr, 0, nullptr), AWD_SUCCESS);
  EXPECT_EQ(awdOccluded(scene_, nullptr, 0, nullptr), AWD_SUCCESS);
  EXPECT_EQ(awdGetFilmInfo(render_, nullptr, nullptr, nullptr), AWD_SUCCESS);
  EXPECT_EQ(awdGetImageInfo(image_, nullptr, nullptr, nullptr), AWD_SUCCESS);
  EXPECT_EQ(awdSetImageMetadata(image_, "key", nullptr), AWD_SUCCESS);
  EXPECT_EQ(awdRenderPass(render_, 1, nullptr), AWD_SUCCESS);
  EXPECT_EQ(awdAdaptField(field_, nullptr), AWD_SUCCESS);
}

TEST_F(Arguments, HandleOutputsAreNullAfterAFailure) {
  void* const rubbish = &floats_;
  AWDField field = static_cast<AWDField>(rubbish);
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.basis = "nonesuch";
  EXPECT_NE(awdNewField(device_, &desc, &field), AWD_SUCCESS);
  EXPECT_EQ(field, nullptr);
  AWDScene scene = static_cast<AWDScene>(rubbish);
  EXPECT_NE(awdNewScene(nullptr, &scene), AWD_SUCCESS);
  EXPECT_EQ(scene, nullptr);
  AWDImage image = static_cast<AWDImage>(rubbish);
  EXPECT_NE(awdReadImage(device_, "/nonexistent/file.exr", &image), AWD_SUCCESS);
  EXPECT_EQ(image, nullptr);
  image = static_cast<AWDImage>(rubbish);
  EXPECT_NE(awdNewImage(device_, 0, 1, &image), AWD_SUCCESS);
  EXPECT_EQ(image, nullptr);
  AWDDevice device = static_cast<AWDDevice>(rubbish);
  AWDDeviceDesc deviceDesc = AWD_DEVICE_DESC_INIT;
  deviceDesc.structSize = 3;
  EXPECT_NE(awdNewDevice(&deviceDesc, &device), AWD_SUCCESS);
  EXPECT_EQ(device, nullptr);
}

}  // namespace
