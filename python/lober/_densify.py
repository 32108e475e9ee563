"""More points on a curve where it is coarse, fewer where it is over-resolved."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from . import _lober
from ._arrays import Points, points_of


@dataclass(frozen=True)
class Diagnostic:
    """Segments first, ..., first + count - 1 of the result: at least one of them breaks a criterion."""

    first: int
    count: int
    cause: str


@dataclass(frozen=True)
class Densified:
    """A curve of more points, with what could not be done."""

    points: Points
    closed: bool
    diagnostics: list[Diagnostic]


def densify(
    curve: Any,
    *,
    closed: bool = True,
    max_length: float = math.inf,
    angle: float = math.inf,
    distance_angle: float = math.inf,
    min_length: float = 0.0,
    hobson: bool = False,
    interpolation: str = "linear",
    max_points: int = 100_000_000,
    threads: int = 0,
) -> Densified:
    """Cuts segments until all criteria that are given hold; vertices given stay, bit for bit.

    `max_length` bounds the length of a segment, `angle` that between successive ones in radians, `distance_angle` the
    product of both; segments are not cut below `min_length`. `hobson=True` takes Hobson's criteria with a choice of
    values of lober's for those that are not given. `interpolation` is linear, dritschel or spline. Raises UsageError,
    DataError.
    """
    points = points_of(curve)
    if hobson:
        _, hobson_angle, hobson_distance, hobson_min = _lober.hobson_criteria(points, closed)
        angle = hobson_angle if angle == math.inf else angle
        distance_angle = hobson_distance if distance_angle == math.inf else distance_angle
        min_length = min_length or hobson_min
    found, diagnostics = _lober.densify(
        points, closed, max_length, angle, distance_angle, min_length, interpolation, max_points, threads
    )
    return Densified(found, closed, [Diagnostic(*entry) for entry in diagnostics])


def densify_near(
    curve: Any,
    other: Any,
    *,
    closed: bool = True,
    other_closed: bool = True,
    passes: int = 1,
    points: int = 10,
    interpolation: str = "linear",
    max_points: int = 100_000_000,
    threads: int = 0,
) -> Densified:
    """Puts `points` points into every segment that meets the other curve, and so on in its parts, `passes` times."""
    found, diagnostics = _lober.densify_near(
        points_of(curve),
        closed,
        points_of(other, "other"),
        other_closed,
        passes,
        points,
        interpolation,
        max_points,
        threads,
    )
    return Densified(found, closed, [Diagnostic(*entry) for entry in diagnostics])


def simplify(
    curve: Any, tolerance: float, *, closed: bool = True, max_length: float = math.inf, threads: int = 0
) -> Points:
    """Removes vertices; none given lies farther than `tolerance` from the segment that spans it.

    No segment longer than `max_length` comes into being. Raises UsageError, DataError.
    """
    return _lober.simplify(points_of(curve), closed, tolerance, max_length, threads)
