"""A bar on standard error for calls with `progress=True`."""

from __future__ import annotations

import sys
import time
from typing import Any, Callable, Optional, TextIO, Union

#: Called with the fraction done and a line of text, either of which may be None; returning False cancels.
Progress = Union[None, bool, Callable[[Optional[float], Optional[str]], Any]]


class Bar:
    """Shows how far a call is: a bar, or the last line of text. Wiped away at the end."""

    def __init__(self, title: str, stream: TextIO | None = None, width: int = 30, interval: float = 0.1) -> None:
        self._title = title
        self._stream = sys.stderr if stream is None else stream
        self._width = width
        self._interval = interval
        self._begin = time.monotonic()
        self._last = -1.0
        self._length = 0

    def __call__(self, fraction: float | None, text: str | None) -> bool:
        now = time.monotonic()
        if self._last >= 0 and now - self._last < self._interval and fraction != 1:
            return True
        self._last = now
        line = self._title
        if fraction is not None:
            done = round(min(max(fraction, 0.0), 1.0) * self._width)
            line += f" [{'#' * done}{'.' * (self._width - done)}] {100 * fraction:3.0f} %"
        line += f", {now - self._begin:.1f} s"
        if text:
            line += f": {text}"
        self._show(line[:119])
        return True

    def close(self) -> None:
        if self._length:
            self._show("")
            self._stream.write("\r")
            self._stream.flush()

    def _show(self, line: str) -> None:
        self._stream.write("\r" + line.ljust(self._length))
        self._stream.flush()
        self._length = len(line)


class watching:
    """With `progress=True` a bar for as long as the block runs; else the callable, or None."""

    def __init__(self, progress: Progress, title: str) -> None:
        self._bar = Bar(title) if progress is True else None
        self._callable = self._bar if self._bar is not None else (progress or None)
        if self._callable is not None and not callable(self._callable):
            raise TypeError("progress has to be a callable, True or None")

    def __enter__(self) -> Callable[[float | None, str | None], Any] | None:
        return self._callable  # type: ignore[return-value]

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.close()
