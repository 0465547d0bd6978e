// SPDX-License-Identifier: Apache-2.0
// Structs of the interface with what a fuzzer's bytes say: mostly of use, now and then anything.
#pragma once

#include "awd/awd.h"
#include "bytes.h"

namespace fuzz {

/// Any float: plain ones mostly.
float real32(Bytes& bytes);
/// One of a few settings, or now and then any number.
int32_t choice(Bytes& bytes, uint32_t known);
/// What it is, or now and then another.
size_t structSize(Bytes& bytes, size_t known);

AWDCamera readCamera(Bytes& bytes);
AWDMaterialDesc readMaterial(Bytes& bytes);
AWDRay readRay(Bytes& bytes);
/// camera: what the desc points to.
AWDRenderDesc readRenderDesc(Bytes& bytes, const AWDCamera* camera);
/// powers: room for AWD_MOST_FIELD_LIGHTS.
AWDFieldDesc readFieldDesc(Bytes& bytes, float* powers);
/// axes: room for AWD_MAX_DIMENSIONS.
AWDDensityDesc readDensityDesc(Bytes& bytes, AWDDensityAxis* axes);

}  // namespace fuzz
