// SPDX-License-Identifier: Apache-2.0
// As few pixels as there can be; many lights and patches.
#include <algorithm>

#include "scene_extremes/extremes.h"
#include "scene_extremes/furnace.h"

namespace awdtest {

namespace {

Outcome onePixel() {
  constexpr uint32_t kFilms = 64;
  Findings found;
  double worst = 0.0;
  const Scene scene = furnace(0.5, 1.0).commit(sceneDevice());
  const AWDCamera view = furnaceCamera(1, 1);
  for (const NamedGuide& guide : kGuides) {
    Film all;
    for (uint32_t seed = 1; seed <= kFilms; ++seed) {
      const RenderedFilm rendered =
          renderedFilm(scene, renderDesc(view, guide.guide, seed), {50, 150, 400});
      expectUsable(found, rendered, guide.name);
      all.radiance.insert(all.radiance.end(), rendered.film.radiance.begin(),
                          rendered.film.radiance.end());
    }
    worst = std::max(worst, expectMean(found, pixelMean(all), 2.0, 3e-3, guide.name));
  }
  return found.outcome("mean of %u films right to %.2g", kFilms, worst);
}

Outcome lineOfPixels() {
  Findings found;
  double worst = 0.0;
  const Scene scene = furnace(0.5, 1.0).commit(sceneDevice());
  for (const bool wide : {true, false}) {
    // Pixels are square: a column needs a narrow camera, a row has a low one anyway.
    AWDCamera view = furnaceCamera(wide ? 65536 : 1, wide ? 1 : 65536);
    if (!wide) view.tanHalfFovX = 1e-5f;
    for (const NamedGuide& guide : kUsualGuides) {
      const RenderedFilm rendered =
          renderedFilm(scene, renderDesc(view, guide.guide, 1), {1, 1, 1});
      expectUsable(found, rendered, guide.name);
      worst = std::max(worst, expectMean(found, pixelMean(rendered.film), 2.0, 5e-3, guide.name));
    }
  }
  for (const uint32_t bad : {0u, 65537u}) {
    const AWDCamera view = furnaceCamera(bad, 1);
    const AWDRenderDesc desc = renderDesc(view, AWD_GUIDE_COSINE, 1);
    Render render;
    const AWDResult result = awdNewRender(scene, nullptr, &desc, render.out());
    found.expect(result == AWD_ERROR_INVALID_ARGUMENT, "width %u: %s", bad,
                 awdGetResultString(result));
  }
  return found.outcome("mean right to %.2g", worst);
}

/// Four albedos in turn with the emission that keeps the radiance 2: panels that touch differ, and
/// each is a light.
Outcome manyLights() {
  constexpr uint32_t kPanels = 131;
  Findings found;
  double worst = 0.0;
  SceneBuilder builder;
  std::vector<uint32_t> materials;
  for (const double albedo : {0.5, 0.2, 0.8, 0.65}) {
    materials.push_back(builder.material(grey(albedo), grey(2.0 * (1.0 - albedo))));
  }
  builder.box({0, 0, 0}, {1, 1, 1}, true, materials, kPanels);
  const Scene scene = builder.commit(sceneDevice());
  AWDSceneInfo info = AWD_SCENE_INFO_INIT;
  must(awdGetSceneInfo(scene, &info));
  found.expect(info.lights == 6 * kPanels * kPanels, "%llu lights",
               static_cast<unsigned long long>(info.lights));
  const AWDCamera view = furnaceCamera(32, 32);
  for (const NamedGuide& guide : kUsualGuides) {
    const RenderedFilm rendered =
        renderedFilm(scene, renderDesc(view, guide.guide, 2), {8, 16, 40});
    expectUsable(found, rendered, guide.name);
    worst = std::max(worst, expectMean(found, pixelMean(rendered.film), 2.0, 5e-3, guide.name));
  }
  return found.outcome("%llu lights, mean right to %.2g",
                       static_cast<unsigned long long>(info.lights), worst);
}

/// One patch for all walls, of 4096 x 4096 cells, most of which no sample meets.
Outcome finestLevel() {
  Findings found;
  SceneBuilder builder = furnace(0.5, 1.0);
  const std::vector<uint32_t> patches(builder.mesh().indices.count, 0);
  AWDMeshDesc mesh = builder.mesh();
  mesh.patches = bufferOf(patches, AWD_FORMAT_UINT, 1);
  Scene scene;
  must(awdNewScene(sceneDevice(), scene.out()));
  const AWDMaterialDesc material = {sizeof material, {0.5f, 0.5f, 0.5f}, {1.0f, 1.0f, 1.0f}};
  must(awdAddMaterial(scene, &material, nullptr));
  must(awdAddMesh(scene, &mesh, nullptr));
  must(awdCommitScene(scene));
  const AWDCamera view = furnaceCamera(64, 64);
  double worst = 0.0, most = 0.0;
  for (const char* basis : {"haar", "linear-bspline"}) {
    AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
    desc.patches = AWD_PATCHES_HOST;
    desc.basis = basis;
    desc.startLevel = desc.maxLevel = AWD_LEVEL(12);
    Field field;
    must(awdNewSceneField(scene, &desc, field.out()));
    const RenderedFilm rendered =
        renderedFilm(scene, renderDesc(view, AWD_GUIDE_ADAPTIVE, 4), {8, 24}, field);
    expectUsable(found, rendered, basis);
    worst = std::max(worst, expectMean(found, pixelMean(rendered.film), 2.0, 1e-2, basis));
    most = std::max(most, static_cast<double>(rendered.statistics.bytes) * 1e-6);
    found.expect(rendered.statistics.coefficients >= uint64_t{1} << 24, "%s: %llu coefficients",
                 basis, static_cast<unsigned long long>(rendered.statistics.coefficients));
    desc.startLevel = desc.maxLevel = AWD_LEVEL(13);
    const AWDResult result = awdNewSceneField(scene, &desc, field.out());
    found.expect(result == AWD_ERROR_INVALID_ARGUMENT, "%s, level 13: %s", basis,
                 awdGetResultString(result));
  }
  return found.outcome("mean right to %.2g, %.3g MB at most", worst, most);
}

/// A patch a triangle, as many as a million, of which paths meet many.
Outcome manyPatches() {
  constexpr uint32_t kPanels = 289;
  Findings found;
  SceneBuilder builder = {};
  builder.box({0, 0, 0}, {1, 1, 1}, true, {builder.material(grey(0.5), grey(1.0))}, kPanels);
  AWDMeshDesc mesh = builder.mesh();
  std::vector<uint32_t> patches(mesh.indices.count);
  for (size_t i = 0; i < patches.size(); ++i) patches[i] = static_cast<uint32_t>(i);
  mesh.patches = bufferOf(patches, AWD_FORMAT_UINT, 1);
  Scene scene;
  must(awdNewScene(sceneDevice(), scene.out()));
  const AWDMaterialDesc material = {sizeof material, {0.5f, 0.5f, 0.5f}, {1.0f, 1.0f, 1.0f}};
  must(awdAddMaterial(scene, &material, nullptr));
  must(awdAddMesh(scene, &mesh, nullptr));
  must(awdCommitScene(scene));
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.patches = AWD_PATCHES_HOST;
  desc.startLevel = desc.maxLevel = AWD_LEVEL(0);
  Field field;
  must(awdNewSceneField(scene, &desc, field.out()));
  const AWDCamera view = furnaceCamera(128, 128);
  const RenderedFilm rendered =
      renderedFilm(scene, renderDesc(view, AWD_GUIDE_ADAPTIVE, 3), {8, 8, 16}, field);
  expectUsable(found, rendered, "adaptive");
  AWDSceneInfo info = AWD_SCENE_INFO_INIT;
  must(awdGetSceneInfo(scene, &info));
  found.expect(info.patches == patches.size(), "%llu patches",
               static_cast<unsigned long long>(info.patches));
  found.expect(rendered.statistics.patches > patches.size() / 4, "%llu have had a sample",
               static_cast<unsigned long long>(rendered.statistics.patches));
  const double off = expectMean(found, pixelMean(rendered.film), 2.0, 5e-3, "adaptive");
  return found.outcome("%llu of %llu patches learned, %.3g MB, mean right to %.2g",
                       static_cast<unsigned long long>(rendered.statistics.patches),
                       static_cast<unsigned long long>(info.patches),
                       static_cast<double>(rendered.statistics.bytes) * 1e-6, off);
}

}  // namespace

std::vector<Extreme> countExtremes() {
  return {
      {"an image of one pixel", "e / (1 - albedo)", onePixel},
      {"images of 65536 x 1 and 1 x 65536", "e / (1 - albedo); 0 and 65537 refused", lineOfPixels},
      {"10^5 lights", "each is found; e / (1 - albedo)", manyLights},
      {"10^6 patches", "a quarter learns at least; e / (1 - albedo)", manyPatches, true},
      {"a patch of level 12", "e / (1 - albedo); level 13 refused", finestLevel, true},
  };
}

}  // namespace awdtest
