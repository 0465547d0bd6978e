// SPDX-License-Identifier: Apache-2.0
//! Renders, films and images through the safe interface.

use std::mem;

use crate::common::{device, scene, settings};
use awd::{
    Camera, ErrorCode, Field, FilmLayer, Guide, Image, Quality, Render, RenderSettings, Schedule,
};

fn schedule(samples_per_pass: &[u32]) -> Schedule {
    Schedule { samples_per_pass: samples_per_pass.to_vec(), ..Default::default() }
}

#[test]
fn the_same_seed_gives_the_same_film() {
    let scene = scene(&device());
    let film = |threads| {
        let device = awd::Device::new(awd::DeviceSettings { threads, ..Default::default() });
        let scene = crate::common::scene(&device.unwrap());
        let mut render = Render::new(&scene, &settings()).unwrap();
        render.passes(&schedule(&[1, 2, 4])).unwrap();
        render.film(FilmLayer::Radiance).unwrap()
    };
    assert_eq!(film(1), film(2));

    let mut render = Render::new(&scene, &settings()).unwrap();
    assert_eq!(render.error().unwrap_err().code(), ErrorCode::InvalidOperation);
    render.passes(&schedule(&[2, 6])).unwrap();
    let passes = render.pass_statistics().unwrap();
    assert_eq!(passes.iter().map(|pass| pass.samples_per_pixel).collect::<Vec<_>>(), [2, 6]);
    assert_eq!(render.statistics().unwrap().samples, 16 * 16 * 8);
    let info = render.film_info().unwrap();
    assert_eq!((info.width, info.height, info.samples_per_pixel), (16, 16, 8));
    let error = render.error().unwrap();
    assert!(error.lower <= error.error && error.error <= error.upper, "{:?}", error);
    assert!(render.film(FilmLayer::Variance).unwrap().iter().flatten().any(|v| *v > 0.0));
    assert!(render.film(FilmLayer::Other(9)).is_err());
    assert!(render.read_film(FilmLayer::Radiance, &mut [[0.0; 3]; 255]).is_err());
    assert!(render.pass(0).is_err());
    assert!(render.passes(&schedule(&[0])).is_err());
}

#[test]
fn a_field_is_lent_and_given_back() {
    let scene = scene(&device());
    let field = Field::for_scene(&scene, &Default::default()).unwrap();
    let mut render = Render::with_field(&scene, field, &settings()).unwrap();
    render.pass(4).unwrap();
    let learned = render.field_mut().unwrap().adapt().unwrap();
    assert!(learned.patches > 0);
    let patch = render.pixel_patch(8, 10).unwrap().unwrap();
    assert!(render.field().unwrap().patch(patch).unwrap().learned > 0);
    assert!(render.pixel_patch(16, 0).is_err());
    let mut field = render.into_field().unwrap();
    assert_eq!(field.statistics().unwrap().patches, learned.patches);

    let wrong = RenderSettings { camera: Camera { width: 0, ..Default::default() }, ..settings() };
    let returned = Render::with_field(&scene, field, &wrong).unwrap_err();
    assert_eq!(returned.error.code(), ErrorCode::InvalidArgument);
    let render = Render::with_field(&scene, returned.value, &settings()).unwrap();
    assert!(render.into_field().is_some());

    let cosine = RenderSettings { guide: Guide::Cosine, ..settings() };
    let mut unguided = Render::new(&scene, &cosine).unwrap();
    unguided.pass(1).unwrap();
    assert!(unguided.field().is_none());
}

#[test]
fn a_render_does_not_work_with_a_field_that_is_not_its_own_any_more() {
    let scene = scene(&device());
    let mut render = Render::new(&scene, &settings()).unwrap();
    let mut other = Field::for_scene(&scene, &Default::default()).unwrap();
    mem::swap(render.field_mut().unwrap(), &mut other);
    let refused = [
        render.pass(1).map(|_| ()),
        render.passes(&Default::default()),
        render.pixel_patch(0, 0).map(|_| ()),
    ];
    for outcome in refused {
        assert_eq!(outcome.unwrap_err().code(), ErrorCode::InvalidOperation);
    }
    mem::swap(render.field_mut().unwrap(), &mut other);
    render.pass(1).unwrap();
}

#[test]
fn a_quality_is_a_schedule() {
    let draft = Schedule::of_quality(Quality::Draft).unwrap();
    assert_eq!((draft.error, draft.total_samples), (0.5, 1024));
    assert!(Schedule::of_quality(Quality::Other(77)).is_err());
    let scene = scene(&device());
    let mut render = Render::new(&scene, &settings()).unwrap();
    render.passes(&draft).unwrap();
    assert!(render.error().unwrap().upper <= draft.error);
}

#[test]
fn films_become_images_and_files() {
    let device = device();
    let scene = scene(&device);
    let mut render = Render::new(&scene, &settings()).unwrap();
    render.pass(8).unwrap();
    let film = render.film(FilmLayer::Radiance).unwrap();
    let image = render.film_image().unwrap();
    assert_eq!(image.size().unwrap(), (16, 16));
    assert!(image.channels().unwrap().contains(&"variance.G".to_string()));
    let mut pixels = vec![[0.0f32; 3]; 256];
    for (number, name) in ["R", "G", "B"].iter().enumerate() {
        let flat: Vec<f32> = image.channel(name).unwrap();
        flat.iter().zip(&mut pixels).for_each(|(value, pixel)| pixel[number] = *value);
    }
    assert_eq!(pixels, film);

    let folder = std::env::temp_dir().join(format!("awd-rust-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("film.exr");
    image.write_exr(&path).unwrap();
    image.write_png(folder.join("film.png"), 1.5).unwrap();
    let read = Image::read(&device, &path).unwrap();
    assert_eq!(read.channel("G").unwrap(), image.channel("G").unwrap());
    let patch = render.pixel_patch(8, 10).unwrap().unwrap();
    let of_patch = Image::of_patch(render.field().unwrap(), patch, 8).unwrap();
    assert_eq!(of_patch.channel("Y").unwrap().len(), 64);
    std::fs::remove_dir_all(&folder).unwrap();
    assert_eq!(Image::read(&device, &path).unwrap_err().code(), ErrorCode::Io);
    assert_eq!(image.write_exr(folder.join("x/y.exr")).unwrap_err().code(), ErrorCode::Io);
}

#[test]
fn channels_may_alternate() {
    let mut image = Image::new(&device(), 2, 2).unwrap();
    let pixels: Vec<f32> = (0..12).map(|i| i as f32).collect();
    image.set_channel_of("G", &pixels, 1, 3).unwrap();
    assert_eq!(image.channel("G").unwrap(), [1.0, 4.0, 7.0, 10.0]);
    let mut out = vec![0.0; 8];
    image.read_channel("G", &mut out, 1, 2).unwrap();
    assert_eq!(out, [0.0, 1.0, 0.0, 4.0, 0.0, 7.0, 0.0, 10.0]);
    assert!(image.set_channel_of("R", &pixels, 3, 3).is_err());
    assert!(image.set_channel_of("R", &pixels, 0, 2).is_err());
    assert!(image.set_channel("R", &pixels).is_err());
    assert!(image.read_channel("G", &mut out, 0, usize::MAX).is_err());
    let missing = image.channel("R").unwrap_err();
    assert!(missing.message().contains("it has G"), "{}", missing);

    image.set_metadata("key", Some("value")).unwrap();
    assert_eq!(image.metadata("key").unwrap().as_deref(), Some("value"));
    image.set_metadata("key", None).unwrap();
    assert_eq!(image.metadata("key").unwrap(), None);
    assert!(image.set_metadata("ke\0y", None).is_err());
}
