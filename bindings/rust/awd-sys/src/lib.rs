// SPDX-License-Identifier: Apache-2.0
//! The C interface of libawd as it is, a module for each header. The headers in `include/awd` say
//! what everything does, what may be NULL, and what may be called at the same time; the names are
//! theirs. The crate `awd` is the safe interface on top.
//!
//! Structs that have an `..._INIT` macro in C implement `Default`, which is the same.
//!
//! ```
//! use std::ptr;
//!
//! let mut device: awd_sys::AWDDevice = ptr::null_mut();
//! let desc = awd_sys::AWDDeviceDesc { threads: 1, ..Default::default() };
//! // Safety: both pointers are good, and the handle is released once.
//! unsafe {
//!     assert_eq!(awd_sys::awdNewDevice(&desc, &mut device), awd_sys::AWD_SUCCESS);
//!     awd_sys::awdReleaseDevice(device);
//! }
//! ```
#![allow(non_snake_case)]

#[macro_use]
mod declare;

pub mod basis;
#[doc(hidden)]
pub mod declared;
pub mod density;
pub mod device;
pub mod field;
pub mod image;
pub mod light;
pub mod render;
pub mod scene;
pub mod types;

pub use basis::*;
pub use density::*;
pub use device::*;
pub use field::*;
pub use image::*;
pub use light::*;
pub use render::*;
pub use scene::*;
pub use types::*;
