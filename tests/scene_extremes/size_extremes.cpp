// SPDX-License-Identifier: Apache-2.0
// Scenes of extreme size, and far from the origin.
#include <algorithm>

#include "scene_extremes/extremes.h"
#include "scene_extremes/furnace.h"

namespace awdtest {

namespace {

constexpr uint32_t kSize = 24;

RenderedFilm roomAt(double scale, Vec3 translation, AWDGuide guide,
                    const std::vector<uint32_t>& passes, uint64_t seed) {
  SceneBuilder room = lampRoom();
  room.scale(scale);
  room.translate(translation);
  const AWDCamera view = lampRoomCamera(kSize, scale, translation);
  return renderedFilm(room.commit(sceneDevice()), renderDesc(view, guide, seed), passes);
}

size_t valuesApart(const Film& a, const Film& b) {
  size_t apart = 0;
  for (size_t i = 0; i < a.radiance.size(); ++i) {
    apart += a.radiance[i] != b.radiance[i] || a.variance[i] != b.variance[i];
  }
  return apart;
}

Outcome scaled() {
  Findings found;
  for (const NamedGuide& guide : kGuides) {
    const RenderedFilm unit = roomAt(1.0, {}, guide.guide, {2, 2, 4}, 1);
    found.expect(imageMean(unit.film, 1).mean > 0.01, "%s: the room is black", guide.name);
    for (const double scale : {0x1p20, 0x1p-20, 0x1p56, 0x1p-100}) {
      const RenderedFilm film = roomAt(scale, {}, guide.guide, {2, 2, 4}, 1);
      expectUsable(found, film, guide.name);
      const size_t apart = valuesApart(unit.film, film.film);
      found.expect(apart == 0, "%s, times %g: %zu values differ", guide.name, scale, apart);
    }
  }
  return found.outcome("the same bits");
}

/// A triangle in each coordinate's turn beyond what is taken, then the scene as it was.
Outcome tooLarge() {
  Findings found;
  SceneBuilder good = furnace(0.5, 0.5);
  const Scene scene = good.commit(sceneDevice());
  for (const double far : {1.001e18, -1e30}) {
    SceneBuilder bad;
    bad.triangle({0, 0, 0}, {far, 0, 0}, {0, 1, 0}, 0);
    const AWDMeshDesc mesh = bad.mesh();
    must(awdAddMesh(scene, &mesh, nullptr));
    const AWDResult result = awdCommitScene(scene);
    found.expect(result == AWD_ERROR_INVALID_ARGUMENT, "%g: %s", far, awdGetResultString(result));
  }
  const AWDCamera view = furnaceCamera(kSize, kSize);
  const RenderedFilm rendered = renderedFilm(scene, renderDesc(view, AWD_GUIDE_COSINE, 1), {40});
  expectMean(found, pixelMean(rendered.film), 1.0, 0.01, "the scene afterwards");
  return found.outcome("AWD_ERROR_INVALID_ARGUMENT; the scene as before");
}

/// A floor of triangles of area 1e12, and a lamp above it of half that height as its side.
Scene vastFloor(double height) {
  constexpr double kHalf = 707107.0;
  const double a = 0.25 * height;
  SceneBuilder builder;
  builder.quad({-kHalf, -kHalf, 0}, {kHalf, -kHalf, 0}, {kHalf, kHalf, 0}, {-kHalf, kHalf, 0},
               builder.material(grey(0.5)));
  builder.quad({-a, -a, height}, {-a, a, height}, {a, a, height}, {a, -a, height},
               builder.material(grey(0.0), grey(100.0)));
  return builder.commit(sceneDevice());
}

RenderedFilm belowLamp(double height, const NamedGuide& guide) {
  const AWDCamera view =
      camera({0, -height, 0.5 * height}, {0, 0, 0}, {0, 0, 1}, 1e-3, kSize, kSize);
  return renderedFilm(vastFloor(height), renderDesc(view, guide.guide, 2), {8, 16, 40});
}

Outcome vastTriangles() {
  Findings found;
  double worst = 0.0;
  const double truth = 50.0 * rectangleAbove(0.25, 0.25, 1.0);
  for (const NamedGuide& guide : kGuides) {
    const RenderedFilm rendered = belowLamp(4096.0, guide);
    expectUsable(found, rendered, guide.name);
    worst = std::max(worst, expectMean(found, pixelMean(rendered.film), truth, 4e-3, guide.name));
  }
  return found.outcome("%.6g right to %.2g", truth, worst);
}

/// Rays leave a surface 2^-20 of the scene above it, here 1: where the lamp is as near as 16, rays
/// that meet it see it from there.
Outcome lowLamp() {
  constexpr double kHeight = 16.0, kLift = 1.0;
  Findings found;
  double most = 0.0;
  const double truth = 50.0 * rectangleAbove(4.0, 4.0, kHeight);
  const double lifted = 50.0 * rectangleAbove(4.0, 4.0, kHeight - kLift);
  for (const NamedGuide& guide : kGuides) {
    const RenderedFilm rendered = belowLamp(kHeight, guide);
    expectUsable(found, rendered, guide.name);
    const Estimate seen = pixelMean(rendered.film);
    found.expect(seen.mean > truth - 5.0 * seen.error && seen.mean < lifted + 5.0 * seen.error,
                 "%s: %g is not from %g to %g", guide.name, seen.mean, truth, lifted);
    most = std::max(most, seen.mean / truth - 1.0);
  }
  return found.outcome("%.2g too bright; the bound is %.2g", most, lifted / truth - 1.0);
}

/// All coordinates are integers and stay exact.
constexpr double kFarScale = 8.0;
constexpr Vec3 kFar = {1e7, -1e7, 1e7};

Outcome farAway() {
  Findings found;
  for (const NamedGuide& guide : {kGuides[1], kGuides[2]}) {
    const RenderedFilm near = roomAt(kFarScale, {}, guide.guide, {2, 2, 4}, 3);
    const RenderedFilm far = roomAt(kFarScale, kFar, guide.guide, {2, 2, 4}, 3);
    expectUsable(found, far, guide.name);
    const size_t apart = valuesApart(near.film, far.film);
    found.expect(apart == 0, "%s: %zu values differ", guide.name, apart);
  }
  return found.outcome("the same bits");
}

/// Null hypothesis: the means of all blocks and channels are the same; false alarm 1 %, with fixed
/// seeds. The patches may differ, since positions of the host's are coarse there.
Outcome farAwayGuided() {
  Findings found;
  const RenderedFilm near = roomAt(kFarScale, {}, AWD_GUIDE_ADAPTIVE, {8, 16, 40}, 4);
  const RenderedFilm far = roomAt(kFarScale, kFar, AWD_GUIDE_ADAPTIVE, {8, 16, 40}, 5);
  expectUsable(found, far, "far");
  const std::vector<double> scores = blockScores(near.film, far.film, 8);
  const double limit = familyThreshold(0.01, scores.size());
  found.expect(largest(scores) < limit, "|z| up to %.2f, limit %.2f", largest(scores), limit);
  const double near1 = imageMean(near.film, 1).error, far1 = imageMean(far.film, 1).error;
  found.expect(far1 < 1.5 * near1, "standard error %g, not %g", far1, near1);
  return found.outcome("|z| up to %.2f, limit %.2f; standard error %.2f of that near",
                       largest(scores), limit, far1 / near1);
}

}  // namespace

std::vector<Extreme> sizeExtremes() {
  return {
      {"sizes times 2^20, 2^-20, 2^56, 2^-100", "the same bits", scaled},
      {"coordinates beyond 1e18", "refused; the scene as it was", tooLarge},
      {"triangles of area 1e12", "the lamp's form factor", vastTriangles},
      {"a lamp 1e-5 of the scene above a floor", "off by less than a lift of 1e-6 of the scene",
       lowLamp},
      {"1e7 from the origin, unguided", "the same bits", farAway},
      {"1e7 from the origin, guided", "the same means, errors as near", farAwayGuided},
  };
}

}  // namespace awdtest
