"""Curves as arrays of N x 2 doubles, without a copy where that is possible."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import UsageError

Points = NDArray[np.float64]


def points_of(curve: Any, name: str = "curve") -> Points:
    """The points of a curve as a C-contiguous array of N x 2 doubles.

    No copy is made of an array that is one already, nor of a contiguous vector of complex128. Other numbers are
    converted. Taken are arrays and sequences of N x 2 numbers, vectors of complex numbers, and polygons without holes,
    rings and lines that have `exterior` or `coords` as those of shapely have. A GeoSeries of one geometry is that
    geometry.
    """
    if not isinstance(curve, np.ndarray):
        curve = _of_geometry(curve, name)
    if isinstance(curve, np.ma.MaskedArray) and np.ma.getmaskarray(curve).any():
        raise UsageError(f"{name} has masked points; remove them first")
    array = np.asarray(curve)
    if array.dtype.kind not in "fiubc":
        raise TypeError(f"{name} is an array of dtype {array.dtype}; points are numbers")
    if array.dtype.kind == "c":
        if array.ndim != 1:
            raise UsageError(f"{name} is a complex array of shape {array.shape}; complex points are a vector")
        vector = np.require(array, np.complex128, ["C", "A"])
        return vector.view(np.float64).reshape(-1, 2)
    if array.ndim != 2 or array.shape[1] != 2:
        if array.size == 0 and array.ndim == 1:
            return np.empty((0, 2))
        raise UsageError(f"{name} is an array of shape {array.shape}; points are N x 2 or a complex vector")
    return np.require(array, np.float64, ["C", "A"])


def _of_geometry(curve: Any, name: str) -> Any:
    if getattr(curve, "geom_type", None) is not None and not isinstance(curve.geom_type, str):
        if len(curve) != 1:
            raise UsageError(f"{name} holds {len(curve)} geometries; give one")
        curve = curve.iloc[0] if hasattr(curve, "iloc") else curve[0]
    kind = getattr(curve, "geom_type", None)
    if kind is None:
        return curve
    if kind == "Polygon":
        if len(curve.interiors) > 0:
            raise UsageError(f"{name} is a polygon with holes; give one closed curve")
        curve = curve.exterior
    elif kind not in ("LineString", "LinearRing"):
        raise UsageError(f"{name} is a {kind}; give a Polygon, a LinearRing or a LineString")
    array = np.asarray(curve.coords, dtype=np.float64).reshape(len(curve.coords), -1)
    return array[:, :2]
