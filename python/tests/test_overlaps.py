"""Many curves against many, in memory."""

from __future__ import annotations

import gc
import threading
import tracemalloc
import warnings
from typing import Any

import numpy as np
import pytest
from conftest import ring
from shapely.geometry import Polygon

import lober
from lober import _lober

with warnings.catch_warnings():  # of pyproj, where its data are not installed
    warnings.simplefilter("ignore")
    import geopandas


def wavy(count: int, points: int, seed: int, spread: float = 1.0) -> np.ndarray:
    """A matrix of complex numbers with a curve a row."""
    rng = np.random.default_rng(seed)
    angle = 2 * np.pi * np.arange(points) / points
    radius = 1 + 0.3 * np.cos(rng.integers(2, 6, (count, 1)) * angle + rng.uniform(0, 6, (count, 1)))
    centre = rng.uniform(-spread, spread, (count, 1)) + 1j * rng.uniform(-spread, spread, (count, 1))
    return centre + radius * np.exp(1j * angle)


A, B = wavy(12, 80, 1, 3), wavy(9, 70, 2, 3)
AREAS = ("intersection", "union", "c1_minus_c2", "c2_minus_c1", "symmetric_difference")
COUNTS = ("crossings", "touches", "shared_arcs")


def test_all_numbers_are_those_of_overlay() -> None:
    found = lober.overlap_matrix(A, B, [*AREAS, *COUNTS, *("rounding_" + name for name in AREAS)])
    for i, a in enumerate(A):
        for k, b in enumerate(B):
            r = lober.overlay(a, b)
            for name in AREAS:
                area, bound = getattr(r.area, name), getattr(r.error.rounding, name)
                if r.crossings:
                    assert (found[name][i, k], found["rounding_" + name][i, k]) == (area, bound)
                else:
                    assert abs(found[name][i, k] - area) <= found["rounding_" + name][i, k] + bound
            assert [found[name][i, k] for name in COUNTS] == [r.crossings, r.touches, r.shared_arcs]
    assert found["crossings"].dtype == np.int64 and found["intersection"].shape == (12, 9)


def test_every_kind_of_set_gives_the_same() -> None:
    expected = lober.overlap_matrix(A, B)
    stacked = np.stack([A.real, A.imag], axis=2)
    polygons = [Polygon(curve) for curve in stacked]
    offsets = np.arange(13) * 80
    sets: list[Any] = [
        stacked,
        list(A),
        [curve.tolist() for curve in stacked],
        (stacked.reshape(-1, 2), offsets),
        (A.ravel(), offsets.tolist()),
        polygons,
        geopandas.GeoSeries(polygons),
        geopandas.GeoDataFrame({"name": range(12)}, geometry=polygons),
        {f"day {k}": curve for k, curve in enumerate(A)},
        (curve for curve in A),
        np.asfortranarray(stacked),
    ]
    for one in sets:
        assert np.array_equal(lober.overlap_matrix(one, B), expected), type(one)


def test_one_set_is_symmetric() -> None:
    found = lober.overlap_matrix(A, what=("intersection", "c1_minus_c2", "c2_minus_c1", "shared_arcs"))
    assert np.array_equal(found["intersection"], found["intersection"].T)
    assert np.array_equal(found["c1_minus_c2"], found["c2_minus_c1"].T)
    assert np.array_equal(found["shared_arcs"], np.eye(12))
    assert found["intersection"].diagonal() == pytest.approx([abs(lober.area(a)) for a in A], rel=1e-15)


def test_sparse_matrices_have_the_pairs_that_meet() -> None:
    dense = lober.overlap_matrix(A, B, ("intersection", "crossings"))
    found = lober.overlap_matrix(A, B, ("intersection", "crossings"), sparse=True)
    assert np.array_equal(found["intersection"].toarray(), dense["intersection"])
    assert found["crossings"].nnz == np.count_nonzero(dense["intersection"]) < 12 * 9
    with pytest.raises(lober.UsageError, match="not 0 for curves that lie apart"):
        lober.overlap_matrix(A, B, "union", sparse=True)


def test_many_scattered_curves_are_not_all_compared() -> None:
    rng = np.random.default_rng(3)
    centres = rng.uniform(0, 1000, (20000, 1)) + 1j * rng.uniform(0, 1000, (20000, 1))
    squares = centres + np.array([0, 1, 1 + 1j, 1j])
    found = lober.overlap_matrix(squares, sparse=True)
    dx, dy = (np.abs(part[:, None] - part[None, :]) for part in (centres[:500, 0].real, centres[:500, 0].imag))
    expected = np.maximum(1 - dx, 0) * np.maximum(1 - dy, 0)
    assert np.allclose(found[:500, :500].toarray(), expected, rtol=0, atol=1e-9)
    assert found.nnz < 10 * len(squares)


def test_results_do_not_depend_on_threads() -> None:
    one, many = (lober.overlap_matrix(A, B, AREAS, threads=threads) for threads in (1, 5))
    assert all(np.array_equal(one[name], many[name]) for name in AREAS)


@pytest.mark.parametrize(
    "arguments, error, message",
    [
        ((A[0], B), lober.UsageError, "curves_a is one array of shape"),
        (([A[0], [[1, 2, 3]]], B), lober.UsageError, r"curves_a\[1\] is an array of shape"),
        ((A, ["file.dat"]), TypeError, r"curves_b\[0\]"),
        (("file.dat",), TypeError, "curves_a is of type str"),
        ((None,), TypeError, "curves_a is of type NoneType"),
        ((Polygon(np.eye(3)[:, :2]),), TypeError, "curves_a is one Polygon"),
        ((A, B, "interaction"), lober.UsageError, "'interaction' is not known; there are intersection, union"),
        ((A, B, ["rounding_crossings"]), lober.UsageError, "rounding_crossings"),
        (((A.ravel(), [0, 80, 70, 960]),), lober.UsageError, "offset 2 is less"),
        (((A.ravel(), [0, 80, 961]),), lober.UsageError, "number of points, 960"),
        (((A.ravel(), [-1, 80]),), lober.UsageError, "offsets go from 0"),
        (([A[0], [0, 1 + 1j, 1, 1j]],), lober.DataError, "curve 1: is not simple"),
        ((A, [[0j, 1, np.nan]]), lober.DataError, "second set: curve 0"),
    ],
)
def test_wrong_arguments_are_explained(arguments: tuple[Any, ...], error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        lober.overlap_matrix(*arguments)


def test_curves_that_cannot_be_used_are_nan_where_asked_for() -> None:
    curves = [A[0], [0, 1 + 1j, 1, 1j], A[2]]
    with pytest.warns(lober.IncompleteWarning, match="1 failures, the first: curve 1: is not simple"):
        lober.overlap_matrix(curves, keep_going=True)
    with pytest.warns(lober.IncompleteWarning, match="first set: curve 1: is not simple"):
        found = lober.overlap_matrix(curves, B, ("crossings", "union"), keep_going=True)
    assert np.isnan(found["union"][1]).all() and np.isnan(found["crossings"][1]).all()
    assert not np.isnan(found["union"][[0, 2]]).any()


def test_empty_sets() -> None:
    assert lober.overlap_matrix([], B).shape == (0, 9)
    assert lober.overlap_matrix(A, []).shape == (12, 0)
    assert lober.overlap_matrix([]).shape == (0, 0)


def test_progress_cancels_and_other_threads_run() -> None:
    calls: list[float | None] = []
    with pytest.raises(lober.Cancelled):
        lober.overlap_matrix(wavy(300, 300, 5), progress=lambda fraction, text: calls.append(fraction) or False)
    assert len(calls) == 1 and calls[0] is not None and 0 < calls[0] <= 1
    woke, ended = [0], threading.Event()

    def count() -> None:
        while not ended.wait(0.001):
            woke[0] += 1

    other = threading.Thread(target=count)
    other.start()
    lober.overlap_matrix(wavy(400, 300, 6), threads=1)
    ended.set()
    other.join()
    assert woke[0] > 10


def test_overlays_of_many_pairs_come_lazily_and_in_order() -> None:
    asked: list[int] = []

    def pairs() -> Any:
        for k in range(200):
            asked.append(k)
            yield A[k % 12], B[k % 9]

    results = lober.overlay_many(pairs(), threads=2)
    assert asked == []
    for k, r in enumerate(results):
        assert r.area == lober.overlay(A[k % 12], B[k % 9]).area
        assert len(asked) <= k + 6
    assert k == 199


def test_overlay_many_says_which_pair_cannot_be_used() -> None:
    results = lober.overlay_many([(A[0], B[0]), (A[1], [0, 1 + 1j, 1, 1j]), (A[2], B[2])])
    assert next(results).crossings >= 0
    with pytest.raises(lober.NotSimpleError, match="^pair 1: ") as raised:
        next(results)
    assert raised.value.curve == 2
    with pytest.raises(lober.UsageError, match="^pair 0: is not two curves"):
        next(lober.overlay_many([A[0]]))
    with pytest.raises(lober.Cancelled, match="after 1 pairs"):
        next(lober.overlay_many([(A[0], B[0])], progress=lambda fraction, text: False))
    results = lober.overlay_many([(A[0], B[0])] * 50)
    next(results)
    results.close()  # type: ignore[attr-defined]


def test_memory_does_not_grow_from_call_to_call() -> None:
    lober.overlap_matrix(A, B)
    gc.collect()
    tracemalloc.start()
    lober.overlap_matrix(A, B)
    gc.collect()
    before = tracemalloc.get_traced_memory()[0]
    for _ in range(50):
        lober.overlap_matrix(A, B)
    gc.collect()
    assert tracemalloc.get_traced_memory()[0] - before < 20_000
    tracemalloc.stop()


@pytest.mark.parametrize(
    "options, message",
    [
        ({"what": None}, "what is a name or a list of names, not NoneType"),
        ({"what": 3}, "what is a name or a list of names, not int"),
        ({"check_simple": "no"}, "check_simple cannot be 'no'"),
        ({"keep_going": []}, r"keep_going cannot be \[\]"),
    ],
)
def test_options_of_a_wrong_type(options, message):
    with pytest.raises(TypeError, match=message):
        lober.overlap_matrix([ring(50), ring(50, 0.5)], **options)


def test_the_engine_knows_its_options():
    points, offsets = np.zeros((0, 2)), np.zeros(1, np.int64)
    with pytest.raises(TypeError, match="there is no option mesures"):
        _lober.overlap_matrix(points, offsets, None, None, None, mesures=["union"])
    with pytest.raises(TypeError, match="threads cannot be 1267650600228229401496703205376"):
        _lober.overlap_matrix(points, offsets, None, None, None, threads=2**100)
