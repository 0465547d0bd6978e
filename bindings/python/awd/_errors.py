# SPDX-License-Identifier: Apache-2.0
"""What is raised: a class for each result of the library, with the library's message."""
from typing import Type

from ._enums import Result


class LibraryNotFound(OSError):
    """libawd can't be loaded; the message lists the files that were tried, and why not."""


class Error(Exception):
    """A call of the library failed. `result` is its code."""

    result = Result.ERROR_UNKNOWN


class InvalidArgument(Error, ValueError):
    """A value that the call can't take."""

    result = Result.ERROR_INVALID_ARGUMENT


class InvalidOperation(Error, RuntimeError):
    """A call at the wrong time: before commit, after close, or while another one is at work."""

    result = Result.ERROR_INVALID_OPERATION


class OutOfMemory(Error, MemoryError):
    result = Result.ERROR_OUT_OF_MEMORY


class Unsupported(Error, NotImplementedError):
    """Not in this build of the library, or a module is not there."""

    result = Result.ERROR_UNSUPPORTED


class Cancelled(Error):
    """The progress callback returned False; nothing was changed by what it stopped."""

    result = Result.ERROR_CANCELLED


class FileError(Error, OSError):
    """A file can't be read or written, or bytes are damaged."""

    result = Result.ERROR_IO


class PluginError(Error):
    """A basis module can't be used."""

    result = Result.ERROR_PLUGIN_LOAD


class PluginLoadError(PluginError):
    """It can't be opened or has no entry point."""


class PluginABIError(PluginError):
    """It was compiled for another interface."""

    result = Result.ERROR_PLUGIN_ABI


class PluginNameTaken(PluginError):
    result = Result.ERROR_PLUGIN_NAME_TAKEN


class PluginSelfTestFailed(PluginError):
    """Its mathematics is wrong; the message says where."""

    result = Result.ERROR_PLUGIN_SELF_TEST


CLASSES: tuple[Type[Error], ...] = (
    InvalidArgument, InvalidOperation, OutOfMemory, Unsupported, Cancelled, FileError,
    PluginLoadError, PluginABIError, PluginNameTaken, PluginSelfTestFailed)


def error_of(result: int, message: str) -> Error:
    for kind in CLASSES:
        if kind.result == result:
            return kind(message)
    return Error(f"{message} (result {result})")
