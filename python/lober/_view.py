"""Pages that show results and curves in a browser, as deep as doubles go."""

from __future__ import annotations

import html
import os
import tempfile
import webbrowser
import weakref
from pathlib import Path
from typing import Any

import numpy as np

from . import _lober
from ._arrays import points_of
from ._call import Run
from ._dynamics import Manifold
from .errors import UsageError

# Runs of results that hold numbers only, by the identity of the result, as long as it lives: copies and pickles have none.
_runs: dict[int, tuple[weakref.ref[Any], Run]] = {}


def remember(result: Any, run: Run) -> Any:
    """The result, of which pages can be made as long as it lives."""
    key = id(result)
    _runs[key] = (weakref.ref(result, lambda _: _runs.pop(key, None)), run)
    return result


def _run_of(result: Any) -> Run | None:
    if isinstance(result, Manifold):
        return None  # a curve
    run = getattr(result, "_run", None)
    if isinstance(run, Run):
        return run
    found = _runs.get(id(result))
    return found[1] if found is not None and found[0]() is result else None


class Page:
    """A page of HTML: one text that needs no network. Notebooks show it in a frame."""

    def __init__(self, text: str, height: int = 560) -> None:
        self.text = text
        self.height = height

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Writes the page; the file appears when it is complete."""
        target = Path(path)
        beside = target.with_name(target.name + f".{os.getpid()}")
        try:
            beside.write_text(self.text, encoding="utf-8")
            beside.replace(target)
        except BaseException:
            beside.unlink(missing_ok=True)
            raise
        return target

    def _repr_html_(self) -> str:
        text = html.escape(self.text)
        return (
            f'<iframe srcdoc="{text}" sandbox="allow-scripts allow-downloads" title="lober" '
            f'style="width: 100%; height: {self.height}px; border: 0"></iframe>'
        )

    def __repr__(self) -> str:
        return f"<page of {len(self.text) / 1e6:.1f} MB>"


def page(*what: Any, title: str = "") -> Page:
    """The page of a result of `overlay`, `regions`, `tangle`, `manifold_tangle`, `transport` or `escape`, or of curves.

    A curve is closed where its last point is its first one. Raises UsageError for results that have no page, and for
    those of `transport` and `escape` that were unpickled.
    """
    if not what:
        raise UsageError("nothing to look at: give a result, or curves")
    if len(what) == 1:
        run = _run_of(what[0])
        if run is not None:
            of = getattr(run, "of", None)
            if of is None:
                raise UsageError("a result that was unpickled has no page; compute it again")
            return Page(_lober.page_of_run(of, title))
    curves = []
    for one in what:
        if _run_of(one) is not None:
            raise UsageError("a page shows one result, or curves")
        try:
            curves.append(points_of(getattr(one, "points", one)))
        except (TypeError, ValueError) as error:
            raise UsageError(f"there are no pages of {type(one).__name__}") from error
    closed = [len(points) > 2 and bool(np.array_equal(points[0], points[-1])) for points in curves]
    curves = [points[:-1] if is_closed else points for points, is_closed in zip(curves, closed)]
    names = [f"curve {k}" for k in range(len(curves))]
    return Page(_lober.page_of_curves(curves, names, closed, title))


def view(*what: Any, path: str | os.PathLike[str] | None = None, title: str = "", open: bool = True) -> Path:
    """Writes the page of a result or of curves (see `page`) and opens it in a browser.

    Without `path` it is a file in the folder for temporary files. Returns its path.
    """
    made = page(*what, title=title)
    if path is None:
        handle, name = tempfile.mkstemp(prefix="lober-", suffix=".html")
        os.close(handle)
        path = name
    saved = made.save(path)
    if open:
        webbrowser.open(saved.resolve().as_uri())
    return saved
