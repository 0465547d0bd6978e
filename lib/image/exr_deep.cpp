// SPDX-License-Identifier: Apache-2.0
#include "image/exr_deep.h"

#include <IexBaseExc.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineInputPart.h>
#include <ImfDeepTiledInputPart.h>
#include <ImfHeader.h>
#include <ImfPartType.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace awd {

namespace {

using Imath::Box2i;
using Imath::V2i;

/// Composites the regions (rows or tiles) of one part, one after the other.
class Flattener {
 public:
  /// regionWidth x regionHeight: of the largest region.
  Flattener(Box2i window, int regionWidth, int regionHeight, const std::vector<ExrPlane>& planes,
            double roomBytes, std::pmr::memory_resource* memory)
      : window_(std::move(window)),
        regionWidth_(regionWidth),
        planes_(planes),
        roomBytes_(roomBytes),
        counts_(memory),
        pointers_(planes.size(), std::pmr::vector<char*>(memory), memory),
        samples_(memory),
        order_(memory) {
    const std::size_t pixels = static_cast<std::size_t>(regionWidth) * regionHeight;
    counts_.resize(pixels);
    for (auto& pointers : pointers_) pointers.resize(pixels);
    z_ = find("Z");
    alpha_ = find("A");
  }

  /// Every region starts at the beginning of our arrays: OpenEXR counts x and y from the corner of
  /// a tile, or else x from 0 and no y, since the region is a row.
  Imf::DeepFrameBuffer frameBuffer(bool tiles) {
    Imf::DeepFrameBuffer frame;
    const std::size_t width = tiles ? static_cast<std::size_t>(regionWidth_) : 0;
    const int origin = tiles ? 0 : window_.min.x;
    frame.insertSampleCountSlice(Imf::Slice(Imf::UINT, shifted(counts_.data(), origin),
                                            sizeof(uint32_t), sizeof(uint32_t) * width, 1, 1, 0.0,
                                            tiles, tiles));
    for (std::size_t c = 0; c < planes_.size(); ++c) {
      frame.insert(planes_[c].name,
                   Imf::DeepSlice(Imf::FLOAT, shifted(pointers_[c].data(), origin), sizeof(char*),
                                  sizeof(char*) * width, sizeof(float), 1, 1, 0.0, tiles, tiles));
    }
    return frame;
  }

  /// Makes room for the samples of a region whose counts have been read.
  void prepare(const Box2i& region) {
    double total = 0;
    forEachPixel(region, [&](std::size_t i, int, int) { total += counts_[i]; });
    if (total * sizeof(float) * static_cast<double>(planes_.size()) > roomBytes_) {
      throw Iex::InputExc("its sample counts are damaged");
    }
    samples_.assign(static_cast<std::size_t>(total) * planes_.size(), 0.0f);
    float* next = samples_.data();
    for (auto& pointers : pointers_) {
      forEachPixel(region, [&](std::size_t i, int, int) {
        pointers[i] = reinterpret_cast<char*>(next);
        next += counts_[i];
      });
    }
  }

  void composite(const Box2i& region) {
    const std::size_t width = static_cast<std::size_t>(widthOf(window_));
    forEachPixel(region, [&](std::size_t i, int x, int y) {
      compositePixel(i, static_cast<std::size_t>(y - window_.min.y) * width + (x - window_.min.x));
    });
  }

 private:
  static constexpr std::size_t kNone = ~std::size_t{0};

  std::size_t find(const char* name) const {
    for (std::size_t c = 0; c < planes_.size(); ++c) {
      if (planes_[c].name == name) return c;
    }
    return kNone;
  }

  template <class T>
  static char* shifted(T* first, int origin) {
    // Outside of the array, hence not with pointers.
    return reinterpret_cast<char*>(reinterpret_cast<std::intptr_t>(first) -
                                   static_cast<std::intptr_t>(sizeof(T)) * origin);
  }

  template <class Body>
  void forEachPixel(const Box2i& region, Body&& body) const {
    for (int y = region.min.y; y <= region.max.y; ++y) {
      std::size_t i = static_cast<std::size_t>(y - region.min.y) * regionWidth_;
      for (int x = region.min.x; x <= region.max.x; ++x) body(i++, x, y);
    }
  }

  float sample(std::size_t plane, std::size_t i, uint32_t s) const {
    return reinterpret_cast<const float*>(pointers_[plane][i])[s];
  }

  /// Whether a sample lies before another one; NaN lies behind everything.
  bool nearer(std::size_t i, uint32_t a, uint32_t b) const {
    const float depth = sample(z_, i, a), other = sample(z_, i, b);
    return depth < other || (std::isnan(other) && !std::isnan(depth));
  }

  void compositePixel(std::size_t i, std::size_t to) {
    order_.resize(counts_[i]);
    std::iota(order_.begin(), order_.end(), 0u);
    if (z_ != kNone) {
      std::stable_sort(order_.begin(), order_.end(),
                       [&](uint32_t a, uint32_t b) { return nearer(i, a, b); });
    }
    for (std::size_t c = 0; c < planes_.size(); ++c) {
      const bool isDepth = planes_[c].name == "Z" || planes_[c].name == "ZBack";
      float sum = 0, through = 1;
      for (const uint32_t s : order_) {
        sum += through * sample(c, i, s);
        through *= alpha_ == kNone || isDepth ? 0.0f : 1.0f - sample(alpha_, i, s);
        if (through <= 0) break;
      }
      planes_[c].pixels[to] = sum;
    }
  }

  const Box2i window_;
  const int regionWidth_;
  const std::vector<ExrPlane>& planes_;
  const double roomBytes_;
  std::pmr::vector<uint32_t> counts_;  // of the pixels of the region
  std::pmr::vector<std::pmr::vector<char*>> pointers_;
  std::pmr::vector<float> samples_;
  std::pmr::vector<uint32_t> order_;
  std::size_t z_ = kNone, alpha_ = kNone;
};

}  // namespace

void readDeepPart(Imf::MultiPartInputFile& file, int part, const std::vector<ExrPlane>& planes,
                  double roomBytes, std::pmr::memory_resource* memory) {
  const Imf::Header& header = file.header(part);
  const Box2i window = header.dataWindow();
  if (header.type() == Imf::DEEPTILE) {
    Imf::DeepTiledInputPart input(file, part);
    const int width = std::min(static_cast<int>(input.tileXSize()), widthOf(window));
    const int height = std::min(static_cast<int>(input.tileYSize()), heightOf(window));
    Flattener flattener(window, width, height, planes, roomBytes, memory);
    input.setFrameBuffer(flattener.frameBuffer(true));
    for (int dy = 0; dy < input.numYTiles(0); ++dy) {
      for (int dx = 0; dx < input.numXTiles(0); ++dx) {
        const Box2i tile = input.dataWindowForTile(dx, dy, 0);
        input.readPixelSampleCount(dx, dy, 0);
        flattener.prepare(tile);
        input.readTile(dx, dy, 0);
        flattener.composite(tile);
      }
    }
    return;
  }
  Imf::DeepScanLineInputPart input(file, part);
  Flattener flattener(window, widthOf(window), 1, planes, roomBytes, memory);
  input.setFrameBuffer(flattener.frameBuffer(false));
  for (int y = window.min.y; y <= window.max.y; ++y) {
    const Box2i row(V2i(window.min.x, y), V2i(window.max.x, y));
    input.readPixelSampleCounts(y, y);
    flattener.prepare(row);
    input.readPixels(y, y);
    flattener.composite(row);
  }
}

}  // namespace awd
