// SPDX-License-Identifier: Apache-2.0
// References are dropped in any order, parents before their children; what is left can be used, and
// in the end all memory is the host's again.
#include <gtest/gtest.h>

#include <algorithm>

#include "misuse/world.h"
#include "support/handles.h"
#include "support/random.h"
#include "support/soak.h"

namespace {

using namespace awdmisuse;
using awdtest::must;

/// Something of every kind that needs its parents.
void use(World& world) {
  for (const AWDDevice device : world.devices) {
    AWDImage image = nullptr;
    must(awdNewImage(device, 1, 1, &image));
    awdReleaseImage(image);
  }
  for (const AWDScene scene : world.scenes) must(awdCommitScene(scene));
  for (const AWDField field : world.fields) must(awdAdaptField(field, nullptr));
  for (const AWDRender render : world.renderers) must(awdRenderPass(render, 1, nullptr));
  for (const AWDImage image : world.images) must(awdSetImageMetadata(image, "a", "b"));
  for (const AWDDensity density : world.densities) {
    AWDDensity fork = nullptr;
    must(awdForkDensity(density, &fork));
    awdReleaseDensity(fork);
  }
}

/// References are entries: an object is gone when none is left.
template <class T>
bool dropOne(std::vector<T>& pool, size_t& index) {
  if (index >= pool.size()) {
    index -= pool.size();
    return false;
  }
  const T handle = pool[index];
  pool.erase(pool.begin() + static_cast<std::ptrdiff_t>(index));
  release(handle);
  return true;
}

template <class T>
void retainTwice(std::vector<T>& pool) {
  for (size_t i = 0, n = pool.size(); i < n; i += 2) {
    retain(pool[i]);
    pool.push_back(pool[i]);
  }
}

TEST(Releases, InAnyOrder) {
  const long orders = awdtest::soakSize(8, 500);
  for (long order = 0; order < orders; ++order) {
    SCOPED_TRACE(order);
    World world;
    AWDField field = nullptr;
    must(awdGetRenderField(world.renderers[0], &field));
    world.fields.push_back(field);
    retainTwice(world.renderers), retainTwice(world.fields), retainTwice(world.densities);
    retainTwice(world.scenes), retainTwice(world.images), retainTwice(world.devices);
    awdtest::Random random(static_cast<uint64_t>(order));
    const bool parentsFirst = order == 0;
    while (world.references() > 0) {
      // First the devices, then the scenes and so on, or at random.
      size_t index = parentsFirst ? 0 : random.bits() % world.references();
      dropOne(world.devices, index) || dropOne(world.scenes, index) ||
          dropOne(world.fields, index) || dropOne(world.renderers, index) ||
          dropOne(world.densities, index) || dropOne(world.images, index);
      use(world);
    }
    EXPECT_EQ(world.memory.blocks() + world.others.blocks(), 0u);
  }
}

}  // namespace
