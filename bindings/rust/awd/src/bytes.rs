// SPDX-License-Identifier: Apache-2.0
//! Bytes that the library writes.

use std::os::raw::c_void;
use std::ptr;

use awd_sys::AWDResult;

use crate::error::check;
use crate::Result;

/// What a call writes that tells its size first. It gets where to, how much there is room for, and
/// where to tell the size.
pub(crate) fn collect(
    write: impl Fn(*mut c_void, usize, *mut usize) -> AWDResult,
) -> Result<Vec<u8>> {
    let mut size = 0;
    check(write(ptr::null_mut(), 0, &mut size))?;
    let mut bytes = vec![0u8; size];
    check(write(bytes.as_mut_ptr().cast(), bytes.len(), &mut size))?;
    bytes.truncate(size);
    Ok(bytes)
}
