// SPDX-License-Identifier: Apache-2.0
#include "bindings/cpp/room.h"
#include "support/counting_allocator.h"

namespace {

using namespace awdtest;

TEST(Handles, NothingOutlivesItsLastOwner) {
  CountingAllocator memory;
  {
    const AWDDeviceDesc desc = memory.desc(1);
    awd::Device device = MUST(awd::Device::create(desc));
    awd::Scene scene = makeRoom(device);
    awd::Field field = MUST(awd::Field::create(scene));
    const awd::Camera camera = roomCamera(8, 8);
    awd::Render render = MUST(awd::Render::create(scene, awd::RenderDesc(camera), field));
    awd::Image image = MUST(awd::Image::ofFilm(render));
    awd::Density density = MUST(awd::Density::create(device, awd::DensityDesc(2)));
    awd::Density fork = MUST(density.fork());

    awd::Field copy = field, other;
    other = copy;
    other = std::move(copy);
    other = MUST(render.field());
    image = MUST(awd::Image::create(device, 1, 1));
    fork = density;
    device = awd::Device();  // its children keep it
    EXPECT_GT(memory.blocks(), 0u);
    MUST(render.pass(1));
  }
  EXPECT_EQ(memory.blocks(), 0u);
}

TEST(Handles, CopiesShareAndMovesLeaveNothing) {
  const awd::Device device = oneThread();
  awd::Image image = MUST(awd::Image::create(device, 2, 1));
  const awd::Image copy = image;
  EXPECT_EQ(copy, image);
  const float pixels[] = {1.0f, 2.0f};
  MUST(image.setChannel("Y", {pixels, 2, 1}));
  EXPECT_EQ(MUST(copy.channel("Y")), std::vector<float>({1.0f, 2.0f}));

  awd::Image moved = std::move(image);
  EXPECT_FALSE(image);  // NOLINT(bugprone-use-after-move)
  EXPECT_NE(image, moved);
  EXPECT_EQ(moved, copy);
  expectError([&] { return image.info(); }, AWD_ERROR_INVALID_ARGUMENT, "image is NULL");

  const awd::Image& self = moved;
  moved = self;
  EXPECT_EQ(moved, copy);
  image = moved;
  EXPECT_TRUE(image);
}

TEST(Handles, GoToAndComeFromC) {
  const awd::Device device = oneThread();
  AWDImage raw = nullptr;
  ASSERT_EQ(awdNewImage(device.get(), 3, 2, &raw), AWD_SUCCESS);
  awd::Image image = awd::Image::adopt(raw);
  EXPECT_EQ(image.get(), raw);
  {
    const awd::Image shared = awd::Image::share(raw);
    EXPECT_EQ(shared, image);
  }
  EXPECT_EQ(MUST(image.info()).width, 3u);

  raw = image.release();
  EXPECT_FALSE(image);
  uint32_t height = 0;
  EXPECT_EQ(awdGetImageInfo(raw, nullptr, &height, nullptr), AWD_SUCCESS);
  EXPECT_EQ(height, 2u);
  awdReleaseImage(raw);

  EXPECT_FALSE(awd::Image::share(nullptr));
  EXPECT_FALSE(awd::Density::adopt(nullptr));
}

TEST(Handles, CostNothing) {
  static_assert(sizeof(awd::Field) == sizeof(AWDField));
  static_assert(std::is_nothrow_move_constructible_v<awd::Field>);
  static_assert(std::is_nothrow_copy_constructible_v<awd::Field>);
  static_assert(std::is_nothrow_move_assignable_v<awd::Field>);
  static_assert(std::is_nothrow_default_constructible_v<awd::Field>);
  static_assert(!std::is_convertible_v<awd::Field, AWDField>);
  static_assert(!std::is_convertible_v<AWDField, awd::Field>);
}

}  // namespace
