// SPDX-License-Identifier: Apache-2.0
//! The library's objects as they are owned here.

use std::os::raw::c_void;
use std::ptr::{self, NonNull};

use awd_sys::*;

use crate::{error, Device, Result};

/// What is behind a handle.
pub(crate) trait Object {
    /// Drops a reference.
    ///
    /// # Safety
    /// The reference must be the caller's.
    unsafe fn release(raw: *mut Self);
}

macro_rules! objects {
    ($( $object:ident: $release:ident; )*) => { $(
        impl Object for $object {
            unsafe fn release(raw: *mut Self) {
                $release(raw)
            }
        }
    )* };
}

objects! {
    AWDDeviceImpl: awdReleaseDevice;
    AWDSceneImpl: awdReleaseScene;
    AWDFieldImpl: awdReleaseField;
    AWDDensityImpl: awdReleaseDensity;
    AWDRenderImpl: awdReleaseRender;
    AWDImageImpl: awdReleaseImage;
}

/// A reference, dropped with this.
#[derive(Debug)]
pub(crate) struct Reference<T: Object>(NonNull<T>);

// Safety: no object belongs to a thread. What is done through &self are functions that the headers
// call free; exclusive ones want &mut self.
unsafe impl<T: Object> Send for Reference<T> {}
unsafe impl<T: Object> Sync for Reference<T> {}

impl<T: Object> Reference<T> {
    /// Takes over the reference that the call gives; None if it gave none.
    pub(crate) fn take(new: impl FnOnce(*mut *mut T) -> AWDResult) -> Result<Option<Self>> {
        let mut raw = ptr::null_mut();
        error::check(new(&mut raw))?;
        Ok(NonNull::new(raw).map(Reference))
    }

    pub(crate) fn raw(&self) -> *mut T {
        self.0.as_ptr()
    }
}

impl<T: Object> Drop for Reference<T> {
    fn drop(&mut self) {
        // Safety: it is ours.
        unsafe { T::release(self.raw()) }
    }
}

/// An object of a device, with the device, whose closures it may call.
#[derive(Debug)]
pub(crate) struct Handle<T: Object> {
    reference: Reference<T>,
    device: Device,
}

impl<T: Object> Handle<T> {
    /// What a function `awdNew...` makes.
    pub(crate) fn make(
        device: &Device,
        new: impl FnOnce(*mut *mut T) -> AWDResult,
    ) -> Result<Self> {
        let taken = Self::take(device, new)?;
        Ok(taken.expect("a call that succeeds gives an object"))
    }

    /// The same for one that may give none.
    pub(crate) fn take(
        device: &Device,
        new: impl FnOnce(*mut *mut T) -> AWDResult,
    ) -> Result<Option<Self>> {
        let taken = Reference::take(new);
        device.resume(&[]);
        Ok(taken?.map(|reference| Handle { reference, device: device.clone() }))
    }

    pub(crate) fn raw(&self) -> *mut T {
        self.reference.raw()
    }

    pub(crate) fn address(&self) -> *const c_void {
        self.raw() as *const c_void
    }

    pub(crate) fn device(&self) -> &Device {
        &self.device
    }

    /// For calls in which this object may be at work for long: goes on with a closure's panic.
    pub(crate) fn finish(&self, result: AWDResult) -> Result<()> {
        let outcome = error::check(result);
        self.device.resume(&[self.address()]);
        outcome
    }
}
