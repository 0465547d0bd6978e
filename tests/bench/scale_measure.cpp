// SPDX-License-Identifier: Apache-2.0
#include "scale_measure.h"

#include <algorithm>

#include "support/handles.h"

namespace bench::scale {
namespace {

using awdtest::must;

/// One render.
struct Cost {
  double cpuSeconds, wallSeconds, rays, paths, patches, coefficients, bytes;
};
using CostFigure = double (*)(const Cost& cost);

double nsPerRay(const Cost& cost) { return 1e9 * cost.cpuSeconds / cost.rays; }
double nsPerPath(const Cost& cost) { return 1e9 * cost.cpuSeconds / cost.paths; }
double raysPerPath(const Cost& cost) { return cost.rays / cost.paths; }
double wallSeconds(const Cost& cost) { return cost.wallSeconds; }

std::optional<Cost> render(const Point& point, const Method& method, uint64_t seed) {
  Settings settings;
  settings.field.patchSamples = point.patchSamples;
  method.change(settings);
  settings.render.camera = &point.scene->camera;
  settings.render.seed = seed;
  settings.schedule.totalSamples = point.samples;
  awdtest::Field field;
  if (settings.render.guide == AWD_GUIDE_ADAPTIVE) {
    must(awdNewSceneField(point.scene->scene.get(), &settings.field, field.out()));
  }
  awdtest::Render render;
  must(awdNewRender(point.scene->scene.get(), field, &settings.render, render.out()));
  const AWDResult result = awdRenderPasses(render, &settings.schedule);
  if (result == AWD_ERROR_CANCELLED) return std::nullopt;
  must(result);
  AWDPassStatistics statistics = AWD_PASS_STATISTICS_INIT;
  must(awdGetRenderStatistics(render, &statistics));
  return Cost{statistics.cpuSeconds,
              statistics.wallSeconds,
              static_cast<double>(statistics.rays),
              static_cast<double>(statistics.samples),
              static_cast<double>(statistics.patches),
              static_cast<double>(statistics.coefficients),
              static_cast<double>(statistics.bytes)};
}

Spread spreadOf(const std::vector<Cost>& costs, CostFigure figure) {
  std::vector<double> values(costs.size());
  std::transform(costs.begin(), costs.end(), values.begin(), figure);
  return bench::spreadOf(values);
}

Spread ratioOf(const std::vector<Cost>& costs, const std::vector<Cost>& base, CostFigure figure) {
  std::vector<double> ratios(costs.size());
  std::transform(costs.begin(), costs.end(), base.begin(), ratios.begin(),
                 [&](const Cost& a, const Cost& b) { return figure(a) / figure(b); });
  return bench::spreadOf(ratios);
}

Row rowOf(const Point& point, const Method& method, const std::vector<Cost>& costs,
          const std::vector<Cost>& base) {
  const AWDSceneInfo& info = point.scene->info;
  const Cost& last = costs.back();
  Row row = {{"part", point.part},
             {"x", point.x},
             {"method", method.name},
             {"triangles", info.triangles},
             {"lights", info.lights},
             {"samples_per_pixel", point.samples},
             {"threads", point.threads},
             {"width", point.scene->camera.width},
             {"height", point.scene->camera.height},
             {"repetitions", costs.size()},
             {"patches", last.patches},
             {"coefficients", last.coefficients},
             {"bytes", last.bytes},
             {"scene_bytes", point.scene->bytes},
             {"commit_cpu_seconds", point.scene->commitSeconds}};
  setSpread(row, "ns_per_ray", spreadOf(costs, nsPerRay));
  setSpread(row, "ns_per_path", spreadOf(costs, nsPerPath));
  setSpread(row, "rays_per_path", spreadOf(costs, raysPerPath));
  setSpread(row, "wall_seconds", spreadOf(costs, wallSeconds));
  setSpread(row, "ray_cost_ratio", ratioOf(costs, base, nsPerRay));
  setSpread(row, "path_cost_ratio", ratioOf(costs, base, nsPerPath));
  return row;
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> all = {
      {"cosine", "unguided: by the cosine, roulette by albedo, lights by power",
       [](Settings& with) { with.render.guide = AWD_GUIDE_COSINE; }},
      {"guided, same paths", "guided, but roulette by albedo and lights by power: a guided ray",
       [](Settings& with) {
         with.render.roulette = AWD_ROULETTE_ALBEDO;
         with.render.lights = AWD_LIGHTS_POWER;
       }},
      {"guided", "guided, all defaults", [](Settings&) {}},
  };
  return all;
}

std::optional<std::vector<Row>> measure(const Point& point, int repetitions, Cancelled cancelled) {
  const std::size_t count = methods().size();
  std::vector<std::vector<Cost>> costs(count);
  // The methods of a repetition after each other, each first in its turn: what else the machine
  // does meets them alike.
  for (int r = 0; r < repetitions; ++r) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t m = (i + static_cast<std::size_t>(r)) % count;
      if (cancelled()) return std::nullopt;
      const auto cost = render(point, methods()[m], static_cast<uint64_t>(r) + 1);
      if (!cost) return std::nullopt;
      costs[m].push_back(*cost);
    }
  }
  std::vector<Row> rows;
  for (std::size_t m = 0; m < count; ++m) {
    rows.push_back(rowOf(point, methods()[m], costs[m], costs[0]));
  }
  return rows;
}

}  // namespace bench::scale
