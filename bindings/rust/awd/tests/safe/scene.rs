// SPDX-License-Identifier: Apache-2.0
//! Scenes through the safe interface.

use crate::common::{builder, device, scene, settings, INDICES, VERTICES};
use awd::{Buffer, ErrorCode, Mesh, Ray, Render, SceneBuilder, INVALID_ID, PATCH_BACK};

#[test]
fn rays_meet_what_is_there() {
    let scene = scene(&device());
    let down = [0.0, -1.0, 0.0];
    let rays = [
        Ray::new([0.0, 0.5, 0.0], down),
        Ray::new([0.0, 0.5, 0.0], [0.0, 1.0, 0.0]),
        Ray::new([5.0, 0.5, 0.0], down),
        Ray { tfar: 0.25, ..Ray::new([0.0, 0.5, 0.0], down) },
    ];
    let hits = scene.intersect(&rays).unwrap();
    assert_eq!((hits[0].t, hits[0].material), (0.5, 0));
    assert_eq!((hits[1].t, hits[1].material), (0.5, 1));
    assert_eq!((hits[2].mesh, hits[2].t), (INVALID_ID, f32::INFINITY));
    assert_eq!(scene.occluded(&rays).unwrap(), [true, true, false, false]);
    let nan = Ray::new([f32::NAN; 3], down);
    assert!(scene.intersect(&[nan]).is_err());
    assert!(scene.occluded(&[nan]).is_err());
    assert!(scene.intersect(&[]).unwrap().is_empty());
    let floor = scene.triangle_patch(0, 0, false).unwrap().unwrap();
    assert_eq!(scene.triangle_patch(0, 1, true).unwrap(), Some(floor | PATCH_BACK));
    assert_eq!(scene.point_patch([0.0, 0.1, 0.0]).unwrap(), Some(floor));
    assert!(scene.triangle_patch(3, 0, false).is_err());
    assert!(scene.point_patch([f32::INFINITY; 3]).is_err());
    let info = scene.info().unwrap();
    assert_eq!(
        (info.triangles, info.lights, info.lower, info.upper[1]),
        (4, 1, [-1.0, 0.0, -1.0], 1.0)
    );
}

#[test]
fn what_cannot_be_committed_comes_back() {
    let device = device();
    let mut bad = builder(&device);
    let mesh = Mesh {
        vertices: (&VERTICES).into(),
        indices: (&[[0, 1, 99]]).into(),
        ..Default::default()
    };
    bad.add_mesh(&mesh).unwrap();
    let returned = bad.commit().unwrap_err();
    assert_eq!(returned.error.code(), ErrorCode::InvalidArgument);
    assert!(returned.error.message().contains("99"), "{}", returned);
    assert!(returned.value.commit().is_err());
}

#[test]
fn buffers_may_be_strided() {
    let device = device();
    let mut data = vec![9.0f32; 1];
    for vertex in VERTICES {
        data.extend(vertex);
        data.extend([7.0; 2]);
    }
    let mut strided = SceneBuilder::new(&device).unwrap();
    strided.add_material(&Default::default()).unwrap();
    let vertices = Buffer::strided(&data, 1, 5, 8).unwrap();
    let indices = Buffer::from(&INDICES);
    strided.add_mesh(&Mesh { vertices, indices, ..Default::default() }).unwrap();
    let info = strided.commit().unwrap().info().unwrap();
    assert_eq!((info.lower, info.upper), (scene(&device).info().unwrap().lower, [1.0, 1.0, 1.0]));

    // Up to the last number, and no further.
    assert!(Buffer::<[f32; 3]>::strided(&data[..data.len() - 2], 1, 5, 8).is_ok());
    assert!(Buffer::<[f32; 3]>::strided(&data[..data.len() - 3], 1, 5, 8).is_err());
    assert!(Buffer::<[f32; 3]>::strided(&data, 1, 0, 8).is_err());
    assert!(Buffer::<[f32; 3]>::strided(&data, usize::MAX, 5, 2).is_err());
    assert!(Buffer::<u32>::strided(&[1, 2], 0, usize::MAX, usize::MAX).is_err());
    assert!(Buffer::<u32>::strided(&[], 0, 1, 0).unwrap().is_empty());
}

#[test]
fn a_scene_in_use_cannot_be_changed() {
    let scene = scene(&device());
    let render = Render::new(&scene, &settings()).unwrap();
    let scene = scene.edit().unwrap_err();
    drop(render);
    let mut builder = scene.edit().unwrap();
    let indices = Buffer::from(&INDICES);
    builder
        .add_mesh(&Mesh { vertices: (&VERTICES).into(), indices, ..Default::default() })
        .unwrap();
    assert_eq!(builder.commit().unwrap().info().unwrap().triangles, 8);
}
