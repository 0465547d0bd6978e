# SPDX-License-Identifier: Apache-2.0
"""Numbers by which processes that render or record parts of a pass make it whole."""
import ctypes
from typing import Any, Callable, NamedTuple

import numpy as np
import numpy.typing as npt

from ._arrays import UINT64, Array, address, packed
from ._library import check


class Records(NamedTuple):
    """What one process has found. Of all processes the sums are to be added, modulo 2^64, and the
    largest of each of the maxima is to be taken. With mpi4py:

        comm.Allreduce(MPI.IN_PLACE, records.sums, MPI.SUM)
        comm.Allreduce(MPI.IN_PLACE, records.maxima, MPI.MAX)
    """

    sums: npt.NDArray[np.uint64]
    maxima: npt.NDArray[np.uint64]


def exported(call: Callable[..., int]) -> Records:
    """Of a call of the form (numbers, capacity, *sums, *maxima)."""
    sums, maxima = ctypes.c_size_t(), ctypes.c_size_t()
    sizes = ctypes.byref(sums), ctypes.byref(maxima)
    check(call(None, 0, *sizes))
    numbers = np.empty(sums.value + maxima.value, UINT64)
    check(call(address(numbers), len(numbers), *sizes))
    return Records(numbers[:sums.value], numbers[sums.value:])


def joined(sums: Any, maxima: Any) -> Array:
    """Both in a row, as C takes them."""
    return np.concatenate([packed(sums, UINT64, (-1,), "sums"),
                           packed(maxima, UINT64, (-1,), "maxima")])
