"""Fixed points, manifolds, images of curves, sections."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Iterator

import numpy as np
from numpy.typing import NDArray

from . import _lober
from ._areas import html_table
from ._arrays import Points
from ._call import Run
from ._result import Result
from ._systems import Box, Pair, pair_of, system_of


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


@dataclass(frozen=True, repr=False)
class FixedPoints(Result):
    """The points in a box, sorted by period, x, y."""

    points: list[FixedPoint]
    #: Whether the last scan found what the one before had found and no index contradicts it.
    settled: bool
    #: False where fixed points fill a curve or an area: `points` are then some of them.
    isolated: bool
    grid: int
    index_sum: int
    index_of_box: int | None
    box: Box

    @classmethod
    def _of(cls, run: Run) -> FixedPoints:
        points, search = run.value["points"], run.value["search"]
        return cls(
            [_point_of({key: column[k] for key, column in points.items()}) for k in range(len(points["type"]))],
            search["settled"],
            search["isolated"],
            search["grid"],
            search["index_sum"],
            search["index_of_box"],
            run.of.chosen()["box"],
        )

    def __repr__(self) -> str:
        some = [f"{point.type} of period {point.period} at {point.at}" for point in self.points[:4]]
        return f"<FixedPoints: {len(self.points)}: {'; '.join(some)}{'; ...' if len(self.points) > 4 else ''}>"

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
    return FixedPoint(*_lober.fixed_point(system_of(system)._of, pair_of(near, "near"), period, turns))


@dataclass(frozen=True)
class GrowthDiagnostic:
    """Segments first, ..., first + count - 1 that do not meet the tolerance: failed, spacing, max_rounds, left_box."""

    first: int
    count: int
    cause: str


@dataclass(frozen=True, repr=False)
class Manifold(Result):
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

    @classmethod
    def _of(cls, run: Run) -> Manifold:
        found = run.value
        grown, local, diagnostics = found["result"], found["local_manifold"], found["diagnostics"]["list"]
        return cls(
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

    def __repr__(self) -> str:
        generations = len(self.generation_begin) - 1
        size = f"{len(self.points)} points of {generations} generations, length {self.length:.15g}"
        return f"<Manifold: from {self.saddle}, {size}, ended by {self.stop}, {len(self.diagnostics)} diagnostics>"


@dataclass(frozen=True, repr=False)
class Image:
    """The image of a curve under `iterate` steps.

    `parameters` has for each point the number of the segment of the original plus a fraction. Where the map fails, `parts`
    has the pieces as (points, closed); else the whole.
    """

    points: Points
    parameters: NDArray[np.float64]
    closed: bool
    iterate: int
    #: 1 for the second boundary of a cylinder, else 0.
    curve: int
    diagnostics: list[GrowthDiagnostic]
    stop: str
    images: int
    parts: list[tuple[Points, bool]]

    def __repr__(self) -> str:
        kind = "closed" if self.closed else "open"
        parts = f" in {len(self.parts)} parts" if len(self.parts) > 1 else ""
        return f"<Image: iterate {self.iterate}, {len(self.points)} points{parts}, {kind}, {len(self.diagnostics)} diagnostics>"


def images_of(run: Run) -> list[Image]:
    found = _lober.images_of(run.of)
    for entry in found:
        entry["diagnostics"] = [GrowthDiagnostic(*one) for one in entry["diagnostics"]]
    return [Image(**entry) for entry in found]


def orbits_of(run: Run) -> NDArray[np.float64]:
    followed: NDArray[np.float64] = run.value["orbits"].reshape(-1, run.options["iterates"] + 1, 2)
    return followed
