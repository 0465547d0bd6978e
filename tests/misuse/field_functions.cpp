// SPDX-License-Identifier: Apache-2.0
// How the functions of awd/field.h and awd/light.h are called.
#include "misuse/functions.h"

namespace awdmisuse {

namespace {

constexpr size_t kBatch = 8;
constexpr size_t kHostField = 1;  // with the host's patches and lights; 0 has spatial ones

AWDDirectionSample directionSample(Caller& c) {
  AWDDirectionSample sample = {};
  sample.direction[2] = 1.0f;
  sample.pdf = 0.3f;
  sample.square[0] = c.coordinate();
  sample.square[1] = c.coordinate();
  sample.component = c.wild() ? c.oneOf(20) : AWD_INVALID_ID;
  sample.solidAngle = 3.0f;
  c.spoil(sample.pdf);
  c.spoil(sample.solidAngle);
  return sample;
}

AWDPathVertex pathVertex(Caller& c) {
  AWDPathVertex vertex = {};
  vertex.patch = c.wild() ? c.oneOf(40) : 8;
  c.spoil(vertex.patch);
  vertex.continuation = c.wild() ? c.coordinate() : 0.5f;
  vertex.sample = directionSample(c);
  for (int i = 0; i < 3; ++i) {
    vertex.emitted[i] = c.coordinate();
    vertex.direct[i] = c.coordinate();
    vertex.scattering[i] = c.coordinate();
  }
  return vertex;
}

const uint32_t* patchesOf(Caller& c, size_t count) {
  return c.in<uint32_t>(count, [&] {
    uint32_t patch = c.wild() ? 8 * c.oneOf(4) : 8;
    c.spoil(patch);
    return patch;
  });
}

void addFieldLife(std::vector<Function>& all) {
  all.push_back({"awdNewField", [](Caller& c) {
                   c(awdNewField, Args{c.device(), fieldDesc(c), c.made<AWDField>()});
                 }});
  all.push_back({"awdRetainField", [](Caller& c) { c.retained(awdRetainField); }});
  all.push_back({"awdReleaseField", [](Caller& c) { c.released(awdReleaseField); }});
  all.push_back({"awdSetFieldScale", [](Caller& c) {
                   c(awdSetFieldScale, Args{c.field(), c.number(2.0)});
                 }});
  for (const auto& [name, function] : {std::pair{"awdAdaptField", &awdAdaptField},
                                       {"awdGetFieldStatistics", awdGetFieldStatistics}}) {
    const bool mayBeNull = function == awdAdaptField;
    all.push_back({name, [function = function, mayBeNull](Caller& c) {
                     c(function, Args{c.field(), c.outStruct<AWDFieldStatistics>(
                                                     AWD_FIELD_STATISTICS_INIT, mayBeNull)});
                   }});
  }
  all.push_back({"awdMarkField", [](Caller& c) { c(awdMarkField, Args{c.field()}); }});
  all.push_back({"awdRevertField", [](Caller& c) { c(awdRevertField, Args{c.field()}); }});
  all.push_back({"awdMergeField", [](Caller& c) {
                   AWDField other = nullptr;
                   const std::vector<char>& bytes = c.world().fieldBytes;
                   if (!c.wild()) {
                     for (int i = 0; i < 2; ++i) {
                       awdLoadField(c.world().devices[0], bytes.data(), bytes.size(), &other);
                       c.world().fields.push_back(other);
                     }
                   }
                   const size_t last = c.world().fields.size() - 1;
                   const AWDField into = c.first(last).field();
                   c(awdMergeField, Args{into, c.first(last - 1).field()});
                 }});
}

void addSampling(std::vector<Function>& all) {
  all.push_back({"awdFindPatch", [](Caller& c) {
                   c(awdFindPatch, Args{c.field(), c.places(1), c.units(1), c.out<uint32_t>(1)});
                 }});
  all.push_back({"awdSampleField", [](Caller& c) {
                   c(awdSampleField, Args{c.field(), c.patch(), c.units(1), c.uniforms(3),
                                          c.out<AWDDirectionSample>(1)});
                 }});
  all.push_back(
      {"awdGetFieldPdf", [](Caller& c) {
         c(awdGetFieldPdf, Args{c.field(), c.patch(), c.units(1), c.units(1), c.out<float>(1)});
       }});
  all.push_back({"awdRecordField", [](Caller& c) {
                   const AWDField field = c.field();
                   const uint32_t patch = c.patch();
                   const AWDDirectionSample* sample =
                       c.in<AWDDirectionSample>(1, [&] { return directionSample(c); });
                   c(awdRecordField, Args{field, patch, sample, c.number(1.0)});
                 }});
  all.push_back({"awdMapDirection", [](Caller& c) {
                   c(awdMapDirection, Args{c.field(), c.patch(), c.units(1), c.units(1),
                                           c.out<AWDDirectionSample>(1)});
                 }});
  all.push_back({"awdFindPatches", [](Caller& c) {
                   const AWDField field = c.field();
                   const size_t n = c.count(kBatch);
                   c(awdFindPatches, Args{field, n, c.places(n), c.units(n), c.out<uint32_t>(n)});
                 }});
  all.push_back({"awdSampleFieldBatch", [](Caller& c) {
                   const AWDField field = c.field();
                   const size_t n = c.count(kBatch);
                   c(awdSampleFieldBatch, Args{field, n, patchesOf(c, n), c.units(n),
                                               c.uniforms(3 * n), c.out<AWDDirectionSample>(n)});
                 }});
  all.push_back({"awdGetFieldPdfs", [](Caller& c) {
                   const AWDField field = c.field();
                   const size_t n = c.count(kBatch);
                   c(awdGetFieldPdfs,
                     Args{field, n, patchesOf(c, n), c.units(n), c.units(n), c.out<float>(n)});
                 }});
  all.push_back({"awdRecordFieldBatch", [](Caller& c) {
                   const AWDField field = c.field();
                   const size_t n = c.count(kBatch);
                   const uint32_t* patches = patchesOf(c, n);
                   const AWDDirectionSample* samples =
                       c.in<AWDDirectionSample>(n, [&] { return directionSample(c); });
                   c(awdRecordFieldBatch, Args{field, n, patches, samples, c.uniforms(n)});
                 }});
  all.push_back(
      {"awdRecordFieldPath", [](Caller& c) {
         const AWDField field = c.field();
         const size_t n = c.count(kBatch);
         const AWDPathVertex* vertices = c.in<AWDPathVertex>(n, [&] { return pathVertex(c); });
         const float* background = c.in<float>(
             3, [&] { return c.coordinate(); }, true);
         c(awdRecordFieldPath, Args{field, n, vertices, background, c.out<float>(3, true)});
       }});
}

void addQueries(std::vector<Function>& all) {
  all.push_back({"awdGetFieldPatches", [](Caller& c) {
                   const AWDField field = c.field();
                   const size_t n = c.count(kBatch);
                   c(awdGetFieldPatches, Args{field, c.out<uint32_t>(n), n, c.out<size_t>(1)});
                 }});
  all.push_back({"awdGetPatchInfo", [](Caller& c) {
                   c(awdGetPatchInfo,
                     Args{c.field(), c.patch(), c.outStruct<AWDPatchInfo>(AWD_PATCH_INFO_INIT)});
                 }});
  all.push_back({"awdGetPatchCoefficients", [](Caller& c) {
                   const AWDField field = c.field();
                   const uint32_t patch = c.patch();
                   const size_t n = c.count(1024);
                   c(awdGetPatchCoefficients, Args{field, patch, c.out<double>(n), n});
                 }});
  all.push_back({"awdGetPatchMean", [](Caller& c) {
                   c(awdGetPatchMean, Args{c.field(), c.patch(), c.out<float>(1)});
                 }});
  all.push_back({"awdGetContinuation", [](Caller& c) {
                   c(awdGetContinuation, Args{c.field(), c.patch(), c.number(1.0f), c.number(1.0f),
                                              c.number<uint32_t>(4), c.out<float>(1)});
                 }});
  all.push_back(
      {"awdGetPatchPdf", [](Caller& c) {
         const AWDField field = c.field();
         const uint32_t patch = c.patch();
         const uint32_t n = c.number<uint32_t>(4, {0, 1, 3, 16385, UINT32_MAX});
         const size_t stride = c.number<size_t>(20, {0, 1, 15, 16, 24});
         const size_t row = stride ? stride : 4 * sizeof(float);
         c(awdGetPatchPdf, Args{field, patch, n, c.out<float>((3 * row + 16 + 3) / 4), stride});
       }});
}

void addLights(std::vector<Function>& all) {
  all.push_back({"awdChooseLight", [](Caller& c) {
                   c(awdChooseLight,
                     Args{c.first(kHostField).field(), c.patch(), c.number(0.5), c.out<uint32_t>(1),
                          c.out<float>(1), c.out<double>(1, true)});
                 }});
  all.push_back({"awdGetLightChance", [](Caller& c) {
                   c(awdGetLightChance, Args{c.first(kHostField).field(), c.patch(),
                                             c.number<uint32_t>(1), c.out<float>(1)});
                 }});
  all.push_back({"awdRecordLight", [](Caller& c) {
                   c(awdRecordLight, Args{c.first(kHostField).field(), c.patch(),
                                          c.number<uint32_t>(1), c.number(1.0)});
                 }});
  all.push_back(
      {"awdGetPatchLight", [](Caller& c) {
         c(awdGetPatchLight, Args{c.first(kHostField).field(), c.patch(), c.out<float>(1)});
       }});
}

/// Those that any process may have recorded in.
const uint32_t* exchanged(Caller& c, size_t count) {
  uint32_t next = 0;
  return c.in<uint32_t>(count, [&] {
    uint32_t patch = next++;
    c.spoil(patch);
    return patch;
  });
}

void addBytes(std::vector<Function>& all) {
  all.push_back({"awdSaveField", [](Caller& c) {
                   const AWDField field = c.field();
                   const size_t n = c.count(1 << 16);
                   c(awdSaveField, Args{field, c.out<char>(n), n, c.out<size_t>(1)});
                 }});
  all.push_back({"awdLoadField", [](Caller& c) {
                   const AWDDevice device = c.device();
                   size_t size = 0;
                   const void* bytes = c.bytes(c.world().fieldBytes, size);
                   c(awdLoadField, Args{device, bytes, size, c.made<AWDField>()});
                 }});
  all.push_back({"awdWriteField", [](Caller& c) {
                   c(awdWriteField, Args{c.field(), c.outPath()});
                 }});
  all.push_back(
      {"awdReadField", [](Caller& c) {
         c(awdReadField, Args{c.device(), c.path(c.world().fieldFile), c.made<AWDField>()});
       }});
  all.push_back({"awdExportField", [](Caller& c) {
                   const AWDField field = c.first(kHostField).field();
                   const size_t n = c.count(2);
                   const uint32_t* patches = exchanged(c, n);
                   const size_t capacity = c.count(4096);
                   c(awdExportField, Args{field, patches, n, c.out<uint64_t>(capacity), capacity,
                                          c.out<size_t>(1), c.out<size_t>(1)});
                 }});
  all.push_back({"awdImportField", [](Caller& c) {
                   const AWDField field = c.first(kHostField).field();
                   const size_t n = c.wild() ? c.count(2) : 0;
                   const uint32_t* patches = c.in<uint32_t>(
                       n, [&] { return c.oneOf(8); }, true);
                   size_t count = 0;
                   const uint64_t* numbers = c.bytes(c.world().fieldNumbers, count);
                   c(awdImportField, Args{field, patches, n, numbers, count});
                 }});
}

}  // namespace

const AWDFieldDesc* fieldDesc(Caller& c) {
  return c.desc<AWDFieldDesc>(
      AWD_FIELD_DESC_INIT,
      [&](AWDFieldDesc& desc) {
        c.spoil(desc.preset);
        c.spoil(desc.map);
        c.spoil(desc.basis, {"haar", "nonesuch", "", "m2", "misuse"});
        c.spoil(desc.startLevel, {1, 2, 4, 30, UINT32_MAX});
        c.spoil(desc.maxLevel, {1, 2, 4, 30, UINT32_MAX});
        c.spoil(desc.tau);
        c.spoil(desc.estimator, {1, 2, 3, 4, 5, 6, 7, -1});
        c.spoil(desc.refitSolver, {"", "descent", "none"});
        c.spoil(desc.shrinkage);
        c.spoil(desc.patches);
        for (int i = 0; i < 3; ++i) {
          c.spoil(desc.lower[i]);
          c.spoil(desc.upper[i]);
        }
        c.spoil(desc.patchSamples, {1, 2, 100, UINT32_MAX});
        c.spoil(desc.alpha);
        c.spoil(desc.maxBytes);
        static const float kPowers[64] = {1.0f, 0.0f, 2.0f};
        static const float kBad[64] = {1.0f, -1.0f};
        c.spoil(desc.lightCount, {1, 2, 64, 65, UINT32_MAX});
        c.spoil(desc.lightPowers, {kPowers, kBad, kPowers + 3 - 3});
        c.spoil(desc.target);
      },
      true);
}

void addFieldFunctions(std::vector<Function>& all) {
  addFieldLife(all);
  addSampling(all);
  addQueries(all);
  addLights(all);
  addBytes(all);
}

}  // namespace awdmisuse
