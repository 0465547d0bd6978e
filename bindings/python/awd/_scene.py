# SPDX-License-Identifier: Apache-2.0
import ctypes
from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from . import _arrays, _check
from . import _c as c
from ._arrays import FLOAT, UINT, address
from ._callbacks import ProgressLike
from ._device import Device
from ._figures import SceneInfo, figures
from ._library import check, lib
from ._objects import Object, Use, described

RAY = _arrays.items_of(c.AWDRay)
"""A ray: origin (3), tnear, not below 0, direction (3), of any length, tfar, may be infinite."""
HIT = _arrays.items_of(c.AWDHit)
"""What a ray meets first: t (infinite: nothing), normal (3; geometric, unit, front side), u, v,
mesh (INVALID_ID: nothing), triangle, material, patch (with PATCH_BACK if met on the back)."""


def rays(origins: npt.ArrayLike, directions: npt.ArrayLike, tnear: npt.ArrayLike = 0.0,
         tfar: npt.ArrayLike = np.inf) -> npt.NDArray[np.void]:
    """Rays o + t d, tnear <= t <= tfar, as an array of RAY. origins, directions: (n, 3); tnear,
    tfar: (n,). One of a kind serves all."""
    o = _arrays.together(FLOAT, origins, 3, "origins")
    d = _arrays.together(FLOAT, directions, 3, "directions")
    near = _arrays.together(FLOAT, tnear, 0, "tnear")
    far = _arrays.together(FLOAT, tfar, 0, "tfar")
    count = _arrays.count_of((o, "origins"), (d, "directions"), (near, "tnear"), (far, "tfar"))
    made = np.empty(count, RAY)
    made["origin"], made["direction"], made["tnear"], made["tfar"] = o, d, near, far
    return made


class Scene(Object):
    """Triangle meshes of diffuse materials, which may emit on one side.

    Upload, then commit(); queries and renders want a committed scene. add_material(), add_mesh()
    and commit() are exclusive; queries of a committed scene may run at once in many threads.
    """

    _kind = "Scene"

    def __init__(self, device: Device) -> None:
        _check.instance(device, Device, "device")
        handle = c.AWDScene()
        with Use(shared=(device,)):
            check(lib.awdNewScene(device._handle, ctypes.byref(handle)))
            self._own(handle, device._callbacks)
        self._shared: list[Any] = []  # arrays that commit reads

    def add_material(self, albedo: Any, emission: Any = 0.0) -> int:
        """A diffuse material, f_r = albedo / pi on both sides; its number counts from 0.

        albedo: RGB or grey, 0 to 1. emission: radiance that leaves the front side, RGB or grey,
        finite, >= 0.
        """
        desc = described(c.AWDMaterialDesc)
        desc.albedo = _check.colour(albedo, "albedo")
        desc.emission = _check.colour(emission, "emission")
        number = ctypes.c_uint32()
        with Use(exclusive=(self,)):
            check(lib.awdAddMaterial(self._handle, ctypes.byref(desc), ctypes.byref(number)))
        return number.value

    def add_mesh(self, vertices: npt.ArrayLike, indices: npt.ArrayLike,
                 materials: npt.ArrayLike = 0, patches: Optional[npt.ArrayLike] = None, *,
                 shared: bool = False) -> int:
        """A mesh; its number counts from 0. commit() checks what is in it.

        vertices: (n, 3) float32; finite, below 1e18 in magnitude.
        indices: (m, 3) uint32; counter-clockwise seen from the front.
        materials: one number for all triangles, or (m,) uint32.
        patches: (m,) uint32 below 2^31 - 1; None: a patch per planar piece.
        shared: don't copy now: commit() reads the arrays, which this object keeps until then, and
          which must not be changed or resized meanwhile.

        Arrays of these types are read where they are, at any stride between items; others, also
        those that run backwards, are converted, which copies them.
        """
        desc = described(c.AWDMeshDesc)
        keep = [put(desc.vertices, vertices, FLOAT, 3, c.AWD_FORMAT_FLOAT3, "vertices"),
                put(desc.indices, indices, UINT, 3, c.AWD_FORMAT_UINT3, "indices")]
        if np.ndim(materials) == 0:
            desc.material = _check.integer(_scalar(materials), "materials")
        else:
            keep.append(put(desc.materials, materials, UINT, 1, c.AWD_FORMAT_UINT, "materials"))
        if patches is not None:
            keep.append(put(desc.patches, patches, UINT, 1, c.AWD_FORMAT_UINT, "patches"))
        desc.flags = c.AWD_MESH_SHARED if shared else 0
        number = ctypes.c_uint32()
        with Use(exclusive=(self,)):
            check(lib.awdAddMesh(self._handle, ctypes.byref(desc), ctypes.byref(number)))
            if shared:
                self._shared += keep
        return number.value

    def commit(self, *, progress: ProgressLike = None) -> None:
        """Checks everything, finds planar pieces and lights, and builds the ray tracing structure.
        A bad vertex, index, material or patch is an InvalidArgument that names it."""

        def body() -> None:
            check(lib.awdCommitScene(self._handle))
            self._shared = []

        self._long(progress, (self,), (), body)

    def info(self) -> SceneInfo:
        """Figures of the committed scene."""
        info = described(c.AWDSceneInfo)
        with Use(shared=(self,)):
            check(lib.awdGetSceneInfo(self._handle, ctypes.byref(info)))
        return figures(SceneInfo, info)

    def intersect(self, rays: npt.NDArray[np.void],
                  out: Optional[npt.NDArray[np.void]] = None) -> npt.NDArray[np.void]:
        """First hits of an array of RAY (n,): an array of HIT (n,)."""
        known = _arrays.packed(rays, RAY, (-1,), "rays")
        hits = _arrays.output(out, HIT, known.shape)
        with _arrays.packed_output(hits) as written, Use(shared=(self,)):
            check(lib.awdIntersect(self._handle, address(known), len(known), address(written)))
        return hits if out is None else out

    def occluded(self, rays: npt.NDArray[np.void]) -> npt.NDArray[np.bool_]:
        """Whether anything lies on each of an array of RAY (n,): bool (n,)."""
        known = _arrays.packed(rays, RAY, (-1,), "rays")
        hidden = np.empty(len(known), np.uint8)
        with Use(shared=(self,)):
            check(lib.awdOccluded(self._handle, address(known), len(known), address(hidden)))
        return hidden.view(np.bool_)

    def triangle_patch(self, mesh: int, triangle: int, back: bool = False) -> Optional[int]:
        """The patch of a triangle's front or back side; None for one without area."""
        patch = ctypes.c_uint32()
        numbers = _check.integer(mesh, "mesh"), _check.integer(triangle, "triangle")
        side = 1 if back else 0
        with Use(shared=(self,)):
            check(lib.awdGetTrianglePatch(self._handle, *numbers, side, ctypes.byref(patch)))
        return None if patch.value == c.AWD_INVALID_ID else patch.value

    def point_patch(self, point: _check.Vector) -> Optional[int]:
        """The patch of the triangle nearest to a point, on the side where the point is; None in an
        empty scene."""
        patch = ctypes.c_uint32()
        known = (ctypes.c_float * 3)(*_check.vector(point, "point"))
        with Use(shared=(self,)):
            check(lib.awdGetPointPatch(self._handle, known, ctypes.byref(patch)))
        return None if patch.value == c.AWD_INVALID_ID else patch.value


def put(buffer: Any, value: Any, dtype: "np.dtype[Any]", width: int, format_: int,
        name: str) -> _arrays.Array:
    """Fills an AWDBuffer from an array, and returns what must be kept."""
    array, stride = _arrays.rows(value, dtype, width, name)
    buffer.data = address(array)
    buffer.byteStride = stride
    buffer.count = array.shape[0]
    buffer.format = format_
    return array


def _scalar(value: Any) -> Any:
    return value.item() if isinstance(value, (np.ndarray, np.generic)) else value
