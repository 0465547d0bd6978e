// SPDX-License-Identifier: Apache-2.0
//! Closures that are called from C: what they see, cancel, and panic with.

use std::ops::ControlFlow;
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use crate::common::{builder, scene, settings};
use awd::{
    Device, DeviceSettings, ErrorCode, Field, LogLevel, Progress, Render, SceneBuilder, Schedule,
};

/// Calls of the progress closure that were allowed; the next one does as `last` says.
struct Fuse {
    left: AtomicUsize,
}

impl Fuse {
    fn device(last: fn() -> ControlFlow<()>) -> (Arc<Fuse>, Device) {
        let fuse = Arc::new(Fuse { left: AtomicUsize::new(usize::MAX) });
        let shared = fuse.clone();
        let progress = move |_: &Progress| {
            let left = shared.left.load(Ordering::SeqCst);
            if left == 0 {
                return last();
            }
            shared.left.store(left - 1, Ordering::SeqCst);
            ControlFlow::Continue(())
        };
        let device = Device::new(DeviceSettings {
            progress: Some(Box::new(progress)),
            ..Default::default()
        });
        (fuse, device.unwrap())
    }

    fn set(&self, left: usize) {
        self.left.store(left, Ordering::SeqCst);
    }
}

fn cancel() -> ControlFlow<()> {
    ControlFlow::Break(())
}

fn explode() -> ControlFlow<()> {
    panic!("the closure's own words")
}

/// What the call panicked with.
fn panic_of<T>(call: impl FnOnce() -> T) -> String {
    let payload = catch_unwind(AssertUnwindSafe(call)).err().expect("a panic");
    payload.downcast_ref::<&str>().expect("a text").to_string()
}

#[test]
fn progress_is_told_and_never_falls() {
    let seen = Arc::new(Mutex::new(Vec::new()));
    let shared = seen.clone();
    let progress = move |at: &Progress| {
        shared.lock().unwrap().push(at.clone());
        ControlFlow::Continue(())
    };
    let settings = DeviceSettings { progress: Some(Box::new(progress)), ..Default::default() };
    let device = Device::new(settings).unwrap();
    let mut render = Render::new(&scene(&device), &crate::common::settings()).unwrap();
    render.passes(&Schedule { samples_per_pass: vec![1, 2], ..Default::default() }).unwrap();
    let seen = seen.lock().unwrap();
    for name in ["commit", "pass", "adapt"] {
        assert!(seen.iter().any(|at| at.operation == name && at.fraction == 1.0), "{}", name);
    }
    for pair in seen.windows(2) {
        assert!(pair[0].operation != pair[1].operation || pair[1].fraction >= pair[0].fraction);
    }
}

#[test]
fn every_operation_can_be_cancelled() {
    let (fuse, device) = Fuse::device(cancel);
    fuse.set(0);
    let returned = builder(&device).commit().unwrap_err();
    assert_eq!(returned.error.code(), ErrorCode::Cancelled);
    fuse.set(usize::MAX);
    let scene = returned.value.commit().unwrap();
    let mut render = Render::new(&scene, &settings()).unwrap();
    fuse.set(0);
    assert_eq!(render.pass(1).unwrap_err().code(), ErrorCode::Cancelled);
    assert_eq!(render.film_info().unwrap().samples_per_pixel, 0);
    fuse.set(usize::MAX);
    render.pass(1).unwrap();
    fuse.set(0);
    let cancelled = render.field_mut().unwrap().adapt().unwrap_err();
    assert_eq!(cancelled.code(), ErrorCode::Cancelled);
    fuse.set(usize::MAX);
    render.field_mut().unwrap().adapt().unwrap();
}

#[test]
fn panics_go_on_in_the_caller() {
    let (fuse, device) = Fuse::device(explode);
    fuse.set(0);
    let words = "the closure's own words";
    let scene = builder(&device);
    assert_eq!(panic_of(|| scene.commit()), words);

    fuse.set(usize::MAX);
    let scene = crate::common::scene(&device);
    let mut render = Render::new(&scene, &settings()).unwrap();
    fuse.set(0);
    assert_eq!(panic_of(|| render.pass(1)), words);
    assert_eq!(render.film_info().unwrap().samples_per_pixel, 0);
    fuse.set(usize::MAX);
    render.pass(4).unwrap();
    fuse.set(0);
    assert_eq!(panic_of(|| render.field_mut().unwrap().adapt()), words);

    // At whichever call it is: in a pass or in an adapt between two.
    let many = Schedule { samples_per_pass: vec![1; 4], ..Default::default() };
    let mut fails_at = |left| {
        fuse.set(left);
        catch_unwind(AssertUnwindSafe(|| render.passes(&many).unwrap())).is_err()
    };
    assert!((0..).take_while(|left| fails_at(*left)).count() >= 7);
    fuse.set(usize::MAX);
    render.passes(&many).unwrap();
}

#[test]
fn a_panic_belongs_to_the_object_at_work() {
    let (fuse, device) = Fuse::device(explode);
    let scene = scene(&device);
    let mut render = Render::new(&scene, &settings()).unwrap();
    fuse.set(0);
    std::thread::scope(|threads| {
        let thread = threads.spawn(|| panic_of(|| render.pass(1)));
        // Calls that never report take nothing of it.
        for _ in 0..100 {
            SceneBuilder::new(&device).unwrap();
            Field::for_scene(&scene, &Default::default()).unwrap();
        }
        assert_eq!(thread.join().unwrap(), "the closure's own words");
    });
}

#[test]
fn the_log_is_heard() {
    let lines = Arc::new(Mutex::new(Vec::new()));
    let shared = lines.clone();
    let log =
        move |level: LogLevel, text: &str| shared.lock().unwrap().push((level, text.to_string()));
    let settings = DeviceSettings { log: Some(Box::new(log)), ..Default::default() };
    let device = Device::new(settings).unwrap();
    SceneBuilder::new(&device).unwrap().commit().unwrap();
    let lines = lines.lock().unwrap();
    assert!(lines
        .iter()
        .any(|(level, text)| *level == LogLevel::Warning && text.contains("empty")));
}

#[test]
fn a_panic_of_the_log_goes_on_too() {
    let log = |_: LogLevel, _: &str| panic!("no paper");
    let settings = DeviceSettings { log: Some(Box::new(log)), ..Default::default() };
    let device = Device::new(settings).unwrap();
    let builder = SceneBuilder::new(&device).unwrap();
    assert_eq!(panic_of(|| builder.commit()), "no paper");
    SceneBuilder::new(&device).unwrap();
}

#[test]
fn objects_keep_their_device_and_its_closures() {
    let (fuse, device) = Fuse::device(cancel);
    let scene = scene(&device);
    let mut render = Render::new(&scene, &settings()).unwrap();
    drop(device);
    drop(scene);
    fuse.set(3);
    let code = render.passes(&Default::default()).unwrap_err().code();
    assert_eq!(code, ErrorCode::Cancelled);
    let field = render.into_field().unwrap();
    assert_eq!(Arc::strong_count(&fuse), 2);
    drop(field);
    assert_eq!(Arc::strong_count(&fuse), 1);
}
