// SPDX-License-Identifier: Apache-2.0
// OpenEXR files of every kind, written by OpenEXR itself.
#pragma once

#include <ImfCompression.h>
#include <ImfLineOrder.h>
#include <ImfPixelType.h>
#include <ImfTileDescription.h>

#include <string>
#include <vector>

namespace awd::test {

/// A smooth picture around 0.5; what each pixel (x, y) of channel c of an EXR file of ours is. Half
/// floats hold it exactly.
float smooth(int x, int y, int channel);

struct FileKind {
  Imf::Compression compression = Imf::ZIP_COMPRESSION;
  Imf::PixelType type = Imf::FLOAT;
  Imf::LineOrder order = Imf::INCREASING_Y;
  int left = 0, top = 0, width = 37, height = 23;
  bool black = false;  // instead of smooth()
};

const std::vector<Imf::Compression>& compressions();

/// Channels R (0), G (1) and B (2) of smooth(); uints are 1000 times as large.
void writeScanlines(const std::string& path, const FileKind& kind);
void writeTiles(const std::string& path, const FileKind& kind, Imf::LevelMode mode);
/// Three parts of channel Y: "first" scanlines (channel 0), "second" tiles (1), and "third"
/// scanlines of half the width and height, 5 pixels right of and below the first's corner (2).
void writeParts(const std::string& path, const FileKind& kind);
/// Two parts of one channel and one pixel each, by the names of part and channel.
void writeTwoParts(const std::string& path, const char* const names[2][2]);
/// Of so many pixels along both axes one is there.
void writeSubsampled(const std::string& path, int size);
/// RGB as luminance and chroma.
void writeLumaChroma(const std::string& path, const FileKind& kind, bool alpha);

/// One sample of a deep pixel.
struct DeepSample {
  float z, a, r;
};
/// Channels Z, A and R (float) as `samples` says for each pixel, row by row.
void writeDeep(const std::string& path, const FileKind& kind, bool tiles,
               const std::vector<std::vector<DeepSample>>& samples);
/// 0 to 3 samples a pixel.
std::vector<std::vector<DeepSample>> someSamples(const FileKind& kind);

}  // namespace awd::test
