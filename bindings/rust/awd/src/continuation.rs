// SPDX-License-Identifier: Apache-2.0
//! Renders that go on later, and renders and fields in several processes.

use std::path::Path;
use std::ptr;

use awd_sys::*;

use crate::error::check;
use crate::handle::Handle;
use crate::render::PassStatistics;
use crate::{text, Field, Render, RenderSettings, Result, Scene, Schedule};

/// What a process has found, to be combined with that of others number by number.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Summands {
    /// The first [`sums`](Summands::sums) are to be added, modulo 2^64; of each of the others the
    /// largest is to be taken.
    pub numbers: Vec<u64>,
    /// How many of the numbers are sums.
    pub sums: usize,
}

impl Summands {
    /// `fill` writes into as much room as it is given, and tells how many sums and maxima there are.
    fn collect(
        mut fill: impl FnMut(*mut u64, usize, &mut usize, &mut usize) -> AWDResult,
    ) -> Result<Self> {
        let (mut sums, mut maxima) = (0, 0);
        check(fill(ptr::null_mut(), 0, &mut sums, &mut maxima))?;
        let mut numbers = vec![0; sums + maxima];
        check(fill(numbers.as_mut_ptr(), numbers.len(), &mut sums, &mut maxima))?;
        Ok(Summands { numbers, sums })
    }

    /// Takes in what another process has found. Both must be of one pass: false, and nothing is
    /// changed, if they differ in length.
    #[must_use]
    pub fn combine(&mut self, other: &Summands) -> bool {
        let fits = self.sums == other.sums && self.numbers.len() == other.numbers.len();
        if fits {
            for (i, (mine, theirs)) in self.numbers.iter_mut().zip(&other.numbers).enumerate() {
                *mine =
                    if i < self.sums { mine.wrapping_add(*theirs) } else { (*mine).max(*theirs) };
            }
        }
        fits
    }
}

impl Render {
    /// Writes a checkpoint, between passes: film, figures, settings and field, in a file that is
    /// there whole or not at all.
    ///
    /// # Errors
    /// `Io` if the file can't be written.
    pub fn save(&mut self, path: impl AsRef<Path>) -> Result<()> {
        self.owns_field()?;
        let path = text::c_path(path.as_ref(), "path")?;
        // Safety: the path is good; render and field are ours alone.
        check(unsafe { awdSaveRender(self.raw(), path.as_ptr()) })
    }

    /// The render in a checkpoint of this scene, with a field of its own if it is adaptive. It goes
    /// on by schedules with [`resume`](Schedule::resume), or pass by pass, to the same bits as if
    /// it had never stopped. `settings`: if they must be those of the checkpoint.
    ///
    /// # Errors
    /// `InvalidArgument` if the scene or the settings are others, `Io` if the file can't be read or
    /// is damaged.
    pub fn load(
        scene: &Scene,
        path: impl AsRef<Path>,
        settings: Option<&RenderSettings>,
    ) -> Result<Self> {
        let path = text::c_path(path.as_ref(), "path")?;
        let camera = settings.map(|settings| settings.camera.desc());
        let desc = settings.zip(camera.as_ref()).map(|(settings, camera)| settings.desc(camera));
        let known = desc.as_ref().map_or(ptr::null(), |desc| desc as *const _);
        let handle = Handle::make(scene.device(), |to| {
            // Safety: the pointers are good.
            unsafe { awdLoadRender(scene.raw(), path.as_ptr(), ptr::null_mut(), known, to) }
        })?;
        Render::of(scene, handle)
    }

    /// Renders part `part` of `parts` of the schedule's next pass, and adapts before it where that
    /// is due: the samples per pixel of the pass, 0 if the schedule is through.
    /// [`export_pass`](Render::export_pass) and [`import_pass`](Render::import_pass) end it.
    ///
    /// # Errors
    /// `Cancelled` by the progress closure: film and field are as they were. `InvalidArgument` for
    /// schedules of seconds.
    pub fn pass_part(&mut self, schedule: &Schedule, part: u32, parts: u32) -> Result<u32> {
        self.owns_field()?;
        let desc = schedule.desc()?;
        let mut samples = 0;
        // Safety: the pointers are good; render and field are ours alone.
        self.finish(unsafe { awdRenderPassPart(self.raw(), &desc, part, parts, &mut samples) })?;
        Ok(samples)
    }

    /// The part that was rendered last.
    ///
    /// # Errors
    /// `InvalidOperation` if none waits to be imported.
    pub fn export_pass(&mut self) -> Result<Summands> {
        self.owns_field()?;
        Summands::collect(|numbers, capacity, sums, maxima| {
            // Safety: there is room for so many.
            unsafe { awdExportPass(self.raw(), numbers, capacity, sums, maxima) }
        })
    }

    /// Ends the pass with the numbers of all parts, combined.
    ///
    /// # Errors
    /// `InvalidArgument`, and nothing is changed, unless each part is in them once and all processes
    /// have the same scene, settings, passes and densities.
    pub fn import_pass(&mut self, numbers: &[u64]) -> Result<PassStatistics> {
        self.owns_field()?;
        let mut statistics = AWDPassStatistics::default();
        // Safety: the pointers are good; render and field are ours alone.
        check(unsafe {
            awdImportPass(self.raw(), numbers.as_ptr(), numbers.len(), &mut statistics)
        })?;
        Ok(PassStatistics::new(&statistics))
    }
}

impl Field {
    /// What was recorded since the last adapt. `patches`: of a field with patches of the host's
    /// own, the numbers of all in which any process may have recorded, ascending; else empty.
    ///
    /// # Errors
    /// `InvalidArgument` if a patch that is not among these has records.
    pub fn export_records(&mut self, patches: &[u32]) -> Result<Summands> {
        Summands::collect(|numbers, capacity, sums, maxima| {
            let (listed, count) = list(patches);
            // Safety: the pointers are good, and there is room for so many.
            unsafe { awdExportField(self.raw(), listed, count, numbers, capacity, sums, maxima) }
        })
    }

    /// Puts the combined numbers in its place: the bits are those of one process that has recorded
    /// everything.
    ///
    /// # Errors
    /// `InvalidArgument`, and nothing is changed, if the fields were not all the same.
    pub fn import_records(&mut self, numbers: &[u64], patches: &[u32]) -> Result<()> {
        let (listed, count) = list(patches);
        // Safety: the pointers are good.
        check(unsafe { awdImportField(self.raw(), listed, count, numbers.as_ptr(), numbers.len()) })
    }
}

/// NULL for none.
fn list(patches: &[u32]) -> (*const u32, usize) {
    let pointer = if patches.is_empty() { ptr::null() } else { patches.as_ptr() };
    (pointer, patches.len())
}
