/* SPDX-License-Identifier: Apache-2.0
 *
 * A picture in C: the program that README.md shows.
 */
#include <awd/awd.h>
#include <stdio.h>

int main(void) {
  /* A grey floor under a lamp that shines down. */
  const float vertices[8][3] = {{-1, 0, 1},      {1, 0, 1},         {1, 0, -1},
                                {-1, 0, -1},     {-0.5f, 1, -0.5f}, {0.5f, 1, -0.5f},
                                {0.5f, 1, 0.5f}, {-0.5f, 1, 0.5f}};
  const uint32_t indices[4][3] = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  const uint32_t materials[4] = {0, 0, 1, 1};
  const AWDMaterialDesc grey = {sizeof grey, {0.5f, 0.5f, 0.5f}, {0, 0, 0}};
  const AWDMaterialDesc lamp = {sizeof lamp, {0, 0, 0}, {4, 4, 3}};
  AWDMeshDesc mesh = AWD_MESH_DESC_INIT;
  AWDCamera camera = AWD_CAMERA_INIT;
  AWDRenderDesc desc = AWD_RENDER_DESC_INIT;
  AWDDevice device = NULL;
  AWDScene scene = NULL;
  AWDRender render = NULL;
  AWDImage image = NULL;
  int failed;

  mesh.vertices = (AWDBuffer){vertices, 0, 0, 8, AWD_FORMAT_FLOAT3, 0};
  mesh.indices = (AWDBuffer){indices, 0, 0, 4, AWD_FORMAT_UINT3, 0};
  mesh.materials = (AWDBuffer){materials, 0, 0, 4, AWD_FORMAT_UINT, 0};
  camera.eye[1] = 0.5f;
  camera.eye[2] = 4;
  desc.camera = &camera;

  failed = awdNewDevice(NULL, &device) || awdNewScene(device, &scene) ||
           awdAddMaterial(scene, &grey, NULL) || awdAddMaterial(scene, &lamp, NULL) ||
           awdAddMesh(scene, &mesh, NULL) || awdCommitScene(scene) ||
           awdNewRender(scene, NULL, &desc, &render) || awdRenderPasses(render, NULL) ||
           awdNewFilmImage(render, &image) || awdWriteImageEXR(image, "lamp.exr");
  if (failed) fprintf(stderr, "%s\n", awdGetLastErrorMessage());

  awdReleaseImage(image);
  awdReleaseRender(render);
  awdReleaseScene(scene);
  awdReleaseDevice(device);
  return failed;
}
