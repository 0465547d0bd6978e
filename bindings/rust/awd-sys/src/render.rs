// SPDX-License-Identifier: Apache-2.0
//! awd/render.h: the renderer, its schedules and its film.

use std::os::raw::c_char;

use crate::field::AWDFieldDesc;
use crate::types::*;

pub type AWDGuide = i32;
pub type AWDDirectLight = i32;
pub type AWDRoulette = i32;
pub type AWDPoints = i32;
pub type AWDLightChoice = i32;
pub type AWDQuality = i32;
pub type AWDFilmLayer = i32;

constants! {
    AWD_GUIDE_ADAPTIVE: AWDGuide = 0;
    AWD_GUIDE_COSINE: AWDGuide = 1;
    AWD_GUIDE_UNIFORM: AWDGuide = 2;

    AWD_DIRECT_DEFAULT: AWDDirectLight = 0;
    AWD_DIRECT_AREA: AWDDirectLight = 1;
    AWD_DIRECT_WEIGHTED: AWDDirectLight = 2;
    AWD_DIRECT_NONE: AWDDirectLight = 3;

    AWD_ROULETTE_DEFAULT: AWDRoulette = 0;
    AWD_ROULETTE_ALBEDO: AWDRoulette = 1;
    AWD_ROULETTE_THROUGHPUT: AWDRoulette = 2;
    AWD_ROULETTE_ADJOINT: AWDRoulette = 3;

    AWD_POINTS_DEFAULT: AWDPoints = 0;
    AWD_POINTS_RANDOM: AWDPoints = 1;
    AWD_POINTS_SOBOL: AWDPoints = 2;

    AWD_LIGHTS_DEFAULT: AWDLightChoice = 0;
    AWD_LIGHTS_POWER: AWDLightChoice = 1;
    AWD_LIGHTS_LEARNED: AWDLightChoice = 2;

    AWD_QUALITY_DRAFT: AWDQuality = 1;
    AWD_QUALITY_NORMAL: AWDQuality = 2;
    AWD_QUALITY_FINE: AWDQuality = 3;
    AWD_QUALITY_REFERENCE: AWDQuality = 4;

    AWD_FILM_RADIANCE: AWDFilmLayer = 1;
    AWD_FILM_VARIANCE: AWDFilmLayer = 2;
}

structs! {
    pub struct AWDCamera {
        structSize: usize,
        eye: [f32; 3],
        lookDir: [f32; 3],
        up: [f32; 3],
        tanHalfFovX: f32,
        width: u32,
        height: u32,
    }

    pub struct AWDRenderDesc {
        structSize: usize,
        camera: *const AWDCamera,
        preset: AWDPreset,
        guide: AWDGuide,
        direct: AWDDirectLight,
        roulette: AWDRoulette,
        shadowRays: u32,
        maxLights: u32,
        seed: u64,
        combination: AWDCombination,
        points: AWDPoints,
        maxBytes: u64,
        maxSplit: u32,
        lights: AWDLightChoice,
    }

    pub struct AWDPassStatistics {
        structSize: usize,
        cpuSeconds: f64,
        wallSeconds: f64,
        samplesPerPixel: u64,
        samples: u64,
        rays: u64,
        shadowRays: u64,
        patches: u64,
        coefficients: u64,
        bytes: u64,
        rejectedSamples: u64,
    }

    pub struct AWDSchedule {
        structSize: usize,
        samplesPerPass: *const u32,
        passCount: u32,
        totalSamples: u32,
        seconds: f64,
        error: f64,
        resume: i32,
        maxPasses: u32,
    }

    pub struct AWDRenderError {
        structSize: usize,
        error: f64,
        lower: f64,
        upper: f64,
    }
}

inits! {
    AWDCamera {
        lookDir: [0.0, 0.0, -1.0],
        up: [0.0, 1.0, 0.0],
        tanHalfFovX: 0.5,
        width: 512,
        height: 512,
    };
    AWDRenderDesc;
    AWDPassStatistics;
    AWDSchedule;
    AWDRenderError;
}

functions! {
    fn awdNewSceneField(
        scene: AWDScene,
        desc: *const AWDFieldDesc,
        field: *mut AWDField,
    ) -> AWDResult;
    fn awdNewRender(
        scene: AWDScene,
        field: AWDField,
        desc: *const AWDRenderDesc,
        render: *mut AWDRender,
    ) -> AWDResult;
    fn awdRetainRender(render: AWDRender);
    fn awdReleaseRender(render: AWDRender);
    fn awdGetRenderField(render: AWDRender, field: *mut AWDField) -> AWDResult;
    fn awdRenderPass(
        render: AWDRender,
        samplesPerPixel: u32,
        statistics: *mut AWDPassStatistics,
    ) -> AWDResult;
    fn awdRenderPasses(render: AWDRender, schedule: *const AWDSchedule) -> AWDResult;
    fn awdSaveRender(render: AWDRender, path: *const c_char) -> AWDResult;
    fn awdLoadRender(
        scene: AWDScene,
        path: *const c_char,
        field: AWDField,
        desc: *const AWDRenderDesc,
        render: *mut AWDRender,
    ) -> AWDResult;
    fn awdRenderPassPart(
        render: AWDRender,
        schedule: *const AWDSchedule,
        part: u32,
        parts: u32,
        samplesPerPixel: *mut u32,
    ) -> AWDResult;
    fn awdExportPass(
        render: AWDRender,
        numbers: *mut u64,
        capacity: usize,
        sums: *mut usize,
        maxima: *mut usize,
    ) -> AWDResult;
    fn awdImportPass(
        render: AWDRender,
        numbers: *const u64,
        count: usize,
        statistics: *mut AWDPassStatistics,
    ) -> AWDResult;
    fn awdGetQualitySchedule(quality: AWDQuality, schedule: *mut AWDSchedule) -> AWDResult;
    fn awdGetPassCount(render: AWDRender, count: *mut u32) -> AWDResult;
    fn awdGetPassStatistics(
        render: AWDRender,
        index: u32,
        statistics: *mut AWDPassStatistics,
    ) -> AWDResult;
    fn awdGetRenderStatistics(render: AWDRender, statistics: *mut AWDPassStatistics) -> AWDResult;
    fn awdReadFilm(
        render: AWDRender,
        layer: AWDFilmLayer,
        pixels: *mut f32,
        pixelStride: usize,
        rowStride: usize,
    ) -> AWDResult;
    fn awdGetFilmInfo(
        render: AWDRender,
        width: *mut u32,
        height: *mut u32,
        samplesPerPixel: *mut u64,
    ) -> AWDResult;
    fn awdGetRenderError(render: AWDRender, error: *mut AWDRenderError) -> AWDResult;
    fn awdGetPixelPatch(render: AWDRender, x: u32, y: u32, patch: *mut u32) -> AWDResult;
}
