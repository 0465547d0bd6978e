// SPDX-License-Identifier: Apache-2.0
// All that a host does in a life, call by call, so that each can be disturbed and repeated.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "support/films.h"
#include "support/scenes.h"

namespace awdtest {

/// One function of the library on arguments that are there already: nothing but the library works
/// within `call`. What was learned from it is kept by `after`.
struct LifeStep {
  std::string name;
  std::function<AWDResult()> call;
  std::function<void()> after;
};

class Life {
 public:
  struct Size {
    uint32_t pixels = 6;  ///< of the image, along an axis
    uint32_t panels = 0;  ///< squared and times 12: triangles on top of those of the room
    size_t points = 200;  ///< of a density's pass
  };
  /// folder: for its files. refits: also by the refit module, whose own memory is not the host's.
  Life(const AWDDeviceDesc& desc, std::string folder, bool refits, const Size& size);
  Life(const AWDDeviceDesc& desc, std::string folder, bool refits)
      : Life(desc, std::move(folder), refits, Size()) {}
  Life(const Life&) = delete;
  Life& operator=(const Life&) = delete;
  ~Life();

  const std::vector<LifeStep>& steps() const { return steps_; }
  /// What its calls have given, by name: the same bits for lives of the same steps.
  const std::map<std::string, std::vector<char>>& evidence() const { return evidence_; }

 private:
  void step(const char* name, std::function<AWDResult()> call, std::function<void()> after = {});
  template <class T>
  void keep(const std::string& name, const std::vector<T>& values) {
    const char* bytes = reinterpret_cast<const char*>(values.data());
    evidence_[name].assign(bytes, bytes + values.size() * sizeof(T));
  }
  void addScene();
  void addRender();
  void addParts();
  void addField();
  void addCheckpoint();
  void addDensity(const std::string& name, AWDDensity& density, AWDDensityStructure structure,
                  AWDEstimator estimator);
  void addImages();
  void addSavedField(const char* name, AWDField& field);
  void addFilm(const char* name, AWDRender& render);

  const AWDDeviceDesc desc_;
  const std::string fieldPath_, renderPath_, exrPath_, pngPath_;
  std::vector<LifeStep> steps_;
  std::map<std::string, std::vector<char>> evidence_;

  const Size is_;
  const SceneBuilder room_;
  const AWDMeshDesc mesh_ = room_.mesh();
  AWDCamera camera_ = lampRoomCamera(is_.pixels);
  AWDRenderDesc renderDesc_ = AWD_RENDER_DESC_INIT;
  std::vector<uint32_t> passes_ = {2, 3, 3};
  AWDSchedule schedule_ = AWD_SCHEDULE_INIT;
  AWDFieldDesc fieldDesc_ = AWD_FIELD_DESC_INIT, hostDesc_ = AWD_FIELD_DESC_INIT;
  std::map<std::string, AWDDensityDesc> densityDescs_;
  std::vector<AWDMaterialDesc> materials_;
  std::vector<char> bytes_;
  std::vector<uint64_t> numbers_;
  std::vector<float> pixels_;
  std::vector<uint32_t> patches_;
  std::vector<AWDDirectionSample> samples_;
  std::vector<AWDPathVertex> path_;
  std::vector<double> uniforms_, points_, pdfs_, values_;
  size_t size_ = 0, sums_ = 0, maxima_ = 0;
  uint32_t samplesPerPixel_ = 0;

  AWDDevice device_ = nullptr;
  AWDScene scene_ = nullptr;
  AWDRender render_ = nullptr, loadedRender_ = nullptr;
  AWDField field_ = nullptr, host_ = nullptr, loaded_ = nullptr, read_ = nullptr;
  AWDDensity grid_ = nullptr, tree_ = nullptr, refit_ = nullptr, fork_ = nullptr, copy_ = nullptr;
  AWDImage image_ = nullptr, patchImage_ = nullptr, readImage_ = nullptr;
};

}  // namespace awdtest
