// SPDX-License-Identifier: Apache-2.0
//! The passes of a field, in one process and in several.

use std::path::Path;

use awd_sys::*;

use crate::bytes::collect;
use crate::error::check;
use crate::handle::Handle;
use crate::{text, Device, Field, Result};

/// Figures of a field.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FieldStatistics {
    /// Patches that have ever had a sample.
    pub patches: u64,
    /// Coefficients of all their densities.
    pub coefficients: u64,
    /// Memory held by the field.
    pub bytes: u64,
    /// Recorded by the pass that the last adapt ended.
    pub samples: u64,
    /// Of these: NaN, infinite or negative, or of a bad pdf.
    pub rejected: u64,
    /// Of these: too large for the scale, clamped.
    pub saturated: u64,
    /// Patches whose samples were of no use: density kept as it was.
    pub kept: u64,
    /// Patches whose refit failed in the last adapt.
    pub refit_failed: u64,
    /// That ended at the solver's limit of iterations.
    pub refit_limited: u64,
    /// Of the solver in the last adapt, over all patches.
    pub refit_iterations: u64,
    /// Patches that `max_bytes` kept from being split in the last adapt.
    pub capped: u64,
    /// Of the rejected: values that were NaN.
    pub rejected_nan: u64,
    /// Values that were infinite.
    pub rejected_infinite: u64,
    /// Values that were negative.
    pub rejected_negative: u64,
    /// By a pdf that no sample can have, in a path.
    pub rejected_pdf: u64,
}

impl FieldStatistics {
    fn new(from: &AWDFieldStatistics) -> Self {
        FieldStatistics {
            patches: from.patches,
            coefficients: from.coefficients,
            bytes: from.bytes,
            samples: from.samples,
            rejected: from.rejected,
            saturated: from.saturated,
            kept: from.kept,
            refit_failed: from.refitFailed,
            refit_limited: from.refitLimited,
            refit_iterations: from.refitIterations,
            capped: from.capped,
            rejected_nan: from.rejectedNaN,
            rejected_infinite: from.rejectedInfinite,
            rejected_negative: from.rejectedNegative,
            rejected_pdf: from.rejectedPdf,
        }
    }
}

impl Field {
    /// The magnitude of values to be expected in patches that know nothing yet, such as the
    /// luminance of the brightest light; 1 at first.
    pub fn set_scale(&mut self, magnitude: f64) -> Result<()> {
        // Safety: no pointers.
        check(unsafe { awdSetFieldScale(self.raw(), magnitude) })
    }

    /// Ends a pass: what every patch has recorded becomes its next density, and spatial patches of
    /// many samples are split.
    ///
    /// # Errors
    /// `Cancelled` by the progress closure: the field is as it was.
    pub fn adapt(&mut self) -> Result<FieldStatistics> {
        let mut statistics = AWDFieldStatistics::default();
        // Safety: the pointer is good.
        self.handle.finish(unsafe { awdAdaptField(self.raw(), &mut statistics) })?;
        Ok(FieldStatistics::new(&statistics))
    }

    /// Remembers what has been recorded so far, for [`revert`](Field::revert).
    pub fn mark(&mut self) -> Result<()> {
        // Safety: no pointers.
        check(unsafe { awdMarkField(self.raw()) })
    }

    /// Forgets all that was recorded after the last mark.
    pub fn revert(&mut self) -> Result<()> {
        // Safety: no pointers.
        check(unsafe { awdRevertField(self.raw()) })
    }

    /// The figures without adapting.
    pub fn statistics(&mut self) -> Result<FieldStatistics> {
        let mut statistics = AWDFieldStatistics::default();
        // Safety: the pointer is good.
        check(unsafe { awdGetFieldStatistics(self.raw(), &mut statistics) })?;
        Ok(FieldStatistics::new(&statistics))
    }

    /// Adds what `other` has recorded since its last adapt; it stays as it is. Both must be the
    /// same in settings, patches and densities, such as fields loaded from the same bytes.
    pub fn merge(&mut self, other: &mut Field) -> Result<()> {
        // Safety: both are ours alone.
        check(unsafe { awdMergeField(self.raw(), other.raw()) })
    }

    /// Everything that the field is and has recorded, with version and checksum.
    pub fn save(&mut self) -> Result<Vec<u8>> {
        // Safety: `collect` hands on good pointers.
        collect(|to, capacity, size| unsafe { awdSaveField(self.raw(), to, capacity, size) })
    }

    /// The field that these bytes of [`save`](Field::save) are. Goes on with the same bits.
    ///
    /// # Errors
    /// `Io` if they are damaged.
    pub fn load(device: &Device, bytes: &[u8]) -> Result<Self> {
        // Safety: as many bytes as are told.
        let handle = Handle::make(device, |raw| unsafe {
            awdLoadField(device.raw(), bytes.as_ptr().cast(), bytes.len(), raw)
        })?;
        Ok(Field { handle })
    }

    /// The same bytes in a file, which is there whole or not at all.
    pub fn write(&mut self, path: impl AsRef<Path>) -> Result<()> {
        let path = text::c_path(path.as_ref(), "path")?;
        // Safety: the path is good.
        check(unsafe { awdWriteField(self.raw(), path.as_ptr()) })
    }

    /// The field in such a file.
    ///
    /// # Errors
    /// `Io` if it can't be read or is damaged.
    pub fn read(device: &Device, path: impl AsRef<Path>) -> Result<Self> {
        let path = text::c_path(path.as_ref(), "path")?;
        // Safety: the path is good.
        let handle =
            Handle::make(device, |raw| unsafe { awdReadField(device.raw(), path.as_ptr(), raw) })?;
        Ok(Field { handle })
    }
}
