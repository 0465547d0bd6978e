// SPDX-License-Identifier: Apache-2.0
//! awd/image.h: named float channels and metadata.

use std::os::raw::c_char;

use crate::types::*;

structs! {
    pub struct AWDPNGDesc {
        structSize: usize,
        exposure: f32,
        reserved: u32,
    }
}

inits! {
    AWDPNGDesc;
}

functions! {
    fn awdNewImage(device: AWDDevice, width: u32, height: u32, image: *mut AWDImage) -> AWDResult;
    fn awdNewFilmImage(render: AWDRender, image: *mut AWDImage) -> AWDResult;
    fn awdNewPatchImage(field: AWDField, patch: u32, n: u32, image: *mut AWDImage) -> AWDResult;
    fn awdReadImage(device: AWDDevice, path: *const c_char, image: *mut AWDImage) -> AWDResult;
    fn awdRetainImage(image: AWDImage);
    fn awdReleaseImage(image: AWDImage);
    fn awdGetImageInfo(
        image: AWDImage,
        width: *mut u32,
        height: *mut u32,
        channelCount: *mut u32,
    ) -> AWDResult;
    fn awdGetImageChannelName(image: AWDImage, index: u32, name: *mut *const c_char) -> AWDResult;
    fn awdSetImageChannel(
        image: AWDImage,
        name: *const c_char,
        pixels: *const f32,
        pixelStride: usize,
        rowStride: usize,
    ) -> AWDResult;
    fn awdGetImageChannel(
        image: AWDImage,
        name: *const c_char,
        pixels: *mut f32,
        pixelStride: usize,
        rowStride: usize,
    ) -> AWDResult;
    fn awdSetImageMetadata(image: AWDImage, key: *const c_char, value: *const c_char) -> AWDResult;
    fn awdGetImageMetadata(
        image: AWDImage,
        key: *const c_char,
        value: *mut *const c_char,
    ) -> AWDResult;
    fn awdWriteImageEXR(image: AWDImage, path: *const c_char) -> AWDResult;
    fn awdWriteImagePNG(image: AWDImage, path: *const c_char, desc: *const AWDPNGDesc) -> AWDResult;
}
