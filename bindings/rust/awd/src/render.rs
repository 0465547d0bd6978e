// SPDX-License-Identifier: Apache-2.0
//! The renderer.

use std::ptr;

use awd_sys::*;

use crate::error::check;
use crate::handle::Handle;
use crate::{Error, ErrorCode, Field, RenderSettings, Result, Returned, Scene, Schedule};

/// Figures of one pass, or of all.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PassStatistics {
    /// Of the process, while rendering and adapting.
    pub cpu_seconds: f64,
    /// Likewise.
    pub wall_seconds: f64,
    /// Of the pass, or of all.
    pub samples_per_pixel: u64,
    /// Camera paths.
    pub samples: u64,
    /// Traced, shadow rays included.
    pub rays: u64,
    /// Of these.
    pub shadow_rays: u64,
    /// That have had a sample, at the end.
    pub patches: u64,
    /// Of their densities as used during the pass.
    pub coefficients: u64,
    /// Of field and film.
    pub bytes: u64,
    /// Paths and records that were NaN, infinite or negative: left out, but counted as samples.
    pub rejected_samples: u64,
}

impl PassStatistics {
    pub(crate) fn new(from: &AWDPassStatistics) -> Self {
        PassStatistics {
            cpu_seconds: from.cpuSeconds,
            wall_seconds: from.wallSeconds,
            samples_per_pixel: from.samplesPerPixel,
            samples: from.samples,
            rays: from.rays,
            shadow_rays: from.shadowRays,
            patches: from.patches,
            coefficients: from.coefficients,
            bytes: from.bytes,
            rejected_samples: from.rejectedSamples,
        }
    }
}

/// A path tracer with its film, of a committed scene. The same seed gives the same bits for any
/// number of threads.
///
/// It owns its field: [`field`](Render::field) lends it, [`into_field`](Render::into_field) gives
/// it back.
#[derive(Debug)]
pub struct Render {
    pub(crate) handle: Handle<AWDRenderImpl>,
    field: Option<Field>,
    /// The field that the library's render works with; NULL: none.
    learner: usize,
    /// Which nobody may change meanwhile.
    scene: Scene,
}

impl Render {
    /// Makes a render with a black film and, if it is adaptive, a field of its own.
    ///
    /// # Errors
    /// `InvalidArgument` names the setting that can't be.
    pub fn new(scene: &Scene, settings: &RenderSettings) -> Result<Self> {
        Self::make(scene, None, settings).map_err(Error::from)
    }

    /// The same with a field, which may have learned before; on failure it comes back. Used by
    /// [`Guide::Adaptive`](crate::Guide::Adaptive) alone.
    pub fn with_field(
        scene: &Scene,
        field: Field,
        settings: &RenderSettings,
    ) -> Result<Self, Returned<Field>> {
        Self::make(scene, Some(field), settings).map_err(|returned| Returned {
            error: returned.error,
            value: returned.value.expect("what was given"),
        })
    }

    fn make(
        scene: &Scene,
        field: Option<Field>,
        settings: &RenderSettings,
    ) -> Result<Self, Returned<Option<Field>>> {
        let camera = settings.camera.desc();
        let desc = settings.desc(&camera);
        let raw = field.as_ref().map_or(ptr::null_mut(), Field::raw);
        let device = scene.device();
        // Safety: the pointers are good, and the field is ours alone.
        let made = Handle::make(device, |to| unsafe { awdNewRender(scene.raw(), raw, &desc, to) })
            .and_then(|handle| Render::of(scene, handle));
        let mut render = match made {
            Ok(render) => render,
            Err(error) => return Err(Returned { error, value: field }),
        };
        // Of the field that was given, the render's is but another reference.
        render.field = field.or(render.field);
        Ok(render)
    }

    /// With the field that the library's render has.
    pub(crate) fn of(scene: &Scene, handle: Handle<AWDRenderImpl>) -> Result<Self> {
        // Safety: the pointers are good.
        let learner =
            Handle::take(scene.device(), |to| unsafe { awdGetRenderField(handle.raw(), to) })?;
        let address = learner.as_ref().map_or(0, |learner| learner.raw() as usize);
        let field = learner.map(|handle| Field { handle });
        Ok(Render { handle, field, learner: address, scene: scene.clone() })
    }

    pub(crate) fn raw(&self) -> AWDRender {
        self.handle.raw()
    }

    /// The scene.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The field: its own, or that which was given.
    pub fn field(&self) -> Option<&Field> {
        self.field.as_ref()
    }

    /// The field, for what is exclusive: [`Field::adapt`] after each [`pass`](Render::pass). If it
    /// is swapped for another one, the render refuses to work on.
    pub fn field_mut(&mut self) -> Option<&mut Field> {
        self.field.as_mut()
    }

    /// Ends the render and gives its field back, with what it has learned.
    pub fn into_field(self) -> Option<Field> {
        self.field
    }

    /// The library works with the field of this render: it must still be here.
    pub(crate) fn owns_field(&self) -> Result<()> {
        let here = self.field.as_ref().map_or(0, |field| field.raw() as usize);
        if self.learner == 0 || self.learner == here {
            return Ok(());
        }
        let message = "the render's field was swapped for another one: put it back";
        Err(Error::new(ErrorCode::InvalidOperation, message))
    }

    /// For calls in which render and field may be at work for long.
    pub(crate) fn finish(&self, result: AWDResult) -> Result<()> {
        let outcome = check(result);
        let field = self.field.as_ref().map_or(ptr::null(), |field| field.handle.address());
        self.handle.device().resume(&[self.handle.address(), field]);
        outcome
    }

    /// One pass of at least one sample per pixel with the densities as they are; doesn't adapt.
    ///
    /// # Errors
    /// `Cancelled` by the progress closure: film and field are as they were.
    pub fn pass(&mut self, samples_per_pixel: u32) -> Result<PassStatistics> {
        self.owns_field()?;
        let mut statistics = AWDPassStatistics::default();
        // Safety: the pointer is good; render and field are ours alone.
        self.finish(unsafe { awdRenderPass(self.raw(), samples_per_pixel, &mut statistics) })?;
        Ok(PassStatistics::new(&statistics))
    }

    /// Runs the passes of a schedule and adapts between them, not after the last.
    ///
    /// # Errors
    /// `Cancelled` by the progress closure: passes that were finished before stay.
    pub fn passes(&mut self, schedule: &Schedule) -> Result<()> {
        self.owns_field()?;
        let desc = schedule.desc()?;
        // Safety: the pointer is good; render and field are ours alone.
        self.finish(unsafe { awdRenderPasses(self.raw(), &desc) })
    }

    /// The patch under the middle of a pixel; None where nothing is seen.
    pub fn pixel_patch(&self, x: u32, y: u32) -> Result<Option<u32>> {
        self.owns_field()?;
        let mut patch = 0;
        // Safety: the pointer is good, and nobody can adapt the field meanwhile.
        check(unsafe { awdGetPixelPatch(self.raw(), x, y, &mut patch) })?;
        Ok(crate::scene::valid(patch))
    }

    /// The figures of each pass that was finished.
    pub fn pass_statistics(&mut self) -> Result<Vec<PassStatistics>> {
        let mut count = 0;
        // Safety: the pointer is good.
        check(unsafe { awdGetPassCount(self.raw(), &mut count) })?;
        let each = |index| {
            let mut statistics = AWDPassStatistics::default();
            // Safety: the pointer is good.
            check(unsafe { awdGetPassStatistics(self.raw(), index, &mut statistics) })?;
            Ok(PassStatistics::new(&statistics))
        };
        (0..count).map(each).collect()
    }

    /// Sums over all passes; patches, coefficients and bytes are those of the last.
    pub fn statistics(&mut self) -> Result<PassStatistics> {
        let mut statistics = AWDPassStatistics::default();
        // Safety: the pointer is good.
        check(unsafe { awdGetRenderStatistics(self.raw(), &mut statistics) })?;
        Ok(PassStatistics::new(&statistics))
    }
}
