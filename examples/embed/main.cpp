// SPDX-License-Identifier: Apache-2.0
// A host in C++ that has libawd do two things: guide an integrator of its own, and render a scene.
#include <cmath>
#include <cstdio>

#include "integrator.h"
#include "lamp.h"

namespace {

/// Both pictures must be right, within five standard errors; the guided one is to be less noisy.
bool guide(const awd::Device& device) {
  constexpr uint32_t kSize = 32, kSamples = 255;  // 1 + 2 + 4 + .. + 128
  const host::Picture plain = host::lightFloor(kSize, kSamples);
  const host::Picture guided = host::lightFloorGuided(device, kSize, kSamples);
  bool good = true;
  for (const host::Picture* picture : {&plain, &guided}) {
    const double mean = host::relativeMean(*picture), error = host::relativeError(*picture);
    std::printf("%-9s relMSE %.5f, mean %.4f of the truth\n",
                picture == &plain ? "unguided" : "guided", error, mean);
    good = good && std::abs(mean - 1.0) < 5.0 * std::sqrt(error) / kSize;
  }
  const double gain = host::relativeError(plain) / host::relativeError(guided);
  std::printf("gain      %.1fx\n", gain);
  return good && gain > 1.0;
}

bool render(const awd::Device& device) {
  const host::Picture picture = host::renderLamp(device, 64, 48);
  double sum = 0.0;
  for (const host::Pixel& pixel : picture.pixels) sum += pixel.r + pixel.g + pixel.b;
  std::printf("lamp      mean radiance %.3f\n",
              sum / (3.0 * static_cast<double>(picture.pixels.size())));
  return sum > 0.0;
}

}  // namespace

int main() {
  try {
    const auto onLog = [](int32_t, const char* message) {
      std::fprintf(stderr, "embed: %s\n", message);
    };
    awd::DeviceDesc desc;
    desc.setLog(onLog);
    const awd::Device device = awd::Device::create(desc);
    return guide(device) && render(device) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "embed: %s\n", error.what());
    return 1;
  }
}
