/* SPDX-License-Identifier: Apache-2.0
 *
 * The scene: triangle meshes of diffuse materials, which may emit on one side.
 *
 * Upload, then awdCommitScene; queries and renders want a committed scene. A scene can be changed
 * and committed again once no render of it is at work.
 */
#ifndef AWD_SCENE_H
#define AWD_SCENE_H

#include "awd/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Makes an empty scene. Free. */
AWD_EXPORT AWDResult AWD_CALL awdNewScene(AWDDevice device, AWDScene* scene) AWD_NOEXCEPT;
/* One reference more, or less; NULL is allowed. Free. */
AWD_EXPORT void AWD_CALL awdRetainScene(AWDScene scene) AWD_NOEXCEPT;
AWD_EXPORT void AWD_CALL awdReleaseScene(AWDScene scene) AWD_NOEXCEPT;

/* A diffuse material: f_r = albedo / pi on both sides. */
typedef struct AWDMaterialDesc {
  size_t structSize;
  float albedo[3];   /* 0 to 1 */
  float emission[3]; /* radiance leaving the front side, finite, >= 0 */
} AWDMaterialDesc;

#ifdef __cplusplus
#define AWD_MATERIAL_DESC_INIT                                                                     \
  AWDMaterialDesc {                                                                                \
    sizeof(AWDMaterialDesc), {0.0f, 0.0f, 0.0f}, { 0.0f, 0.0f, 0.0f }                              \
  }
#else
#define AWD_MATERIAL_DESC_INIT                                                                     \
  {                                                                                                \
    sizeof(AWDMaterialDesc), {0.0f, 0.0f, 0.0f}, { 0.0f, 0.0f, 0.0f }                              \
  }
#endif

/* Adds a material; its number counts from 0. *material may be NULL. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdAddMaterial(AWDScene scene, const AWDMaterialDesc* desc,
                                             uint32_t* material) AWD_NOEXCEPT;

/* Flags of a mesh. */
enum {
  /* Don't copy the buffers now: awdCommitScene reads them, and they must live until then. */
  AWD_MESH_SHARED = 1u
};

/* Triangles. Buffers are copied, unless they are shared. */
typedef struct AWDMeshDesc {
  size_t structSize;
  AWDBuffer vertices;  /* FLOAT3; finite, below 1e18 in magnitude */
  AWDBuffer indices;   /* UINT3; counter-clockwise seen from the front */
  AWDBuffer materials; /* UINT, one a triangle; none: `material` for all */
  AWDBuffer patches;   /* UINT below 2^31 - 1, one a triangle; none: a patch per planar piece */
  uint32_t material;   /* used when there is no `materials` buffer */
  uint32_t flags;      /* AWD_MESH_SHARED or 0 */
} AWDMeshDesc;

#ifdef __cplusplus
#define AWD_MESH_DESC_INIT                                                                         \
  AWDMeshDesc {                                                                                    \
    sizeof(AWDMeshDesc), {nullptr, 0u, 0u, 0u, 0, 0u}, {nullptr, 0u, 0u, 0u, 0, 0u},               \
        {nullptr, 0u, 0u, 0u, 0, 0u}, {nullptr, 0u, 0u, 0u, 0, 0u}, 0u, 0u                         \
  }
#else
#define AWD_MESH_DESC_INIT                                                                         \
  {                                                                                                \
    sizeof(AWDMeshDesc), {NULL, 0u, 0u, 0u, 0, 0u}, {NULL, 0u, 0u, 0u, 0, 0u},                     \
        {NULL, 0u, 0u, 0u, 0, 0u}, {NULL, 0u, 0u, 0u, 0, 0u}, 0u, 0u                               \
  }
#endif

/* Adds a mesh; its number counts from 0. *mesh may be NULL. Contents are checked by commit.
   Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdAddMesh(AWDScene scene, const AWDMeshDesc* desc,
                                         uint32_t* mesh) AWD_NOEXCEPT;

/* Checks everything, finds planar pieces and lights, and builds the ray tracing structure.
   Triangles without area are skipped and counted; a scene without light is a warning in the log.
   A bad vertex, index, material or patch is an error that names it, and leaves the scene as it
   was before the call; so does AWD_ERROR_CANCELLED. Exclusive. */
AWD_EXPORT AWDResult AWD_CALL awdCommitScene(AWDScene scene) AWD_NOEXCEPT;

/* Figures of a scene. */
typedef struct AWDSceneInfo {
  size_t structSize;
  uint64_t triangles; /* uploaded */
  uint64_t skipped;   /* of these, without area */
  uint64_t lights;    /* coplanar connected emissive triangles of one material are one */
  uint64_t patches;   /* host's ids in use and planar pieces; each has two sides */
  uint32_t meshes;    /* added */
  uint32_t materials; /* added */
  float lower[3];     /* bounding box; 0 if there is no triangle */
  float upper[3];     /* likewise */
} AWDSceneInfo;

#ifdef __cplusplus
#define AWD_SCENE_INFO_INIT                                                                        \
  AWDSceneInfo {                                                                                   \
    sizeof(AWDSceneInfo), 0u, 0u, 0u, 0u, 0u, 0u, {0.0f, 0.0f, 0.0f}, { 0.0f, 0.0f, 0.0f }         \
  }
#else
#define AWD_SCENE_INFO_INIT                                                                        \
  {                                                                                                \
    sizeof(AWDSceneInfo), 0u, 0u, 0u, 0u, 0u, 0u, {0.0f, 0.0f, 0.0f}, { 0.0f, 0.0f, 0.0f }         \
  }
#endif

/* Figures of the committed scene; AWD_ERROR_INVALID_OPERATION if it is not. Free. */
AWD_EXPORT AWDResult AWD_CALL awdGetSceneInfo(AWDScene scene, AWDSceneInfo* info) AWD_NOEXCEPT;

/* --- queries ----------------------------------------------------------------------------------
   Of a scene as it was last committed; AWD_ERROR_INVALID_OPERATION if it never was. */

/* A ray o + t d, tnear <= t <= tfar; d need not be a unit vector, but neither it nor o may be
   beyond 1e18 times the size of the scene. This struct never grows. */
typedef struct AWDRay {
  float origin[3];    /* o */
  float tnear;        /* finite, not below 0 */
  float direction[3]; /* d */
  float tfar;         /* may be infinite */
} AWDRay;

/* What a ray meets first. This struct never grows. */
typedef struct AWDHit {
  float t;           /* infinite if nothing was hit */
  float normal[3];   /* geometric, unit, front side */
  float u;           /* barycentric: (1-u-v) p0 + u p1 + v p2 */
  float v;           /* likewise */
  uint32_t mesh;     /* AWD_INVALID_ID if nothing was hit */
  uint32_t triangle; /* of the mesh */
  uint32_t material; /* of the triangle */
  uint32_t patch;    /* with AWD_PATCH_BACK if met on the back side */
} AWDHit;

/* First hits of `count` rays. AWD_ERROR_INVALID_OPERATION before commit. Free, but not during it.
 */
AWD_EXPORT AWDResult AWD_CALL awdIntersect(AWDScene scene, const AWDRay* rays, size_t count,
                                           AWDHit* hits) AWD_NOEXCEPT;

/* Whether anything lies on each of `count` rays: 1 or 0. AWD_ERROR_INVALID_OPERATION before commit.
   Free, but not during it. */
AWD_EXPORT AWDResult AWD_CALL awdOccluded(AWDScene scene, const AWDRay* rays, size_t count,
                                          uint8_t* occluded) AWD_NOEXCEPT;

/* The patch of a triangle: front side, or back side if `back` is not 0. AWD_INVALID_ID for one
   without area. AWD_ERROR_INVALID_OPERATION before commit. Free, but not during it. */
AWD_EXPORT AWDResult AWD_CALL awdGetTrianglePatch(AWDScene scene, uint32_t mesh, uint32_t triangle,
                                                  int32_t back, uint32_t* patch) AWD_NOEXCEPT;

/* The patch of the triangle nearest to a point, on the side where the point is (front if it lies
   in the plane). AWD_INVALID_ID in an empty scene. AWD_ERROR_INVALID_OPERATION before commit.
   Free, but not during it. */
AWD_EXPORT AWDResult AWD_CALL awdGetPointPatch(AWDScene scene, const float point[3],
                                               uint32_t* patch) AWD_NOEXCEPT;

#ifdef __cplusplus
}
#endif
#endif
