// SPDX-License-Identifier: Apache-2.0
#include "util/bytes.h"

#include "util/error.h"
#include "util/random.h"

namespace awd {

namespace {

constexpr std::size_t kMagic = 8;
constexpr std::size_t kVersionAt = kMagic;
constexpr std::size_t kLengthAt = kVersionAt + 4;
constexpr std::size_t kChecksumAt = kLengthAt + 8;
constexpr std::size_t kHeader = kChecksumAt + 8;

/// A packed number's byte: so many bits of it, and whether there are more.
constexpr int kPackedBits = 7;
constexpr uint64_t kPackedMore = 1u << kPackedBits;

/// Every bit of the frame but the checksum's own reaches every bit of this.
uint64_t checksum(const char* bytes, std::size_t size) {
  uint64_t sum = mixBits(size);
  uint64_t word = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const bool own = i >= kChecksumAt && i < kHeader;
    word = word << 8 | (own ? 0u : static_cast<unsigned char>(bytes[i]));
    if (i % 8 == 7 || i + 1 == size) {
      sum = mixBits(sum + word + 0x9e3779b97f4a7c15u) ^ (sum << 1 | sum >> 63);
      word = 0;
    }
  }
  return sum;
}

void putAt(std::pmr::vector<char>& bytes, std::size_t at, uint64_t number) {
  for (std::size_t i = 0; i < 8; ++i) bytes[at + i] = static_cast<char>(number >> (8 * i));
}

}  // namespace

ByteWriter::ByteWriter(std::pmr::memory_resource* memory, std::string_view magic, uint32_t version,
                       std::size_t most)
    : bytes_(memory) {
  bytes_.reserve(most);
  bytes_.assign(magic.begin(), magic.begin() + kMagic);
  put(version);
  put(uint64_t{0});
  put(uint64_t{0});
}

void ByteWriter::putText(std::string_view text) {
  put(static_cast<uint32_t>(text.size()));
  bytes_.insert(bytes_.end(), text.begin(), text.end());
}

void ByteWriter::putBytes(const std::pmr::vector<char>& bytes) {
  put(uint64_t{bytes.size()});
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

void ByteWriter::putPacked(uint64_t number) {
  for (; number >= kPackedMore; number >>= kPackedBits) {
    bytes_.push_back(static_cast<char>(number | kPackedMore));
  }
  bytes_.push_back(static_cast<char>(number));
}

std::pmr::vector<char> ByteWriter::finish() {
  putAt(bytes_, kLengthAt, bytes_.size());
  putAt(bytes_, kChecksumAt, checksum(bytes_.data(), bytes_.size()));
  return std::move(bytes_);  // a copy would lie in the memory of the process, not of the host
}

ByteReader::ByteReader(const void* bytes, std::size_t size, std::string_view magic,
                       uint32_t version, const char* what)
    : next_(static_cast<const char*>(bytes)), end_(next_ + size), what_(what) {
  const char* begin = next_;
  if (size < kHeader || magic != std::string_view(begin, kMagic)) {
    fail(AWD_ERROR_IO, "these %zu bytes are not %s", size, what);
  }
  next_ += kMagic;
  const auto theirs = get<uint32_t>();
  if (theirs != version) {
    fail(AWD_ERROR_IO, "%s of version %u: this library reads version %u", what, theirs, version);
  }
  const auto length = get<uint64_t>();
  if (length != size) {
    fail(AWD_ERROR_IO, "%s of %llu bytes: got %zu", what, static_cast<unsigned long long>(length),
         size);
  }
  if (get<uint64_t>() != checksum(begin, size)) {
    fail(AWD_ERROR_IO, "%s is damaged: its checksum is wrong", what);
  }
}

std::string_view ByteReader::getText(std::size_t longest) {
  const auto size = get<uint32_t>();
  if (size > longest) damaged();
  return {take(size), size};
}

std::string_view ByteReader::getBytes() {
  const std::size_t size = getCount(1);
  return {take(size), size};
}

uint64_t ByteReader::getPacked() {
  uint64_t number = 0;
  for (int shift = 0;; shift += kPackedBits) {
    const uint64_t byte = static_cast<unsigned char>(*take(1));
    const uint64_t bits = byte % kPackedMore;
    // Beyond the 64th bit there is nothing, and no number ends in bytes that say nothing.
    if (shift > 63 || bits << shift >> shift != bits || (byte == 0 && shift > 0)) damaged();
    number |= bits << shift;
    if (byte < kPackedMore) return number;
  }
}

std::size_t ByteReader::getCount(std::size_t itemSize) {
  const auto count = get<uint64_t>();
  if (count > static_cast<std::size_t>(end_ - next_) / itemSize) damaged();
  return static_cast<std::size_t>(count);
}

void ByteReader::finish() {
  if (next_ != end_) damaged();
}

void ByteReader::damaged() const {
  fail(AWD_ERROR_IO, "%s is damaged: what it holds makes no sense", what_);
}

const char* ByteReader::take(std::size_t size) {
  if (size > static_cast<std::size_t>(end_ - next_)) damaged();
  const char* from = next_;
  next_ += size;
  return from;
}

}  // namespace awd
