# SPDX-License-Identifier: Apache-2.0
"""What this package declares of the C interface. `python3 -m awd.declared` prints it as JSON, for
tests that compare it with the headers; libawd is not loaded."""
import ctypes
import json
from typing import Any

from . import _c as c


def declared() -> dict[str, Any]:
    """{"functions": {name: number of arguments}, "constants": {name: value},
    "structs": {name: {"size": bytes, "fields": {name: offset}}}}"""
    names = {name: value for name, value in vars(c).items() if name.startswith("AWD")}
    return {
        "functions": {name: len(known.arguments) for name, known in c.functions.items()},
        "constants": {name: value for name, value in names.items() if isinstance(value, int)},
        "structs": {
            name: {"size": ctypes.sizeof(kind),
                   "fields": {field[0]: getattr(kind, field[0]).offset for field in kind._fields_}}
            for name, kind in names.items()
            if isinstance(kind, type) and issubclass(kind, ctypes.Structure)
        },
    }


if __name__ == "__main__":
    print(json.dumps(declared(), indent=1))
