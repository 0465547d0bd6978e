// SPDX-License-Identifier: Apache-2.0
//! How a density is made.

use std::ffi::CString;

use awd_sys::*;

use crate::settings::level;
use crate::slices::check_length;
use crate::{text, Combination, Estimator, Result, Target};

enumeration! {
    /// What a density is made of.
    #[derive(Default)]
    DensityStructure {
        /// A grid.
        #[default]
        Default = AWD_STRUCTURE_DEFAULT,
        /// The tensor product of any families.
        Grid = AWD_STRUCTURE_GRID,
        /// Boxes halved where that pays, each with the lowest level of nested families.
        Tree = AWD_STRUCTURE_TREE,
    }
}

enumeration! {
    /// How points are drawn.
    #[derive(Default)]
    Sampler {
        /// By inverse CDF; by component for the estimator paper.
        #[default]
        Default = AWD_SAMPLER_DEFAULT,
        /// Marginal, then conditionals: one uniform an axis, monotone, so that strata are kept.
        InverseCdf = AWD_SAMPLER_INVERSE_CDF,
        /// A component from the first uniform, the point from it by one an axis; grids only.
        Component = AWD_SAMPLER_COMPONENT,
    }
}

/// One axis of a density.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct DensityAxis {
    /// Name of a family; None: "linear-bspline" on a grid, "haar" in a tree.
    pub basis: Option<String>,
    /// Level at first; None: by `pass_samples`.
    pub start_level: Option<u32>,
    /// Level beyond which it never refines; None: by `max_coefficients` on a grid, 20 halvings in a
    /// tree. Equal levels: it stays there.
    pub max_level: Option<u32>,
}

/// How a [`Density`](crate::Density) is made; 0 or None stands for what the library finds best.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DensitySettings {
    /// 1 to 6; must be set.
    pub dimensions: u32,
    /// Grid or tree.
    pub structure: DensityStructure,
    /// One for each dimension; empty: all defaults.
    pub axes: Vec<DensityAxis>,
    /// How coefficients come from samples.
    pub estimator: Estimator,
    /// What the density becomes proportional to.
    pub target: Target,
    /// How points are drawn.
    pub sampler: Sampler,
    /// How the passes' estimates of the integral make one.
    pub combination: Combination,
    /// Coefficients below tau times the mean density are raised to it, at most 1; 0: by the number
    /// of samples; negative: no floor, which risks infinite variance.
    pub tau: f64,
    /// Number of samples that the coarser level is worth; 0: by the basis; negative: no cascade.
    pub shrinkage: f64,
    /// To be expected in a pass; 0: 1024, later twice the last pass's.
    pub pass_samples: u64,
    /// 0: 65536.
    pub max_coefficients: u64,
    /// Solver of the estimator refit, "ceres" or "descent"; None: the module's first.
    pub refit_solver: Option<String>,
    /// Most memory that the sums of refit may take; 0: 2^28.
    pub refit_bytes: u64,
}

/// The description for C, with what it points to.
pub(crate) struct Description {
    axes: Vec<AWDDensityAxis>,
    _texts: Vec<Option<CString>>,
    refit_solver: Option<CString>,
    desc: AWDDensityDesc,
}

impl Description {
    pub(crate) fn new(settings: &DensitySettings) -> Result<Self> {
        if !settings.axes.is_empty() {
            check_length("axes", settings.axes.len(), settings.dimensions as usize)?;
        }
        let names = settings.axes.iter().map(|axis| text::c_option(&axis.basis, "basis"));
        let texts: Vec<Option<CString>> = names.collect::<Result<_>>()?;
        let axes = settings.axes.iter().zip(&texts).map(|(axis, name)| AWDDensityAxis {
            basis: text::pointer(name),
            startLevel: level(axis.start_level),
            maxLevel: level(axis.max_level),
        });
        Ok(Description {
            axes: axes.collect(),
            _texts: texts,
            refit_solver: text::c_option(&settings.refit_solver, "refit_solver")?,
            desc: AWDDensityDesc {
                dimensions: settings.dimensions,
                structure: settings.structure.raw(),
                estimator: settings.estimator.raw(),
                target: settings.target.raw(),
                sampler: settings.sampler.raw(),
                combination: settings.combination.raw(),
                tau: settings.tau,
                shrinkage: settings.shrinkage,
                passSamples: settings.pass_samples,
                maxCoefficients: settings.max_coefficients,
                refitBytes: settings.refit_bytes,
                ..Default::default()
            },
        })
    }

    /// Points into self.
    pub(crate) fn desc(&self) -> AWDDensityDesc {
        AWDDensityDesc {
            axes: if self.axes.is_empty() { std::ptr::null() } else { self.axes.as_ptr() },
            refitSolver: text::pointer(&self.refit_solver),
            ..self.desc
        }
    }
}
