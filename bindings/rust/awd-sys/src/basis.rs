// SPDX-License-Identifier: Apache-2.0
//! awd/basis.h: the interface of basis plugins.

use std::os::raw::c_char;

pub type AWDBasisModuleFn =
    Option<unsafe extern "C" fn(host: *const AWDBasisHost) -> *const AWDBasisModule>;

constants! {
    AWD_BASIS_ABI: u32 = 1;
    AWD_BASIS_MAX_ORDER: u32 = 8;
    AWD_BASIS_MAX_LEVEL: u32 = 20;

    AWD_BASIS_ORTHOGONAL: u32 = 1;
    AWD_BASIS_PERIODIC: u32 = 2;
    AWD_BASIS_NESTED: u32 = 4;
}

structs! {
    pub struct AWDBasisFamily {
        structSize: usize,
        name: *const c_char,
        summary: *const c_char,
        flags: u32,
        order: u32,
        sampleDims: u32,
        minLevel: u32,
        maxLevel: u32,
        count: Option<unsafe extern "C" fn(level: u32) -> u32>,
        cells: Option<unsafe extern "C" fn(level: u32) -> u32>,
        support: Option<unsafe extern "C" fn(level: u32, j: u32, ab: *mut f64)>,
        weight: Option<unsafe extern "C" fn(level: u32, j: u32) -> f64>,
        eval: Option<
            unsafe extern "C" fn(level: u32, x: f64, first: *mut u32, values: *mut f64) -> u32,
        >,
        sample: Option<unsafe extern "C" fn(level: u32, j: u32, u: *const f64) -> f64>,
        twoScale: Option<
            unsafe extern "C" fn(level: u32, j: u32, first: *mut u32, h: *mut f64) -> u32,
        >,
        wavelet: Option<unsafe extern "C" fn(k: u32, g: *mut f64)>,
        vanishingMoments: u32,
    }

    pub struct AWDBasisHost {
        structSize: usize,
        abi: u32,
        libraryVersion: u32,
    }

    pub struct AWDBasisModule {
        structSize: usize,
        abi: u32,
        familyCount: u32,
        version: *const c_char,
        license: *const c_char,
        families: *const *const AWDBasisFamily,
    }
}
