# SPDX-License-Identifier: Apache-2.0
"""Single values on their way to C: a TypeError or ValueError that names the argument, or a value
that fits the C type. ctypes itself would wrap integers, cut strings at a zero byte and make 1e39
infinite."""
import math
import operator
import os
from enum import IntEnum
from typing import Any, Optional, Sequence, Type, TypeVar, Union

PathLike = Union[str, bytes, "os.PathLike[str]", "os.PathLike[bytes]"]
Vector = Sequence[float]

UINT32 = 2**32 - 1
UINT64 = 2**64 - 1
SIZE = 2**63 - 1
LARGEST_FLOAT32 = float.fromhex("0x1.fffffep+127")

E = TypeVar("E", bound=IntEnum)


def integer(value: Any, name: str, most: int = UINT32, least: int = 0) -> int:
    try:
        known = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} is {shown(value)}: it must be an integer") from None
    if not least <= known <= most:
        raise ValueError(f"{name} is {shown(known)}: it must be from {least} to {most}")
    return known


def level(value: Optional[int], name: str) -> int:
    """A level as AWD_LEVEL() has it; None is the default."""
    return 0 if value is None else integer(value, name, most=UINT32 - 1) + 1


def number(value: Any, name: str) -> float:
    """A double; NaN and infinity are for the library to judge."""
    if isinstance(value, (str, bytes, bytearray)):
        raise TypeError(f"{name} is {shown(value)}: it must be a number")
    try:
        return float(value)
    except OverflowError:
        raise ValueError(f"{name} is too large") from None
    except TypeError:
        raise TypeError(f"{name} is {shown(value)}: it must be a number") from None


def number32(value: Any, name: str) -> float:
    """A double that a C float can hold."""
    known = number(value, name)
    if math.isfinite(known) and abs(known) > LARGEST_FLOAT32:
        raise ValueError(f"{name} is {known}: it must fit a 32-bit float")
    return known


def vector(value: Any, name: str) -> tuple[float, float, float]:
    """Three numbers for a float[3]."""
    if isinstance(value, (str, bytes, bytearray, dict, set)):
        raise TypeError(f"{name} is {shown(value)}: it must be three numbers")
    try:
        length = len(value)
        items = [value[i] for i in range(min(length, 3))]
    except TypeError:
        raise TypeError(f"{name} is {shown(value)}: it must be three numbers") from None
    except (LookupError, OverflowError) as error:
        raise ValueError(f"{name} must be three numbers: {error}") from None
    if length != 3:
        raise ValueError(f"{name} has {length} items: it must have three")
    x, y, z = (number32(item, f"{name}[{i}]") for i, item in enumerate(items))
    return x, y, z


def colour(value: Any, name: str) -> tuple[float, float, float]:
    """Three numbers, or one for all three."""
    try:
        grey = number32(value, name)
    except TypeError:
        return vector(value, name)
    return grey, grey, grey


def enumerated(value: Any, kind: Type[E], name: str) -> E:
    """A member of `kind`, given as itself, as its value or by name."""
    if isinstance(value, str):
        found = kind.__members__.get(value.upper().replace("-", "_"))
    else:
        number_ = integer(value, name, most=2**31 - 1, least=-(2**31))
        found = next((member for member in kind if member.value == number_), None)
    if found is None:
        names = ", ".join(member.lower().replace("_", "-") for member in kind.__members__)
        raise ValueError(f"{name} is {shown(value)}: it must be one of {names}")
    return found


def text(value: Any, name: str) -> bytes:
    if not isinstance(value, str):
        raise TypeError(f"{name} is {shown(value)}: it must be a str")
    return without_zero(value.encode("utf-8"), name)


def optional_text(value: Any, name: str) -> Optional[bytes]:
    return None if value is None else text(value, name)


def path(value: Any, name: str) -> bytes:
    try:
        known = os.fsencode(value)
    except TypeError:
        raise TypeError(f"{name} is {shown(value)}: it must be a path") from None
    return without_zero(known, name)


def without_zero(value: bytes, name: str) -> bytes:
    if b"\0" in value:
        raise ValueError(f"{name} has a zero byte, at which C would cut it")
    return value


def call_back(value: Any, name: str) -> Any:
    if value is not None and not callable(value):
        raise TypeError(f"{name} is {shown(value)}: it must be callable")
    return value


def instance(value: Any, kind: Any, name: str) -> Any:
    if not isinstance(value, kind):
        raise TypeError(f"{name} is {shown(value)}: it must be an awd.{kind.__name__}")
    return value


def shown(value: Any) -> str:
    """For messages: short, whatever it is."""
    if isinstance(value, int) and value.bit_length() > 64:
        return f"an integer of {value.bit_length()} bits"
    try:
        known = repr(value)
    except Exception:
        known = ""
    return known if 0 < len(known) <= 60 else f"of type {type(value).__name__}"
