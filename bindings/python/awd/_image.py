# SPDX-License-Identifier: Apache-2.0
import ctypes
from typing import Any, Callable, Optional

import numpy as np
import numpy.typing as npt

from . import _arrays, _check
from . import _c as c
from ._arrays import FLOAT, address
from ._device import Device
from ._field import Field
from ._library import check, decoded, lib
from ._objects import Object, Use, described


class Image(Object):
    """Named float channels and text metadata, read from and written to OpenEXR, written to PNG.

    An image without channels; width, height: 1 to 65536. Reading may be done in many threads at
    once, set() and set_metadata() are exclusive. Files are written beside their place and renamed
    into it: a FileError leaves no half file, and an older one of the name untouched.
    """

    _kind = "Image"

    def __init__(self, device: Device, width: int, height: int) -> None:
        _check.instance(device, Device, "device")
        size = _check.integer(width, "width"), _check.integer(height, "height")
        self._take(device, lib.awdNewImage, *size)

    @classmethod
    def read(cls, device: Device, path: _check.PathLike) -> "Image":
        """Whatever OpenEXR reads; awd/image.h tells how it becomes channels."""
        _check.instance(device, Device, "device")
        known = _check.path(path, "path")
        made = cls.__new__(cls)
        made._take(device, lib.awdReadImage, known)
        return made

    @classmethod
    def of_patch(cls, field: Field, patch: int, n: int) -> "Image":
        """The density of a patch on the unit square, n x n, in channel Y, with metadata."""
        _check.instance(field, Field, "field")
        numbers = _check.integer(patch, "patch"), _check.integer(n, "n")
        made = cls.__new__(cls)
        made._take(field, lib.awdNewPatchImage, *numbers)
        return made

    def _take(self, parent: Object, function: Callable[..., int], *more: Any,
              exclusive: bool = False) -> None:
        handle = c.AWDImage()
        with Use((parent,), ()) if exclusive else Use((), (parent,)):
            check(function(parent._handle, *more, ctypes.byref(handle)))
            self._own(handle, parent._callbacks)

    def _info(self) -> tuple[int, int, int]:
        width, height, count = ctypes.c_uint32(), ctypes.c_uint32(), ctypes.c_uint32()
        check(lib.awdGetImageInfo(self._handle, ctypes.byref(width), ctypes.byref(height),
                                  ctypes.byref(count)))
        return width.value, height.value, count.value

    @property
    def width(self) -> int:
        with Use(shared=(self,)):
            return self._info()[0]

    @property
    def height(self) -> int:
        with Use(shared=(self,)):
            return self._info()[1]

    @property
    def channels(self) -> tuple[str, ...]:
        """Their names, sorted."""
        names = []
        with Use(shared=(self,)):
            for index in range(self._info()[2]):
                name = ctypes.c_char_p()
                check(lib.awdGetImageChannelName(self._handle, index, ctypes.byref(name)))
                names.append(decoded(name.value))
        return tuple(names)

    def get(self, name: str,
            out: Optional[npt.NDArray[np.float32]] = None) -> npt.NDArray[np.float32]:
        """A channel: (height, width), row 0 on top. `out`, float32, is written in place at any
        strides that go forward, else through a copy. InvalidArgument lists the channels there
        are."""
        known = _check.text(name, "name")
        with Use(shared=(self,)):
            width, height, _ = self._info()
            pixels = _arrays.output(out, FLOAT, (height, width))
            with _arrays.image_output(pixels, FLOAT.itemsize) as (written, pixel, row):
                check(lib.awdGetImageChannel(self._handle, known, address(written), pixel, row))
        return pixels if out is None else out

    def set(self, name: str, pixels: npt.ArrayLike) -> None:
        """Adds or replaces a channel: (height, width) float32, read in place at any strides that go
        forward; others are converted. The name: 1 to 63 printable characters."""
        known = _check.text(name, "name")
        given = _arrays.as_array(pixels, FLOAT, "pixels")
        with Use(exclusive=(self,)):
            width, height, _ = self._info()
            given = _arrays.shaped(given, (height, width), "pixels")
            strides = _arrays.image_strides(given, FLOAT.itemsize)
            if strides is None:
                given, strides = np.ascontiguousarray(given), (0, 0)
            check(lib.awdSetImageChannel(self._handle, known, address(given), *strides))

    def metadata(self, key: str) -> Optional[str]:
        """None if there is none of that key."""
        known = _check.text(key, "key")
        value = ctypes.c_char_p()
        with Use(shared=(self,)):
            check(lib.awdGetImageMetadata(self._handle, known, ctypes.byref(value)))
            return None if value.value is None else decoded(value.value)

    def set_metadata(self, key: str, value: Optional[str]) -> None:
        """Adds or replaces a line; None removes it. The key: 1 to 63 printable characters."""
        known, text = _check.text(key, "key"), _check.optional_text(value, "value")
        with Use(exclusive=(self,)):
            check(lib.awdSetImageMetadata(self._handle, known, text))

    def write_exr(self, path: _check.PathLike) -> None:
        """Scanlines, float32, ZIP; metadata as attributes."""
        known = _check.path(path, "path")
        with Use(shared=(self,)):
            check(lib.awdWriteImageEXR(self._handle, known))

    def write_png(self, path: _check.PathLike, exposure: float = 0.0) -> None:
        """R, G and B in sRGB, clipped, times 2^exposure; without these the first channel in false
        colours."""
        known = _check.path(path, "path")
        desc = described(c.AWDPNGDesc)
        desc.exposure = _check.number32(exposure, "exposure")
        with Use(shared=(self,)):
            check(lib.awdWriteImagePNG(self._handle, known, ctypes.byref(desc)))
