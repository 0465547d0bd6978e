// SPDX-License-Identifier: Apache-2.0
//! Rays and what they meet, laid out as in C.

use awd_sys::*;

use crate::Vector;

/// A ray o + t d, tnear <= t <= tfar; tnear is finite and not below 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// o, finite.
    pub origin: Vector,
    /// Where it begins.
    pub tnear: f32,
    /// d, finite; need not be a unit vector.
    pub direction: Vector,
    /// Where it ends; may be infinite.
    pub tfar: f32,
}

impl Ray {
    /// The whole half-line from a point.
    pub fn new(origin: Vector, direction: Vector) -> Self {
        Ray { origin, tnear: 0.0, direction, tfar: f32::INFINITY }
    }
}

/// What a ray meets first.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Hit {
    /// Infinite if nothing was hit.
    pub t: f32,
    /// Geometric, unit, front side.
    pub normal: Vector,
    /// Barycentric: (1-u-v) p0 + u p1 + v p2.
    pub u: f32,
    /// Barycentric.
    pub v: f32,
    /// [`INVALID_ID`](crate::INVALID_ID) if nothing was hit.
    pub mesh: u32,
    /// Within the mesh.
    pub triangle: u32,
    /// Of the triangle.
    pub material: u32,
    /// With the highest bit if met on the back side.
    pub patch: u32,
}

same_layout! {
    ray_is_as_in_c: Ray = AWDRay {
        origin = origin,
        tnear = tnear,
        direction = direction,
        tfar = tfar,
    }
}

same_layout! {
    hit_is_as_in_c: Hit = AWDHit {
        t = t,
        normal = normal,
        u = u,
        v = v,
        mesh = mesh,
        triangle = triangle,
        material = material,
        patch = patch,
    }
}
