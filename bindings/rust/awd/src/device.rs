// SPDX-License-Identifier: Apache-2.0
//! The device.

use std::ffi::CString;
use std::fmt;
use std::os::raw::{c_char, c_void};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use awd_sys::*;

use crate::callbacks::{on_log, on_progress, Callbacks};
use crate::handle::Reference;
use crate::{text, LogFn, ProgressFn, Result};

/// How a [`Device`] works.
#[derive(Default)]
pub struct DeviceSettings {
    /// 0: all that this process may use; 1: everything runs in the calling thread. At most 1024.
    pub threads: u32,
    /// Don't read `$AWD_BASIS_PATH`.
    pub ignore_environment: bool,
    /// None: silent. If it panics, the panic goes on in a later call that uses the device.
    pub log: Option<LogFn>,
    /// None: nothing is reported, nothing can be cancelled. A panic cancels the operation and goes
    /// on in the call that was at work.
    pub progress: Option<ProgressFn>,
}

impl fmt::Debug for DeviceSettings {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter
            .debug_struct("DeviceSettings")
            .field("threads", &self.threads)
            .field("ignore_environment", &self.ignore_environment)
            .field("log", &self.log.is_some())
            .field("progress", &self.progress.is_some())
            .finish()
    }
}

/// Threads, closures, and the registry of basis families. Two devices share nothing; clones are the
/// same device. Objects keep their device alive.
///
/// A closure that holds a clone of its own device keeps it alive forever.
#[derive(Clone, Debug)]
pub struct Device {
    shared: Arc<Shared>,
}

/// The reference is dropped first: until then the library may call back.
#[derive(Debug)]
struct Shared {
    reference: Reference<AWDDeviceImpl>,
    callbacks: Arc<Callbacks>,
}

impl Device {
    /// Makes a device. Loads nothing yet: basis modules are looked for when one is asked for.
    ///
    /// ```
    /// use std::ops::ControlFlow;
    ///
    /// # fn main() -> awd::Result<()> {
    /// let device = awd::Device::new(awd::DeviceSettings {
    ///     log: Some(Box::new(|level, message| eprintln!("{:?}: {}", level, message))),
    ///     progress: Some(Box::new(|progress| {
    ///         eprint!("\r{} {:3.0} %", progress.operation, 100.0 * progress.fraction);
    ///         ControlFlow::Continue(())
    ///     })),
    ///     ..Default::default()
    /// })?;
    /// assert!(device.bases()?.iter().any(|basis| basis.name == "haar"));
    /// # Ok(())
    /// # }
    /// ```
    pub fn new(settings: DeviceSettings) -> Result<Self> {
        Self::make(settings, &[])
    }

    /// A device that looks for basis modules in these absolute folders before all others.
    ///
    /// # Safety
    /// What is there is loaded and run: it must be sound.
    pub unsafe fn with_basis_paths(settings: DeviceSettings, paths: &[PathBuf]) -> Result<Self> {
        Self::make(settings, paths)
    }

    fn make(settings: DeviceSettings, paths: &[PathBuf]) -> Result<Self> {
        let paths: Vec<CString> =
            paths.iter().map(|path| text::c_path(path, "paths")).collect::<Result<_>>()?;
        let pointers: Vec<*const c_char> = paths.iter().map(|path| path.as_ptr()).collect();
        let callbacks = Arc::new(Callbacks::new(settings.log, settings.progress));
        let user = Arc::as_ptr(&callbacks) as *mut c_void;
        let flags = if settings.ignore_environment { AWD_DEVICE_IGNORE_ENVIRONMENT } else { 0 };
        let desc = AWDDeviceDesc {
            threads: settings.threads,
            flags,
            log: callbacks.log.as_ref().map(|_| on_log as _),
            logUser: user,
            progress: callbacks.progress.as_ref().map(|_| on_progress as _),
            progressUser: user,
            basisPaths: pointers.as_ptr(),
            basisPathCount: pointers.len(),
            ..Default::default()
        };
        // Safety: the description lives through the call, the closures longer than the device.
        let reference = Reference::take(|raw| unsafe { awdNewDevice(&desc, raw) })?;
        let reference = reference.expect("a call that succeeds gives a device");
        Ok(Device { shared: Arc::new(Shared { reference, callbacks }) })
    }

    /// Loads one basis module by absolute path. Errors of the kinds `Plugin...` tell why not.
    ///
    /// # Safety
    /// The module's code is run: it must be sound.
    pub unsafe fn load_basis_module(&self, path: &Path) -> Result<()> {
        let path = text::c_path(path, "path")?;
        self.finish(awdLoadBasisModule(self.raw(), path.as_ptr()))
    }

    /// Registers a module that is linked into the program.
    ///
    /// # Safety
    /// The table and all that it points to must be sound, as `awd/basis.h` says.
    pub unsafe fn register_basis_module(&self, module: &'static AWDBasisModule) -> Result<()> {
        self.finish(awdRegisterBasisModule(self.raw(), module))
    }

    pub(crate) fn raw(&self) -> AWDDevice {
        self.shared.reference.raw()
    }

    pub(crate) fn resume(&self, objects: &[*const c_void]) {
        self.shared.callbacks.resume(objects);
    }

    pub(crate) fn finish(&self, result: AWDResult) -> Result<()> {
        let outcome = crate::error::check(result);
        self.resume(&[]);
        outcome
    }
}
