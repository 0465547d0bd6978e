// SPDX-License-Identifier: Apache-2.0
#include "bindings/cpp/room.h"

namespace {

using namespace awdtest;

awd::Render newRender(const awd::Scene& scene, uint32_t width, uint32_t height) {
  const awd::Camera camera = roomCamera(width, height);
  return MUST(awd::Render::create(scene, awd::RenderDesc(camera)));
}

TEST(Render, RunsPasses) {
  awd::Render render = newRender(makeRoom(oneThread()), 12, 8);
  EXPECT_EQ(MUST(render.pass(2)).samplesPerPixel, 2u);
  const uint32_t passes[] = {1, 3};
  awd::Schedule schedule;
  schedule.setPasses(passes);
  MUST(render.passes(schedule));
  EXPECT_EQ(MUST(render.passCount()), 3u);
  EXPECT_EQ(MUST(render.passStatistics(2)).samplesPerPixel, 3u);
  EXPECT_EQ(MUST(render.statistics()).samplesPerPixel, 6u);
  const awd::FilmInfo info = MUST(render.filmInfo());
  EXPECT_EQ(info.width, 12u);
  EXPECT_EQ(info.height, 8u);
  EXPECT_EQ(info.samplesPerPixel, 6u);
  const AWDRenderError error = MUST(render.error());
  EXPECT_LE(error.lower, error.upper);
  EXPECT_EQ(MUST(render.pixelPatch(0, 0)), AWD_INVALID_ID);
  EXPECT_NE(MUST(render.pixelPatch(6, 5)), AWD_INVALID_ID);
}

TEST(Render, HasAFieldIfItIsAdaptive) {
  const awd::Scene scene = makeRoom(oneThread());
  const awd::Camera camera = roomCamera(4, 4);
  awd::RenderDesc desc(camera);
  const awd::Field field = MUST(awd::Field::create(scene));
  EXPECT_EQ(MUST(MUST(awd::Render::create(scene, desc, field)).field()), field);
  EXPECT_TRUE(MUST(MUST(awd::Render::create(scene, desc)).field()));
  desc.guide = AWD_GUIDE_COSINE;
  awd::Render cosine = MUST(awd::Render::create(scene, desc));
  EXPECT_FALSE(MUST(cosine.field()));
  awd::Schedule schedule;
  schedule.totalSamples = 2;
  MUST(cosine.passes(schedule));
  EXPECT_EQ(MUST(cosine.filmInfo()).samplesPerPixel, 2u);
  static_assert(!std::is_constructible_v<awd::RenderDesc, awd::Camera&&>);
}

TEST(Render, FilmsAreWrittenThroughStrides) {
  awd::Render render = newRender(makeRoom(oneThread()), 5, 3);
  MUST(render.pass(4));
  const std::vector<float> packed = MUST(render.film());
  ASSERT_EQ(packed.size(), 45u);

  const size_t row = 5 * 4 + 3;  // four floats a pixel, three after each row
  std::vector<float> strided(3 * row, -1.0f);
  MUST(render.readFilm({strided.data(), 5, 3, 4 * sizeof(float), row * sizeof(float)}));
  float sum = 0.0f;
  for (size_t y = 0; y < 3; ++y) {
    for (size_t i = 0; i < row; ++i) {
      const bool gap = i >= 20 || i % 4 == 3;
      EXPECT_EQ(strided[y * row + i], gap ? -1.0f : packed[y * 15 + i / 4 * 3 + i % 4]);
      if (!gap) sum += strided[y * row + i];
    }
  }
  EXPECT_GT(sum, 0.0f);
  EXPECT_NE(MUST(render.film(AWD_FILM_VARIANCE)), packed);

  expectError(
      [&] {
        return render.readFilm({strided.data(), 5, 4});
      },
      AWD_ERROR_INVALID_ARGUMENT, "pixels has 5 x 4 of them: give 5 x 3");
}

TEST(Render, QualitiesAreSchedules) {
  const awd::Schedule schedule = MUST(awd::qualitySchedule(AWD_QUALITY_DRAFT));
  EXPECT_EQ(schedule.error, 0.5);
  EXPECT_EQ(schedule.totalSamples, 1024u);
  expectError([] { return awd::qualitySchedule(99); }, AWD_ERROR_INVALID_ARGUMENT, "99");
}

}  // namespace
