// SPDX-License-Identifier: Apache-2.0
//! What several tests start from.

use awd::{Camera, Device, Material, Mesh, RenderSettings, Scene, SceneBuilder, Vector};

pub const UP: Vector = [0.0, 1.0, 0.0];

pub fn device() -> Device {
    Device::new(Default::default()).unwrap()
}

pub const VERTICES: [Vector; 8] = [
    [-1.0, 0.0, 1.0],
    [1.0, 0.0, 1.0],
    [1.0, 0.0, -1.0],
    [-1.0, 0.0, -1.0],
    [-0.5, 1.0, -0.5],
    [0.5, 1.0, -0.5],
    [0.5, 1.0, 0.5],
    [-0.5, 1.0, 0.5],
];
pub const INDICES: [[u32; 3]; 4] = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]];
pub const MATERIALS: [u32; 4] = [0, 0, 1, 1];

/// A grey floor and, not committed yet, a lamp above it that shines down.
pub fn builder(device: &Device) -> SceneBuilder {
    let mut builder = SceneBuilder::new(device).unwrap();
    let grey = Material { albedo: [0.5; 3], emission: [0.0; 3] };
    let lamp = Material { albedo: [0.0; 3], emission: [4.0; 3] };
    assert_eq!(builder.add_material(&grey).unwrap(), 0);
    assert_eq!(builder.add_material(&lamp).unwrap(), 1);
    let mesh = Mesh {
        vertices: (&VERTICES).into(),
        indices: (&INDICES).into(),
        materials: (&MATERIALS).into(),
        ..Default::default()
    };
    assert_eq!(builder.add_mesh(&mesh).unwrap(), 0);
    builder
}

pub fn scene(device: &Device) -> Scene {
    builder(device).commit().unwrap()
}

/// 16 x 16 pixels.
pub fn settings() -> RenderSettings {
    let camera = Camera { eye: [0.0, 0.5, 4.0], width: 16, height: 16, ..Default::default() };
    RenderSettings { camera, seed: 1, ..Default::default() }
}

/// Numbers in [0,1), the same every time, by SplitMix64.
pub fn uniforms(count: usize) -> Vec<f64> {
    let number = |i: u64| {
        let z = i.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    };
    (1..=count as u64).map(number).collect()
}
