// SPDX-License-Identifier: Apache-2.0
//! What a render has made so far.

use awd_sys::*;

use crate::error::check;
use crate::handle::Handle;
use crate::slices::{check_length, product};
use crate::{Image, Render, Result};

enumeration! {
    /// What the film holds of a pixel.
    FilmLayer {
        /// Mean over all samples as they are weighted, linear RGB.
        Radiance = AWD_FILM_RADIANCE,
        /// Estimated variance of that mean, per channel; 0 below 2 samples.
        Variance = AWD_FILM_VARIANCE,
    }
}

/// Size of a film, and what it has had.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FilmInfo {
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// So far.
    pub samples_per_pixel: u64,
}

/// How far a film is from the truth, relative to its brightness:
/// sqrt(mean (x - truth)^2) / mean x, over all pixels and channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RenderError {
    /// As samples of even and of odd number tell it.
    pub error: f64,
    /// The true one is above this and
    pub lower: f64,
    /// below this 95 times of 100.
    pub upper: f64,
}

impl Render {
    /// Size of the film and samples so far.
    pub fn film_info(&mut self) -> Result<FilmInfo> {
        let (mut width, mut height, mut samples_per_pixel) = (0, 0, 0);
        // Safety: the pointers are good.
        check(unsafe {
            awdGetFilmInfo(self.raw(), &mut width, &mut height, &mut samples_per_pixel)
        })?;
        Ok(FilmInfo { width, height, samples_per_pixel })
    }

    /// A layer of the film: height times width pixels, row 0 on top.
    pub fn film(&mut self, layer: FilmLayer) -> Result<Vec<[f32; 3]>> {
        let mut pixels = vec![[0.0; 3]; self.count_pixels()?];
        self.read_film(layer, &mut pixels)?;
        Ok(pixels)
    }

    /// The same into a slice.
    pub fn read_film(&mut self, layer: FilmLayer, pixels: &mut [[f32; 3]]) -> Result<()> {
        check_length("pixels", pixels.len(), self.count_pixels()?)?;
        // Safety: all pixels of the film, packed.
        check(unsafe { awdReadFilm(self.raw(), layer.raw(), pixels.as_mut_ptr().cast(), 0, 0) })
    }

    fn count_pixels(&mut self) -> Result<usize> {
        let info = self.film_info()?;
        product(&[info.width as usize, info.height as usize])
    }

    /// How good the film is.
    ///
    /// # Errors
    /// `InvalidOperation` below 2 samples per pixel.
    pub fn error(&mut self) -> Result<RenderError> {
        let mut error = AWDRenderError::default();
        // Safety: the pointer is good.
        check(unsafe { awdGetRenderError(self.raw(), &mut error) })?;
        Ok(RenderError { error: error.error, lower: error.lower, upper: error.upper })
    }

    /// The film as an image: channels R G B; variance.R variance.G variance.B; samples.Y; metadata
    /// that says how it was made.
    pub fn film_image(&mut self) -> Result<Image> {
        let device = self.handle.device();
        // Safety: the pointers are good.
        let handle = Handle::make(device, |raw| unsafe { awdNewFilmImage(self.raw(), raw) })?;
        Ok(Image { handle })
    }
}
