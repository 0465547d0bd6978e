// SPDX-License-Identifier: Apache-2.0
#include "integrator.h"

#include <algorithm>
#include <thread>

#include "room.h"

namespace host {
namespace {

constexpr Vec kUp = {0.0f, 0.0f, 1.0f};

Vec positionOf(uint32_t pixel, uint32_t n) {
  const uint32_t row = pixel / n, column = pixel % n;
  const float scale = 1.0f / static_cast<float>(n);
  return {(static_cast<float>(column) + 0.5f) * scale, (static_cast<float>(row) + 0.5f) * scale,
          0.0f};
}

/// What a direction brings: f_r L cos(theta).
float reflected(const Vec& position, const Vec& direction) {
  return kAlbedo / static_cast<float>(kPi) * incoming(position, direction) * direction[2];
}

void add(Pixel& pixel, float value) {
  pixel.r += value;
  pixel.g += value;
  pixel.b += value;
}

/// Calls work(pixel) for every pixel, in threads of the host's own.
template <class Work>
void forEachPixel(const Picture& picture, Work&& work) {
  const uint32_t count = picture.width * picture.height, threads = 2;
  std::vector<std::thread> running;
  for (uint32_t t = 0; t < threads; ++t) {
    running.emplace_back([=] {
      for (uint32_t pixel = t; pixel < count; pixel += threads) work(pixel);
    });
  }
  for (std::thread& thread : running) thread.join();
}

void divide(Picture& picture, uint32_t samples) {
  const float factor = 1.0f / static_cast<float>(samples);
  for (Pixel& pixel : picture.pixels) {
    for (float* value : {&pixel.r, &pixel.g, &pixel.b}) *value *= factor;
  }
}

/// Mean over pixels of f(quotient of picture and truth).
template <class Function>
double meanOver(const Picture& floor, Function&& f) {
  double sum = 0.0;
  for (uint32_t pixel = 0; pixel < floor.pixels.size(); ++pixel) {
    sum += f(floor.pixels[pixel].r / exactReflected(positionOf(pixel, floor.width)));
  }
  return sum / static_cast<double>(floor.pixels.size());
}

}  // namespace

Picture lightFloor(uint32_t n, uint32_t samples) {
  Picture picture(n, n);
  forEachPixel(picture, [&](uint32_t pixel) {
    const Vec position = positionOf(pixel, n);
    Random random(pixel);
    for (uint32_t i = 0; i < samples; ++i) {
      const double radius = std::sqrt(random()), angle = 2.0 * kPi * random();
      const float up = static_cast<float>(std::sqrt(1.0 - radius * radius));
      const Vec direction = {static_cast<float>(radius * std::cos(angle)),
                             static_cast<float>(radius * std::sin(angle)), up};
      if (up > 0.0f) {
        const float pdf = up / static_cast<float>(kPi);
        add(picture.pixels[pixel], reflected(position, direction) / pdf);
      }
    }
  });
  divide(picture, samples);
  return picture;
}

Picture lightFloorGuided(const awd::Device& device, uint32_t n, uint32_t samples) {
  awd::FieldDesc desc;  // a box around all positions: the field finds its patches itself
  std::fill(desc.upper, desc.upper + 3, 1.0f);
  awd::Field field = awd::Field::create(device, desc);
  Picture picture(n, n);
  // Many small passes at first: what they teach serves all that follow.
  for (uint32_t done = 0, pass = 1; done < samples; done += pass, pass *= 2) {
    pass = std::min(pass, samples - done);
    forEachPixel(picture, [&](uint32_t pixel) {
      const Vec position = positionOf(pixel, n);
      const uint32_t patch = field.findPatch(position, kUp);
      Random random(uint64_t{done} * n * n + pixel);
      for (uint32_t i = 0; i < pass; ++i) {
        const std::array<double, 3> uniforms = {random(), random(), random()};
        const AWDDirectionSample sample = field.sample(patch, kUp, uniforms);
        const Vec direction = {sample.direction[0], sample.direction[1], sample.direction[2]};
        const float value = reflected(position, direction);
        field.record(patch, sample, value);
        add(picture.pixels[pixel], value / sample.pdf);
      }
    });
    if (done + pass < samples) field.adapt();
  }
  divide(picture, samples);
  return picture;
}

double relativeError(const Picture& floor) {
  return meanOver(floor, [](double x) { return (x - 1.0) * (x - 1.0); });
}

double relativeMean(const Picture& floor) {
  return meanOver(floor, [](double x) { return x; });
}

}  // namespace host
