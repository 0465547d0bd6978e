# SPDX-License-Identifier: Apache-2.0
import ctypes
from typing import Any, Union

from . import _arrays, _check
from . import _c as c
from ._arrays import UINT, address
from ._enums import Quality
from ._figures import QualitySchedule, figures
from ._library import check, lib
from ._objects import described


def quality_schedule(quality: Union[Quality, str]) -> QualitySchedule:
    """What a quality promises. Whether it was kept: render.error().upper <= error, or
    render.samples_per_pixel is total_samples."""
    known = _check.enumerated(quality, Quality, "quality")
    schedule = described(c.AWDSchedule)
    check(lib.awdGetQualitySchedule(known, ctypes.byref(schedule)))
    return figures(QualitySchedule, schedule)


def schedule_of(samples: Any, seconds: Any, error: Any, passes: Any,
                quality: Any) -> tuple[Any, Any]:
    """The C struct, and what must be kept as long as C reads it."""
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
    return schedule, keep
