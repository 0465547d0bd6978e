// SPDX-License-Identifier: Apache-2.0
// How the functions of awd/device.h and awd/density.h are called.
#include "misuse/functions.h"

namespace awdmisuse {

namespace {

constexpr size_t kPoints = 8;  // items of a batch

const AWDDeviceDesc* deviceDesc(Caller& c) {
  return c.desc<AWDDeviceDesc>(
      c.world().memory.desc(1),
      [&](AWDDeviceDesc& desc) {
        c.spoil(desc.flags);
        c.spoil(desc.threads, {2, 1025, UINT32_MAX});
        if (c.wild() && c.oneOf(8) == 0) desc.free = nullptr;
        if (c.wild() && c.oneOf(8) == 0) desc.alloc = nullptr;
        c.spoil(desc.basisPathCount, {1, SIZE_MAX});
      },
      true);
}

const AWDDensityDesc* densityDesc(Caller& c) {
  return c.desc<AWDDensityDesc>(AWD_DENSITY_DESC_INIT, [&](AWDDensityDesc& desc) {
    desc.dimensions = c.wild() ? 1 + c.oneOf(2) : 2;
    desc.structure = c.wild() ? static_cast<int32_t>(c.oneOf(3)) : AWD_STRUCTURE_GRID;
    desc.maxCoefficients = 256;
    c.spoil(desc.dimensions, {0, 3, 4, 6, 7, UINT32_MAX});
    c.spoil(desc.structure);
    c.spoil(desc.estimator, {1, 2, 3, 4, 5, 6, 7, -1});
    c.spoil(desc.target);
    c.spoil(desc.sampler, {1, 2, 3, -1});
    c.spoil(desc.combination);
    c.spoil(desc.tau);
    c.spoil(desc.shrinkage);
    c.spoil(desc.passSamples);
    c.spoil(desc.maxCoefficients, {0, 1, 2, 1024, UINT64_MAX});
    c.spoil(desc.refitSolver, {"", "descent", "none"});
    c.spoil(desc.refitBytes, {1, 1000, UINT64_MAX});
    static const AWDDensityAxis kAxes[2] = {{"nonesuch", 0, 0}, {"haar", AWD_LEVEL(3), 1}};
    static const AWDDensityAxis kOdd[2] = {{"haar", 1, 2}, {"quadratic-bspline", UINT32_MAX, 0}};
    if (desc.dimensions <= 2) c.spoil(desc.axes, {&kAxes[0], &kAxes[1] - 1, kOdd});
  });
}

void addDevice(std::vector<Function>& all) {
  all.push_back({"awdGetVersion", [](Caller& c) { c(awdGetVersion, Args{}); }});
  all.push_back({"awdGetResultString",
                 [](Caller& c) { c(awdGetResultString, Args{c.number<int32_t>(-1)}); }});
  all.push_back({"awdGetLastErrorMessage", [](Caller& c) { c(awdGetLastErrorMessage, Args{}); }});
  all.push_back({"awdNewDevice", [](Caller& c) {
                   c(awdNewDevice, Args{deviceDesc(c), c.made<AWDDevice>()});
                 }});
  all.push_back({"awdRetainDevice", [](Caller& c) { c.retained(awdRetainDevice); }});
  all.push_back({"awdReleaseDevice", [](Caller& c) { c.released(awdReleaseDevice); }});
  all.push_back({"awdLoadBasisModule", [](Caller& c) {
                   c(awdLoadBasisModule, Args{c.device(), c.path(c.world().modulePath)});
                 }});
  all.push_back({"awdRegisterBasisModule", [](Caller& c) {
                   const AWDBasisModule* module = c.world().registered;
                   c(awdRegisterBasisModule, Args{c.device(), c.given(module)});
                 }});
  all.push_back({"awdCheckBasisModule", [](Caller& c) {
                   const AWDBasisCheckFn report = [](void* calls, const AWDBasisCheck* check) {
                     *static_cast<size_t*>(calls) += check->name ? 1 : 0;
                   };
                   const char* path = c.path(c.world().modulePath);
                   size_t* calls = c.out<size_t>(1, true);
                   // Whom the report is for may be NULL as long as it doesn't mind.
                   c(awdCheckBasisModule, Args{path, calls ? report : nullptr, calls});
                 }});
  all.push_back({"awdGetBasisCount", [](Caller& c) {
                   c(awdGetBasisCount, Args{c.device(), c.out<size_t>(1)});
                 }});
  all.push_back({"awdGetBasisInfo", [](Caller& c) {
                   c(awdGetBasisInfo, Args{c.device(), c.number<size_t>(0),
                                           c.outStruct<AWDBasisInfo>(AWD_BASIS_INFO_INIT)});
                 }});
}

/// Room for the uniforms of any sampler.
size_t uniformsOf(size_t count) { return count * (AWD_MAX_DIMENSIONS + 1); }

void addDensityLife(std::vector<Function>& all) {
  all.push_back({"awdNewDensity", [](Caller& c) {
                   c(awdNewDensity, Args{c.device(), densityDesc(c), c.made<AWDDensity>()});
                 }});
  all.push_back({"awdRetainDensity", [](Caller& c) { c.retained(awdRetainDensity); }});
  all.push_back({"awdReleaseDensity", [](Caller& c) { c.released(awdReleaseDensity); }});
  all.push_back({"awdForkDensity", [](Caller& c) {
                   c(awdForkDensity, Args{c.density(), c.made<AWDDensity>()});
                 }});
  all.push_back({"awdJoinDensity", [](Caller& c) {
                   AWDDensity fork = nullptr;
                   if (!c.wild() && awdForkDensity(c.world().densities[0], &fork) == AWD_SUCCESS) {
                     c.world().densities.push_back(fork);
                   }
                   const AWDDensity into = c.density();
                   const size_t last = c.world().densities.size() - 1;
                   c(awdJoinDensity, Args{into, c.first(last).density()});
                 }});
  all.push_back({"awdSampleDensity", [](Caller& c) {
                   const AWDDensity density = c.density();
                   const size_t n = c.count(kPoints);
                   c(awdSampleDensity, Args{density, n, c.uniforms(uniformsOf(n)),
                                            c.out<double>(AWD_MAX_DIMENSIONS * n),
                                            c.out<double>(n, true), c.out<uint32_t>(n, true)});
                 }});
  all.push_back({"awdGetDensityPdf", [](Caller& c) {
                   const AWDDensity density = c.density();
                   const size_t n = c.count(kPoints);
                   c(awdGetDensityPdf,
                     Args{density, n, c.uniforms(AWD_MAX_DIMENSIONS * n), c.out<double>(n)});
                 }});
  all.push_back({"awdRecordDensity", [](Caller& c) {
                   const AWDDensity density = c.density();
                   const size_t n = c.count(kPoints);
                   const double* points = c.uniforms(AWD_MAX_DIMENSIONS * n);
                   const double* pdfs = c.in<double>(
                       n, [&] { return 0.5 + c.uniform(); }, true);
                   const uint32_t* components = c.in<uint32_t>(
                       n, [&] { return c.oneOf(c.wild() ? 20 : 2); }, true);
                   c(awdRecordDensity, Args{density, n, points, pdfs, components, c.uniforms(n)});
                 }});
  all.push_back({"awdAdaptDensity", [](Caller& c) {
                   c(awdAdaptDensity, Args{c.density(), c.outStruct<AWDDensityReport>(
                                                            AWD_DENSITY_REPORT_INIT, true)});
                 }});
  all.push_back({"awdRefineDensity", [](Caller& c) {
                   const AWDDensity density = c.first(1).density();
                   c(awdRefineDensity, Args{density, c.number<uint32_t>(AWD_ALL_AXES)});
                 }});
}

void addDensityQueries(std::vector<Function>& all) {
  all.push_back({"awdGetDensityEstimate", [](Caller& c) {
                   c(awdGetDensityEstimate,
                     Args{c.density(), c.outStruct<AWDDensityEstimate>(AWD_DENSITY_ESTIMATE_INIT)});
                 }});
  all.push_back({"awdGetDensityInfo", [](Caller& c) {
                   c(awdGetDensityInfo,
                     Args{c.density(), c.outStruct<AWDDensityInfo>(AWD_DENSITY_INFO_INIT)});
                 }});
  all.push_back({"awdGetDensityAxisInfo", [](Caller& c) {
                   c(awdGetDensityAxisInfo,
                     Args{c.density(), c.number<uint32_t>(0),
                          c.outStruct<AWDDensityAxisInfo>(AWD_DENSITY_AXIS_INFO_INIT)});
                 }});
  all.push_back({"awdGetDensityCoefficients", [](Caller& c) {
                   const AWDDensity density = c.first(1).density();
                   const int32_t form = c.number<int32_t>(AWD_COEFFICIENTS_ORTHONORMAL);
                   const size_t n = c.count(1024);
                   c(awdGetDensityCoefficients, Args{density, form, c.out<double>(n), n});
                 }});
  all.push_back({"awdSetDensityCoefficients", [](Caller& c) {
                   const AWDDensity density = c.density();
                   AWDDensityInfo info = AWD_DENSITY_INFO_INIT;
                   if (density) awdGetDensityInfo(density, &info);
                   const size_t most = static_cast<size_t>(info.coefficients);
                   const size_t n = c.wild() && c.oneOf(2) ? c.count(most + 2) : most;
                   c(awdSetDensityCoefficients, Args{density, c.uniforms(n), n});
                 }});
  all.push_back({"awdGetDensityIntegral", [](Caller& c) {
                   const AWDDensity density = c.density();
                   // Both ends are there or neither: one of them may be NULL in good calls of both.
                   const double* lower = c.in<double>(AWD_MAX_DIMENSIONS, [] { return 0.25; });
                   const double* upper =
                       c.in<double>(AWD_MAX_DIMENSIONS, [&] { return 0.5 + 0.5 * c.uniform(); });
                   c(awdGetDensityIntegral, Args{density, lower, upper, c.out<double>(1)});
                 }});
  all.push_back({"awdGetDensityLeaves", [](Caller& c) {
                   const AWDDensity density = c.first(1).density();
                   const size_t n = c.count(kPoints);
                   c(awdGetDensityLeaves,
                     Args{density, c.out<double>(2 * AWD_MAX_DIMENSIONS * n), n, c.out<size_t>(1)});
                 }});
  all.push_back(
      {"awdGetDensityDetailEnergy", [](Caller& c) {
         const AWDDensity density = c.first(1).density();
         const size_t n = c.count(kPoints);
         c(awdGetDensityDetailEnergy, Args{density, c.out<double>(n), n, c.out<size_t>(1)});
       }});
}

void addDensityBytes(std::vector<Function>& all) {
  all.push_back(
      {"awdExportDensityStatistics", [](Caller& c) {
         const AWDDensity density = c.density();
         const size_t n = c.count(1 << 16);
         c(awdExportDensityStatistics, Args{density, c.out<char>(n), n, c.out<size_t>(1)});
       }});
  for (const auto& [name, function] :
       {std::pair{"awdAddDensityStatistics", &awdAddDensityStatistics},
        {"awdImportDensityStatistics", awdImportDensityStatistics}}) {
    all.push_back({name, [function = function](Caller& c) {
                     const AWDDensity density = c.density();
                     size_t size = 0;
                     const void* bytes = c.bytes(c.world().statisticsBytes, size);
                     c(function, Args{density, bytes, size});
                   }});
  }
  all.push_back({"awdSaveDensity", [](Caller& c) {
                   const AWDDensity density = c.density();
                   const size_t n = c.count(1 << 16);
                   c(awdSaveDensity, Args{density, c.out<char>(n), n, c.out<size_t>(1)});
                 }});
  all.push_back({"awdLoadDensity", [](Caller& c) {
                   const AWDDevice device = c.device();
                   size_t size = 0;
                   const void* bytes = c.bytes(c.world().densityBytes, size);
                   c(awdLoadDensity, Args{device, bytes, size, c.made<AWDDensity>()});
                 }});
}

}  // namespace

void addDeviceFunctions(std::vector<Function>& all) {
  addDevice(all);
  addDensityLife(all);
  addDensityQueries(all);
  addDensityBytes(all);
}

}  // namespace awdmisuse
