# SPDX-License-Identifier: Apache-2.0
import ctypes
from dataclasses import dataclass
from typing import Any, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _arrays, _check
from . import _c as c
from ._arrays import FLOAT, address
from ._callbacks import ProgressLike
from ._enums import (Combination, DirectLight, FilmLayer, Guide, LightChoice, Points, Preset,
                     Quality, Roulette)
from ._exchange import Records, exported, joined
from ._field import Field
from ._figures import PassStatistics, RenderError, Triple, figures
from ._image import Image
from ._library import check, lib
from ._objects import Object, Reference, Use, described
from ._scene import Scene
from ._schedule import schedule_of


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

    All methods are exclusive, those that run, save, export and import for the field too;
    pixel_patch() is not.
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
        if field is not None:
            _check.instance(field, Field, "field")
        desc = settings_of(camera, preset=preset, guide=guide, direct=direct, roulette=roulette,
                           shadow_rays=shadow_rays, max_lights=max_lights, seed=seed,
                           combination=combination, points=points, max_bytes=max_bytes,
                           max_split=max_split, lights=lights)
        handle = c.AWDRender()
        with Use(exclusive=(field,), shared=(scene,)):
            given = None if field is None else field._handle
            check(lib.awdNewRender(scene._handle, given, ctypes.byref(desc), ctypes.byref(handle)))
            self._begin(handle, scene, field)

    def _begin(self, handle: Any, scene: Scene, field: Optional[Field]) -> None:
        self._own(handle, scene._callbacks)
        own = c.AWDField()
        check(lib.awdGetRenderField(self._handle, ctypes.byref(own)))
        if own.value is not None:
            # One reference a field, so that it knows which calls use it.
            made = Field._make(own, scene)
            self._field = (made if field is None else field)._alive()
        self._scene = scene._alive()

    @classmethod
    def load(cls, scene: Scene, path: _check.PathLike, camera: Optional[Camera] = None,
             field: Optional[Field] = None, **settings: Any) -> "Render":
        """From a checkpoint of save(), to go on with the same bits: run(resume=True, ..). `scene`
        must be made as it was then. camera and settings, if given, are those of Render(); together
        with those of `field`, which is not used itself, they must be what the checkpoint has:
        InvalidArgument names the first that differs. FileError: no file, or a damaged one."""
        _check.instance(scene, Scene, "scene")
        known = _check.path(path, "path")
        if field is not None:
            _check.instance(field, Field, "field")
        if camera is None and settings:
            raise ValueError(f"{', '.join(settings)}: settings are compared with a camera alone")
        desc = None if camera is None else settings_of(camera, **settings)
        handle, made = c.AWDRender(), cls.__new__(cls)
        with Use(shared=(scene, field)):
            check(lib.awdLoadRender(scene._handle, known, None if field is None else field._handle,
                                    None if desc is None else ctypes.byref(desc),
                                    ctypes.byref(handle)))
            made._begin(handle, scene, None)
        return made

    def save(self, path: _check.PathLike) -> None:
        """Writes a checkpoint: film, figures, settings and field, in a file that is there whole or
        not at all. Exclusive for the field too."""
        known = _check.path(path, "path")
        with Use(exclusive=(self, self._field), shared=(self._scene,)):
            check(lib.awdSaveRender(self._handle, known))

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
            quality: Union[Quality, str, None] = None, resume: bool = False, max_passes: int = 0,
            progress: ProgressLike = None) -> None:
        """Several passes, with adapting between them.

        samples: per pixel, divided into passes by the library.
        seconds: wall time, within which the library chooses passes.
        error: until the upper end of error() is not above it, within samples and seconds if set.
        passes: samples per pixel of each pass, instead of all these.
        quality: sets error, and the most samples unless `samples` is given; see quality_schedule().
        None of them: the preset's schedule.
        resume: all passes that the render has had count as the first of these.
        max_passes: that are rendered now, of those that are left; 0: all.

        Passes that were finished before a cancellation stay: resume goes on from there.
        """
        schedule, keep = schedule_of(samples, seconds, error, passes, quality)
        schedule.resume = bool(resume)
        schedule.maxPasses = _check.integer(max_passes, "max_passes")

        def body() -> None:
            check(lib.awdRenderPasses(self._handle, ctypes.byref(schedule)))

        self._long(progress, (self, self._field), (self._scene,), body)
        del keep  # until here the library may read it

    def run_part(self, part: int, parts: int, *, samples: int = 0, error: float = 0.0,
                 passes: Optional[npt.ArrayLike] = None,
                 quality: Union[Quality, str, None] = None, progress: ProgressLike = None) -> int:
        """Renders part `part` of `parts` of the next pass that the schedule has, one part in each
        process, with renders made alike; adapts before it. Returns the samples per pixel of the
        pass, 0: the schedule is through. export_pass() and import_pass() come next, and nothing
        else may use the field until then."""
        schedule, keep = schedule_of(samples, 0.0, error, passes, quality)
        numbers = _check.integer(part, "part"), _check.integer(parts, "parts")
        done = ctypes.c_uint32()

        def body() -> None:
            check(lib.awdRenderPassPart(self._handle, ctypes.byref(schedule), *numbers,
                                        ctypes.byref(done)))

        self._long(progress, (self, self._field), (self._scene,), body)
        del keep  # until here the library may read it
        return done.value

    def export_pass(self) -> Records:
        """The part last rendered. InvalidOperation if none waits to be imported."""
        with Use(exclusive=(self, self._field)):
            handle = self._handle
            return exported(lambda *room: lib.awdExportPass(handle, *room))

    def import_pass(self, sums: npt.ArrayLike, maxima: npt.ArrayLike) -> PassStatistics:
        """Ends the pass with what all processes have exported, combined: each then has the bits of
        one that rendered all. InvalidArgument, and nothing is changed, unless each part is in them
        once."""
        numbers = joined(sums, maxima)
        statistics = described(c.AWDPassStatistics)
        with Use(exclusive=(self, self._field)):
            check(lib.awdImportPass(self._handle, address(numbers), len(numbers),
                                    ctypes.byref(statistics)))
        return figures(PassStatistics, statistics)

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


def settings_of(camera: Camera, *, preset: Union[Preset, str] = Preset.DEFAULT,
                guide: Union[Guide, str] = Guide.ADAPTIVE,
                direct: Union[DirectLight, str] = DirectLight.DEFAULT,
                roulette: Union[Roulette, str] = Roulette.DEFAULT, shadow_rays: int = 0,
                max_lights: int = 0, seed: int = 0,
                combination: Union[Combination, str] = Combination.DEFAULT,
                points: Union[Points, str] = Points.DEFAULT, max_bytes: int = 0,
                max_split: int = 0, lights: Union[LightChoice, str] = LightChoice.DEFAULT) -> Any:
    """The C struct, which keeps that of the camera."""
    _check.instance(camera, Camera, "camera")
    desc = described(c.AWDRenderDesc)
    desc.camera = ctypes.pointer(camera._described())
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
    return desc
