/* SPDX-License-Identifier: Apache-2.0 */
#include "room.h"

static const float kVertices[12][3] = {
    {-1, -1, -1},     {1, -1, -1},     {1, -1, 1},       {-1, -1, 1}, /* of the floor */
    {-1, 1, -1},      {1, 1, -1},      {1, 1, 1},        {-1, 1, 1},  /* of the ceiling */
    {-0.2f, 0, 0.2f}, {0.2f, 0, 0.2f}, {0.2f, 0, -0.2f}, {-0.2f, 0, -0.2f}};

/* Fronts look into the room, that of the lamp upwards. */
static const uint32_t kTriangles[14][3] = {{3, 2, 1}, {3, 1, 0}, {4, 5, 6},  {4, 6, 7},  {0, 1, 5},
                                           {0, 5, 4}, {2, 3, 7}, {2, 7, 6},  {0, 4, 7},  {0, 7, 3},
                                           {1, 2, 6}, {1, 6, 5}, {8, 9, 10}, {8, 10, 11}};

static const uint32_t kMaterials[14] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 2, 2, 3, 3};

AWDResult makeRoom(AWDDevice device, AWDScene* scene) {
  static const float colours[4][2][3] = {{{0.7f, 0.7f, 0.7f}, {0, 0, 0}},
                                         {{0.7f, 0.2f, 0.1f}, {0, 0, 0}},
                                         {{0.1f, 0.3f, 0.7f}, {0, 0, 0}},
                                         {{0, 0, 0}, {30, 28, 24}}};
  AWDMeshDesc mesh = AWD_MESH_DESC_INIT;
  AWDResult result = awdNewScene(device, scene);
  int i, c;
  for (i = 0; i < 4 && result == AWD_SUCCESS; ++i) {
    AWDMaterialDesc material = AWD_MATERIAL_DESC_INIT;
    for (c = 0; c < 3; ++c) {
      material.albedo[c] = colours[i][0][c];
      material.emission[c] = colours[i][1][c];
    }
    result = awdAddMaterial(*scene, &material, NULL);
  }
  mesh.vertices = (AWDBuffer){kVertices, 0, 0, 12, AWD_FORMAT_FLOAT3, 0};
  mesh.indices = (AWDBuffer){kTriangles, 0, 0, 14, AWD_FORMAT_UINT3, 0};
  mesh.materials = (AWDBuffer){kMaterials, 0, 0, 14, AWD_FORMAT_UINT, 0};
  if (result == AWD_SUCCESS) result = awdAddMesh(*scene, &mesh, NULL);
  return result == AWD_SUCCESS ? awdCommitScene(*scene) : result;
}

AWDCamera viewOfRoom(uint32_t size) {
  AWDCamera camera = AWD_CAMERA_INIT;
  camera.eye[1] = -0.25f;
  camera.eye[2] = 0.95f;
  camera.tanHalfFovX = 0.8f;
  camera.width = camera.height = size;
  return camera;
}
