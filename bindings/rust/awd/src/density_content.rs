// SPDX-License-Identifier: Apache-2.0
//! What a density holds: coefficients, boxes, statistics, bytes.

use std::ptr;

use awd_sys::*;

use crate::bytes::collect;
use crate::error::check;
use crate::slices::{check_length, product};
use crate::{Density, DensityAxisInfo, Result};

enumeration! {
    /// In which basis coefficients are told.
    #[derive(Default)]
    CoefficientForm {
        /// Those of p: the constant 1 has all of them 1.
        #[default]
        Scaling = AWD_COEFFICIENTS_SCALING,
        /// For nested families, in the orthonormal basis of each cell: the squares sum to the
        /// integral of p^2.
        Orthonormal = AWD_COEFFICIENTS_ORTHONORMAL,
    }
}

/// A box of a tree, `dimensions` numbers each.
#[derive(Clone, Debug, PartialEq)]
pub struct DensityBox {
    /// Its lower ends.
    pub lower: Vec<f64>,
    /// Its upper ends.
    pub upper: Vec<f64>,
}

impl Density {
    /// What an axis is; `axis` is below [`dimensions`](Density::dimensions).
    pub fn axis(&self, axis: u32) -> Result<DensityAxisInfo> {
        let mut info = AWDDensityAxisInfo::default();
        // Safety: the pointer is good, and the text lives as long as the density.
        unsafe {
            check(awdGetDensityAxisInfo(self.raw(), axis, &mut info))?;
            Ok(DensityAxisInfo::new(&info))
        }
    }

    /// All coefficients: of a grid with the last axis running fastest, of a tree leaf by leaf with
    /// each leaf like a grid.
    pub fn coefficients(&self, form: CoefficientForm) -> Result<Vec<f64>> {
        let mut factors = vec![self.count_leaves()?];
        for axis in 0..self.dimensions() {
            factors.push(self.axis(axis as u32)?.count as usize);
        }
        let mut values = vec![0.0; product(&factors)?];
        // Safety: as many as are told.
        check(unsafe {
            let (to, capacity) = (values.as_mut_ptr(), values.len());
            awdGetDensityCoefficients(self.raw(), form.raw(), to, capacity)
        })?;
        Ok(values)
    }

    /// Makes p the density of these scaling coefficients, divided by their integral: as many as
    /// there are now, finite, none negative, not all 0. Not after samples have been recorded.
    pub fn set_coefficients(&mut self, coefficients: &[f64]) -> Result<()> {
        // Safety: as many as are told.
        check(unsafe {
            awdSetDensityCoefficients(self.raw(), coefficients.as_ptr(), coefficients.len())
        })
    }

    /// The integral of p over a box; over all of [0,1]^d it is 1 but for rounding.
    pub fn integral(&self, lower: &[f64], upper: &[f64]) -> Result<f64> {
        check_length("lower", lower.len(), self.dimensions())?;
        check_length("upper", upper.len(), self.dimensions())?;
        let mut integral = 0.0;
        // Safety: `dimensions` numbers each.
        check(unsafe {
            awdGetDensityIntegral(self.raw(), lower.as_ptr(), upper.as_ptr(), &mut integral)
        })?;
        Ok(integral)
    }

    fn count_leaves(&self) -> Result<usize> {
        let mut count = 0;
        // Safety: with a capacity of 0 nothing is written but the count.
        check(unsafe { awdGetDensityLeaves(self.raw(), ptr::null_mut(), 0, &mut count) })?;
        Ok(count)
    }

    /// The boxes of a tree's leaves, in the order of their coefficients.
    pub fn leaves(&self) -> Result<Vec<DensityBox>> {
        let d = self.dimensions();
        let mut count = self.count_leaves()?;
        let mut boxes = vec![0.0; product(&[count, 2, d])?];
        // Safety: 2 d numbers a leaf.
        check(unsafe { awdGetDensityLeaves(self.raw(), boxes.as_mut_ptr(), count, &mut count) })?;
        let leaf = |ends: &[f64]| DensityBox { lower: ends[..d].into(), upper: ends[d..].into() };
        Ok(boxes.chunks_exact(2 * d).map(leaf).collect())
    }

    /// For nested families, the integral of p^2 split by wavelets: first that of the coarsest
    /// level, then that of the details between each rung and the next.
    pub fn detail_energy(&self) -> Result<Vec<f64>> {
        let mut count = 0;
        // Safety: with a capacity of 0 nothing is written but the count; then as many as are told.
        unsafe {
            check(awdGetDensityDetailEnergy(self.raw(), ptr::null_mut(), 0, &mut count))?;
            let mut energies = vec![0.0; count];
            let to = energies.as_mut_ptr();
            check(awdGetDensityDetailEnergy(self.raw(), to, energies.len(), &mut count))?;
            Ok(energies)
        }
    }

    /// What was recorded since the last adapt, to be sent to another process or machine.
    pub fn export_statistics(&mut self) -> Result<Vec<u8>> {
        // Safety: `collect` hands on good pointers.
        collect(|to, capacity, size| unsafe {
            awdExportDensityStatistics(self.raw(), to, capacity, size)
        })
    }

    /// Adds what a density of the same bases and boxes has exported.
    pub fn add_statistics(&mut self, bytes: &[u8]) -> Result<()> {
        // Safety: as many bytes as are told.
        check(unsafe { awdAddDensityStatistics(self.raw(), bytes.as_ptr().cast(), bytes.len()) })
    }

    /// Forgets what was recorded and takes this instead.
    pub fn import_statistics(&mut self, bytes: &[u8]) -> Result<()> {
        // Safety: as many bytes as are told.
        check(unsafe { awdImportDensityStatistics(self.raw(), bytes.as_ptr().cast(), bytes.len()) })
    }

    /// Everything that the density is and has recorded, with version and checksum.
    pub fn save(&mut self) -> Result<Vec<u8>> {
        // Safety: `collect` hands on good pointers.
        collect(|to, capacity, size| unsafe { awdSaveDensity(self.raw(), to, capacity, size) })
    }
}
