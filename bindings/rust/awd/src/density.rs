// SPDX-License-Identifier: Apache-2.0
//! Adaptive densities on the unit cube: sampling and learning.

use std::ptr;

use awd_sys::*;

use crate::density_settings::Description;
use crate::error::check;
use crate::handle::Handle;
use crate::slices::{check_length, count_points, product};
use crate::{DensityEstimate, DensityInfo, DensityReport, DensitySettings, Device, Result};

/// A pdf on [0,1]^d that learns |f| from samples of f, so that the next samples fall where f is
/// large.
///
/// A pass: draw points, evaluate f there, record what it is, adapt. In between the density is
/// frozen, so that the mean of f / p is unbiased. The same samples give the same bits however they
/// were split into batches, threads ([`fork`](Density::fork)) or machines
/// ([`export_statistics`](Density::export_statistics)).
///
/// Arrays are packed: point i starts at `points[i * dimensions]`.
///
/// ```
/// # fn main() -> awd::Result<()> {
/// let device = awd::Device::new(Default::default())?;
/// let settings = awd::DensitySettings { dimensions: 1, ..Default::default() };
/// let mut density = awd::Density::new(&device, &settings)?;
/// for _ in 0..3 {
///     let uniforms: Vec<f64> = (0..1000).map(|i| (i as f64 + 0.5) / 1000.0).collect();
///     let samples = density.sample(&uniforms)?;
///     let values: Vec<f64> = samples.points.iter().map(|x| x * x).collect();
///     density.record(&samples.points, Some(&samples.pdfs), None, &values)?;
///     density.adapt()?;
/// }
/// assert!((density.estimate()?.integral - 1.0 / 3.0).abs() < 1e-3);
/// # Ok(())
/// # }
/// ```
///
/// What is exclusive wants `&mut`: no thread can sample while another one adapts.
///
/// ```compile_fail,E0502
/// # fn test(density: &mut awd::Density) {
/// let reader = &*density;
/// density.adapt().unwrap();
/// reader.pdf(&[0.5]).unwrap();
/// # }
/// ```
#[derive(Debug)]
pub struct Density {
    pub(crate) handle: Handle<AWDDensityImpl>,
    dimensions: usize,
    uniforms: usize,
}

/// Points that were drawn, packed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Samples {
    /// `dimensions` numbers for each, in [0,1).
    pub points: Vec<f64>,
    /// One for each: bit for bit what [`Density::pdf`] says.
    pub pdfs: Vec<f64>,
    /// One for each: [`INVALID_ID`](crate::INVALID_ID) unless the sampler is component.
    pub components: Vec<u32>,
}

impl Density {
    /// Makes a constant density.
    ///
    /// # Errors
    /// `Unsupported` when there is no such basis or, for the estimator refit, no refit module, or a
    /// tree is asked of a family that is not nested.
    pub fn new(device: &Device, settings: &DensitySettings) -> Result<Self> {
        let description = Description::new(settings)?;
        let desc = description.desc();
        // Safety: the pointers are good, and what desc points to lives in the description.
        Self::of(Handle::make(device, |raw| unsafe { awdNewDensity(device.raw(), &desc, raw) })?)
    }

    /// The density that these bytes of [`save`](Density::save) are. Goes on with the same bits.
    ///
    /// # Errors
    /// `Io` if they are damaged.
    pub fn load(device: &Device, bytes: &[u8]) -> Result<Self> {
        Self::of(Handle::make(device, |raw| unsafe {
            // Safety: as many bytes as are told.
            awdLoadDensity(device.raw(), bytes.as_ptr().cast(), bytes.len(), raw)
        })?)
    }

    fn of(handle: Handle<AWDDensityImpl>) -> Result<Self> {
        let mut density = Density { handle, dimensions: 0, uniforms: 0 };
        let info = density.info()?;
        density.dimensions = info.dimensions as usize;
        density.uniforms = info.uniforms as usize;
        Ok(density)
    }

    pub(crate) fn raw(&self) -> AWDDensity {
        self.handle.raw()
    }

    /// Numbers of each point.
    pub fn dimensions(&self) -> usize {
        self.dimensions
    }

    /// Uniforms for each point: one more than dimensions if the sampler is component.
    pub fn uniforms(&self) -> usize {
        self.uniforms
    }

    /// A density of the same p, which both share, and with no samples: one for each thread that
    /// records.
    pub fn fork(&self) -> Result<Self> {
        let device = self.handle.device();
        // Safety: the pointers are good.
        let handle = Handle::make(device, |raw| unsafe { awdForkDensity(self.raw(), raw) })?;
        Ok(Density { handle, ..*self })
    }

    /// Takes what a fork of this density, or of the one that it was forked from, has recorded; the
    /// fork then takes over this one's p and has no samples.
    pub fn join(&mut self, fork: &mut Density) -> Result<()> {
        // Safety: both are ours alone.
        check(unsafe { awdJoinDensity(self.raw(), fork.raw()) })
    }

    /// Draws points from [`uniforms`](Density::uniforms) numbers in [0,1) for each.
    pub fn sample(&self, uniforms: &[f64]) -> Result<Samples> {
        let count = count_points("uniforms", uniforms.len(), self.uniforms)?;
        let mut samples = Samples {
            points: vec![0.0; count * self.dimensions],
            pdfs: vec![0.0; count],
            components: vec![0; count],
        };
        let Samples { points, pdfs, components } = &mut samples;
        self.sample_into(uniforms, points, Some(pdfs), Some(components))?;
        Ok(samples)
    }

    /// The same into slices of the right lengths.
    pub fn sample_into(
        &self,
        uniforms: &[f64],
        points: &mut [f64],
        pdfs: Option<&mut [f64]>,
        components: Option<&mut [u32]>,
    ) -> Result<()> {
        let count = count_points("uniforms", uniforms.len(), self.uniforms)?;
        check_length("points", points.len(), product(&[count, self.dimensions])?)?;
        let pdfs = optional("pdfs", pdfs, count)?;
        let components = optional("components", components, count)?;
        // Safety: the lengths are as C wants them.
        check(unsafe {
            let points = points.as_mut_ptr();
            awdSampleDensity(self.raw(), count, uniforms.as_ptr(), points, pdfs, components)
        })
    }

    /// p at points of [0,1]^d.
    pub fn pdf(&self, points: &[f64]) -> Result<Vec<f64>> {
        let mut pdfs = vec![0.0; count_points("points", points.len(), self.dimensions)?];
        self.pdf_into(points, &mut pdfs)?;
        Ok(pdfs)
    }

    /// The same into a slice, one number for each point.
    pub fn pdf_into(&self, points: &[f64], pdfs: &mut [f64]) -> Result<()> {
        let count = count_points("points", points.len(), self.dimensions)?;
        check_length("pdfs", pdfs.len(), count)?;
        // Safety: the lengths are as C wants them.
        check(unsafe { awdGetDensityPdf(self.raw(), count, points.as_ptr(), pdfs.as_mut_ptr()) })
    }

    /// Tells the values of f at points. Zeros belong in. `pdfs`: with what density each was drawn;
    /// None: p itself. `components`: those of the sampler component. If an argument is wrong
    /// nothing is recorded. At most 2^30 - 1 samples a pass.
    pub fn record(
        &mut self,
        points: &[f64],
        pdfs: Option<&[f64]>,
        components: Option<&[u32]>,
        values: &[f64],
    ) -> Result<()> {
        let count = values.len();
        check_length("points", points.len(), product(&[count, self.dimensions])?)?;
        let pdfs = match pdfs {
            Some(pdfs) => check_length("pdfs", pdfs.len(), count).map(|_| pdfs.as_ptr())?,
            None => ptr::null(),
        };
        let components = match components {
            Some(list) => check_length("components", list.len(), count).map(|_| list.as_ptr())?,
            None => ptr::null(),
        };
        // Safety: the lengths are as C wants them.
        check(unsafe {
            let points = points.as_ptr();
            awdRecordDensity(self.raw(), count, points, pdfs, components, values.as_ptr())
        })
    }

    /// Ends a pass: p becomes what the samples say, and recording starts anew. A failure changes
    /// nothing.
    ///
    /// # Errors
    /// `Cancelled` by the progress closure, which only the estimator refit calls.
    pub fn adapt(&mut self) -> Result<DensityReport> {
        let mut report = AWDDensityReport::default();
        // Safety: the pointer is good, and the text lives until the next adapt.
        unsafe {
            self.handle.finish(awdAdaptDensity(self.raw(), &mut report))?;
            Ok(DensityReport::new(&report))
        }
    }

    /// The same p one level finer along an axis; None: along all. Not after samples have been
    /// recorded.
    pub fn refine(&mut self, axis: Option<u32>) -> Result<()> {
        // Safety: no pointers.
        check(unsafe { awdRefineDensity(self.raw(), axis.unwrap_or(AWD_ALL_AXES)) })
    }

    /// The estimate of the integral of f.
    pub fn estimate(&mut self) -> Result<DensityEstimate> {
        let mut estimate = AWDDensityEstimate::default();
        // Safety: the pointer is good.
        check(unsafe { awdGetDensityEstimate(self.raw(), &mut estimate) })?;
        Ok(DensityEstimate {
            integral: estimate.integral,
            standard_error: estimate.standardError,
            samples: estimate.samples,
            passes: estimate.passes,
        })
    }

    /// What the density is.
    pub fn info(&mut self) -> Result<DensityInfo> {
        let mut info = AWDDensityInfo::default();
        // Safety: the pointer is good.
        check(unsafe { awdGetDensityInfo(self.raw(), &mut info) })?;
        Ok(DensityInfo::new(&info))
    }
}

fn optional<T>(argument: &str, slice: Option<&mut [T]>, count: usize) -> Result<*mut T> {
    match slice {
        Some(slice) => check_length(argument, slice.len(), count).map(|_| slice.as_mut_ptr()),
        None => Ok(ptr::null_mut()),
    }
}
