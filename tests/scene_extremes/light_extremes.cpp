// SPDX-License-Identifier: Apache-2.0
// Lights far brighter than what is about them, and what is narrow: lamps, slits, cracks.
#include <algorithm>

#include "scene_extremes/extremes.h"
#include "scene_extremes/furnace.h"

namespace awdtest {

namespace {

constexpr float kBright = 1e12f;
constexpr double kNarrow = 0x1p-20;

/// A furnace of radiance 2, in it a closed box that is a furnace to it as well, and in that another
/// whose walls shine inwards, 10^12 times as bright.
Outcome enclosedLight() {
  Findings found;
  double worst = 0.0;
  SceneBuilder builder;
  const uint32_t wall = builder.material(grey(0.5), grey(1.0));
  builder.box({0, 0, 0}, {1, 1, 1}, true, {wall});
  builder.box({0.5, 0.0625, 0.5}, {0.75, 0.25, 0.75}, false, {wall});
  builder.box({0.5625, 0.125, 0.5625}, {0.6875, 0.1875, 0.6875}, true,
              {builder.material(grey(0.5), grey(kBright))});
  const Scene scene = builder.commit(sceneDevice());
  const AWDCamera view = furnaceCamera(32, 32);
  for (const NamedGuide& guide : kUsualGuides) {
    const RenderedFilm rendered =
        renderedFilm(scene, renderDesc(view, guide.guide, 1), {8, 16, 40});
    expectUsable(found, rendered, guide.name);
    const float most =
        *std::max_element(rendered.film.radiance.begin(), rendered.film.radiance.end());
    found.expect(most < 1e3f, "%s: a pixel of %g", guide.name, most);
    worst = std::max(worst, expectMean(found, pixelMean(rendered.film), 2.0, 5e-3, guide.name));
  }
  return found.outcome("mean right to %.2g", worst);
}

/// Rays start on both sides of every edge of a closed box, and none gets out.
Outcome crack() {
  Findings found;
  SceneBuilder builder;
  builder.box({-1, -1, -1}, {2, 2, 2}, true, {builder.material(grey(0.5), grey(kBright))});
  builder.box({0, 0, 0}, {1, 1, 1}, true, {builder.material(grey(0.5))}, 32);
  const Scene scene = builder.commit(sceneDevice());
  const AWDCamera view = furnaceCamera(64, 64);
  for (const NamedGuide& guide : kGuides) {
    const RenderedFilm rendered = renderedFilm(scene, renderDesc(view, guide.guide, 2), {8, 8, 16});
    expectUsable(found, rendered, guide.name);
    const size_t lit = static_cast<size_t>(std::count_if(rendered.film.radiance.begin(),
                                                         rendered.film.radiance.end(),
                                                         [](float value) { return value > 0.0f; }));
    found.expect(lit == 0, "%s: %zu values are lit", guide.name, lit);
  }
  return found.outcome("black");
}

/// A lamp of half sides a and b one unit above a floor that glows with 1 itself, seen where it is
/// brightest: what comes of the lamp is known, and that of the floor.
Outcome lampAboveFloor(double a, double b, double emission) {
  constexpr double kAlbedo = 0.5;
  Findings found;
  double worst = 0.0;
  SceneBuilder builder;
  const uint32_t lamp = builder.material(grey(0.0), grey(emission));
  builder.quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0},
               builder.material(grey(kAlbedo), grey(1.0)));
  builder.quad({-a, -b, 1}, {-a, b, 1}, {a, b, 1}, {a, -b, 1}, lamp);
  const Scene scene = builder.commit(sceneDevice());
  const AWDCamera view = camera({0, -1, 0.5}, {0, 0, 0}, {0, 0, 1}, 1e-3, 16, 16);
  const double truth = 1.0 + kAlbedo * emission * rectangleAbove(a, b, 1.0);
  for (const NamedGuide& guide : kGuides) {
    const RenderedFilm rendered =
        renderedFilm(scene, renderDesc(view, guide.guide, 3), {16, 32, 80});
    expectUsable(found, rendered, guide.name);
    worst = std::max(worst, expectMean(found, pixelMean(rendered.film), truth, 4e-3, guide.name));
  }
  return found.outcome("%.6g right to %.2g", truth, worst);
}

Outcome tinyLamp() { return lampAboveFloor(5e-7, 5e-7, kBright); }
Outcome stripLamp() { return lampAboveFloor(0.5, 0.5 * kNarrow, 1e6); }

/// Seen through: pixels of half the slit's width.
Outcome slit() {
  Findings found;
  SceneBuilder builder;
  const uint32_t wall = builder.material(grey(0.5)),
                 lamp = builder.material(grey(0.0), grey(kBright));
  builder.quad({-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 1, 0}, wall);
  const double end = 1.0 + kNarrow;
  builder.quad({kNarrow, -1, 0}, {end, -1, 0}, {end, 1, 0}, {kNarrow, 1, 0}, wall);
  builder.quad({-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, lamp);
  const Scene scene = builder.commit(sceneDevice());
  const double middle = 0.5 * kNarrow;
  const AWDCamera view = camera({middle, 0, 1}, {middle, 0, 0}, {0, 1, 0}, 1.25 * kNarrow, 5, 1);
  for (const NamedGuide& guide : kGuides) {
    const RenderedFilm rendered =
        renderedFilm(scene, renderDesc(view, guide.guide, 4), {16, 16, 32});
    expectUsable(found, rendered, guide.name);
    for (const uint32_t x : {0u, 2u, 4u}) {
      const float seen = rendered.film.radiance[size_t{3} * x];
      found.expect(seen == (x == 2 ? kBright : 0.0f), "%s: pixel %u is %g", guide.name, x, seen);
    }
  }
  return found.outcome("0, 1e12, 0");
}

/// Two furnaces that don't see each other, of radiances 2 and 2e12; the camera is in the dim one.
Outcome dimFurnace() {
  Findings found;
  double worst = 0.0;
  SceneBuilder builder;
  builder.box({0, 0, 0}, {1, 1, 1}, true, {builder.material(grey(0.5), grey(1.0))}, 2);
  builder.box({2, 0, 0}, {3, 1, 1}, true, {builder.material(grey(0.5), grey(kBright))}, 2);
  const Scene scene = builder.commit(sceneDevice());
  const AWDCamera dim = furnaceCamera(32, 32);
  AWDCamera bright = dim;
  bright.eye[0] += 2.0f;
  for (const NamedGuide& guide : kUsualGuides) {
    for (const bool inDim : {true, false}) {
      const RenderedFilm rendered =
          renderedFilm(scene, renderDesc(inDim ? dim : bright, guide.guide, 5), {8, 16, 40});
      expectUsable(found, rendered, guide.name);
      worst = std::max(worst, expectMean(found, pixelMean(rendered.film),
                                         inDim ? 2.0 : 2.0 * double{kBright}, 5e-3, guide.name));
    }
  }
  return found.outcome("means right to %.2g", worst);
}

}  // namespace

std::vector<Extreme> lightExtremes() {
  return {
      {"a light 10^12 as bright, shut in", "none of it gets out: e / (1 - albedo)", enclosedLight},
      {"a room beside one 10^12 as bright", "e / (1 - albedo) in both", dimFurnace},
      {"a closed box of 6144 panels in the light", "black", crack},
      {"a lamp of area 1e-12, 10^12 as bright", "the rectangle's form factor", tinyLamp},
      {"a lamp of width 1e-6", "the rectangle's form factor", stripLamp},
      {"a slit of width 1e-6 before a bright lamp", "the lamp in it, black beside it", slit},
  };
}

}  // namespace awdtest
