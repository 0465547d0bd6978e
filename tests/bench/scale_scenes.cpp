// SPDX-License-Identifier: Apache-2.0
#include "scale_scenes.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <limits>

#include "camera_choice.h"
#include "scene_loader.h"
#include "support/scenes.h"
#include "upload.h"

namespace bench::scale {
namespace {

using awdtest::must;

double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void commit(const CountedDevice& device, std::size_t before, CommittedScene& committed) {
  const double start = cpuSeconds();
  must(awdCommitScene(committed.scene.get()));
  committed.commitSeconds = cpuSeconds() - start;
  committed.bytes = static_cast<double>(device.bytes() - before);
  must(awdGetSceneInfo(committed.scene.get(), &committed.info));
}

/// Into n x n: the corners of the pieces are those of a lattice over the triangle.
void cut(command::Mesh& mesh, uint32_t n) {
  command::Mesh pieces = {mesh.name, {}, {}, mesh.material};
  for (const std::array<uint32_t, 3>& triangle : mesh.triangles) {
    const auto first = static_cast<uint32_t>(pieces.vertices.size());
    // Row i has i + 1 corners.
    const auto corner = [&](uint32_t i, uint32_t j) { return first + i * (i + 1) / 2 + j; };
    for (uint32_t i = 0; i <= n; ++i) {
      for (uint32_t j = 0; j <= i; ++j) {
        const double weights[3] = {double(n - i) / n, double(i - j) / n, double(j) / n};
        std::array<float, 3> at = {};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          double sum = 0.0;
          for (std::size_t k = 0; k < 3; ++k) sum += weights[k] * mesh.vertices[triangle[k]][axis];
          at[axis] = static_cast<float>(sum);
        }
        pieces.vertices.push_back(at);
        if (i == n) continue;
        pieces.triangles.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
        if (j < i)
          pieces.triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
      }
    }
  }
  mesh = std::move(pieces);
}

bool shines(const command::Material& material) {
  return std::any_of(material.emission.begin(), material.emission.end(),
                     [](float value) { return value > 0.0f; });
}

}  // namespace

CountedDevice::CountedDevice(uint32_t threads, Cancelled cancelled) : cancelled_(cancelled) {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.threads = threads;
  desc.alloc = [](void* user, size_t size, size_t alignment) -> void* {
    static_cast<CountedDevice*>(user)->bytes_ += size;
    const std::size_t least = std::max(alignment, sizeof(void*));
    return std::aligned_alloc(least, (std::max<std::size_t>(size, 1) + least - 1) / least * least);
  };
  desc.free = [](void* user, void* ptr, size_t size, size_t) {
    static_cast<CountedDevice*>(user)->bytes_ -= size;
    std::free(ptr);
  };
  desc.allocUser = this;
  desc.progress = [](void* user, const AWDProgress*) -> int32_t {
    return static_cast<CountedDevice*>(user)->cancelled_() ? 0 : 1;
  };
  desc.progressUser = this;
  device_ = awd::Device::create(desc);
}

CommittedScene cutRooms(const CountedDevice& device, uint32_t pieces, uint32_t width) {
  const std::string file = sceneFiles("").at("two-rooms");
  command::SceneData data = command::loadScene(file);
  CommittedScene committed;
  committed.camera = command::chooseCamera({}, file, data);
  command::resize(committed.camera, width, {});
  for (command::Mesh& mesh : data.meshes) {
    if (!shines(data.materials[mesh.material])) cut(mesh, pieces);
  }
  const std::size_t before = device.bytes();
  committed.scene = command::uploadScene(device.device(), data, file);
  commit(device, before, committed);
  return committed;
}

CommittedScene lampGrid(const CountedDevice& device, uint32_t side, uint32_t width) {
  constexpr double kShare = 0.5;  // of its cell's side, a lamp's
  constexpr float kEmission = 40.0f;
  awdtest::SceneBuilder room;
  const uint32_t white = room.material(awdtest::grey(0.7)), red = room.material({0.7f, 0.3f, 0.2f}),
                 lamp = room.material(awdtest::grey(0.0), awdtest::grey(kEmission));
  room.box({0, 0, 0}, {4, 3, 4}, true, {white, red, white, white, red, white});
  const double cell = 2.0 / side, half = 0.5 * kShare * cell;
  for (uint32_t i = 0; i < side * side; ++i) {
    const double x = 1.0 + (i % side + 0.5) * cell, z = 1.0 + (i / side + 0.5) * cell;
    constexpr double y = 2.5;
    room.quad({x - half, y, z - half}, {x - half, y, z + half}, {x + half, y, z + half},
              {x + half, y, z - half}, lamp);
  }
  CommittedScene committed;
  committed.camera = awdtest::lampRoomCamera(width);
  const std::size_t before = device.bytes();
  awdtest::Scene scene = room.upload(device.device().get());
  committed.scene = awd::Scene::share(scene);
  commit(device, before, committed);
  return committed;
}

}  // namespace bench::scale
