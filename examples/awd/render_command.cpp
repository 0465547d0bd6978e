// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <sstream>
#include <vector>

#include "camera_choice.h"
#include "commands.h"
#include "console.h"
#include "device.h"
#include "failure.h"
#include "interrupt.h"
#include "progress_bar.h"
#include "render_options.h"
#include "scene_loader.h"
#include "statistics_json.h"
#include "upload.h"
#include "write_file.h"

namespace command {
namespace {

using nlohmann::json;

/// Every file that the run will write, looked at before an hour of work goes into them.
void checkOutputs(const RenderOptions& options) {
  std::vector<NamedFile> outputs = {{"--output", options.output}};
  if (options.json) outputs.push_back({"--json", *options.json});
  if (options.fieldOut) outputs.push_back({"--save-field", *options.fieldOut});
  if (options.checkpoint) outputs.push_back({"--checkpoint", *options.checkpoint});
  for (const PdfRequest& pdf : options.pdfs) outputs.push_back({"--pdf", pdf.file()});
  for (const NamedFile& output : outputs) checkWritable(output.path);

  std::vector<NamedFile> inputs = {{"the scene", options.scene}};
  if (options.camera) inputs.push_back({"--camera", *options.camera});
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (const NamedFile& input : inputs) checkApart(outputs[i], input);
    for (std::size_t k = i + 1; k < outputs.size(); ++k) checkApart(outputs[i], outputs[k]);
    // A field may be taken further in its own file.
    if (options.fieldIn && outputs[i].what != std::string("--save-field")) {
      checkApart(outputs[i], {"--field", *options.fieldIn});
    }
  }
}

/// None unless the render is adaptive. scene: empty before it is loaded.
awd::Field makeField(const awd::Device& device, const RenderOptions& options,
                     const awd::Scene& scene) {
  if (!options.isAdaptive()) return {};
  if (options.fieldIn) return awd::Field::read(device, *options.fieldIn);
  awd::FieldDesc desc;
  desc.preset = options.presetValue();
  desc.basis = options.basis ? options.basis->c_str() : nullptr;
  if (options.level) desc.maxLevel = AWD_LEVEL(*options.level);
  desc.estimator = options.estimatorValue();
  desc.refitSolver = options.refitSolver ? options.refitSolver->c_str() : nullptr;
  return scene ? awd::Field::create(scene, desc) : awd::Field::create(device, desc);
}

/// Of MiB; at least 1, since 0 is no limit.
uint64_t bytesOf(double mebibytes) {
  return static_cast<uint64_t>(std::clamp(std::ceil(mebibytes * 1048576.0), 1.0, 0x1p62));
}

/// From the checkpoint if there is one; `field` is then that of the render.
awd::Render makeRender(const awd::Scene& scene, awd::Field& field, const AWDCamera& camera,
                       const RenderOptions& options) {
  awd::RenderDesc desc(camera);
  desc.preset = options.presetValue();
  desc.guide = options.guideValue();
  desc.shadowRays = options.shadowRays;
  desc.points = options.pointsValue();
  desc.direct = options.directValue();
  desc.lights = options.lightsValue();
  desc.maxSplit = options.maxSplit;
  desc.maxBytes = options.memory ? bytesOf(*options.memory) : 0;
  desc.seed = options.seed;
  if (!options.checkpoint || !std::filesystem::exists(*options.checkpoint)) {
    return awd::Render::create(scene, desc, field);
  }
  const std::string& file = *options.checkpoint;
  awd::Render render = awd::Render::load(scene, file, field, desc);
  field = render.field();
  const uint32_t passes = render.passCount();
  note("going on from " + file + ", after " + std::to_string(passes) +
       (passes == 1 ? " pass" : " passes"));
  return render;
}

/// Whether the operation was done; false: it was cancelled.
template <class Operation>
bool finished(const std::string& what, Operation&& operation) {
  return named(what, [&] {
    try {
      operation();
      return true;
    } catch (const awd::Error& error) {
      if (error.code() != AWD_ERROR_CANCELLED) throw;
      return false;
    }
  });
}

/// A pass at a time, each of them saved.
void renderWithCheckpoints(awd::Render& render, awd::Schedule schedule, const std::string& file) {
  schedule.resume = 1;
  schedule.maxPasses = 1;
  for (uint32_t before = render.passCount();; ++before) {
    render.passes(schedule);
    if (render.passCount() == before) return;
    render.save(file);
  }
}

void renderPasses(awd::Render& render, const RenderOptions& options) {
  const Schedule& schedule = options.schedule;
  awd::Schedule desc;
  if (!schedule.samplesPerPass.empty()) desc.setPasses(schedule.samplesPerPass);
  desc.totalSamples = schedule.totalSamples;
  desc.seconds = schedule.seconds;
  desc.error = schedule.error;
  if (options.checkpoint) return renderWithCheckpoints(render, desc, *options.checkpoint);
  render.passes(desc);
}

std::string fileName(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

void writeImage(awd::Render& render, const RenderOptions& options, const std::string& commandLine) {
  awd::Image image = awd::Image::ofFilm(render);
  image.setMetadata("scene", fileName(options.scene));
  image.setMetadata("command", commandLine);
  image.writeEXR(options.output);
}

/// Name of the basis in use; null without one.
json basisName(const awd::Field& field) {
  if (!field) return nullptr;
  return field.patchInfo(0).basis;
}

std::string libraryVersion() {
  const uint32_t version = awd::version();
  return std::to_string(version / 10000) + '.' + std::to_string(version / 100 % 100) + '.' +
         std::to_string(version % 100);
}

void writeStatistics(awd::Render& render, awd::Field& field, const AWDCamera& camera,
                     const RenderOptions& options) {
  json statistics = renderStatistics(render);
  json spp = json::array();
  for (const json& pass : statistics["passes"]) spp.push_back(pass["samples_per_pixel"]);
  statistics["version"] = libraryVersion();
  statistics["settings"] = {
      {"scene", fileName(options.scene)},
      {"width", camera.width},
      {"height", camera.height},
      {"guide", options.guide},
      {"basis", basisName(field)},
      {"estimator", field && !options.fieldIn ? json(options.estimator) : json()},
      {"refit_solver", options.refitSolver ? json(*options.refitSolver) : json()},
      {"preset", options.preset},
      {"quality", options.quality ? json(*options.quality) : json()},
      {"seed", options.seed},
      {"spp", spp}};
  if (field && options.estimator == "refit") statistics["refit"] = refitStatistics(field);
  writeFile(*options.json, toText(statistics));
}

/// Where time or samples ran out before the film was as good as was asked for.
void tellBrokenPromise(awd::Render& render, const RenderOptions& options) {
  std::ostringstream promise;
  if (options.quality) {
    promise << "--quality " << *options.quality;
  } else {
    promise << "--error " << options.schedule.error;
  }
  const uint64_t count = render.filmInfo().samplesPerPixel;
  const std::string samples = std::to_string(count) + " samples a pixel";
  if (count < 2) {
    warn(promise.str() + " is not reached: of " + samples + " no error can be told");
    return;
  }
  const AWDRenderError error = render.error();
  if (error.upper <= options.schedule.error) return;
  std::ostringstream text;
  text << promise.str() << " is not reached: after " << samples << " the error may be "
       << error.upper << " of the mean radiance, not " << options.schedule.error;
  warn(text.str());
}

/// Whether it was done; else says why, so that others can be done after it.
template <class Operation>
bool attempt(Operation&& operation) {
  try {
    operation();
    return true;
  } catch (const std::bad_alloc&) {
    complain("out of memory");
  } catch (const std::exception& error) {
    complain(error.what());
  }
  return false;
}

/// Each output for itself: a disk that is full for one may have room for another.
bool writeAll(awd::Render& render, awd::Field& field, const AWDCamera& camera,
              const RenderOptions& options, const std::string& commandLine) {
  bool all = attempt([&] { writeImage(render, options, commandLine); });
  for (const PdfRequest& pdf : options.pdfs) all &= attempt([&] { pdf.write(render, field); });
  if (options.json) all &= attempt([&] { writeStatistics(render, field, camera, options); });
  if (options.fieldOut) {
    all &= attempt([&] {
      field.adapt();
      field.write(*options.fieldOut);
    });
  }
  return all;
}

int render(RenderOptions& options, const std::string& commandLine) {
  checkOutputs(options);
  ProgressBar bar;
  bar.setPassCount(options.schedule.samplesPerPass.size());
  const awd::Device device = openDevice(options.device, &bar);
  // An unknown basis, or a damaged field, shows before a long load.
  makeField(device, options, {});

  const SceneData data = loadScene(options.scene);
  AWDCamera camera = chooseCamera(options.camera, options.scene, data);
  resize(camera, options.width, options.height);
  awd::Scene scene = uploadScene(device, data, options.scene);
  catchInterrupt();
  if (!finished(options.scene, [&] { scene.commit(); })) {
    complain("interrupted before the first pass had ended: nothing is written");
    return kInterrupted;
  }

  awd::Field field = makeField(device, options, scene);
  awd::Render render = makeRender(scene, field, camera, options);
  for (PdfRequest& pdf : options.pdfs)
    pdf.resolve(scene, render, options.presetValue() != AWD_PRESET_PAPER);
  const uint32_t before = render.passCount();
  bool complete = false;
  const bool sound =
      attempt([&] { complete = finished(options.scene, [&] { renderPasses(render, options); }); });
  bar.letFinish();
  clearStatus();
  if (!complete) {
    const uint32_t passes = render.passCount();
    if (!sound && passes == before) return kFailed;
    complain(passes == 0 ? "interrupted before the first pass had ended: nothing is written"
                         : std::string(sound ? "interrupted" : "failed") +
                               ": only finished passes are written, " + std::to_string(passes));
    if (passes == 0) return kInterrupted;
  }
  if (complete && options.schedule.error > 0.0) tellBrokenPromise(render, options);
  if (!writeAll(render, field, camera, options, commandLine) || !sound) return kFailed;
  return complete ? kDone : kInterrupted;
}

}  // namespace

void addRenderCommand(CLI::App& program, Action& action, const std::string& commandLine) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = program.add_subcommand("render", "Render a scene file to an OpenEXR image");
  options->describe(*command);
  command->footer(
      "OBJ: Kd is the albedo, Ke the radiance that the front side emits. glTF: baseColorFactor, "
      "and\n"
      "emissiveFactor times emissiveStrength. Ctrl-C ends the run early; the passes finished by "
      "then\n"
      "are written.");
  command->callback([&action, options, commandLine] {
    options->finish();
    action = [options, commandLine] { return render(*options, commandLine); };
  });
}

}  // namespace command
