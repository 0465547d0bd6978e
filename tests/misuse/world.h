// SPDX-License-Identifier: Apache-2.0
// The objects that calls are made on: references of the host's, by kind, and what their memory is.
#pragma once

#include <string>
#include <vector>

#include "awd/awd.h"
#include "awd/basis.h"
#include "support/counting_allocator.h"
#include "support/temporary_folder.h"

namespace awdmisuse {

/// Refuses what no small scene needs, and counts the rest.
class SmallMemory {
 public:
  AWDDeviceDesc desc(uint32_t threads);
  size_t blocks() const { return counter_.blocks(); }

 private:
  awdtest::CountingAllocator counter_;
  AWDDeviceDesc inner_ = AWD_DEVICE_DESC_INIT;
};

/// Each entry is one reference; an object may have several.
template <class T>
using Pool = std::vector<T>;

struct World {
  World();
  /// References of its own to the objects of another one, such as for a thread.
  explicit World(World& shared);
  ~World();
  World& operator=(const World&) = delete;

  /// Drops every reference but that of the first device.
  void release();
  /// Number of references of all kinds.
  size_t references() const;

  template <class T>
  Pool<T>& pool();

  /// After how many reports of progress the second device's host says stop; negative: never.
  long cancelAfter = -1;
  SmallMemory memory;
  SmallMemory others;  ///< of the second device
  awdtest::TemporaryFolder folder;
  std::string fieldFile, renderFile, imageFile, rubbishFile;
  std::vector<char> fieldBytes, densityBytes, statisticsBytes;
  std::vector<uint64_t> fieldNumbers, passNumbers;
  AWDBasisModule module{};  ///< good; its families live as long
  const AWDBasisModule* registered = &module;
  bool renders = true;  ///< of a library with the renderer
  AWDBasisFamily family{};
  const AWDBasisFamily* families[1] = {&family};
  std::string modulePath;

  Pool<AWDDevice> devices;
  Pool<AWDScene> scenes;
  Pool<AWDField> fields;
  Pool<AWDDensity> densities;
  Pool<AWDRender> renderers;
  Pool<AWDImage> images;

 private:
  void makeObjects(AWDDevice device);
  void saveObjects();
  void saveRender();
};

template <>
inline Pool<AWDDevice>& World::pool() {
  return devices;
}
template <>
inline Pool<AWDScene>& World::pool() {
  return scenes;
}
template <>
inline Pool<AWDField>& World::pool() {
  return fields;
}
template <>
inline Pool<AWDDensity>& World::pool() {
  return densities;
}
template <>
inline Pool<AWDRender>& World::pool() {
  return renderers;
}
template <>
inline Pool<AWDImage>& World::pool() {
  return images;
}

inline void retain(AWDDevice handle) { awdRetainDevice(handle); }
inline void retain(AWDScene handle) { awdRetainScene(handle); }
inline void retain(AWDField handle) { awdRetainField(handle); }
inline void retain(AWDDensity handle) { awdRetainDensity(handle); }
inline void retain(AWDRender handle) { awdRetainRender(handle); }
inline void retain(AWDImage handle) { awdRetainImage(handle); }
inline void release(AWDDevice handle) { awdReleaseDevice(handle); }
inline void release(AWDScene handle) { awdReleaseScene(handle); }
inline void release(AWDField handle) { awdReleaseField(handle); }
inline void release(AWDDensity handle) { awdReleaseDensity(handle); }
inline void release(AWDRender handle) { awdReleaseRender(handle); }
inline void release(AWDImage handle) { awdReleaseImage(handle); }

/// A mesh of two triangles, one of which emits, with 4 vertices and materials 0 and 1. Its buffers
/// live as long as the program.
AWDMeshDesc smallMesh();
AWDCamera smallCamera();
/// Two passes of 2 samples per pixel.
AWDSchedule smallSchedule();
AWDRenderDesc smallRender(const AWDCamera& camera);

/// What a few operations on objects of their own give, bit by bit.
std::vector<double> referenceBits(AWDDevice device);

}  // namespace awdmisuse
