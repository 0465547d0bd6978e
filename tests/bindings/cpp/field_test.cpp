// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>

#include "bindings/cpp/room.h"

namespace {

using namespace awdtest;

const std::array<float, 3> kUp = {0, 0, 1};
const std::array<double, 3> kUniforms = {0.3, 0.6, 0.9};

awd::Field newField(const awd::Device& device = oneThread()) {
  const float powers[] = {1.0f, 3.0f};
  awd::FieldDesc desc;
  desc.upper[0] = desc.upper[1] = desc.upper[2] = 1.0f;
  desc.setLights(powers);
  return MUST(awd::Field::create(device, desc));
}

TEST(Field, GuidesVertexByVertex) {
  awd::Field field = newField();
  MUST(field.setScale(2.0));
  const uint32_t patch = MUST(field.findPatch(std::array<float, 3>{0.5f, 0.5f, 0.5f}, kUp));
  const AWDDirectionSample sample = MUST(field.sample(patch, kUp, kUniforms));
  EXPECT_EQ(MUST(field.pdf(patch, kUp, sample.direction)), sample.pdf);
  const AWDDirectionSample mapped = MUST(field.map(patch, kUp, sample.direction));
  EXPECT_NEAR(mapped.square[0], sample.square[0], 1e-5);
  EXPECT_EQ(MUST(field.patchMean(patch)), -1.0f);
  EXPECT_EQ(MUST(field.continuation(patch, 1.0f, 1.0f)), -1.0f);
  MUST(field.record(patch, sample, 0.5));
  EXPECT_EQ(MUST(field.statistics()).patches, 1u);
  EXPECT_EQ(MUST(field.adapt()).samples, 1u);
  const uint32_t after = MUST(field.findPatch(std::array<float, 3>{0.5f, 0.5f, 0.5f}, kUp));
  EXPECT_GT(MUST(field.patchMean(after)), 0.0f);
  EXPECT_GT(MUST(field.continuation(after, 1.0f, 1.0f, 1)), 0.0f);
}

TEST(Field, RecordsPaths) {
  awd::Field field = newField();
  AWDPathVertex vertices[2] = {};
  vertices[0].patch = MUST(field.findPatch(std::array<float, 3>{0.5f, 0.5f, 0.5f}, kUp));
  vertices[0].continuation = 1.0f;
  vertices[0].sample = MUST(field.sample(vertices[0].patch, kUp, kUniforms));
  vertices[0].direct[1] = 0.25f;
  for (float& s : vertices[0].scattering) s = vertices[0].sample.pdf;
  vertices[1].patch = AWD_INVALID_ID;
  vertices[1].emitted[0] = 2.0f;
  const std::array<float, 3> radiance = MUST(field.recordPath(vertices));
  EXPECT_FLOAT_EQ(radiance[0], 2.0f);
  EXPECT_FLOAT_EQ(radiance[1], 0.25f);
  const std::array<float, 3> sky = MUST(
      field.recordPath(awd::View<const AWDPathVertex>(vertices, 1), std::array<float, 3>{0, 0, 3}));
  EXPECT_FLOAT_EQ(sky[2], 3.0f);
  EXPECT_EQ(MUST(field.adapt()).samples, 2u);
}

TEST(Field, BatchesAreWhatSinglesAre) {
  const awd::Field field = newField();
  const std::vector<float> positions = {0.1f, 0.2f, 0.3f, 0.9f, 0.8f, 0.7f};
  const std::vector<float> normals = {0, 0, 1, 1, 0, 0};
  const std::vector<double> uniforms = {0.3, 0.6, 0.9, 0.1, 0.2, 0.3};
  std::vector<uint32_t> patches(2);
  std::vector<AWDDirectionSample> samples(2);
  MUST(field.findPatches(positions, normals, patches));
  EXPECT_EQ(patches[1],
            MUST(field.findPatch(awd::Float3(&positions[3]), awd::Float3(&normals[3]))));
  MUST(field.sample(patches, normals, uniforms, samples));
  std::vector<float> directions(6), pdfs(2);
  for (size_t i = 0; i < 6; ++i) directions[i] = samples[i / 3].direction[i % 3];
  MUST(field.pdf(patches, normals, directions, pdfs));
  for (size_t i = 0; i < 2; ++i) EXPECT_EQ(pdfs[i], samples[i].pdf);
  MUST(field.record(patches, samples, std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(MUST(field.patches()).size(), 2u);

  std::vector<float> five(5);
  std::vector<double> seven(7);
  const auto refused = [](auto&& call, const char* part) {
    expectError(call, AWD_ERROR_INVALID_ARGUMENT, part);
  };
  refused([&] { return field.findPatches(five, normals, patches); }, "positions has 5");
  refused([&] { return field.findPatches(positions, five, patches); }, "normals has 5");
  refused([&] { return field.sample(patches, five, uniforms, samples); }, "normals has 5");
  refused([&] { return field.sample(patches, normals, seven, samples); }, "uniforms has 7");
  refused([&] { return field.pdf(patches, five, directions, pdfs); }, "normals has 5");
  refused([&] { return field.pdf(patches, normals, five, pdfs); }, "directions has 5");
  refused([&] { return field.pdf(patches, normals, directions, five); }, "pdfs has 5");
  refused([&] { return field.record(patches, samples, seven); }, "values has 7");
  samples.resize(3);
  refused([&] { return field.sample(patches, normals, uniforms, samples); }, "samples has 3");
  refused([&] { return field.record(patches, samples, std::vector<double>(2)); }, "samples has 3");
}

TEST(Field, ChoosesLights) {
  awd::Field field = newField();
  const awd::LightChoice choice = MUST(field.chooseLight(0, 0.5));
  EXPECT_EQ(choice.light, 1u);
  EXPECT_FLOAT_EQ(choice.chance, 0.75f);
  EXPECT_NEAR(choice.rest, 1.0 / 3.0, 1e-12);
  EXPECT_FLOAT_EQ(MUST(field.lightChance(0, 0)), 0.25f);
  MUST(field.recordLight(0, 0, 5.0));
  MUST(field.adapt());
  EXPECT_GT(MUST(field.patchLight(0)), 0.0f);
}

TEST(Field, ShowsWhatAPatchKnows) {
  const awd::Field field = newField();
  const AWDPatchInfo info = MUST(field.patchInfo(0));
  EXPECT_EQ(MUST(field.patchCoefficients(0)).size(), size_t{info.axisCount} * info.axisCount);
  std::vector<float> pixels(4 * 6, -1.0f);  // rows of 4, with a gap of 2
  MUST(field.patchPdf(0, {pixels.data(), 4, 4, 0, 6 * sizeof(float)}));
  for (size_t i = 0; i < pixels.size(); ++i) {
    EXPECT_FLOAT_EQ(pixels[i], i % 6 < 4 ? 1.0f : -1.0f) << i;
  }
  expectError(
      [&] {
        return field.patchPdf(0, {pixels.data(), 4, 3});
      },
      AWD_ERROR_INVALID_ARGUMENT, "square");
  expectError(
      [&] {
        return field.patchPdf(0, {pixels.data(), 2, 2, 8});
      },
      AWD_ERROR_INVALID_ARGUMENT, "packed");
}

TEST(Field, GoesOnElsewhere) {
  const awd::Device device = oneThread();
  awd::Field field = newField(device);
  const std::vector<std::byte> fresh = MUST(field.save());
  MUST(field.record(0, MUST(field.sample(0, kUp, kUniforms)), 1.0));
  awd::Field other = MUST(awd::Field::load(device, fresh));
  MUST(other.merge(field));
  EXPECT_EQ(MUST(other.save()), MUST(field.save()));

  MUST(field.mark());
  MUST(field.record(0, MUST(field.sample(0, kUp, kUniforms)), 1.0));
  EXPECT_NE(MUST(other.save()), MUST(field.save()));
  MUST(field.revert());
  EXPECT_EQ(MUST(field.adapt()).samples, 1u);

  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / "bindings-cpp.field";
  MUST(field.write(path));
  awd::Field read = MUST(awd::Field::read(device, path));
  EXPECT_EQ(MUST(read.save()), MUST(field.save()));
  std::filesystem::remove(path);
  expectError([&] { return awd::Field::read(device, path); }, AWD_ERROR_IO, path.string());
}

}  // namespace
