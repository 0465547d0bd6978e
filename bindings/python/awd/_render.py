# SPDX-License-Identifier: Apache-2.0
import ctypes
from dataclasses import dataclass
from typing import Any, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _arrays, _check
from . import _c as c
from ._arrays import FLOAT, UINT, address
from ._callbacks import ProgressLike
from ._enums import (Combination, DirectLight, FilmLayer, Guide, LightChoice, Points, Preset,
                     Quality, Roulette)
from ._field import Field
from ._figures import PassStatistics, QualitySchedule, RenderError, Triple, figures
from ._image import Image
from ._library import check, lib
from ._objects import Object, Reference, Use, described
from ._scene import Scene


@dataclass(frozen=True)
class Camera:
    """A pinhole camera. Pixel (i, j), row 0 on top, with (u, v) in [0,1)^2 looks along
    look_dir + tan_half_fov_x ((2 (i+u)/w - 1) right + (1 - 2 (j+v)/h) (h/w) up),
    right = look_dir x up; width, height: 1 to 65536."""

    eye: Triple = (0.0, 0.0, 0.0)
    look_dir: Triple = (0.0, 0.0, -1.0)
    up: Triple = (0.0, 1.0, 0.0)
    tan_half_fov_x: float = 0.5
    width: int = 512
    height: int = 512

    def _described(self) -> Any:
        camera = described(c.AWDCamera)
        camera.eye = _check.vector(self.eye, "camera.eye")
        camera.lookDir = _check.vector(self.look_dir, "camera.look_dir")
        camera.up = _check.vector(self.up, "camera.up")
        camera.tanHalfFovX = _check.number32(self.tan_half_fov_x, "camera.tan_half_fov_x")
        camera.width = _check.integer(self.width, "camera.width")
        camera.height = _check.integer(self.height, "camera.height")
        return camera


class Render(Object):
    """A path tracer with its film, of a committed scene.

    field: used if guide is ADAPTIVE; None: one of the render's own.
    shadow_rays: per light and vertex, at most 1024; max_lights: with more, shadow rays share them;
      max_split: rays a vertex, at most 64; max_bytes: of film, pass and field; 0: the default.
    awd/render.h tells the rest. The same seed gives the same bits for any number of threads.

    All methods are exclusive, run() and run_pass() for the field too; pixel_patch() is not.
    """

    _kind = "Render"
    # References, so that closing the Python objects of scene and field harms no render.
    _scene: Reference
    _field: Optional[Reference] = None

    def __init__(self, scene: Scene, camera: Camera, field: Optional[Field] = None, *,
                 preset: Union[Preset, str] = Preset.DEFAULT,
                 guide: Union[Guide, str] = Guide.ADAPTIVE,
                 direct: Union[DirectLight, str] = DirectLight.DEFAULT,
                 roulette: Union[Roulette, str] = Roulette.DEFAULT,
                 shadow_rays: int = 0, max_lights: int = 0, seed: int = 0,
                 combination: Union[Combination, str] = Combination.DEFAULT,
                 points: Union[Points, str] = Points.DEFAULT, max_bytes: int = 0,
                 max_split: int = 0,
                 lights: Union[LightChoice, str] = LightChoice.DEFAULT) -> None:
        _check.instance(scene, Scene, "scene")
        _check.instance(camera, Camera, "camera")
        if field is not None:
            _check.instance(field, Field, "field")
        known_camera = camera._described()
        desc = described(c.AWDRenderDesc)
        desc.camera = ctypes.pointer(known_camera)
        desc.preset = _check.enumerated(preset, Preset, "preset")
        desc.guide = _check.enumerated(guide, Guide, "guide")
        desc.direct = _check.enumerated(direct, DirectLight, "direct")
        desc.roulette = _check.enumerated(roulette, Roulette, "roulette")
        desc.shadowRays = _check.integer(shadow_rays, "shadow_rays")
        desc.maxLights = _check.integer(max_lights, "max_lights")
        desc.seed = _check.integer(seed, "seed", _check.UINT64)
        desc.combination = _check.enumerated(combination, Combination, "combination")
        desc.points = _check.enumerated(points, Points, "points")
        desc.maxBytes = _check.integer(max_bytes, "max_bytes", _check.UINT64)
        desc.maxSplit = _check.integer(max_split, "max_split")
        desc.lights = _check.enumerated(lights, LightChoice, "lights")
        handle, own = c.AWDRender(), c.AWDField()
        with Use(exclusive=(field,), shared=(scene,)):
            given = None if field is None else field._handle
            check(lib.awdNewRender(scene._handle, given, ctypes.byref(desc), ctypes.byref(handle)))
            self._own(handle, scene._callbacks)
            check(lib.awdGetRenderField(self._handle, ctypes.byref(own)))
            if own.value is not None:
                # One reference a field, so that it knows which calls use it.
                made = Field._make(own, scene)
                self._field = (made if field is None else field)._alive()
            self._scene = scene._alive()

    @property
    def field(self) -> Optional[Field]:
        """None unless the render is adaptive. The render keeps it alive, closed or not."""
        self._alive()
        return None if self._field is None else Field._sharing(self._field)

    def run_pass(self, samples_per_pixel: int, *, progress: ProgressLike = None) -> PassStatistics:
        """One pass of n >= 1 samples per pixel with the densities as they are; call field.adapt()
        after it. Cancelled, it leaves film and field as they were."""
        number = _check.integer(samples_per_pixel, "samples_per_pixel")
        statistics = described(c.AWDPassStatistics)
        self._long(progress, (self, self._field), (self._scene,), lambda: check(
            lib.awdRenderPass(self._handle, number, ctypes.byref(statistics))))
        return figures(PassStatistics, statistics)

    def run(self, *, samples: int = 0, seconds: float = 0.0, error: float = 0.0,
            passes: Optional[npt.ArrayLike] = None,
            quality: Union[Quality, str, None] = None, progress: ProgressLike = None) -> None:
        """Several passes, with adapting between them.

        samples: per pixel, divided into passes by the library.
        seconds: wall time, within which the library chooses passes.
        error: until the upper end of error() is not above it, within samples and seconds if set.
        passes: samples per pixel of each pass, instead of all these.
        quality: sets error, and the most samples unless `samples` is given; see quality_schedule().
        None of them: the preset's schedule.

        Passes that were finished before a cancellation stay.
        """
        schedule = described(c.AWDSchedule)
        schedule.totalSamples = _check.integer(samples, "samples")
        schedule.seconds = _check.number(seconds, "seconds")
        schedule.error = _check.number(error, "error")
        keep = None
        if passes is not None:
            keep = _arrays.packed(passes, UINT, (-1,), "passes")
            if len(keep) == 0:
                raise ValueError("passes is empty")
            schedule.samplesPerPass = ctypes.cast(address(keep), ctypes.POINTER(ctypes.c_uint32))
            schedule.passCount = _check.integer(len(keep), "the length of passes")
        if quality is not None:
            if schedule.error != 0.0:
                raise ValueError("error and quality are both set: quality sets the error")
            promise = quality_schedule(quality)
            schedule.error = promise.error
            schedule.totalSamples = schedule.totalSamples or promise.total_samples

        def body() -> None:
            check(lib.awdRenderPasses(self._handle, ctypes.byref(schedule)))

        self._long(progress, (self, self._field), (self._scene,), body)
        del keep  # until here the library may read it

    def film(self, layer: Union[FilmLayer, str] = FilmLayer.RADIANCE,
             out: Optional[npt.NDArray[np.float32]] = None) -> npt.NDArray[np.float32]:
        """A layer of the film: (height, width, 3) linear RGB, float32, row 0 on top.

        out: float32 of this shape. Pixels are written where they are if the channels of each are
        packed and pixels and rows go forward, as in image[..., :3] of four channels; otherwise
        through a copy.
        """
        known = _check.enumerated(layer, FilmLayer, "layer")
        with Use(exclusive=(self,)):
            width, height, _ = self._film_info()
            pixels = _arrays.output(out, FLOAT, (height, width, 3))
            with _arrays.image_output(pixels, 3 * FLOAT.itemsize) as (written, pixel, row):
                check(lib.awdReadFilm(self._handle, known, address(written), pixel, row))
        return pixels if out is None else out

    def _film_info(self) -> tuple[int, int, int]:
        width, height, samples = ctypes.c_uint32(), ctypes.c_uint32(), ctypes.c_uint64()
        check(lib.awdGetFilmInfo(self._handle, ctypes.byref(width), ctypes.byref(height),
                                 ctypes.byref(samples)))
        return width.value, height.value, samples.value

    @property
    def width(self) -> int:
        with Use(exclusive=(self,)):
            return self._film_info()[0]

    @property
    def height(self) -> int:
        with Use(exclusive=(self,)):
            return self._film_info()[1]

    @property
    def samples_per_pixel(self) -> int:
        """So far."""
        with Use(exclusive=(self,)):
            return self._film_info()[2]

    def image(self) -> Image:
        """The film: channels R G B; variance.R variance.G variance.B; samples.Y; metadata that says
        how it was made (keys begin with "awd.")."""
        made = Image.__new__(Image)
        made._take(self, lib.awdNewFilmImage, exclusive=True)
        return made

    def error(self) -> RenderError:
        """InvalidOperation below 2 samples per pixel."""
        error = described(c.AWDRenderError)
        with Use(exclusive=(self,)):
            check(lib.awdGetRenderError(self._handle, ctypes.byref(error)))
        return figures(RenderError, error)

    def passes(self) -> tuple[PassStatistics, ...]:
        """The figures of each pass so far."""
        count, found = ctypes.c_uint32(), []
        with Use(exclusive=(self,)):
            check(lib.awdGetPassCount(self._handle, ctypes.byref(count)))
            for index in range(count.value):
                statistics = described(c.AWDPassStatistics)
                check(lib.awdGetPassStatistics(self._handle, index, ctypes.byref(statistics)))
                found.append(figures(PassStatistics, statistics))
        return tuple(found)

    def statistics(self) -> PassStatistics:
        """Sums over all passes; patches, coefficients and bytes are those of the last."""
        statistics = described(c.AWDPassStatistics)
        with Use(exclusive=(self,)):
            check(lib.awdGetRenderStatistics(self._handle, ctypes.byref(statistics)))
        return figures(PassStatistics, statistics)

    def pixel_patch(self, x: int, y: int) -> Optional[int]:
        """The patch under the middle of a pixel; None where nothing is seen."""
        place = _check.integer(x, "x"), _check.integer(y, "y")
        patch = ctypes.c_uint32()
        with Use(shared=(self, self._field)):
            check(lib.awdGetPixelPatch(self._handle, *place, ctypes.byref(patch)))
        return None if patch.value == c.AWD_INVALID_ID else patch.value


def quality_schedule(quality: Union[Quality, str]) -> QualitySchedule:
    """What a quality promises. Whether it was kept: render.error().upper <= error, or
    render.samples_per_pixel is total_samples."""
    known = _check.enumerated(quality, Quality, "quality")
    schedule = described(c.AWDSchedule)
    check(lib.awdGetQualitySchedule(known, ctypes.byref(schedule)))
    return figures(QualitySchedule, schedule)
