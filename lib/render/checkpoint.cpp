// SPDX-License-Identifier: Apache-2.0
// A render as a file from which it goes on with the same bits.
#include <limits>

#include "render/render.h"
#include "util/atomic_file.h"
#include "util/error.h"

namespace awd {

namespace {

constexpr char kMagic[] = "AWDRENDR";
constexpr uint32_t kVersion = 1;
constexpr double kMostSeconds = std::numeric_limits<double>::max();
/// Of the settings and of a pass, at most.
constexpr std::size_t kHead = 512;
constexpr std::size_t kPass = 96;
constexpr std::size_t kLeastPass = 80;

// These name all members: with one more they don't compile until that is saved too.

void put(ByteWriter& writer, const AWDCamera& camera) {
  const auto& [structSize, eye, lookDir, up, tanHalfFovX, width, height] = camera;
  for (const float* v : {eye, lookDir, up}) {
    for (int i = 0; i < 3; ++i) writer.put(static_cast<double>(v[i]));
  }
  writer.put(static_cast<double>(tanHalfFovX));
  writer.put(width);
  writer.put(height);
}

AWDCamera getCamera(ByteReader& reader) {
  constexpr double kFloat = std::numeric_limits<float>::max();
  const auto number = [&] { return static_cast<float>(reader.get(-kFloat, kFloat)); };
  AWDCamera camera = AWD_CAMERA_INIT;
  for (float* v : {camera.eye, camera.lookDir, camera.up}) {
    for (int i = 0; i < 3; ++i) v[i] = number();
  }
  camera.tanHalfFovX = number();
  camera.width = reader.get<uint32_t>(1, 65536);
  camera.height = reader.get<uint32_t>(1, 65536);
  return camera;
}

void put(ByteWriter& writer, const AWDRenderDesc& desc) {
  const auto& [structSize, camera, preset, guide, direct, roulette, shadowRays, maxLights, seed,
               combination, points, maxBytes, maxSplit, lights] = desc;
  put(writer, *camera);
  for (const int32_t choice : {preset, guide, direct, roulette, combination, points, lights}) {
    writer.put(choice);
  }
  for (const uint32_t number : {shadowRays, maxLights, maxSplit}) writer.put(number);
  writer.put(seed);
  writer.put(maxBytes);
}

AWDRenderDesc getDesc(ByteReader& reader, AWDCamera& camera) {
  AWDRenderDesc desc = AWD_RENDER_DESC_INIT;
  camera = getCamera(reader);
  desc.camera = &camera;
  for (int32_t* choice : {&desc.preset, &desc.guide, &desc.direct, &desc.roulette,
                          &desc.combination, &desc.points, &desc.lights}) {
    *choice = reader.get<int32_t>();
  }
  for (uint32_t* number : {&desc.shadowRays, &desc.maxLights, &desc.maxSplit}) {
    *number = reader.get<uint32_t>();
  }
  desc.seed = reader.get<uint64_t>();
  desc.maxBytes = reader.get<uint64_t>();
  return desc;
}

void put(ByteWriter& writer, const AWDPassStatistics& pass) {
  const auto& [structSize, cpuSeconds, wallSeconds, samplesPerPixel, samples, rays, shadowRays,
               patches, coefficients, bytes, rejectedSamples] = pass;
  writer.put(cpuSeconds);
  writer.put(wallSeconds);
  for (const uint64_t figure : {samplesPerPixel, samples, rays, shadowRays, patches, coefficients,
                                bytes, rejectedSamples}) {
    writer.put(figure);
  }
}

AWDPassStatistics getPass(ByteReader& reader) {
  AWDPassStatistics pass = AWD_PASS_STATISTICS_INIT;
  pass.cpuSeconds = reader.get(0.0, kMostSeconds);
  pass.wallSeconds = reader.get(0.0, kMostSeconds);
  for (uint64_t* figure : {&pass.samplesPerPixel, &pass.samples, &pass.rays, &pass.shadowRays,
                           &pass.patches, &pass.coefficients, &pass.bytes, &pass.rejectedSamples}) {
    *figure = reader.get<uint64_t>();
  }
  return pass;
}

bool sameView(const AWDCamera& a, const AWDCamera& b) {
  return load(a.eye) == load(b.eye) && load(a.lookDir) == load(b.lookDir) &&
         load(a.up) == load(b.up) && a.tanHalfFovX == b.tanHalfFovX && a.width == b.width &&
         a.height == b.height;
}

}  // namespace

void Render::save(const char* path) const {
  if (part_) {
    fail(AWD_ERROR_INVALID_OPERATION,
         "a part of a pass has been rendered: save before it, or after awdImportPass");
  }
  std::pmr::vector<char> learned(context_->memory());
  if (field_) learned = field_->bytesOf();
  const std::size_t pixels = std::size_t{film_.width()} * film_.height();
  ByteWriter writer(context_->memory(), kMagic, kVersion,
                    kHead + statistics_.size() * kPass + learned.size() + Film::bytesToPut(pixels));
  writer.put(geometry_->digest());
  writer.put(geometry_->info().triangles);
  put(writer, desc_);
  writer.put(static_cast<uint8_t>(experienced_));
  writer.put(uint64_t{statistics_.size()});
  for (const AWDPassStatistics& pass : statistics_) put(writer, pass);
  writer.putBytes(learned);
  film_.put(writer);

  const std::pmr::vector<char> bytes = writer.finish();
  AtomicFile file(path);
  file.write(bytes.data(), bytes.size());
  file.commit();
}

void Render::checkSame(const AWDRenderDesc& other) const {
  const auto check = [](bool same, const char* what) {
    if (same) return;
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "desc->%s is not what the checkpoint was rendered with: go on with the same settings, or "
         "leave desc NULL",
         what);
  };
  const PathSettings theirs = settle(other);
  check(sameView(view_, *other.camera), "camera");
  check(preset_ == other.preset, "preset");
  check(settings_.guide == theirs.guide, "guide");
  check(settings_.direct == theirs.direct, "direct");
  check(settings_.roulette == theirs.roulette, "roulette");
  check(settings_.shadowRays == theirs.shadowRays, "shadowRays");
  check(settings_.maxLights == theirs.maxLights, "maxLights");
  check(seed_ == other.seed, "seed");
  check(combination_ == settleCombination(other), "combination");
  check(settings_.sobol == theirs.sobol, "points");
  check(desc_.maxBytes == other.maxBytes, "maxBytes");
  check(settings_.maxSplit == theirs.maxSplit, "maxSplit");
  check(settings_.learnLights == theirs.learnLights, "lights");
}

Ref<Render> Render::load(Ref<Context> context, Ref<Geometry> geometry, const void* bytes,
                         std::size_t size, const Finders& find, const AWDRenderDesc* desc,
                         const Field* like) {
  std::pmr::memory_resource* memory = context->memory();
  ByteReader reader(bytes, size, kMagic, kVersion, "a checkpoint");
  const auto scene = reader.get<uint64_t>();
  const auto triangles = reader.get<uint64_t>();
  if (scene != geometry->digest()) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "scene is not the one that the checkpoint was rendered of: %llu triangles there, %llu "
         "here, or other places, materials or patches",
         static_cast<unsigned long long>(triangles),
         static_cast<unsigned long long>(geometry->info().triangles));
  }
  AWDCamera camera;
  const AWDRenderDesc saved = getDesc(reader, camera);
  const bool experienced = reader.get<uint8_t>(0, 1) != 0;
  const std::size_t passes = reader.getCount(kLeastPass);
  std::pmr::vector<AWDPassStatistics> statistics(memory);
  statistics.reserve(passes);
  uint64_t samples = 0;
  for (std::size_t i = 0; i < passes; ++i) {
    statistics.push_back(getPass(reader));
    samples += statistics.back().samplesPerPixel;
  }
  const std::string_view learned = reader.getBytes();
  if (learned.empty() == (saved.guide == AWD_GUIDE_ADAPTIVE)) reader.damaged();
  // No film is given more memory than its bytes answer for.
  const std::size_t pixels = std::size_t{camera.width} * camera.height;
  if (reader.remaining() != Film::bytesToPut(pixels)) reader.damaged();

  Ref<Field> field;
  if (!learned.empty()) field = Field::load(context, learned.data(), learned.size(), find);
  Ref<Render> render;
  try {
    render = Ref<Render>::adopt(awd::make<Render>(memory, context, geometry, field, saved));
  } catch (const Error& error) {
    // What the host gives is not wrong: it has seen none of these settings.
    if (error.code() != AWD_ERROR_INVALID_ARGUMENT) throw;
    fail(AWD_ERROR_IO, "a checkpoint is damaged: of what it holds %s", error.what());
  }
  render->limitField();
  render->experienced_ = experienced;
  render->statistics_ = std::move(statistics);
  render->film_.get(reader);
  reader.finish();
  if (render->film_.samples() != samples) reader.damaged();
  if (desc) render->checkSame(*desc);
  if (field && like) {
    if (const char* what = field->differenceTo(*like)) {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "field differs from that of the checkpoint in %s: go on with the same settings, or "
           "leave field NULL",
           what);
    }
  }
  return render;
}

}  // namespace awd
