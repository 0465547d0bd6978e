// SPDX-License-Identifier: Apache-2.0
// Writes the scenes of this folder: make-scenes FOLDER. Lengths in metres, y upwards.
#include <cstdio>

#include "scene_file.h"

namespace {

using scenes::divide;
using scenes::SceneFile;
using scenes::Turn;
using scenes::Vec;

constexpr Turn kSlightly = {24.0 / 25.0, 7.0 / 25.0};       // 16.3 degrees
constexpr Turn kSlightlyBack = {24.0 / 25.0, -7.0 / 25.0};  // -16.3 degrees
constexpr Turn kOblique = {12.0 / 13.0, 5.0 / 13.0};        // 22.6 degrees

constexpr Vec kX = {1, 0, 0}, kY = {0, 1, 0}, kZ = {0, 0, 1};

/// A table with four square legs.
void table(SceneFile& scene, Vec foot, Vec size) {
  const double top = 0.04, leg = 0.05;
  scene.block(foot + Vec{0, size.y - top, 0}, {size.x, top, size.z});
  const double dx = 0.5 * (size.x - leg) - 0.03, dz = 0.5 * (size.z - leg) - 0.03;
  for (const double x : {-dx, dx}) {
    for (const double z : {-dz, dz}) scene.block(foot + Vec{x, 0, z}, {leg, size.y - top, leg});
  }
}

/// Shelves between two sides, open to both faces; the depth runs along z.
void shelves(SceneFile& scene, Vec foot, Vec size, int count) {
  const double board = 0.03;
  const double side = 0.5 * (size.x - board);
  scene.block(foot - side * kX, {board, size.y, size.z});
  scene.block(foot + side * kX, {board, size.y, size.z});
  for (int i = 0; i < count; ++i) {
    const double y = 0.08 + (size.y - board - 0.08) * i / (count - 1);
    scene.block(foot + y * kY, {size.x - 2 * board, board, size.z});
  }
}

/// A box without its front towards the camera: the usual test of colour bleeding.
SceneFile cornellBox() {
  SceneFile scene("cornell-box");
  scene.material("white", {0.74, 0.73, 0.70});
  scene.material("red", {0.62, 0.08, 0.07});
  scene.material("green", {0.12, 0.46, 0.12});
  scene.material("lamp", {0.5, 0.5, 0.5}, {16, 13, 9});
  const double w = 1.0, h = 2.0;  // half width and depth; height

  scene.object("floor", "white");
  scene.quad({-w, 0, w}, {w, 0, w}, {w, 0, -w}, {-w, 0, -w});
  scene.object("ceiling", "white");
  scene.quad({-w, h, -w}, {w, h, -w}, {w, h, w}, {-w, h, w});
  scene.object("back", "white");
  scene.quad({-w, 0, -w}, {w, 0, -w}, {w, h, -w}, {-w, h, -w});
  scene.object("left", "red");
  scene.quad({-w, 0, w}, {-w, 0, -w}, {-w, h, -w}, {-w, h, w});
  scene.object("right", "green");
  scene.quad({w, 0, -w}, {w, 0, w}, {w, h, w}, {w, h, -w});

  scene.object("tall", "white");
  scene.block({-0.36, 0, -0.34}, {0.58, 1.24, 0.58}, kOblique);
  scene.object("short", "white");
  scene.block({0.36, 0, 0.32}, {0.6, 0.6, 0.6}, kSlightlyBack);
  scene.object("lamp", "lamp");
  scene.quad({-0.25, 1.98, -0.2}, {0.25, 1.98, -0.2}, {0.25, 1.98, 0.2}, {-0.25, 1.98, 0.2});
  scene.camera({0, 1, 4.9}, {0, 1, 0}, 0.27);
  return scene;
}

/// Figure 2 of the paper: the ground is lit by the reflector alone. The lamp turns its front to
/// the reflector and its dark back to the camera; the shelf hides it from the strip of ground
/// behind it, and takes light from the lower half of the reflector.
SceneFile verification() {
  SceneFile scene("verification");
  scene.material("ground", {0.7, 0.7, 0.7});
  scene.material("reflector", {0.8, 0.8, 0.8});
  scene.material("black", {0, 0, 0});
  scene.material("lamp", {0, 0, 0}, {300, 300, 300});

  scene.object("ground", "ground");
  scene.quad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1});
  scene.object("reflector", "reflector");
  scene.quad({-0.8, 0.3, -1.2}, {0.8, 0.3, -1.2}, {0.8, 1.5, -1.2}, {-0.8, 1.5, -1.2});
  scene.object("lamp", "lamp");
  scene.quad({0.3, 1.6, -0.4}, {-0.3, 1.6, -0.4}, {-0.3, 1.9, -0.4}, {0.3, 1.9, -0.4});
  scene.object("shelf", "black");
  scene.block({0, 1.53, -0.475}, {1.0, 0.02, 0.15});
  scene.camera({0, 2.6, 2.0}, {0, 0, -0.1}, 0.42);
  return scene;
}

/// The lamp is in the far room (z < -0.2), the camera in the near one (z > 0), and the door opens
/// into the near room. The lamp hangs on the side that the slit looks away from: what comes through
/// has been reflected at least once, but for a streak of floor behind the door.
SceneFile twoRooms() {
  SceneFile scene("two-rooms");
  scene.material("plaster", {0.75, 0.73, 0.68});
  scene.material("far-plaster", {0.72, 0.74, 0.76});
  scene.material("slabs", {0.52, 0.47, 0.40});
  scene.material("wood", {0.55, 0.38, 0.24});
  scene.material("paint", {0.68, 0.70, 0.72});
  scene.material("blue", {0.25, 0.36, 0.58});
  scene.material("lamp", {0.6, 0.6, 0.6}, {2600, 2250, 1800});
  const double w = 4.0, h = 2.7, near = 4.6, far = 4.0, wall = 0.2;
  const double left = 1.6, right = 2.5, top = 2.1;  // of the opening
  const std::vector<double> rows = {0, 1.05, top, h};
  const auto opening = [](std::size_t i, std::size_t j) { return i == 2 && j < 2; };

  scene.object("near-floor", "slabs");
  scene.panels({{0, 0, near}, kX, -1 * kZ, divide(w, 5), divide(near, 6)});
  scene.object("near-walls", "plaster");
  scene.panels({{0, h, 0}, kX, kZ, divide(w, 4), divide(near, 4)});
  scene.panels({{0, 0, 0}, kX, kY, {0, 0.8, left, right, 3.25, w}, rows}, opening);
  scene.panels({{w, 0, near}, -1 * kX, kY, divide(w, 4), rows});
  scene.panels({{0, 0, near}, -1 * kZ, kY, divide(near, 5), rows});
  scene.panels({{w, 0, 0}, kZ, kY, divide(near, 5), rows});

  scene.object("far-floor", "slabs");
  scene.panels({{0, 0, -wall}, kX, -1 * kZ, divide(w, 4), divide(far, 4)});
  scene.object("far-walls", "far-plaster");
  scene.panels({{0, h, -wall - far}, kX, kZ, divide(w, 3), divide(far, 3)});
  scene.panels({{0, 0, -wall - far}, kX, kY, divide(w, 4), rows});
  scene.panels({{w, 0, -wall}, -1 * kX, kY, {0, 0.75, w - right, w - left, 3.2, w}, rows}, opening);
  scene.panels({{0, 0, -wall}, -1 * kZ, kY, divide(far, 4), rows});
  scene.panels({{w, 0, -wall - far}, kZ, kY, divide(far, 4), rows});

  // The passage, its sill and casing, and the door, which opens into the near room.
  scene.object("door-frame", "paint");
  scene.quad({left, 0, 0}, {left, 0, -wall}, {left, top, -wall}, {left, top, 0});
  scene.quad({right, 0, -wall}, {right, 0, 0}, {right, top, 0}, {right, top, -wall});
  scene.quad({left, top, -wall}, {right, top, -wall}, {right, top, 0}, {left, top, 0});
  scene.block({0.5 * (left + right), 0, -0.5 * wall}, {right - left, 0.03, wall + 0.1});
  scene.block({left - 0.06, 0, 0.035}, {0.12, top, 0.07});
  scene.block({right + 0.06, 0, 0.015}, {0.12, top, 0.03});
  scene.block({0.5 * (left + right), top, 0.025}, {right - left + 0.24, 0.12, 0.05});
  scene.object("door", "wood");
  const double thick = 0.04, leaf = right - left;
  const Vec hinge = {left, 0.035, 0.02};
  const Vec along = {kSlightlyBack.cos, 0, -kSlightlyBack.sin};
  const Vec across = {kSlightlyBack.sin, 0, kSlightlyBack.cos};
  scene.block(hinge + 0.5 * leaf * along + 0.5 * thick * across, {leaf, top - 0.045, thick},
              kSlightlyBack);

  scene.object("near-furniture", "wood");
  table(scene, {2.7, 0, 2.3}, {1.3, 0.75, 0.8});
  shelves(scene, {0.75, 0, 0.2}, {1.0, 1.9, 0.3}, 5);
  scene.object("near-things", "blue");
  scene.block({2.45, 0.75, 2.35}, {0.22, 0.22, 0.22}, kOblique);
  scene.block({2.95, 0.75, 2.2}, {0.16, 0.34, 0.16}, kSlightlyBack);
  scene.block({3.5, 0, 0.75}, {0.5, 0.45, 0.5}, kSlightly);

  scene.object("far-furniture", "wood");
  scene.block({0.3, 0, -2.2}, {0.55, 1.0, 1.6});
  scene.block({1.5, 0, -3.4}, {0.5, 0.5, 0.5}, kOblique);
  scene.object("lamp", "lamp");
  scene.quad({3.0, 2.6, -1.6}, {3.6, 2.6, -1.6}, {3.6, 2.6, -1.0}, {3.0, 2.6, -1.0});
  scene.object("lamp-box", "paint");
  scene.block({3.3, 2.61, -1.3}, {0.62, 0.09, 0.62});
  scene.camera({0.7, 1.5, 4.3}, {2.35, 1.05, 0.6}, 0.6);
  return scene;
}

/// An uplighter: the lamp lies in a bowl that hides it from everything but the ceiling.
SceneFile ceilingLamp() {
  SceneFile scene("ceiling-lamp");
  scene.material("plaster", {0.76, 0.74, 0.70});
  scene.material("boards", {0.50, 0.36, 0.24});
  scene.material("wood", {0.58, 0.42, 0.28});
  scene.material("cloth", {0.55, 0.22, 0.18});
  scene.material("metal", {0.45, 0.45, 0.45});
  scene.material("lamp", {0.5, 0.5, 0.5}, {420, 360, 270});
  const double w = 4.4, h = 2.7, d = 4.8;
  const std::vector<double> rows = {0, 0.9, 1.8, h};

  scene.object("ceiling", "plaster");
  scene.panels({{0, h, 0}, kX, kZ, divide(w, 6), divide(d, 6)});
  scene.object("walls", "plaster");
  scene.panels({{0, 0, 0}, kX, kY, divide(w, 4), rows});
  scene.panels({{w, 0, d}, -1 * kX, kY, divide(w, 4), rows});
  scene.panels({{0, 0, d}, -1 * kZ, kY, divide(d, 4), rows});
  scene.panels({{w, 0, 0}, kZ, kY, divide(d, 4), rows});
  scene.object("floor", "boards");
  scene.panels({{0, 0, d}, kX, -1 * kZ, divide(w, 5), divide(d, 5)});

  // The bowl, from its bottom up to the rim.
  const Vec foot = {2.0, 0, 1.8};
  const double bottom = 1.6, rim = 1.87, bottomHalf = 0.13, rimHalf = 0.2, lampHalf = 0.12;
  const auto ring = [&](double half, double y, int corner) {
    const double x = corner == 1 || corner == 2 ? half : -half;
    return foot + Vec{x, y, corner < 2 ? half : -half};
  };
  scene.object("bowl", "metal");
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    scene.quad(ring(bottomHalf, bottom, i), ring(bottomHalf, bottom, j), ring(rimHalf, rim, j),
               ring(rimHalf, rim, i));
  }
  scene.block(foot + (bottom - 0.02) * kY, {2 * bottomHalf, 0.02, 2 * bottomHalf});
  scene.block(foot, {0.32, 0.04, 0.32});
  scene.block(foot + 0.04 * kY, {0.04, bottom - 0.06, 0.04});
  scene.object("lamp", "lamp");
  const double y = bottom + 0.02;
  scene.quad(ring(lampHalf, y, 0), ring(lampHalf, y, 1), ring(lampHalf, y, 2),
             ring(lampHalf, y, 3));

  scene.object("furniture", "wood");
  table(scene, {1.1, 0, 3.0}, {0.9, 0.72, 1.4});
  shelves(scene, {3.5, 0, 0.2}, {1.2, 1.8, 0.3}, 5);
  scene.object("seats", "cloth");
  scene.block({3.2, 0, 1.9}, {0.8, 0.42, 0.8}, kOblique);
  scene.block({0.45, 0, 0.5}, {0.5, 0.5, 0.5}, kSlightly);
  scene.object("things", "plaster");
  scene.block({1.05, 0.72, 2.8}, {0.2, 0.2, 0.2}, kOblique);
  scene.block({1.2, 0.72, 3.3}, {0.14, 0.3, 0.14}, kSlightlyBack);
  scene.block({3.25, 0.42, 1.85}, {0.3, 0.12, 0.3}, kSlightlyBack);
  scene.camera({3.9, 1.5, 4.5}, {1.75, 1.2, 1.0}, 0.66);
  return scene;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: make-scenes FOLDER\n");
    return 2;
  }
  for (const SceneFile& scene : {cornellBox(), verification(), twoRooms(), ceilingLamp()}) {
    if (!scene.write(argv[1])) {
      std::fprintf(stderr, "make-scenes: can't write into \"%s\"\n", argv[1]);
      return 1;
    }
  }
  return 0;
}
