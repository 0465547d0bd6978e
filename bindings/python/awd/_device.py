# SPDX-License-Identifier: Apache-2.0
import ctypes
from typing import Any, Optional, Sequence

from . import _check
from . import _c as c
from ._callbacks import (Callbacks, LogFunction, ProgressFunction, log_function, progress_function)
from ._errors import PluginABIError, PluginLoadError
from ._figures import BasisCheck, BasisInfo, figures
from ._library import check, lib
from ._objects import Object, Use, described


class Device(Object):
    """Threads, callbacks, and the registry of basis families. Two devices share nothing.

    threads: 0: all this process may use; at most 1024.
    ignore_environment: don't look for basis modules in $AWD_BASIS_PATH.
    log: called with (Severity, str), from any thread, also from several at once. Without it the
      library is silent.
    progress: called with a Progress of every long operation of every object of the device, from
      whichever thread is at work; returns False to cancel. The long calls take one of their own.
    basis_paths: absolute folders that are searched for basis modules before all others.

    An exception in a callback cancels what is at work, if it can be, and comes out of the call.
    Methods may be called at any time from any thread.
    """

    _kind = "Device"

    def __init__(self, *, threads: int = 0, ignore_environment: bool = False,
                 log: Optional[LogFunction] = None, progress: Optional[ProgressFunction] = None,
                 basis_paths: Sequence[_check.PathLike] = ()) -> None:
        desc = described(c.AWDDeviceDesc)
        desc.threads = _check.integer(threads, "threads")
        desc.flags = c.AWD_DEVICE_IGNORE_ENVIRONMENT if ignore_environment else 0
        if isinstance(basis_paths, (str, bytes)):
            raise TypeError("basis_paths is one path: it must be a sequence of paths")
        paths = [_check.path(path, f"basis_paths[{i}]") for i, path in enumerate(basis_paths)]
        desc.basisPaths = (ctypes.c_char_p * len(paths))(*paths)
        desc.basisPathCount = len(paths)
        callbacks = Callbacks(log_function(log), progress_function(progress))
        desc.log = callbacks.log
        desc.progress = callbacks.progress
        handle = c.AWDDevice()
        check(lib.awdNewDevice(ctypes.byref(desc), ctypes.byref(handle)))
        self._own(handle, callbacks)

    def bases(self) -> tuple[BasisInfo, ...]:
        """Families that can be used, by name, then candidates that were refused, by file. Looks
        for modules if that has not been done."""
        count = ctypes.c_size_t()
        found = []
        with Use(shared=(self,)):
            check(lib.awdGetBasisCount(self._handle, ctypes.byref(count)))
            for index in range(count.value):
                info = described(c.AWDBasisInfo)
                check(lib.awdGetBasisInfo(self._handle, index, ctypes.byref(info)))
                found.append(figures(BasisInfo, info))
        return tuple(found)

    def load_basis(self, path: _check.PathLike) -> None:
        """Loads a basis module by absolute path. A PluginError tells why not."""
        known = _check.path(path, "path")
        with Use(shared=(self,)):
            check(lib.awdLoadBasisModule(self._handle, known))


def check_basis(path: _check.PathLike) -> tuple[BasisCheck, ...]:
    """Tests a basis module, by absolute path, as loading does, and registers nothing: every check
    of every family, with its status. PluginLoadError or PluginABIError: none could be made."""
    known = _check.path(path, "path")
    checks: list[BasisCheck] = []
    failures: list[BaseException] = []

    def report(_: Any, told: Any) -> None:
        try:
            checks.append(figures(BasisCheck, told.contents))
        except BaseException as error:
            failures.append(error)

    result = lib.awdCheckBasisModule(known, c.AWDBasisCheckFn(report), None)
    if failures:
        raise failures[0]
    if result in (PluginLoadError.result, PluginABIError.result) or not checks:
        check(result)
    return tuple(checks)


def library_version() -> tuple[int, int, int]:
    """Major, minor and patch version of the loaded library."""
    version: int = lib.awdGetVersion()
    return version // 10000, version // 100 % 100, version % 100


def library_path() -> str:
    """The file that was loaded, as it was asked of the loader."""
    return lib.path()


def result_string(result: int) -> str:
    """The library's short name of a result code, such as "out of memory"."""
    known = _check.integer(result, "result", most=2**31 - 1, least=-(2**31))
    text: bytes = lib.awdGetResultString(known)
    return text.decode()
