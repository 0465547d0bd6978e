// SPDX-License-Identifier: Apache-2.0
//! Basis families and their modules through the safe interface.

use std::panic::{catch_unwind, AssertUnwindSafe};
use std::path::{Path, PathBuf};

use crate::common::device;
use awd::{check_basis_module, Basis, Device, DeviceSettings, ErrorCode};

fn haar() -> Basis {
    let bases = device().bases().unwrap();
    bases.into_iter().find(|basis| basis.name == "haar").unwrap()
}

#[test]
fn families_are_listed() {
    let haar = haar();
    assert_eq!((haar.order, haar.rejected), (1, None));
    assert!(haar.flags.nested() && haar.flags.orthogonal() && !haar.flags.periodic());
    assert!(Path::new(&haar.file).is_absolute());
}

#[test]
fn modules_are_loaded_and_checked() {
    let file = PathBuf::from(haar().file);
    let mut checks = Vec::new();
    // Safety: a module of ours.
    unsafe {
        check_basis_module(&file, |check| checks.push(check.clone())).unwrap();
        device().load_basis_module(&file).unwrap();
        let folder = file.parent().unwrap().to_path_buf();
        Device::with_basis_paths(DeviceSettings::default(), &[folder]).unwrap();
        assert!(Device::with_basis_paths(DeviceSettings::default(), &["x".into()]).is_err());
    }
    assert!(checks.len() > 5);
    assert!(checks.iter().all(|check| check.failure.is_none() && check.worst <= check.limit));

    let missing = Path::new("/nowhere/there.so");
    // Safety: nothing is loaded.
    let error = unsafe { device().load_basis_module(missing) }.unwrap_err();
    assert_eq!(error.code(), ErrorCode::PluginLoad);
    // Safety: nothing is loaded.
    assert!(unsafe { check_basis_module(missing, |_| ()) }.is_err());
}

#[test]
fn a_panic_of_the_report_goes_on() {
    let file = PathBuf::from(haar().file);
    let mut calls = 0;
    let outcome = catch_unwind(AssertUnwindSafe(|| {
        // Safety: a module of ours.
        let _ = unsafe {
            check_basis_module(&file, |_| {
                calls += 1;
                panic!("enough")
            })
        };
    }));
    assert!(outcome.is_err());
    assert_eq!(calls, 1);
}

#[test]
fn the_version_is_that_of_the_declarations() {
    use awd_sys::{AWD_VERSION_MAJOR, AWD_VERSION_MINOR, AWD_VERSION_PATCH};
    assert_eq!(awd::version(), (AWD_VERSION_MAJOR, AWD_VERSION_MINOR, AWD_VERSION_PATCH));
}
