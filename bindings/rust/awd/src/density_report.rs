// SPDX-License-Identifier: Apache-2.0
//! What a density tells of itself.

use awd_sys::*;

use crate::{
    text, BasisFlags, Combination, DensityStructure, Estimator, RefitStatus, Sampler, Target,
};

/// What an adapt made of a pass.
#[derive(Clone, Debug, PartialEq)]
pub struct DensityReport {
    /// Samples of the pass.
    pub samples: u64,
    /// Of these: NaN or infinite.
    pub rejected: u64,
    /// Of the new density.
    pub coefficients: u64,
    /// Coefficients that came out negative, before the floor.
    pub negative: u64,
    /// Tree: coefficients saved where details were below their error.
    pub coarsened: u64,
    /// Tree: boxes halved.
    pub split: u64,
    /// The floor that was used; 0: none.
    pub tau: f64,
    /// The estimator that was used.
    pub estimator: Estimator,
    /// The samples were of no use: the density is as it was.
    pub kept: bool,
    /// Grid: rungs of the cascade that were estimated.
    pub estimated_levels: u32,
    /// How the refit ended; this and all below are of the estimator refit.
    pub refit_status: RefitStatus,
    /// The solver's: sweeps of descent, trust-region steps of ceres.
    pub refit_iterations: u32,
    /// Coefficients that the floor holds.
    pub refit_at_bound: u64,
    /// Of the pull towards the cascade.
    pub refit_lambda: f64,
    /// What was minimised over that of zero coefficients: 0 would be a perfect fit.
    pub refit_objective: f64,
    /// The solver's own account.
    pub refit_message: String,
}

impl DensityReport {
    /// # Safety
    /// The report's text must be good, as the library gives it.
    pub(crate) unsafe fn new(report: &AWDDensityReport) -> Self {
        DensityReport {
            samples: report.samples,
            rejected: report.rejected,
            coefficients: report.coefficients,
            negative: report.negative,
            coarsened: report.coarsened,
            split: report.split,
            tau: report.tau,
            estimator: Estimator::from_raw(report.estimator),
            kept: report.kept != 0,
            estimated_levels: report.estimatedLevels,
            refit_status: RefitStatus::from_raw(report.refitStatus),
            refit_iterations: report.refitIterations,
            refit_at_bound: report.refitAtBound,
            refit_lambda: report.refitLambda,
            refit_objective: report.refitObjective,
            refit_message: text::string(report.refitMessage),
        }
    }
}

/// The estimate of the integral of f over [0,1]^d by all passes, the one at work included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DensityEstimate {
    /// 0 without samples.
    pub integral: f64,
    /// As of independent samples: too large if they were stratified. Infinite with one sample.
    pub standard_error: f64,
    /// How many samples there were.
    pub samples: u64,
    /// Passes that had samples.
    pub passes: u64,
}

/// What a density is, with the defaults settled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DensityInfo {
    /// Of the cube.
    pub dimensions: u32,
    /// Grid or tree.
    pub structure: DensityStructure,
    /// The default estimator remains so: it depends on the pass.
    pub estimator: Estimator,
    /// What the density becomes proportional to.
    pub target: Target,
    /// How points are drawn.
    pub sampler: Sampler,
    /// How passes make one estimate.
    pub combination: Combination,
    /// Uniforms for each point that is drawn.
    pub uniforms: u32,
    /// How many there are now.
    pub coefficients: u64,
    /// Boxes of a tree, 1 for a grid.
    pub leaves: u64,
    /// Memory held, density and statistics.
    pub bytes: u64,
    /// Recorded since the last adapt.
    pub samples: u64,
    /// Of these: NaN or infinite.
    pub rejected: u64,
    /// Samples that the density was made of; 0: constant, or set by the host.
    pub learned: u64,
    /// Adapts so far.
    pub passes: u64,
}

impl DensityInfo {
    pub(crate) fn new(info: &AWDDensityInfo) -> Self {
        DensityInfo {
            dimensions: info.dimensions,
            structure: DensityStructure::from_raw(info.structure),
            estimator: Estimator::from_raw(info.estimator),
            target: Target::from_raw(info.target),
            sampler: Sampler::from_raw(info.sampler),
            combination: Combination::from_raw(info.combination),
            uniforms: info.uniforms,
            coefficients: info.coefficients,
            leaves: info.leaves,
            bytes: info.bytes,
            samples: info.samples,
            rejected: info.rejected,
            learned: info.learned,
            passes: info.passes,
        }
    }
}

/// What an axis of a density is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DensityAxisInfo {
    /// Name of the family.
    pub basis: String,
    /// Grid: present level; tree: most halvings of any leaf along this axis.
    pub level: u32,
    /// Beyond which it never refines.
    pub max_level: u32,
    /// Functions along this axis, of the grid or of one leaf.
    pub count: u32,
    /// Polynomial pieces that they are made of.
    pub cells: u32,
    /// Polynomial degree + 1.
    pub order: u32,
    /// Of the family.
    pub flags: BasisFlags,
}

impl DensityAxisInfo {
    /// # Safety
    /// The text must be good, as the library gives it.
    pub(crate) unsafe fn new(info: &AWDDensityAxisInfo) -> Self {
        DensityAxisInfo {
            basis: text::string(info.basis),
            level: info.level,
            max_level: info.maxLevel,
            count: info.count,
            cells: info.cells,
            order: info.order,
            flags: BasisFlags(info.flags),
        }
    }
}
