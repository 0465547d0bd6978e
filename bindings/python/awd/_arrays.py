# SPDX-License-Identifier: Apache-2.0
"""Arrays on their way to C and back.

What C can read or write in place is handed over as it is; the rest goes through a copy. An array
of another kind or shape is a TypeError or ValueError.
"""
from contextlib import contextmanager
from typing import Any, Iterator, Optional

import numpy as np
import numpy.typing as npt

from ._check import SIZE, shown

Array = npt.NDArray[Any]

FLOAT = np.dtype(np.float32)
DOUBLE = np.dtype(np.float64)
UINT = np.dtype(np.uint32)
UINT64 = np.dtype(np.uint64)


def items_of(kind: Any) -> "np.dtype[np.void]":
    """The dtype of arrays of a C struct."""
    return np.dtype(kind)


def address(array: Array) -> int:
    """Of the first item. The array must be kept as long as C uses it."""
    known: int = array.__array_interface__["data"][0]
    return known


def as_array(value: Any, dtype: "np.dtype[Any]", name: str) -> Array:
    """`value` as an array of this dtype: itself, or a copy of other numbers. Numbers are never
    made of strings, objects, booleans or complex numbers, integers never of floats."""
    try:
        array = np.asarray(value)
    except MemoryError:
        raise
    except Exception as error:
        raise TypeError(f"{name} is no array: {error}") from None
    if array.dtype == dtype:
        return array
    if dtype.names is not None:
        raise TypeError(f"{name} has dtype {array.dtype}: it must be {dtype.names}, as of "
                        "awd.empty()")
    if array.size == 0 and array.dtype == DOUBLE:  # of an empty list
        return array.astype(dtype)
    if array.dtype.kind not in ("iu" if dtype.kind == "u" else "iuf"):
        raise TypeError(f"{name} has dtype {array.dtype}: it must be {dtype}, or convertible "
                        "without loss of kind")
    # First, so that a view of more items than there is memory is not looked through for ages.
    with np.errstate(over="ignore"):  # infinity, which the library judges
        made = array.astype(dtype)
    if dtype.kind == "u" and array.size > 0 and not np.can_cast(array.dtype, dtype):
        low, high, most = int(array.min()), int(array.max()), int(np.iinfo(dtype).max)
        if low < 0 or high > most:
            raise ValueError(f"{name} has {low if low < 0 else high}: it must be from 0 to {most}")
    return made


def shaped(array: Array, shape: tuple[int, ...], name: str) -> Array:
    """Checks the shape, in which -1 is any number."""
    if array.shape == (0,) and len(shape) > 1:
        array = array.reshape([0] + [1 if n < 0 else n for n in shape[1:]])
    fits = array.ndim == len(shape) and all(n in (-1, m) for n, m in zip(shape, array.shape))
    if not fits:
        wanted = ", ".join("n" if n < 0 else str(n) for n in shape)
        raise ValueError(f"{name} has shape {array.shape}: it must be "
                         f"({wanted}{',' if len(shape) == 1 else ''})")
    return array


def packed(value: Any, dtype: "np.dtype[Any]", shape: tuple[int, ...], name: str) -> Array:
    """An input that C wants packed; one that is packed already is not copied."""
    array = shaped(as_array(value, dtype, name), shape, name)
    return np.require(array, dtype, ["C_CONTIGUOUS", "ALIGNED"])


def together(dtype: "np.dtype[Any]", value: Any, width: int, name: str,
             count: Optional[int] = None) -> Array:
    """Items of `width` numbers (0: plain ones). One alone serves all; `count` None: as it is."""
    array = as_array(value, dtype, name)
    one = () if width == 0 else (width,)
    if array.shape == one:
        array = np.broadcast_to(array, (1 if count is None else count, *one))
    elif count is not None and array.shape[:1] == (1,) and array.ndim == 1 + len(one):
        array = np.broadcast_to(shaped(array, (1, *one), name), (count, *one))
    array = shaped(array, (-1 if count is None else count, *one), name)
    return np.require(array, dtype, ["C_CONTIGUOUS", "ALIGNED"])


def count_of(*values: "tuple[Array, str]") -> int:
    """How many items arrays of together() are for: their lengths, of which 1 serves all."""
    count, first = 1, ""
    for array, name in values:
        n = array.shape[0]
        if n == 1:
            continue
        if first and n != count:
            raise ValueError(f"{name} has {n} items, but {first} {count}")
        count, first = n, name
    return count


def spread(array: Array, count: int) -> Array:
    """A packed array of together() for `count` items."""
    if array.shape[0] == count:
        return array
    return np.ascontiguousarray(np.broadcast_to(array, (count, *array.shape[1:])))


def rows(value: Any, dtype: "np.dtype[Any]", width: int, name: str) -> tuple[Array, int]:
    """An input (n, width), or (n,) if width is 1, and its stride in bytes. Any array whose rows
    are packed and go forward without overlap is not copied."""
    shape = (-1, width) if width > 1 else (-1,)
    array = shaped(as_array(value, dtype, name), shape, name)
    size = width * dtype.itemsize
    if width > 1 and array.strides[1] != dtype.itemsize:
        array = np.ascontiguousarray(array)
    if array.shape[0] < 2:
        return array, 0
    if array.strides[0] < size:
        array = np.ascontiguousarray(array)
    return array, array.strides[0]


def output(out: Any, dtype: "np.dtype[Any]", shape: tuple[int, ...], name: str = "out") -> Array:
    """A new array, or `out`, which must be of this dtype and shape and writeable."""
    if out is None:
        if np.prod([float(n) for n in shape]) * dtype.itemsize > SIZE:
            raise MemoryError(f"an array of shape {shape}")
        return np.empty(shape, dtype)
    if not isinstance(out, np.ndarray):
        raise TypeError(f"{name} is {shown(out)}: it must be a numpy array")
    array = np.asarray(out)
    if array.dtype != dtype:
        raise TypeError(f"{name} has dtype {array.dtype}: it must be {dtype} in native byte order")
    if array.shape != shape:
        raise ValueError(f"{name} has shape {array.shape}: it must be {shape}")
    if not array.flags.writeable:
        raise ValueError(f"{name} is read-only")
    return array


@contextmanager
def packed_output(array: Array) -> Iterator[Array]:
    """Where C, which wants it packed, writes: `array` itself if it is, else a copy."""
    if array.flags.carray:
        yield array
        return
    written = np.empty(array.shape, array.dtype)
    yield written
    np.copyto(array, written)


@contextmanager
def image_output(array: Array, pixel: int) -> Iterator[tuple[Array, int, int]]:
    """Where C writes an image (h, w) or (h, w, 3) of pixels of so many bytes, and the strides in
    bytes of a pixel and a row: `array` itself if its strides are such that pixels are packed and go
    forward without overlap, else a copy."""
    strides = image_strides(array, pixel)
    if strides is not None:
        yield (array, *strides)
        return
    written = np.empty(array.shape, array.dtype)
    yield written, 0, 0
    np.copyto(array, written)


def image_strides(array: Array, pixel: int) -> Optional[tuple[int, int]]:
    """Strides of a pixel and a row as C takes them; None: it can't."""
    height, width = array.shape[:2]
    if array.ndim == 3 and array.strides[2] != array.itemsize:
        return None
    step = array.strides[1] if width > 1 else pixel
    end = (width - 1) * step + pixel
    row = array.strides[0] if height > 1 else end
    if step < pixel or row < end:
        return None
    return step, row
