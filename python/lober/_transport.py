"""Tangles grown from equations, transport between regions, escape from a well."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _lober
from ._agreement import Agreement, agreement_of
from ._areas import html_table
from ._arrays import Points
from ._call import call, system_input
from ._measured import Measured
from ._progress import Progress, watching
from ._systems import Connection, Pair, System, connection_of, is_own, system_of
from ._tangle import Tangle
from .errors import UsageError


@dataclass(frozen=True)
class TurnstileAreas(Measured):
    """Signed areas of the lobes of a turnstile, in the order of `Tangle.turnstile`, with the labels of those lobes.

    Which lobe comes first depends on the bip; `areas["L12(1)"]` is that of what leaves region 1, the sum where a map has
    several such lobes.
    """

    labels: tuple[str, ...]

    def __getitem__(self, label: str) -> Measured:
        of_it = [k for k, here in enumerate(self.labels[: len(self.value)]) if here == label]
        if not of_it:
            raise KeyError(f"{label}: the lobes are {', '.join(self.labels)}")
        return Measured(float(self.value[of_it].sum()), float(self.error[of_it].sum()))

    def __str__(self) -> str:
        return ", ".join(f"{n}: {v} +- {e}" for n, v, e in zip(self.labels, self.value, self.error))


class SystemTangle(Tangle):
    """The tangle of a system's manifolds, which were grown as far as it needs them."""

    def __init__(
        self,
        of: _lober.Tangle,
        more: dict[str, Any],
        call: tuple[str, tuple[Any, ...], dict[str, Any]],
        system: System,
        connection: Connection,
    ) -> None:
        super().__init__(of, call)
        self.system = system
        self.connection = connection
        #: Number of the pip q where the boundary passes from one manifold to the other.
        self.bip: int = more["bip"]
        #: That the manifolds were grown to in the end.
        self.tolerance: float = more["tolerance"]
        labels = self.lobes.label
        #: Signed areas of the lobes of the turnstile by action; no entries where the map has none.
        self.area_by_action = TurnstileAreas(
            more["areas_by_action"], more["action_errors"], tuple(labels[k] for k in self.turnstile)
        )
        self.saddles: tuple[Pair, Pair] = more["saddles"]
        self.multipliers: tuple[float, float] = more["multipliers"]
        #: How far the points of both manifolds lie beside them, an estimate; errors of areas contain it.
        self.point_errors: tuple[float, float] = more["point_errors"]
        #: Areas by geometry and by action, and more.
        self.agreement: Agreement = agreement_of(more["comparisons"])


def manifold_tangle(
    system: Any,
    connection: Connection | None = None,
    *,
    tolerance: float = 1e-5,
    before: int = 1,
    after: int = 0,
    smooth: bool = True,
    max_iterates: int = 60,
    max_points: int = 20_000_000,
    max_work: float = 1e8,
    threads: int = 0,
    progress: Progress = None,
) -> SystemTangle:
    """Grows both manifolds of a connection and finds their tangle: `lober tangle --system`.

    `connection` defaults to that of the system, whose bip is not insisted on; of another one it is: DataError where no pip lies near. `tolerance` is the distance that polygon and manifold may have; errors of
    areas are far smaller. Images of the bip from f^-before to f^after are wanted; `max_work` bounds the evaluations of the
    vector field. Raises DataError where there is no tangle within the limits, UsageError, Cancelled.
    """
    made = system_of(system)
    chosen = connection_of(made, connection)
    # A bip of a connection of the caller's is insisted on; that of the system is a hint, which may be far from any pip.
    bip_near = None if is_own(made, connection) else chosen.bip
    with watching(progress, "tangle") as callback:
        found, more = _lober.grow_tangle(
            made._of,
            chosen._parts(),
            bip_near,
            tolerance,
            before,
            after,
            smooth,
            max_iterates,
            max_points,
            max_work,
            threads,
            callback,
        )
    options = {
        "tolerance": tolerance,
        "before": before,
        "after": after,
        "smooth": smooth,
        "max_iterates": max_iterates,
        "max_points": max_points,
        "max_work": max_work,
    }
    return SystemTangle(found, more, ("manifold_tangle", (made, connection), options), made, chosen)


@dataclass(frozen=True)
class Region:
    area: Measured
    bounded: bool


@dataclass(frozen=True)
class TransportBoundary:
    """One tangle: what its boundary encloses, what crosses it in one step, and the lobes of its turnstile."""

    enclosed: Measured
    flux12: Measured
    flux21: Measured
    lobe_area12: Measured
    lobe_area21: Measured
    lobe_area12_by_action: float
    lobe_area21_by_action: float
    outline: Points


@dataclass(frozen=True)
class Transport:
    """The result of `transport`. Matrices are arrays of n x regions x regions, for n = 1, 2, ..., NaN where a route
    does not lead."""

    n: NDArray[np.int64]
    regions: list[Region]
    boundaries: list[TransportBoundary]
    #: a_ij(n), by lobes.
    flux: Measured
    #: T_ij(n), by lobes.
    total: Measured
    #: T_ij(n), by boundaries.
    by_boundaries: Measured
    #: T_ij(n) counted, with one standard deviation.
    by_particles: Measured
    #: Iterates of the map in one step: 2 where both multipliers of a saddle are negative.
    iterates_a_step: int
    remarks: list[str]
    agreement: Agreement

    def _repr_html_(self) -> str:
        rows = [
            [
                str(n),
                f"{self.flux.value[k, 0, 1]:.12g}",
                f"{self.flux.error[k, 0, 1]:.1e}",
                f"{self.total.value[k, 0, 1]:.12g}",
                f"{self.total.error[k, 0, 1]:.1e}",
            ]
            for k, n in enumerate(self.n)
        ]
        return html_table(["n", "a12(n)", "error", "T12(n)", "error"], rows)


def transport(
    system: Any,
    connection: Connection | None = None,
    *,
    iterates: int = 7,
    tolerance: float = 1e-5,
    particles: int = 0,
    seed: int = 1,
    all_regions: bool = False,
    max_points: int = 20_000_000,
    max_work: float = 1e8,
    threads: int = 0,
    progress: Progress = None,
) -> Transport:
    """The area that leaves a region, iterate by iterate: a_ij(n) and T_ij(n) by lobes and by boundaries, counted too where
    `particles` are asked for.

    `all_regions` takes the further boundaries of the system. There are fewer rows where points or work do not suffice;
    a remark says so. Raises DataError where there is not even n = 1 or the map does not preserve area, UsageError,
    Cancelled.
    """
    made = system_of(system)
    settings = {
        "iterates": iterates,
        "tolerance": tolerance,
        "particles": particles,
        "seed": seed,
        "all_regions": all_regions,
        "max_points": max_points,
        "max_work": max_work,
        # That of a connection of the caller's is insisted on.
        "bip": connection.bip if connection is not None and not is_own(made, connection) else None,
    }
    found, comparisons = call("transport", [system_input(made, connection)], settings, threads, progress)
    steps = found["steps"]
    counted = steps["T_ij_by_particles"]
    return Transport(
        steps["n"],
        [Region(Measured(*area), bool(bounded)) for bounded, *area in zip(found["regions"]["bounded"], *found["regions"]["area"])],
        [_boundary(entry) for entry in found["boundaries"]],
        Measured(*steps["a_ij"]),
        Measured(*steps["T_ij"]),
        Measured(*steps["T_ij_by_boundaries"]),
        Measured(*(counted or (np.full_like(steps["T_ij"][0], np.nan),) * 2)),
        found["iterates_a_step"],
        found["remarks"],
        agreement_of(comparisons),
    )


def _boundary(entry: dict[str, Any]) -> TransportBoundary:
    turnstile = entry["turnstile"]
    return TransportBoundary(
        Measured(*entry["enclosed"]),
        Measured(*turnstile["flux12"]),
        Measured(*turnstile["flux21"]),
        Measured(*turnstile["lobe_area12"]),
        Measured(*turnstile["lobe_area21"]),
        turnstile["lobe_area12_by_action"],
        turnstile["lobe_area21_by_action"],
        entry["outline"],
    )


@dataclass(frozen=True)
class Bottleneck:
    """A bottleneck of a well: its periodic orbit, and the curves of its tubes on the section.

    `entry` are E, f(E), ..., what enters by it; `exit` are X, f^-1(X), ..., what is about to leave.
    """

    energy: float
    orbit_period: float
    multiplier: float
    action: Measured
    area: Measured
    entry: list[Points]
    exit: list[Points]


@dataclass(frozen=True)
class Escape:
    """The result of `escape`.

    `table` is a structured array with fields `entry`, `exit` (numbers of bottlenecks), `crossings`, `iterates`,
    `fraction`, `error`, and `other`, `other_error`, the same from another split; NaN where it is not known. `stop` says
    why it goes to `crossings` only: done, points, work, budget or lost. `also_open` holds saddles below the energy that
    are none of the system's, as states: what leaves by these is not in the table.
    """

    energy: float
    table: NDArray[Any]
    crossings: int
    stop: str
    bottlenecks: list[Bottleneck]
    also_open: list[list[float]]
    agreement: Agreement


def escape(
    system: Any,
    *,
    crossings: int = 4,
    energy: float | None = None,
    tolerance: float = 1e-6,
    max_points: int = 2_000_000,
    budget: float | None = None,
    monte_carlo: int = 0,
    threads: int = 0,
    progress: Progress = None,
) -> Escape:
    """Escape from a potential well: the fraction of what enters by one bottleneck that leaves by another, and when.

    `energy` defaults to the system's parameter of that name; `budget` is in seconds by the clock, in
    place of a limit on work that gives the same table on every machine; `monte_carlo` trajectories from each entrance check
    the table, as comparisons of `agreement`. Raises UsageError for a system without section
    or saddles, DataError, Cancelled.
    """
    made = system_of(system)
    if energy is None:
        if "energy" not in made.parameters:
            raise UsageError(f"energy is missing, and system {made.name} has no parameter energy")
        energy = made.parameters["energy"]
    settings = {
        "crossings": crossings,
        "energy": energy,
        "tolerance": tolerance,
        "max_points": max_points,
        "budget": budget,
        "monte_carlo": monte_carlo,
    }
    found, comparisons = call("escape", [system_input(made)], settings, threads, progress)
    names = [one["name"] for one in found["bottlenecks"]]
    stop = found["stop"]
    return Escape(
        found["energy"],
        _escape_table(found["table"], names),
        found["crossings"],
        "done" if stop is None else stop["reason"],
        [_bottleneck(found["energy"], one) for one in found["bottlenecks"]],
        [list(state) for state in found["also_open"]["at"]],
        agreement_of(comparisons),
    )


def _escape_table(columns: dict[str, Any], names: list[str]) -> NDArray[Any]:
    fields: dict[str, Any] = {
        "entry": np.array([names.index(name) for name in columns["entrance"]], np.uint32),
        "exit": np.array([names.index(name) for name in columns["exit"]], np.uint32),
        "crossings": columns["crossings"].astype(np.int32),
        "iterates": columns["iterates"].astype(np.int32),
    }
    fields["fraction"], fields["error"] = columns["fraction"]
    fields["other"], fields["other_error"] = columns["other"]
    table = np.empty(len(columns["entrance"]), [(name, column.dtype) for name, column in fields.items()])
    for name, column in fields.items():
        table[name] = column
    return table


def _bottleneck(energy: float, entry: dict[str, Any]) -> Bottleneck:
    orbit = entry["orbit"]
    return Bottleneck(
        energy,
        orbit["period"],
        entry["multiplier"],
        Measured(*orbit["action"]),
        Measured(*entry["area"]),
        entry["entry_curves"]["outline"],
        entry["exit_curves"]["outline"],
    )
