"""Many curves as one array of points with offsets."""

from __future__ import annotations

from typing import Any, Iterable, Mapping

import numpy as np
from numpy.typing import NDArray

from ._arrays import Points, points_of
from .errors import UsageError

#: Points of all curves, and where each begins, with the number of points at the end.
CurveSet = tuple[Points, NDArray[np.int64]]

KINDS = (
    "a list of curves, a GeoSeries, an array of curves x points x 2 numbers, a matrix of complex numbers with a curve a "
    "row, or (points, offsets) where curve k are the points offsets[k]:offsets[k + 1]"
)


def curve_set_of(curves: Any, name: str) -> CurveSet:
    """Raises UsageError or TypeError, which names the curve. (points, offsets) are not copied where they fit."""
    if isinstance(curves, tuple) and len(curves) == 2 and _are_offsets(curves[1]):
        offsets = np.asarray(curves[1])
        return points_of(curves[0], f"points of {name}"), np.ascontiguousarray(offsets, dtype=np.int64)
    if isinstance(curves, np.ndarray) and (curves.ndim == 3 or (curves.ndim == 2 and curves.dtype.kind == "c")):
        return _stacked(curves, name)
    if isinstance(curves, np.ndarray) and curves.dtype != object and curves.ndim > 0 and curves.size > 0:
        raise UsageError(f"{name} is one array of shape {curves.shape}; give {KINDS}")
    arrays = [points_of(curve, f"{name}[{k}]") for k, curve in enumerate(_each(curves, name))]
    offsets = np.zeros(len(arrays) + 1, np.int64)
    np.cumsum([len(array) for array in arrays], out=offsets[1:])
    return (np.concatenate(arrays) if arrays else np.empty((0, 2))), offsets


def _are_offsets(given: Any) -> bool:
    return isinstance(given, (np.ndarray, list, range)) and np.ndim(given) == 1 and np.asarray(given).dtype.kind in "iu"


def _stacked(curves: NDArray[Any], name: str) -> CurveSet:
    count, points = curves.shape[:2]
    flat = curves.reshape(-1) if curves.dtype.kind == "c" else curves.reshape(-1, curves.shape[2])
    return points_of(flat, name), np.arange(count + 1, dtype=np.int64) * points


def _each(curves: Any, name: str) -> Iterable[Any]:
    if hasattr(curves, "geom_type") and isinstance(curves.geom_type, str):
        raise TypeError(f"{name} is one {curves.geom_type}; give {KINDS}")
    if isinstance(curves, Mapping):
        return curves.values()
    if hasattr(curves, "zones"):
        return [zone.points for zone in curves.zones]
    if hasattr(curves, "geometry"):  # a GeoSeries or a GeoDataFrame
        return list(curves.geometry)
    if isinstance(curves, (str, bytes)) or not isinstance(curves, Iterable):
        raise TypeError(f"{name} is of type {type(curves).__name__}; give {KINDS}")
    return curves
