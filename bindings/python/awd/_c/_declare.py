# SPDX-License-Identifier: Apache-2.0
"""How the modules of this folder declare functions: awd._library gives these types to those of the
loaded library."""
from ctypes import c_void_p
from typing import Any, NamedTuple

# The address of the first item of an array.
Array = c_void_p


class Function(NamedTuple):
    result: Any
    arguments: tuple[Any, ...]


functions: dict[str, Function] = {}


def function(name: str, result: Any, *arguments: Any) -> None:
    functions[name] = Function(result, arguments)
