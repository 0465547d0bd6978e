// SPDX-License-Identifier: Apache-2.0
//
// awd/density.h in C++.
#ifndef AWD_CPP_DENSITY_HPP
#define AWD_CPP_DENSITY_HPP

#include <vector>

#include "awd/cpp/collect.hpp"
#include "awd/cpp/device.hpp"

namespace awd {
inline namespace AWD_CPP_MODE {

/// An adaptive density on the unit cube. It knows how many numbers a point has and wants, so that
/// views are checked before C writes to them: how many points there are is told by `points`.
class Density : public Owner<Density, AWDDensity, awdRetainDensity, awdReleaseDensity> {
 public:
  static Returns<Density> create(const Device& device, const AWDDensityDesc& desc) {
    const detail::Call call;
    AWDDensity handle = nullptr;
    const AWDResult result = awdNewDensity(device.get(), &desc, &handle);
    Density density = adopt(handle);
    return detail::outcome(call, result, density);
  }
  /// Of what save() gave.
  static Returns<Density> load(const Device& device, Bytes bytes) {
    const detail::Call call;
    AWDDensity handle = nullptr;
    const AWDResult result = awdLoadDensity(device.get(), bytes.data(), bytes.size(), &handle);
    Density density = adopt(handle);
    return detail::outcome(call, result, density);
  }
  /// As of every handle; nothing else may use the density meanwhile, nor in share().
  static Density adopt(AWDDensity handle) noexcept {
    Density density = Owner::adopt(handle);
    AWDDensityInfo info = AWD_DENSITY_INFO_INIT;
    if (handle && awdGetDensityInfo(handle, &info) == AWD_SUCCESS) {
      density.dimensions_ = info.dimensions;
      density.uniforms_ = info.uniforms;
    }
    return density;
  }
  /// One of the same p for a thread of its own.
  Returns<Density> fork() const {
    Density density;
    density.dimensions_ = dimensions_;
    density.uniforms_ = uniforms_;
    return detail::outcome(awdForkDensity(get(), density.out()), density);
  }
  /// Moves what a fork has recorded to this.
  Returns<void> join(Density& fork) { return detail::outcome(awdJoinDensity(get(), fork.get())); }

  std::uint32_t dimensions() const noexcept { return dimensions_; }
  /// That sample() wants a point: `dimensions`, and one more if the sampler is component.
  std::uint32_t uniforms() const noexcept { return uniforms_; }

  // --- points ---------------------------------------------------------------------------------

  /// Draws points. pdfs and components may be left out.
  Returns<void> sample(View<const double> uniforms, View<double> points, View<double> pdfs = {},
                       View<std::uint32_t> components = {}) const {
    const std::size_t n = countOf(points.size());
    if (points.size() != n * dimensions_) return partOfAPoint(points.size());
    if (uniforms.size() != n * uniforms_) {
      return detail::wrongSize<void>("uniforms", uniforms.size(), n * uniforms_);
    }
    if (!isThereOrNone(pdfs, n)) return detail::wrongSize<void>("pdfs", pdfs.size(), n);
    if (!isThereOrNone(components, n)) {
      return detail::wrongSize<void>("components", components.size(), n);
    }
    return detail::outcome(awdSampleDensity(get(), n, uniforms.data(), points.data(), orNull(pdfs),
                                            orNull(components)));
  }
  Returns<void> pdf(View<const double> points, View<double> pdfs) const {
    const std::size_t n = countOf(points.size());
    if (points.size() != n * dimensions_) return partOfAPoint(points.size());
    if (pdfs.size() != n) return detail::wrongSize<void>("pdfs", pdfs.size(), n);
    return detail::outcome(awdGetDensityPdf(get(), n, points.data(), pdfs.data()));
  }
  /// At one point.
  Returns<double> pdf(View<const double> point) const {
    double p = 0.0;
    if (point.size() != dimensions_) {
      return detail::wrongSize<double>("point", point.size(), dimensions_);
    }
    return detail::outcome(awdGetDensityPdf(get(), 1, point.data(), &p), p);
  }
  /// Tells values of f. Without pdfs the points were drawn from p; components: of the sampler
  /// component.
  Returns<void> record(View<const double> points, View<const double> pdfs,
                       View<const double> values, View<const std::uint32_t> components = {}) {
    const std::size_t n = countOf(points.size());
    if (points.size() != n * dimensions_) return partOfAPoint(points.size());
    if (values.size() != n) return detail::wrongSize<void>("values", values.size(), n);
    if (!isThereOrNone(pdfs, n)) return detail::wrongSize<void>("pdfs", pdfs.size(), n);
    if (!isThereOrNone(components, n)) {
      return detail::wrongSize<void>("components", components.size(), n);
    }
    return detail::outcome(
        awdRecordDensity(get(), n, points.data(), orNull(pdfs), orNull(components), values.data()));
  }

  // --- passes ---------------------------------------------------------------------------------

  /// The text in it lives until the next adapt.
  Returns<AWDDensityReport> adapt() {
    const detail::Call call(get());
    AWDDensityReport report = AWD_DENSITY_REPORT_INIT;
    return detail::outcome(call, awdAdaptDensity(get(), &report), report);
  }
  Returns<void> refine(std::uint32_t axis = AWD_ALL_AXES) {
    return detail::outcome(awdRefineDensity(get(), axis));
  }
  Returns<AWDDensityEstimate> estimate() {
    AWDDensityEstimate estimate = AWD_DENSITY_ESTIMATE_INIT;
    return detail::outcome(awdGetDensityEstimate(get(), &estimate), estimate);
  }

  // --- what it has learned --------------------------------------------------------------------

  Returns<AWDDensityInfo> info() {
    AWDDensityInfo info = AWD_DENSITY_INFO_INIT;
    return detail::outcome(awdGetDensityInfo(get(), &info), info);
  }
  Returns<AWDDensityAxisInfo> axisInfo(std::uint32_t axis) const {
    AWDDensityAxisInfo info = AWD_DENSITY_AXIS_INFO_INIT;
    return detail::outcome(awdGetDensityAxisInfo(get(), axis, &info), info);
  }
  Returns<std::vector<double>> coefficients(AWDCoefficientForm form = AWD_COEFFICIENTS_SCALING) {
    AWDDensityInfo info = AWD_DENSITY_INFO_INIT;
    std::vector<double> all;
    AWDResult result = awdGetDensityInfo(get(), &info);
    if (result == AWD_SUCCESS) {
      all.resize(info.coefficients);
      result = awdGetDensityCoefficients(get(), form, all.data(), all.size());
    }
    return detail::outcome(result, all);
  }
  Returns<void> setCoefficients(View<const double> all) {
    return detail::outcome(awdSetDensityCoefficients(get(), all.data(), all.size()));
  }
  /// Over all of the cube.
  Returns<double> integral() const {
    double integral = 0.0;
    return detail::outcome(awdGetDensityIntegral(get(), nullptr, nullptr, &integral), integral);
  }
  /// Over a box.
  Returns<double> integral(View<const double> lower, View<const double> upper) const {
    if (lower.size() != dimensions_) {
      return detail::wrongSize<double>("lower", lower.size(), dimensions_);
    }
    if (upper.size() != dimensions_) {
      return detail::wrongSize<double>("upper", upper.size(), dimensions_);
    }
    double integral = 0.0;
    return detail::outcome(awdGetDensityIntegral(get(), lower.data(), upper.data(), &integral),
                           integral);
  }
  /// Of each leaf of a tree its lower, then its upper corner.
  Returns<std::vector<double>> leaves() const {
    std::vector<double> boxes;
    std::size_t count = 0;
    AWDResult result = awdGetDensityLeaves(get(), nullptr, 0, &count);
    if (result == AWD_SUCCESS && count > 0) {
      boxes.resize(count * 2 * dimensions_);
      result = awdGetDensityLeaves(get(), boxes.data(), count, &count);
    }
    return detail::outcome(result, boxes);
  }
  /// int p^2 split by wavelets, the coarsest level first.
  Returns<std::vector<double>> detailEnergy() const {
    return detail::collect<double>(
        [this](double* energies, std::size_t capacity, std::size_t* count) {
          return awdGetDensityDetailEnergy(get(), energies, capacity, count);
        });
  }

  // --- in several processes, and to be continued ----------------------------------------------

  Returns<std::vector<std::byte>> exportStatistics() {
    return detail::collect<std::byte>(
        [this](std::byte* bytes, std::size_t capacity, std::size_t* size) {
          return awdExportDensityStatistics(get(), bytes, capacity, size);
        });
  }
  Returns<void> addStatistics(Bytes bytes) {
    return detail::outcome(awdAddDensityStatistics(get(), bytes.data(), bytes.size()));
  }
  Returns<void> importStatistics(Bytes bytes) {
    return detail::outcome(awdImportDensityStatistics(get(), bytes.data(), bytes.size()));
  }
  Returns<std::vector<std::byte>> save() {
    return detail::collect<std::byte>(
        [this](std::byte* bytes, std::size_t capacity, std::size_t* size) {
          return awdSaveDensity(get(), bytes, capacity, size);
        });
  }

 private:
  std::size_t countOf(std::size_t numbers) const noexcept {
    return dimensions_ ? numbers / dimensions_ : 0;
  }
  Returns<void> partOfAPoint(std::size_t numbers) const {
    return detail::wrongSize<void>("points", numbers, countOf(numbers) * dimensions_);
  }
  template <class T>
  static bool isThereOrNone(View<T> view, std::size_t n) noexcept {
    return view.empty() || view.size() == n;
  }
  template <class T>
  static T* orNull(View<T> view) noexcept {
    return view.empty() ? nullptr : view.data();
  }

  std::uint32_t dimensions_ = 0, uniforms_ = 0;
};

}  // namespace AWD_CPP_MODE
}  // namespace awd

#endif
