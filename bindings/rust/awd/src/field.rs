// SPDX-License-Identifier: Apache-2.0
//! The field: one adaptive density per patch of surface, over the hemisphere above it.

use std::ptr;

use awd_sys::*;

use crate::error::check;
use crate::field_settings::Description;
use crate::handle::Handle;
use crate::{Device, DirectionSample, FieldSettings, PathVertex, Result, Scene, Vector};

/// Densities over surfaces, which learn where light comes from.
///
/// A host asks for directions ([`sample`](Field::sample)), tells what came from them
/// ([`record`](Field::record), [`record_path`](Field::record_path)), and after each pass lets the
/// field learn ([`adapt`](Field::adapt)). During a pass the densities are frozen, and any number of
/// threads may share `&Field`; sums are integers, so that the order of what they record is of no
/// account. Normals and directions are unit vectors, uniforms in [0,1).
///
/// ```
/// # fn main() -> awd::Result<()> {
/// let device = awd::Device::new(Default::default())?;
/// let bounds = Some(([-1.0; 3], [1.0; 3]));
/// let mut field = awd::Field::new(&device, &awd::FieldSettings { bounds, ..Default::default() })?;
/// let (position, normal) = ([0.0; 3], [0.0, 1.0, 0.0]);
/// let toward = |direction: [f32; 3]| if direction[0] > 0.5 { 1.0 } else { 0.0 };
/// for _ in 0..3 {
///     let patch = field.find_patch(position, normal)?;
///     for i in 0..2000 {
///         let uniforms = [(i as f64 + 0.5) / 2000.0, (i as f64 * 0.618) % 1.0, 0.5];
///         let sample = field.sample(patch, normal, uniforms)?;
///         field.record(patch, &sample, toward(sample.direction))?;
///     }
///     field.adapt()?;
/// }
/// let patch = field.find_patch(position, normal)?;
/// let (left, right) = ([-0.8, 0.6, 0.0], [0.8, 0.6, 0.0]);
/// assert!(field.pdf(patch, normal, right)? > 3.0 * field.pdf(patch, normal, left)?);
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Field {
    pub(crate) handle: Handle<AWDFieldImpl>,
}

impl Field {
    /// Makes an empty field.
    ///
    /// # Errors
    /// `Unsupported` when there is no such basis or, for the estimator refit, no refit module.
    pub fn new(device: &Device, settings: &FieldSettings) -> Result<Self> {
        let description = Description::new(settings)?;
        let desc = description.desc();
        // Safety: the pointers are good, and what desc points to lives in the description.
        let handle = Handle::make(device, |raw| unsafe { awdNewField(device.raw(), &desc, raw) })?;
        Ok(Field { handle })
    }

    /// The same for renders of a scene: a box and lights that are left open are those of the scene.
    pub fn for_scene(scene: &Scene, settings: &FieldSettings) -> Result<Self> {
        let description = Description::new(settings)?;
        let desc = description.desc();
        let device = scene.device();
        // Safety: as above.
        let handle =
            Handle::make(device, |raw| unsafe { awdNewSceneField(scene.raw(), &desc, raw) })?;
        Ok(Field { handle })
    }

    pub(crate) fn raw(&self) -> AWDField {
        self.handle.raw()
    }

    /// The number of the spatial patch at a point, until the next adapt. Numbers that agree but for
    /// their three lowest bits are one patch.
    ///
    /// # Errors
    /// `InvalidOperation` if the field has the host's patches.
    pub fn find_patch(&self, position: Vector, normal: Vector) -> Result<u32> {
        let mut patch = 0;
        // Safety: three floats each.
        check(unsafe { awdFindPatch(self.raw(), position.as_ptr(), normal.as_ptr(), &mut patch) })?;
        Ok(patch)
    }

    /// Draws a direction about the normal. A patch that has not learned anything has the start
    /// density.
    pub fn sample(
        &self,
        patch: u32,
        normal: Vector,
        uniforms: [f64; 3],
    ) -> Result<DirectionSample> {
        let mut sample = DirectionSample::default();
        let to = &mut sample as *mut DirectionSample;
        // Safety: three numbers each, and a sample of the same layout.
        check(unsafe {
            awdSampleField(self.raw(), patch, normal.as_ptr(), uniforms.as_ptr(), to.cast())
        })?;
        Ok(sample)
    }

    /// The pdf of a direction in solid angle, 1/sr; 0 below the horizon.
    pub fn pdf(&self, patch: u32, normal: Vector, direction: Vector) -> Result<f32> {
        let mut pdf = 0.0;
        // Safety: three floats each.
        check(unsafe {
            awdGetFieldPdf(self.raw(), patch, normal.as_ptr(), direction.as_ptr(), &mut pdf)
        })?;
        Ok(pdf)
    }

    /// A direction that the host drew itself, as a sample that can be recorded. A host that draws
    /// with chance a from the field and else from its BSDF sets
    /// `pdf = a p_field + (1 - a) p_bsdf` in every sample. Below the horizon pdf and solid angle
    /// are 0, and the sample can't be recorded.
    pub fn map_direction(
        &self,
        patch: u32,
        normal: Vector,
        direction: Vector,
    ) -> Result<DirectionSample> {
        let mut sample = DirectionSample::default();
        let to = &mut sample as *mut DirectionSample;
        // Safety: three floats each, and a sample of the same layout.
        check(unsafe {
            awdMapDirection(self.raw(), patch, normal.as_ptr(), direction.as_ptr(), to.cast())
        })?;
        Ok(sample)
    }

    /// What came from a sampled direction: the luminance of f_r L_i cos(theta), 0 where nothing
    /// came; not divided by the pdf. NaN, infinite or negative values count as rejected samples of
    /// value 0.
    pub fn record(&self, patch: u32, sample: &DirectionSample, value: f64) -> Result<()> {
        let sample = sample as *const DirectionSample;
        // Safety: a sample of the same layout.
        check(unsafe { awdRecordField(self.raw(), patch, sample.cast(), value) })
    }

    /// Records a path from the camera on, and gives its estimate of what the camera sees.
    /// `background`: what comes from outside the scene, if the last vertex went on. If a vertex
    /// can't be, the call fails and nothing is recorded.
    pub fn record_path(
        &self,
        vertices: &[PathVertex],
        background: Option<Vector>,
    ) -> Result<Vector> {
        let mut radiance = [0.0; 3];
        let background = background.as_ref().map_or(ptr::null(), |color| color.as_ptr());
        // Safety: as many vertices of the same layout as are told, three floats each.
        check(unsafe {
            let from = vertices.as_ptr().cast();
            awdRecordFieldPath(self.raw(), vertices.len(), from, background, radiance.as_mut_ptr())
        })?;
        Ok(radiance)
    }

    /// With how many rays on average a path should go on from a vertex, by the radiance that is
    /// still to come. `throughput`: luminance of the path's weight before the vertex; `expected`:
    /// that of the radiance that the pixel is expected to have; `max_split`: 1 to 64, 0: 8. Trace
    /// floor(rays) of them, one more with the chance of the fraction, and divide each by rays. None
    /// where nothing is known.
    pub fn continuation(
        &self,
        patch: u32,
        throughput: f32,
        expected: f32,
        max_split: u32,
    ) -> Result<Option<f32>> {
        let mut rays = 0.0;
        // Safety: the pointer is good.
        check(unsafe {
            awdGetContinuation(self.raw(), patch, throughput, expected, max_split, &mut rays)
        })?;
        Ok(known(rays))
    }
}

/// -1 in C stands for what is not known.
pub(crate) fn known(value: f32) -> Option<f32> {
    (value >= 0.0).then(|| value)
}
