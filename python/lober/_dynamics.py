"""Fixed points, manifolds, images of curves, sections."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Iterator

import numpy as np
from numpy.typing import NDArray

from . import _lober
from ._areas import html_table
from ._arrays import Points, points_of
from ._call import call, system_input
from ._progress import Progress, watching
from ._systems import Box, Pair, pair_of, system_of
from .errors import UsageError


@dataclass(frozen=True)
class FixedPoint:
    """A fixed or periodic point of the planar map; `derivative`, `multipliers` and `directions` are of f^period."""

    at: Pair
    period: int
    type: str
    derivative: tuple[Pair, Pair]
    multipliers: tuple[complex, complex]
    directions: tuple[Pair, Pair]
    #: Greene's residue, (2 - trace) / 4.
    residue: float
    #: The sign of det(1 - D f^period).
    index: int
    #: |f^period(at) - at - shift|.
    residual: float


@dataclass(frozen=True)
class FixedPoints:
    """The points in a box, sorted by period, x, y."""

    points: list[FixedPoint]
    #: Whether the last scan found what the one before had found and no index contradicts it.
    settled: bool
    grid: int
    index_sum: int
    index_of_box: int | None
    box: Box

    def __len__(self) -> int:
        return len(self.points)

    def __getitem__(self, number: int) -> FixedPoint:
        return self.points[number]

    def __iter__(self) -> Iterator[FixedPoint]:
        return iter(self.points)

    @property
    def at(self) -> Points:
        """Positions of all points, as an array."""
        return np.array([point.at for point in self.points], dtype=np.float64).reshape(-1, 2)

    def _repr_html_(self) -> str:
        rows = [
            [f"{p.at[0]:.14g}", f"{p.at[1]:.14g}", str(p.period), p.type, f"{p.residue:.8g}", f"{p.residual:.1e}"]
            for p in self.points
        ]
        return html_table(["x", "y", "period", "type", "residue", "residual"], rows)


def fixed_points(
    system: Any,
    *,
    box: Box | None = None,
    period: int = 1,
    turns: int = 0,
    grid: int = 48,
    max_grid: int = 384,
    threads: int = 0,
    progress: Progress = None,
) -> FixedPoints:
    """The points with f^period(z) = z + turns * lattice in a box (default: the window of the system).

    Found by scans on grids of `grid`, twice as many, ... up to `max_grid` points a side until two in a row find the same.
    Raises UsageError, Cancelled.
    """
    made = system_of(system)
    settings = {"box": box, "period": period, "turns": turns, "grid": grid, "max_grid": max_grid}
    found, _ = call("fixed_points", [system_input(made)], settings, threads, progress)
    points, search = found["points"], found["search"]
    return FixedPoints(
        [_point_of({key: column[k] for key, column in points.items()}) for k in range(len(points["type"]))],
        search["settled"],
        search["grid"],
        search["index_sum"],
        search["index_of_box"],
        made.window if box is None else box,
    )


def _point_of(row: dict[str, Any]) -> FixedPoint:
    (xx, xy), (yx, yy) = row["derivative"].tolist()
    (x1, y1), (x2, y2) = np.nan_to_num(row["directions"]).tolist()  # none where the multipliers are complex
    return FixedPoint(
        (float(row["x"]), float(row["y"])),
        int(row["period"]),
        row["type"],
        ((xx, xy), (yx, yy)),
        (complex(*row["multipliers"][0]), complex(*row["multipliers"][1])),
        ((x1, y1), (x2, y2)),
        float(row["residue"]),
        int(row["index"]),
        float(row["residual"]),
    )


def fixed_point(system: Any, near: Pair, *, period: int = 1, turns: int = 0) -> FixedPoint:
    """The one that Newton's method finds from a point. Raises DataError where it does not converge."""
    return FixedPoint(*_lober.fixed_point(system_of(system)._of, near, period, turns))


@dataclass(frozen=True)
class GrowthDiagnostic:
    """Segments first, ..., first + count - 1 that do not meet the tolerance: failed, spacing, max_rounds, left_box."""

    first: int
    count: int
    cause: str


@dataclass(frozen=True)
class Manifold:
    """One branch of a manifold, from its saddle on.

    Vertex i is F^(k steps)(P(parameters[i])), k its generation, P the local manifold; `generation_begin` has the first
    vertex of each generation and the number of points. `stop` says why growing ended: iterates, length, points, ended or
    failed.
    """

    points: Points
    parameters: NDArray[np.float64]
    generation_begin: NDArray[np.uint64]
    diagnostics: list[GrowthDiagnostic]
    stop: str
    length: float
    images: int
    saddle: Pair
    multiplier: float
    #: How far images of the local manifold lie beside it, at most.
    defect: float


def grow(
    system: Any,
    side: str = "unstable",
    *,
    tolerance: float = 1e-5,
    iterates: int | None = None,
    length: float = math.inf,
    at: Pair | None = None,
    branch: str | Pair | None = None,
    period: int = 1,
    max_length: float = 0.0,
    max_points: int = 100_000_000,
    box: Box | None = None,
    threads: int = 0,
    progress: Progress = None,
) -> Manifold:
    """Grows one branch of the unstable or stable manifold of a saddle, no farther than `tolerance` from the curve.

    Ends after `iterates` images of the local manifold or at the arc length `length`, one of which has to be given. `at` is
    a point near the saddle and `branch` is "+", "-" or a vector roughly along the branch (default: those of the system's
    tangle). `period` is that of the saddle. Raises DataError, UsageError, Cancelled.
    """
    if iterates is None and not length < math.inf:
        raise UsageError("the end of the manifold is missing; give iterates or length")
    if branch is not None and not isinstance(branch, str):
        branch = ",".join(repr(number) for number in pair_of(branch, "branch"))
    settings = {
        "side": side,
        "from": at,
        "branch": branch,
        "period": period,
        "tolerance": tolerance,
        "iterates": iterates,
        "length": length if length < math.inf else None,
        "max_length": max_length if max_length > 0 else None,
        "box": box,
        "max_points": max_points,
    }
    found, _ = call("grow", [system_input(system)], settings, threads, progress)
    grown, local, diagnostics = found["result"], found["local_manifold"], found["diagnostics"]["list"]
    return Manifold(
        found["points"],
        found["parameters"],
        np.array([*grown["generations"], grown["points"]], dtype=np.uint64),
        [
            GrowthDiagnostic(int(first), int(count), cause)
            for first, count, cause in zip(diagnostics["segment"], diagnostics["count"], diagnostics["cause"])
        ],
        grown["stop"],
        grown["length"],
        grown["images"],
        local["saddle"],
        local["multiplier"],
        local["defect_across"],
    )


@dataclass(frozen=True)
class Image:
    """The image of a curve under `iterate` steps.

    `parameters` has for each point the number of the segment of the original plus a fraction. Where the map fails, `parts`
    has the pieces as (points, closed); else the whole.
    """

    points: Points
    parameters: NDArray[np.float64]
    closed: bool
    iterate: int
    diagnostics: list[GrowthDiagnostic]
    stop: str
    images: int
    parts: list[tuple[Points, bool]]


def images(
    system: Any,
    curve: Any,
    first: int,
    last: int,
    *,
    tolerance: float = 1e-5,
    closed: bool = True,
    max_length: float = math.inf,
    max_points: int = 100_000_000,
    box: Box | None = None,
    threads: int = 0,
    progress: Progress = None,
) -> list[Image]:
    """Images number `first` to `last` of a curve, negative for pre-images, each no farther than `tolerance` from its
    polygon. The vertices given stay. Images further out are left out where points run out. Raises UsageError, DataError,
    Cancelled.
    """
    made = system_of(system)
    with watching(progress, "image") as callback:
        found = _lober.curve_images(
            made._of,
            points_of(curve),
            closed,
            first,
            last,
            tolerance,
            max_length,
            max_points,
            box,
            threads,
            callback,
        )
    for entry in found:
        entry["diagnostics"] = [GrowthDiagnostic(*one) for one in entry["diagnostics"]]
    return [Image(**entry) for entry in found]


def image(system: Any, curve: Any, iterates: int = 1, *, tolerance: float = 1e-5, **options: Any) -> Image:
    """The image of a curve under `iterates` steps. Options as `images`. Raises DataError where points run out."""
    found = images(system, curve, iterates, iterates, tolerance=tolerance, **options)
    return found[0]


def section(
    system: Any,
    starts: Any = None,
    *,
    iterates: int = 1000,
    orbits: int = 1000,
    box: Box | None = None,
    lifted: bool = False,
    threads: int = 0,
    progress: Progress = None,
) -> NDArray[np.float64]:
    """Orbits of the planar map, an array of orbits x (iterates + 1) x 2; NaN from where an orbit is lost.

    Orbits start at the points `starts`, or at `orbits` points spread evenly over the box (default: `System.picture`).
    Points of a map that repeats itself after a shift are shifted into one cell from the left side of the box on, unless
    `lifted`. Raises UsageError, Cancelled.
    """
    settings = {"orbits": orbits, "iterates": iterates, "box": box, "lifted": lifted}
    points = None if starts is None else points_of(starts, "starts")
    found, _ = call("section", [system_input(system), *([] if points is None else [points])], settings, threads, progress)
    followed: NDArray[np.float64] = found["orbits"].reshape(-1, iterates + 1, 2)
    return followed
