"""Functions of operations, written by _generate.py from the engine's table. Not to be edited."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np
from numpy.typing import NDArray

from ._agreement import Agreement, agreement_of
from ._call import run
from ._dynamics import FixedPoints, Image, Manifold, images_of, orbits_of
from ._measured import Measured
from ._overlay import Interior, Overlay
from ._progress import Progress
from ._numbers import seed_of
from ._regions import Regions
from ._result import Result, kept
from ._systems import Box, Connection, Pair
from ._tangle import Tangle
from ._transport import Escape, SystemTangle, Transport

__all__ = [
    "CurveTransport",
    "Densify",
    "Levels",
    "Simplify",
    "Sweep",
    "curve_transport",
    "densify",
    "escape",
    "fixed_points",
    "grow",
    "images",
    "interior",
    "levels",
    "manifold_tangle",
    "overlay",
    "regions",
    "section",
    "simplify",
    "sweep",
    "tangle",
    "transport",
]


@dataclass(frozen=True)
class CurveTransportRegions:
    """R1, R2. A column each."""

    #: Whether it is.
    bounded: NDArray[Any]
    #: Not known where it is not bounded (unit: area).
    area: Measured

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "CurveTransportRegions":
        return cls(
            bounded=v["bounded"],
            area=Measured(*(v["area"] or (np.nan, np.nan))),
        )


@dataclass(frozen=True)
class CurveTransportTurnstile:
    """Lobes and fluxes."""

    #: Area that leaves the region inside in one step (unit: area).
    flux12: Measured
    #: Area that enters the region inside in one step (unit: area).
    flux21: Measured
    #: Sum of the lobes that leave, each counted fully (unit: area).
    lobe_area12: Measured
    #: Sum of the lobes that enter, each counted fully (unit: area).
    lobe_area21: Measured

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "CurveTransportTurnstile":
        return cls(
            flux12=Measured(*(v["flux12"] or (np.nan, np.nan))),
            flux21=Measured(*(v["flux21"] or (np.nan, np.nan))),
            lobe_area12=Measured(*(v["lobe_area12"] or (np.nan, np.nan))),
            lobe_area21=Measured(*(v["lobe_area21"] or (np.nan, np.nan))),
        )


@dataclass(frozen=True)
class CurveTransportStepsOverlaps:
    """Common areas of the lobes of the first turnstile with images of its lobes. A column each."""

    #: Common area of L12(1) and f^(n-1) L12(1) (unit: area).
    L12_L12: NDArray[np.float64]
    #: Common area of L12(1) and f^(n-1) L21(1) (unit: area).
    L12_L21: NDArray[np.float64]
    #: Common area of L21(1) and f^(n-1) L12(1) (unit: area).
    L21_L12: NDArray[np.float64]
    #: Common area of L21(1) and f^(n-1) L21(1) (unit: area).
    L21_L21: NDArray[np.float64]

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "CurveTransportStepsOverlaps":
        return cls(
            L12_L12=v["L12_L12"],
            L12_L21=v["L12_L21"],
            L21_L12=v["L21_L12"],
            L21_L21=v["L21_L21"],
        )


@dataclass(frozen=True)
class CurveTransportSteps:
    """N = 1, 2, ... A column each."""

    #: Iterates.
    n: NDArray[Any]
    #: A21(n) (unit: area).
    a: Measured
    #: T21(n) by lobes (unit: area).
    T: Measured
    #: Common area of L12(1) and f^(n-1) L21(1) (unit: area).
    overlap: NDArray[np.float64]
    #: T21(n) by boundaries (unit: area).
    T_by_boundaries: Measured
    #: |T21(n) by lobes - by boundaries| (unit: area).
    consistency: NDArray[np.float64]
    #: A12(n) = T12(n) - T12(n - 1) (unit: area).
    a12: Measured
    #: A21(n) = T21(n) - T21(n - 1) (unit: area).
    a21: Measured
    #: Area of the fluid from R1 that is in R2 after n iterates, by lobes (unit: area).
    T12: Measured
    #: Area of the fluid from R2 that is in R1 after n iterates, by lobes (unit: area).
    T21: Measured
    #: Common areas of the lobes of the first turnstile with images of its lobes.
    overlaps: CurveTransportStepsOverlaps
    #: T21(n) counted, with one standard deviation (unit: area).
    T_by_particles: Measured
    #: A_ij(n) of all regions, by lobes (unit: area).
    a_ij: Measured
    #: T_ij(n) of all regions, by lobes (unit: area).
    T_ij: Measured
    #: T_ij(n) of all regions, by boundaries (unit: area).
    T_ij_by_boundaries: Measured
    #: T_ij(n) counted, with one standard deviation (unit: area).
    T_ij_by_particles: Measured

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "CurveTransportSteps":
        return cls(
            n=v["n"],
            a=Measured(*(v["a"] or (np.nan, np.nan))),
            T=Measured(*(v["T"] or (np.nan, np.nan))),
            overlap=v["overlap"],
            T_by_boundaries=Measured(*(v["T_by_boundaries"] or (np.nan, np.nan))),
            consistency=v["consistency"],
            a12=Measured(*(v["a12"] or (np.nan, np.nan))),
            a21=Measured(*(v["a21"] or (np.nan, np.nan))),
            T12=Measured(*(v["T12"] or (np.nan, np.nan))),
            T21=Measured(*(v["T21"] or (np.nan, np.nan))),
            overlaps=CurveTransportStepsOverlaps._of(v["overlaps"]),
            T_by_particles=Measured(*(v["T_by_particles"] or (np.nan, np.nan))),
            a_ij=Measured(*(v["a_ij"] or (np.nan, np.nan))),
            T_ij=Measured(*(v["T_ij"] or (np.nan, np.nan))),
            T_ij_by_boundaries=Measured(*(v["T_ij_by_boundaries"] or (np.nan, np.nan))),
            T_ij_by_particles=Measured(*(v["T_ij_by_particles"] or (np.nan, np.nan))),
        )


@dataclass(frozen=True)
class CurveTransportStop:
    """Why there are fewer rows than were asked for."""

    #: Curves: they reach no farther.
    reason: str | None
    #: The reason in words.
    why: str | None

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "CurveTransportStop":
        return cls(
            reason=v["reason"],
            why=v["why"],
        )


@dataclass(frozen=True)
class CurveTransportError:
    """Error bars of T21(n) and the checks that support them."""

    #: Estimate of |T - true T| by lobes, integration and rounding included; worst step (unit: area).
    discretisation: float
    #: The same by boundaries (unit: area).
    boundaries: float
    #: |T by lobes - T by boundaries|; worst step (unit: area).
    consistency: float
    #: |flux12 - flux21| of the turnstile, by geometry (unit: area).
    area_conservation: float

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "CurveTransportError":
        return cls(
            discretisation=v["discretisation"],
            boundaries=v["boundaries"],
            consistency=v["consistency"],
            area_conservation=v["area_conservation"],
        )


@dataclass(frozen=True, repr=False)
class CurveTransport(Result):
    """The result of `curve_transport`."""

    #: Number of pips from one to its image.
    period: int
    #: R1, R2.
    regions: CurveTransportRegions
    #: Area that the boundary encloses; where it crosses itself, of what it winds round (unit: area).
    enclosed: Measured
    #: Lobes and fluxes.
    turnstile: CurveTransportTurnstile | None
    #: N = 1, 2, ...
    steps: CurveTransportSteps
    #: Why there are fewer rows than were asked for.
    stop: CurveTransportStop | None
    #: Remarks on the result.
    remarks: list[str]
    #: Error bars of T21(n) and the checks that support them.
    error: CurveTransportError | None
    #: By independent routes.
    agreement: Agreement

    @classmethod
    def _of(cls, v: dict[str, Any], comparisons: list[tuple[Any, ...]]) -> "CurveTransport":
        return cls(
            period=v["period"],
            regions=CurveTransportRegions._of(v["regions"]),
            enclosed=Measured(*(v["enclosed"] or (np.nan, np.nan))),
            turnstile=None if v["turnstile"] is None else CurveTransportTurnstile._of(v["turnstile"]),
            steps=CurveTransportSteps._of(v["steps"]),
            stop=None if v["stop"] is None else CurveTransportStop._of(v["stop"]),
            remarks=v["remarks"],
            error=None if v["error"] is None else CurveTransportError._of(v["error"]),
            agreement=agreement_of(comparisons),
        )


def curve_transport(
    u: Any,
    s: Any,
    *,
    iterates: int | None = None,
    bip: int | None = None,
    period: int | None = None,
    bip_near: Pair | None = None,
    closure: Sequence[float] | None = None,
    index: str = 'auto',
    check_simple: bool = True,
    threads: int = 0,
    progress: Progress = None,
) -> CurveTransport:
    """Computes the transport across the boundary of two manifolds that are given as curves: the fluxes a(n) and T(n)
    by lobes and by boundaries, for as many n as there are images of the bip on the curves. No map is needed.

    `u`: the unstable manifold, outward from its fixed point; `s`: the stable manifold, outward from its fixed
    point. Curves and points are arrays of N x 2 numbers, complex vectors, or polygons of shapely; the last point of
    a closed curve is joined to the first. Arrays of doubles of more than a megabyte are not copied and must not
    change while the result is in use. Raises UsageError, DataError, Cancelled.

    iterates: number of iterates n up to which the table goes, or as far as the curves reach; n takes n images
        of the bip on them; default: as far as the curves reach
    bip: number of the boundary intersection point, the pip at which the boundary passes from U to S, from 0;
        default: the pip nearest to bip_near, or the middle one
    period: number of pips from one to its image, at most the number of lobes, and even where lobes alternate;
        default: inferred from the areas
    bip_near: point near it; default: none
    closure: corners of the path that closes the boundary, from the fixed point of S to that of U; default: the
        straight line
    index: index that proposes which segments can meet; the results do not depend on it
    check_simple: whether to refuse manifolds that cross or touch themselves
    """
    settings = {
        "iterates": iterates,
        "bip": bip,
        "period": period,
        "bip_near": bip_near,
        "closure": closure,
        "index": index,
        "check_simple": check_simple,
    }
    ran = run("curve_transport", (u, s), settings, threads, progress)
    return kept(CurveTransport._of(ran.value, ran.comparisons), ran)


@dataclass(frozen=True)
class DensifySteps:
    """The steps in order. A column each."""

    #: Simplify, criteria, passes or crossings.
    step: list[str | None]
    #: Number of points after the step.
    points: NDArray[Any]
    #: Number of rounds in which points were inserted or removed.
    rounds: NDArray[Any]

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "DensifySteps":
        return cls(
            step=v["step"],
            points=v["points"],
            rounds=v["rounds"],
        )


@dataclass(frozen=True)
class DensifyResult:
    """The resulting curve."""

    #: Number of points.
    points: int
    #: Whether the last point is joined to the first one.
    closed: bool

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "DensifyResult":
        return cls(
            points=v["points"],
            closed=v["closed"],
        )


@dataclass(frozen=True)
class DensifyAgainst:
    """The other curve with the crossings inserted."""

    #: Number of points.
    points: int
    #: Whether the last point is joined to the first one.
    closed: bool

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "DensifyAgainst":
        return cls(
            points=v["points"],
            closed=v["closed"],
        )


@dataclass(frozen=True)
class DensifyDiagnosticsCounts:
    """Number of places by cause, for each cause that occurs."""

    #: Number of places.
    min_length: int
    #: Number of places.
    corner: int
    #: Number of places.
    max_points: int
    #: Number of places.
    max_rounds: int

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "DensifyDiagnosticsCounts":
        return cls(
            min_length=v["min_length"],
            corner=v["corner"],
            max_points=v["max_points"],
            max_rounds=v["max_rounds"],
        )


@dataclass(frozen=True)
class DensifyDiagnosticsList:
    """Places in order along the result; empty where a later step has changed the numbers of segments. A column each."""

    #: Number of the first segment, from 0.
    segment: NDArray[Any]
    #: Number of segments, at least one of which breaks a criterion.
    count: NDArray[Any]
    #: Min_length, corner, max_points or max_rounds.
    cause: list[str | None]

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "DensifyDiagnosticsList":
        return cls(
            segment=v["segment"],
            count=v["count"],
            cause=v["cause"],
        )


@dataclass(frozen=True)
class DensifyDiagnostics:
    """Segments that do not meet the criteria."""

    #: Number of places by cause, for each cause that occurs.
    counts: DensifyDiagnosticsCounts | None
    #: Number of segments in all places.
    segments: int
    #: Places in order along the result; empty where a later step has changed the numbers of segments.
    list: DensifyDiagnosticsList

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "DensifyDiagnostics":
        return cls(
            counts=None if v["counts"] is None else DensifyDiagnosticsCounts._of(v["counts"]),
            segments=v["segments"],
            list=DensifyDiagnosticsList._of(v["list"]),
        )


@dataclass(frozen=True, repr=False)
class Densify(Result):
    """The result of `densify`."""

    #: The steps in order.
    steps: DensifySteps
    #: Number of rounds of all steps.
    rounds: int
    #: Number of points of the curve given.
    given: int
    #: The resulting curve.
    result: DensifyResult | None
    #: Signed area, positive for a counter-clockwise curve; for an open one that of the polygon that its ends close
    #: (unit: area).
    signed_area: float
    #: Points of the result (unit: length).
    points: NDArray[np.float64]
    #: The other curve with the crossings inserted.
    against: DensifyAgainst | None
    #: Points of the other curve; none where no crossings were inserted (unit: length).
    against_points: NDArray[np.float64]
    #: Segments that do not meet the criteria.
    diagnostics: DensifyDiagnostics | None

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "Densify":
        return cls(
            steps=DensifySteps._of(v["steps"]),
            rounds=v["rounds"],
            given=v["given"],
            result=None if v["result"] is None else DensifyResult._of(v["result"]),
            signed_area=v["signed_area"],
            points=v["points"],
            against=None if v["against"] is None else DensifyAgainst._of(v["against"]),
            against_points=v["against_points"],
            diagnostics=None if v["diagnostics"] is None else DensifyDiagnostics._of(v["diagnostics"]),
        )


def densify(
    curve: Any,
    against: Any = None,
    *,
    closed: bool = True,
    closed_against: bool = True,
    simplify: float | None = None,
    max_length: float | None = None,
    hobson: bool = False,
    angle: float | None = None,
    distance_angle: float | None = None,
    min_length: float | None = None,
    passes: int = 0,
    points: int = 0,
    crossings: bool = False,
    interpolation: str | None = None,
    max_points: int = 100000000,
    threads: int = 0,
    progress: Progress = None,
) -> Densify:
    """Inserts points into a curve, or removes them: first simplify, then the criteria (max_length, hobson, angle,
    distance_angle), then passes, then crossings.

    `curve`: a curve; `against`: another curve, for passes and crossings. Curves and points are arrays of N x 2
    numbers, complex vectors, or polygons of shapely; the last point of a closed curve is joined to the first.
    Arrays of doubles of more than a megabyte are not copied and must not change while the result is in use. Raises UsageError, DataError, Cancelled.

    closed: whether to join the last vertex of the curve to the first
    closed_against: whether to join the last vertex of the other curve to the first
    simplify: maximum distance of a removed vertex from the curve that remains, in units of the coordinates;
        vertices are removed before all other steps; default: no vertex is removed
    max_length: maximum length of a segment (tau), in units of the coordinates; longer segments are split, and
        none is made by the removal of vertices; default: no maximum
    hobson: whether to use the angle criteria of Hobson and of Mancho et al., with limits relative to the size
        of the curve, which is the longer side of its bounding box
    angle: maximum angle between consecutive segments, in radians; default: no maximum; with hobson 0.3
    distance_angle: maximum product of the length of a segment and the angles at its ends, in units of the
        coordinates; default: no maximum; with hobson 1e-3 of the size
    min_length: minimum length of a segment (delta), in units of the coordinates; no segment is split into
        shorter ones; default: 0; with angle criteria 1e-6 of the size
    passes: number of passes that refine the curve where it meets the other one
    points: number of points that each pass inserts into a segment that meets the other curve
    crossings: whether to insert a vertex wherever the curves meet
    interpolation: interpolation between the vertices; default: linear; with angle criteria dritschel
    max_points: maximum number of points of the result
    """
    settings = {
        "closed": closed,
        "closed_against": closed_against,
        "simplify": simplify,
        "max_length": max_length,
        "hobson": hobson,
        "angle": angle,
        "distance_angle": distance_angle,
        "min_length": min_length,
        "passes": passes,
        "points": points,
        "crossings": crossings,
        "interpolation": interpolation,
        "max_points": max_points,
    }
    ran = run("densify", (curve, against), settings, threads, progress)
    return kept(Densify._of(ran.value), ran)


def escape(
    system: Any,
    *,
    energy: float | None = None,
    crossings: int = 4,
    saddle: str | None = None,
    section: str | None = None,
    direction: str | None = None,
    bound: str | None = None,
    tolerance: float = 1e-06,
    max_points: int = 2000000,
    max_work: float = 1000000000.0,
    budget: float | None = None,
    monte_carlo: int = 2000,
    seed: int = 1,
    rng: Any = None,
    threads: int = 0,
    progress: Progress = None,
) -> Escape:
    """Computes the escape from a potential well: the periodic orbits of its bottlenecks, their tubes on a section, and
    the fraction of the trajectories entering by one bottleneck that leave by another after n crossings.

    `system` is a system or its name. Raises UsageError, DataError, Cancelled.

    energy: total energy, above that of the saddles; default: the parameter energy of the system
    crossings: number of crossings of the section up to which the table goes; with 0 only the orbits, the tubes
        and their first crossings are computed
    saddle: saddles of the potential, with semicolons between: the number of each among those of the system,
        from 1, or a position near it, or four coordinates; default: all saddles of the system
    section: section, x=VALUE or y=VALUE, where x and y are the coordinates of position; default: the section of
        the system
    direction: sign of the velocity of the crossings that count: +, - or, with no crossings, both; default: that
        of the system's section, or + with a section of one's own; with no crossings both, unless the section has a
        bound
    bound: part of the section whose crossings count, for example x<-1 or y>0, with no crossings only; default:
        that of the system, or the whole section with a section of one's own
    tolerance: maximum distance between a curve and its polygon, relative to the square root of the area of the
        smallest entrance
    max_points: maximum number of points of a curve; the table ends before an image that is expected to need
        more
    max_work: work that the table may take, in evaluations of the vector field, where no time is given
    budget: wall-clock time that the table may take, in seconds; it ends before images that are expected to end
        later, and those that do not end as expected are broken off; default: a limit on the work instead, which
        gives the same table on every machine
    monte_carlo: number of trajectories to follow from each entrance, as a check of the table; 0: none
    seed: seed of the random numbers of these trajectories
    rng: what numpy.random.default_rng takes, from which the seed is drawn, in place of one
    """
    settings = {
        "energy": energy,
        "crossings": crossings,
        "saddle": saddle,
        "section": section,
        "direction": direction,
        "bound": bound,
        "tolerance": tolerance,
        "max_points": max_points,
        "max_work": max_work,
        "budget": budget,
        "monte_carlo": monte_carlo,
        "seed": seed_of(seed, 1, rng),
    }
    ran = run("escape", (system,), settings, threads, progress)
    return kept(Escape._of(ran), ran)


def fixed_points(
    system: Any,
    *,
    box: Box | None = None,
    period: int = 1,
    turns: int = 0,
    grid: int = 48,
    max_grid: int = 384,
    budget: float | None = None,
    threads: int = 0,
    progress: Progress = None,
) -> FixedPoints:
    """Finds the fixed and periodic points of a map, or of a flow's Poincare map, in a box, with their multipliers,
    residues and types.

    `system` is a system or its name. Raises UsageError, DataError, Cancelled.

    box: corners of the box that is searched, x0 < x1 and y0 < y1, in the coordinates of the map; default: the
        system's window
    period: period, in iterates of the map; points whose least period divides it are found too
    turns: number of shifts of the plane, of those after which the system repeats, by which a point moves in a
        period: the turns of a lifted angle
    grid: number of points a side of the grid of the first scan; each further one has twice as many
    max_grid: number of points a side of the grid of the last scan
    budget: wall-clock time that the search may take, in seconds; points found by then are in the result;
        default: a limit on the work instead, of some seconds on one core, which gives the same points on every
        machine
    """
    settings = {
        "box": box,
        "period": period,
        "turns": turns,
        "grid": grid,
        "max_grid": max_grid,
        "budget": budget,
    }
    ran = run("fixed_points", (system,), settings, threads, progress)
    return kept(FixedPoints._of(ran), ran)


def grow(
    system: Any,
    side: str = 'unstable',
    *,
    from_: Pair | None = None,
    branch: str | None = None,
    period: int = 1,
    turns: int = 0,
    tolerance: float | None = None,
    iterates: int | None = None,
    length: float | None = None,
    max_length: float | None = None,
    box: Box | None = None,
    max_points: int = 100000000,
    max_memory: int | None = None,
    max_work: float = 1000000000.0,
    threads: int = 0,
    progress: Progress = None,
) -> Manifold:
    """Grows a branch of the stable or unstable manifold of a saddle of a map, or of a flow's Poincare map, to a
    tolerance.

    `system` is a system or its name. Raises UsageError, DataError, Cancelled.

    side: side of the saddle whose manifold is grown
    from_: point near the saddle, in the coordinates of the map; default: the saddle of the system's tangle, or
        else the only saddle in the system's window
    branch: branch of the manifold; + leaves the saddle to the right, - to the left, or up and down if the
        tangent is vertical; or a vector X,Y roughly along it; default: the branch of the system's tangle, or else +
    period: least period of the saddle, in iterates of the map
    turns: number of shifts of the plane, of those after which the system repeats, by which a point moves in a
        period: the turns of a lifted angle
    tolerance: maximum distance between the manifold and its polygon, in units of the coordinates; default: 1e-5
        times the power of ten in the extent of the system's window: 1e-5 for the built-in systems
    iterates: number of images of the local manifold after which growing ends; default: no limit, and there has
        to be a length
    length: arc length of the manifold, without parts outside the box, at which growing ends, in units of the
        coordinates; default: no limit, and there have to be iterates
    max_length: maximum length of a segment, in units of the coordinates; default: 1/50 of the extent of the
        local manifold
    box: corners of the box in which the tolerance holds; outside it the manifold is followed coarsely, and what
        comes back may be wrong or missing; default: a square around the saddle, 200 extents of the local manifold
        wide
    max_points: maximum number of points, at which growing ends
    max_memory: memory in bytes at which growing ends; default: no limit
    max_work: maximum work, in evaluations of the vector field, or in steps of a map that is given by formulas
    """
    settings = {
        "side": side,
        "from": from_,
        "branch": branch,
        "period": period,
        "turns": turns,
        "tolerance": tolerance,
        "iterates": iterates,
        "length": length,
        "max_length": max_length,
        "box": box,
        "max_points": max_points,
        "max_memory": max_memory,
        "max_work": max_work,
    }
    ran = run("grow", (system,), settings, threads, progress)
    return kept(Manifold._of(ran), ran)


def images(
    system: Any,
    curve: Any = None,
    first: int = 1,
    last: int | None = None,
    *,
    closed: bool = True,
    circle: Sequence[float] | None = None,
    rectangle: Box | None = None,
    boundary: bool = False,
    tolerance: float | None = None,
    max_length: float | None = None,
    box: Box | None = None,
    max_points: int = 100000000,
    max_work: float = 1000000000.0,
    threads: int = 0,
    progress: Progress = None,
) -> list[Image]:
    """Computes images and pre-images of a curve under a map, or a flow's Poincare map, to a tolerance.

    `system` is a system or its name; `curve`: a curve, in place of a circle, a rectangle or the boundary. Curves
    and points are arrays of N x 2 numbers, complex vectors, or polygons of shapely; the last point of a closed
    curve is joined to the first. Arrays of doubles of more than a megabyte are not copied and must not change while
    the result is in use. Raises UsageError, DataError, Cancelled.

    closed: whether to join the last vertex of the curve to the first
    circle: circle about X,Y of radius R, in the coordinates of the map, counter-clockwise, which is followed as
        a circle, not as a polygon; default: the curve given
    rectangle: corners of a rectangle, which is followed counter-clockwise; default: the curve given
    boundary: whether to follow the boundary that the system's tangle makes, from its manifolds: U up to the
        boundary intersection point and S from there; on a cylinder the upper and the lower one
    first: number of iterates of the first image; negative ones are pre-images
    last: number of iterates of the last image; default: that of the first
    tolerance: maximum distance between an image and its polygon, in units of the coordinates; default: 1e-5
        times the power of ten in the extent of the system's window: 1e-5 for the built-in systems
    max_length: maximum length of a segment, in units of the coordinates; default: no maximum
    box: corners of the box in which the tolerance holds; outside it images are followed coarsely, and what
        comes back may be wrong or missing; default: the box of the curve and of the system's window, three times as
        wide and high
    max_points: maximum number of points of an image, at which it ends
    max_work: maximum work, in evaluations of the vector field, or in steps of a map that is given by formulas
    """
    settings = {
        "closed": closed,
        "circle": circle,
        "rectangle": rectangle,
        "boundary": boundary,
        "first": first,
        "last": last,
        "tolerance": tolerance,
        "max_length": max_length,
        "box": box,
        "max_points": max_points,
        "max_work": max_work,
    }
    ran = run("image", (system, curve), settings, threads, progress)
    return images_of(ran)


def interior(
    c1: Any,
    c2: Any,
    *,
    method: str = 'split',
    passes: int = 0,
    points: int = 0,
    index: str = 'auto',
    check_simple: bool = True,
    verify: bool = False,
    threads: int = 0,
    progress: Progress = None,
) -> Interior:
    """Computes the areas of two simple closed curves by the interior function (Q1, Q2, Q3), independently of the
    overlay.

    `c1`: a simple closed curve; `c2`: another one. Curves and points are arrays of N x 2 numbers, complex vectors,
    or polygons of shapely; the last point of a closed curve is joined to the first. Arrays of doubles of more than
    a megabyte are not copied and must not change while the result is in use. Raises UsageError, DataError, Cancelled.

    method: way in which segments are weighted; split: at the points where the curves meet; ends: by their two
        ends, as Lober 1.8 does
    passes: number of passes that insert points where the ends of a segment differ; with ends
    points: number of points that a pass inserts into such a segment; with ends
    index: index that proposes which segments can meet; the results do not depend on it
    check_simple: whether to refuse curves that are not simple
    verify: whether to compute the areas by the overlay too, and report how far the two results differ
    """
    settings = {
        "method": method,
        "passes": passes,
        "points": points,
        "index": index,
        "check_simple": check_simple,
        "verify": verify,
    }
    ran = run("interior", (c1, c2), settings, threads, progress)
    return Interior(ran)


@dataclass(frozen=True)
class LevelsSaddles:
    """Saddles of the flow at that time, near the ends of its connections or in its bottlenecks. A column each."""

    #: Position of the saddle (unit: length).
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
    """Levels by value, ascending. A column each."""

    #: Value of the level (unit: energy).
    energy: NDArray[np.float64]
    #: Saddle that the level goes through (unit: length).
    saddle: NDArray[np.float64]
    #: Number of curves.
    curves: NDArray[Any]
    #: Number of closed curves.
    closed: NDArray[Any]
    #: Number of points of all curves.
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


@dataclass(frozen=True, repr=False)
class Levels(Result):
    """The result of `levels`."""

    #: Saddles of the flow at that time, near the ends of its connections or in its bottlenecks.
    saddles: LevelsSaddles
    #: Levels by value, ascending.
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

    at: values of the levels, with commas between; default: the given number of levels
    number: number of levels, at values that divide the cells of the grid evenly; those through saddles come on
        top
    energy: energy of Hill's region: where the potential exceeds it no motion is possible (flows of two degrees
        of freedom); default: the other levels
    time: time of a forced flow
    box: corners of the box of the grid, x0 < x1 and y0 < y1; default: the system's window and saddles for a
        planar flow, a square about the origin with the saddles else
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
    ran = run("levels", (system,), settings, threads, progress)
    return kept(Levels._of(ran.value), ran)


def manifold_tangle(
    system: Any,
    connection: Connection | None = None,
    *,
    from_: Pair | None = None,
    to: Pair | None = None,
    u_direction: Pair | None = None,
    s_direction: Pair | None = None,
    bip: Pair | None = None,
    tolerance: float | None = None,
    max_points: int = 20000000,
    before: int = 1,
    after: int = 0,
    smooth: bool = True,
    max_iterates: int = 60,
    max_work: float = 100000000.0,
    budget: float | None = None,
    threads: int = 0,
    progress: Progress = None,
) -> SystemTangle:
    """Grows the unstable and the stable manifold of a system's saddles and finds their tangle: pips, lobes, boundary
    and turnstile, with areas by geometry and by action.

    `system` is a system or its name. `connection`: in place of the options that choose one. Raises UsageError, DataError, Cancelled.

    from_: point near the saddle of the unstable manifold, in the coordinates of the map; default: the system's
    to: point near the saddle of the stable manifold, in the coordinates of the map; default: that of from, a
        period of the plane farther where that is the system's own saddle and its tangle leads there, or the
        system's
    u_direction: vector roughly along the unstable manifold, away from its saddle; default: the system's
    s_direction: vector roughly along the stable manifold, away from its saddle; default: the system's
    bip: point near the boundary intersection point, the pip at which the boundary passes from U to S; default:
        the system's, or the pip halfway, up to which U is as long as S
    tolerance: maximum distance between a manifold and its polygon, which errors of areas are far smaller than,
        in units of the coordinates; default: 1e-5 times the power of ten in the extent of the system's window: 1e-5
        for the built-in systems
    max_points: maximum number of points of each manifold
    before: number of pre-images of the bip up to which manifolds are grown
    after: number of images of the bip up to which manifolds are grown
    smooth: whether to take the areas of smooth curves through the points
    max_iterates: maximum number of images of the local manifolds
    max_work: work that growing the manifolds may take, in evaluations of the vector field, where no time is
        given
    budget: wall-clock time that growing the manifolds may take, in seconds; default: a limit on the work
        instead, which gives the same result on every machine
    """
    settings = {
        "from": from_,
        "to": to,
        "u_direction": u_direction,
        "s_direction": s_direction,
        "bip": bip,
        "tolerance": tolerance,
        "max_points": max_points,
        "before": before,
        "after": after,
        "smooth": smooth,
        "max_iterates": max_iterates,
        "max_work": max_work,
        "budget": budget,
    }
    ran = run("manifold_tangle", (system,), settings, threads, progress, connection, lazy={"overlaps": False})
    return SystemTangle(ran)


def overlay(
    c1: Any,
    c2: Any,
    *,
    areas_only: bool = False,
    index: str = 'auto',
    check_simple: bool = True,
    verify: bool = False,
    threads: int = 0,
    progress: Progress = None,
) -> Overlay:
    """Computes where two simple closed curves cross, the pieces of their differences, intersection and union, and all
    areas with error bars.

    `c1`: a simple closed curve; `c2`: another one. Curves and points are arrays of N x 2 numbers, complex vectors,
    or polygons of shapely; the last point of a closed curve is joined to the first. Arrays of doubles of more than
    a megabyte are not copied and must not change while the result is in use. Raises UsageError, DataError, Cancelled.

    areas_only: whether to compute the total areas but not the pieces, which is faster
    index: index that proposes which segments can meet; the results do not depend on it
    check_simple: whether to refuse curves that are not simple
    verify: whether to compute the areas by the interior method too, and report how far the two results differ
    """
    settings = {
        "areas_only": areas_only,
        "index": index,
        "check_simple": check_simple,
        "verify": verify,
    }
    ran = run("overlay", (c1, c2), settings, threads, progress, lazy={"discretisation": False, "smooth": False, "classes": False})
    return Overlay(ran)


def regions(
    c1: Any,
    c2: Any = None,
    *,
    index: str = 'auto',
    threads: int = 0,
    progress: Progress = None,
) -> Regions:
    """Computes the area of each pair of winding numbers of one or two closed curves, which may cross themselves, and
    the areas and pieces that a rule makes of them.

    `c1`: a closed curve; `c2`: another one. Curves and points are arrays of N x 2 numbers, complex vectors, or
    polygons of shapely; the last point of a closed curve is joined to the first. Arrays of doubles of more than a
    megabyte are not copied and must not change while the result is in use. Raises UsageError, DataError, Cancelled.

    index: index that proposes which segments can meet; the results do not depend on it
    """
    settings = {
        "index": index,
    }
    ran = run("regions", (c1, c2), settings, threads, progress, lazy={"rule": None, "areas_only": True})
    return Regions(ran)


def section(
    system: Any,
    starts: Any = None,
    *,
    orbits: int = 1000,
    iterates: int = 1000,
    box: Box | None = None,
    lifted: bool = False,
    exit_times: bool = False,
    threads: int = 0,
    progress: Progress = None,
) -> NDArray[np.float64]:
    """Follows orbits of a map, or of a flow's Poincare map, and counts their points.

    `system` is a system or its name; `starts`: first points of orbits, in place of those of orbits. Curves and
    points are arrays of N x 2 numbers, complex vectors, or polygons of shapely; the last point of a closed curve is
    joined to the first. Arrays of doubles of more than a megabyte are not copied and must not change while the
    result is in use. Raises UsageError, DataError, Cancelled.

    orbits: number of orbits, whose first points are spread evenly over the box
    iterates: number of iterates of each orbit
    box: corners of the box in which orbits start and which is drawn, x0 < x1 and y0 < y1; default: the whole
        region of interest of the system, usually its window
    lifted: whether to leave lifted angles as they come (default: points of a map that repeats after a shift,
        such as 2 pi, are shifted into one cell from the left side of the box on, and from its lower side where both
        coordinates are angles)
    exit_times: whether to compute after how many crossings of the section orbits leave, the first point being
        crossing 1: one orbit begins in each cell of a grid on the box, as in a picture, in place of those of
        orbits; for systems whose orbits escape
    """
    settings = {
        "orbits": orbits,
        "iterates": iterates,
        "box": box,
        "lifted": lifted,
        "exit_times": exit_times,
    }
    ran = run("section", (system, starts), settings, threads, progress)
    return orbits_of(ran)


@dataclass(frozen=True)
class SimplifyResult:
    """The resulting curve."""

    #: Number of points.
    points: int
    #: Whether the last point is joined to the first one.
    closed: bool

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "SimplifyResult":
        return cls(
            points=v["points"],
            closed=v["closed"],
        )


@dataclass(frozen=True, repr=False)
class Simplify(Result):
    """The result of `simplify`."""

    #: Number of points of the curve given.
    given: int
    #: The resulting curve.
    result: SimplifyResult | None
    #: Signed area, positive for a counter-clockwise curve; for an open one that of the polygon that its ends close
    #: (unit: area).
    signed_area: float
    #: Points of the result (unit: length).
    points: NDArray[np.float64]

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "Simplify":
        return cls(
            given=v["given"],
            result=None if v["result"] is None else SimplifyResult._of(v["result"]),
            signed_area=v["signed_area"],
            points=v["points"],
        )


def simplify(
    curve: Any,
    *,
    tolerance: float,
    max_length: float | None = None,
    closed: bool = True,
    threads: int = 0,
    progress: Progress = None,
) -> Simplify:
    """Removes vertices of a curve, so that it stays within a tolerance of the given one.

    `curve`: a curve. Curves and points are arrays of N x 2 numbers, complex vectors, or polygons of shapely; the
    last point of a closed curve is joined to the first. Arrays of doubles of more than a megabyte are not copied
    and must not change while the result is in use. Raises UsageError, DataError, Cancelled.

    tolerance: maximum distance of a removed vertex from the curve that remains, in units of the coordinates
    max_length: maximum length of new segments, in units of the coordinates; default: no maximum
    closed: whether to join the last vertex of the curve to the first
    """
    settings = {
        "tolerance": tolerance,
        "max_length": max_length,
        "closed": closed,
    }
    ran = run("simplify", (curve,), settings, threads, progress)
    return kept(Simplify._of(ran.value), ran)


@dataclass(frozen=True)
class SweepRows:
    """A value each. A column each."""

    #: Value of the parameter.
    value: NDArray[np.float64]
    #: Why there is no result.
    failure: list[str | None]
    #: Saddle of U (unit: length).
    from_: NDArray[np.float64]
    #: Saddle of S (unit: length).
    to: NDArray[np.float64]
    #: Multiplier of U at its saddle.
    multiplier: NDArray[np.float64]
    #: Number of pips from one to its image.
    period: NDArray[Any]
    #: Boundary intersection point (q) (unit: length).
    bip: NDArray[np.float64]
    #: Signed areas of the lobes of the turnstile by geometry (unit: area).
    areas: list[NDArray[np.float64]]
    #: Their error bars (unit: area).
    errors: list[NDArray[np.float64]]
    #: Signed areas of the lobes of the turnstile by action; empty where the map has none (unit: area).
    areas_by_action: list[NDArray[np.float64]]
    #: Area that leaves in one iterate (unit: area).
    flux12: Measured
    #: Area that enters in one iterate (unit: area).
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
    #: Area of the lobes of one side to first order (unit: area).
    first_order: NDArray[np.float64]

    @classmethod
    def _of(cls, v: dict[str, Any]) -> "SweepRows":
        return cls(
            value=v["value"],
            failure=v["failure"],
            from_=v["from"],
            to=v["to"],
            multiplier=v["multiplier"],
            period=v["period"],
            bip=v["bip"],
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
    """Zeros of the difference. A column each."""

    #: The values between which the zero lies.
    between: list[NDArray[np.float64]]
    #: Value of the parameter.
    value: NDArray[np.float64]
    #: Width of the interval in which the zero is known to lie.
    width: NDArray[np.float64]
    #: Difference that is left there (unit: area).
    difference: NDArray[np.float64]
    #: Number of further values that it took.
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


@dataclass(frozen=True, repr=False)
class Sweep(Result):
    """The result of `sweep`."""

    #: Name of the parameter.
    parameter: str | None
    #: A value each.
    rows: SweepRows
    #: Zeros of the difference.
    zeros: SweepZeros
    #: Why no zero was found, where zeros were looked for.
    no_zero: str | None
    #: Number of values without a result.
    failures: int
    #: Remarks on the result.
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
    tolerance: float | None = None,
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
    tolerance: maximum distance between a manifold and its polygon, which errors of areas are far smaller than,
        in units of the coordinates; default: 1e-5 times the power of ten in the extent of the system's window: 1e-5
        for the built-in systems
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
        the system's, or the pip halfway, up to which U is as long as S
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
    ran = run("sweep", (system,), settings, threads, progress)
    return kept(Sweep._of(ran.value, ran.comparisons), ran)


def tangle(
    u: Any,
    s: Any,
    *,
    bip: int | None = None,
    period: int | None = None,
    bip_near: Pair | None = None,
    closure: Sequence[float] | None = None,
    smooth: bool = False,
    index: str = 'auto',
    check_simple: bool = True,
    threads: int = 0,
    progress: Progress = None,
) -> Tangle:
    """Finds the tangle of two manifolds, which are given as curves: primary intersection points, lobes, boundary and
    turnstile, with areas and error bars.

    `u`: the unstable manifold, outward from its fixed point; `s`: the stable manifold, outward from its fixed
    point. Curves and points are arrays of N x 2 numbers, complex vectors, or polygons of shapely; the last point of
    a closed curve is joined to the first. Arrays of doubles of more than a megabyte are not copied and must not
    change while the result is in use. Raises UsageError, DataError, Cancelled.

    bip: number of the boundary intersection point, the pip at which the boundary passes from U to S, from 0;
        default: the pip nearest to bip_near, or the middle one
    period: number of pips from one to its image, at most the number of lobes, and even where lobes alternate;
        default: inferred from the areas
    bip_near: point near it; default: none
    closure: corners of the path that closes the boundary, from the fixed point of S to that of U; default: the
        straight line
    smooth: whether to compute the pips and areas of smooth curves through the points, with error bars, instead
        of those of the polygons
    index: index that proposes which segments can meet; the results do not depend on it
    check_simple: whether to refuse manifolds that cross or touch themselves
    """
    settings = {
        "bip": bip,
        "period": period,
        "bip_near": bip_near,
        "closure": closure,
        "smooth": smooth,
        "index": index,
        "check_simple": check_simple,
    }
    ran = run("tangle", (u, s), settings, threads, progress, lazy={"overlaps": False})
    return Tangle(ran)


def transport(
    system: Any,
    connection: Connection | None = None,
    *,
    from_: Pair | None = None,
    to: Pair | None = None,
    u_direction: Pair | None = None,
    s_direction: Pair | None = None,
    bip: Pair | None = None,
    iterates: int = 7,
    tolerance: float | None = None,
    max_points: int = 20000000,
    max_work: float = 100000000.0,
    budget: float | None = None,
    all_regions: bool = False,
    particles: int = 0,
    melnikov: bool = False,
    seed: int = 1,
    rng: Any = None,
    threads: int = 0,
    progress: Progress = None,
) -> Transport:
    """Computes the transport across the boundary that a stable and an unstable manifold of a map make: grows them,
    finds the turnstile, and computes the fluxes a(n) and T(n) by lobes and by boundaries.

    `system` is a system or its name. `connection`: in place of the options that choose one. Raises UsageError, DataError, Cancelled.

    from_: point near the saddle of the unstable manifold, in the coordinates of the map; default: the system's
    to: point near the saddle of the stable manifold, in the coordinates of the map; default: that of from, a
        period of the plane farther where that is the system's own saddle and its tangle leads there, or the
        system's
    u_direction: vector roughly along the unstable manifold, away from its saddle; default: the system's
    s_direction: vector roughly along the stable manifold, away from its saddle; default: the system's
    bip: point near the boundary intersection point, the pip at which the boundary passes from U to S; default:
        the system's, or the pip halfway, up to which U is as long as S
    iterates: number of iterates n up to which the table goes
    tolerance: maximum distance between a manifold and its polygon, which errors of areas are far smaller than,
        in units of the coordinates; default: 1e-5 times the power of ten in the extent of the system's window: 1e-5
        for the built-in systems
    max_points: maximum number of points of each manifold
    max_work: work that growing the manifolds of one boundary may take, in evaluations of the vector field,
        where no time is given
    budget: wall-clock time that all of it may take, in seconds; default: a limit on the work instead, which
        gives the same table on every machine
    all_regions: whether to compute the transport between the regions of all boundaries that the system names
        (ovp: the lower vortex too), with the matrices T_ij(n)
    particles: number of particles in each bounded region by which T(n) is counted, as a check
    melnikov: whether to compute Melnikov's function too, and the areas of lobes to first order in the parameter
        that is the size of the system's perturbation (eps) beside the exact ones
    seed: seed of the random numbers of the particles
    rng: what numpy.random.default_rng takes, from which the seed is drawn, in place of one
    """
    settings = {
        "from": from_,
        "to": to,
        "u_direction": u_direction,
        "s_direction": s_direction,
        "bip": bip,
        "iterates": iterates,
        "tolerance": tolerance,
        "max_points": max_points,
        "max_work": max_work,
        "budget": budget,
        "all_regions": all_regions,
        "particles": particles,
        "melnikov": melnikov,
        "seed": seed_of(seed, 1, rng),
    }
    ran = run("transport", (system,), settings, threads, progress, connection)
    return kept(Transport._of(ran), ran)
