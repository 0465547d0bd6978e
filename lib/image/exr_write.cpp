// SPDX-License-Identifier: Apache-2.0
#include "image/exr_write.h"

#include <IexBaseExc.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "util/atomic_file.h"
#include "util/error.h"

namespace awd {

namespace {

/// OpenEXR writes its table of offsets in a destructor, which swallows exceptions. So the first
/// failure is kept here, and whoever owns the stream asks for it.
class AtomicStream final : public Imf::OStream {
 public:
  explicit AtomicStream(AtomicFile& file) : OStream(file.path().c_str()), file_(file) {}

  void write(const char bytes[], int count) override {
    attempt([&] { file_.write(bytes, static_cast<std::size_t>(count)); });
  }
  uint64_t tellp() override { return file_.position(); }
  void seekp(uint64_t position) override {
    attempt([&] { file_.seek(position); });
  }

  void throwIfFailed() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  template <class Action>
  void attempt(Action&& action) {
    try {
      throwIfFailed();
      action();
    } catch (const Error& error) {
      failure_ = std::current_exception();
      throw Iex::IoExc(error.what());  // OpenEXR tidies up after its own kind
    }
  }

  AtomicFile& file_;
  std::exception_ptr failure_;
};

/// OpenEXR would cut it off, and take two that begin alike for one.
void checkLength(std::string_view name, const char* path) {
  constexpr std::size_t kLongest = 255;
  if (name.size() <= kLongest) return;
  fail(
      AWD_ERROR_UNSUPPORTED,
      "can't write \"%s\": the image has a name of %zu characters, \"%.40s...\"; OpenEXR takes %zu",
      path, name.size(), std::string(name).c_str(), kLongest);
}

Imf::Header makeHeader(const Image& image) {
  constexpr float kPixelAspectRatio = 1.0f, kScreenWindowWidth = 1.0f;
  Imf::Header header(static_cast<int>(image.width()), static_cast<int>(image.height()),
                     kPixelAspectRatio, Imath::V2f(0.0f), kScreenWindowWidth, Imf::INCREASING_Y,
                     Imf::ZIP_COMPRESSION);
  for (const auto& [name, pixels] : image.channels()) {
    header.channels().insert(name.c_str(), Imf::Channel(Imf::FLOAT));
  }
  for (const auto& [key, value] : image.metadata()) {
    header.insert(key.c_str(), Imf::StringAttribute(std::string(value)));
  }
  return header;
}

Imf::FrameBuffer makeFrameBuffer(const Image& image) {
  Imf::FrameBuffer frame;
  for (const auto& [name, pixels] : image.channels()) {
    frame.insert(name.c_str(), Imf::Slice::Make(Imf::FLOAT, pixels.data(), Imath::V2i(0, 0),
                                                image.width(), image.height()));
  }
  return frame;
}

}  // namespace

void writeExr(const Image& image, const char* path) {
  if (image.channels().empty()) {
    fail(AWD_ERROR_INVALID_OPERATION,
         "the image has no channel to write to \"%s\": set one with awdSetImageChannel", path);
  }
  for (const auto& [name, pixels] : image.channels()) checkLength(name, path);
  for (const auto& [key, value] : image.metadata()) checkLength(key, path);
  AtomicFile file(path);
  AtomicStream stream(file);
  try {
    constexpr int kOtherThreads = 0;
    Imf::OutputFile output(stream, makeHeader(image), kOtherThreads);
    output.setFrameBuffer(makeFrameBuffer(image));
    output.writePixels(static_cast<int>(image.height()));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    stream.throwIfFailed();
    fail(AWD_ERROR_IO, "can't write \"%s\": %s", path, error.what());
  }
  stream.throwIfFailed();
  file.commit();
}

}  // namespace awd
