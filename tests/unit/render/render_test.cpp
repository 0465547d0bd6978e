// SPDX-License-Identifier: Apache-2.0
#include "render/render.h"

#include <gtest/gtest.h>

#include "density/levels.h"
#include "render/rooms.h"
#include "util/error.h"

namespace awd {
namespace {

AWDCamera lookingDown() {
  AWDCamera camera = AWD_CAMERA_INIT;
  camera.eye[2] = 0.9f;
  camera.up[1] = 1.0f;
  camera.width = 40;
  camera.height = 24;
  return camera;
}

Ref<Render> makeRender(const Ref<Scene>& scene, Ref<Field> field, AWDGuide guide) {
  const AWDCamera camera = lookingDown();
  AWDRenderDesc desc = AWD_RENDER_DESC_INIT;
  desc.camera = &camera;
  desc.guide = guide;
  return Render::make(scene->device().shareContext(), scene->shareGeometry(), std::move(field),
                      desc);
}

Ref<Field> haarField(const Ref<Scene>& scene) {
  return Field::make(scene->device().shareContext(), haarTable(),
                     settle(std::pmr::get_default_resource(), AWD_FIELD_DESC_INIT, haarTable()));
}

TEST(Render, CountsWhatItDoes) {
  const Ref<Scene> scene = sceneOf(floorAndLamp());
  const Ref<Render> render = makeRender(scene, {}, AWD_GUIDE_COSINE);
  const AWDPassStatistics pass = render->pass(3);
  EXPECT_EQ(pass.samplesPerPixel, 3u);
  EXPECT_EQ(pass.samples, 3u * 40 * 24);
  EXPECT_GT(pass.rays, pass.samples);
  EXPECT_GT(pass.shadowRays, 0u);
  EXPECT_EQ(pass.rejectedSamples, 0u);
  EXPECT_EQ(pass.patches, 0u);
  render->pass(2);
  EXPECT_EQ(render->total().samples, 5u * 40 * 24);
  EXPECT_EQ(render->film().samples(), 5u);
}

TEST(Render, AdaptsBetweenPassesAlone) {
  const Ref<Scene> scene = sceneOf(floorAndLamp());
  const Ref<Field> field = haarField(scene);
  const Ref<Render> render = makeRender(scene, field, AWD_GUIDE_ADAPTIVE);
  const uint32_t samples[] = {2, 4};
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.samplesPerPass = samples;
  schedule.passCount = 2;
  render->passes(schedule);
  ASSERT_EQ(render->statistics().size(), 2u);
  const uint32_t floor = scene->geometry().triangle(0).patch;
  // What the second pass recorded waits for the next adapt.
  EXPECT_GT(field->patchInfo(floor).samples, 0u);
  render->passes(schedule);
  EXPECT_EQ(render->statistics().size(), 4u);
}

TEST(Render, ARefusedScheduleKeepsThePartThatWaits) {
  const Ref<Scene> scene = sceneOf(floorAndLamp());
  const Ref<Field> field = haarField(scene);
  const Ref<Render> render = makeRender(scene, field, AWD_GUIDE_ADAPTIVE);
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.totalSamples = 20;
  ASSERT_GT(render->passPart(schedule, 0, 1), 0u);
  const uint64_t recorded = field->patchInfo(scene->geometry().triangle(0).patch).samples;
  const uint32_t none[] = {0};
  AWDSchedule wrong = AWD_SCHEDULE_INIT;
  wrong.samplesPerPass = none;
  wrong.passCount = 1;
  EXPECT_THROW(render->passes(wrong), Error);
  EXPECT_THROW(render->passPart(wrong, 0, 1), Error);
  EXPECT_THROW(render->pass(0), Error);
  EXPECT_GT(render->exchangeSize().sums, 0u);
  EXPECT_EQ(field->patchInfo(scene->geometry().triangle(0).patch).samples, recorded);
}

TEST(Render, StepsAsideWhereThereAreTooFewSamplesToLearnFrom) {
  const Ref<Scene> scene = sceneOf(floorAndLamp());
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  const auto rendered = [&](const Ref<Field>& field, AWDGuide guide, uint32_t samples) {
    schedule.totalSamples = samples;
    Ref<Render> render = makeRender(scene, field, guide);
    render->passes(schedule);
    return render;
  };
  const Ref<Field> field = haarField(scene);
  const Ref<Render> few = rendered(field, AWD_GUIDE_ADAPTIVE, 5);
  const Ref<Render> cosine = rendered({}, AWD_GUIDE_COSINE, 5);
  EXPECT_EQ(few->statistics().size(), 1u);
  EXPECT_EQ(few->total().rays, cosine->total().rays);
  EXPECT_EQ(few->film().mean(500), cosine->film().mean(500));
  EXPECT_EQ(field->statistics().patches, 0u) << "it has learned";
  // The next schedule of the same render goes beyond, and learns.
  schedule.totalSamples = 3;
  few->passes(schedule);
  EXPECT_EQ(few->statistics().size(), 4u);
  EXPECT_GT(field->statistics().patches, 0u);
  // What a field knows already is used however few samples there are.
  EXPECT_EQ(rendered(field, AWD_GUIDE_ADAPTIVE, 3)->statistics().size(), 3u);
  EXPECT_GT(rendered(haarField(scene), AWD_GUIDE_ADAPTIVE, 6)->statistics().size(), 3u);
}

TEST(Render, ScalesTheFieldToItsLights) {
  // A lamp far dimmer than the field's own scale must still be learned from in the first pass.
  const Ref<Device> owner = device();
  Ref<Scene> scene = Scene::make(owner);
  scene->addMaterial(material(0.5f, 0.0f));
  scene->addMaterial(material(0.0f, 1e-30f));
  const Soup soup = floorAndLamp();
  scene->addMesh(soup.desc());
  scene->commit();
  const Ref<Field> field = haarField(scene);
  const Ref<Render> render = makeRender(scene, field, AWD_GUIDE_ADAPTIVE);
  render->pass(4);
  const AWDFieldStatistics figures = field->adapt();
  EXPECT_EQ(figures.kept, 0u);
  EXPECT_EQ(figures.saturated, 0u);
}

TEST(Render, RefusesAnEmptyPass) {
  const Ref<Scene> scene = sceneOf(floorAndLamp());
  const Ref<Render> render = makeRender(scene, {}, AWD_GUIDE_UNIFORM);
  EXPECT_THROW(render->pass(0), Error);
}

TEST(Render, KnowsThePatchUnderAPixel) {
  const Ref<Scene> scene = sceneOf(floorAndLamp());
  const Ref<Render> render = makeRender(scene, {}, AWD_GUIDE_COSINE);
  EXPECT_EQ(render->pixelPatch(20, 12), scene->geometry().triangle(0).patch);
  EXPECT_THROW(render->pixelPatch(40, 0), Error);
}

}  // namespace
}  // namespace awd
