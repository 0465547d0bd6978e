// SPDX-License-Identifier: Apache-2.0
#include "statistics_json.h"

#include "failure.h"

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

json renderStatistics(const Render& render) {
  AWDPassStatistics statistics = AWD_PASS_STATISTICS_INIT;
  uint32_t count = 0;
  check(awdGetPassCount(render.get(), &count));
  json passes = json::array();
  for (uint32_t i = 0; i < count; ++i) {
    check(awdGetPassStatistics(render.get(), i, &statistics));
    passes.push_back(toJson(statistics));
  }
  check(awdGetRenderStatistics(render.get(), &statistics));
  json all = {{"passes", passes}, {"total", toJson(statistics)}};
  if (statistics.samplesPerPixel < 2) return all;
  AWDRenderError error = AWD_RENDER_ERROR_INIT;
  check(awdGetRenderError(render.get(), &error));
  all["error"] = {{"relative", error.error}, {"lower", error.lower}, {"upper", error.upper}};
  return all;
}

json refitStatistics(const Field& field) {
  AWDFieldStatistics statistics = AWD_FIELD_STATISTICS_INIT;
  check(awdGetFieldStatistics(field.get(), &statistics));
  return {{"failed", statistics.refitFailed},
          {"limited", statistics.refitLimited},
          {"iterations", statistics.refitIterations}};
}

std::string toText(const json& value) {
  return value.dump(2, ' ', false, json::error_handler_t::replace) + '\n';
}

}  // namespace command
