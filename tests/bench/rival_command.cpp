// SPDX-License-Identifier: Apache-2.0
// awd-bench rival: a host that is not our renderer, guided by the library and by its peers.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>

#include "commands.h"
#include "guide_options.h"
#include "interrupt.h"
#include "rival_methods.h"

namespace bench {
namespace {

void list() {
  for (const rival::Method& method : rival::methods()) {
    std::printf("%-22s  %s\n", method.name.c_str(), method.what.c_str());
  }
}

bool shootHost(const rival::Method& method, host::Roulette roulette, const awd::Device& device,
               const LoadedScene& loaded, uint32_t samples, uint64_t seed, Shot& shot) {
  const host::Scene scene(loaded);
  const std::unique_ptr<host::Guide> guide = method.make(device.get(), scene);
  host::Picture picture;
  if (!host::render(scene, loaded.camera, guide.get(), roulette, samples, seed,
                    command::wasInterrupted, picture)) {
    return false;
  }
  const command::Metrics metrics =
      command::compareImages({loaded.camera.width, loaded.camera.height, std::move(picture.pixels)},
                             loaded.reference.mean, loaded.reference.variance);
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  shot = {metrics.relMse,
          metrics.relMseTrimmed,
          metrics.l1,
          picture.cpuSeconds,
          static_cast<double>(picture.rays),
          unknown,
          unknown,
          unknown};
  return true;
}

guide::Contender contender(const rival::Method& method, host::Roulette roulette) {
  return {method.name, [&method, roulette](const awd::Device& device, const LoadedScene& loaded,
                                           uint32_t samples, uint64_t seed, Shot& shot) {
            return shootHost(method, roulette, device, loaded, samples, seed, shot);
          }};
}

}  // namespace

void addRivalCommand(CLI::App& program, Action& action) {
  auto options = std::make_shared<guide::Options>();
  options->samples = {8, 32, 128};
  options->seeds = 3;
  auto roulette = std::make_shared<host::Roulette>(host::Roulette::kAdjoint);
  guide::Choice choice = {"rival",
                          {"cosine", "awd"},
                          list,
                          [roulette](const std::string& name) {
                            return contender(rival::methodNamed(name), *roulette);
                          },
                          ""};
  CLI::App* command = program.add_subcommand(
      "rival", "Efficiency of a small path tracer, guided by the library and by its peers");
  command
      ->add_option("--roulette", *roulette,
                   "How long guided paths live: by the radiance still to come as the host has\n"
                   "seen it (adjoint, the default), or by albedo, as unguided ones")
      ->transform(CLI::CheckedTransformer(std::map<std::string, host::Roulette>{
          {"adjoint", host::Roulette::kAdjoint}, {"albedo", host::Roulette::kAlbedo}}));
#ifdef AWD_BENCH_OPENPGL
  choice.methods.emplace_back("openpgl");
#else
  choice.note = "Built without Open PGL: there is no method openpgl";
#endif
  guide::addOptions(*command, action, std::move(choice), options);
}

}  // namespace bench
