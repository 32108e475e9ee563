"""Pictures of results with matplotlib, which is imported when one is made.

Every function takes `ax`, the axes to draw into (default: new ones), and returns them; colours and lines can be changed there.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable

import numpy as np

from ._overlay import Overlay, winding
from ._tangle import Tangle
from ._transport import Escape, Transport
from .errors import UsageError

if TYPE_CHECKING:
    from matplotlib.axes import Axes

UNSTABLE, STABLE, BOUNDARY = "#d55e00", "#0072b2", "#b3b3b3"
#: Of what leaves, what enters, and lobes without a label.
SIDES = {"12": "#e69f00", "21": "#009e73", "": "#56b4e9"}
OVERLAP = "#7b2d8b"


def _axes(ax: Axes | None, equal: bool) -> Axes:
    if ax is not None:
        return ax
    import matplotlib.pyplot as pyplot

    made: Axes = pyplot.subplots()[1]
    if equal:
        made.set_aspect("equal", adjustable="datalim")
    return made


def _closed(points: Any) -> Any:
    return np.concatenate([points, points[:1]])


def _drawable(points: Any, window: Any) -> Any:
    """The line without points that nobody sees: those in the cell of the point before, of 8000 x 8000 over the window.

    matplotlib refuses paths with very many of them ("Exceeded cell block limit").
    """
    points, window = np.asarray(points), np.asarray(window)
    if len(points) < 10_000:
        return points
    low, extent = window.min(axis=0), np.ptp(window, axis=0)
    cell = np.floor((points - low) / np.where(extent > 0, extent, 1) * 8000)
    cell = np.clip(cell, -8000, 16000)  # far beyond the window all is one cell
    kept = np.ones(len(points), dtype=bool)
    kept[1:-1] = (cell[1:-1] != cell[:-2]).any(axis=1) | (cell[1:-1] != cell[2:]).any(axis=1)
    return points[kept]


def _label_place(ring: Any, centroid: Any) -> tuple[float, float]:
    """The centroid, or, of a lobe that bends round its own, the vertex nearest to it."""
    if winding(ring, [centroid])[0][0] == 0:
        centroid = ring[np.hypot(*(ring - centroid).T).argmin()]
    return float(centroid[0]), float(centroid[1])


def _fill(ax: Axes, rings: Iterable[Any], **style: Any) -> None:
    """A polygon with holes, as one path."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    paths = [Path(_closed(ring), closed=True) for ring in rings]
    if paths:
        ax.add_patch(PathPatch(Path.make_compound_path(*paths), **{"linewidth": 0, "alpha": 0.4, **style}))


def overlay(
    r: Overlay, ax: Axes | None = None, *, pairings: Iterable[str] = ("c1_minus_c2", "c2_minus_c1"), nodes: bool = True
) -> Axes:
    """Both curves, the pieces of some pairings, and the points where the curves meet."""
    ax = _axes(ax, True)
    curves = r._run.arguments
    for pairing, colour in zip(pairings, (STABLE, UNSTABLE, OVERLAP, "0.6")):
        for piece in r.pieces(pairing):
            _fill(ax, piece.outline, color=colour)
    for curve, colour, label in zip(curves, (STABLE, UNSTABLE), ("C1", "C2")):
        ring = _drawable(_closed(curve), curve)
        ax.plot(ring[:, 0], ring[:, 1], color=colour, linewidth=1, label=label)
    if nodes:
        ax.plot(r.nodes["x"], r.nodes["y"], "k.", markersize=4, label="nodes")
    ax.autoscale_view()
    ax.legend()
    return ax


def tangle(
    t: Tangle, ax: Axes | None = None, *, lobes: Iterable[int] | None = None, labels: bool = True, pips: bool = True
) -> Axes:
    """Both manifolds, the boundary, and lobes (default: all) in the colours of what leaves and what enters.

    The picture shows the lobes and the boundary; manifolds may go on beyond it.
    """
    ax = _axes(ax, True)
    chosen = list(range(len(t.lobes)) if lobes is None else lobes)
    shown = [t.lobes.outline(k) for k in chosen]
    for k, ring in zip(chosen, shown):
        label = t.lobes.label[k]
        _fill(ax, [ring], color=SIDES[label[1:3]])
        if labels:
            ax.annotate(label or str(k), _label_place(ring, t.lobes.centroid[k]), ha="center", va="center", fontsize="small")
    if t.boundary is not None:
        ring = _closed(t.boundary.outline)
        ax.plot(ring[:, 0], ring[:, 1], color=BOUNDARY, linewidth=4, zorder=0, label="boundary")
        shown.append(t.boundary.outline)
    for points, colour, label in ((t.u, UNSTABLE, "U"), (t.s, STABLE, "S")):
        line = _drawable(points, np.concatenate(shown) if shown else points)
        ax.plot(line[:, 0], line[:, 1], color=colour, linewidth=0.7, label=label)
    if pips:
        ax.plot(t.pips["x"], t.pips["y"], "k.", markersize=4, label="pips")
    if shown:
        corners = np.concatenate(shown)
        low, high = corners.min(axis=0), corners.max(axis=0)
        margin = 0.05 * (high - low)
        ax.set_xlim(low[0] - margin[0], high[0] + margin[0])
        ax.set_ylim(low[1] - margin[1], high[1] + margin[1])
    ax.legend()
    return ax


def turnstile(t: Tangle, ax: Axes | None = None, **options: Any) -> Axes:
    """The lobes between the pre-image of the bip and the bip, as `tangle` draws them."""
    if len(t.turnstile) == 0:
        raise UsageError(t.images["reason"] or "fewer pips before the bip than from a pip to its image")
    return tangle(t, ax, lobes=t.turnstile, **options)


def flux(r: Transport, ax: Axes | None = None, *, i: int = 1, j: int = 2) -> Axes:
    """T_ij(n) over n with error bars: by lobes, by boundaries, and counted where particles were."""
    ax = _axes(ax, False)
    for measured, style, label in (
        (r.total, "o-", "lobes"),
        (r.by_boundaries, "s", "boundaries"),
        (r.by_particles, "^", "particles"),
    ):
        value, error = measured.value[:, i - 1, j - 1], measured.error[:, i - 1, j - 1]
        if np.isfinite(value).any():
            ax.errorbar(r.n, value, yerr=error, fmt=style, capsize=3, markerfacecolor="none", label=f"by {label}")
    ax.set_xlabel("n")
    ax.set_ylabel(f"$T_{{{i}{j}}}(n)$")
    ax.set_xticks(r.n)
    ax.legend()
    return ax


def exits(r: Escape, ax: Axes | None = None) -> Axes:
    """The fraction of what enters by each bottleneck that leaves by each, crossing by crossing, with error bars."""
    ax = _axes(ax, False)
    known = r.table[np.isfinite(r.table["fraction"])]
    pairs = sorted({(int(row["entry"]), int(row["exit"])) for row in known})
    width = 0.8 / max(len(pairs), 1)
    for k, (entry, exit_) in enumerate(pairs):
        rows = known[(known["entry"] == entry) & (known["exit"] == exit_)]
        at = rows["crossings"] + (k - (len(pairs) - 1) / 2) * width
        label = f"from {entry + 1} to {exit_ + 1}"
        ax.bar(at, rows["fraction"], width, yerr=rows["error"], capsize=2, label=label)
    ax.set_xlabel("crossings")
    ax.set_ylabel("fraction")
    ax.set_xticks(range(1, r.crossings + 1))
    ax.legend()
    return ax
