"""Tangles grown from equations, transport between regions, escape from a well."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _lober
from ._agreement import Agreement
from ._areas import html_table
from ._arrays import Points, sealed
from ._call import Run
from ._measured import Measured
from ._melnikov import Melnikov
from ._result import Result
from ._systems import Connection, Pair, System
from ._tangle import Tangle
from ._view import remember


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


def _connection_of(run: Run) -> Connection:
    chosen = run.of.chosen()
    system, *given = run.arguments
    known = given[0] if given else system.connection
    saddles = chosen["from"], chosen["to"]
    closes = known is not None and (known.from_saddle, known.to_saddle) == saddles
    return Connection(
        saddles[0],
        chosen["u_direction"],
        saddles[1],
        chosen["s_direction"],
        chosen.get("bip"),
        known.closure if closes else (),
    )


class SystemTangle(Tangle):
    """The tangle of a system's manifolds, which were grown as far as it needs them."""

    _function = "manifold_tangle"

    def __init__(self, run: Run) -> None:
        super().__init__(run)
        more = _lober.manifolds_of(run.of)
        self.system: System = run.arguments[0]
        self.connection = _connection_of(run)
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


@dataclass(frozen=True, repr=False)
class Transport(Result):
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
    #: Melnikov's function, where it was asked for.
    melnikov: Melnikov | None
    remarks: list[str]
    agreement: Agreement

    _picture = "flux"

    @classmethod
    def _of(cls, run: Run) -> Transport:
        found = run.value
        steps = found["steps"]
        counted = steps["T_ij_by_particles"]
        made = cls(
            steps["n"],
            [
                Region(Measured(*area), bool(bounded))
                for bounded, *area in zip(found["regions"]["bounded"], *found["regions"]["area"])
            ],
            [_boundary(entry) for entry in found["boundaries"]],
            Measured(*steps["a_ij"]),
            Measured(*steps["T_ij"]),
            Measured(*steps["T_ij_by_boundaries"]),
            Measured(*(counted or (np.full_like(steps["T_ij"][0], np.nan),) * 2)),
            found["iterates_a_step"],
            None if found["melnikov"] is None else Melnikov._of(found["melnikov"]),
            found["remarks"],
            run.agreement,
        )
        remember(made, run)
        return made

    def __repr__(self) -> str:
        agreed = "routes agree" if self.agreement else "routes disagree"
        areas = ", ".join(f"{region.area.value:.10g}" for region in self.regions if region.bounded)
        return f"<Transport: n = 1 ... {len(self.n)}, {len(self.regions)} regions, bounded areas {areas}, {agreed}>"

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


@dataclass(frozen=True, repr=False)
class Escape(Result):
    """The result of `escape`.

    `table` is a structured array with fields `entry`, `exit` (numbers of bottlenecks), `crossings` (0: before the first
    one), `iterates`, `fraction`, `error`, and `other`, `other_error`, the same from another split; NaN where it is not
    known. `stop` says why it goes to `crossings` only: done, points, work, budget or lost. `also_open` holds saddles
    below the energy that are none of the system's, as states: what leaves by these is not in the table. `survival` is a
    structured array with fields `entry`, `crossings` (n), `left` (the fractions that have left by each exit up to n),
    `remains` and `error`, as far as all fractions are known.
    """

    energy: float
    table: NDArray[Any]
    crossings: int
    stop: str
    bottlenecks: list[Bottleneck]
    also_open: list[list[float]]
    agreement: Agreement
    survival: NDArray[Any]

    _picture = "exits"

    def __repr__(self) -> str:
        agreed = "routes agree" if self.agreement else "routes disagree"
        size = f"{len(self.bottlenecks)} bottlenecks, {self.crossings} crossings ({self.stop}), {len(self.table)} rows"
        return f"<Escape: energy {self.energy:.15g}, {size}, {agreed}>"

    def _repr_html_(self) -> str:
        names = self.table.dtype.names or ()
        rows = [[f"{row[name]:.6g}" for name in names] for row in self.table[:20]]
        more = f"<p>and {len(self.table) - 20} more</p>" if len(self.table) > 20 else ""
        title = f"<p>energy {self.energy:.15g}, {len(self.bottlenecks)} bottlenecks, {self.crossings} crossings: {self.stop}</p>"
        return title + html_table(names, rows) + more

    @classmethod
    def _of(cls, run: Run) -> Escape:
        found = run.value
        names = [one["name"] for one in found["bottlenecks"]]
        stop = found["stop"]
        made = cls(
            found["energy"],
            _escape_table(found["table"], names),
            found["crossings"],
            "done" if stop is None else stop["reason"],
            [_bottleneck(found["energy"], one) for one in found["bottlenecks"]],
            [list(state) for state in found["also_open"]["at"]],
            run.agreement,
            sealed(_survival(found["survival"], names)),
        )
        remember(made, run)
        return made


def _survival(columns: dict[str, Any], names: list[str]) -> NDArray[Any]:
    fields: list[Any] = [("entry", np.uint32), ("crossings", np.int32), ("left", np.float64, (len(names),))]
    table = np.empty(len(columns["entrance"]), [*fields, ("remains", np.float64), ("error", np.float64)])
    table["entry"] = [names.index(name) for name in columns["entrance"]]
    table["crossings"] = columns["crossings"]
    if len(table) > 0:
        table["left"] = np.asarray(columns["left"], np.float64)
    table["remains"], table["error"] = columns["remains"]
    return table


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
