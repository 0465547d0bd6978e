// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <sstream>

#include "awd_handles.hpp"
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
  checkWritable(options.output);
  if (options.json) checkWritable(*options.json);
  if (options.fieldOut) checkWritable(*options.fieldOut);
  if (options.checkpoint) checkWritable(*options.checkpoint);
  for (const PdfRequest& pdf : options.pdfs) checkWritable(pdf.file());
}

/// None unless the render is adaptive. scene: null before it is loaded.
Field makeField(const Device& device, const RenderOptions& options, AWDScene scene) {
  Field field;
  if (!options.isAdaptive()) return field;
  if (options.fieldIn) {
    check(awdReadField(device.get(), options.fieldIn->c_str(), field.out()));
    return field;
  }
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.preset = options.presetValue();
  desc.basis = options.basis ? options.basis->c_str() : nullptr;
  if (options.level) desc.maxLevel = AWD_LEVEL(*options.level);
  desc.estimator = options.estimatorValue();
  desc.refitSolver = options.refitSolver ? options.refitSolver->c_str() : nullptr;
  check(scene ? awdNewSceneField(scene, &desc, field.out())
              : awdNewField(device.get(), &desc, field.out()));
  return field;
}

uint32_t passCount(const Render& render) {
  uint32_t count = 0;
  check(awdGetPassCount(render.get(), &count));
  return count;
}

/// From the checkpoint if there is one; `field` is then that of the render.
Render makeRender(const Scene& scene, Field& field, const AWDCamera& camera,
                  const RenderOptions& options) {
  AWDRenderDesc desc = AWD_RENDER_DESC_INIT;
  desc.camera = &camera;
  desc.preset = options.presetValue();
  desc.guide = options.guideValue();
  desc.shadowRays = options.shadowRays;
  desc.points = options.pointsValue();
  desc.direct = options.directValue();
  desc.lights = options.lightsValue();
  desc.maxSplit = options.maxSplit;
  desc.maxBytes = static_cast<uint64_t>(options.memory.value_or(0.0) * 1048576.0);
  desc.seed = options.seed;
  Render render;
  if (!options.checkpoint || !std::filesystem::exists(*options.checkpoint)) {
    check(awdNewRender(scene.get(), field.get(), &desc, render.out()));
    return render;
  }
  const std::string& file = *options.checkpoint;
  check(awdLoadRender(scene.get(), file.c_str(), field.get(), &desc, render.out()));
  field = Field();
  check(awdGetRenderField(render.get(), field.out()));
  const uint32_t passes = passCount(render);
  note("going on from " + file + ", after " + std::to_string(passes) +
       (passes == 1 ? " pass" : " passes"));
  return render;
}

/// Whether the operation was done; false: it was cancelled.
bool finished(AWDResult result, const std::string& what) {
  if (result == AWD_ERROR_CANCELLED) return false;
  check(result, what);
  return true;
}

/// A pass at a time, each of them saved.
AWDResult renderWithCheckpoints(const Render& render, AWDSchedule schedule,
                                const std::string& file) {
  schedule.resume = 1;
  schedule.maxPasses = 1;
  for (uint32_t before = passCount(render);; ++before) {
    const AWDResult result = awdRenderPasses(render.get(), &schedule);
    if (result != AWD_SUCCESS || passCount(render) == before) return result;
    check(awdSaveRender(render.get(), file.c_str()));
  }
}

AWDResult renderPasses(const Render& render, const RenderOptions& options) {
  const Schedule& schedule = options.schedule;
  AWDSchedule desc = AWD_SCHEDULE_INIT;
  if (!schedule.samplesPerPass.empty()) {
    desc.samplesPerPass = schedule.samplesPerPass.data();
    desc.passCount = static_cast<uint32_t>(schedule.samplesPerPass.size());
  }
  desc.totalSamples = schedule.totalSamples;
  desc.seconds = schedule.seconds;
  desc.error = schedule.error;
  if (options.checkpoint) return renderWithCheckpoints(render, desc, *options.checkpoint);
  return awdRenderPasses(render.get(), &desc);
}

std::string fileName(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

void writeImage(const Render& render, const RenderOptions& options,
                const std::string& commandLine) {
  Image image;
  check(awdNewFilmImage(render.get(), image.out()));
  check(awdSetImageMetadata(image.get(), "scene", fileName(options.scene).c_str()));
  check(awdSetImageMetadata(image.get(), "command", commandLine.c_str()));
  check(awdWriteImageEXR(image.get(), options.output.c_str()));
}

/// Name of the basis in use; null without one.
json basisName(const Field& field) {
  if (!field.get()) return nullptr;
  AWDPatchInfo info = AWD_PATCH_INFO_INIT;
  check(awdGetPatchInfo(field.get(), 0, &info));
  return info.basis;
}

std::string libraryVersion() {
  const uint32_t version = awdGetVersion();
  return std::to_string(version / 10000) + '.' + std::to_string(version / 100 % 100) + '.' +
         std::to_string(version % 100);
}

void writeStatistics(const Render& render, const Field& field, const AWDCamera& camera,
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
      {"estimator", field.get() ? json(options.estimator) : json()},
      {"refit_solver", options.refitSolver ? json(*options.refitSolver) : json()},
      {"preset", options.preset},
      {"quality", options.quality ? json(*options.quality) : json()},
      {"seed", options.seed},
      {"spp", spp}};
  if (field.get() && options.estimator == "refit") statistics["refit"] = refitStatistics(field);
  writeFile(*options.json, toText(statistics));
}

/// Where time or samples ran out before the film was as good as its quality promises.
void tellBrokenPromise(const Render& render, const RenderOptions& options) {
  AWDPassStatistics statistics = AWD_PASS_STATISTICS_INIT;
  check(awdGetRenderStatistics(render.get(), &statistics));
  const std::string samples = std::to_string(statistics.samplesPerPixel) + " samples a pixel";
  if (statistics.samplesPerPixel < 2) {
    warn("--quality " + *options.quality + " is not reached: of " + samples +
         " no error can be told");
    return;
  }
  AWDRenderError error = AWD_RENDER_ERROR_INIT;
  check(awdGetRenderError(render.get(), &error));
  if (error.upper <= options.schedule.error) return;
  std::ostringstream text;
  text << "--quality " << *options.quality << " is not reached: after " << samples
       << " the error may be " << error.upper << " of the mean radiance, not "
       << options.schedule.error;
  warn(text.str());
}

int render(RenderOptions& options, const std::string& commandLine) {
  checkOutputs(options);
  ProgressBar bar;
  bar.setPassCount(options.schedule.samplesPerPass.size());
  const Device device = openDevice(options.device, &bar);
  // An unknown basis, or a damaged field, shows before a long load.
  makeField(device, options, nullptr);

  const SceneData data = loadScene(options.scene);
  AWDCamera camera = chooseCamera(options.camera, options.scene, data);
  resize(camera, options.width, options.height);
  const Scene scene = uploadScene(device, data, options.scene);
  catchInterrupt();
  if (!finished(awdCommitScene(scene.get()), options.scene)) {
    complain("interrupted before the first pass had ended: nothing is written");
    return kInterrupted;
  }

  Field field = makeField(device, options, scene.get());
  const Render render = makeRender(scene, field, camera, options);
  for (PdfRequest& pdf : options.pdfs)
    pdf.resolve(scene, render, options.presetValue() != AWD_PRESET_PAPER);
  const bool complete = finished(renderPasses(render, options), options.scene);
  clearStatus();
  if (!complete) {
    const uint32_t passes = passCount(render);
    complain(passes == 0
                 ? "interrupted before the first pass had ended: nothing is written"
                 : "interrupted: only finished passes are written, " + std::to_string(passes));
    if (passes == 0) return kInterrupted;
  }
  if (complete && options.quality) tellBrokenPromise(render, options);
  writeImage(render, options, commandLine);
  for (const PdfRequest& pdf : options.pdfs) pdf.write(render, field);
  if (options.json) writeStatistics(render, field, camera, options);
  if (options.fieldOut) {
    check(awdAdaptField(field.get(), nullptr));
    check(awdWriteField(field.get(), options.fieldOut->c_str()));
  }
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
