// SPDX-License-Identifier: Apache-2.0
#include "statistics_json.h"

namespace command {

using nlohmann::json;

json toJson(const AWDPassStatistics& statistics) {
  return {{"cpu_seconds", statistics.cpuSeconds},
          {"wall_seconds", statistics.wallSeconds},
          {"rays", statistics.rays},
          {"shadow_rays", statistics.shadowRays},
          {"samples", statistics.samples},
          {"samples_per_pixel", statistics.samplesPerPixel},
          {"coefficients", statistics.coefficients},
          {"patches", statistics.patches},
          {"bytes", statistics.bytes},
          {"rejected_samples", statistics.rejectedSamples}};
}

json renderStatistics(awd::Render& render) {
  json passes = json::array();
  const uint32_t count = render.passCount();
  for (uint32_t i = 0; i < count; ++i) passes.push_back(toJson(render.passStatistics(i)));
  const AWDPassStatistics total = render.statistics();
  json all = {{"passes", passes}, {"total", toJson(total)}};
  if (total.samplesPerPixel < 2) return all;
  const AWDRenderError error = render.error();
  all["error"] = {{"relative", error.error}, {"lower", error.lower}, {"upper", error.upper}};
  return all;
}

json refitStatistics(awd::Field& field) {
  const AWDFieldStatistics statistics = field.statistics();
  return {{"failed", statistics.refitFailed},
          {"limited", statistics.refitLimited},
          {"iterations", statistics.refitIterations}};
}

std::string toText(const json& value) {
  return value.dump(2, ' ', false, json::error_handler_t::replace) + '\n';
}

}  // namespace command
