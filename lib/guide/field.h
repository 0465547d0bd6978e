// SPDX-License-Identifier: Apache-2.0
// The field: a density per patch. Each member function is what a C function of awd/field.h wraps;
// our renderer uses nothing else.
#pragma once

#include <array>
#include <memory_resource>
#include <optional>
#include <vector>

#include "awd/field.h"
#include "density/finders.h"
#include "guide/continuation.h"
#include "guide/field_settings.h"
#include "guide/hemisphere.h"
#include "guide/patch.h"
#include "guide/patch_learning.h"
#include "guide/patch_table.h"
#include "guide/spatial_tree.h"
#include "util/bytes.h"
#include "util/context.h"

namespace awd {

/// What a pass needs to know of a patch, looked up once.
struct PatchView {
  const SquareDensity* density = nullptr;
  PatchStatistics* statistics = nullptr;  ///< null: the patch has not been made yet
  const LightChoice* lights = nullptr;    ///< null: of a field that chooses none
  const float* nodalTables = nullptr;     ///< of nodal()
  float mean = 0.0f;  ///< of f/p: the radiance reflected, in the units of what is recorded
  uint16_t nodalCells = 0;
  bool known = false;  ///< whether anything has been learned about the mean

  /// The fast form of the density, if it has one.
  NodalSquare nodal() const { return {nodalTables, nodalCells}; }
};

class Field final : public RefCounted {
 public:
  static Ref<Field> make(Ref<Context> context, const AWDBasisFamily& family,
                         const FieldSettings& settings);
  Field(Ref<Context> context, const AWDBasisFamily& family, const FieldSettings& settings);

  /// From what bytesOf() wrote.
  static Ref<Field> load(Ref<Context> context, const void* bytes, std::size_t size,
                         const Finders& find);

  Context& context() const { return *context_; }
  const FieldSettings& settings() const { return settings_; }
  const Family& family() const { return learning_.family(); }
  bool isSpatial() const { return tree_.has_value(); }
  /// How many lights its patches choose among; 0: they don't.
  uint32_t lights() const { return settings_.lights ? settings_.lights->lights() : 0; }

  /// The number of the patch at a point of a surface; only of a spatial field.
  uint32_t findPatch(Vec3f point, Vec3f normal) const { return tree_->find(point, normal); }
  PatchView view(uint32_t patch) const {
    const uint32_t key = keyOf(patch);
    return key < views_.size() ? views_[key] : viewOf(key);
  }

  /// Brings nearer what sampling and recording in a patch will read.
  static void prefetch(const PatchView& view) {
    if (view.nodalTables) {
      view.nodal().prefetch();
    } else {
      view.density->prefetch();
    }
    if (view.statistics) view.statistics->prefetch();
  }

  AWDDirectionSample sample(const PatchView& view, Vec3f normal, const double uniforms[3]) const;
  AWDDirectionSample sample(uint32_t patch, Vec3f normal, const double uniforms[3]) const {
    return sample(view(patch), normal, uniforms);
  }
  float pdf(uint32_t patch, Vec3f normal, Vec3f direction) const;
  /// A direction that the host drew, as a sample that can be recorded; of pdf and solid angle 0
  /// below the horizon.
  AWDDirectionSample mapDirection(uint32_t patch, Vec3f normal, Vec3f direction) const;
  void record(uint32_t patch, const AWDDirectionSample& sample, double value) {
    record(patch, view(patch), sample, value);
  }
  void record(uint32_t patch, const PatchView& view, const AWDDirectionSample& sample,
              double value);
  /// What a shadow ray to that light brought, not divided by the chance of the light.
  void recordLight(uint32_t patch, const PatchView& view, uint32_t light, double value) {
    PatchStatistics& sums = view.statistics ? *view.statistics : *touch(keyOf(patch)).statistics;
    sums.recordLight(light, value);
  }
  /// Makes recording in the patch need no memory: of several records that are told at once then all
  /// are taken or none.
  void makeRoom(uint32_t patch) {
    if (!view(patch).statistics) touch(keyOf(patch));
  }
  /// Fails if the field can't have a patch of this number.
  void checkPatch(uint32_t patch) const;
  /// Fails as record() would for a patch or component that can't be.
  void checkRecord(uint32_t patch, const AWDDirectionSample& sample) const;
  /// A sample of the patch whose pdf makes no sense.
  void reject(uint32_t patch);
  /// Records what a path brought at each of its vertices, from the camera on; its radiance. All
  /// that can fail has been checked.
  Vec3d recordPath(const AWDPathVertex* vertices, std::size_t count, Vec3d background);

  void setScale(double magnitude);
  /// No patch is split beyond these bytes, nor beyond those of the settings.
  void limitBytes(uint64_t most) { settings_.maxBytes = std::min(settings_.maxBytes, most); }
  AWDFieldStatistics adapt();
  /// Whether there is anything that adapt() would learn from.
  bool hasRecords() const;
  AWDFieldStatistics statistics() const;
  /// What has been recorded so far is kept apart, so that revert() can drop what comes after.
  void mark();
  void revert();
  /// Adds what another field of the same densities has recorded since the last adapt.
  void merge(const Field& other);
  /// The patches that several fields exchange records of: null for spatial ones, which are all that
  /// the tree has; of the host's own those that any of the fields may have recorded in, ascending.
  struct Exchanged {
    const uint32_t* patches = nullptr;
    std::size_t count = 0;
  };
  /// How many numbers these are: first such that are added up, then such of which the largest is
  /// taken.
  struct ExchangeSize {
    std::size_t sums, maxima;
  };
  ExchangeSize exchangeSize(const Exchanged& exchanged) const;
  /// What has been recorded since the last adapt, or the last mark after it.
  void exportRecords(const Exchanged& exchanged, uint64_t* sums, uint64_t* maxima) const;
  /// Puts in place of that what several fields of the same densities have exported, combined.
  void importRecords(const Exchanged& exchanged, const uint64_t* sums, const uint64_t* maxima);
  /// What differs in how they were made, as in "its map"; null: nothing does.
  const char* differenceTo(const Field& other) const;
  /// Everything that the field is and has recorded.
  std::pmr::vector<char> bytesOf() const;

  AWDPatchInfo patchInfo(uint32_t patch) const;
  /// The density of a patch, or the start density.
  const SquareDensity& density(uint32_t patch) const { return *view(patch).density; }
  std::pmr::vector<uint32_t> patches() const;
  /// p at the middles of n x n pixels: u to the right, v downwards; rows rowStride bytes apart.
  void pdfImage(uint32_t patch, uint32_t n, float* pixels, std::size_t rowStride) const;

 private:
  void destroy() noexcept override;

  /// What a patch becomes at the end of a pass.
  struct Successor {
    uint32_t key;
    Patch* patch;
    PatchKnowledge known;
    Owned<PatchStatistics> statistics;
    uint64_t samples;
    std::array<uint64_t, kRejections> rejected;
    uint64_t saturated;
    RefitReport refit;
  };
  /// A patch that a split has made.
  struct Newcomer {
    uint32_t key;
    Owned<Patch> patch;
  };
  /// What a split needs to know of a leaf: its part of what its patch knows.
  struct Part {
    uint32_t leaf;
    PatchKnowledge* known;
    uint32_t firstEighth, eighths;
    double samples;  ///< in these
    double weight;
  };

  /// Patches that were made, and then not recorded in.
  void removeUnseen();
  Successor succeed(uint32_t key, Patch& patch, bool mayRefine, const Refitter& refitter) const;
  /// Whether there is memory for all of these patches to be refined.
  bool mayRefine(const std::pmr::vector<std::pair<uint32_t, Patch*>>& patches) const;
  /// Of the density and the choice of lights that are not the field's own.
  static std::size_t memoryOf(const PatchKnowledge& known) {
    return (known.density ? known.density->bytes() : 0) +
           (known.lights ? known.lights->bytes() : 0);
  }
  std::pmr::vector<Successor> learnAll();
  /// At how many samples a leaf is split, when there are so many leaves.
  double patchSamples(uint32_t leaves) const;
  /// Splits leaves of many samples in `tree`; patches for those halves that have had any.
  /// capped: how many more would have been, but for the memory allowed.
  std::pmr::vector<Newcomer> splitAll(SpatialTree& tree, std::pmr::vector<Successor>& successors,
                                      uint64_t& capped) const;
  void take(Successor& next);
  uint32_t keyOf(uint32_t patch) const {
    return isSpatial() ? patch / SpatialTree::kEighths : patch;
  }
  uint32_t numberOf(uint32_t key) const { return isSpatial() ? key * SpatialTree::kEighths : key; }
  const SquareDensity& density(const PatchKnowledge& known) const {
    return known.density ? *known.density : *start_;
  }
  /// The patch of that key or, if none has been made yet, the one that its leaf was split from.
  const Patch* nearest(uint32_t key) const;
  PatchView viewOf(uint32_t key) const;
  /// Views go on showing what the last adapt left, and record where statistics are now.
  void renewViews();
  Patch& touch(uint32_t key);
  Patch* newPatch(uint32_t key) const;

  struct Layout;
  Layout layOut(const Exchanged& exchanged) const;
  /// Of settings, places, knowledge and units: what all who exchange records must agree in.
  std::array<uint64_t, 4> digests(const Layout& layout) const;
  PatchUnits unitsOf(uint32_t key) const;

  Owned<PatchStatistics> getStatistics(ByteReader& reader, const BasisLevel& level,
                                       PatchUnits units) const;
  void checkMerge(const Field& other) const;
  /// Fails unless the patch of that key is the same in both, but for what was recorded.
  void checkMerge(const Field& other, uint32_t key) const;

  Ref<Context> context_;
  FieldSettings settings_;
  PatchLearning learning_;
  Ref<SquareDensity> start_;
  PatchUnits units_;             ///< of patches that know nothing yet
  AWDFieldStatistics lastPass_;  ///< of the last adapt: all but patches, coefficients and bytes
  std::optional<SpatialTree> tree_;
  PatchTable<Patch> table_;
  std::pmr::vector<PatchView> views_;  ///< of a spatial field's leaves, as the last adapt left them
};

}  // namespace awd
