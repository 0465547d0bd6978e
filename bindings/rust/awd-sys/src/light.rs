// SPDX-License-Identifier: Apache-2.0
//! awd/light.h: which light a shadow ray goes to.

use crate::types::*;

functions! {
    fn awdChooseLight(
        field: AWDField,
        patch: u32,
        uniform: f64,
        light: *mut u32,
        chance: *mut f32,
        rest: *mut f64,
    ) -> AWDResult;
    fn awdGetLightChance(field: AWDField, patch: u32, light: u32, chance: *mut f32) -> AWDResult;
    fn awdRecordLight(field: AWDField, patch: u32, light: u32, value: f64) -> AWDResult;
    fn awdGetPatchLight(field: AWDField, patch: u32, magnitude: *mut f32) -> AWDResult;
}
