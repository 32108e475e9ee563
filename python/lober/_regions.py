"""Closed curves that may cross, touch and overlap themselves."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _lober
from ._areas import AreaErrors, Areas, areas_html, html_table
from ._arrays import Points, sealed
from ._call import Run
from ._features import feature, features
from ._recomputed import Recomputed

if TYPE_CHECKING:
    import pandas

RULES = ("nonzero", "evenodd", "positive", "negative")


class RegionPieces:
    """The pieces of one region: areas as an array, outlines when asked for."""

    def __init__(self, of: _lober.RegionPieces) -> None:
        self._of = of

    @property
    def area(self) -> NDArray[np.float64]:
        """Area of each piece; memory of the result, without a copy."""
        return self._of.areas()

    def holes(self, number: int) -> int:
        return self._of.holes(number)

    def outline(self, number: int) -> list[Points]:
        """Closed polygons: the outer one, counter-clockwise, then the holes, clockwise."""
        return sealed(self._of.outline(number))  # type: ignore[no-any-return]

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        return features(
            feature(self.outline(k), {"number": k, "area": float(area), "holes": self.holes(k)})
            for k, area in enumerate(self.area)
        )

    def __array__(self, dtype: Any = None) -> NDArray[Any]:
        """The areas."""
        return np.asarray(self.area, dtype)

    def to_pandas(self) -> pandas.DataFrame:
        """A row for each piece: `area`, `holes`."""
        import pandas

        table = {"area": self.area, "holes": [self.holes(k) for k in range(len(self))]}
        return pandas.DataFrame(table, index=pandas.RangeIndex(len(self), name="piece"))

    def __len__(self) -> int:
        return len(self._of)

    def __repr__(self) -> str:
        return f"<{len(self)} pieces, total area {self.area.sum():.15g}>"

    def _repr_html_(self) -> str:
        rows = [[str(k), f"{area:.15g}", str(self.holes(k))] for k, area in enumerate(self.area[:20])]
        more = f"<p>and {len(self) - 20} more</p>" if len(self) > 20 else ""
        return f"<p>{repr(self)[1:-1]}</p>" + html_table(["piece", "area", "holes"], rows) + more


class Regions(Recomputed):
    """The result of `regions`."""

    _function = "regions"

    def __init__(self, run: Run) -> None:
        self._run = run
        self._of = _lober.regions_of(run.of)

    @property
    def table(self) -> NDArray[Any]:
        """All pairs of winding numbers that occur but (0, 0): a structured array with fields `w1`, `w2`, `area`."""
        return self._of.table()

    @property
    def signed_area(self) -> tuple[float, float]:
        """Signed areas of C1 and C2: the sums of winding number times area."""
        return self._of.signed_areas()

    def area(self, rule: str = "nonzero") -> Areas:
        """Areas under a fill rule: nonzero, evenodd, positive or negative."""
        return self._of.areas(rule)

    def error(self, rule: str = "nonzero") -> AreaErrors:
        """Error bars of `area(rule)`: `rounding`."""
        return AreaErrors(self._of.rounding(rule))

    def rounding(self, area: float) -> float:
        """A bound on the rounding error of an area of the table or of a piece."""
        return self._of.rounding_of(area)

    def pieces(self, pairing: str = "c1_minus_c2", rule: str = "nonzero") -> RegionPieces:
        """The connected components; with one curve, `c1_minus_c2` is its region."""
        return RegionPieces(self._of.pieces(rule, pairing))

    def __repr__(self) -> str:
        return f"<Regions: {len(self.table)} pairs of winding numbers>"

    def _repr_html_(self) -> str:
        return areas_html("fill rule nonzero", self.area(), self.error())
