"""Two closed curves: crossings, pieces and areas."""

from __future__ import annotations

import operator
from functools import cached_property
from typing import TYPE_CHECKING, Any, Iterator, Sequence, overload

import numpy as np
from numpy.typing import NDArray

from . import _lober
from ._agreement import Agreement
from ._areas import AREAS, AreaErrors, Areas, areas_html, html_table
from ._arrays import Points, points_of, sealed
from ._call import Run
from ._features import feature, features
from ._numbers import threads_of
from ._recomputed import Recomputed

if TYPE_CHECKING:
    import pandas

PAIRINGS = ("c1_minus_c2", "c2_minus_c1", "intersection", "union")


class Piece:
    """One connected component of a pairing. A feature for others (`__geo_interface__`)."""

    def __init__(self, overlay: Overlay, pairing: str, number: int) -> None:
        self._overlay = overlay
        self._pairing = pairing
        self._number = number
        self.area: float
        self.holes: int
        self.crossings: NDArray[np.uint32]
        self.area, self.holes, self.crossings = overlay._of.piece(pairing, number)

    @property
    def outline(self) -> list[Points]:
        """Closed polygons: the outer one, counter-clockwise, then the holes, clockwise."""
        return sealed(self._overlay._of.outline(self._pairing, self._number))  # type: ignore[no-any-return]

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        about = {"pairing": self._pairing, "number": self._number, "area": self.area, "holes": self.holes}
        return feature(self.outline, about)

    def __repr__(self) -> str:
        return f"<Piece {self._number} of {self._pairing}: area {self.area:.15g}, {self.holes} holes>"


class Pieces(Sequence[Piece]):
    """The pieces of one pairing: a sequence of `Piece`, with the areas of all as an array. Features for others, such as
    `geopandas.GeoDataFrame.from_features(pieces)`."""

    def __init__(self, overlay: Overlay, pairing: str) -> None:
        self._overlay = overlay
        self._pairing = pairing

    @property
    def area(self) -> NDArray[np.float64]:
        """Area of each piece; memory of the result, without a copy."""
        return self._overlay._of.piece_areas(self._pairing)

    @cached_property
    def centroids(self) -> Points:
        return sealed(self._overlay._of.centroids(self._pairing))  # type: ignore[no-any-return]

    @cached_property
    def slivers(self) -> NDArray[np.uint32]:
        """Numbers of the pieces that are no wider than the rounding of their vertices."""
        return sealed(self._overlay._of.slivers(self._pairing))  # type: ignore[no-any-return]

    def __len__(self) -> int:
        return len(self.area)

    @overload
    def __getitem__(self, number: int) -> Piece: ...
    @overload
    def __getitem__(self, number: slice) -> list[Piece]: ...
    def __getitem__(self, number: int | slice) -> Piece | list[Piece]:
        if isinstance(number, slice):
            return [self[k] for k in range(*number.indices(len(self)))]
        at = operator.index(number)
        if not -len(self) <= at < len(self):
            raise IndexError(f"there is no piece {at}; there are {len(self)}")
        return Piece(self._overlay, self._pairing, at % len(self))

    def __iter__(self) -> Iterator[Piece]:
        return (self[number] for number in range(len(self)))

    def __array__(self, dtype: Any = None) -> NDArray[Any]:
        """The areas."""
        return np.asarray(self.area, dtype)

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        return features(piece.__geo_interface__ for piece in self)

    def to_pandas(self) -> pandas.DataFrame:
        """A row for each piece: `area`, `holes`, the number of `crossings` on its boundary, `x` and `y` of its centroid,
        and whether it is a `sliver`."""
        import pandas

        pieces = list(self)
        slivers = np.zeros(len(pieces), bool)
        slivers[self.slivers] = True
        return pandas.DataFrame(
            {
                "area": self.area,
                "holes": [piece.holes for piece in pieces],
                "crossings": [len(piece.crossings) for piece in pieces],
                "x": self.centroids[:, 0],
                "y": self.centroids[:, 1],
                "sliver": slivers,
            },
            index=pandas.RangeIndex(len(pieces), name="piece"),
        )

    def __repr__(self) -> str:
        return f"<{len(self)} pieces of {self._pairing}, total area {self.area.sum():.15g}>"

    def _repr_html_(self) -> str:
        rows = [[str(k), f"{area:.15g}", str(self[k].holes)] for k, area in enumerate(self.area[:20])]
        more = f"<p>and {len(self) - 20} more</p>" if len(self) > 20 else ""
        return f"<p>{repr(self)[1:-1]}</p>" + html_table(["piece", "area", "holes"], rows) + more


class Overlay(Recomputed):
    """The result of `overlay`. Arrays are views of it where it holds the numbers; the rest is computed when asked for."""

    _function = "overlay"
    _picture = "overlay"

    def __init__(self, run: Run) -> None:
        self._run = run
        self._of = _lober.overlay_of(run.of)

    @property
    def agreement(self) -> Agreement:
        """The areas by the interior function too, with `verify=True`."""
        return self._run.agreement

    @property
    def area(self) -> Areas:
        """Areas in squared units of the coordinates, all >= 0."""
        return self._of.areas

    @cached_property
    def error(self) -> AreaErrors:
        """Error bars of `area`: `rounding`, `discretisation`."""
        return AreaErrors(self._of.rounding, self._of.discretisation())

    @cached_property
    def nodes(self) -> NDArray[Any]:
        """Where the curves meet, in order along C1: a structured array.

        Fields: `x`, `y`; `rho`, +1 where C1 leaves the region of C2, -1 where it enters, 0 for a touch; `shared`, +1 or -1
        for an arc that both curves share in the same or in opposite directions; `segment1`, `t1`, `segment2`, `t2`, the
        positions along the curves; `end_...`, those of the end of a shared arc; `order2`, the rank along C2.
        """
        return sealed(self._of.nodes())  # type: ignore[no-any-return]

    @property
    def classes(self) -> NDArray[np.uint32]:
        """The equivalence class of each node under sigma (Naik, Lekien & Ross 2017); 2^32 - 1 for touches."""
        return self._of.classes()

    @property
    def class_count(self) -> int:
        return self._of.class_count

    def sigma(self, pairing: str = "c1_minus_c2") -> NDArray[Any]:
        """rho, sigma, class and S(p) of each crossing, for `c1_minus_c2` or `c2_minus_c1`."""
        return self._of.sigma(pairing)

    @property
    def crossings(self) -> int:
        """The number of nodes where the curves cross: always even."""
        return self._of.crossings

    @property
    def touches(self) -> int:
        return self._of.touches

    @property
    def shared_arcs(self) -> int:
        return self._of.shared_arcs

    @property
    def same_curve(self) -> bool:
        return self._of.same_curve

    @property
    def orientation(self) -> tuple[str, str]:
        """Orientations of the two curves as given."""
        return self._of.orientation1, self._of.orientation2

    def pieces(self, pairing: str = "c1_minus_c2") -> Pieces:
        """The connected components of `c1_minus_c2`, `c2_minus_c1`, `intersection` or `union`."""
        self._of.piece_areas(pairing)
        return Pieces(self, pairing)

    @cached_property
    def smooth(self) -> SmoothAreas:
        """Areas between the smooth curves through the points, with estimates of their errors."""
        return SmoothAreas(*self._of.smooth())

    @property
    def timing(self) -> dict[str, float]:
        """Seconds of each phase."""
        return self._of.timing

    def __repr__(self) -> str:
        return (
            f"<Overlay: {self.crossings} crossings, C1 \\ C2 = {self.area.c1_minus_c2:.15g}, "
            f"C2 \\ C1 = {self.area.c2_minus_c1:.15g}>"
        )

    def _repr_html_(self) -> str:
        title = f"{self.crossings} crossings, {self.touches} touches, {self.shared_arcs} shared arcs"
        return areas_html(title, self.area, self.error)


class SmoothAreas:
    """Areas between smooth curves through the points, of order h^6 in the length h of segments."""

    def __init__(self, area: Areas, error: Areas, fallback_segments: int, fallback_crossings: int) -> None:
        self.area = area
        #: Estimates of |area - area of the smooth curves|.
        self.error = error
        self.fallback_segments = fallback_segments
        self.fallback_crossings = fallback_crossings

    def __repr__(self) -> str:
        return f"<SmoothAreas: C1 \\ C2 = {self.area.c1_minus_c2:.15g} +- {self.error.c1_minus_c2:.1e}>"

    def _repr_html_(self) -> str:
        rows = [
            [label, f"{getattr(self.area, name):.15g}", f"{getattr(self.error, name):.1e}"]
            for name, label in AREAS.items()
        ]
        return html_table(["between smooth curves", "area", "error"], rows)


class Interior(Recomputed):
    """The result of `interior`."""

    _function = "interior"

    def __init__(self, run: Run) -> None:
        self._run = run
        self._of = _lober.interior_of(run.of)

    @property
    def agreement(self) -> Agreement:
        """The areas by the overlay too, with `verify=True`."""
        return self._run.agreement

    @property
    def area(self) -> Areas:
        return self._of.areas

    @property
    def error(self) -> AreaErrors:
        """Error bars of `area`: `rounding`."""
        return AreaErrors(self._of.rounding)

    @property
    def q(self) -> tuple[float, float, float]:
        """Q1, Q2, Q3 (Naik, Lekien & Ross 2017, section 4): symmetric difference, union and intersection."""
        return self._of.q1, self._of.q2, self._of.q3

    @property
    def delta(self) -> float:
        """1/4 |Q2 - Q3 - Q1|, which is zero by algebra: the rounding of the three sums."""
        return self._of.delta

    @cached_property
    def nodes(self) -> NDArray[Any]:
        """As `Overlay.nodes`."""
        return sealed(self._of.nodes())  # type: ignore[no-any-return]

    @property
    def orientation(self) -> tuple[str, str]:
        return self._of.orientation1, self._of.orientation2

    def __repr__(self) -> str:
        return f"<Interior: C1 \\ C2 = {self.area.c1_minus_c2:.15g}, C2 \\ C1 = {self.area.c2_minus_c1:.15g}>"

    def _repr_html_(self) -> str:
        return areas_html("interior method", self.area, self.error)


def winding(curve: Any, points: Any, *, threads: int = 0) -> tuple[NDArray[np.int32], NDArray[np.bool_]]:
    """The winding number of a closed curve of any shape about each point, exactly, and which points lie on the curve.

    Counter-clockwise is positive; the number of a point on the curve is 0.
    """
    return _lober.windings(points_of(curve, "curve"), points_of(points, "points"), threads_of(threads))


def interior_function(curve: Any, points: Any, *, threads: int = 0) -> NDArray[np.float64]:
    """J of a closed curve at each point: 2 pi times the winding number, on the curve the principal value."""
    return _lober.interior_values(points_of(curve, "curve"), points_of(points, "points"), threads_of(threads))


def area(curve: Any) -> float:
    """The signed area of a closed curve, positive for counter-clockwise ones."""
    return _lober.signed_area(points_of(curve, "curve"))
