// SPDX-License-Identifier: Apache-2.0
//! awd/device.h: the device and its registry of basis families.

use std::os::raw::{c_char, c_void};

use crate::basis::AWDBasisModule;
use crate::types::*;

pub type AWDBasisCheckFn =
    Option<unsafe extern "C" fn(user: *mut c_void, check: *const AWDBasisCheck)>;

constants! {
    AWD_DEVICE_IGNORE_ENVIRONMENT: u32 = 1;
}

structs! {
    pub struct AWDDeviceDesc {
        structSize: usize,
        threads: u32,
        flags: u32,
        log: AWDLogFn,
        logUser: *mut c_void,
        progress: AWDProgressFn,
        progressUser: *mut c_void,
        alloc: AWDAllocFn,
        free: AWDFreeFn,
        allocUser: *mut c_void,
        parallelFor: AWDParallelForFn,
        parallelForUser: *mut c_void,
        basisPaths: *const *const c_char,
        basisPathCount: usize,
    }

    pub struct AWDBasisCheck {
        structSize: usize,
        family: *const c_char,
        name: *const c_char,
        message: *const c_char,
        worst: f64,
        limit: f64,
        status: AWDResult,
        index: u32,
    }

    pub struct AWDBasisInfo {
        structSize: usize,
        name: *const c_char,
        summary: *const c_char,
        file: *const c_char,
        status: AWDResult,
        flags: u32,
        message: *const c_char,
        order: u32,
        minLevel: u32,
        maxLevel: u32,
        reserved: u32,
    }
}

inits! {
    AWDDeviceDesc;
    AWDBasisInfo;
}

functions! {
    fn awdGetVersion() -> u32;
    fn awdGetResultString(result: AWDResult) -> *const c_char;
    fn awdGetLastErrorMessage() -> *const c_char;
    fn awdNewDevice(desc: *const AWDDeviceDesc, device: *mut AWDDevice) -> AWDResult;
    fn awdRetainDevice(device: AWDDevice);
    fn awdReleaseDevice(device: AWDDevice);
    fn awdLoadBasisModule(device: AWDDevice, absolutePath: *const c_char) -> AWDResult;
    fn awdRegisterBasisModule(device: AWDDevice, module: *const AWDBasisModule) -> AWDResult;
    fn awdCheckBasisModule(
        absolutePath: *const c_char,
        report: AWDBasisCheckFn,
        user: *mut c_void,
    ) -> AWDResult;
    fn awdGetBasisCount(device: AWDDevice, count: *mut usize) -> AWDResult;
    fn awdGetBasisInfo(device: AWDDevice, index: usize, info: *mut AWDBasisInfo) -> AWDResult;
}
