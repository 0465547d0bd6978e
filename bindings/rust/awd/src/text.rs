// SPDX-License-Identifier: Apache-2.0
//! Texts on their way to C and back.

use std::ffi::{CStr, CString};
use std::os::raw::c_char;
use std::os::unix::ffi::OsStrExt;
use std::path::Path;
use std::ptr;

use crate::{Error, Result};

pub(crate) fn c_string(text: &str, argument: &str) -> Result<CString> {
    CString::new(text)
        .map_err(|_| Error::argument(format!("{} has a zero byte: {:?}", argument, text)))
}

pub(crate) fn c_path(path: &Path, argument: &str) -> Result<CString> {
    CString::new(path.as_os_str().as_bytes())
        .map_err(|_| Error::argument(format!("{} has a zero byte: {:?}", argument, path)))
}

pub(crate) fn c_option(text: &Option<String>, argument: &str) -> Result<Option<CString>> {
    text.as_deref().map(|text| c_string(text, argument)).transpose()
}

/// Of None NULL. The pointer lives as long as the text.
pub(crate) fn pointer(text: &Option<CString>) -> *const c_char {
    text.as_ref().map_or(ptr::null(), |text| text.as_ptr())
}

/// A copy of a text of C's; "" for NULL.
///
/// # Safety
/// The pointer is NULL, or good and ends with a zero byte.
pub(crate) unsafe fn string(text: *const c_char) -> String {
    if text.is_null() {
        return String::new();
    }
    CStr::from_ptr(text).to_string_lossy().into_owned()
}
