// SPDX-License-Identifier: Apache-2.0
//
// awd/field.h and awd/light.h in C++.
#ifndef AWD_CPP_FIELD_HPP
#define AWD_CPP_FIELD_HPP

#include <vector>

#include "awd/cpp/buffer.hpp"
#include "awd/cpp/collect.hpp"
#include "awd/cpp/scene.hpp"
#include "awd/cpp/summands.hpp"
#include "awd/light.h"

namespace awd {
inline namespace AWD_CPP_MODE {

/// Which light a shadow ray goes to.
struct LightChoice {
  std::uint32_t light;
  float chance;
  double rest;  /// of the uniform, uniform again
};

/// One adaptive density per patch of surface, over the hemisphere above it.
class Field : public Owner<Field, AWDField, awdRetainField, awdReleaseField> {
 public:
  static Returns<Field> create(const Device& device, const AWDFieldDesc& desc = FieldDesc()) {
    const detail::Call call;
    Field field;
    return detail::outcome(call, awdNewField(device.get(), &desc, field.out()), field);
  }
  /// For renders of a committed scene, whose box and lights it takes.
  static Returns<Field> create(const Scene& scene, const AWDFieldDesc& desc = FieldDesc()) {
    const detail::Call call;
    Field field;
    return detail::outcome(call, awdNewSceneField(scene.get(), &desc, field.out()), field);
  }
  /// Of what save() gave.
  static Returns<Field> load(const Device& device, Bytes bytes) {
    const detail::Call call;
    Field field;
    return detail::outcome(
        call, awdLoadField(device.get(), bytes.data(), bytes.size(), field.out()), field);
  }
  /// Of a file that write() wrote.
  static Returns<Field> read(const Device& device, Text path) {
    const detail::Call call;
    Field field;
    return detail::outcome(call, awdReadField(device.get(), path.get(), field.out()), field);
  }

  // --- directions ---------------------------------------------------------------------------

  Returns<std::uint32_t> findPatch(Float3 position, Float3 normal) const {
    std::uint32_t patch = AWD_INVALID_ID;
    return detail::outcome(awdFindPatch(get(), position.data(), normal.data(), &patch), patch);
  }
  Returns<AWDDirectionSample> sample(std::uint32_t patch, Float3 normal, Double3 uniforms) const {
    AWDDirectionSample sample;
    return detail::outcome(awdSampleField(get(), patch, normal.data(), uniforms.data(), &sample),
                           sample);
  }
  Returns<float> pdf(std::uint32_t patch, Float3 normal, Float3 direction) const {
    float pdf = 0.0f;
    return detail::outcome(awdGetFieldPdf(get(), patch, normal.data(), direction.data(), &pdf),
                           pdf);
  }
  /// A direction that the host drew, as a sample that can be recorded.
  Returns<AWDDirectionSample> map(std::uint32_t patch, Float3 normal, Float3 direction) const {
    AWDDirectionSample sample;
    return detail::outcome(awdMapDirection(get(), patch, normal.data(), direction.data(), &sample),
                           sample);
  }
  Returns<void> record(std::uint32_t patch, const AWDDirectionSample& sample, double value) const {
    return detail::outcome(awdRecordField(get(), patch, &sample, value));
  }
  /// Records a path from the camera on; what it tells of the radiance that the camera sees.
  Returns<std::array<float, 3>> recordPath(View<const AWDPathVertex> vertices) const {
    std::array<float, 3> radiance = {};
    return detail::outcome(
        awdRecordFieldPath(get(), vertices.size(), vertices.data(), nullptr, radiance.data()),
        radiance);
  }
  /// The same; the path's last ray met what comes from outside the scene.
  Returns<std::array<float, 3>> recordPath(View<const AWDPathVertex> vertices,
                                           Float3 background) const {
    std::array<float, 3> radiance = {};
    return detail::outcome(awdRecordFieldPath(get(), vertices.size(), vertices.data(),
                                              background.data(), radiance.data()),
                           radiance);
  }
  /// With how many rays on average a path should go on; -1 where nothing is known.
  Returns<float> continuation(std::uint32_t patch, float throughput, float expected,
                              std::uint32_t maxSplit = 0) const {
    float rays = 0.0f;
    return detail::outcome(awdGetContinuation(get(), patch, throughput, expected, maxSplit, &rays),
                           rays);
  }

  // --- many at a time: three numbers each of positions, normals, directions and uniforms ------

  Returns<void> findPatches(View<const float> positions, View<const float> normals,
                            View<std::uint32_t> patches) const {
    const std::size_t n = patches.size();
    if (positions.size() != 3 * n) {
      return detail::wrongSize<void>("positions", positions.size(), 3 * n);
    }
    if (normals.size() != 3 * n) return detail::wrongSize<void>("normals", normals.size(), 3 * n);
    return detail::outcome(
        awdFindPatches(get(), n, positions.data(), normals.data(), patches.data()));
  }
  Returns<void> sample(View<const std::uint32_t> patches, View<const float> normals,
                       View<const double> uniforms, View<AWDDirectionSample> samples) const {
    const std::size_t n = patches.size();
    if (normals.size() != 3 * n) return detail::wrongSize<void>("normals", normals.size(), 3 * n);
    if (uniforms.size() != 3 * n) {
      return detail::wrongSize<void>("uniforms", uniforms.size(), 3 * n);
    }
    if (samples.size() != n) return detail::wrongSize<void>("samples", samples.size(), n);
    return detail::outcome(awdSampleFieldBatch(get(), n, patches.data(), normals.data(),
                                               uniforms.data(), samples.data()));
  }
  Returns<void> pdf(View<const std::uint32_t> patches, View<const float> normals,
                    View<const float> directions, View<float> pdfs) const {
    const std::size_t n = patches.size();
    if (normals.size() != 3 * n) return detail::wrongSize<void>("normals", normals.size(), 3 * n);
    if (directions.size() != 3 * n) {
      return detail::wrongSize<void>("directions", directions.size(), 3 * n);
    }
    if (pdfs.size() != n) return detail::wrongSize<void>("pdfs", pdfs.size(), n);
    return detail::outcome(
        awdGetFieldPdfs(get(), n, patches.data(), normals.data(), directions.data(), pdfs.data()));
  }
  Returns<void> record(View<const std::uint32_t> patches, View<const AWDDirectionSample> samples,
                       View<const double> values) const {
    const std::size_t n = patches.size();
    if (samples.size() != n) return detail::wrongSize<void>("samples", samples.size(), n);
    if (values.size() != n) return detail::wrongSize<void>("values", values.size(), n);
    return detail::outcome(
        awdRecordFieldBatch(get(), n, patches.data(), samples.data(), values.data()));
  }

  // --- lights ---------------------------------------------------------------------------------

  Returns<LightChoice> chooseLight(std::uint32_t patch, double uniform) const {
    LightChoice choice = {AWD_INVALID_ID, 0.0f, 0.0};
    return detail::outcome(
        awdChooseLight(get(), patch, uniform, &choice.light, &choice.chance, &choice.rest), choice);
  }
  Returns<float> lightChance(std::uint32_t patch, std::uint32_t light) const {
    float chance = 0.0f;
    return detail::outcome(awdGetLightChance(get(), patch, light, &chance), chance);
  }
  Returns<void> recordLight(std::uint32_t patch, std::uint32_t light, double value) const {
    return detail::outcome(awdRecordLight(get(), patch, light, value));
  }
  Returns<float> patchLight(std::uint32_t patch) const {
    float magnitude = 0.0f;
    return detail::outcome(awdGetPatchLight(get(), patch, &magnitude), magnitude);
  }

  // --- passes ---------------------------------------------------------------------------------

  Returns<void> setScale(double magnitude) {
    return detail::outcome(awdSetFieldScale(get(), magnitude));
  }
  Returns<AWDFieldStatistics> adapt() {
    const detail::Call call(get());
    AWDFieldStatistics statistics = AWD_FIELD_STATISTICS_INIT;
    return detail::outcome(call, awdAdaptField(get(), &statistics), statistics);
  }
  Returns<void> mark() { return detail::outcome(awdMarkField(get())); }
  Returns<void> revert() { return detail::outcome(awdRevertField(get())); }
  Returns<AWDFieldStatistics> statistics() {
    AWDFieldStatistics statistics = AWD_FIELD_STATISTICS_INIT;
    return detail::outcome(awdGetFieldStatistics(get(), &statistics), statistics);
  }

  // --- what it has learned ----------------------------------------------------------------------

  /// Numbers of the patches that have had samples.
  Returns<std::vector<std::uint32_t>> patches() const {
    return detail::collect<std::uint32_t>(
        [this](std::uint32_t* patches, std::size_t capacity, std::size_t* count) {
          return awdGetFieldPatches(get(), patches, capacity, count);
        });
  }
  Returns<AWDPatchInfo> patchInfo(std::uint32_t patch) const {
    AWDPatchInfo info = AWD_PATCH_INFO_INIT;
    return detail::outcome(awdGetPatchInfo(get(), patch, &info), info);
  }
  Returns<std::vector<double>> patchCoefficients(std::uint32_t patch) const {
    AWDPatchInfo info = AWD_PATCH_INFO_INIT;
    std::vector<double> coefficients;
    AWDResult result = awdGetPatchInfo(get(), patch, &info);
    if (result == AWD_SUCCESS) {
      coefficients.resize(std::size_t{info.axisCount} * info.axisCount);
      result = awdGetPatchCoefficients(get(), patch, coefficients.data(), coefficients.size());
    }
    return detail::outcome(result, coefficients);
  }
  Returns<float> patchMean(std::uint32_t patch) const {
    float mean = 0.0f;
    return detail::outcome(awdGetPatchMean(get(), patch, &mean), mean);
  }
  /// Writes the density on the unit square to a square of pixels that lie in rows without gaps.
  Returns<void> patchPdf(std::uint32_t patch, ChannelPixels pixels) const {
    if (pixels.width != pixels.height || pixels.pixelStride != sizeof(float)) {
      return detail::failure<void>(
          Error(AWD_ERROR_INVALID_ARGUMENT, "pixels: give a square of packed rows"));
    }
    return detail::outcome(
        awdGetPatchPdf(get(), patch, pixels.width, pixels.data, pixels.rowStride));
  }

  // --- in several processes, and to be continued ------------------------------------------------

  Returns<std::vector<std::byte>> save() {
    return detail::collect<std::byte>(
        [this](std::byte* bytes, std::size_t capacity, std::size_t* size) {
          return awdSaveField(get(), bytes, capacity, size);
        });
  }
  Returns<void> write(Text path) { return detail::outcome(awdWriteField(get(), path.get())); }
  /// Adds what `other` has recorded since its last adapt.
  Returns<void> merge(Field& other) { return detail::outcome(awdMergeField(get(), other.get())); }
  /// What was recorded since the last adapt, to be combined with that of other processes. patches:
  /// of a field with patches of the host's own, else empty.
  Returns<Summands> exportRecords(View<const std::uint32_t> patches = {}) {
    return detail::summands([&](std::uint64_t* numbers, std::size_t capacity, std::size_t* sums,
                                std::size_t* maxima) {
      return awdExportField(get(), patches.data(), patches.size(), numbers, capacity, sums, maxima);
    });
  }
  /// Puts the combined numbers in its place.
  Returns<void> importRecords(View<const std::uint64_t> numbers,
                              View<const std::uint32_t> patches = {}) {
    return detail::outcome(
        awdImportField(get(), patches.data(), patches.size(), numbers.data(), numbers.size()));
  }
};

}  // namespace AWD_CPP_MODE
}  // namespace awd

#endif
