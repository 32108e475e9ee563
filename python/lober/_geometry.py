"""Geometries of others as arrays: shapely, `__geo_interface__`, xarray, tables."""

from __future__ import annotations

from typing import Any, Mapping

import numpy as np

from .errors import UsageError

#: Names of x and of y, in tables, datasets and labels, in any case.
COORDINATES = ((("x",), ("y",)), (("lon", "longitude", "long", "lng"), ("lat", "latitude")))


def array_of_geometry(curve: Any, name: str) -> Any:
    """An object that NumPy can make an array of, for a curve that is none. Raises UsageError, TypeError."""
    if curve is None:
        raise TypeError(f"{name} is None; give an array of N x 2 numbers, a complex vector or a polygon")
    if isinstance(curve, (str, bytes)) or hasattr(curve, "__fspath__"):
        raise TypeError(f"{name} is a text; lober.read({str(curve)!r}) reads a curve of a file")
    if hasattr(curve, "zones"):
        if len(curve.zones) != 1:
            raise UsageError(f"{name} is a file of {len(curve.zones)} curves; give one of its zones")
        return curve.zones[0].points
    if isinstance(getattr(curve, "points", None), np.ndarray):  # a zone, a manifold, an image
        return curve.points
    if hasattr(curve, "dims"):
        return array_of_labelled(curve, name)
    if isinstance(curve, np.ndarray):  # a structured one
        return np.stack([curve[one] for one in _named(curve.dtype.names, name)], axis=-1)
    geometry = getattr(curve, "geometry", None)
    if geometry is None and hasattr(curve, "geometry"):
        raise UsageError(f"{name} is a row without a geometry")
    if geometry is not None and hasattr(geometry, "geom_type"):  # a table of geopandas, or a row of one
        return array_of_geometry(_only(geometry, name), name)
    if hasattr(curve, "geom_type"):
        return _of_shapely(_only(curve, name), name)
    if hasattr(curve, "columns") and hasattr(curve, "to_numpy"):
        return _of_table(curve, name)
    mapping = getattr(curve, "__geo_interface__", curve)
    if not isinstance(mapping, Mapping):
        return curve
    try:
        return _of_mapping(mapping, name)
    except UsageError:
        raise
    except (ValueError, TypeError, LookupError, AttributeError):
        raise UsageError(f"{name} is not GeoJSON of a curve, whose coordinates are a list of points") from None


def _only(geometry: Any, name: str) -> Any:
    if isinstance(geometry.geom_type, str):
        return geometry
    if len(geometry) != 1:
        raise UsageError(f"{name} holds {len(geometry)} geometries; give one")
    return geometry.iloc[0] if hasattr(geometry, "iloc") else geometry[0]


def _of_shapely(geometry: Any, name: str) -> Any:
    kind = geometry.geom_type
    if kind in ("MultiPolygon", "MultiLineString") and len(geometry.geoms) == 1:
        return _of_shapely(geometry.geoms[0], name)
    if kind == "Polygon":
        if len(geometry.interiors) > 0:
            raise UsageError(f"{name} is a polygon with holes; give one closed curve")
        geometry = geometry.exterior
    elif kind not in ("LineString", "LinearRing"):
        raise UsageError(f"{name} is a {kind}; give a Polygon, a LinearRing or a LineString")
    array = np.asarray(geometry.coords, dtype=np.float64).reshape(len(geometry.coords), -1)
    return array[:, :2]


def _of_mapping(geometry: Mapping[str, Any], name: str) -> Any:
    """GeoJSON as a dictionary."""
    kind = geometry.get("type")
    if kind == "FeatureCollection":
        if len(geometry["features"]) != 1:
            raise UsageError(f"{name} holds {len(geometry['features'])} features; give one")
        return array_of_geometry(geometry["features"][0], name)
    if kind == "Feature":
        return _of_mapping(geometry["geometry"] or {}, name)
    parts = geometry.get("coordinates", ())
    if kind in ("MultiPolygon", "MultiLineString") and len(parts) == 1:
        kind, parts = kind.removeprefix("Multi"), parts[0]
    if kind == "Polygon":
        if len(parts) > 1:
            raise UsageError(f"{name} is a polygon with holes; give one closed curve")
        parts = parts[0] if parts else ()
    elif kind not in ("LineString", "LinearRing"):
        raise UsageError(f"{name} is a {kind or 'dictionary without a type'}; give a Polygon or a LineString")
    return np.array([point[:2] for point in parts], dtype=np.float64).reshape(-1, 2)


def _of_table(table: Any, name: str) -> Any:
    """Columns x and y by their names, or the only two, whose names say nothing, in their order."""
    chosen = _known(table.columns)
    if chosen is None and len(table.columns) == 2:
        return table.to_numpy()
    return table[chosen or _named(table.columns, name)].to_numpy()


def _known(names: Any) -> list[Any] | None:
    """Those of x and y among names, in this order; None where there are not both."""
    by_lower = {str(one).lower(): one for one in names}
    for all_x, all_y in COORDINATES:
        x, y = (next((one for one in words if one in by_lower), None) for words in (all_x, all_y))
        if x is not None and y is not None:
            return [by_lower[x], by_lower[y]]
    return None


def _named(names: Any, name: str) -> list[Any]:
    known = _known(names)
    if known is not None:
        return known
    raise UsageError(f"{name} has no columns x and y, nor lon and lat: {', '.join(map(str, names))}")


def array_of_labelled(given: Any, name: str) -> Any:
    """A DataArray of xarray as an array whose last axis are the coordinates, or a complex one; a Dataset has x and y."""
    if hasattr(given, "data_vars"):
        x, y = (given[one] for one in _named([*given.data_vars, *given.coords], name))
        if x.dims != y.dims:
            raise UsageError(f"{name}: {x.name} and {y.name} have different dimensions, {x.dims} and {y.dims}")
        return np.stack([x.values, y.values], axis=-1)
    array = given.values
    if array.dtype.kind == "c" or array.ndim < 2:
        return array
    if given.dims[-1] in ("coordinate", "xy", "axis"):
        return _in_order(array, given, array.ndim - 1)
    pairs = [k for k, size in enumerate(array.shape) if size == 2]
    named = [k for k in pairs if given.dims[k] in ("coordinate", "xy", "axis", "component")]
    axis = named[0] if named else pairs[-1] if pairs else array.ndim - 1
    return np.moveaxis(_in_order(array, given, axis), axis, -1)


def _in_order(array: Any, given: Any, axis: int) -> Any:
    """With x before y along the axis, where its labels name them."""
    dimension = given.dims[axis]
    labels = [str(one) for one in given.coords[dimension].values] if dimension in given.coords else []
    known = _known(labels)
    if len(labels) != 2 or known is None or known == labels:
        return array
    return np.flip(array, axis)
