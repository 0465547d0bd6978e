// SPDX-License-Identifier: Apache-2.0
// Makes the arguments of one call, good or wild, keeps its text, and judges what came of it.
#pragma once

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "misuse/world.h"
#include "support/guarded.h"
#include "support/random.h"

namespace awdmisuse {

/// The arguments of a call, made from left to right.
template <class... T>
struct Args {
  explicit Args(T... made) : values(made...) {}
  std::tuple<T...> values;
};

class Caller {
 public:
  enum class Mode { kGood, kWild };
  static constexpr int kNone = -1, kAll = -2;

  /// null: which of the pointers is NULL, counted from 0; good ones otherwise.
  Caller(World& world, uint64_t seed, Mode mode, int null = kNone)
      : world_(world), random_(seed), mode_(mode), null_(null) {}

  // --- what a table of functions says of an argument --------------------------------------------

  template <class T>
  T handle() {
    auto& pool = world_.pool<T>();
    T chosen = nullptr;
    // Good calls take the first of each kind, which belong together.
    const size_t index = wild() && !pool.empty() ? random_.bits() % pool.size() : first_;
    if (!pool.empty()) chosen = pool[index];
    return pointer(chosen, false, kindOf(chosen) + "[" + std::to_string(index) + "]");
  }
  AWDDevice device() { return handle<AWDDevice>(); }
  AWDScene scene() { return handle<AWDScene>(); }
  AWDField field() { return handle<AWDField>(); }
  AWDDensity density() { return handle<AWDDensity>(); }
  AWDRender render() { return handle<AWDRender>(); }
  AWDImage image() { return handle<AWDImage>(); }
  /// The `index`-th of its kind in good calls from here on.
  Caller& first(size_t index) {
    first_ = index;
    return *this;
  }
  template <class T>
  T optional(T handle) {
    allowNull();
    return handle;
  }
  /// Where a handle goes; what was made is the world's.
  template <class T>
  T* made() {
    T* out = reinterpret_cast<T*>(room(sizeof(T), 0xab));
    outputs_.push_back([this, out](bool done, bool given) {
      if (!given) return;
      if (done && *out) world_.pool<T>().push_back(*out);
      if (!done && *out) complain("a handle output is not NULL after a failure");
    });
    return pointer(out, false, "&made");
  }

  /// `count` items that end where memory does; wild ones are sometimes NULL.
  template <class T>
  const T* in(size_t count, const std::function<T()>& item, bool mayBeNull = false) {
    T* items = reinterpret_cast<T*>(room(count * sizeof(T), 0));
    for (size_t i = 0; i < count; ++i) items[i] = item();
    return pointer(static_cast<const T*>(items), mayBeNull, textOf(items, count));
  }
  /// What is already there.
  template <class T>
  T* given(T* there) {
    return pointer(there, false, "&module");
  }
  template <class T>
  T* out(size_t count, bool mayBeNull = false) {
    return pointer(reinterpret_cast<T*>(room(count * sizeof(T), 0xcd)), mayBeNull,
                   "out of " + std::to_string(count));
  }
  /// A struct that begins with structSize, filled by fill(), which may spoil() its fields.
  template <class T>
  const T* desc(T value, const std::function<void(T&)>& fill, bool mayBeNull = false) {
    const T good = value;
    fill(value);
    const std::string spoilt = differences(&good, &value, sizeof value);
    return pointer(static_cast<const T*>(sized(value)), mayBeNull, "&desc" + spoilt);
  }
  template <class T>
  T* outStruct(T value, bool mayBeNull = false) {
    return pointer(sized(value), mayBeNull, "&struct");
  }
  const char* text(const std::string& good, const std::vector<std::string>& wilder,
                   bool mayBeNull = false);
  /// Of a file to be read, or to be written. No call reads what another has written.
  const char* path(const std::string& good) {
    return text(good, {"", "name", "/nowhere/name", world_.folder.path(""), world_.rubbishFile,
                       world_.fieldFile, world_.renderFile, world_.imageFile, longPath()});
  }
  const char* outPath() {
    return text(world_.folder.path("out"),
                {"", "written", "/nowhere/name", world_.folder.path(""), longPath()});
  }
  template <class T>
  const T* bytes(const std::vector<T>& good, size_t& count) {
    std::vector<T> spoilt = good;
    if (wild() && oneOf(2) == 0) spoilt.resize(oneOf(static_cast<uint32_t>(good.size()) + 9));
    if (wild() && !spoilt.empty() && oneOf(2) == 0) {
      spoilt[random_.bits() % spoilt.size()] ^= static_cast<T>(1u << oneOf(8));
    }
    count = spoilt.size();
    size_t i = 0;
    return in<T>(count, [&] { return spoilt[i++]; });
  }

  template <class T>
  T number(T good) {
    return note(wild() ? wildNumber(good) : good);
  }
  /// Of those that take time or memory: the good one, 0, or one of these.
  template <class T>
  T number(T good, const std::vector<T>& wilder) {
    return note(wild() && oneOf(2) == 0 ? wilder[random_.bits() % wilder.size()] : good);
  }
  /// So many items that there is room for.
  size_t count(size_t most) { return note(wild() ? random_.bits() % (most + 1) : most); }
  uint32_t patch() {
    return number<uint32_t>(0, {0, 1, 8, 9, 100, 0x7ffffffeu, 0x7fffffffu, AWD_PATCH_BACK,
                                AWD_PATCH_BACK | 8u, AWD_INVALID_ID});
  }
  double uniform() { return wild() && oneOf(20) == 0 ? wildNumber(0.5) : random_.uniform(); }
  float coordinate() {
    const float good = static_cast<float>(random_.uniform());
    return wild() && oneOf(40) == 0 ? wildNumber(good) : good;
  }
  /// Three floats each: unit vectors, but for a few.
  const float* units(size_t count) {
    size_t i = 0;
    const size_t axis = wild() ? oneOf(3) : 2;
    return in<float>(3 * count, [&] {
      const float good = i++ % 3 == axis ? 1.0f : 0.0f;
      return wild() && oneOf(40) == 0 ? wildNumber(good) : good;
    });
  }
  const float* places(size_t count) {
    return in<float>(3 * count, [&] { return coordinate(); });
  }
  const double* uniforms(size_t count) {
    return in<double>(count, [&] { return uniform(); });
  }
  /// Spoils a field of a struct now and then.
  template <class T>
  void spoil(T& field) {
    if (wild() && oneOf(8) == 0) field = wildNumber(field);
  }
  template <class T>
  void spoil(T& field, const std::vector<T>& wilder) {
    if (wild() && oneOf(6) == 0) field = wilder[random_.bits() % wilder.size()];
  }

  bool wild() const { return mode_ == Mode::kWild; }
  uint32_t oneOf(uint32_t n) { return static_cast<uint32_t>(random_.bits() % n); }
  World& world() { return world_; }

  // --- the call ---------------------------------------------------------------------------------

  template <class R, class... P, class... T>
  void operator()(R (*function)(P...) noexcept, Args<T...> arguments) {
    static_assert(sizeof...(P) == sizeof...(T));
    begin();
    if constexpr (std::is_same_v<R, void>) {
      std::apply(function, arguments.values);
      finish(AWD_SUCCESS);
    } else if constexpr (std::is_same_v<R, const char*>) {
      if (!std::apply(function, arguments.values)) complain("returned NULL");
      finish(AWD_SUCCESS);
    } else if constexpr (std::is_same_v<R, uint32_t>) {
      if (std::apply(function, arguments.values) == 0) complain("returned 0");
      finish(AWD_SUCCESS);
    } else {
      finish(std::apply(function, arguments.values));
    }
  }
  /// A Retain function; the reference is the world's.
  template <class T>
  void retained(void (*function)(T) noexcept) {
    const T object = optional(handle<T>());
    (*this)(function, Args{object});
    if (object) world_.pool<T>().push_back(object);
  }
  /// A Release function of one of the world's references, while there are others of its kind.
  template <class T>
  void released(void (*function)(T) noexcept) {
    auto& pool = world_.pool<T>();
    T object = pool.size() < 3 ? nullptr : pool.back();
    if (object && wild()) {
      std::swap(pool[2 + random_.bits() % (pool.size() - 2)], pool.back());
      object = pool.back();
    }
    object = pointer(object, true, kindOf(object) + " of " + std::to_string(pool.size()));
    if (object) pool.pop_back();
    (*this)(function, Args{object});
  }

  // --- what came of it --------------------------------------------------------------------------

  void named(const char* name) { name_ = name; }
  AWDResult result() const { return result_; }
  /// "" if all is well.
  const std::string& complaint() const { return complaint_; }
  /// As in C, but for what pointers point to, which has its kind and size.
  std::string text() const { return name_ + "(" + texts_ + ")"; }
  /// Of the pointers so far: whether NULL may be.
  const std::vector<bool>& pointers() const { return mayBeNull_; }
  /// Called when all arguments are made.
  void onBegin(std::function<void(const std::string&)> tell) { tell_ = std::move(tell); }

 private:
  void begin() {
    world_.cancelAfter = wild() && oneOf(6) == 0 ? static_cast<long>(oneOf(5)) : -1;
    if (tell_) tell_(text());
  }
  void finish(AWDResult result);
  void complain(const std::string& what) {
    if (complaint_.empty()) complaint_ = what;
  }
  void allowNull() { mayBeNull_.back() = true; }
  bool chooseNull(int index) {
    return null_ == kAll || null_ == index || (wild() && oneOf(30) == 0);
  }
  template <class T>
  T pointer(T value, bool mayBeNull, const std::string& meaning) {
    const bool null = chooseNull(static_cast<int>(mayBeNull_.size()));
    mayBeNull_.push_back(mayBeNull);
    if (null) value = nullptr;
    // Outputs are judged only if there were any.
    if (!outputs_.empty() && outputs_.size() > judged_.size()) judged_.push_back(value != nullptr);
    describe(value ? meaning : "NULL");
    return value;
  }
  void describe(const std::string& argument) { texts_ += (texts_.empty() ? "" : ", ") + argument; }
  template <class T>
  T note(T value) {
    describe(std::to_string(value));
    return value;
  }
  static std::string kindOf(AWDDevice) { return "device"; }
  static std::string kindOf(AWDScene) { return "scene"; }
  static std::string kindOf(AWDField) { return "field"; }
  static std::string kindOf(AWDDensity) { return "density"; }
  static std::string kindOf(AWDRender) { return "render"; }
  static std::string kindOf(AWDImage) { return "image"; }
  template <class T>
  static std::string textOf(const T* items, size_t count) {
    std::string text = "{";
    if constexpr (std::is_arithmetic_v<T>) {
      for (size_t i = 0; i < count && i < 12; ++i) {
        text += (i ? ", " : "") + std::to_string(items[i]);
      }
    }
    return text + "} of " + std::to_string(count);
  }
  /// Words of a struct that are not as they were.
  static std::string differences(const void* good, const void* spoilt, size_t size);
  std::string longPath() const { return world_.folder.path(std::string(5000, 'x').c_str()); }
  char* room(size_t size, int fill);
  /// A copy of a struct with a structSize of its own choice, as much as that, before a guard.
  template <class T>
  T* sized(T value) {
    size_t size = sizeof(T), claimed = sizeof(T);
    bool rubbish = false;
    if (wild() && oneOf(8) == 0) {
      switch (oneOf(5)) {
        case 0:  // of an older host
          size = claimed = sizeof(size_t) * (1 + oneOf(sizeof(T) / sizeof(size_t)));
          break;
        case 1:  // of a newer one
          size = claimed = sizeof(T) + 8;
          break;
        case 2:  // which uses what is new
          size = claimed = sizeof(T) + 8;
          rubbish = true;
          break;
        case 3:
          claimed = oneOf(2) ? oneOf(8) : sizeof(T) - 1 - oneOf(7);
          break;
        default:
          claimed = static_cast<size_t>(0) - 1 - oneOf(2) * 1000;
      }
      texts_ += " /* structSize " + std::to_string(claimed) + ": */";
    }
    char* place = room(size, 0);
    value.structSize = claimed;
    std::memcpy(place, static_cast<const void*>(&value), std::min(size, sizeof(T)));
    if (rubbish) place[size - 1] = 1;
    return reinterpret_cast<T*>(place);
  }
  template <class T>
  T wildNumber(T good);

  World& world_;
  awdtest::Random random_;
  Mode mode_;
  int null_;
  size_t first_ = 0;
  std::string name_, texts_, complaint_;
  std::vector<bool> mayBeNull_, judged_;
  std::vector<std::function<void(bool, bool)>> outputs_;
  std::vector<std::unique_ptr<awdtest::Guarded>> rooms_;
  std::vector<std::unique_ptr<std::string>> strings_;
  std::function<void(const std::string&)> tell_;
  AWDResult result_ = AWD_SUCCESS;
};

template <class T>
T Caller::wildNumber(T good) {
  using Limits = std::numeric_limits<T>;
  if constexpr (std::is_floating_point_v<T>) {
    const T choices[] = {T(0),
                         T(-0.0),
                         T(1),
                         T(-1),
                         Limits::max(),
                         Limits::lowest(),
                         Limits::min(),
                         Limits::denorm_min(),
                         Limits::infinity(),
                         -Limits::infinity(),
                         Limits::quiet_NaN(),
                         T(0.999)};
    return choices[oneOf(12)];
  } else {
    const T choices[] = {T(0),
                         T(1),
                         T(2),
                         T(7),
                         T(100),
                         Limits::max(),
                         T(Limits::max() - 1),
                         Limits::min(),
                         T(Limits::max() / 2),
                         T(good + 1),
                         T(good - 1),
                         T(-1)};
    return choices[oneOf(12)];
  }
}

/// A function of the interface and how it is called.
struct Function {
  const char* name;
  std::function<void(Caller&)> call;
  bool renders = false;  ///< of those that want the renderer
  /// Retain and Release have none.
  bool hasResult() const {
    return std::strncmp(name, "awdRe", 5) != 0 ||
           (std::strncmp(name, "awdRetain", 9) != 0 && std::strncmp(name, "awdRelease", 10) != 0);
  }
};

/// Every function that the headers declare.
const std::vector<Function>& allFunctions();

}  // namespace awdmisuse
