// SPDX-License-Identifier: Apache-2.0
// What the cases share: films in one call, and what must be true of them. In a closed furnace,
// where every wall of albedo a emits (1 - a) L, every radiance is L.
#pragma once

#include <string>
#include <vector>

#include "support/films.h"
#include "support/findings.h"
#include "support/scenes.h"

namespace awdtest {

struct NamedGuide {
  const char* name;
  AWDGuide guide;
};
constexpr NamedGuide kGuides[] = {
    {"adaptive", AWD_GUIDE_ADAPTIVE},
    {"cosine", AWD_GUIDE_COSINE},
    {"uniform", AWD_GUIDE_UNIFORM},
};
/// The two that are meant for closed rooms of high albedo.
constexpr NamedGuide kUsualGuides[] = {kGuides[0], kGuides[1]};

/// One for all cases.
AWDDevice sceneDevice();

struct RenderedFilm {
  Film film;
  AWDPassStatistics statistics;
};
RenderedFilm renderedFilm(AWDScene scene, const AWDRenderDesc& desc,
                          const std::vector<uint32_t>& passes, AWDField field = nullptr);

/// Inside the unit cube, looking into a corner.
AWDCamera furnaceCamera(uint32_t width, uint32_t height);

/// The unit cube, all of its walls alike.
SceneBuilder furnace(double albedo, double emission);

/// Every number of the film is finite and not negative, and no path was left out.
void expectUsable(Findings& found, const RenderedFilm& rendered, const std::string& name);

/// Of a furnace, whose pixels are independent and of one mean: that mean, and its standard error.
Estimate pixelMean(const Film& film);

/// The estimate is within 5 standard errors of the truth, false alarm 6e-7, and these are below
/// `share` of it. Returns how far it is off, as a share.
double expectMean(Findings& found, Estimate estimate, double truth, double share,
                  const std::string& name);

/// Share of the radiance of a rectangle of half sides a and b, at height h above a point and
/// parallel to its surface, that the point gets as irradiance over pi.
double rectangleAbove(double a, double b, double h);

}  // namespace awdtest
