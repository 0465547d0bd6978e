// SPDX-License-Identifier: Apache-2.0
// Scenes of more triangles that look the same.
#pragma once

#include "render_shots.h"

namespace bench::paper {

/// The same surfaces, camera and reference; each triangle is n x n equal ones.
LoadedScene cutScene(const awd::Device& device, const LoadedScene& whole, uint32_t n);

}  // namespace bench::paper
