"""The tangle of an unstable and a stable manifold: pips, lobes, boundary, turnstile."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _lober
from ._agreement import Agreement
from ._areas import html_table
from ._arrays import Points, sealed
from ._call import Run
from ._features import feature, features
from ._recomputed import Recomputed

if TYPE_CHECKING:
    import pandas


@dataclass(frozen=True)
class TangleErrors:
    """Error bars of lobes, or of the boundary: `rounding` is a bound, `discretisation` an estimate."""

    rounding: Any
    discretisation: Any


@dataclass(frozen=True)
class Boundary:
    """B(q): the unstable manifold up to the bip q and the stable one from there."""

    bip: int
    area: float
    error: TangleErrors
    orientation: str
    crosses_itself: bool
    outline: Points

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        return feature([self.outline], {"bip": self.bip, "area": self.area})


class Lobes:
    """All lobes; lobe k lies between pips k and k + 1. Attributes are arrays with an entry for each lobe."""

    def __init__(self, tangle: Tangle) -> None:
        self._tangle = tangle
        self._rows: NDArray[Any] = sealed(tangle._of.lobes())

    @property
    def area(self) -> NDArray[np.float64]:
        """Signed: positive where the lobe lies on the left of the unstable manifold."""
        return self._rows["area"]

    @property
    def error(self) -> TangleErrors:
        """Error bars of `area`."""
        return TangleErrors(self._rows["rounding"], self._rows["discretisation"])

    @property
    def polygon_area(self) -> NDArray[np.float64]:
        """Areas of the polygons; differs from `area` with `smooth` only."""
        return self._rows["polygon_area"]

    @property
    def inside(self) -> NDArray[np.float64]:
        """Area of the part inside the boundary."""
        return self._rows["inside"]

    @property
    def outside(self) -> NDArray[np.float64]:
        return self._rows["outside"]

    @property
    def parts_error(self) -> NDArray[np.float64]:
        """Error bars of `inside` and `outside` with `smooth`; else NaN."""
        return self._rows["parts_error"]

    @property
    def perimeter(self) -> NDArray[np.float64]:
        return self._rows["perimeter"]

    @property
    def width(self) -> NDArray[np.float64]:
        """The mean width of a thin lobe, 2 |area| / perimeter."""
        return self._rows["width"]

    @property
    def centroid(self) -> Points:
        return np.stack([self._rows["x"], self._rows["y"]], axis=1)

    @property
    def simple(self) -> NDArray[np.bool_]:
        """Whether the two arcs of a lobe meet nowhere but at its pips."""
        return self._rows["simple"]

    @cached_property
    def label(self) -> list[str]:
        """`L12(n)` or `L21(n)` (Rom-Kedar & Wiggins); empty where the period is not known."""
        return self._tangle._of.labels()

    def outline(self, lobe: int) -> Points:
        """The boundary of a lobe as a closed polygon."""
        return sealed(self._tangle._of.lobe_outline(lobe))  # type: ignore[no-any-return]

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        return features(
            feature([self.outline(k)], {"number": k, "label": self.label[k], "area": float(area)})
            for k, area in enumerate(self.area)
        )

    def __array__(self, dtype: Any = None) -> NDArray[Any]:
        """A structured array with a row for each lobe."""
        return self._rows if dtype is None else self._rows.astype(dtype)

    def to_pandas(self) -> pandas.DataFrame:
        """A row for each lobe, with its label."""
        import pandas

        table: dict[str, Any] = {"label": self.label, **{name: self._rows[name] for name in self._rows.dtype.names or ()}}
        return pandas.DataFrame(table, index=pandas.RangeIndex(len(self), name="lobe"))

    def __len__(self) -> int:
        return len(self._rows)

    def __repr__(self) -> str:
        return f"<{len(self)} lobes>"

    def _repr_html_(self) -> str:
        return self._tangle._repr_html_()


class Tangle(Recomputed):
    """The result of `tangle`."""

    _function = "tangle"
    _picture = "tangle"

    def __init__(self, run: Run) -> None:
        self._run = run
        self._of = _lober.tangle_of(run.of)

    @property
    def u(self) -> Points:
        """The points of the unstable manifold."""
        return self._of.u()

    @property
    def s(self) -> Points:
        return self._of.s()

    @cached_property
    def nodes(self) -> NDArray[Any]:
        """Where the manifolds meet, in order along the unstable one; fields as in `Overlay.nodes`."""
        return sealed(self._of.nodes())  # type: ignore[no-any-return]

    @cached_property
    def pips(self) -> NDArray[Any]:
        """Primary intersections outward along the unstable manifold: `x`, `y`, `rho`, `node` and positions."""
        return sealed(self._of.pips())  # type: ignore[no-any-return]

    @cached_property
    def lobes(self) -> Lobes:
        return Lobes(self)

    @cached_property
    def boundary(self) -> Boundary | None:
        """None where there is no pip."""
        found = self._of.boundary()
        if found is None:
            return None
        errors = TangleErrors(found["rounding"], found["discretisation"])
        return Boundary(
            found["bip"],
            found["area"],
            errors,
            found["orientation"],
            found["crosses_itself"],
            sealed(self._of.boundary_outline()),
        )

    @cached_property
    def images(self) -> dict[str, Any]:
        """The map on pips: `period`, the pips from one to its image, or None with the `reason`."""
        return self._of.images()

    @property
    def period(self) -> int | None:
        period: int | None = self.images["period"]
        return period

    @property
    def turnstile(self) -> range:
        """Numbers of the lobes between the pre-image of the bip and the bip; empty where they are not all there."""
        return range(self.images["turnstile_begin"], self.images["turnstile_end"])

    @cached_property
    def overlaps(self) -> NDArray[Any]:
        """The common areas of lobes i < j: `i`, `j`, `area`, `error`, `perimeter`, for every pair that has any."""
        return sealed(self._of.overlaps())  # type: ignore[no-any-return]

    @property
    def agreement(self) -> Agreement:
        """Areas of lobes and of their images, where the period was inferred; of a system, by geometry and by action."""
        return self._run.agreement

    @property
    def remarks(self) -> list[str]:
        """Remarks on unusual input."""
        return self._of.remarks

    def __repr__(self) -> str:
        return f"<Tangle: {self._size()}>"

    def _size(self) -> str:
        crossings = np.count_nonzero(self.nodes["rho"])  # the others are touches
        agreed = "" if self.agreement else ", routes disagree"
        return f"{crossings} crossings, {len(self.pips)} pips, {len(self.lobes)} lobes{agreed}"

    def _repr_html_(self) -> str:
        lobes = self.lobes
        rows = [
            [
                str(k),
                lobes.label[k],
                f"{lobes.area[k]:.15g}",
                f"{lobes.error.rounding[k]:.1e}",
                f"{lobes.error.discretisation[k]:.1e}",
            ]
            for k in range(min(len(lobes), 20))
        ]
        more = f"<p>and {len(lobes) - 20} more</p>" if len(lobes) > 20 else ""
        title = f"<p>{self._size()}</p>"
        return title + html_table(["lobe", "label", "area", "rounding", "discretisation"], rows) + more
