# SPDX-License-Identifier: Apache-2.0
"""Finds libawd, and calls its functions."""
import ctypes
import os
import threading
from typing import Any, Callable, Optional

from . import _c as c
from ._errors import LibraryNotFound, Unsupported, error_of

SONAME = "libawd.so.1"


def candidates() -> list[str]:
    """The file that $AWD_LIBRARY names, alone; else the one in the wheel, then the system's."""
    named = os.environ.get("AWD_LIBRARY")
    if named:
        return [named]
    wheel = os.path.join(os.path.dirname(os.path.abspath(__file__)), "_lib", SONAME)
    return [wheel, SONAME]


def load() -> tuple[str, ctypes.CDLL]:
    tried = []
    for path in candidates():
        try:
            library = ctypes.CDLL(path)
            library.awdGetVersion  # another library of that name has none
        except (OSError, AttributeError, ValueError) as error:
            tried.append(f"  {path}: {error}")
            continue
        return path, library
    raise LibraryNotFound(
        "libawd was not found. Set AWD_LIBRARY to the file, install the library, or install a "
        "wheel that carries it. Tried:\n" + "\n".join(tried))


class Library:
    """The functions of libawd as attributes; the library is loaded when the first is asked for."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._path: Optional[str] = None

    def __getattr__(self, name: str) -> Callable[..., Any]:
        if name not in c.functions:
            raise AttributeError(name)
        self.path()
        found: Callable[..., Any] = self.__dict__[name]
        return found

    def path(self) -> str:
        """The file as it was asked of the loader."""
        with self._lock:
            if self._path is None:
                path, library = load()
                for name, declared in c.functions.items():
                    self.__dict__[name] = bind(library, path, name, declared)
                self._path = path
            return self._path


def bind(library: ctypes.CDLL, path: str, name: str, declared: c.Function) -> Callable[..., Any]:
    try:
        bound = getattr(library, name)
    except AttributeError:

        def missing(*_: Any) -> Any:
            raise Unsupported(f"{path} has no {name}: it is an older one, or was built without it")

        return missing
    bound.restype = declared.result
    bound.argtypes = declared.arguments
    return bound  # type: ignore[no-any-return]


lib = Library()


def check(result: int) -> None:
    """Raises what the library says of a call of this thread that failed."""
    if result != c.AWD_SUCCESS:
        raise error_of(result, decoded(lib.awdGetLastErrorMessage()))


def decoded(text: Optional[bytes]) -> str:
    return "" if text is None else text.decode("utf-8", "replace")
