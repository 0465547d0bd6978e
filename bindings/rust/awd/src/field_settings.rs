// SPDX-License-Identifier: Apache-2.0
//! How a field is made.

use std::ffi::CString;
use std::ptr;

use awd_sys::*;

use crate::settings::level;
use crate::slices::check_length;
use crate::{text, Estimator, Preset, Result, Target, Vector};

enumeration! {
    /// How the unit square is laid over the hemisphere.
    #[derive(Default)]
    HemisphereMap {
        /// Concentric-cosine; spherical in the preset paper.
        #[default]
        Default = AWD_MAP_DEFAULT,
        /// theta = pi u/2, phi = 2 pi v.
        Spherical = AWD_MAP_SPHERICAL,
        /// Equal-area square to disk to dome.
        ConcentricCosine = AWD_MAP_CONCENTRIC_COSINE,
        /// cos(theta) = u, phi = 2 pi v.
        Cylindrical = AWD_MAP_CYLINDRICAL,
        /// sin(theta)^2 = u, phi = 2 pi v.
        Cosine = AWD_MAP_COSINE,
    }
}

enumeration! {
    /// Which patches there are.
    #[derive(Default)]
    Patches {
        /// Spatial if there is a box, but for the preset paper.
        #[default]
        Default = AWD_PATCHES_DEFAULT,
        /// The library's own, found by [`Field::find_patch`](crate::Field::find_patch).
        Spatial = AWD_PATCHES_SPATIAL,
        /// The host's numbers, or those of the scene's triangles.
        Host = AWD_PATCHES_HOST,
    }
}

/// How a [`Field`](crate::Field) is made; 0 or None stands for what the preset says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FieldSettings {
    /// Settles every setting that is left open.
    pub preset: Preset,
    /// From the unit square to directions.
    pub map: HemisphereMap,
    /// Name of a family; None: "linear-bspline"; "haar" in the preset paper.
    pub basis: Option<String>,
    /// Level of a density's first pass; None: 3.
    pub start_level: Option<u32>,
    /// Level beyond which nothing is refined; None: 4.
    pub max_level: Option<u32>,
    /// Coefficients below tau times the mean density are raised to it, at most 1; negative: no
    /// floor, which risks infinite variance where there is no alpha.
    pub tau: f64,
    /// 0: lumped; paper in the preset of that name.
    pub estimator: Estimator,
    /// Solver of the estimator refit, "ceres" or "descent"; None: the module's first.
    pub refit_solver: Option<String>,
    /// Of the estimators quasi and refit, as in [`DensitySettings`](crate::DensitySettings).
    pub shrinkage: f64,
    /// Whose patches there are.
    pub patches: Patches,
    /// Lower and upper corner of the box of the positions of spatial patches, in the host's units;
    /// None: no box, or that of the scene.
    pub bounds: Option<(Vector, Vector)>,
    /// A spatial patch that has had more samples is split; 0: 2000.
    pub patch_samples: u32,
    /// Share of the map's constant density in every learned one; 0: 0.1 for the estimator lumped,
    /// else none; negative: none; at most 1.
    pub alpha: f64,
    /// Memory beyond which no patch is split; 0: no limit.
    pub max_bytes: u64,
    /// Lights, or groups of them, that shadow rays choose among, at most 64; 0: none, or those of
    /// the scene.
    pub light_count: u32,
    /// `light_count` powers >= 0, by which lights are chosen where nothing has been learned; None:
    /// equal ones.
    pub light_powers: Option<Vec<f32>>,
    /// What densities become proportional to.
    pub target: Target,
}

/// The description for C, with what it points to.
pub(crate) struct Description<'a> {
    basis: Option<CString>,
    refit_solver: Option<CString>,
    settings: &'a FieldSettings,
}

impl<'a> Description<'a> {
    pub(crate) fn new(settings: &'a FieldSettings) -> Result<Self> {
        if let Some(powers) = &settings.light_powers {
            check_length("light_powers", powers.len(), settings.light_count as usize)?;
        }
        Ok(Description {
            basis: text::c_option(&settings.basis, "basis")?,
            refit_solver: text::c_option(&settings.refit_solver, "refit_solver")?,
            settings,
        })
    }

    /// Points into self.
    pub(crate) fn desc(&self) -> AWDFieldDesc {
        let settings = self.settings;
        let (lower, upper) = settings.bounds.unwrap_or_default();
        AWDFieldDesc {
            preset: settings.preset.raw(),
            map: settings.map.raw(),
            basis: text::pointer(&self.basis),
            startLevel: level(settings.start_level),
            maxLevel: level(settings.max_level),
            tau: settings.tau,
            estimator: settings.estimator.raw(),
            refitSolver: text::pointer(&self.refit_solver),
            shrinkage: settings.shrinkage,
            patches: settings.patches.raw(),
            lower,
            upper,
            patchSamples: settings.patch_samples,
            alpha: settings.alpha,
            maxBytes: settings.max_bytes,
            lightCount: settings.light_count,
            lightPowers: settings.light_powers.as_ref().map_or(ptr::null(), |list| list.as_ptr()),
            target: settings.target.raw(),
            ..Default::default()
        }
    }
}
