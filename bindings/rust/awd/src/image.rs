// SPDX-License-Identifier: Apache-2.0
//! Images.

use std::mem::size_of;
use std::path::Path;
use std::ptr;

use awd_sys::*;

use crate::error::check;
use crate::handle::Handle;
use crate::slices::{check_length, product};
use crate::{text, Device, Error, Field, Result};

/// Named float channels and text metadata, read from and written to OpenEXR, written to PNG. An
/// error leaves no half file, and an older file of the name untouched.
///
/// ```
/// # fn main() -> awd::Result<()> {
/// let device = awd::Device::new(Default::default())?;
/// let mut image = awd::Image::new(&device, 2, 1)?;
/// image.set_channel("Y", &[0.25, 0.75])?;
/// image.set_metadata("made by", Some("hand"))?;
/// assert_eq!(image.channel("Y")?, [0.25, 0.75]);
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Image {
    pub(crate) handle: Handle<AWDImageImpl>,
}

impl Image {
    /// An image without channels; width and height 1 to 65536.
    pub fn new(device: &Device, width: u32, height: u32) -> Result<Self> {
        // Safety: the pointers are good.
        let handle =
            Handle::make(device, |raw| unsafe { awdNewImage(device.raw(), width, height, raw) })?;
        Ok(Image { handle })
    }

    /// Reads whatever OpenEXR reads.
    ///
    /// # Errors
    /// `Io` for a file that is missing, truncated or damaged.
    pub fn read(device: &Device, path: impl AsRef<Path>) -> Result<Self> {
        let path = text::c_path(path.as_ref(), "path")?;
        // Safety: the pointers are good.
        let handle =
            Handle::make(device, |raw| unsafe { awdReadImage(device.raw(), path.as_ptr(), raw) })?;
        Ok(Image { handle })
    }

    /// The density of a patch on the unit square, as [`Field::patch_pdf`], in channel Y.
    pub fn of_patch(field: &Field, patch: u32, n: u32) -> Result<Self> {
        let device = field.handle.device();
        // Safety: the pointers are good.
        let handle =
            Handle::make(device, |raw| unsafe { awdNewPatchImage(field.raw(), patch, n, raw) })?;
        Ok(Image { handle })
    }

    fn raw(&self) -> AWDImage {
        self.handle.raw()
    }

    /// Width and height.
    pub fn size(&self) -> Result<(u32, u32)> {
        let (mut width, mut height) = (0, 0);
        // Safety: the pointers are good.
        check(unsafe { awdGetImageInfo(self.raw(), &mut width, &mut height, ptr::null_mut()) })?;
        Ok((width, height))
    }

    fn count_pixels(&self) -> Result<usize> {
        let (width, height) = self.size()?;
        product(&[width as usize, height as usize])
    }

    /// The names of the channels, sorted.
    pub fn channels(&self) -> Result<Vec<String>> {
        let mut count = 0;
        // Safety: the pointers are good, and the texts live until the image changes.
        unsafe {
            check(awdGetImageInfo(self.raw(), ptr::null_mut(), ptr::null_mut(), &mut count))?;
            let name = |index| {
                let mut name = ptr::null();
                check(awdGetImageChannelName(self.raw(), index, &mut name))?;
                Ok(text::string(name))
            };
            (0..count).map(name).collect()
        }
    }

    /// Adds or replaces a channel: height times width numbers, row 0 on top. The name: 1 to 63
    /// printable characters.
    pub fn set_channel(&mut self, name: &str, pixels: &[f32]) -> Result<()> {
        self.set_channel_of(name, pixels, 0, 1)
    }

    /// The same from one of several channels that alternate in `pixels`, such as the green of RGB:
    /// number 1 of 3.
    pub fn set_channel_of(
        &mut self,
        name: &str,
        pixels: &[f32],
        number: usize,
        channels: usize,
    ) -> Result<()> {
        let name = text::c_string(name, "name")?;
        let stride = self.check_pixels(pixels.len(), number, channels)?;
        // Safety: the pixels of the image, the last of which ends within the slice.
        check(unsafe {
            let from = pixels.as_ptr().add(number);
            awdSetImageChannel(self.raw(), name.as_ptr(), from, stride, 0)
        })
    }

    /// A channel: height times width numbers, row 0 on top.
    ///
    /// # Errors
    /// `InvalidArgument` if there is none of the name: the message lists those there are.
    pub fn channel(&self, name: &str) -> Result<Vec<f32>> {
        let mut pixels = vec![0.0; self.count_pixels()?];
        self.read_channel(name, &mut pixels, 0, 1)?;
        Ok(pixels)
    }

    /// The same into one of several channels that alternate in `pixels`.
    pub fn read_channel(
        &self,
        name: &str,
        pixels: &mut [f32],
        number: usize,
        channels: usize,
    ) -> Result<()> {
        let name = text::c_string(name, "name")?;
        let stride = self.check_pixels(pixels.len(), number, channels)?;
        // Safety: as above.
        check(unsafe {
            let to = pixels.as_mut_ptr().add(number);
            awdGetImageChannel(self.raw(), name.as_ptr(), to, stride, 0)
        })
    }

    /// Bytes from one pixel to the next.
    fn check_pixels(&self, length: usize, number: usize, channels: usize) -> Result<usize> {
        if number >= channels {
            let text = format!("channel number {} of {}: it must be less", number, channels);
            return Err(Error::argument(text));
        }
        check_length("pixels", length, product(&[self.count_pixels()?, channels])?)?;
        product(&[channels, size_of::<f32>()])
    }

    /// Adds or replaces a line of metadata; None removes it. The key: 1 to 63 printable characters.
    pub fn set_metadata(&mut self, key: &str, value: Option<&str>) -> Result<()> {
        let key = text::c_string(key, "key")?;
        let value = value.map(|value| text::c_string(value, "value")).transpose()?;
        // Safety: the texts are good.
        check(unsafe { awdSetImageMetadata(self.raw(), key.as_ptr(), text::pointer(&value)) })
    }

    /// A line of metadata, if there is one of that key.
    pub fn metadata(&self, key: &str) -> Result<Option<String>> {
        let key = text::c_string(key, "key")?;
        let mut value = ptr::null();
        // Safety: the pointers are good, and the text lives until the image changes.
        unsafe {
            check(awdGetImageMetadata(self.raw(), key.as_ptr(), &mut value))?;
            Ok((!value.is_null()).then(|| text::string(value)))
        }
    }

    /// Writes scanlines, float32, ZIP; metadata as string attributes.
    ///
    /// # Errors
    /// `Io` if the file can't be written.
    pub fn write_exr(&self, path: impl AsRef<Path>) -> Result<()> {
        let path = text::c_path(path.as_ref(), "path")?;
        // Safety: the path is good.
        check(unsafe { awdWriteImageEXR(self.raw(), path.as_ptr()) })
    }

    /// Writes 8 bit: colours in sRGB, values multiplied by 2^exposure and clipped, of an image with
    /// R, G and B; else the first channel in false colours.
    ///
    /// # Errors
    /// `Io` if the file can't be written.
    pub fn write_png(&self, path: impl AsRef<Path>, exposure: f32) -> Result<()> {
        let path = text::c_path(path.as_ref(), "path")?;
        let desc = AWDPNGDesc { exposure, ..Default::default() };
        // Safety: the pointers are good.
        check(unsafe { awdWriteImagePNG(self.raw(), path.as_ptr(), &desc) })
    }
}
