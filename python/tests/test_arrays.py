"""Objects that are taken as a curve, and that nothing is copied without need."""

from __future__ import annotations

import gc
import math
import weakref

import numpy as np
import pytest
from conftest import ring
from shapely.geometry import LineString, MultiPoint, Point, Polygon

import lober
from lober._arrays import points_of


def address(array: np.ndarray) -> int:
    return array.__array_interface__["data"][0]


def test_arrays_of_doubles_are_not_copied():
    array = ring(100)
    assert points_of(array) is array
    u = np.ascontiguousarray(np.stack([np.linspace(0, 6, 300), np.sin(np.linspace(0, 6, 300))], axis=1))
    s = np.ascontiguousarray(np.stack([np.linspace(6, 0, 300), np.zeros(300) + 0.1], axis=1))
    t = lober.tangle(u, s)
    assert address(t.u) == address(u) and address(t.s) == address(s)
    assert not t.u.flags.writeable


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
    array = ring(1000)
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
        (None, TypeError, "dtype object"),
        ("curve.npy", TypeError, "dtype"),
        (np.array([["a", "b"]]), TypeError, "dtype"),
        ([[0, 0], [1]], ValueError, "inhomogeneous"),
        ([], lober.DataError, "c1"),
        (np.empty((0, 2)), lober.DataError, "c1"),
        ([[0, 0], [1, 0]], lober.DataError, "c1"),
        ([[0, 0], [1, 0], [1, math.nan]], lober.DataError, "c1"),
        ([[0, 0], [1, 0], [1, math.inf]], lober.DataError, "c1"),
        (np.ma.masked_array(np.zeros((3, 2)), mask=[[1, 0], [0, 0], [0, 0]]), lober.UsageError, "masked"),
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
