// SPDX-License-Identifier: Apache-2.0
#include "image/exr_check.h"

#include <ImfCompression.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "image/image.h"
#include "util/error.h"

namespace awd {

namespace {

constexpr int32_t kMagic = 20000630;
constexpr int32_t kVersionMask = 0xFF, kNewestVersion = 2, kMultiPart = 0x1000;
constexpr double kTileRoom = 64e6;  // bytes of one tile that are fine in any file

/// Reads what it is asked for or throws.
class Cursor {
 public:
  Cursor(const char* begin, const char* end, const char* path)
      : next_(begin), end_(end), path_(path) {}

  [[noreturn]] void damaged(const char* reason) const {
    fail(AWD_ERROR_IO, "can't read \"%s\": %s", path_, reason);
  }
  const char* path() const { return path_; }
  bool atEnd() const { return next_ == end_; }
  std::size_t left() const { return static_cast<std::size_t>(end_ - next_); }

  const char* take(std::size_t count) {
    if (count > left()) damaged("the file is cut off or its header is damaged");
    const char* const taken = next_;
    next_ += count;
    return taken;
  }
  uint8_t byte() { return static_cast<uint8_t>(*take(1)); }
  int32_t integer() {
    const auto* b = reinterpret_cast<const unsigned char*>(take(4));
    return static_cast<int32_t>(uint32_t{b[0]} | uint32_t{b[1]} << 8 | uint32_t{b[2]} << 16 |
                                uint32_t{b[3]} << 24);
  }
  /// A size or count.
  std::size_t natural() {
    const int32_t value = integer();
    if (value < 0) damaged("a size in its header is negative");
    return static_cast<std::size_t>(value);
  }
  std::string_view text() {
    const void* const zero = std::memchr(next_, 0, left());
    if (!zero) damaged("the file is cut off in its header");
    const std::size_t length = static_cast<std::size_t>(static_cast<const char*>(zero) - next_);
    return {take(length + 1), length};
  }
  Cursor sub(std::size_t count) {
    const char* const begin = take(count);
    return {begin, begin + count, path_};
  }

 private:
  const char* next_;
  const char* end_;
  const char* path_;
};

/// What one header says about sizes.
struct Claim {
  bool channels = false, compression = false, window = false, tiled = false, deep = false;
  double width = 0, height = 0;          // data window
  double tileWidth = 0, tileHeight = 0;  // of a tiled part
  double chunks = 0;
  double pixelBytes = 0;  // of all channels, uncompressed
  int compressionNumber = 0;
};

void readChannels(Cursor value, Claim& claim) {
  while (!value.text().empty()) {
    const int32_t type = value.integer();
    value.take(4);
    const double xSampling = value.integer(), ySampling = value.integer();
    if (xSampling < 1 || ySampling < 1) value.damaged("a channel's subsampling is not positive");
    // In memory a subsampled channel takes as much as any: no more than chroma's 2 x 2 is believed.
    claim.pixelBytes += (type == 1 ? 2.0 : 4.0) / std::min(xSampling * ySampling, 4.0);
  }
  if (!value.atEnd()) value.damaged("its list of channels has a wrong size");
}

void readWindow(Cursor value, Claim& claim) {
  const double left = value.integer(), top = value.integer();
  const double right = value.integer(), bottom = value.integer();
  claim.width = right - left + 1;
  claim.height = bottom - top + 1;
  if (claim.width < 1 || claim.height < 1) value.damaged("its data window is empty");
  if (claim.width > kLongestImageAxis || claim.height > kLongestImageAxis) {
    fail(AWD_ERROR_UNSUPPORTED,
         "can't read \"%s\": its data window is %.0f x %.0f pixels, more than %u along an axis",
         value.path(), claim.width, claim.height, kLongestImageAxis);
  }
}

/// OpenEXR reads as much as the type wants, not as much as the header says: where these differ,
/// what comes next would be read as something else.
void checkSize(std::string_view type, const Cursor& value) {
  struct Size {
    std::string_view type;
    std::size_t bytes;
  };
  static constexpr Size kSizes[] = {{"box2i", 16},
                                    {"box2f", 16},
                                    {"chromaticities", 32},
                                    {"compression", 1},
                                    {"double", 8},
                                    {"envmap", 1},
                                    {"deepImageState", 1},
                                    {"float", 4},
                                    {"int", 4},
                                    {"keycode", 28},
                                    {"lineOrder", 1},
                                    {"m33f", 36},
                                    {"m33d", 72},
                                    {"m44f", 64},
                                    {"m44d", 128},
                                    {"rational", 8},
                                    {"tiledesc", 9},
                                    {"timecode", 8},
                                    {"v2i", 8},
                                    {"v2f", 8},
                                    {"v2d", 16},
                                    {"v3i", 12},
                                    {"v3f", 12},
                                    {"v3d", 24}};
  for (const Size& size : kSizes) {
    if (type == size.type && value.left() != size.bytes) {
      value.damaged("an attribute in its header has a wrong size");
    }
  }
  if (type == "floatvector" && value.left() % sizeof(float) != 0) {
    value.damaged("an attribute in its header has a wrong size");
  }
}

void readAttribute(std::string_view name, std::string_view type, Cursor value, Claim& claim) {
  checkSize(type, value);
  if (name == "channels" && type == "chlist") {
    claim.channels = true;
    readChannels(value, claim);
  } else if (name == "compression" && type == "compression") {
    claim.compression = true;
    claim.compressionNumber = value.byte();
  } else if (name == "dataWindow" && type == "box2i") {
    claim.window = true;
    readWindow(value, claim);
  } else if (name == "tiles" && type == "tiledesc") {
    claim.tiled = true;
    claim.tileWidth = static_cast<uint32_t>(value.integer());
    claim.tileHeight = static_cast<uint32_t>(value.integer());
    if (claim.tileWidth < 1 || claim.tileHeight < 1) value.damaged("its tiles are empty");
  } else if (name == "type" && type == "string") {
    claim.deep = value.left() >= 4 && std::memcmp(value.take(4), "deep", 4) == 0;
  } else if (name == "chunkCount" && type == "int") {
    claim.chunks = static_cast<double>(value.natural());
  } else if (type == "preview") {
    const double width = value.integer(), height = value.integer();
    if (width < 0 || height < 0 || width * height * 4 != static_cast<double>(value.left())) {
      value.damaged("its preview has a wrong size");
    }
  } else if (type == "stringvector") {
    while (!value.atEnd()) value.take(value.natural());
  }
}

void checkClaim(const Cursor& file, Claim claim, double fileSize) {
  if (!claim.channels || !claim.compression || !claim.window) {
    file.damaged("a header lacks its channels, compression or data window");
  }
  if (claim.tiled) {
    const double tiles = std::max(1.0, claim.width / claim.tileWidth) *
                         std::max(1.0, claim.height / claim.tileHeight);
    claim.chunks = std::max(claim.chunks, tiles);
  }
  // Deep pixels may hold no sample at all: of them only the counts are certain.
  if (claim.deep) claim.pixelBytes = sizeof(uint32_t);
  const double bytes = claim.width * claim.height * claim.pixelBytes;
  const double tileBytes = claim.tileWidth * claim.tileHeight * claim.pixelBytes;
  if (bytes > fileSize * largestExrRatio(claim.compressionNumber) ||
      claim.chunks * sizeof(uint64_t) > fileSize || tileBytes > std::max(kTileRoom, 4 * bytes)) {
    fail(AWD_ERROR_IO,
         "can't read \"%s\": a header claims %.0f x %.0f pixels, more than %.0f bytes can hold: "
         "the file is cut off or damaged",
         file.path(), claim.width, claim.height, fileSize);
  }
}

}  // namespace

double largestExrRatio(int compression) {
  // Deflate stands for 1032 bytes a byte at most, run lengths for 64, Huffman codes with run
  // lengths for about 400. PXR24 deflates three of a float's four bytes. DWA keeps one 16 bit
  // number of an empty block of 64 pixels, deflated, and deflates run lengths. Rounded up, since
  // this is to catch the absurd.
  switch (compression) {
    case Imf::NO_COMPRESSION:
      return 1;
    case Imf::RLE_COMPRESSION:
      return 64;
    case Imf::PIZ_COMPRESSION:
      return 1024;
    case Imf::B44_COMPRESSION:
    case Imf::B44A_COMPRESSION:
      return 16;
    case Imf::DWAA_COMPRESSION:
    case Imf::DWAB_COMPRESSION:
      return 131072;
    default:
      return 2048;
  }
}

bool checkExrHeaders(const char* bytes, std::size_t size, const char* path) {
  Cursor file(bytes, bytes + size, path);
  if (size == 0) file.damaged("the file is empty");
  if (size < 8 || file.integer() != kMagic) file.damaged("it is not an OpenEXR file");
  const int32_t version = file.integer();
  if ((version & kVersionMask) > kNewestVersion) {
    fail(AWD_ERROR_UNSUPPORTED, "can't read \"%s\": it is of version %d of OpenEXR, newer than %d",
         path, version & kVersionMask, kNewestVersion);
  }
  bool deep = false;
  do {
    Claim claim;
    for (std::string_view name = file.text(); !name.empty(); name = file.text()) {
      const std::string_view type = file.text();
      readAttribute(name, type, file.sub(file.natural()), claim);
    }
    checkClaim(file, claim, static_cast<double>(size));
    deep |= claim.deep;
    // Another header follows in a file of several parts, or an empty one, which ends them.
  } while ((version & kMultiPart) != 0 && file.left() > 0 && *file.take(0) != 0);
  return deep;
}

}  // namespace awd
