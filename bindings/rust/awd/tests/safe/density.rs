// SPDX-License-Identifier: Apache-2.0
//! Densities through the safe interface.

use std::thread;

use crate::common::{device, uniforms};
use awd::{
    CoefficientForm, Density, DensityAxis, DensitySettings, DensityStructure, ErrorCode, Estimator,
    Sampler, INVALID_ID,
};

fn settings(dimensions: u32) -> DensitySettings {
    DensitySettings { dimensions, ..Default::default() }
}

fn f(x: &[f64]) -> f64 {
    x.iter().map(|x| (-3.0 * x).exp()).product()
}

fn values(points: &[f64], dimensions: usize) -> Vec<f64> {
    points.chunks(dimensions).map(f).collect()
}

/// Two passes; the second is what the first has taught.
fn learned(mut density: Density) -> Density {
    for _ in 0..2 {
        let samples = density.sample(&uniforms(2 * 3000)).unwrap();
        let values = values(&samples.points, 2);
        density.record(&samples.points, Some(&samples.pdfs), None, &values).unwrap();
        assert_eq!(density.adapt().unwrap().samples, 3000);
    }
    density
}

#[test]
fn learns_and_tells_the_integral() {
    let device = device();
    let mut density = learned(Density::new(&device, &settings(2)).unwrap());
    let truth = ((1.0 - (-3.0f64).exp()) / 3.0).powi(2);
    let estimate = density.estimate().unwrap();
    assert!((estimate.integral - truth).abs() < 0.05 * truth, "{:?}", estimate);
    assert_eq!((estimate.samples, estimate.passes), (6000, 2));
    let pdf = density.pdf(&[0.05, 0.05, 0.95, 0.95]).unwrap();
    assert!(pdf[0] > 10.0 * pdf[1], "{:?}", pdf);
    assert!((density.integral(&[0.0; 2], &[1.0; 2]).unwrap() - 1.0).abs() < 1e-12);
    let info = density.info().unwrap();
    assert_eq!((info.dimensions, info.uniforms, info.passes), (2, 2, 2));
    assert_eq!(info.structure, DensityStructure::Grid);
}

#[test]
fn pdfs_of_samples_are_those_of_points() {
    let density = learned(Density::new(&device(), &settings(2)).unwrap());
    let samples = density.sample(&uniforms(2 * 100)).unwrap();
    assert_eq!(density.pdf(&samples.points).unwrap(), samples.pdfs);
    assert!(samples.components.iter().all(|component| *component == INVALID_ID));
}

#[test]
fn threads_with_forks_give_the_bits_of_one() {
    let device = device();
    let mut one = Density::new(&device, &settings(2)).unwrap();
    let mut many = Density::new(&device, &settings(2)).unwrap();
    let uniforms = uniforms(2 * 4000);
    let record = |density: &mut Density, uniforms: &[f64]| {
        let samples = density.sample(uniforms).unwrap();
        let values = values(&samples.points, 2);
        density.record(&samples.points, Some(&samples.pdfs), None, &values).unwrap();
    };
    record(&mut one, &uniforms);
    let mut forks: Vec<Density> = (0..4).map(|_| many.fork().unwrap()).collect();
    thread::scope(|scope| {
        for (fork, part) in forks.iter_mut().zip(uniforms.chunks(2 * 1000)) {
            scope.spawn(|| record(fork, part));
        }
    });
    for fork in &mut forks {
        many.join(fork).unwrap();
    }
    one.adapt().unwrap();
    many.adapt().unwrap();
    let bits = |density: &Density| density.coefficients(CoefficientForm::Scaling).unwrap();
    assert_eq!(bits(&one), bits(&many));
}

#[test]
fn statistics_and_whole_densities_travel_as_bytes() {
    let device = device();
    let mut first = learned(Density::new(&device, &settings(2)).unwrap());
    let mut second = Density::load(&device, &first.save().unwrap()).unwrap();
    let samples = first.sample(&uniforms(2 * 500)).unwrap();
    let values = values(&samples.points, 2);
    first.record(&samples.points, None, None, &values).unwrap();
    let bytes = first.export_statistics().unwrap();
    second.add_statistics(&bytes).unwrap();
    assert_eq!(second.info().unwrap().samples, 500);
    second.add_statistics(&bytes).unwrap();
    assert_eq!(second.info().unwrap().samples, 1000);
    second.import_statistics(&bytes).unwrap();
    first.adapt().unwrap();
    second.adapt().unwrap();
    assert_eq!(first.save().unwrap(), second.save().unwrap());

    let mut damaged = first.save().unwrap();
    damaged[40] ^= 1;
    assert_eq!(Density::load(&device, &damaged).unwrap_err().code(), ErrorCode::Io);
    assert!(Density::load(&device, &[]).is_err());
    assert!(second.add_statistics(&[]).is_err());
}

#[test]
fn trees_tell_their_boxes_and_details() {
    let axis =
        DensityAxis { basis: Some("haar".into()), start_level: Some(1), ..Default::default() };
    let tree = DensitySettings {
        structure: DensityStructure::Tree,
        axes: vec![axis.clone(), axis],
        ..settings(2)
    };
    let mut density = learned(Density::new(&device(), &tree).unwrap());
    let leaves = density.leaves().unwrap();
    assert_eq!(leaves.len() as u64, density.info().unwrap().leaves);
    let volume = |item: &awd::DensityBox| -> f64 {
        item.lower.iter().zip(&item.upper).map(|(lower, upper)| upper - lower).product()
    };
    assert_eq!(leaves.iter().map(volume).sum::<f64>(), 1.0);
    let coefficients = density.coefficients(CoefficientForm::Orthonormal).unwrap();
    let squares: f64 = coefficients.iter().map(|c| c * c).sum();
    let energies = density.detail_energy().unwrap();
    assert!((energies.iter().sum::<f64>() - squares).abs() < 1e-9 * squares);
    assert_eq!(density.axis(0).unwrap().basis, "haar");
    assert!(density.axis(0).unwrap().flags.nested());
}

#[test]
fn coefficients_can_be_set_and_refined() {
    let axes = vec![DensityAxis { start_level: Some(1), ..Default::default() }];
    let mut density = Density::new(&device(), &DensitySettings { axes, ..settings(1) }).unwrap();
    density.set_coefficients(&[0.0, 1.0, 0.0]).unwrap();
    let before = density.pdf(&[0.1, 0.5, 0.7]).unwrap();
    density.refine(None).unwrap();
    density.refine(Some(0)).unwrap();
    assert_eq!(density.coefficients(CoefficientForm::Scaling).unwrap().len(), 9);
    for (before, after) in before.iter().zip(density.pdf(&[0.1, 0.5, 0.7]).unwrap()) {
        assert!((before - after).abs() < 1e-12);
    }
    assert!(density.set_coefficients(&[1.0]).is_err());
    assert!(density.set_coefficients(&[]).is_err());
    assert!(density.refine(Some(7)).is_err());
}

#[test]
fn components_go_back_with_their_points() {
    let paper =
        DensitySettings { estimator: Estimator::Paper, sampler: Sampler::Component, ..settings(2) };
    let mut density = Density::new(&device(), &paper).unwrap();
    assert_eq!(density.uniforms(), 3);
    let samples = density.sample(&uniforms(3 * 100)).unwrap();
    let values = values(&samples.points, 2);
    let (points, pdfs) = (&samples.points, Some(&samples.pdfs[..]));
    assert!(density.record(points, pdfs, None, &values).is_err());
    assert!(density.record(points, pdfs, Some(&[u32::MAX; 100]), &values).is_err());
    density.record(points, pdfs, Some(&samples.components), &values).unwrap();
}

#[test]
fn wrong_lengths_never_reach_the_library() {
    let mut density = Density::new(&device(), &settings(2)).unwrap();
    let refused = |outcome: awd::Result<()>| {
        assert_eq!(outcome.unwrap_err().code(), ErrorCode::InvalidArgument);
    };
    refused(density.sample(&[0.5; 3]).map(|_| ()));
    refused(density.sample_into(&[0.5; 4], &mut [0.0; 3], None, None));
    refused(density.sample_into(&[0.5; 4], &mut [0.0; 4], Some(&mut [0.0]), None));
    refused(density.sample_into(&[0.5; 4], &mut [0.0; 4], None, Some(&mut [0; 3])));
    refused(density.pdf(&[0.5; 5]).map(|_| ()));
    refused(density.pdf_into(&[0.5; 4], &mut [0.0; 3]));
    refused(density.record(&[0.5; 4], None, None, &[1.0]));
    refused(density.record(&[0.5; 4], Some(&[1.0]), None, &[1.0; 2]));
    refused(density.record(&[0.5; 4], None, Some(&[1]), &[1.0; 2]));
    refused(density.integral(&[0.0], &[1.0; 2]).map(|_| ()));
    refused(density.integral(&[0.0; 2], &[1.0; 3]).map(|_| ()));
    assert_eq!(density.info().unwrap().samples, 0);
    assert!(density.sample(&[]).unwrap().points.is_empty());
    density.record(&[], None, None, &[]).unwrap();
}

#[test]
fn the_message_is_the_librarys() {
    let device = device();
    let error = Density::new(&device, &settings(9)).unwrap_err();
    assert_eq!(error.code(), ErrorCode::InvalidArgument);
    assert!(error.message().contains("desc->dimensions is 9: 1 to 6 is allowed"), "{}", error);
    let axis = |name: &str| DensityAxis { basis: Some(name.into()), ..Default::default() };
    let with = |axes| Density::new(&device, &DensitySettings { axes, ..settings(1) }).unwrap_err();
    assert_eq!(with(vec![axis("no-such")]).code(), ErrorCode::Unsupported);
    assert_eq!(with(vec![axis("ha\0ar")]).code(), ErrorCode::InvalidArgument);
    assert_eq!(with(vec![axis("haar"), axis("haar")]).code(), ErrorCode::InvalidArgument);
    let level = DensityAxis { start_level: Some(u32::MAX), ..Default::default() };
    assert_eq!(with(vec![level]).code(), ErrorCode::InvalidArgument);
}
