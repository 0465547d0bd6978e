// SPDX-License-Identifier: Apache-2.0
//! awd/field.h: one adaptive density per patch of surface.

use std::os::raw::{c_char, c_void};

use crate::types::*;

pub type AWDHemisphereMap = i32;
pub type AWDPatches = i32;

constants! {
    AWD_MOST_FIELD_LIGHTS: u32 = 64;

    AWD_MAP_DEFAULT: AWDHemisphereMap = 0;
    AWD_MAP_SPHERICAL: AWDHemisphereMap = 1;
    AWD_MAP_CONCENTRIC_COSINE: AWDHemisphereMap = 2;
    AWD_MAP_CYLINDRICAL: AWDHemisphereMap = 3;
    AWD_MAP_COSINE: AWDHemisphereMap = 4;

    AWD_PATCHES_DEFAULT: AWDPatches = 0;
    AWD_PATCHES_SPATIAL: AWDPatches = 1;
    AWD_PATCHES_HOST: AWDPatches = 2;
}

structs! {
    pub struct AWDFieldDesc {
        structSize: usize,
        preset: AWDPreset,
        map: AWDHemisphereMap,
        basis: *const c_char,
        startLevel: u32,
        maxLevel: u32,
        tau: f64,
        estimator: AWDEstimator,
        refitSolver: *const c_char,
        shrinkage: f64,
        patches: AWDPatches,
        lower: [f32; 3],
        upper: [f32; 3],
        patchSamples: u32,
        alpha: f64,
        maxBytes: u64,
        lightCount: u32,
        lightPowers: *const f32,
        target: AWDTarget,
    }

    pub struct AWDDirectionSample {
        direction: [f32; 3],
        pdf: f32,
        square: [f32; 2],
        component: u32,
        solidAngle: f32,
    }

    pub struct AWDFieldStatistics {
        structSize: usize,
        patches: u64,
        coefficients: u64,
        bytes: u64,
        samples: u64,
        rejected: u64,
        saturated: u64,
        kept: u64,
        refitFailed: u64,
        refitLimited: u64,
        refitIterations: u64,
        capped: u64,
        rejectedNaN: u64,
        rejectedInfinite: u64,
        rejectedNegative: u64,
        rejectedPdf: u64,
    }

    pub struct AWDPatchInfo {
        structSize: usize,
        basis: *const c_char,
        level: u32,
        axisCount: u32,
        samples: u64,
        learned: u64,
    }

    pub struct AWDPathVertex {
        patch: u32,
        continuation: f32,
        sample: AWDDirectionSample,
        emitted: [f32; 3],
        direct: [f32; 3],
        scattering: [f32; 3],
    }
}

inits! {
    AWDFieldDesc;
    AWDFieldStatistics;
    AWDPatchInfo;
}

functions! {
    fn awdNewField(device: AWDDevice, desc: *const AWDFieldDesc, field: *mut AWDField) -> AWDResult;
    fn awdRetainField(field: AWDField);
    fn awdReleaseField(field: AWDField);
    fn awdFindPatch(
        field: AWDField,
        position: *const f32,
        normal: *const f32,
        patch: *mut u32,
    ) -> AWDResult;
    fn awdSampleField(
        field: AWDField,
        patch: u32,
        normal: *const f32,
        uniforms: *const f64,
        sample: *mut AWDDirectionSample,
    ) -> AWDResult;
    fn awdGetFieldPdf(
        field: AWDField,
        patch: u32,
        normal: *const f32,
        direction: *const f32,
        pdf: *mut f32,
    ) -> AWDResult;
    fn awdRecordField(
        field: AWDField,
        patch: u32,
        sample: *const AWDDirectionSample,
        value: f64,
    ) -> AWDResult;
    fn awdSetFieldScale(field: AWDField, magnitude: f64) -> AWDResult;
    fn awdAdaptField(field: AWDField, statistics: *mut AWDFieldStatistics) -> AWDResult;
    fn awdMarkField(field: AWDField) -> AWDResult;
    fn awdRevertField(field: AWDField) -> AWDResult;
    fn awdGetFieldStatistics(field: AWDField, statistics: *mut AWDFieldStatistics) -> AWDResult;
    fn awdGetFieldPatches(
        field: AWDField,
        patches: *mut u32,
        capacity: usize,
        count: *mut usize,
    ) -> AWDResult;
    fn awdGetPatchInfo(field: AWDField, patch: u32, info: *mut AWDPatchInfo) -> AWDResult;
    fn awdGetPatchCoefficients(
        field: AWDField,
        patch: u32,
        coefficients: *mut f64,
        capacity: usize,
    ) -> AWDResult;
    fn awdGetPatchMean(field: AWDField, patch: u32, mean: *mut f32) -> AWDResult;
    fn awdGetContinuation(
        field: AWDField,
        patch: u32,
        throughput: f32,
        expected: f32,
        maxSplit: u32,
        rays: *mut f32,
    ) -> AWDResult;
    fn awdGetPatchPdf(
        field: AWDField,
        patch: u32,
        n: u32,
        pixels: *mut f32,
        rowStride: usize,
    ) -> AWDResult;
    fn awdMapDirection(
        field: AWDField,
        patch: u32,
        normal: *const f32,
        direction: *const f32,
        sample: *mut AWDDirectionSample,
    ) -> AWDResult;
    fn awdFindPatches(
        field: AWDField,
        count: usize,
        positions: *const f32,
        normals: *const f32,
        patches: *mut u32,
    ) -> AWDResult;
    fn awdSampleFieldBatch(
        field: AWDField,
        count: usize,
        patches: *const u32,
        normals: *const f32,
        uniforms: *const f64,
        samples: *mut AWDDirectionSample,
    ) -> AWDResult;
    fn awdGetFieldPdfs(
        field: AWDField,
        count: usize,
        patches: *const u32,
        normals: *const f32,
        directions: *const f32,
        pdfs: *mut f32,
    ) -> AWDResult;
    fn awdRecordFieldBatch(
        field: AWDField,
        count: usize,
        patches: *const u32,
        samples: *const AWDDirectionSample,
        values: *const f64,
    ) -> AWDResult;
    fn awdRecordFieldPath(
        field: AWDField,
        count: usize,
        vertices: *const AWDPathVertex,
        background: *const f32,
        radiance: *mut f32,
    ) -> AWDResult;
    fn awdSaveField(
        field: AWDField,
        bytes: *mut c_void,
        capacity: usize,
        size: *mut usize,
    ) -> AWDResult;
    fn awdLoadField(
        device: AWDDevice,
        bytes: *const c_void,
        size: usize,
        field: *mut AWDField,
    ) -> AWDResult;
    fn awdWriteField(field: AWDField, path: *const c_char) -> AWDResult;
    fn awdReadField(device: AWDDevice, path: *const c_char, field: *mut AWDField) -> AWDResult;
    fn awdMergeField(field: AWDField, other: AWDField) -> AWDResult;
    fn awdExportField(
        field: AWDField,
        patches: *const u32,
        patchCount: usize,
        numbers: *mut u64,
        capacity: usize,
        sums: *mut usize,
        maxima: *mut usize,
    ) -> AWDResult;
    fn awdImportField(
        field: AWDField,
        patches: *const u32,
        patchCount: usize,
        numbers: *const u64,
        count: usize,
    ) -> AWDResult;
}
