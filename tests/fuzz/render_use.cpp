// SPDX-License-Identifier: Apache-2.0
#include "render_use.h"

#include <cmath>
#include <vector>

#include "require.h"

namespace fuzz {

void lookAt(AWDRender render) {
  uint32_t width = 0, height = 0, passes = 0;
  uint64_t samples = 0;
  require(awdGetFilmInfo(render, &width, &height, &samples) == AWD_SUCCESS, "no film");
  std::vector<float> pixels(size_t{3} * width * height);
  for (const AWDFilmLayer layer : {AWD_FILM_RADIANCE, AWD_FILM_VARIANCE}) {
    require(awdReadFilm(render, layer, pixels.data(), 0, 0) == AWD_SUCCESS, "no layer");
    for (const float pixel : pixels)
      require(!std::isnan(pixel) && pixel >= 0.0f, "a pixel is none");
  }
  AWDRenderError error = AWD_RENDER_ERROR_INIT;
  if (oneOf(awdGetRenderError(render, &error), {AWD_ERROR_INVALID_OPERATION}, "error")) {
    require(!std::isnan(error.error) && !std::isnan(error.lower) && !std::isnan(error.upper),
            "an error is NaN");
  }
  AWDPassStatistics figures = AWD_PASS_STATISTICS_INIT;
  require(awdGetPassCount(render, &passes) == AWD_SUCCESS, "no count");
  for (uint32_t pass = 0; pass < passes; ++pass) {
    require(awdGetPassStatistics(render, pass, &figures) == AWD_SUCCESS, "no figures");
  }
  require(awdGetRenderStatistics(render, &figures) == AWD_SUCCESS, "no figures");
  uint32_t patch = 0;
  require(awdGetPixelPatch(render, width - 1, height - 1, &patch) == AWD_SUCCESS, "no patch");
}

}  // namespace fuzz
