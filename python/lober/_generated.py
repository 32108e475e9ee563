"""Functions of operations, written by _generate.py from the engine's table. Not to be edited."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np
from numpy.typing import NDArray

from ._agreement import Agreement, agreement_of
from ._call import call
from ._measured import Measured
from ._progress import Progress
from ._systems import Box, Pair


@dataclass(frozen=True)
class LevelsSaddles:
    """Of the flow at that time, near the ends of its connections or in the bottlenecks of its well. A column each."""

    #: Where it is (unit: length).
    at: NDArray[np.float64]
    #: Its energy (unit: energy).
    energy: NDArray[np.float64]

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "LevelsSaddles":
        return cls(
            at=v["at"],
            energy=v["energy"],
        )


@dataclass(frozen=True)
class LevelsLevels:
    """By value, ascending. A column each."""

    #: Value of the level (unit: energy).
    energy: NDArray[np.float64]
    #: Saddle that the level goes through (unit: length).
    saddle: NDArray[np.float64]
    #: Number of curves.
    curves: NDArray[Any]
    #: Number of those that are closed.
    closed: NDArray[Any]
    #: Number of points of all.
    points: NDArray[Any]
    #: The curves, closed ones with their first point again, each with a NaN behind it (unit: length).
    outline: list[NDArray[np.float64]]

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "LevelsLevels":
        return cls(
            energy=v["energy"],
            saddle=v["saddle"],
            curves=v["curves"],
            closed=v["closed"],
            points=v["points"],
            outline=v["outline"],
        )


@dataclass(frozen=True)
class Levels:
    """What `levels` returns."""

    #: Of the flow at that time, near the ends of its connections or in the bottlenecks of its well.
    saddles: LevelsSaddles
    #: By value, ascending.
    levels: LevelsLevels

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "Levels":
        return cls(
            saddles=LevelsSaddles._of(v["saddles"]),
            levels=LevelsLevels._of(v["levels"]),
        )


def levels(
    system: Any,
    *,
    at: Sequence[float] | None = None,
    number: int = 24,
    energy: float | None = None,
    time: float = 0.0,
    box: Box | None = None,
    grid: Pair | None = None,
    threads: int = 0,
    progress: Progress = None,
) -> Levels:
    """Computes level curves of the energy of a flow: streamlines of a planar flow with those through its saddles,
    curves of equal potential and Hill's region of a flow of two degrees of freedom.

    `system` is a system or its name. Raises UsageError, DataError, Cancelled.

    at: values of the levels, with commas between; default: as many as the number of levels says
    number: number of levels, at values that divide the cells of the grid evenly; those through saddles come on
        top
    energy: energy of Hill's region: where the potential exceeds it no motion is possible (flows of two degrees
        of freedom); default: the other levels
    time: time at which a forced flow is looked at
    box: corners of the box that is looked at, x0 < x1 and y0 < y1; default: the system's window and saddles for
        a planar flow, a square about the origin with the saddles else
    grid: pair of numbers of cells, across and up; details smaller than a cell are missed; default: 480, and as
        many up as make them square
    """
    settings = {
        "at": at,
        "number": number,
        "energy": energy,
        "time": time,
        "box": box,
        "grid": grid,
    }
    return Levels._of(call("levels", system, settings, threads, progress)[0])


@dataclass(frozen=True)
class SweepRows:
    """A value each. A column each."""

    #: Of the parameter.
    value: NDArray[np.float64]
    #: Why there is no result.
    failure: list[str | None]
    #: Saddle of U (unit: length).
    from_: NDArray[np.float64]
    #: Saddle of S (unit: length).
    to: NDArray[np.float64]
    #: Multiplier of U at its saddle.
    eigenvalue: NDArray[np.float64]
    #: Number of pips from one to its image.
    period: NDArray[Any]
    #: Of the lobes of the turnstile by geometry, signed (unit: area).
    areas: list[NDArray[np.float64]]
    #: Their error bars (unit: area).
    errors: list[NDArray[np.float64]]
    #: Of the lobes of the turnstile by action, signed; empty where the map has none (unit: area).
    areas_by_action: list[NDArray[np.float64]]
    #: Of what leaves in one iterate (unit: area).
    flux12: Measured
    #: Of what enters in one iterate (unit: area).
    flux21: Measured
    #: Sum of the lobes that leave, each counted fully (unit: area).
    lobe_area12: Measured
    #: Sum of the lobes that enter, each counted fully (unit: area).
    lobe_area21: Measured
    #: The same by action (unit: area).
    lobe_area12_by_action: NDArray[np.float64]
    #: The same by action (unit: area).
    lobe_area21_by_action: NDArray[np.float64]
    #: Why there is no flux.
    remark: list[str | None]
    #: W(q) - W(q'), q' the pip half an iterate before q (unit: area).
    difference: NDArray[np.float64]
    #: Whether the pips are those of the row before, followed from there.
    follows: NDArray[Any]
    #: Of the lobes of one side to first order (unit: area).
    first_order: NDArray[np.float64]

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "SweepRows":
        return cls(
            value=v["value"],
            failure=v["failure"],
            from_=v["from"],
            to=v["to"],
            eigenvalue=v["eigenvalue"],
            period=v["period"],
            areas=v["areas"],
            errors=v["errors"],
            areas_by_action=v["areas_by_action"],
            flux12=Measured(*(v["flux12"] or (np.nan, np.nan))),
            flux21=Measured(*(v["flux21"] or (np.nan, np.nan))),
            lobe_area12=Measured(*(v["lobe_area12"] or (np.nan, np.nan))),
            lobe_area21=Measured(*(v["lobe_area21"] or (np.nan, np.nan))),
            lobe_area12_by_action=v["lobe_area12_by_action"],
            lobe_area21_by_action=v["lobe_area21_by_action"],
            remark=v["remark"],
            difference=v["difference"],
            follows=v["follows"],
            first_order=v["first_order"],
        )


@dataclass(frozen=True)
class SweepZeros:
    """Of the difference. A column each."""

    #: The values that it lies between.
    between: list[NDArray[np.float64]]
    #: Of the parameter.
    value: NDArray[np.float64]
    #: Within which it is known.
    width: NDArray[np.float64]
    #: What is left there (unit: area).
    difference: NDArray[np.float64]
    #: Further values that it took.
    evaluations: NDArray[Any]
    #: Why it could not be refined.
    failure: list[str | None]

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "SweepZeros":
        return cls(
            between=v["between"],
            value=v["value"],
            width=v["width"],
            difference=v["difference"],
            evaluations=v["evaluations"],
            failure=v["failure"],
        )


@dataclass(frozen=True)
class Sweep:
    """What `sweep` returns."""

    #: Name of the parameter.
    parameter: str | None
    #: A value each.
    rows: SweepRows
    #: Of the difference.
    zeros: SweepZeros
    #: Why none was found, where they were looked for.
    no_zero: str | None
    #: Number of values without a result.
    failures: int
    #: What to know of the result.
    remarks: list[str]
    #: By independent routes.
    agreement: Agreement

    @classmethod
    def _of(cls, v: dict[str, Any], comparisons: list[tuple[Any, ...]]) -> "Sweep":
        return cls(
            parameter=v["parameter"],
            rows=SweepRows._of(v["rows"]),
            zeros=SweepZeros._of(v["zeros"]),
            no_zero=v["no_zero"],
            failures=v["failures"],
            remarks=v["remarks"],
            agreement=agreement_of(comparisons),
        )


def sweep(
    system: Any,
    *,
    range: str,
    tolerance: float = 1e-05,
    max_points: int = 20000000,
    find_zeros: bool = False,
    melnikov: bool = False,
    from_: Pair | None = None,
    to: Pair | None = None,
    u_direction: Pair | None = None,
    s_direction: Pair | None = None,
    bip: Pair | None = None,
    threads: int = 0,
    progress: Progress = None,
) -> Sweep:
    """Computes the areas of the turnstile for the values FIRST to LAST of a parameter, in steps of STEP, and where the
    flux changes sides.

    `system` is a system or its name. Raises UsageError, DataError, Cancelled.

    range: parameter and its values, NAME=FIRST:LAST:STEP
    tolerance: maximum distance between a manifold and its polygon, in units of the coordinates; errors of areas
        are far smaller
    max_points: maximum number of points of each manifold
    find_zeros: whether to refine the values of the parameter at which the difference in action of the two pips
        of the turnstile changes its sign
    melnikov: whether to compute the areas of lobes to first order in the parameter that is the size of the
        system's perturbation (eps), by Melnikov's function, for every value
    from_: point near the saddle of the unstable manifold, in the coordinates of the map; default: the system's
    to: point near the saddle of the stable manifold, in the coordinates of the map; default: that of from, a
        period of the plane farther where that is the system's own saddle and its tangle leads there, or the
        system's
    u_direction: vector roughly along the unstable manifold, away from its saddle; default: the system's
    s_direction: vector roughly along the stable manifold, away from its saddle; default: the system's
    bip: point near the boundary intersection point, the pip at which the boundary passes from U to S; default:
        the system's, or the middle pip
    """
    settings = {
        "range": range,
        "tolerance": tolerance,
        "max_points": max_points,
        "find_zeros": find_zeros,
        "melnikov": melnikov,
        "from": from_,
        "to": to,
        "u_direction": u_direction,
        "s_direction": s_direction,
        "bip": bip,
    }
    return Sweep._of(*call("sweep", system, settings, threads, progress))
