# SPDX-License-Identifier: Apache-2.0
"""What the library calls back: log and progress, and how exceptions come through them.

An exception in a callback can't cross C. It is kept, what is at work is cancelled, and the call
that it came from raises it when it returns.
"""
import threading
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Callable, Optional, Type, Union

from . import _c as c
from ._check import call_back, shown
from ._enums import Severity
from ._errors import Cancelled, InvalidOperation
from ._library import decoded


@dataclass(frozen=True)
class Progress:
    """What a long operation has done so far."""

    operation: str
    """ "commit", "pass" or "adapt" """
    fraction: float
    """0 to 1, never falling within one operation"""


LogFunction = Callable[[Severity, str], object]
ProgressFunction = Callable[[Progress], object]
"""Returns False to cancel; anything else, None too, goes on."""
ProgressLike = Union[bool, ProgressFunction, None]


class Watch:
    """One call that may take long, in the eyes of the callbacks."""

    def __init__(self, callbacks: "Callbacks", handles: list[int], progress: Any) -> None:
        from .progress import Bar

        self.cancelled = False
        self.error: Optional[BaseException] = None
        self.bar = Bar() if progress is True else None
        self.tell: Optional[ProgressFunction] = self.bar
        if progress is not None and not isinstance(progress, bool):
            self.tell = call_back(progress, "progress")
        self._callbacks = callbacks
        self._handles = handles

    def __enter__(self) -> "Watch":
        self._callbacks.watch(self._handles, self)
        return self

    def __exit__(self, kind: Optional[Type[BaseException]], error: Optional[BaseException],
                 trace: Optional[TracebackType]) -> None:
        self._callbacks.unwatch(self._handles, self)
        if self.bar is not None:
            self.bar.close()
        if self.error is not None and (error is None or isinstance(error, Cancelled)):
            raise self.error from None


class Callbacks:
    """Those of a device. Kept alive by every reference to one of its objects."""

    def __init__(self, log: Optional[LogFunction], progress: Optional[ProgressFunction]) -> None:
        state = _State(log, progress)
        self._state = state
        # Closures over `state`, not methods: with those self could not be freed at once.
        self.log = c.AWDLogFn(0) if log is None else c.AWDLogFn(
            lambda _, severity, message: state.on_log(severity, message))
        self.progress = c.AWDProgressFn(lambda _, progress: state.on_progress(progress))

    def watch(self, handles: list[int], watch: Watch) -> None:
        with self._state.lock:
            if any(handle in self._state.watches for handle in handles):
                raise InvalidOperation("another call uses this object: it must return before this "
                                       "one, also if this one comes from its callback")
            for handle in handles:
                self._state.watches[handle] = watch

    def unwatch(self, handles: list[int], watch: Watch) -> None:
        with self._state.lock:
            for handle in handles:
                if self._state.watches.get(handle) is watch:
                    del self._state.watches[handle]

    def raise_pending(self) -> None:
        """Raises what the log function raised since."""
        if self._state.pending:
            with self._state.lock:
                pending, self._state.pending = self._state.pending, []
            if pending:
                raise pending[0]


class _State:
    def __init__(self, log: Optional[LogFunction], progress: Optional[ProgressFunction]) -> None:
        self.log = log
        self.progress = progress
        self.lock = threading.Lock()
        self.watches: dict[int, Watch] = {}
        self.pending: list[BaseException] = []

    def on_log(self, severity: int, message: Optional[bytes]) -> None:
        try:
            if self.log is not None:
                self.log(Severity(severity), decoded(message))
        except BaseException as error:
            self.pending.append(error)

    def on_progress(self, progress: Any) -> int:
        watch = None
        try:
            told = progress.contents
            watch = self.watches.get(told.object)
            if self.pending or (watch is not None and watch.cancelled):
                return 0
            known = Progress(decoded(told.operation), told.fraction)
            for tell in (self.progress, None if watch is None else watch.tell):
                if tell is not None and tell(known) is False:
                    return 0
            return 1
        except BaseException as error:
            if watch is None:
                self.pending.append(error)
            else:
                watch.error = watch.error or error
                watch.cancelled = True
            return 0


def interruptible(body: Callable[[], None], watch: Watch) -> None:
    """Runs body(). Signals reach Python in its main thread alone, and not while that is in C: there
    body() runs in a thread of its own, so that Ctrl-C cancels it."""
    if threading.current_thread() is not threading.main_thread():
        body()
        return
    done = threading.Event()
    turn = threading.Lock()  # whoever takes it first says whether body() runs
    failure: list[BaseException] = []

    def run() -> None:
        if not turn.acquire(blocking=False):
            return
        try:
            body()
        except BaseException as error:
            failure.append(error)
        finally:
            done.set()

    interrupt: Optional[BaseException] = None
    try:
        threading.Thread(target=run, name="awd").start()
    except BaseException as error:
        if turn.acquire(blocking=False):
            raise  # body() has not begun, and will not
        watch.cancelled = True
        interrupt = error
    while not done.is_set():
        try:
            done.wait()
        except BaseException as error:  # of a signal's handler, such as KeyboardInterrupt
            watch.cancelled = True
            interrupt = interrupt or error
    if interrupt is not None:
        raise interrupt
    if failure:
        raise failure[0]


def log_function(value: Any) -> Optional[LogFunction]:
    known: Optional[LogFunction] = call_back(value, "log")
    return known


def progress_function(value: Any) -> Optional[ProgressFunction]:
    if isinstance(value, bool):
        raise TypeError(f"progress is {shown(value)}: it must be callable")
    known: Optional[ProgressFunction] = call_back(value, "progress")
    return known
