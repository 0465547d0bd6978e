// SPDX-License-Identifier: Apache-2.0
#include "image/exr_read.h"

#include <IexBaseExc.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfRgba.h>
#include <ImfRgbaFile.h>
#include <ImfStringAttribute.h>
#include <ImfTiledInputPart.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>

#include "image/exr_check.h"
#include "image/exr_deep.h"
#include "image/exr_names.h"
#include "util/error.h"
#include "util/file_bytes.h"
#include "util/uncancelled.h"

namespace awd {

namespace {

using Imath::Box2i;

constexpr int kInThisThread = 0;
/// What an image may take whatever the size of its file.
constexpr double kRoomOfAnyFile = 1u << 26;

/// A file in memory. Says that it is mapped if it is deep: OpenEXR then takes chunks where they
/// are, instead of first allocating the size that a damaged file gives them.
class MemoryStream final : public Imf::IStream {
 public:
  MemoryStream(std::pmr::vector<char>& bytes, const char* path, bool deep)
      : IStream(path), bytes_(bytes), deep_(deep) {}

  bool isMemoryMapped() const override { return deep_; }
  char* readMemoryMapped(int count) override { return take(count); }
  bool read(char to[], int count) override {
    std::memcpy(to, take(count), static_cast<std::size_t>(count));
    return position_ < bytes_.size();
  }
  uint64_t tellg() override { return position_; }
  void seekg(uint64_t position) override { position_ = position; }

 private:
  char* take(int count) {
    if (count < 0 || position_ > bytes_.size() ||
        static_cast<uint64_t>(count) > bytes_.size() - position_) {
      throw Iex::InputExc("the file is cut off or damaged");
    }
    char* const taken = bytes_.data() + position_;
    position_ += static_cast<uint64_t>(count);
    return taken;
  }

  std::pmr::vector<char>& bytes_;
  uint64_t position_ = 0;
  const bool deep_;
};

bool isDeep(const Imf::Header& header) {
  return header.hasType() && Imf::isDeepData(header.type());
}

/// Reads channels of a part that is not deep. Subsampled ones go through a smaller buffer first.
void readFlatPart(Imf::MultiPartInputFile& file, int part, const std::vector<ExrPlane>& planes,
                  std::pmr::memory_resource* memory) {
  const Imf::Header& header = file.header(part);
  const Box2i window = header.dataWindow();
  std::vector<Image::Pixels> coarse;
  coarse.reserve(planes.size());
  Imf::FrameBuffer frame;
  for (const ExrPlane& plane : planes) {
    const int width = widthOf(window) / plane.xSampling;
    const int height = heightOf(window) / plane.ySampling;
    float* pixels = plane.pixels;
    if (plane.xSampling != 1 || plane.ySampling != 1) {
      coarse.emplace_back(static_cast<std::size_t>(width) * height, 0.0f, memory);
      pixels = coarse.back().data();
    }
    frame.insert(plane.name, Imf::Slice::Make(Imf::FLOAT, pixels, window, sizeof(float),
                                              sizeof(float) * static_cast<std::size_t>(width),
                                              plane.xSampling, plane.ySampling));
  }
  if (header.hasTileDescription()) {
    Imf::TiledInputPart input(file, part);
    input.setFrameBuffer(frame);
    input.readTiles(0, input.numXTiles(0) - 1, 0, input.numYTiles(0) - 1, 0);
  } else {
    Imf::InputPart input(file, part);
    input.setFrameBuffer(frame);
    input.readPixels(window.min.y, window.max.y);
  }
  auto next = coarse.begin();
  for (const ExrPlane& plane : planes) {
    if (plane.xSampling == 1 && plane.ySampling == 1) continue;
    const std::size_t width = static_cast<std::size_t>(widthOf(window));
    for (int y = 0; y < heightOf(window); ++y) {
      const float* row = next->data() + y / plane.ySampling * (width / plane.xSampling);
      for (std::size_t x = 0; x < width; ++x)
        plane.pixels[y * width + x] = row[x / plane.xSampling];
    }
    ++next;
  }
}

/// The reader of one file.
class Reader {
 public:
  Reader(Context& context, const char* path)
      : context_(context),
        path_(path),
        bytes_(readFile(context.memory(), path)),
        deep_(checkExrHeaders(bytes_.data(), bytes_.size(), path)) {}

  Ref<Image> read() {
    MemoryStream stream(bytes_, path_, deep_);
    constexpr bool kRepairOffsets = false;  // a picture with holes is no picture
    Imf::MultiPartInputFile file(stream, kInThisThread, kRepairOffsets);
    for (int part = 0; part < file.parts(); ++part) {
      if (!file.partComplete(part)) throw Iex::InputExc("the file was not written to its end");
    }
    const Imf::Header& first = file.header(0);
    window_ = first.dataWindow();
    checkRoom(file);
    image_ = Image::make(context_, static_cast<uint32_t>(widthOf(window_)),
                         static_cast<uint32_t>(heightOf(window_)));
    const bool lumaChroma = isLumaChroma(first);
    for (int part = 0; part < file.parts(); ++part) {
      readPart(file, part, part == 0 && lumaChroma);
    }
    if (lumaChroma) readLumaChroma(first);
    readMetadata(first);
    return std::move(image_);
  }

 private:
  /// An image has all of its channels at its full size, however few pixels a part has of them.
  void checkRoom(const Imf::MultiPartInputFile& file) const {
    const double pixels = static_cast<double>(widthOf(window_)) * heightOf(window_);
    // Uncompressed bytes stand for more as well: chroma for four pixels, a deep pixel that is empty
    // for all of its channels.
    double wanted = 0.0, apart = 0.0, possible = 32.0;
    for (int part = 0; part < file.parts(); ++part) {
      const Imf::Header& header = file.header(part);
      const Imf::ChannelList& channels = header.channels();
      double count = 0.0;
      for (auto i = channels.begin(); i != channels.end(); ++i) ++count;
      wanted += count * pixels;
      // A part of another window is read into planes of its own first.
      const Box2i& window = header.dataWindow();
      if (window != window_) {
        apart = std::max(apart, count * static_cast<double>(widthOf(window)) * heightOf(window));
      }
      possible = std::max(possible, largestExrRatio(header.compression()));
    }
    if ((wanted + apart) * sizeof(float) <=
        kRoomOfAnyFile + 2 * possible * static_cast<double>(bytes_.size())) {
      return;
    }
    fail(AWD_ERROR_UNSUPPORTED,
         "can't read \"%s\": its channels would take %.0f bytes, out of all proportion to the "
         "file's %zu",
         path_, (wanted + apart) * sizeof(float), bytes_.size());
  }

  bool isLumaChroma(const Imf::Header& header) const {
    const Imf::Channel* const ry = header.channels().findChannel("RY");
    const Imf::Channel* const by = header.channels().findChannel("BY");
    if (isDeep(header) || !ry || !by || !header.channels().findChannel("Y")) return false;
    if (ry->xSampling != 2 || ry->ySampling != 2 || by->xSampling != 2 || by->ySampling != 2) {
      fail(AWD_ERROR_UNSUPPORTED,
           "can't read \"%s\": its chroma is subsampled by %d x %d; OpenEXR knows 2 x 2", path_,
           ry->xSampling, ry->ySampling);
    }
    return true;
  }

  void readPart(Imf::MultiPartInputFile& file, int part, bool lumaChroma) {
    const Imf::Header& header = file.header(part);
    if (header.hasType() && !Imf::isSupportedType(header.type())) {
      if (part > 0) return;
      fail(AWD_ERROR_UNSUPPORTED, "can't read \"%s\": it is of the unknown type \"%s\"", path_,
           header.type().c_str());
    }
    const Box2i window = header.dataWindow();
    const bool direct = window == window_;
    const std::size_t pixels = static_cast<std::size_t>(widthOf(window)) * heightOf(window);
    std::vector<Image::Pixels> apart;  // of a part whose window is not the image's
    std::vector<ExrPlane> planes;
    std::vector<Image::Pixels*> targets;
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
      const std::string name = i.name();
      if (lumaChroma && (name == "Y" || name == "RY" || name == "BY")) continue;
      targets.push_back(&addChannel(part == 0 ? name : header.name() + "." + name));
      if (!direct) apart.emplace_back(pixels, 0.0f, context_.memory());
      planes.push_back({name, i.channel().xSampling, i.channel().ySampling,
                        direct ? targets.back()->data() : apart.back().data()});
    }
    if (planes.empty()) return;
    if (isDeep(header)) {
      const double room =
          static_cast<double>(bytes_.size()) * 2 * largestExrRatio(header.compression());
      readDeepPart(file, part, planes, room, context_.memory());
    } else {
      readFlatPart(file, part, planes, context_.memory());
    }
    for (std::size_t c = 0; c < apart.size(); ++c) place(apart[c], window, *targets[c]);
  }

  Image::Pixels& addChannel(const std::string& name) {
    if (image_->channel(name)) {
      fail(AWD_ERROR_UNSUPPORTED, "can't read \"%s\": two of its channels are called \"%.80s\"",
           path_, name.c_str());
    }
    return image_->addChannel(name);
  }

  /// Copies what lies inside of the image.
  void place(const Image::Pixels& from, const Box2i& window, Image::Pixels& to) const {
    const int left = std::max(window.min.x, window_.min.x);
    const int right = std::min(window.max.x, window_.max.x);
    if (left > right) return;
    const int bottom = std::min(window.max.y, window_.max.y);
    for (int y = std::max(window.min.y, window_.min.y); y <= bottom; ++y) {
      const float* row = from.data() +
                         static_cast<std::size_t>(y - window.min.y) * widthOf(window) +
                         (left - window.min.x);
      std::copy(row, row + (right - left + 1),
                to.data() + static_cast<std::size_t>(y - window_.min.y) * widthOf(window_) +
                    (left - window_.min.x));
    }
  }

  /// With OpenEXR's own filter for the chroma, and so with its precision, which is half.
  void readLumaChroma(const Imf::Header& header) {
    MemoryStream stream(bytes_, path_, deep_);
    Imf::RgbaInputFile input(stream, kInThisThread);
    const std::size_t width = image_->width();
    std::pmr::vector<Imf::Rgba> row(width, context_.memory());
    float* red = image_->addChannel("R").data();
    float* green = image_->addChannel("G").data();
    float* blue = image_->addChannel("B").data();
    const Box2i& window = header.dataWindow();
    // Pixel (0, 0), which may lie outside of the array.
    const std::intptr_t origin = reinterpret_cast<std::intptr_t>(row.data()) -
                                 static_cast<std::intptr_t>(sizeof(Imf::Rgba)) * window.min.x;
    input.setFrameBuffer(reinterpret_cast<Imf::Rgba*>(origin), 1, 0);
    for (int y = window.min.y; y <= window.max.y; ++y) {
      input.readPixels(y);
      for (const Imf::Rgba& pixel : row) {
        *red++ = pixel.r;
        *green++ = pixel.g;
        *blue++ = pixel.b;
      }
    }
  }

  void readMetadata(const Imf::Header& header) {
    for (auto i = header.begin(); i != header.end(); ++i) {
      const auto* text = dynamic_cast<const Imf::StringAttribute*>(&i.attribute());
      if (text && !isReservedAttribute(i.name())) image_->addMetadata(i.name(), text->value());
    }
  }

  Context& context_;
  const char* const path_;
  std::pmr::vector<char> bytes_;
  const bool deep_;
  Box2i window_;
  Ref<Image> image_;
};

}  // namespace

Ref<Image> readExr(Context& context, const char* path) {
  const Uncancelled uncancelled;
  Reader reader(context, path);
  try {
    return reader.read();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    fail(AWD_ERROR_IO, "can't read \"%s\": %s", path, error.what());
  }
}

}  // namespace awd
