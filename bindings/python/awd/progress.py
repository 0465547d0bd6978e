# SPDX-License-Identifier: Apache-2.0
"""Progress that a person can see: a line in a terminal or a notebook."""
import importlib
import sys
import time
from typing import Any, Optional

from ._callbacks import Progress

WIDTH = 30
INTERVAL = 0.1  # seconds between two drawings


class Bar:
    """Draws what it is called with: in a notebook through IPython, in a terminal on one line of
    stderr; nothing where there is neither. `progress=True` makes one.

    It may be called from any thread, but from one at a time.
    """

    def __init__(self) -> None:
        self._display = notebook_display()
        self._stream = sys.stderr if is_terminal(sys.stderr) else None
        self._began = time.monotonic()
        self._drawn: Optional[float] = None
        self._operation = ""
        self._fraction = 0.0
        self._passes = 0
        self._line = ""

    def __call__(self, progress: Progress) -> None:
        new = progress.operation != self._operation or progress.fraction < self._fraction
        if new and progress.operation == "pass":
            self._passes += 1
        self._operation, self._fraction = progress.operation, progress.fraction
        now = time.monotonic()
        if new or progress.fraction >= 1 or self._drawn is None or now - self._drawn >= INTERVAL:
            self._drawn = now
            self._draw(self.text(now - self._began))

    def text(self, seconds: float) -> str:
        name = f"pass {self._passes}" if self._operation == "pass" else self._operation
        full = int(self._fraction * WIDTH)
        bar = "#" * full + "." * (WIDTH - full)
        return f"{name:<8} [{bar}] {100 * self._fraction:3.0f} %  {seconds:.1f} s"

    def _draw(self, line: str) -> None:
        if self._display is not None:
            self._display.update({"text/plain": line}, raw=True)
        elif self._stream is not None:
            self._stream.write("\r" + line.ljust(len(self._line)))
            self._stream.flush()
        self._line = line

    def close(self) -> None:
        """Ends the line."""
        if self._display is None and self._stream is not None and self._line:
            self._stream.write("\n")
            self._stream.flush()
        self._line = ""


def is_terminal(stream: Any) -> bool:
    try:
        return bool(stream.isatty())
    except (AttributeError, ValueError):  # there is none, or it is closed
        return False


def notebook_display() -> Any:
    """A display to be updated, where Python runs in a notebook; else None."""
    shell = sys.modules.get("IPython")
    session = shell.get_ipython() if shell is not None else None
    if session is None or not hasattr(session, "kernel"):
        return None
    display = importlib.import_module("IPython.display").display
    return display({"text/plain": ""}, raw=True, display_id=True)
