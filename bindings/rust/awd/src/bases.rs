// SPDX-License-Identifier: Apache-2.0
//! Basis families: which there are, and whether a module is right.

use std::any::Any;
use std::os::raw::c_void;
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};
use std::path::Path;

use awd_sys::*;

use crate::error::check;
use crate::{text, Device, Error, ErrorCode, Result};

/// What a family is like: flags of `awd/basis.h`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BasisFlags(pub u32);

impl BasisFlags {
    /// Its functions are orthogonal.
    pub fn orthogonal(self) -> bool {
        self.0 & AWD_BASIS_ORTHOGONAL != 0
    }

    /// What leaves [0,1] at one end comes back at the other.
    pub fn periodic(self) -> bool {
        self.0 & AWD_BASIS_PERIODIC != 0
    }

    /// Each support lies in one dyadic cell: tree densities are allowed.
    pub fn nested(self) -> bool {
        self.0 & AWD_BASIS_NESTED != 0
    }
}

/// A family that can be used, or a candidate that can't.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Basis {
    /// "" when a module could not say.
    pub name: String,
    /// One line.
    pub summary: String,
    /// Absolute path of its module; "" when registered from memory.
    pub file: String,
    /// Why it can't be used; None if it can.
    pub rejected: Option<Error>,
    /// Its properties.
    pub flags: BasisFlags,
    /// Polynomial degree + 1.
    pub order: u32,
    /// Coarsest level.
    pub min_level: u32,
    /// Finest level.
    pub max_level: u32,
}

impl Device {
    /// Families that were found, by name, then rejected candidates.
    pub fn bases(&self) -> Result<Vec<Basis>> {
        let mut count = 0;
        // Safety: the pointer is good.
        self.finish(unsafe { awdGetBasisCount(self.raw(), &mut count) })?;
        (0..count).map(|index| self.basis(index)).collect()
    }

    fn basis(&self, index: usize) -> Result<Basis> {
        let mut info = AWDBasisInfo::default();
        // Safety: the pointer is good, and the texts live as long as the device.
        unsafe {
            self.finish(awdGetBasisInfo(self.raw(), index, &mut info))?;
            let code = ErrorCode::from_raw(info.status);
            let failed = info.status != AWD_SUCCESS;
            Ok(Basis {
                name: text::string(info.name),
                summary: text::string(info.summary),
                file: text::string(info.file),
                rejected: failed.then(|| Error::new(code, text::string(info.message))),
                flags: BasisFlags(info.flags),
                order: info.order,
                min_level: info.minLevel,
                max_level: info.maxLevel,
            })
        }
    }
}

/// One check of a family's self-test.
#[derive(Clone, Debug, PartialEq)]
pub struct BasisCheck {
    /// Name of the family; "" when it could not say.
    pub family: String,
    /// Of the check, such as "partition of unity".
    pub name: String,
    /// Kind of failure, and what is wrong and where; None when all is well.
    pub failure: Option<Error>,
    /// Largest figure met; infinite when there is none to tell.
    pub worst: f64,
    /// That no figure may exceed.
    pub limit: f64,
    /// Of the family in its module.
    pub index: u32,
}

struct Report<'a> {
    each: &'a mut dyn FnMut(&BasisCheck),
    panic: Option<Box<dyn Any + Send>>,
}

/// Tests a basis module by absolute path as loading does, and registers nothing: `report` is called
/// with every check. The error is that of the first failure.
///
/// # Safety
/// The module's code is run: it must be sound.
pub unsafe fn check_basis_module(path: &Path, mut report: impl FnMut(&BasisCheck)) -> Result<()> {
    let path = text::c_path(path, "path")?;
    let mut report = Report { each: &mut report, panic: None };
    let user = &mut report as *mut Report as *mut c_void;
    let outcome = check(awdCheckBasisModule(path.as_ptr(), Some(on_check), user));
    if let Some(panic) = report.panic {
        resume_unwind(panic);
    }
    outcome
}

/// # Safety
/// To be called by the library alone, with a `Report` as its user pointer.
unsafe extern "C" fn on_check(user: *mut c_void, check: *const AWDBasisCheck) {
    let report = &mut *user.cast::<Report>();
    if report.panic.is_some() {
        return;
    }
    let check = &*check;
    let code = ErrorCode::from_raw(check.status);
    let failed = check.status != AWD_SUCCESS;
    let outcome = catch_unwind(AssertUnwindSafe(|| {
        (report.each)(&BasisCheck {
            family: text::string(check.family),
            name: text::string(check.name),
            failure: failed.then(|| Error::new(code, text::string(check.message))),
            worst: check.worst,
            limit: check.limit,
            index: check.index,
        })
    }));
    report.panic = outcome.err();
}
