// SPDX-License-Identifier: Apache-2.0
//! Fields through the safe interface.

use std::f32::consts::FRAC_PI_2;
use std::thread;

use crate::common::{device, uniforms, UP};
use awd::{
    Device, DirectionSample, ErrorCode, Field, FieldSettings, Patches, PathVertex, Vector,
    INVALID_ID, PATCH_BACK,
};

const COUNT: usize = 3000;

fn spatial(device: &Device) -> Field {
    let bounds = Some(([-1.0; 3], [1.0; 3]));
    Field::new(device, &FieldSettings { bounds, light_count: 3, ..Default::default() }).unwrap()
}

/// Light from one half of the hemisphere.
fn brought(sample: &DirectionSample) -> f64 {
    if sample.direction[0] > 0.0 {
        f64::from(sample.direction[1])
    } else {
        0.0
    }
}

/// Records items `from`, `from + step` and so on of a pass.
fn record(field: &Field, from: usize, step: usize) {
    let u = uniforms(COUNT + 2);
    for i in (from..COUNT).step_by(step) {
        let position = [u[i] as f32 - 0.5, 0.0, u[i + 1] as f32 - 0.5];
        let patch = field.find_patch(position, UP).unwrap();
        let sample = field.sample(patch, UP, [u[i], u[i + 1], u[i + 2]]).unwrap();
        field.record(patch, &sample, brought(&sample)).unwrap();
    }
}

#[test]
fn threads_that_share_a_field_give_the_bits_of_one() {
    let device = device();
    let (mut one, mut many) = (spatial(&device), spatial(&device));
    for _ in 0..3 {
        record(&one, 0, 1);
        thread::scope(|scope| {
            for from in 0..4 {
                let many = &many;
                scope.spawn(move || record(many, from, 4));
            }
        });
        assert_eq!(one.adapt().unwrap().samples, COUNT as u64);
        many.adapt().unwrap();
    }
    assert_eq!(one.save().unwrap(), many.save().unwrap());
    assert!(one.statistics().unwrap().patches > 1);
}

#[test]
fn a_batch_is_many_single_calls() {
    let device = device();
    let (mut single, mut batch) = (spatial(&device), spatial(&device));
    record(&single, 0, 1);
    let u = uniforms(COUNT + 2);
    let positions: Vec<Vector> =
        (0..COUNT).map(|i| [u[i] as f32 - 0.5, 0.0, u[i + 1] as f32 - 0.5]).collect();
    let normals = vec![UP; COUNT];
    let mut patches = vec![0; COUNT];
    batch.find_patches(&positions, &normals, &mut patches).unwrap();
    let triples: Vec<[f64; 3]> = (0..COUNT).map(|i| [u[i], u[i + 1], u[i + 2]]).collect();
    let mut samples = vec![DirectionSample::default(); COUNT];
    batch.sample_batch(&patches, &normals, &triples, &mut samples).unwrap();
    let values: Vec<f64> = samples.iter().map(brought).collect();
    batch.record_batch(&patches, &samples, &values).unwrap();
    let directions: Vec<Vector> = samples.iter().map(|sample| sample.direction).collect();
    let mut pdfs = vec![0.0; COUNT];
    batch.pdfs(&patches, &normals, &directions, &mut pdfs).unwrap();
    for i in (0..COUNT).step_by(97) {
        assert_eq!(pdfs[i], batch.pdf(patches[i], UP, directions[i]).unwrap());
    }
    assert_eq!(single.save().unwrap(), batch.save().unwrap());
}

#[test]
fn parts_of_a_pass_are_merged() {
    let device = device();
    let mut whole = spatial(&device);
    record(&whole, 0, 1);
    whole.adapt().unwrap();
    let bytes = whole.save().unwrap();
    let mut first = Field::load(&device, &bytes).unwrap();
    let path = std::env::temp_dir().join(format!("awd-rust-{}.field", std::process::id()));
    whole.write(&path).unwrap();
    let mut second = Field::read(&device, &path).unwrap();
    std::fs::remove_file(&path).unwrap();
    record(&whole, 0, 1);
    record(&first, 0, 2);
    record(&second, 1, 2);
    first.merge(&mut second).unwrap();
    whole.adapt().unwrap();
    first.adapt().unwrap();
    assert_eq!(whole.save().unwrap(), first.save().unwrap());

    let mut damaged = bytes;
    damaged[100] ^= 1;
    assert_eq!(Field::load(&device, &damaged).unwrap_err().code(), ErrorCode::Io);
    assert_eq!(Field::read(&device, &path).unwrap_err().code(), ErrorCode::Io);
    assert!(first.merge(&mut spatial(&device)).is_err());
}

#[test]
fn patches_tell_what_they_know() {
    let mut field = spatial(&device());
    let patch = field.find_patch([0.0; 3], UP).unwrap();
    assert_eq!(field.patch_mean(patch).unwrap(), None);
    assert_eq!(field.continuation(patch, 1.0, 1.0, 0).unwrap(), None);
    assert!(field.patches().unwrap().is_empty());
    record(&field, 0, 1);
    field.adapt().unwrap();
    let patch = field.find_patch([0.0; 3], UP).unwrap();
    // The integral of cos(theta) over half of the hemisphere is pi / 2, with a standard error of
    // pi / 2 / sqrt(3000).
    let mean = field.patch_mean(patch).unwrap().unwrap();
    assert!((mean - FRAC_PI_2).abs() < 0.15, "{}", mean);
    assert!(field.continuation(patch, 1.0, mean, 0).unwrap().unwrap() > 0.9);
    assert!(!field.patches().unwrap().is_empty());
    let info = field.patch(patch).unwrap();
    assert_eq!(info.basis, "linear-bspline");
    let coefficients = field.patch_coefficients(patch).unwrap();
    assert_eq!(coefficients.len() as u32, info.axis_count * info.axis_count);
    let pixels = field.patch_pdf(patch, 32).unwrap();
    let average = pixels.iter().sum::<f32>() / pixels.len() as f32;
    assert!((average - 1.0).abs() < 0.05, "{}", average);
    assert!(field.patch_pdf(patch, 0).is_err());
    assert!(field.patch_pdf(patch, u32::MAX).is_err());
}

#[test]
fn lights_are_chosen_by_what_they_brought() {
    let mut field = spatial(&device());
    let patch = field.find_patch([0.0; 3], UP).unwrap();
    for uniform in uniforms(3000) {
        let chosen = field.choose_light(patch, uniform).unwrap();
        assert!(chosen.light < 3 && (0.0..1.0).contains(&chosen.rest));
        let value = if chosen.light == 2 { 1.0 } else { 0.0 };
        field.record_light(patch, chosen.light, value).unwrap();
    }
    field.adapt().unwrap();
    assert!(field.light_chance(patch, 2).unwrap() > 0.8);
    assert!(field.patch_light(patch).unwrap() > 0.5);
    assert!(field.light_chance(patch, 3).is_err());
    assert!(field.record_light(patch, 3, 1.0).is_err());
    assert!(field.choose_light(patch, 1.0).is_err());
    let without = Field::new(&device(), &Default::default()).unwrap();
    let error = without.choose_light(0, 0.5).unwrap_err();
    assert_eq!(error.code(), ErrorCode::InvalidOperation);
}

#[test]
fn a_path_brings_what_its_vertices_say() {
    let mut field = spatial(&device());
    let patch = field.find_patch([0.0; 3], UP).unwrap();
    let sample = field.map_direction(patch, UP, [0.6, 0.8, 0.0]).unwrap();
    let vertices = [
        PathVertex {
            patch,
            continuation: 0.5,
            sample,
            direct: [0.25; 3],
            scattering: [sample.pdf; 3],
            ..Default::default()
        },
        PathVertex { emitted: [1.0, 2.0, 3.0], ..Default::default() },
    ];
    let radiance = field.record_path(&vertices, None).unwrap();
    for (got, emitted) in radiance.iter().zip([1.0, 2.0, 3.0]) {
        assert!((got - (0.25 + 2.0 * emitted)).abs() < 1e-5, "{:?}", radiance);
    }
    let beyond = field.record_path(&vertices[..1], Some([1.0; 3])).unwrap();
    assert!((beyond[0] - 2.25).abs() < 1e-5, "{:?}", beyond);
    assert_eq!(field.record_path(&[], None).unwrap(), [0.0; 3]);
    assert_eq!(field.adapt().unwrap().samples, 2);
}

#[test]
fn marks_forget_what_came_after() {
    let mut field = spatial(&device());
    field.set_scale(4.0).unwrap();
    field.mark().unwrap();
    record(&field, 0, 1);
    field.revert().unwrap();
    assert_eq!(field.adapt().unwrap().samples, 0);
    assert!(field.set_scale(f64::NAN).is_err());
}

#[test]
fn no_number_does_harm() {
    let device = device();
    let host = FieldSettings { patches: Patches::Host, ..Default::default() };
    for field in [spatial(&device), Field::new(&device, &host).unwrap()] {
        for patch in [0, 1, 7, 123_456, 1 << 30, PATCH_BACK, PATCH_BACK | 77, INVALID_ID] {
            let sample = field.sample(patch, UP, [0.1, 0.2, 0.3]);
            let sample = sample.unwrap_or_default();
            let wild = DirectionSample { square: [f32::NAN, 1e30], component: 12_345, ..sample };
            let _ = field.record(patch, &sample, f64::NAN);
            let _ = field.record(patch, &wild, 1.0);
            let _ = field.pdf(patch, UP, [f32::NAN; 3]);
            let _ = field.pdf(patch, UP, UP);
            let _ = field.map_direction(patch, UP, UP);
            let _ = field.patch(patch);
            let _ = field.patch_coefficients(patch);
            let _ = field.patch_mean(patch);
            let _ = field.patch_pdf(patch, 3);
            let _ = field.patch_light(patch);
            let _ = field.record_light(patch, u32::MAX, 1.0);
            let _ = field.light_chance(patch, 0);
            let vertex =
                PathVertex { patch, continuation: 1.0, sample: wild, ..Default::default() };
            let _ = field.record_path(&[vertex], Some([f32::INFINITY; 3]));
            let _ = field.record_batch(&[patch, patch], &[wild, sample], &[1.0, 2.0]);
        }
        assert!(field.find_patch([f32::NAN; 3], UP).is_err());
        assert!(field.sample(0, [0.0; 3], [0.5; 3]).is_err());
        assert!(field.sample(0, UP, [1.0; 3]).is_err());
        let mut field = field;
        field.adapt().unwrap();
    }
}

#[test]
fn wrong_lengths_never_reach_the_library() {
    let field = spatial(&device());
    let sample = DirectionSample::default();
    assert!(field.find_patches(&[UP; 2], &[UP; 1], &mut [0; 2]).is_err());
    assert!(field.find_patches(&[UP; 2], &[UP; 2], &mut [0; 1]).is_err());
    assert!(field.sample_batch(&[0; 2], &[UP; 1], &[[0.5; 3]; 2], &mut [sample; 2]).is_err());
    assert!(field.sample_batch(&[0; 2], &[UP; 2], &[[0.5; 3]; 1], &mut [sample; 2]).is_err());
    assert!(field.sample_batch(&[0; 2], &[UP; 2], &[[0.5; 3]; 2], &mut [sample; 1]).is_err());
    assert!(field.pdfs(&[0; 2], &[UP; 2], &[UP; 1], &mut [0.0; 2]).is_err());
    assert!(field.pdfs(&[0; 2], &[UP; 1], &[UP; 2], &mut [0.0; 2]).is_err());
    assert!(field.pdfs(&[0; 2], &[UP; 2], &[UP; 2], &mut [0.0; 1]).is_err());
    assert!(field.record_batch(&[0; 2], &[sample; 1], &[1.0; 2]).is_err());
    assert!(field.record_batch(&[0; 2], &[sample; 2], &[1.0; 1]).is_err());
    let powers =
        FieldSettings { light_count: 2, light_powers: Some(vec![1.0]), ..Default::default() };
    assert!(Field::new(&device(), &powers).is_err());
}
