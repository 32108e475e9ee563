"""The section of a system of one's own: `y=0` and `x<-1` as numbers."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Sequence

from ._numbers import number_of
from .errors import UsageError


@dataclass(frozen=True)
class Section:
    """The section of a flow, by numbers of coordinates: a lober_section of lober_system.h, but for the energy."""

    coordinate: int
    value: float
    direction: int
    #: The coordinates of the map.
    chart: tuple[int, int]
    #: The coordinate that follows from the energy, or -1.
    solved: int
    #: A coordinate, a value, and the side that counts: 1, -1, or 0 for both.
    bound: tuple[int, float, int]
    #: The period of the coordinate, or 0.
    angle: float

    def as_dict(self) -> dict[str, Any]:
        """As bindings/python_field.cpp reads it."""
        return {
            "coordinate": self.coordinate,
            "value": self.value,
            "direction": self.direction,
            "chart_x": self.chart[0],
            "chart_y": self.chart[1],
            "solved": self.solved,
            "bound_coordinate": self.bound[0],
            "bound": self.bound[1],
            "bound_side": self.bound[2],
            "period": self.angle,
        }


def _relation(text: Any, signs: str, names: Sequence[str], what: str, form: str) -> tuple[int, str, float]:
    """The number of a coordinate, the sign behind its name, and the number behind that."""
    if not isinstance(text, str):
        raise UsageError(f"{what} has to be a text like {form!r}, not {type(text).__name__}")
    for sign in signs:
        name, found, number = text.partition(sign)
        if not found:
            continue
        if name.strip() not in names:
            raise UsageError(f"{what}: {name.strip()!r} is not a coordinate; the coordinates are {', '.join(names)}")
        try:
            value = float(number)
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            raise UsageError(f"{what}: {number.strip()!r} is not a number")
        return list(names).index(name.strip()), sign, value
    raise UsageError(f"{what} has to be a text like {form!r}, not {text!r}")


def section_of(
    system: str, names: Sequence[str], hamiltonian: bool, section: Any, direction: Any, bound: Any, angle: Any
) -> Section:
    """A section of four coordinates, positions before momenta, or of three. Raises UsageError."""
    if len(set(names)) < len(names):
        raise UsageError(f"system {system}: two coordinates have the same name")
    if hamiltonian and len(names) != 4:
        raise UsageError(f"system {system}: a section of a Hamiltonian flow needs 4 coordinates, not {len(names)}")
    if not hamiltonian and len(names) != 3:
        raise UsageError(
            f"system {system}: a flow of {len(names)} coordinates has no return map; give 3, or 4 with a hamiltonian"
        )
    at, _, value = _relation(section, "=", names, f"system {system}: section", "y=0")
    if direction not in (1, -1, "+", "-"):
        raise UsageError(f"system {system}: direction has to be 1 or -1, not {direction!r}")
    turn = number_of(angle, f"system {system}: angle")
    if not (turn >= 0 and math.isfinite(turn)):
        raise UsageError(f"system {system}: angle is the period of the section's coordinate, not {turn}")
    limit = (0, 0.0, 0)
    if bound is not None:
        bounded, sign, edge = _relation(bound, "<>", names, f"system {system}: bound", "x<-1")
        limit = (bounded, edge, -1 if sign == "<" else 1)
    solved = (at + 2) % 4 if hamiltonian else -1
    chart = [k for k in range(len(names)) if k not in (at, solved)]
    towards = 1 if direction in (1, "+") else -1
    return Section(at, value, towards, (chart[0], chart[1]), solved, limit, turn)
