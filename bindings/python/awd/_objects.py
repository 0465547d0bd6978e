# SPDX-License-Identifier: Apache-2.0
"""Handles and their lives.

A Reference owns one reference of the C object and gives it back when the last of those that use it
is gone: the Python object until it is closed, and any call at work. It also knows which calls are
at work, so that what the C interface leaves undefined (two calls at once where one is exclusive) is
an InvalidOperation here.
"""
import ctypes
import threading
from types import TracebackType
from typing import Any, Callable, Optional, Type, TypeVar, Union

from ._callbacks import Callbacks, Watch, interruptible
from ._errors import InvalidOperation
from ._library import check, lib

Self = TypeVar("Self", bound="Object")


class Reference:
    def __init__(self, kind: str, pointer: int, callbacks: Callbacks) -> None:
        self.kind = kind
        self.pointer = pointer
        self.callbacks = callbacks  # must live as long as the C object may call them
        self._release: Callable[[int], None] = getattr(lib, f"awdRelease{kind}")
        self._lock = threading.Lock()
        self._shared = 0
        self._exclusive = False

    def __del__(self) -> None:
        self._release(self.pointer)

    def enter(self, exclusive: bool) -> None:
        with self._lock:
            if self._exclusive or (exclusive and self._shared):
                raise InvalidOperation(
                    f"another call uses this {self.kind}: it must return before this one, also if "
                    "this one comes from its callback")
            if exclusive:
                self._exclusive = True
            else:
                self._shared += 1

    def leave(self, exclusive: bool) -> None:
        with self._lock:
            if exclusive:
                self._exclusive = False
            else:
                self._shared -= 1


class Use:
    """Within it calls may use these objects: `exclusive` ones alone, others together."""

    def __init__(self, exclusive: "Used" = (), shared: "Used" = ()) -> None:
        alone = references(exclusive)
        together = [known for known in references(shared) if known not in alone]
        # An object that is given twice is for the library to judge.
        self._wanted = [(known, True) for known in dict.fromkeys(alone)]
        self._wanted += [(known, False) for known in together]
        self._held: list[tuple[Reference, bool]] = []

    def __enter__(self) -> None:
        try:
            for reference, exclusive in self._wanted:
                reference.enter(exclusive)
                self._held.append((reference, exclusive))
        except BaseException:
            self._leave()
            raise

    def __exit__(self, kind: Optional[Type[BaseException]], error: Optional[BaseException],
                 trace: Optional[TracebackType]) -> None:
        callbacks = self._wanted[0][0].callbacks
        self._leave()
        callbacks.raise_pending()

    def _leave(self) -> None:
        while self._held:
            reference, exclusive = self._held.pop()
            reference.leave(exclusive)


class Object:
    """What all objects of the library have in common: they can be closed, and closed by `with`.

    Closing gives up this object's hold on the C object; children (a scene of a device, a render of
    a scene) go on living. Any use after it raises InvalidOperation. An object that is not closed is
    given up when Python forgets it.
    """

    _kind = "Object"
    _reference: Optional[Reference] = None

    def _own(self, pointer: Any, callbacks: Callbacks) -> None:
        self._reference = Reference(self._kind, pointer.value, callbacks)

    @classmethod
    def _make(cls: Type[Self], pointer: Any, parent: "Object") -> Self:
        """The Python object of a handle of which the library has given a reference."""
        made = cls.__new__(cls)
        made._own(pointer, parent._callbacks)
        return made

    @classmethod
    def _sharing(cls: Type[Self], reference: Reference) -> Self:
        """Another Python object of the same C object, to be closed by itself."""
        made = cls.__new__(cls)
        made._reference = reference
        return made

    def _alive(self) -> Reference:
        reference = self._reference
        if reference is None:
            raise InvalidOperation(f"the {self._kind} is closed")
        return reference

    @property
    def _handle(self) -> int:
        return self._alive().pointer

    @property
    def _callbacks(self) -> Callbacks:
        return self._alive().callbacks

    @property
    def closed(self) -> bool:
        return self._reference is None

    def close(self) -> None:
        """Gives up the object; a call at work keeps it until it returns. Closing twice is fine."""
        self._reference = None

    def __enter__(self: Self) -> Self:
        self._alive()
        return self

    def __exit__(self, kind: Optional[Type[BaseException]], error: Optional[BaseException],
                 trace: Optional[TracebackType]) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<awd.{self._kind}{' (closed)' if self.closed else ''}>"

    def _long(self, progress: Any, exclusive: "Used", shared: "Used",
              body: Callable[[], None]) -> None:
        """Runs a call that may take long: it tells of its progress, and an exception or Ctrl-C
        cancels it within a tile of work."""
        callbacks = self._callbacks
        use = Use(exclusive, shared)
        handles = [known.pointer for known in references(exclusive)]
        with Watch(callbacks, handles, progress) as watch:

            def run() -> None:
                with use:
                    body()

            interruptible(run, watch)


Used = tuple[Union[Object, Reference, None], ...]


def references(used: Used) -> list[Reference]:
    """Those of the objects, which must not be closed; none for None."""
    return [known._alive() if isinstance(known, Object) else known for known in used
            if known is not None]


def bytes_of(call: Callable[[Any, int, Any], int]) -> bytes:
    """What a call of the form (bytes, capacity, *size) gives."""
    size = ctypes.c_size_t()
    check(call(None, 0, ctypes.byref(size)))
    room = ctypes.create_string_buffer(max(size.value, 1))
    check(call(room, size.value, ctypes.byref(size)))
    return room.raw[:size.value]


def described(kind: Any) -> Any:
    """A C struct with its structSize set, all else 0: the default."""
    made = kind()
    made.structSize = ctypes.sizeof(kind)
    return made
