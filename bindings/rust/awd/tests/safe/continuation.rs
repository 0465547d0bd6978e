// SPDX-License-Identifier: Apache-2.0
//! Checkpoints, and renders and fields in parts.

use crate::common::{device, scene, settings};
use awd::{ErrorCode, Field, FilmLayer, Render, RenderSettings, Schedule};

fn schedule() -> Schedule {
    Schedule { samples_per_pass: vec![1, 2, 3], ..Default::default() }
}

#[test]
fn a_checkpoint_goes_on_with_the_same_bits() {
    let scene = scene(&device());
    let mut whole = Render::new(&scene, &settings()).unwrap();
    whole.passes(&schedule()).unwrap();

    let path = std::env::temp_dir().join(format!("awd-checkpoint-{}", std::process::id()));
    let mut first = Render::new(&scene, &settings()).unwrap();
    first.passes(&Schedule { max_passes: 1, ..schedule() }).unwrap();
    first.save(&path).unwrap();
    let mut rest = Render::load(&scene, &path, Some(&settings())).unwrap();
    assert_eq!(rest.pass_statistics().unwrap().len(), 1);
    rest.passes(&Schedule { resume: true, ..schedule() }).unwrap();
    let film = |render: &mut Render| render.film(FilmLayer::Radiance).unwrap();
    assert_eq!(film(&mut rest), film(&mut whole));
    assert!(rest.field().is_some());

    let other = RenderSettings { seed: 99, ..settings() };
    let error = Render::load(&scene, &path, Some(&other)).unwrap_err();
    assert_eq!(error.code(), ErrorCode::InvalidArgument);
    std::fs::remove_file(&path).unwrap();
    assert_eq!(Render::load(&scene, &path, None).unwrap_err().code(), ErrorCode::Io);
}

#[test]
fn parts_make_the_whole() {
    let scene = scene(&device());
    let mut whole = Render::new(&scene, &settings()).unwrap();
    whole.passes(&schedule()).unwrap();

    let mut ranks: Vec<_> = (0..2).map(|_| Render::new(&scene, &settings()).unwrap()).collect();
    assert_eq!(ranks[0].export_pass().unwrap_err().code(), ErrorCode::InvalidOperation);
    loop {
        let samples = ranks[0].pass_part(&schedule(), 0, 2).unwrap();
        assert_eq!(ranks[1].pass_part(&schedule(), 1, 2).unwrap(), samples);
        if samples == 0 {
            break;
        }
        let (mine, theirs) = (ranks[0].export_pass().unwrap(), ranks[1].export_pass().unwrap());
        let mut all = mine.clone();
        assert!(all.combine(&theirs));
        for (i, (a, b)) in mine.numbers.iter().zip(&theirs.numbers).enumerate() {
            let combined = if i < mine.sums { a.wrapping_add(*b) } else { *a.max(b) };
            assert_eq!(all.numbers[i], combined);
        }
        for rank in &mut ranks {
            assert_eq!(rank.import_pass(&all.numbers).unwrap().samples_per_pixel, samples.into());
        }
    }
    for rank in &mut ranks {
        let film = rank.film(FilmLayer::Radiance).unwrap();
        assert_eq!(film, whole.film(FilmLayer::Radiance).unwrap());
        let learned = rank.field_mut().unwrap().save().unwrap();
        assert!(learned == whole.field_mut().unwrap().save().unwrap(), "fields differ");
        assert!(rank.import_pass(&[1, 2, 3]).is_err());
    }
}

#[test]
fn records_of_two_fields_are_those_of_one() {
    let device = device();
    let mut fields: Vec<_> =
        (0..3).map(|_| Field::new(&device, &Default::default()).unwrap()).collect();
    let up = [0.0, 1.0, 0.0];
    for i in 0..200 {
        let at = |k: u32| f64::from((i * k) % 200) / 200.0;
        let sample = fields[2].sample(7, up, [at(1), at(37), at(91)]).unwrap();
        fields[2].record(7, &sample, 1.0 + at(3)).unwrap();
        fields[(i % 2) as usize].record(7, &sample, 1.0 + at(3)).unwrap();
    }
    let mut all = fields[0].export_records(&[7]).unwrap();
    assert!(all.combine(&fields[1].export_records(&[7]).unwrap()));
    assert!(!all.combine(&Default::default()));
    assert!(fields[0].export_records(&[]).is_err(), "7 has records");
    fields[0].import_records(&all.numbers, &[7]).unwrap();
    assert_eq!(fields[0].save().unwrap(), fields[2].save().unwrap());
}
