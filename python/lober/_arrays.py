"""Curves as arrays of N x 2 doubles, without a copy where that is possible."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._geometry import array_of_geometry
from .errors import UsageError

Points = NDArray[np.float64]

#: Inputs that a result keeps are copied up to this number of bytes, so that it does not change with them.
COPIED = 1 << 20


def points_of(curve: Any, name: str = "curve") -> Points:
    """The points of a curve as a C-contiguous array of N x 2 doubles.

    No copy is made of an array that is one already, nor of a contiguous vector of complex128. Other numbers are
    converted. Taken are arrays and sequences of N x 2 numbers, vectors of complex numbers, and what stands for a curve
    elsewhere (_geometry.py): polygons without holes, rings and lines of shapely and GeoJSON, objects with
    `__geo_interface__`, a row of a GeoDataFrame, tables, structured arrays and datasets with
    columns x and y, DataArrays.
    """
    if not isinstance(curve, np.ndarray) or curve.dtype.names is not None:
        curve = array_of_geometry(curve, name)
    if isinstance(curve, np.ma.MaskedArray) and np.ma.getmaskarray(curve).any():
        raise UsageError(f"{name} has masked points; remove them first")
    try:
        array = np.asarray(curve)
        if array.dtype.kind == "O":
            array = np.array(array.tolist(), dtype=np.float64)
    except ValueError as error:
        raise UsageError(f"{name} cannot be made an array of N x 2 numbers: {error}") from None
    except TypeError:
        raise TypeError(f"{name} is of type {type(curve).__name__}, which holds no numbers; points are N x 2 numbers") from None
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
        advice = "; this is its transpose, give it as .T" if array.ndim == 2 and array.shape[0] == 2 else ""
        raise UsageError(f"{name} is an array of shape {array.shape}; points are N x 2 or a complex vector{advice}")
    return np.require(array, np.float64, ["C", "A"])


def kept_points_of(curve: Any, name: str) -> Points:
    """The same for a result that keeps the points: a copy, unless they take more than a megabyte."""
    points = points_of(curve, name)
    return points.copy() if points.nbytes <= COPIED else points


def sealed(array: Any) -> Any:
    """An array that a result hands out, or several: read-only, so that the result stays what it is."""
    if isinstance(array, np.ndarray):
        array.flags.writeable = False
    elif isinstance(array, (list, tuple)):
        for one in array:
            sealed(one)
    elif isinstance(array, dict):
        sealed(list(array.values()))
    return array
