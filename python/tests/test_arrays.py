"""Objects that are taken as a curve, and that nothing is copied without need."""

from __future__ import annotations

import gc
import math
import weakref
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from conftest import ring
from shapely.geometry import LineString, MultiPoint, MultiPolygon, Point, Polygon

import lober
from lober._arrays import points_of


def address(array: np.ndarray) -> int:
    return array.__array_interface__["data"][0]


def test_arrays_of_doubles_are_not_copied():
    array = ring(100)
    assert points_of(array) is array
    count = 70_000  # more than a megabyte
    u = np.ascontiguousarray(np.stack([np.linspace(0, 6, count), np.sin(np.linspace(0, 6, count))], axis=1))
    s = np.ascontiguousarray(np.stack([np.linspace(6, 0, count), np.zeros(count) + 0.1], axis=1))
    t = lober.tangle(u, s)
    assert address(t.u) == address(u) and address(t.s) == address(s)
    assert not t.u.flags.writeable


def test_results_do_not_change_with_small_inputs():
    first, second = ring(1000), ring(1000, 0.5)
    r = lober.overlay(first, second)
    outline, nodes = r.pieces()[0].outline[0].copy(), r.nodes.copy()
    first *= 3
    second[:] = 0
    assert np.array_equal(r.pieces()[0].outline[0], outline) and np.array_equal(r._of.nodes(), nodes)


def test_arrays_of_results_are_read_only():
    r = lober.overlay(ring(100), ring(100, 0.5))
    pieces = r.pieces()
    arrays = [r.nodes, r.classes, pieces.area, pieces.centroids, pieces.slivers, *pieces[0].outline]
    t = lober.manifold_tangle("henon")
    arrays += [t.u, t.pips, t.lobes.area, t.lobes.outline(0), t.boundary.outline, t.overlaps]
    arrays += [lober.transport("henon", iterates=2).total.value, lober.sweep("standard", range="K=1:1.2:0.1").rows.value]
    for array in arrays:
        assert not array.flags.writeable
        with pytest.raises(ValueError):
            array[...] = array


def test_complex_vectors_are_not_copied():
    vector = np.exp(1j * np.linspace(0, 6, 50))
    assert address(points_of(vector)) == address(vector)
    np.testing.assert_array_equal(points_of(vector)[:, 1], vector.imag)


def test_results_are_views():
    r = lober.overlay(ring(1000), ring(1000, 0.5))
    areas = r.pieces("c1_minus_c2").area
    assert not areas.flags.owndata and not areas.flags.writeable
    assert address(areas) == address(r.pieces("c1_minus_c2").area)
    assert address(r.classes) == address(r.classes)
    with pytest.raises(ValueError):
        areas[0] = 0
    expected = areas.tolist()
    del r
    gc.collect()
    assert areas.tolist() == expected  # the view keeps the result alive


def test_results_keep_their_curves():
    array = ring(70_000)  # more than a megabyte
    alive = weakref.ref(array)
    r = lober.overlay(array, ring(1000, 0.5))
    del r._run  # which holds the arrays too, for pickles
    expected = r.nodes.tobytes()
    del array
    gc.collect()
    assert alive() is not None
    assert r._of.nodes().tobytes() == expected
    del r
    gc.collect()
    assert alive() is None


class WithInterface:
    def __init__(self, points):
        self.__geo_interface__ = Polygon(points).__geo_interface__


@pytest.mark.parametrize(
    "convert",
    [
        lambda a: a.tolist(),
        lambda a: [tuple(row) for row in a],
        lambda a: np.asfortranarray(a),
        lambda a: np.repeat(a, 2, axis=0)[::2],
        lambda a: a.astype(">f8"),
        lambda a: a.astype(np.longdouble),
        lambda a: a[:, 0] + 1j * a[:, 1],
        lambda a: (a[:, 0] + 1j * a[:, 1]).tolist(),
        lambda a: np.repeat(a[:, 0] + 1j * a[:, 1], 2)[::2],
        lambda a: np.frombuffer(b"\0" + a.tobytes(), dtype=np.uint8)[1:].view(np.float64).reshape(-1, 2),
        lambda a: Polygon(a),
        lambda a: Polygon(a).exterior,
        lambda a: LineString(np.concatenate([a, a[:1]])),
        lambda a: np.ma.masked_array(a),
        lambda a: a.astype(object),
        lambda a: MultiPolygon([Polygon(a)]),
        lambda a: Polygon(a).__geo_interface__,
        lambda a: {"type": "Feature", "geometry": Polygon(a).__geo_interface__, "properties": {}},
        lambda a: WithInterface(a),
        lambda a: pd.DataFrame(a),
        lambda a: pd.DataFrame({"t": range(len(a)), "Lat": a[:, 1], "Lon": a[:, 0]}),
        lambda a: pd.DataFrame({"y": a[:, 1], "x": a[:, 0]}),
        lambda a: pd.DataFrame({"LAT": a[:, 1], "LON": a[:, 0]}),
        lambda a: pd.DataFrame({"a": a[:, 0], "b": a[:, 1]}),
        lambda a: xr.DataArray(a, dims=("point", "coordinate")),
        lambda a: xr.DataArray(a[:, ::-1], dims=("point", "xy"), coords={"xy": ["y", "x"]}),
        lambda a: xr.DataArray(a[:, ::-1].T, dims=("c", "point"), coords={"c": ["latitude", "longitude"]}),
        lambda a: xr.DataArray(a, dims=("point", "xy"), coords={"xy": ["lon", "lat"]}),
        lambda a: xr.DataArray(a.T, dims=("coordinate", "point")),
        lambda a: xr.DataArray(a.T, dims=("component", "time")),
        lambda a: xr.Dataset({"x": ("point", a[:, 0]), "y": ("point", a[:, 1])}),
        lambda a: np.array([(y, 0, x) for x, y in a], [("lat", "f8"), ("t", "i4"), ("lon", "f8")]),
        lambda a: np.array([tuple(row) for row in a], [("x", "f8"), ("y", "f8")])[:, None][:, 0],
        lambda a: lober.Zone("one", a),
        lambda a: lober.CurveFile("a.dat", "text", "", [lober.Zone("one", a)]),
    ],
)
def test_what_is_converted(convert):
    array = ring(40)
    assert lober.overlay(convert(array), ring(30, 0.5)).area == lober.overlay(array, ring(30, 0.5)).area


def test_integers_and_single_precision():
    square = [[0, 0], [2, 0], [2, 2], [0, 2]]
    assert lober.area(square) == 4
    assert lober.area(np.array(square, dtype=np.float32)) == 4
    assert lober.area(np.array(square, dtype=np.uint8)) == 4


def test_geo_series():
    class Series(list):
        geom_type = ["Polygon"]

    assert lober.area(Series([Polygon([(0, 0), (1, 0), (1, 1)])])) == 0.5
    with pytest.raises(lober.UsageError, match="2 geometries"):
        lober.area(Series([Polygon(), Polygon()]))


@pytest.mark.parametrize(
    ("curve", "error", "text"),
    [
        (np.zeros((4, 3)), lober.UsageError, r"shape \(4, 3\)"),
        (np.zeros(4), lober.UsageError, r"shape \(4,\)"),
        (np.zeros((2, 2, 2)), lober.UsageError, r"shape \(2, 2, 2\)"),
        (np.zeros((2, 2), complex), lober.UsageError, "vector"),
        (3.0, lober.UsageError, r"shape \(\)"),
        (None, TypeError, "c1 is None; give an array of N x 2 numbers"),
        ("curve.npy", TypeError, r"c1 is a text; lober.read\('curve.npy'\) reads"),
        (Path("curve.npy"), TypeError, r"lober.read\('curve.npy'\)"),
        (object(), TypeError, "c1 is of type object"),
        (np.array([[0, 0], [1, object()]], dtype=object), TypeError, "c1 is of type ndarray, which holds no numbers"),
        (np.array([[0, 0], ["a", 1]], dtype=object), lober.UsageError, "c1 cannot be made an array"),
        (np.zeros((2, 10)), lober.UsageError, "give it as .T"),
        ({"x": 1}, lober.UsageError, "dictionary without a type"),
        ({"type": "Point", "coordinates": [0, 0]}, lober.UsageError, "c1 is a Point"),
        (pd.DataFrame(np.eye(3), columns=list("abc")), lober.UsageError, "no columns x and y, nor lon and lat: a, b, c"),
        (np.array([["a", "b"]]), TypeError, "dtype"),
        ([[0, 0], [1]], ValueError, "inhomogeneous"),
        ([], lober.DataError, "c1"),
        (np.empty((0, 2)), lober.DataError, "c1"),
        ([[0, 0], [1, 0]], lober.DataError, "c1"),
        ([[0, 0], [1, 0], [1, math.nan]], lober.DataError, "c1"),
        ([[0, 0], [1, 0], [1, math.inf]], lober.DataError, "c1"),
        (np.ma.masked_array(np.zeros((3, 2)), mask=[[1, 0], [0, 0], [0, 0]]), lober.UsageError, "masked"),
        (np.zeros(4, [("a", "f8"), ("b", "f8")]), lober.UsageError, "no columns x and y, nor lon and lat: a, b"),
        ({"type": "Polygon", "coordinates": [[[0, 0], [1]]]}, lober.UsageError, "c1 is not GeoJSON of a curve"),
        ({"type": "FeatureCollection"}, lober.UsageError, "c1 is not GeoJSON of a curve"),
        ({"type": "Polygon", "coordinates": 3}, lober.UsageError, "c1 is not GeoJSON of a curve"),
        (pd.Series({"name": "a", "geometry": None}), lober.UsageError, "c1 is a row without a geometry"),
        (Point(0, 0), lober.UsageError, "is a Point"),
        (MultiPoint([(0, 0)]), lober.UsageError, "MultiPoint"),
        (Point(0, 0).buffer(2) - Point(0, 0).buffer(1), lober.UsageError, "holes"),
    ],
)
def test_what_is_refused(curve, error, text):
    with pytest.raises(error, match=text):
        lober.overlay(curve, ring(10))


def test_curves_that_cross_themselves():
    bow = [[0, 0], [1, 1], [1, 0], [0, 1]]
    with pytest.raises(lober.NotSimpleError) as caught:
        lober.overlay(ring(10, 3), bow)
    error = caught.value
    assert error.curve == 2 and {error.segment1, error.segment2} == {0, 2} and error.at == (0.5, 0.5)
    assert isinstance(error, lober.DataError) and isinstance(error, ValueError) and isinstance(error, lober.Error)
    assert "0.5" in str(error)
    assert lober.regions(bow).area("evenodd").c1 == 0.5
