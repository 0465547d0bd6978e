// SPDX-License-Identifier: Apache-2.0
//! Adaptive wavelet densities for Monte Carlo ray tracing: libawd, safely.
//!
//! - A [`Density`] on [0,1]^d learns any function, so that its integral takes fewer samples.
//! - A [`Field`] has such a density for each patch of surface: it guides a path tracer of yours.
//! - A [`Render`] of a [`Scene`] is a path tracer of the library's own, with film and schedules.
//!
//! What the C headers call *free* takes `&self`, and may be called from any number of threads; what
//! they call *exclusive* takes `&mut self`. Objects keep what they were made of alive. Settings are
//! structs whose default lets the library decide. Numbers are checked by the library, and lengths
//! of slices here: what is wrong is an [`Error`] whose message says what to do, never a panic. A
//! panic in a closure of yours cancels the operation that called it and goes on in its caller.
//!
//! Left to `awd-sys` are mesh buffers that are not copied, the host's own allocator, and the host's
//! own scheduler.
#![warn(missing_docs)]

#[macro_use]
mod enumeration;
#[macro_use]
mod layout;

mod bases;
mod bytes;
mod callbacks;
mod continuation;
mod density;
mod density_content;
mod density_report;
mod density_settings;
mod device;
mod error;
mod field;
mod field_batch;
mod field_passes;
mod field_settings;
mod film;
mod handle;
mod image;
mod mesh;
mod patch;
mod path;
mod ray;
mod render;
mod render_settings;
mod scene;
mod schedule;
mod settings;
mod slices;
mod text;

pub use bases::{check_basis_module, Basis, BasisCheck, BasisFlags};
pub use callbacks::{LogFn, LogLevel, Progress, ProgressFn};
pub use continuation::Summands;
pub use density::{Density, Samples};
pub use density_content::{CoefficientForm, DensityBox};
pub use density_report::{DensityAxisInfo, DensityEstimate, DensityInfo, DensityReport};
pub use density_settings::{DensityAxis, DensitySettings, DensityStructure, Sampler};
pub use device::{Device, DeviceSettings};
pub use error::{Error, ErrorCode, Result, Returned};
pub use field::Field;
pub use field_passes::FieldStatistics;
pub use field_settings::{FieldSettings, HemisphereMap, Patches};
pub use film::{FilmInfo, FilmLayer, RenderError};
pub use image::Image;
pub use mesh::{Buffer, Item, Material, Mesh};
pub use patch::{ChosenLight, PatchInfo};
pub use path::{DirectionSample, PathVertex};
pub use ray::{Hit, Ray};
pub use render::{PassStatistics, Render};
pub use render_settings::{
    Camera, DirectLight, Guide, LightChoice, Points, RenderSettings, Roulette,
};
pub use scene::{Scene, SceneBuilder, SceneInfo};
pub use schedule::{Quality, Schedule};
pub use settings::{Combination, Estimator, Preset, RefitStatus, Target};

/// Three numbers: a position, a direction, or a colour.
pub type Vector = [f32; 3];

/// No mesh, triangle, material, patch or component.
pub const INVALID_ID: u32 = awd_sys::AWD_INVALID_ID;

/// The bit that tells the number of a patch from that of its back side.
pub const PATCH_BACK: u32 = awd_sys::AWD_PATCH_BACK;

/// Version of the loaded library: major, minor, patch.
pub fn version() -> (u32, u32, u32) {
    // Safety: no pointers.
    let version = unsafe { awd_sys::awdGetVersion() };
    (version / 10000, version / 100 % 100, version % 100)
}
