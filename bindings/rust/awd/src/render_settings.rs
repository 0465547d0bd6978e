// SPDX-License-Identifier: Apache-2.0
//! How a render is made.

use awd_sys::*;

use crate::{Combination, Preset, Vector};

enumeration! {
    /// Where indirect rays go.
    #[derive(Default)]
    Guide {
        /// By the field's density.
        #[default]
        Adaptive = AWD_GUIDE_ADAPTIVE,
        /// pdf = cos(theta) / pi.
        Cosine = AWD_GUIDE_COSINE,
        /// pdf = 1 / (2 pi).
        Uniform = AWD_GUIDE_UNIFORM,
    }
}

enumeration! {
    /// How light is found.
    #[derive(Default)]
    DirectLight {
        /// Weighted; area in the preset paper.
        #[default]
        Default = AWD_DIRECT_DEFAULT,
        /// Shadow rays alone: infinite variance where a light touches a surface.
        Area = AWD_DIRECT_AREA,
        /// Shadow rays and indirect rays that meet a light, by balance weights.
        Weighted = AWD_DIRECT_WEIGHTED,
        /// By indirect rays that meet a light, alone.
        None = AWD_DIRECT_NONE,
    }
}

enumeration! {
    /// How long paths live.
    #[derive(Default)]
    Roulette {
        /// Adjoint if adaptive, throughput if uniform, else albedo.
        #[default]
        Default = AWD_ROULETTE_DEFAULT,
        /// By the largest component of the albedo.
        Albedo = AWD_ROULETTE_ALBEDO,
        /// By that of throughput times albedo.
        Throughput = AWD_ROULETTE_THROUGHPUT,
        /// By the radiance still to come, with splitting; needs [`Guide::Adaptive`].
        Adjoint = AWD_ROULETTE_ADJOINT,
    }
}

enumeration! {
    /// What paths are drawn from.
    #[derive(Default)]
    Points {
        /// Sobol; random in the preset paper.
        #[default]
        Default = AWD_POINTS_DEFAULT,
        /// Independent numbers.
        Random = AWD_POINTS_RANDOM,
        /// Sobol's sequence with Owen's scrambling.
        Sobol = AWD_POINTS_SOBOL,
    }
}

enumeration! {
    /// Which light a shadow ray goes to, where lights share them.
    #[derive(Default)]
    LightChoice {
        /// Learned if adaptive and the field chooses lights; else by power.
        #[default]
        Default = AWD_LIGHTS_DEFAULT,
        /// By power.
        Power = AWD_LIGHTS_POWER,
        /// As the field has learned; needs one of [`Field::for_scene`](crate::Field::for_scene).
        Learned = AWD_LIGHTS_LEARNED,
    }
}

/// A pinhole camera. Pixel (i, j), row 0 on top, with (u, v) in [0,1)^2 looks along
/// `look_dir + tan_half_fov_x ((2 (i+u)/w - 1) right + (1 - 2 (j+v)/h) (h/w) up)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Where it is, in the host's units.
    pub eye: Vector,
    /// Is normalised.
    pub look_dir: Vector,
    /// Is made orthogonal to `look_dir`.
    pub up: Vector,
    /// > 0
    pub tan_half_fov_x: f32,
    /// Pixels, 1 to 65536.
    pub width: u32,
    /// Pixels, 1 to 65536.
    pub height: u32,
}

impl Default for Camera {
    fn default() -> Self {
        let AWDCamera { eye, lookDir, up, tanHalfFovX, width, height, .. } = Default::default();
        Camera { eye, look_dir: lookDir, up, tan_half_fov_x: tanHalfFovX, width, height }
    }
}

impl Camera {
    pub(crate) fn desc(&self) -> AWDCamera {
        AWDCamera {
            eye: self.eye,
            lookDir: self.look_dir,
            up: self.up,
            tanHalfFovX: self.tan_half_fov_x,
            width: self.width,
            height: self.height,
            ..Default::default()
        }
    }
}

/// How a [`Render`](crate::Render) is made; 0 stands for what the preset says.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RenderSettings {
    /// What is seen.
    pub camera: Camera,
    /// Settles every setting that is left open.
    pub preset: Preset,
    /// Where indirect rays go.
    pub guide: Guide,
    /// How light is found.
    pub direct: DirectLight,
    /// How long paths live.
    pub roulette: Roulette,
    /// Per light and vertex, at most 1024; 0: 1, in the preset paper 4.
    pub shadow_rays: u32,
    /// With more lights than this, the shadow rays of a vertex share them; 0: 1, in the preset
    /// paper 8.
    pub max_lights: u32,
    /// The same seed gives the same bits for any number of threads.
    pub seed: u64,
    /// Count or experience.
    pub combination: Combination,
    /// What paths are drawn from.
    pub points: Points,
    /// Memory of film, pass and field together; 0: no limit.
    pub max_bytes: u64,
    /// Of the roulette adjoint: rays a vertex, at most 64; 1: none; 0: 8.
    pub max_split: u32,
    /// Which light a shadow ray goes to.
    pub lights: LightChoice,
}

impl RenderSettings {
    pub(crate) fn desc(&self, camera: &AWDCamera) -> AWDRenderDesc {
        AWDRenderDesc {
            camera,
            preset: self.preset.raw(),
            guide: self.guide.raw(),
            direct: self.direct.raw(),
            roulette: self.roulette.raw(),
            shadowRays: self.shadow_rays,
            maxLights: self.max_lights,
            seed: self.seed,
            combination: self.combination.raw(),
            points: self.points.raw(),
            maxBytes: self.max_bytes,
            maxSplit: self.max_split,
            lights: self.lights.raw(),
            ..Default::default()
        }
    }
}
