// SPDX-License-Identifier: Apache-2.0
// The objects behind the handles.
#pragma once

#include "api/guard.h"
#include "util/ref.h"
#include "util/uncancelled.h"

namespace awd {

class Density;
class Device;
class Field;
class Scene;
class Render;
class Image;

inline Device* behind(AWDDevice handle) { return reinterpret_cast<Device*>(handle); }
inline Density* behind(AWDDensity handle) { return reinterpret_cast<Density*>(handle); }
inline Field* behind(AWDField handle) { return reinterpret_cast<Field*>(handle); }
inline Scene* behind(AWDScene handle) { return reinterpret_cast<Scene*>(handle); }
inline Render* behind(AWDRender handle) { return reinterpret_cast<Render*>(handle); }
inline Image* behind(AWDImage handle) { return reinterpret_cast<Image*>(handle); }

/// The object of a handle that must not be NULL.
template <class Handle>
auto& object(Handle handle, const char* argument) {
  return *behind(need(handle, argument));
}

[[noreturn]] inline void failAtWork(const char* argument) {
  fail(AWD_ERROR_INVALID_OPERATION,
       "%s is at work in another call: wait for its end, also in a callback of that call",
       argument);
}

/// The same, for a call that changes it, or that sees it half changed if another call is at work.
template <class Handle>
auto& idle(Handle handle, const char* argument) {
  auto& known = object(handle, argument);
  if (known.isAtWork()) failAtWork(argument);
  return known;
}

/// For a call that calls the host back: whatever that does, the object is there to its end, no
/// other call changes it, and the thread does not leave. Null: none.
template <class T>
class AtWork {
 public:
  AtWork(T* object, const char* argument) : object_(Ref<T>::share(object)) {
    if (object && !object->beginWork()) failAtWork(argument);
  }
  ~AtWork() {
    if (object_) object_->endWork();
  }
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;
  T* operator->() const { return object_.get(); }
  T& operator*() const { return *object_; }

 private:
  Uncancelled uncancelled_;
  Ref<T> object_;
};

/// Hands a reference to the host.
template <class Handle, class T>
void give(Handle* output, Ref<T> reference) {
  *output = reinterpret_cast<Handle>(reference.detach());
}

}  // namespace awd
