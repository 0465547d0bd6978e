// SPDX-License-Identifier: Apache-2.0
//! awd/density.h: adaptive densities on the unit cube.

use std::os::raw::{c_char, c_void};

use crate::types::*;

pub type AWDDensityStructure = i32;
pub type AWDSampler = i32;
pub type AWDCoefficientForm = i32;

constants! {
    AWD_MAX_DIMENSIONS: u32 = 6;
    AWD_ALL_AXES: u32 = 0xFFFF_FFFF;

    AWD_STRUCTURE_DEFAULT: AWDDensityStructure = 0;
    AWD_STRUCTURE_GRID: AWDDensityStructure = 1;
    AWD_STRUCTURE_TREE: AWDDensityStructure = 2;

    AWD_SAMPLER_DEFAULT: AWDSampler = 0;
    AWD_SAMPLER_INVERSE_CDF: AWDSampler = 1;
    AWD_SAMPLER_COMPONENT: AWDSampler = 2;

    AWD_COEFFICIENTS_SCALING: AWDCoefficientForm = 0;
    AWD_COEFFICIENTS_ORTHONORMAL: AWDCoefficientForm = 1;
}

structs! {
    pub struct AWDDensityAxis {
        basis: *const c_char,
        startLevel: u32,
        maxLevel: u32,
    }

    pub struct AWDDensityDesc {
        structSize: usize,
        dimensions: u32,
        structure: AWDDensityStructure,
        axes: *const AWDDensityAxis,
        estimator: AWDEstimator,
        target: AWDTarget,
        sampler: AWDSampler,
        combination: AWDCombination,
        tau: f64,
        shrinkage: f64,
        passSamples: u64,
        maxCoefficients: u64,
        refitSolver: *const c_char,
        refitBytes: u64,
    }

    pub struct AWDDensityReport {
        structSize: usize,
        samples: u64,
        rejected: u64,
        coefficients: u64,
        negative: u64,
        coarsened: u64,
        split: u64,
        tau: f64,
        estimator: AWDEstimator,
        kept: i32,
        estimatedLevels: u32,
        refitStatus: AWDRefitStatus,
        refitIterations: u32,
        refitAtBound: u64,
        refitLambda: f64,
        refitObjective: f64,
        refitMessage: *const c_char,
    }

    pub struct AWDDensityEstimate {
        structSize: usize,
        integral: f64,
        standardError: f64,
        samples: u64,
        passes: u64,
    }

    pub struct AWDDensityInfo {
        structSize: usize,
        dimensions: u32,
        structure: AWDDensityStructure,
        estimator: AWDEstimator,
        target: AWDTarget,
        sampler: AWDSampler,
        combination: AWDCombination,
        uniforms: u32,
        reserved: u32,
        coefficients: u64,
        leaves: u64,
        bytes: u64,
        samples: u64,
        rejected: u64,
        learned: u64,
        passes: u64,
    }

    pub struct AWDDensityAxisInfo {
        structSize: usize,
        basis: *const c_char,
        level: u32,
        maxLevel: u32,
        count: u32,
        cells: u32,
        order: u32,
        flags: u32,
    }
}

inits! {
    AWDDensityDesc;
    AWDDensityReport;
    AWDDensityEstimate;
    AWDDensityInfo;
    AWDDensityAxisInfo;
}

functions! {
    fn awdNewDensity(
        device: AWDDevice,
        desc: *const AWDDensityDesc,
        density: *mut AWDDensity,
    ) -> AWDResult;
    fn awdRetainDensity(density: AWDDensity);
    fn awdReleaseDensity(density: AWDDensity);
    fn awdForkDensity(density: AWDDensity, fork: *mut AWDDensity) -> AWDResult;
    fn awdJoinDensity(density: AWDDensity, fork: AWDDensity) -> AWDResult;
    fn awdSampleDensity(
        density: AWDDensity,
        count: usize,
        uniforms: *const f64,
        points: *mut f64,
        pdfs: *mut f64,
        components: *mut u32,
    ) -> AWDResult;
    fn awdGetDensityPdf(
        density: AWDDensity,
        count: usize,
        points: *const f64,
        pdfs: *mut f64,
    ) -> AWDResult;
    fn awdRecordDensity(
        density: AWDDensity,
        count: usize,
        points: *const f64,
        pdfs: *const f64,
        components: *const u32,
        values: *const f64,
    ) -> AWDResult;
    fn awdAdaptDensity(density: AWDDensity, report: *mut AWDDensityReport) -> AWDResult;
    fn awdRefineDensity(density: AWDDensity, axis: u32) -> AWDResult;
    fn awdGetDensityEstimate(density: AWDDensity, estimate: *mut AWDDensityEstimate) -> AWDResult;
    fn awdGetDensityInfo(density: AWDDensity, info: *mut AWDDensityInfo) -> AWDResult;
    fn awdGetDensityAxisInfo(
        density: AWDDensity,
        axis: u32,
        info: *mut AWDDensityAxisInfo,
    ) -> AWDResult;
    fn awdGetDensityCoefficients(
        density: AWDDensity,
        form: AWDCoefficientForm,
        coefficients: *mut f64,
        capacity: usize,
    ) -> AWDResult;
    fn awdSetDensityCoefficients(
        density: AWDDensity,
        coefficients: *const f64,
        count: usize,
    ) -> AWDResult;
    fn awdGetDensityIntegral(
        density: AWDDensity,
        lower: *const f64,
        upper: *const f64,
        integral: *mut f64,
    ) -> AWDResult;
    fn awdGetDensityLeaves(
        density: AWDDensity,
        boxes: *mut f64,
        capacity: usize,
        count: *mut usize,
    ) -> AWDResult;
    fn awdGetDensityDetailEnergy(
        density: AWDDensity,
        energies: *mut f64,
        capacity: usize,
        count: *mut usize,
    ) -> AWDResult;
    fn awdExportDensityStatistics(
        density: AWDDensity,
        bytes: *mut c_void,
        capacity: usize,
        size: *mut usize,
    ) -> AWDResult;
    fn awdAddDensityStatistics(density: AWDDensity, bytes: *const c_void, size: usize) -> AWDResult;
    fn awdImportDensityStatistics(
        density: AWDDensity,
        bytes: *const c_void,
        size: usize,
    ) -> AWDResult;
    fn awdSaveDensity(
        density: AWDDensity,
        bytes: *mut c_void,
        capacity: usize,
        size: *mut usize,
    ) -> AWDResult;
    fn awdLoadDensity(
        device: AWDDevice,
        bytes: *const c_void,
        size: usize,
        density: *mut AWDDensity,
    ) -> AWDResult;
}
