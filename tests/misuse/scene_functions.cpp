// SPDX-License-Identifier: Apache-2.0
// How the functions of awd/scene.h are called.
#include "misuse/functions.h"

namespace awdmisuse {

namespace {

constexpr size_t kRays = 4;
constexpr size_t kOtherScene = 1;  // the first one stays as checkpoints know it

void spoilBuffer(Caller& c, AWDBuffer& buffer) {
  static const uint32_t kOdd[] = {0, 1, 2, UINT32_MAX, 1, 0, 0x7fffffffu, 5, 3, 0, 2, 4};
  static const float kWild[18] = {0, 1, 2, 1e30f, -1e17f, 0, 3e38f, 1, 0, 0, 0, 0, 1, 1, 1};
  // Nothing is read beyond these: 9 words at least.
  c.spoil(buffer.data, {nullptr, kOdd, kWild});
  c.spoil(buffer.byteOffset, {1, 4, SIZE_MAX, SIZE_MAX - 3});
  c.spoil(buffer.byteStride, {1, 4, SIZE_MAX, SIZE_MAX / 2});
  c.spoil(buffer.format);
  c.spoil(buffer.reserved);
  // Offset and stride that differ from the good ones go with few items, since buffers are small.
  if (buffer.byteOffset || buffer.byteStride || buffer.data == kOdd || buffer.data == kWild) {
    buffer.count = c.oneOf(2);
  } else {
    c.spoil(buffer.count, {0, 1, 2});
  }
}

const AWDMeshDesc* meshDesc(Caller& c) {
  return c.desc<AWDMeshDesc>(smallMesh(), [&](AWDMeshDesc& desc) {
    if (c.wild() && c.oneOf(2) == 0) {
      spoilBuffer(c, desc.vertices);
      spoilBuffer(c, desc.indices);
      spoilBuffer(c, desc.materials);
      spoilBuffer(c, desc.patches);
    }
    c.spoil(desc.material);
    c.spoil(desc.flags);
  });
}

AWDRay ray(Caller& c) {
  AWDRay made = {{0.5f, 0.25f, 1.0f}, 0.0f, {0.0f, 0.0f, -1.0f}, 10.0f};
  for (int i = 0; i < 3; ++i) {
    c.spoil(made.origin[i]);
    c.spoil(made.direction[i]);
  }
  c.spoil(made.tnear);
  c.spoil(made.tfar);
  return made;
}

}  // namespace

void addSceneFunctions(std::vector<Function>& all) {
  const auto add = [&](const char* name, std::function<void(Caller&)> call) {
    all.push_back({name, std::move(call), true});
  };
  add("awdNewScene", [](Caller& c) { c(awdNewScene, Args{c.device(), c.made<AWDScene>()}); });
  add("awdRetainScene", [](Caller& c) { c.retained(awdRetainScene); });
  add("awdReleaseScene", [](Caller& c) { c.released(awdReleaseScene); });
  add("awdAddMaterial", [](Caller& c) {
    const AWDScene scene = c.first(kOtherScene).scene();
    const AWDMaterialDesc* desc =
        c.desc<AWDMaterialDesc>(AWD_MATERIAL_DESC_INIT, [&](AWDMaterialDesc& material) {
          for (int i = 0; i < 3; ++i) {
            c.spoil(material.albedo[i]);
            c.spoil(material.emission[i]);
          }
        });
    c(awdAddMaterial, Args{scene, desc, c.out<uint32_t>(1, true)});
  });
  add("awdAddMesh", [](Caller& c) {
    c(awdAddMesh, Args{c.first(kOtherScene).scene(), meshDesc(c), c.out<uint32_t>(1, true)});
  });
  add("awdCommitScene", [](Caller& c) { c(awdCommitScene, Args{c.first(kOtherScene).scene()}); });
  add("awdGetSceneInfo", [](Caller& c) {
    c(awdGetSceneInfo, Args{c.scene(), c.outStruct<AWDSceneInfo>(AWD_SCENE_INFO_INIT)});
  });
  add("awdIntersect", [](Caller& c) {
    const AWDScene scene = c.scene();
    const size_t n = c.count(kRays);
    const AWDRay* rays = c.in<AWDRay>(n, [&] { return ray(c); });
    c(awdIntersect, Args{scene, rays, n, c.out<AWDHit>(n)});
  });
  add("awdOccluded", [](Caller& c) {
    const AWDScene scene = c.scene();
    const size_t n = c.count(kRays);
    const AWDRay* rays = c.in<AWDRay>(n, [&] { return ray(c); });
    c(awdOccluded, Args{scene, rays, n, c.out<uint8_t>(n)});
  });
  add("awdGetTrianglePatch", [](Caller& c) {
    c(awdGetTrianglePatch, Args{c.scene(), c.number<uint32_t>(0), c.number<uint32_t>(2),
                                c.number<int32_t>(1), c.out<uint32_t>(1)});
  });
  add("awdGetPointPatch", [](Caller& c) {
    c(awdGetPointPatch, Args{c.scene(), c.places(1), c.out<uint32_t>(1)});
  });
}

}  // namespace awdmisuse
