// SPDX-License-Identifier: Apache-2.0
//! awd/types.h: result codes, handles, buffers, callbacks.

use std::os::raw::{c_char, c_void};

/// AWD_LEVEL: a level as a setting, so that 0 can mean "the default".
pub const fn AWD_LEVEL(level: u32) -> u32 {
    level.wrapping_add(1)
}

pub type AWDResult = i32;
pub type AWDFormat = i32;
pub type AWDPreset = i32;
pub type AWDTarget = i32;
pub type AWDEstimator = i32;
pub type AWDCombination = i32;
pub type AWDRefitStatus = i32;

handles! {
    /// Threads, registry, callbacks.
    AWDDevice = *mut AWDDeviceImpl;
    /// Triangles, materials, lights.
    AWDScene = *mut AWDSceneImpl;
    /// One adaptive density per patch.
    AWDField = *mut AWDFieldImpl;
    /// One adaptive density on the unit cube.
    AWDDensity = *mut AWDDensityImpl;
    /// A path tracer with its film.
    AWDRender = *mut AWDRenderImpl;
    /// Named float channels and metadata.
    AWDImage = *mut AWDImageImpl;
}

pub type AWDLogFn =
    Option<unsafe extern "C" fn(user: *mut c_void, severity: i32, message: *const c_char)>;
pub type AWDProgressFn =
    Option<unsafe extern "C" fn(user: *mut c_void, progress: *const AWDProgress) -> i32>;
pub type AWDAllocFn =
    Option<unsafe extern "C" fn(user: *mut c_void, size: usize, alignment: usize) -> *mut c_void>;
pub type AWDFreeFn = Option<
    unsafe extern "C" fn(user: *mut c_void, ptr: *mut c_void, size: usize, alignment: usize),
>;
pub type AWDTaskFn = Option<unsafe extern "C" fn(taskData: *mut c_void, index: usize)>;
pub type AWDParallelForFn = Option<
    unsafe extern "C" fn(user: *mut c_void, count: usize, task: AWDTaskFn, taskData: *mut c_void),
>;

constants! {
    AWD_VERSION_MAJOR: u32 = 0;
    AWD_VERSION_MINOR: u32 = 1;
    AWD_VERSION_PATCH: u32 = 0;
    AWD_VERSION: u32 =
        AWD_VERSION_MAJOR * 10000 + AWD_VERSION_MINOR * 100 + AWD_VERSION_PATCH;
    AWD_INVALID_ID: u32 = 0xFFFF_FFFF;
    AWD_PATCH_BACK: u32 = 0x8000_0000;

    AWD_SUCCESS: AWDResult = 0;
    AWD_ERROR_UNKNOWN: AWDResult = -1;
    AWD_ERROR_INVALID_ARGUMENT: AWDResult = -2;
    AWD_ERROR_INVALID_OPERATION: AWDResult = -3;
    AWD_ERROR_OUT_OF_MEMORY: AWDResult = -4;
    AWD_ERROR_UNSUPPORTED: AWDResult = -5;
    AWD_ERROR_CANCELLED: AWDResult = -6;
    AWD_ERROR_IO: AWDResult = -7;
    AWD_ERROR_PLUGIN_LOAD: AWDResult = -8;
    AWD_ERROR_PLUGIN_ABI: AWDResult = -9;
    AWD_ERROR_PLUGIN_NAME_TAKEN: AWDResult = -10;
    AWD_ERROR_PLUGIN_SELF_TEST: AWDResult = -11;

    AWD_FORMAT_UNDEFINED: AWDFormat = 0;
    AWD_FORMAT_UINT: AWDFormat = 0x5001;
    AWD_FORMAT_UINT3: AWDFormat = 0x5003;
    AWD_FORMAT_FLOAT3: AWDFormat = 0x9003;

    AWD_PRESET_DEFAULT: AWDPreset = 0;
    AWD_PRESET_PAPER: AWDPreset = 1;

    AWD_TARGET_DEFAULT: AWDTarget = 0;
    AWD_TARGET_MEAN: AWDTarget = 1;
    AWD_TARGET_RMS: AWDTarget = 2;

    AWD_ESTIMATOR_DEFAULT: AWDEstimator = 0;
    AWD_ESTIMATOR_PAPER: AWDEstimator = 1;
    AWD_ESTIMATOR_MIXTURE: AWDEstimator = 2;
    AWD_ESTIMATOR_RATIO: AWDEstimator = 3;
    AWD_ESTIMATOR_QUASI: AWDEstimator = 4;
    AWD_ESTIMATOR_REFIT: AWDEstimator = 5;
    AWD_ESTIMATOR_LUMPED: AWDEstimator = 6;

    AWD_COMBINE_DEFAULT: AWDCombination = 0;
    AWD_COMBINE_COUNT: AWDCombination = 1;
    AWD_COMBINE_CROSS_VARIANCE: AWDCombination = 2;
    AWD_COMBINE_EXPERIENCE: AWDCombination = 3;

    AWD_REFIT_NONE: AWDRefitStatus = 0;
    AWD_REFIT_CONVERGED: AWDRefitStatus = 1;
    AWD_REFIT_LIMIT: AWDRefitStatus = 2;
    AWD_REFIT_FAILED: AWDRefitStatus = 3;

    AWD_LOG_INFO: i32 = 0;
    AWD_LOG_WARNING: i32 = 1;
    AWD_LOG_ERROR: i32 = 2;
}

structs! {
    pub struct AWDBuffer {
        data: *const c_void,
        byteOffset: usize,
        byteStride: usize,
        count: usize,
        format: AWDFormat,
        reserved: u32,
    }

    pub struct AWDProgress {
        structSize: usize,
        operation: *const c_char,
        object: *const c_void,
        fraction: f64,
    }
}
