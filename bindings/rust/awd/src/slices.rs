// SPDX-License-Identifier: Apache-2.0
//! Lengths of slices, which C does not see.

use crate::{Error, Result};

/// An error unless a slice has the length that C will read or write.
pub(crate) fn check_length(argument: &str, length: usize, wanted: usize) -> Result<()> {
    if length == wanted {
        return Ok(());
    }
    Err(Error::argument(format!("{} has {} items: {} are needed", argument, length, wanted)))
}

/// The product of factors, each of which counts something in memory.
pub(crate) fn product(factors: &[usize]) -> Result<usize> {
    factors
        .iter()
        .try_fold(1usize, |product, factor| product.checked_mul(*factor))
        .ok_or_else(|| Error::argument(format!("{:?} multiplied can't be addressed", factors)))
}

/// How many points of `each` numbers a slice has.
pub(crate) fn count_points(argument: &str, length: usize, each: usize) -> Result<usize> {
    if each > 0 && length % each == 0 {
        return Ok(length / each);
    }
    Err(Error::argument(format!(
        "{} has {} numbers: give {} for each point",
        argument, length, each
    )))
}
