// SPDX-License-Identifier: Apache-2.0
// A field's directions many at a time, and along paths.
#include "api/field_checks.h"
#include "api/handles.h"
#include "awd/field.h"

using namespace awd;

namespace {

/// Arrays that a batch of more than none must have.
template <class... Arrays>
void needAll(size_t count, const char* const* names, Arrays... arrays) {
  if (count == 0) return;
  (need(arrays, *names++), ...);
}

bool isRecorded(const AWDPathVertex& vertex) {
  return vertex.continuation > 0.0f && vertex.patch != AWD_INVALID_ID;
}

void checkVertex(const Field& field, const AWDPathVertex& vertex) {
  if (!(vertex.continuation >= 0.0f && vertex.continuation <= 1.0f)) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "continuation is %g: it must be in [0,1]",
         vertex.continuation);
  }
  if (isRecorded(vertex)) field.checkRecord(vertex.patch, vertex.sample);
}

}  // namespace

extern "C" {

AWDResult AWD_CALL awdMapDirection(AWDField field, uint32_t patch, const float normal[3],
                                   const float direction[3], AWDDirectionSample* sample) noexcept {
  return guard(__func__, [&] {
    *need(sample, "sample") =
        object(field, "field")
            .mapDirection(patch, unitVector(normal, "normal"), unitVector(direction, "direction"));
  });
}

AWDResult AWD_CALL awdFindPatches(AWDField field, size_t count, const float* positions,
                                  const float* normals, uint32_t* patches) noexcept {
  return guard(__func__, [&] {
    const Field& known = object(field, "field");
    checkSpatial(known);
    const char* const names[] = {"positions", "normals", "patches"};
    needAll(count, names, positions, normals, patches);
    forEachItem(count, [&](size_t i) {
      finitePoint(positions + 3 * i, "positions");
      unitVector(normals + 3 * i, "normals");
    });
    for (size_t i = 0; i < count; ++i) {
      patches[i] = known.findPatch(load(positions + 3 * i), unitVector(normals + 3 * i, "normals"));
    }
  });
}

AWDResult AWD_CALL awdSampleFieldBatch(AWDField field, size_t count, const uint32_t* patches,
                                       const float* normals, const double* uniforms,
                                       AWDDirectionSample* samples) noexcept {
  return guard(__func__, [&] {
    const Field& known = object(field, "field");
    const char* const names[] = {"patches", "normals", "uniforms", "samples"};
    needAll(count, names, patches, normals, uniforms, samples);
    forEachItem(count, [&](size_t i) {
      checkUniforms(uniforms + 3 * i);
      unitVector(normals + 3 * i, "normals");
    });
    for (size_t i = 0; i < count; ++i) {
      samples[i] =
          known.sample(patches[i], unitVector(normals + 3 * i, "normals"), uniforms + 3 * i);
    }
  });
}

AWDResult AWD_CALL awdGetFieldPdfs(AWDField field, size_t count, const uint32_t* patches,
                                   const float* normals, const float* directions,
                                   float* pdfs) noexcept {
  return guard(__func__, [&] {
    const Field& known = object(field, "field");
    const char* const names[] = {"patches", "normals", "directions", "pdfs"};
    needAll(count, names, patches, normals, directions, pdfs);
    forEachItem(count, [&](size_t i) {
      unitVector(normals + 3 * i, "normals");
      unitVector(directions + 3 * i, "directions");
    });
    for (size_t i = 0; i < count; ++i) {
      pdfs[i] = known.pdf(patches[i], unitVector(normals + 3 * i, "normals"),
                          unitVector(directions + 3 * i, "directions"));
    }
  });
}

AWDResult AWD_CALL awdRecordFieldBatch(AWDField field, size_t count, const uint32_t* patches,
                                       const AWDDirectionSample* samples,
                                       const double* values) noexcept {
  return guard(__func__, [&] {
    Field& known = idle(field, "field");
    const char* const names[] = {"patches", "samples", "values"};
    needAll(count, names, patches, samples, values);
    forEachItem(count, [&](size_t i) {
      checkSample(known, samples[i]);
      known.checkRecord(patches[i], samples[i]);
    });
    for (size_t i = 0; i < count; ++i) known.makeRoom(patches[i]);
    for (size_t i = 0; i < count; ++i) known.record(patches[i], samples[i], values[i]);
  });
}

AWDResult AWD_CALL awdRecordFieldPath(AWDField field, size_t count, const AWDPathVertex* vertices,
                                      const float background[3], float radiance[3]) noexcept {
  return guard(__func__, [&] {
    Field& known = idle(field, "field");
    if (count > 0) need(vertices, "vertices");
    forEachItem(count, [&](size_t i) { checkVertex(known, vertices[i]); });
    for (size_t i = 0; i < count; ++i) {
      if (isRecorded(vertices[i])) known.makeRoom(vertices[i].patch);
    }
    const Vec3d outside = background ? convert<double>(load(background)) : Vec3d();
    const Rgb seen = convert<float>(known.recordPath(vertices, count, outside));
    if (!radiance) return;
    radiance[0] = seen.x;
    radiance[1] = seen.y;
    radiance[2] = seen.z;
  });
}

}  // extern "C"
