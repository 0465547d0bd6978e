// SPDX-License-Identifier: Apache-2.0
//! Directions and paths, laid out as in C.

use awd_sys::*;

use crate::{Vector, INVALID_ID};

/// A direction drawn from a patch.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DirectionSample {
    /// Unit vector in the upper hemisphere of the normal.
    pub direction: Vector,
    /// In solid angle, 1/sr.
    pub pdf: f32,
    /// The same point on the unit square.
    pub square: [f32; 2],
    /// The basis function drawn from; [`INVALID_ID`] unless the estimator is paper.
    pub component: u32,
    /// |d omega / d(u,v)| there, sr: the pdf on the square is `pdf * solid_angle`.
    pub solid_angle: f32,
}

/// Where a path met a surface, and how it went on.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathVertex {
    /// [`INVALID_ID`]: nothing is recorded here, say of a mirror.
    pub patch: u32,
    /// Chance with which the path went on, in (0,1]; 0: it ended here.
    pub continuation: f32,
    /// In which it went on; `pdf`: with which that was drawn.
    pub sample: DirectionSample,
    /// What the surface emits towards the vertex before, times the weight with which the host
    /// combines that with shadow rays.
    pub emitted: Vector,
    /// What it reflects of light found by shadow rays, combined likewise.
    pub direct: Vector,
    /// f_r cos(theta) of the sampled direction, not divided by anything.
    pub scattering: Vector,
}

impl Default for PathVertex {
    /// A black end of which nothing is recorded.
    fn default() -> Self {
        PathVertex {
            patch: INVALID_ID,
            continuation: 0.0,
            sample: Default::default(),
            emitted: Default::default(),
            direct: Default::default(),
            scattering: Default::default(),
        }
    }
}

same_layout! {
    direction_sample_is_as_in_c: DirectionSample = AWDDirectionSample {
        direction = direction,
        pdf = pdf,
        square = square,
        component = component,
        solid_angle = solidAngle,
    }
}

same_layout! {
    path_vertex_is_as_in_c: PathVertex = AWDPathVertex {
        patch = patch,
        continuation = continuation,
        sample = sample,
        emitted = emitted,
        direct = direct,
        scattering = scattering,
    }
}
