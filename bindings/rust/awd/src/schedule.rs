// SPDX-License-Identifier: Apache-2.0
//! How many passes there are, and how good the image must be.

use std::ptr;

use awd_sys::*;

use crate::error::check;
use crate::{Error, Result};

enumeration! {
    /// How good an image must be: the upper end of its error, relative to its mean radiance.
    Quality {
        /// 0.5, or 1024 samples per pixel.
        Draft = AWD_QUALITY_DRAFT,
        /// 0.25, or 4096 samples per pixel.
        Normal = AWD_QUALITY_NORMAL,
        /// 0.1, or 16384 samples per pixel.
        Fine = AWD_QUALITY_FINE,
        /// 0.05, or 65536 samples per pixel.
        Reference = AWD_QUALITY_REFERENCE,
    }
}

/// Several passes; the default is the preset's schedule.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Schedule {
    /// The size of each pass; empty: sizes are the library's.
    pub samples_per_pass: Vec<u32>,
    /// Per pixel; 0: no limit but the others.
    pub total_samples: u32,
    /// Wall time; 0: no limit. Not with `samples_per_pass`.
    pub seconds: f64,
    /// Until the upper end of [`Render::error`](crate::Render::error) is not above this; 0: no
    /// limit. Not with `samples_per_pass`.
    pub error: f64,
    /// The passes that the render has had count as the first of this schedule, which goes on after
    /// them: after [`Render::load`](crate::Render::load), or a cancellation.
    pub resume: bool,
    /// That are rendered now, of those that are left; 0: all.
    pub max_passes: u32,
}

impl Schedule {
    /// Whose error and samples are those of a quality; seconds may be added. Whether the promise
    /// was kept is to be asked for afterwards: `upper > schedule.error` where samples ran out.
    pub fn of_quality(quality: Quality) -> Result<Self> {
        let mut schedule = AWDSchedule::default();
        // Safety: the pointer is good.
        check(unsafe { awdGetQualitySchedule(quality.raw(), &mut schedule) })?;
        let AWDSchedule { totalSamples, seconds, error, .. } = schedule;
        Ok(Schedule { total_samples: totalSamples, seconds, error, ..Schedule::default() })
    }

    /// Points into self.
    pub(crate) fn desc(&self) -> Result<AWDSchedule> {
        let passes = &self.samples_per_pass;
        let count = u32::try_from(passes.len())
            .map_err(|_| Error::argument(format!("{} passes are too many", passes.len())))?;
        Ok(AWDSchedule {
            samplesPerPass: if passes.is_empty() { ptr::null() } else { passes.as_ptr() },
            passCount: count,
            totalSamples: self.total_samples,
            seconds: self.seconds,
            error: self.error,
            resume: self.resume.into(),
            maxPasses: self.max_passes,
            ..Default::default()
        })
    }
}
