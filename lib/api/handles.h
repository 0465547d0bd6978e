// SPDX-License-Identifier: Apache-2.0
// The objects behind the handles.
#pragma once

#include "api/guard.h"
#include "util/ref.h"

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

/// Hands a reference to the host.
template <class Handle, class T>
void give(Handle* output, Ref<T> reference) {
  *output = reinterpret_cast<Handle>(reference.detach());
}

}  // namespace awd
