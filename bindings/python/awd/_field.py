# SPDX-License-Identifier: Apache-2.0
import ctypes
from typing import Any, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _arrays, _check
from . import _c as c
from ._arrays import DOUBLE, FLOAT, UINT, address
from ._callbacks import ProgressLike
from ._device import Device
from ._enums import Estimator, HemisphereMap, Patches, Preset, Target
from ._exchange import Records, exported, joined
from ._figures import FieldStatistics, PatchInfo, Triple, figures, optional
from ._library import check, lib
from ._objects import Object, Use, bytes_of, described
from ._scene import Scene

DIRECTION_SAMPLE = _arrays.items_of(c.AWDDirectionSample)
"""A direction drawn from a patch: direction (3; unit), pdf (1/sr), square (2), component,
solidAngle (sr)."""
PATH_VERTEX = _arrays.items_of(c.AWDPathVertex)
"""Where a path met a surface: patch (INVALID_ID: nothing is recorded), continuation (chance to go
on, 0: ended), sample (a DIRECTION_SAMPLE), emitted, direct and scattering (3 each)."""


class LightSample(NamedTuple):
    light: int
    chance: float
    rest: float
    """what is left of the uniform, uniform in [0,1) again"""


class Field(Object):
    """One adaptive density per patch of surface, over the hemisphere above it.

    parent: a device, or a committed scene, whose box and lights are then the defaults.
    map, basis, estimator, target, patches: None or DEFAULT is what the preset has.
    start_level, max_level: None is the preset's.
    tau: floor of coefficients, 0 < tau <= 1; 0: the preset's; negative: none.
    alpha: share of the map's constant density; 0: the default; negative: none; at most 1.
    lower, upper: the box of positions, in scene units.
    light_powers: a power >= 0 for each light to choose among, at most MOST_LIGHTS of them; or
      light_count, for equal powers.
    awd/field.h tells the rest. Unsupported: there is no such basis, refit module or solver.

    Queries and records may come from many threads at once, but not while the field adapts.
    In arrays one patch, normal, direction or position serves all items; what a method returns has
    an entry for each item. Inputs are float32 (uint32 for patches, float64 for uniforms and
    values); others are converted, which copies them.
    """

    _kind = "Field"

    def __init__(self, parent: Union[Device, Scene], *,
                 preset: Union[Preset, str] = Preset.DEFAULT,
                 map: Union[HemisphereMap, str] = HemisphereMap.DEFAULT,
                 basis: Optional[str] = None, start_level: Optional[int] = None,
                 max_level: Optional[int] = None, tau: float = 0.0,
                 estimator: Union[Estimator, str] = Estimator.DEFAULT,
                 refit_solver: Optional[str] = None, shrinkage: float = 0.0,
                 patches: Union[Patches, str] = Patches.DEFAULT,
                 lower: _check.Vector = (0.0, 0.0, 0.0), upper: _check.Vector = (0.0, 0.0, 0.0),
                 patch_samples: int = 0, alpha: float = 0.0, max_bytes: int = 0,
                 light_count: int = 0, light_powers: Optional[npt.ArrayLike] = None,
                 target: Union[Target, str] = Target.DEFAULT) -> None:
        if not isinstance(parent, (Device, Scene)):
            raise TypeError(f"parent is {_check.shown(parent)}: it must be a Device or a Scene")
        desc = described(c.AWDFieldDesc)
        desc.preset = _check.enumerated(preset, Preset, "preset")
        desc.map = _check.enumerated(map, HemisphereMap, "map")
        desc.basis = _check.optional_text(basis, "basis")
        desc.startLevel = _check.level(start_level, "start_level")
        desc.maxLevel = _check.level(max_level, "max_level")
        desc.tau = _check.number(tau, "tau")
        desc.estimator = _check.enumerated(estimator, Estimator, "estimator")
        desc.refitSolver = _check.optional_text(refit_solver, "refit_solver")
        desc.shrinkage = _check.number(shrinkage, "shrinkage")
        desc.patches = _check.enumerated(patches, Patches, "patches")
        desc.lower = _check.vector(lower, "lower")
        desc.upper = _check.vector(upper, "upper")
        desc.patchSamples = _check.integer(patch_samples, "patch_samples")
        desc.alpha = _check.number(alpha, "alpha")
        desc.maxBytes = _check.integer(max_bytes, "max_bytes", _check.UINT64)
        desc.lightCount = _check.integer(light_count, "light_count")
        desc.target = _check.enumerated(target, Target, "target")
        if light_powers is not None:
            powers = _arrays.packed(light_powers, FLOAT, (-1,), "light_powers")
            if desc.lightCount not in (0, len(powers)):
                raise ValueError(f"light_powers has {len(powers)} items, but light_count is "
                                 f"{desc.lightCount}")
            desc.lightCount = _check.integer(len(powers), "the length of light_powers")
            desc.lightPowers = ctypes.cast(address(powers), ctypes.POINTER(ctypes.c_float))
        handle = c.AWDField()
        make = lib.awdNewField if isinstance(parent, Device) else lib.awdNewSceneField
        with Use(shared=(parent,)):
            check(make(parent._handle, ctypes.byref(desc), ctypes.byref(handle)))
            self._own(handle, parent._callbacks)

    @classmethod
    def load(cls, device: Device, data: Any) -> "Field":
        """From the bytes of save(). Damaged ones are a FileError."""
        _check.instance(device, Device, "device")
        known = buffer_of(data)
        handle = c.AWDField()
        with Use(shared=(device,)):
            check(lib.awdLoadField(device._handle, address(known), known.nbytes,
                                   ctypes.byref(handle)))
            return cls._make(handle, device)

    @classmethod
    def read(cls, device: Device, path: _check.PathLike) -> "Field":
        """From the file of write(). A FileError tells why not."""
        _check.instance(device, Device, "device")
        known = _check.path(path, "path")
        handle = c.AWDField()
        with Use(shared=(device,)):
            check(lib.awdReadField(device._handle, known, ctypes.byref(handle)))
            return cls._make(handle, device)

    def save(self) -> bytes:
        """All that the field is and has recorded. Exclusive."""
        with Use(exclusive=(self,)):
            handle = self._handle
            return bytes_of(lambda *room: lib.awdSaveField(handle, *room))

    def write(self, path: _check.PathLike) -> None:
        """The same in a file, which is there whole or not at all. Exclusive."""
        known = _check.path(path, "path")
        with Use(exclusive=(self,)):
            check(lib.awdWriteField(self._handle, known))

    def merge(self, other: "Field") -> None:
        """Adds what `other` has recorded since its last adapt; it stays as it is. Both must be the
        same in settings, patches and densities. Exclusive for both."""
        _check.instance(other, Field, "other")
        with Use(exclusive=(self, other)):
            check(lib.awdMergeField(self._handle, other._handle))

    def export_records(self, patches: Optional[npt.ArrayLike] = None) -> Records:
        """What was recorded since the last adapt, or since mark() after it, for processes that
        record parts of a pass. patches: of a field with patches of the host's own, ascending, all
        in which any process may have recorded; None with spatial ones. Exclusive."""
        known = None if patches is None else _arrays.packed(patches, UINT, (-1,), "patches")
        with Use(exclusive=(self,)):
            handle, given = self._handle, listed(known)
            return exported(lambda *room: lib.awdExportField(handle, *given, *room))

    def import_records(self, sums: npt.ArrayLike, maxima: npt.ArrayLike,
                       patches: Optional[npt.ArrayLike] = None) -> None:
        """Puts what all processes have exported, combined, in place of what this one has recorded;
        adapt() then has the bits of one process that has recorded everything. Exclusive."""
        known = None if patches is None else _arrays.packed(patches, UINT, (-1,), "patches")
        numbers = joined(sums, maxima)
        with Use(exclusive=(self,)):
            check(lib.awdImportField(self._handle, *listed(known), address(numbers), len(numbers)))

    # --- directions ---

    def find_patches(self, positions: npt.ArrayLike, normals: npt.ArrayLike,
                     out: Optional[npt.NDArray[np.uint32]] = None) -> npt.NDArray[np.uint32]:
        """The spatial patches at positions (n, 3) with unit normals (n, 3): uint32 (n,), good until
        the next adapt. Their three lowest bits tell in which eighth of the patch the point is."""
        p, q = (_arrays.together(FLOAT, positions, 3, "positions"),
                _arrays.together(FLOAT, normals, 3, "normals"))
        count = _arrays.count_of((p, "positions"), (q, "normals"))
        p, q = _arrays.spread(p, count), _arrays.spread(q, count)
        found = _arrays.output(out, UINT, (count,))
        with _arrays.packed_output(found) as written, Use(shared=(self,)):
            check(lib.awdFindPatches(self._handle, count, address(p), address(q),
                                     address(written)))
        return found if out is None else out

    def sample(self, patches: npt.ArrayLike, normals: npt.ArrayLike, uniforms: npt.ArrayLike,
               out: Optional[npt.NDArray[np.void]] = None) -> npt.NDArray[np.void]:
        """Directions drawn from patches (n,) about unit normals (n, 3) by uniforms (n, 3) in [0,1):
        an array of DIRECTION_SAMPLE (n,)."""
        a, b, u = (_arrays.together(UINT, patches, 0, "patches"),
                   _arrays.together(FLOAT, normals, 3, "normals"),
                   _arrays.together(DOUBLE, uniforms, 3, "uniforms"))
        count = _arrays.count_of((a, "patches"), (b, "normals"), (u, "uniforms"))
        a, b, u = (_arrays.spread(array, count) for array in (a, b, u))
        drawn = _arrays.output(out, DIRECTION_SAMPLE, (count,))
        with _arrays.packed_output(drawn) as written, Use(shared=(self,)):
            check(lib.awdSampleFieldBatch(self._handle, count, address(a), address(b), address(u),
                                          address(written)))
        return drawn if out is None else out

    def pdf(self, patches: npt.ArrayLike, normals: npt.ArrayLike, directions: npt.ArrayLike,
            out: Optional[npt.NDArray[np.float32]] = None) -> npt.NDArray[np.float32]:
        """The pdfs in solid angle, 1/sr, of unit directions (n, 3): float32 (n,); 0 below the
        horizon."""
        a, b, d = (_arrays.together(UINT, patches, 0, "patches"),
                   _arrays.together(FLOAT, normals, 3, "normals"),
                   _arrays.together(FLOAT, directions, 3, "directions"))
        count = _arrays.count_of((a, "patches"), (b, "normals"), (d, "directions"))
        a, b, d = (_arrays.spread(array, count) for array in (a, b, d))
        pdfs = _arrays.output(out, FLOAT, (count,))
        with _arrays.packed_output(pdfs) as written, Use(shared=(self,)):
            check(lib.awdGetFieldPdfs(self._handle, count, address(a), address(b), address(d),
                                      address(written)))
        return pdfs if out is None else out

    def map_direction(self, patch: int, normal: _check.Vector,
                      direction: _check.Vector) -> npt.NDArray[np.void]:
        """A unit direction that the host drew itself, as a sample that can be recorded: an array of
        DIRECTION_SAMPLE (1,). Set its pdf if it was drawn by a mixture."""
        number = _check.integer(patch, "patch")
        n = (ctypes.c_float * 3)(*_check.vector(normal, "normal"))
        d = (ctypes.c_float * 3)(*_check.vector(direction, "direction"))
        sample = np.empty(1, DIRECTION_SAMPLE)
        with Use(shared=(self,)):
            check(lib.awdMapDirection(self._handle, number, n, d, address(sample)))
        return sample

    def record(self, patches: npt.ArrayLike, samples: npt.NDArray[np.void],
               values: npt.ArrayLike) -> None:
        """What came from directions: values (n,), luminances of f_r L_i cos(theta), not divided by
        the pdf; 0 where nothing came. samples: an array of DIRECTION_SAMPLE (n,). A value that is
        NaN, infinite or negative counts as a rejected sample of value 0."""
        s = _arrays.packed(samples, DIRECTION_SAMPLE, (-1,), "samples")
        a = _arrays.together(UINT, patches, 0, "patches", len(s))
        v = _arrays.together(DOUBLE, values, 0, "values", len(s))
        with Use(shared=(self,)):
            check(lib.awdRecordFieldBatch(self._handle, len(s), address(a), address(s),
                                          address(v)))

    def record_path(self, vertices: npt.NDArray[np.void],
                    background: Optional[_check.Vector] = None) -> Triple:
        """Records a path, an array of PATH_VERTEX (n,) from the camera on; returns its estimate of
        the radiance that the camera sees. background: what comes from outside the scene."""
        known = _arrays.packed(vertices, PATH_VERTEX, (-1,), "vertices")
        beyond = None
        if background is not None:
            beyond = (ctypes.c_float * 3)(*_check.vector(background, "background"))
        radiance = (ctypes.c_float * 3)()
        with Use(shared=(self,)):
            check(lib.awdRecordFieldPath(self._handle, len(known), address(known), beyond,
                                         radiance))
        return radiance[0], radiance[1], radiance[2]

    # --- learning ---

    def set_scale(self, magnitude: float) -> None:
        """The magnitude of values to be expected at first, such as the luminance of the brightest
        light. Exclusive."""
        known = _check.number(magnitude, "magnitude")
        with Use(exclusive=(self,)):
            check(lib.awdSetFieldScale(self._handle, known))

    def adapt(self, *, progress: ProgressLike = None) -> FieldStatistics:
        """Ends a pass: what was recorded becomes the next densities. Cancelled, it leaves the field
        as it was. Exclusive."""
        statistics = described(c.AWDFieldStatistics)
        self._long(progress, (self,), (),
                   lambda: check(lib.awdAdaptField(self._handle, ctypes.byref(statistics))))
        return figures(FieldStatistics, statistics)

    def mark(self) -> None:
        """Remembers what has been recorded so far, for revert(). Exclusive."""
        with Use(exclusive=(self,)):
            check(lib.awdMarkField(self._handle))

    def revert(self) -> None:
        """Forgets all that was recorded since the last mark(). Exclusive."""
        with Use(exclusive=(self,)):
            check(lib.awdRevertField(self._handle))

    def statistics(self) -> FieldStatistics:
        """Exclusive."""
        statistics = described(c.AWDFieldStatistics)
        with Use(exclusive=(self,)):
            check(lib.awdGetFieldStatistics(self._handle, ctypes.byref(statistics)))
        return figures(FieldStatistics, statistics)

    # --- a look at patches ---

    def patches(self) -> npt.NDArray[np.uint32]:
        """The numbers of those that have had samples, ascending, front sides first."""
        count = ctypes.c_size_t()
        found: npt.NDArray[np.uint32] = np.empty(0, np.uint32)
        with Use(shared=(self,)):
            handle = self._handle
            check(lib.awdGetFieldPatches(handle, None, 0, ctypes.byref(count)))
            while count.value > len(found):  # others may record meanwhile
                found = np.empty(count.value, np.uint32)
                check(lib.awdGetFieldPatches(handle, address(found), len(found),
                                             ctypes.byref(count)))
        return found

    def patch_info(self, patch: int) -> PatchInfo:
        number = _check.integer(patch, "patch")
        info = described(c.AWDPatchInfo)
        with Use(shared=(self,)):
            check(lib.awdGetPatchInfo(self._handle, number, ctypes.byref(info)))
        return figures(PatchInfo, info)

    def patch_coefficients(self, patch: int) -> npt.NDArray[np.float64]:
        """c of p(u, v) = sum_jk c[j, k] N_j(u) N_k(v) on the unit square: float64."""
        number = _check.integer(patch, "patch")
        info = described(c.AWDPatchInfo)
        with Use(shared=(self,)):
            check(lib.awdGetPatchInfo(self._handle, number, ctypes.byref(info)))
            coefficients = np.empty((info.axisCount, info.axisCount))
            check(lib.awdGetPatchCoefficients(self._handle, number, address(coefficients),
                                              coefficients.size))
        return coefficients

    def patch_mean(self, patch: int) -> Optional[float]:
        """The integral of f over the hemisphere as all passes have found it: the indirect radiance
        that the patch reflects, if that is recorded. None where nothing is known."""
        return optional(self._patch_number(lib.awdGetPatchMean, patch))

    def patch_light(self, patch: int) -> float:
        """sum_l sqrt(E[x_l^2]) over the lights, as found; 0 where nothing has been."""
        return self._patch_number(lib.awdGetPatchLight, patch)

    def continuation(self, patch: int, throughput: float, expected: float,
                     max_split: int = 0) -> Optional[float]:
        """With how many rays on average a path should go on. throughput: luminance of the path's
        weight before the vertex; expected: that of the pixel's radiance; max_split: 1 to 64, 0: 8.
        None where nothing is known."""
        return optional(self._patch_number(
            lib.awdGetContinuation, patch, _check.number32(throughput, "throughput"),
            _check.number32(expected, "expected"), _check.integer(max_split, "max_split")))

    def patch_pdf(self, patch: int, n: int,
                  out: Optional[npt.NDArray[np.float32]] = None) -> npt.NDArray[np.float32]:
        """The density on the unit square as an image (n, n), float32: row i, column k holds
        p((k + 1/2)/n, (i + 1/2)/n). 1 <= n <= 16384. Rows of `out` may be any distance apart."""
        number, n = _check.integer(patch, "patch"), _check.integer(n, "n", 16384, 1)
        image = _arrays.output(out, FLOAT, (n, n))
        strides = _arrays.image_strides(image, FLOAT.itemsize)
        direct = strides is not None and strides[0] == FLOAT.itemsize
        written = image if direct else np.empty((n, n), np.float32)
        stride = strides[1] if direct and strides is not None else 0
        with Use(shared=(self,)):
            check(lib.awdGetPatchPdf(self._handle, number, n, address(written), stride))
        if not direct:
            np.copyto(image, written)
        return image if out is None else out

    # --- lights ---

    def choose_light(self, patch: int, uniform: float) -> LightSample:
        """Chooses a light by a uniform in [0,1)."""
        number, known = _check.integer(patch, "patch"), _check.number(uniform, "uniform")
        light, chance, rest = ctypes.c_uint32(), ctypes.c_float(), ctypes.c_double()
        with Use(shared=(self,)):
            check(lib.awdChooseLight(self._handle, number, known, ctypes.byref(light),
                                     ctypes.byref(chance), ctypes.byref(rest)))
        return LightSample(light.value, chance.value, rest.value)

    def light_chance(self, patch: int, light: int) -> float:
        """The chance of a light to be chosen."""
        return self._patch_number(lib.awdGetLightChance, patch, _check.integer(light, "light"))

    def record_light(self, patch: int, light: int, value: float) -> None:
        """What a shadow ray to a light brought, not divided by the chance of the light; 0 where it
        was hidden."""
        numbers = _check.integer(patch, "patch"), _check.integer(light, "light")
        known = _check.number(value, "value")
        with Use(shared=(self,)):
            check(lib.awdRecordLight(self._handle, *numbers, known))

    def _patch_number(self, function: Any, patch: Any, *more: Any) -> float:
        number, result = _check.integer(patch, "patch"), ctypes.c_float()
        with Use(shared=(self,)):
            check(function(self._handle, number, *more, ctypes.byref(result)))
        return result.value


def listed(patches: Optional[_arrays.Array]) -> tuple[Optional[int], int]:
    return (None, 0) if patches is None else (address(patches), len(patches))


def buffer_of(data: Any) -> _arrays.Array:
    """bytes, or anything else whose bytes lie in a row, without a copy."""
    try:
        return np.frombuffer(memoryview(data).cast("B"), np.uint8)
    except (TypeError, ValueError, BufferError) as error:
        raise TypeError(f"data is {_check.shown(data)}: it must be bytes ({error})") from None
