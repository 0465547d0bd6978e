// SPDX-License-Identifier: Apache-2.0
#include "guide_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace bench::guide {
namespace {

using SceneFiles = std::map<std::string, std::string>;

[[noreturn]] void failUnknown(const std::string& name, const SceneFiles& all) {
  std::string message = "no scene " + name + "; there are";
  for (const auto& [other, file] : all) message.append(" ").append(other);
  throw std::runtime_error(message);
}

class Comparison {
 public:
  Comparison(const Options& options, const std::vector<Contender>& contenders, Report& report,
             Cancelled cancelled)
      : options_(options),
        contenders_(contenders),
        report_(report),
        cancelled_(cancelled),
        device_(newRenderDevice(options.threads, cancelled)) {}

  /// False: cancelled.
  bool measure(const std::string& name, const std::string& file) {
    const std::optional<LoadedScene> scene = loadChosen(device_, options_, name, file);
    if (!scene) return !cancelled_();
    const LoadedScene& loaded = *scene;
    report_.begin(loaded);
    return std::all_of(options_.samples.begin(), options_.samples.end(),
                       [&](uint32_t samples) { return measure(loaded, samples); });
  }

 private:
  bool measure(const LoadedScene& loaded, uint32_t samples) {
    std::vector<std::vector<Shot>> shots(contenders_.size());
    const auto report = [&](std::size_t i) {
      report_.add(samples, contenders_[i].name, shots[i], i == 0 ? nullptr : shots.data());
    };
    bool complete = true;
    // The methods of a seed after each other: what else the machine does meets them alike.
    for (int seed = 1; seed <= options_.seeds && complete; ++seed) {
      for (std::size_t i = 0; i < contenders_.size() && complete; ++i) {
        Shot shot = {};
        complete = !cancelled_() && contenders_[i].shoot(device_, loaded, samples,
                                                         static_cast<uint64_t>(seed), shot);
        if (complete) shots[i].push_back(shot);
        if (complete && seed == options_.seeds) report(i);
      }
    }
    for (std::size_t i = 0; i < contenders_.size() && !complete; ++i) {
      if (!shots[i].empty() && shots[i].size() < static_cast<std::size_t>(options_.seeds)) {
        report(i);
      }
    }
    if (complete && samples == options_.samples.back()) {
      complete = shootInEqualTime(loaded, samples, shots);
    }
    report_.write(false);
    return complete;
  }

  /// The baseline again, with the number of samples that takes it as long as the first method that
  /// it is compared with: for the eye, the errors being known at every time. False: cancelled.
  bool shootInEqualTime(const LoadedScene& loaded, uint32_t samples,
                        const std::vector<std::vector<Shot>>& shots) {
    if (shots.size() < 2 || shots[0].front().image.values.empty()) return true;
    const double ratio = shots[1].front().cpuSeconds / shots[0].front().cpuSeconds;
    const double wanted = std::clamp(std::round(samples * ratio), 1.0, 1e6);
    Shot shot = {};
    const auto count = static_cast<uint32_t>(wanted);
    if (!contenders_[0].shoot(device_, loaded, count, 1, shot)) return false;
    report_.showBaseline(count, contenders_[0].name, shot);
    return true;
  }

  const Options& options_;
  const std::vector<Contender>& contenders_;
  Report& report_;
  Cancelled cancelled_;
  awd::Device device_;
};

}  // namespace

SceneFiles chosenScenes(const Options& options) {
  SceneFiles all = sceneFiles(options.moreScenes);
  if (options.only.empty()) return all;
  SceneFiles chosen;
  for (const std::string& name : options.only) {
    const auto found = all.find(name);
    if (found == all.end()) failUnknown(name, all);
    chosen.insert(*found);
  }
  return chosen;
}

std::optional<LoadedScene> loadChosen(const awd::Device& device, const Options& options,
                                      const std::string& name, const std::string& file) {
  std::optional<Reference> reference;
  if (!options.references.empty()) {
    reference = averageReference(device.get(), options.references, name);
    if (!reference) {
      std::fprintf(stderr, "%s is left out: no %s/%s-*.exr\n", name.c_str(),
                   options.references.c_str(), name.c_str());
      return std::nullopt;
    }
  }
  LoadedScene loaded =
      loadScene(device, name, file, reference ? reference->mean.width : options.width);
  if (!reference) {
    if (!takeReference(device, options.folder, options.referenceSamples, loaded)) {
      return std::nullopt;
    }
  } else if (reference->mean.height != loaded.camera.height) {
    throw std::runtime_error("the reference of " + name + " is not of its camera's aspect");
  } else {
    loaded.reference = std::move(*reference);
  }
  return loaded;
}

bool measureScenes(const Options& options, const std::vector<Contender>& contenders, Report& report,
                   Cancelled cancelled) {
  Comparison comparison(options, contenders, report, cancelled);
  for (const auto& [name, file] : chosenScenes(options)) {
    if (!comparison.measure(name, file)) return false;
  }
  return true;
}

}  // namespace bench::guide
