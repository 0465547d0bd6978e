// SPDX-License-Identifier: Apache-2.0
//! The host's closures behind C's callbacks. No panic may cross C: it is kept until the call at
//! work has come back, and goes on there.

use std::any::Any;
use std::fmt;
use std::ops::ControlFlow;
use std::os::raw::{c_char, c_void};
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use awd_sys::*;

use crate::text;

enumeration! {
    /// Severity of a log message.
    LogLevel {
        /// Something to know.
        Info = AWD_LOG_INFO,
        /// Something that may not be meant, such as a scene without light.
        Warning = AWD_LOG_WARNING,
        /// Something that went wrong.
        Error = AWD_LOG_ERROR,
    }
}

/// What a long operation has done so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Progress {
    /// "commit", "pass" or "adapt".
    pub operation: String,
    /// 0 to 1, never falling within one operation.
    pub fraction: f64,
}

/// Takes a message of one line. May be called from any thread, also from several at once.
pub type LogFn = Box<dyn Fn(LogLevel, &str) + Send + Sync>;

/// Says whether to go on. `Break` cancels: the operation then ends soon with
/// [`ErrorCode::Cancelled`](crate::ErrorCode::Cancelled) and leaves its objects as they were.
/// Called from whichever thread is at work, never from two at once for one operation.
pub type ProgressFn = Box<dyn Fn(&Progress) -> ControlFlow<()> + Send + Sync>;

type Payload = Box<dyn Any + Send>;

/// Of no object: that of the log.
const LOG: usize = 0;

#[derive(Default)]
pub(crate) struct Callbacks {
    pub log: Option<LogFn>,
    pub progress: Option<ProgressFn>,
    panicked: AtomicBool,
    /// The object at work, by address, and what the closure panicked with.
    panics: Mutex<Vec<(usize, Payload)>>,
}

impl Callbacks {
    pub(crate) fn new(log: Option<LogFn>, progress: Option<ProgressFn>) -> Self {
        Callbacks { log, progress, ..Default::default() }
    }

    /// Goes on with a panic of the log closure, or of the progress closure while one of the objects
    /// was at work.
    pub(crate) fn resume(&self, objects: &[*const c_void]) {
        if !self.panicked.load(Ordering::Acquire) {
            return;
        }
        let mut panics = self.panics();
        let mine = |key: usize| key == LOG || objects.iter().any(|object| *object as usize == key);
        let found = panics.iter().position(|(key, _)| mine(*key));
        let payload = found.map(|index| panics.remove(index).1);
        self.panicked.store(!panics.is_empty(), Ordering::Release);
        drop(panics);
        if let Some(payload) = payload {
            resume_unwind(payload);
        }
    }

    fn panics(&self) -> MutexGuard<Vec<(usize, Payload)>> {
        self.panics.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn keep(&self, object: usize, payload: Payload) {
        self.panics().push((object, payload));
        self.panicked.store(true, Ordering::Release);
    }

    fn has_panicked(&self, object: usize) -> bool {
        self.panicked.load(Ordering::Acquire) && self.panics().iter().any(|(key, _)| *key == object)
    }
}

impl fmt::Debug for Callbacks {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter
            .debug_struct("Callbacks")
            .field("log", &self.log.is_some())
            .field("progress", &self.progress.is_some())
            .finish()
    }
}

/// # Safety
/// To be called by the library alone, with `Callbacks` as its user pointer.
pub(crate) unsafe extern "C" fn on_log(user: *mut c_void, severity: i32, message: *const c_char) {
    let callbacks = &*user.cast::<Callbacks>();
    let outcome = catch_unwind(AssertUnwindSafe(|| {
        if let Some(log) = &callbacks.log {
            log(LogLevel::from_raw(severity), &text::string(message));
        }
    }));
    if let Err(payload) = outcome {
        callbacks.keep(LOG, payload);
    }
}

/// # Safety
/// As of `on_log`.
pub(crate) unsafe extern "C" fn on_progress(user: *mut c_void, at: *const AWDProgress) -> i32 {
    let callbacks = &*user.cast::<Callbacks>();
    let object = (*at).object as usize;
    if callbacks.has_panicked(object) {
        return 0;
    }
    let outcome = catch_unwind(AssertUnwindSafe(|| match &callbacks.progress {
        None => ControlFlow::Continue(()),
        Some(progress) => progress(&Progress {
            operation: text::string((*at).operation),
            fraction: (*at).fraction,
        }),
    }));
    match outcome {
        Ok(ControlFlow::Continue(())) => 1,
        Ok(ControlFlow::Break(())) => 0,
        Err(payload) => {
            callbacks.keep(object, payload);
            0
        }
    }
}
