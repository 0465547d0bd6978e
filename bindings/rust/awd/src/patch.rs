// SPDX-License-Identifier: Apache-2.0
//! What a patch of a field knows.

use std::ptr;

use awd_sys::*;

use crate::error::check;
use crate::field::known;
use crate::slices::product;
use crate::{text, Error, Field, Result};

/// Along a side of an image of a patch's density.
const MOST_PIXELS: u32 = 16384;

/// What a patch knows; one never seen has the start density.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PatchInfo {
    /// Name of the family on both axes.
    pub basis: String,
    /// Of both axes.
    pub level: u32,
    /// Functions per axis; their square is the number of coefficients.
    pub axis_count: u32,
    /// Recorded since the last adapt.
    pub samples: u64,
    /// Samples of the pass that last changed the density; 0: start density.
    pub learned: u64,
}

/// A light that was chosen for a shadow ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChosenLight {
    /// Its number.
    pub light: u32,
    /// The chance that it had.
    pub chance: f32,
    /// The rest of the uniform, uniform in [0,1) again, to choose within a group of lights.
    pub rest: f64,
}

impl Field {
    /// The numbers of the patches that have had samples, ascending, front sides first.
    pub fn patches(&self) -> Result<Vec<u32>> {
        let mut patches = Vec::new();
        loop {
            let mut count = 0;
            // Safety: as many as are told.
            check(unsafe {
                let to = if patches.is_empty() { ptr::null_mut() } else { patches.as_mut_ptr() };
                awdGetFieldPatches(self.raw(), to, patches.len(), &mut count)
            })?;
            if count <= patches.len() {
                patches.truncate(count);
                return Ok(patches);
            }
            // Others may record meanwhile.
            patches.resize(count, 0);
        }
    }

    /// What a patch knows.
    pub fn patch(&self, patch: u32) -> Result<PatchInfo> {
        let mut info = AWDPatchInfo::default();
        // Safety: the pointer is good, and the text lives as long as the field.
        unsafe {
            check(awdGetPatchInfo(self.raw(), patch, &mut info))?;
            Ok(PatchInfo {
                basis: text::string(info.basis),
                level: info.level,
                axis_count: info.axisCount,
                samples: info.samples,
                learned: info.learned,
            })
        }
    }

    /// Coefficients c of p(u,v) = sum_jk c[j * axis_count + k] N_j(u) N_k(v), on the unit square.
    pub fn patch_coefficients(&self, patch: u32) -> Result<Vec<f64>> {
        let axis = self.patch(patch)?.axis_count as usize;
        let mut coefficients = vec![0.0; product(&[axis, axis])?];
        // Safety: as many as are told.
        check(unsafe {
            let (to, capacity) = (coefficients.as_mut_ptr(), coefficients.len());
            awdGetPatchCoefficients(self.raw(), patch, to, capacity)
        })?;
        Ok(coefficients)
    }

    /// What all passes have found the integral of f over the hemisphere to be: the indirect
    /// radiance that the patch reflects. None where nothing is known.
    pub fn patch_mean(&self, patch: u32) -> Result<Option<f32>> {
        let mut mean = 0.0;
        // Safety: the pointer is good.
        check(unsafe { awdGetPatchMean(self.raw(), patch, &mut mean) })?;
        Ok(known(mean))
    }

    /// The density on the unit square as n x n pixels, u to the right and v downwards, each of them
    /// p at its middle; n is 1 to 16384.
    pub fn patch_pdf(&self, patch: u32, n: u32) -> Result<Vec<f32>> {
        if n > MOST_PIXELS {
            return Err(Error::argument(format!("n is {}: at most {} is allowed", n, MOST_PIXELS)));
        }
        let mut pixels = vec![0.0; n as usize * n as usize];
        // Safety: n x n pixels.
        check(unsafe { awdGetPatchPdf(self.raw(), patch, n, pixels.as_mut_ptr(), 0) })?;
        Ok(pixels)
    }

    /// Chooses one of `light_count` lights for a shadow ray by a uniform in [0,1).
    ///
    /// # Errors
    /// `InvalidOperation` if the field knows no lights.
    pub fn choose_light(&self, patch: u32, uniform: f64) -> Result<ChosenLight> {
        let (mut light, mut chance, mut rest) = (0, 0.0, 0.0);
        // Safety: the pointers are good.
        check(unsafe {
            awdChooseLight(self.raw(), patch, uniform, &mut light, &mut chance, &mut rest)
        })?;
        Ok(ChosenLight { light, chance, rest })
    }

    /// The chance of a light to be chosen.
    pub fn light_chance(&self, patch: u32, light: u32) -> Result<f32> {
        let mut chance = 0.0;
        // Safety: the pointer is good.
        check(unsafe { awdGetLightChance(self.raw(), patch, light, &mut chance) })?;
        Ok(chance)
    }

    /// What a shadow ray to a light brought: the luminance of f_r L cos(theta) over the pdf of the
    /// point in solid angle, times the weight with which the host combines it; not divided by the
    /// chance of the light; 0 where it was hidden.
    pub fn record_light(&self, patch: u32, light: u32, value: f64) -> Result<()> {
        // Safety: no pointers.
        check(unsafe { awdRecordLight(self.raw(), patch, light, value) })
    }

    /// The root mean square of an estimate of all lights by one shadow ray chosen in the best way;
    /// 0 where nothing has been found.
    pub fn patch_light(&self, patch: u32) -> Result<f32> {
        let mut magnitude = 0.0;
        // Safety: the pointer is good.
        check(unsafe { awdGetPatchLight(self.raw(), patch, &mut magnitude) })?;
        Ok(magnitude)
    }
}
