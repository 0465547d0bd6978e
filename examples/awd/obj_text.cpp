// SPDX-License-Identifier: Apache-2.0
#include "obj_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <string_view>

#include "console.h"
#include "failure.h"
#include "regular_file.h"

namespace command {
namespace {

constexpr char kBlanks[] = " \t\r\v\f";
constexpr std::string_view kMark = "\xEF\xBB\xBF";  // of UTF-8

/// Lines of a file, joined where one ends in a backslash.
class Lines {
 public:
  explicit Lines(const std::string& path) : path_(path), file_(path) {
    if (!file_) throw Failure("can't read " + inQuotes(path));
  }

  bool next() {
    text_.clear();
    for (std::string part; std::getline(file_, part);) {
      ++number_;
      if (number_ == 1 && part.compare(0, kMark.size(), kMark) == 0) {
        part.erase(0, kMark.size());
        marked_ = true;
      }
      while (!part.empty() && part.back() == '\r') part.pop_back();
      const bool goesOn = !part.empty() && part.back() == '\\';
      if (goesOn) part.back() = ' ';
      text_ += part;
      if (!goesOn) break;
    }
    if (file_.eof() && text_.empty()) return false;
    rest_ = text_;
    commented_ = false;
    return true;
  }

  /// Whether blanks stand before the first word of the line.
  bool isIndented() const { return !text_.empty() && text_.find_first_of(kBlanks) == 0; }
  /// Whether word() has met a comment on the line.
  bool isCommented() const { return commented_; }
  /// Whether the file begins with a byte order mark, which is passed over.
  bool isMarked() const { return marked_; }

  /// The next word of the line; empty at its end or at a comment.
  std::string_view word() {
    const std::size_t begin = std::min(rest_.find_first_not_of(kBlanks), rest_.size());
    rest_.remove_prefix(begin);
    if (!rest_.empty() && rest_.front() == '#') {
      commented_ = true;
      rest_ = {};
    }
    const std::size_t end = std::min(rest_.find_first_of(kBlanks), rest_.size());
    const std::string_view found = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return found;
  }

  /// What is left of the line, which may be a name with blanks in it.
  std::string remainder() const {
    const std::size_t begin = rest_.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return "";
    return std::string(rest_.substr(begin, rest_.find_last_not_of(kBlanks) - begin + 1));
  }

  [[noreturn]] void fail(const std::string& reason) const { fail(number_, reason); }
  [[noreturn]] void fail(std::size_t line, const std::string& reason) const {
    throw Failure(path_ + ":" + std::to_string(line) + ": " + reason);
  }
  std::size_t number() const { return number_; }

 private:
  std::string path_;
  std::ifstream file_;
  std::string text_;
  std::string_view rest_;
  std::size_t number_ = 0;
  bool commented_ = false, marked_ = false;
};

/// A word of the line as a number that a float can hold.
float toNumber(const Lines& lines, const char* what, std::string_view word) {
  if (word.empty()) lines.fail(std::string(what) + " has too few numbers");
  std::string_view digits = word;
  if (digits.front() == '+') digits.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) {
    lines.fail(std::string(what) + " has " + inQuotes(std::string(word)) +
               " where a number should be");
  }
  // Out of a double's range: either as good as 0, or infinite.
  if (error == std::errc::result_out_of_range) {
    value = std::strtod(std::string(digits).c_str(), nullptr);
  }
  if (!(std::abs(value) <= std::numeric_limits<float>::max())) {
    lines.fail(std::string(what) + " has " + inQuotes(std::string(word)) +
               ", which is no finite number");
  }
  return static_cast<float>(value);
}

class ObjText {
 public:
  explicit ObjText(const std::string& path) : path_(path), lines_(path) {}

  std::map<std::string, Material> run() {
    while (lines_.next()) {
      const std::string_view key = lines_.word();
      if (key == "v") {
        checkVertex();
      } else if (key == "f") {
        checkFace();
      } else if (key == "mtllib") {
        readLibraries(lines_.remainder());
      }
    }
    if (highest_ > vertices_) {
      lines_.fail(highestLine_, "face uses vertex " + std::to_string(highest_) + " of " +
                                    std::to_string(vertices_));
    }
    return std::move(materials_);
  }

 private:
  void checkVertex() {
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = lines_.word();
      toNumber(lines_, "vertex", word);
      // Assimp would pass over the vertex, and all that come later would move up.
      if (word.front() == '.') {
        lines_.fail("vertex has " + inQuotes(std::string(word)) + ", which can't be read: write " +
                    inQuotes('0' + std::string(word)));
      }
    }
    ++vertices_;
  }

  void checkFace() {
    int corners = 0;
    for (std::string_view word = lines_.word(); !word.empty(); word = lines_.word()) {
      ++corners;
      int64_t index = 0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
      const bool whole = end == word.data() + word.size() || *end == '/';
      if (error != std::errc() || !whole || index == 0) {
        lines_.fail("face has " + inQuotes(std::string(word)) + " where an index should be");
      }
      if (index < 0 && index < -static_cast<int64_t>(vertices_)) {
        lines_.fail("face uses vertex " + std::to_string(index) + " of the " +
                    std::to_string(vertices_) + " so far");
      }
      // A positive index may also mean a vertex that comes later.
      if (index > 0 && static_cast<uint64_t>(index) > highest_) {
        highest_ = static_cast<uint64_t>(index);
        highestLine_ = lines_.number();
      }
    }
    if (corners < 3) {
      lines_.fail("face of " + std::to_string(corners) + (corners == 1 ? " vertex" : " vertices") +
                  ": at least 3 are needed");
    }
  }

  /// One file whose name may hold blanks, or else several.
  void readLibraries(const std::string& names) {
    const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
    if (isRegularFile(folder / names)) {
      readLibrary((folder / names).string());
      return;
    }
    std::istringstream words(names);
    for (std::string name; words >> name;) {
      if (isRegularFile(folder / name)) {
        readLibrary((folder / name).string());
      } else {
        warn(path_ + ": can't read material library " + inQuotes(name));
      }
    }
  }

  void readLibrary(const std::string& path) {
    Lines lines(path);
    bool textured = false;
    Material* material = nullptr;
    while (lines.next()) {
      const std::string_view key = lines.word();
      if (key == "newmtl") {
        const std::string name = lines.remainder();
        material = &(materials_[name] = undefinedMaterial(name));
      } else if (key == "Kd" || key == "Ke") {
        if (!material) lines.fail(std::string(key) + " comes before the first newmtl");
        const std::string what = std::string(key) + " of material " + inQuotes(material->name);
        for (float& channel : key == "Kd" ? material->albedo : material->emission) {
          channel = toNumber(lines, what.c_str(), lines.word());
        }
      } else {
        textured |= key == "map_Kd" || key == "map_Ke";
      }
    }
    if (textured) warn(path + ": textures are ignored");
  }

  std::string path_;
  Lines lines_;
  std::map<std::string, Material> materials_;
  uint64_t vertices_ = 0, highest_ = 0;
  std::size_t highestLine_ = 0;
};

/// Keys that numbers follow, and no name that might have a # in it.
bool hasNumbers(std::string_view key) {
  static constexpr std::string_view kKeys[] = {"v", "vn", "vt", "vp", "f", "l", "p"};
  return std::find(std::begin(kKeys), std::end(kKeys), key) != std::end(kKeys);
}

/// Whether Assimp would misread the file: it takes no line that is indented, and comments after
/// numbers for more of them.
bool isMisread(const std::string& path) {
  Lines lines(path);
  while (lines.next()) {
    if (lines.isMarked()) return true;
    const std::string_view key = lines.word();
    if (key.empty()) continue;
    if (lines.isIndented()) return true;
    if (!hasNumbers(key)) continue;
    while (!lines.word().empty()) {
    }
    if (lines.isCommented()) return true;
  }
  return false;
}

}  // namespace

std::optional<std::string> plainObjText(const std::string& path) {
  if (!isMisread(path)) return std::nullopt;
  Lines lines(path);
  std::string text;
  while (lines.next()) {
    const std::string_view key = lines.word();
    text += key;
    if (hasNumbers(key)) {
      for (std::string_view word = lines.word(); !word.empty(); word = lines.word()) {
        text.append(" ").append(word);
      }
    } else if (!key.empty()) {
      text += ' ' + lines.remainder();
    }
    text += '\n';
  }
  return text;
}

std::map<std::string, Material> readObjText(const std::string& path) { return ObjText(path).run(); }

Material undefinedMaterial(const std::string& name) { return {name, {0.6f, 0.6f, 0.6f}, {}}; }

}  // namespace command
