// SPDX-License-Identifier: Apache-2.0
#include "exr_files.h"

#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfDeepTiledOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfTiledOutputFile.h>
#include <ImfTiledOutputPart.h>

#include <cmath>
#include <cstdint>

namespace awd::test {

namespace {

Imath::Box2i windowOf(const FileKind& kind) {
  return {{kind.left, kind.top}, {kind.left + kind.width - 1, kind.top + kind.height - 1}};
}

Imf::Header headerOf(const FileKind& kind) {
  Imf::Header header(windowOf(kind), windowOf(kind));
  header.compression() = kind.compression;
  header.lineOrder() = kind.order;
  return header;
}

/// The numbers of one channel in the type of the file.
class Plane {
 public:
  Plane(const FileKind& kind, int channel) : kind_(kind) {
    for (int y = 0; y < kind.height; ++y) {
      for (int x = 0; x < kind.width; ++x) {
        const float value = kind.black ? 0.0f : smooth(x, y, channel);
        floats_.push_back(value);
        halves_.emplace_back(value);
        uints_.push_back(static_cast<uint32_t>(value * 1000));
      }
    }
  }
  Imf::Slice slice() const {
    const void* const data = kind_.type == Imf::FLOAT  ? static_cast<const void*>(floats_.data())
                             : kind_.type == Imf::HALF ? static_cast<const void*>(halves_.data())
                                                       : static_cast<const void*>(uints_.data());
    const std::size_t size = kind_.type == Imf::HALF ? 2 : 4;
    return Imf::Slice::Make(kind_.type, data, windowOf(kind_), size,
                            size * static_cast<std::size_t>(kind_.width));
  }

 private:
  FileKind kind_;
  std::vector<float> floats_;
  std::vector<half> halves_;
  std::vector<uint32_t> uints_;
};

template <class File>
void writeAllTiles(File& file) {
  for (int ly = 0; ly < file.numYLevels(); ++ly) {
    for (int lx = 0; lx < file.numXLevels(); ++lx) {
      if (!file.isValidLevel(lx, ly)) continue;
      file.writeTiles(0, file.numXTiles(lx) - 1, 0, file.numYTiles(ly) - 1, lx, ly);
    }
  }
}

}  // namespace

float smooth(int x, int y, int channel) {
  const double value = 0.5 + 0.4 * std::sin(0.2 * x + 0.11 * y + channel);
  return half(static_cast<float>(value));
}

const std::vector<Imf::Compression>& compressions() {
  static const std::vector<Imf::Compression> all = {
      Imf::NO_COMPRESSION,   Imf::RLE_COMPRESSION,   Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
      Imf::PIZ_COMPRESSION,  Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION,  Imf::B44A_COMPRESSION,
      Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION};
  return all;
}

void writeScanlines(const std::string& path, const FileKind& kind) {
  Imf::Header header = headerOf(kind);
  Imf::FrameBuffer frame;
  const char* const names[] = {"R", "G", "B"};
  std::vector<Plane> planes;
  for (int c = 0; c < 3; ++c) planes.emplace_back(kind, c);
  for (std::size_t c = 0; c < 3; ++c) {
    header.channels().insert(names[c], Imf::Channel(kind.type));
    frame.insert(names[c], planes[c].slice());
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  file.writePixels(kind.height);
}

void writeTiles(const std::string& path, const FileKind& kind, Imf::LevelMode mode) {
  Imf::Header header = headerOf(kind);
  header.setTileDescription(Imf::TileDescription(16, 8, mode));
  Imf::FrameBuffer frame;
  const char* const names[] = {"R", "G", "B"};
  std::vector<Plane> planes;
  for (int c = 0; c < 3; ++c) planes.emplace_back(kind, c);
  for (std::size_t c = 0; c < 3; ++c) {
    header.channels().insert(names[c], Imf::Channel(kind.type));
    frame.insert(names[c], planes[c].slice());
  }
  Imf::TiledOutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  writeAllTiles(file);
}

void writeParts(const std::string& path, const FileKind& kind) {
  FileKind third = kind;
  third.left += 5;
  third.top += 5;
  third.width /= 2;
  third.height /= 2;
  Imf::Header headers[] = {headerOf(kind), headerOf(kind), headerOf(third)};
  const char* const names[] = {"first", "second", "third"};
  for (int part = 0; part < 3; ++part) {
    headers[part].setName(names[part]);
    headers[part].setType(part == 1 ? Imf::TILEDIMAGE : Imf::SCANLINEIMAGE);
    headers[part].channels().insert("Y", Imf::Channel(kind.type));
    // Parts share it.
    headers[part].displayWindow() = windowOf(kind);
  }
  headers[1].setTileDescription(Imf::TileDescription(16, 8));
  Imf::MultiPartOutputFile file(path.c_str(), headers, 3);
  for (int part = 0; part < 3; ++part) {
    const FileKind& size = part == 2 ? third : kind;
    const Plane plane(size, part);
    Imf::FrameBuffer frame;
    frame.insert("Y", plane.slice());
    if (part == 1) {
      Imf::TiledOutputPart output(file, part);
      output.setFrameBuffer(frame);
      output.writeTiles(0, output.numXTiles() - 1, 0, output.numYTiles() - 1);
    } else {
      Imf::OutputPart output(file, part);
      output.setFrameBuffer(frame);
      output.writePixels(size.height);
    }
  }
}

void writeTwoParts(const std::string& path, const char* const names[2][2]) {
  Imf::Header headers[2];
  for (int part = 0; part < 2; ++part) {
    headers[part] = headerOf({Imf::ZIP_COMPRESSION, Imf::FLOAT, Imf::INCREASING_Y, 0, 0, 1, 1});
    headers[part].setName(names[part][0]);
    headers[part].setType(Imf::SCANLINEIMAGE);
    headers[part].channels().insert(names[part][1], Imf::Channel(Imf::FLOAT));
  }
  Imf::MultiPartOutputFile file(path.c_str(), headers, 2);
  for (int part = 0; part < 2; ++part) {
    float pixel = 0.5f;
    Imf::FrameBuffer frame;
    frame.insert(names[part][1], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&pixel), 4, 4));
    Imf::OutputPart output(file, part);
    output.setFrameBuffer(frame);
    output.writePixels(1);
  }
}

void writeSubsampled(const std::string& path, int size) {
  Imf::Header header(size, size);
  header.compression() = Imf::DWAB_COMPRESSION;
  header.channels().insert("Y", Imf::Channel(Imf::FLOAT, size, size));
  float pixel = 0.5f;
  Imf::FrameBuffer frame;
  frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&pixel), 4, 4, size, size));
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  file.writePixels(size);
}

void writeLumaChroma(const std::string& path, const FileKind& kind, bool alpha) {
  std::vector<Imf::Rgba> pixels;
  for (int y = 0; y < kind.height; ++y) {
    for (int x = 0; x < kind.width; ++x) {
      pixels.emplace_back(smooth(x, y, 0), smooth(x, y, 1), smooth(x, y, 2), smooth(x, y, 3));
    }
  }
  Imf::RgbaOutputFile file(path.c_str(), headerOf(kind), alpha ? Imf::WRITE_YCA : Imf::WRITE_YC);
  file.setFrameBuffer(pixels.data() - kind.left - kind.top * kind.width, 1,
                      static_cast<std::size_t>(kind.width));
  file.writePixels(kind.height);
}

void writeDeep(const std::string& path, const FileKind& kind, bool tiles,
               const std::vector<std::vector<DeepSample>>& samples) {
  Imf::Header header = headerOf(kind);
  header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
  header.channels().insert("A", Imf::Channel(Imf::FLOAT));
  header.channels().insert("R", Imf::Channel(Imf::FLOAT));
  header.setType(tiles ? Imf::DEEPTILE : Imf::DEEPSCANLINE);
  if (tiles) header.setTileDescription(Imf::TileDescription(16, 8));

  const std::size_t width = static_cast<std::size_t>(kind.width);
  std::vector<uint32_t> counts;
  std::vector<const float*> pointers[3];
  for (const auto& pixel : samples) {
    counts.push_back(static_cast<uint32_t>(pixel.size()));
    const DeepSample* const first = pixel.data();
    pointers[0].push_back(first ? &first->z : nullptr);
    pointers[1].push_back(first ? &first->a : nullptr);
    pointers[2].push_back(first ? &first->r : nullptr);
  }
  const std::ptrdiff_t origin = kind.left + static_cast<std::ptrdiff_t>(width) * kind.top;
  Imf::DeepFrameBuffer frame;
  frame.insertSampleCountSlice(Imf::Slice(Imf::UINT,
                                          reinterpret_cast<char*>(counts.data() - origin),
                                          sizeof(uint32_t), sizeof(uint32_t) * width));
  const char* const names[] = {"Z", "A", "R"};
  for (int c = 0; c < 3; ++c) {
    frame.insert(names[c],
                 Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(pointers[c].data() - origin),
                                sizeof(float*), sizeof(float*) * width, sizeof(DeepSample)));
  }
  if (tiles) {
    Imf::DeepTiledOutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  } else {
    Imf::DeepScanLineOutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(kind.height);
  }
}

std::vector<std::vector<DeepSample>> someSamples(const FileKind& kind) {
  std::vector<std::vector<DeepSample>> samples;
  for (int i = 0; i < kind.width * kind.height; ++i) {
    std::vector<DeepSample> pixel;
    for (int s = 0; s < i % 4; ++s) {
      // Not in the order of depth.
      const float z = static_cast<float>((i * 7 + s * 5) % 11);
      pixel.push_back({z, 0.25f * static_cast<float>(s + 1), 0.125f * static_cast<float>(i % 9)});
    }
    samples.push_back(pixel);
  }
  return samples;
}

}  // namespace awd::test
