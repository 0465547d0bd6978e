// SPDX-License-Identifier: Apache-2.0
//! Many queries at a time, for wavefront renderers: what the functions for one item do, in the
//! order of the items and with the same bits. If an argument is wrong the message names its index,
//! and nothing is written or recorded.

use awd_sys::*;

use crate::error::check;
use crate::slices::check_length;
use crate::{DirectionSample, Field, Result, Vector};

impl Field {
    /// [`find_patch`](Field::find_patch) for as many items as there are positions.
    pub fn find_patches(
        &self,
        positions: &[Vector],
        normals: &[Vector],
        patches: &mut [u32],
    ) -> Result<()> {
        let count = positions.len();
        check_length("normals", normals.len(), count)?;
        check_length("patches", patches.len(), count)?;
        // Safety: as many items as are told.
        check(unsafe {
            let (positions, normals) = (positions.as_ptr().cast(), normals.as_ptr().cast());
            awdFindPatches(self.raw(), count, positions, normals, patches.as_mut_ptr())
        })
    }

    /// [`sample`](Field::sample) for as many items as there are patches.
    pub fn sample_batch(
        &self,
        patches: &[u32],
        normals: &[Vector],
        uniforms: &[[f64; 3]],
        samples: &mut [DirectionSample],
    ) -> Result<()> {
        let count = patches.len();
        check_length("normals", normals.len(), count)?;
        check_length("uniforms", uniforms.len(), count)?;
        check_length("samples", samples.len(), count)?;
        // Safety: as many items as are told, samples of the same layout.
        check(unsafe {
            let (normals, uniforms) = (normals.as_ptr().cast(), uniforms.as_ptr().cast());
            let samples = samples.as_mut_ptr().cast();
            awdSampleFieldBatch(self.raw(), count, patches.as_ptr(), normals, uniforms, samples)
        })
    }

    /// [`pdf`](Field::pdf) for as many items as there are patches.
    pub fn pdfs(
        &self,
        patches: &[u32],
        normals: &[Vector],
        directions: &[Vector],
        pdfs: &mut [f32],
    ) -> Result<()> {
        let count = patches.len();
        check_length("normals", normals.len(), count)?;
        check_length("directions", directions.len(), count)?;
        check_length("pdfs", pdfs.len(), count)?;
        // Safety: as many items as are told.
        check(unsafe {
            let (normals, directions) = (normals.as_ptr().cast(), directions.as_ptr().cast());
            let pdfs = pdfs.as_mut_ptr();
            awdGetFieldPdfs(self.raw(), count, patches.as_ptr(), normals, directions, pdfs)
        })
    }

    /// [`record`](Field::record) for as many items as there are patches.
    pub fn record_batch(
        &self,
        patches: &[u32],
        samples: &[DirectionSample],
        values: &[f64],
    ) -> Result<()> {
        let count = patches.len();
        check_length("samples", samples.len(), count)?;
        check_length("values", values.len(), count)?;
        // Safety: as many items as are told, samples of the same layout.
        check(unsafe {
            let samples = samples.as_ptr().cast();
            awdRecordFieldBatch(self.raw(), count, patches.as_ptr(), samples, values.as_ptr())
        })
    }
}
