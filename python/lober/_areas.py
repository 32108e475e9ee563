"""Areas of two curves and their error bars, as tables."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Iterable

from . import _lober
from ._lober import Areas as Areas

#: Names and labels of the areas, in the order of the program.
AREAS = {
    "c1": "C1",
    "c2": "C2",
    "intersection": "C1 and C2",
    "union": "C1 or C2",
    "c1_minus_c2": "C1 \\ C2",
    "c2_minus_c1": "C2 \\ C1",
    "symmetric_difference": "either, not both",
}


@dataclass(frozen=True)
class AreaErrors:
    """Error bars, area by area, in squared units of the coordinates.

    `rounding` is a bound on |area - exact area of the polygons as given|, `discretisation` an estimate of |area of the
    polygons - area between smooth curves through the same points|, `consistency` the difference to another method. What
    was not computed is None.
    """

    rounding: Areas
    discretisation: Areas | None = None
    consistency: Areas | None = None


def dict_of(areas: Areas) -> dict[str, float]:
    return {name: getattr(areas, name) for name in AREAS}


def html_table(head: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    def row(cells: Iterable[str], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{cell}</{tag}>" for cell in cells) + "</tr>"

    body = "".join(row(cells, "td") for cells in rows)
    return f"<table><thead>{row(head, 'th')}</thead><tbody>{body}</tbody></table>"


def areas_html(title: str, areas: Areas, errors: AreaErrors) -> str:
    """A caption and a row for each area with its error bars."""
    columns = [name for name in ("rounding", "discretisation", "consistency") if getattr(errors, name) is not None]
    rows = [
        [label, f"{getattr(areas, name):.15g}", *(f"{getattr(getattr(errors, c), name):.1e}" for c in columns)]
        for name, label in AREAS.items()
    ]
    return f"<p>{title}</p>" + html_table(["", "area", *columns], rows)


def _areas_repr(self: Areas) -> str:
    return "Areas(" + ", ".join(f"{name}={value!r}" for name, value in dict_of(self).items()) + ")"


def _areas_equal(self: Areas, other: Any) -> Any:
    return dict_of(self) == dict_of(other) if isinstance(other, Areas) else NotImplemented


def _areas_of(numbers: tuple[float, ...]) -> Areas:
    return _lober.areas_of(**dict(zip(AREAS, numbers)))


def _areas_reduce(self: Areas) -> tuple[Any, ...]:
    """By a function: the classes of the extension have no __new__ to unpickle with (bindings/sealed.hpp)."""
    return _areas_of, (tuple(dict_of(self).values()),)


_lober.Areas.__module__ = "lober"
_lober.Areas.__reduce__ = _areas_reduce  # type: ignore[assignment]
_lober.Areas.__repr__ = _areas_repr  # type: ignore[assignment]
_lober.Areas.__eq__ = _areas_equal  # type: ignore[assignment]
_lober.Areas.__hash__ = None  # type: ignore[assignment]
