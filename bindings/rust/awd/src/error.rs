// SPDX-License-Identifier: Apache-2.0
//! What comes of a call.

use std::fmt;

use awd_sys::*;

use crate::text;

/// The outcome of a call of this crate.
pub type Result<T, E = Error> = std::result::Result<T, E>;

enumeration! {
    /// The kind of an [`Error`].
    ErrorCode {
        /// Nothing better is known.
        Unknown = AWD_ERROR_UNKNOWN,
        /// A value that the call can't take.
        InvalidArgument = AWD_ERROR_INVALID_ARGUMENT,
        /// A call at the wrong time.
        InvalidOperation = AWD_ERROR_INVALID_OPERATION,
        /// Memory ran out.
        OutOfMemory = AWD_ERROR_OUT_OF_MEMORY,
        /// Not in this build of the library, or a module is not there.
        Unsupported = AWD_ERROR_UNSUPPORTED,
        /// The progress closure said stop; nothing was changed.
        Cancelled = AWD_ERROR_CANCELLED,
        /// A file or bytes can't be read, or a file can't be written.
        Io = AWD_ERROR_IO,
        /// A module can't be opened or has no entry point.
        PluginLoad = AWD_ERROR_PLUGIN_LOAD,
        /// A module was compiled for another interface.
        PluginAbi = AWD_ERROR_PLUGIN_ABI,
        /// There is a family of that name already.
        PluginNameTaken = AWD_ERROR_PLUGIN_NAME_TAKEN,
        /// A module's mathematics is wrong; the message says where.
        PluginSelfTest = AWD_ERROR_PLUGIN_SELF_TEST,
    }
}

/// Why a call failed: the message names argument, value and remedy.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    code: ErrorCode,
    message: String,
}

impl Error {
    /// The kind of error.
    pub fn code(&self) -> ErrorCode {
        self.code
    }

    /// What is wrong: the library's words, or those of this crate for what never reached it.
    pub fn message(&self) -> &str {
        &self.message
    }

    pub(crate) fn new(code: ErrorCode, message: impl Into<String>) -> Self {
        Error { code, message: message.into() }
    }

    pub(crate) fn argument(message: impl Into<String>) -> Self {
        Error::new(ErrorCode::InvalidArgument, message)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.write_str(&self.message)
    }
}

impl std::error::Error for Error {}

/// Turns the result of this thread's last call into a `Result`.
pub(crate) fn check(result: AWDResult) -> Result<()> {
    if result == AWD_SUCCESS {
        return Ok(());
    }
    // Safety: the text is this thread's own until its next call.
    let message = unsafe { text::string(awdGetLastErrorMessage()) };
    Err(Error::new(ErrorCode::from_raw(result), message))
}

/// An error that hands back what the call would have consumed. `?` makes a plain [`Error`] of it.
#[derive(Debug)]
pub struct Returned<T> {
    /// Why the call failed.
    pub error: Error,
    /// What it was given.
    pub value: T,
}

impl<T> From<Returned<T>> for Error {
    fn from(returned: Returned<T>) -> Self {
        returned.error
    }
}

impl<T> fmt::Display for Returned<T> {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        self.error.fmt(formatter)
    }
}

impl<T: fmt::Debug> std::error::Error for Returned<T> {}
