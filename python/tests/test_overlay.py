"""Overlay, interior method and winding numbers."""

from __future__ import annotations

import copy
import math
import pickle
import threading

import numpy as np
import pytest
from conftest import ring

import lober


def test_areas_of_squares(squares):
    r = lober.overlay(*squares)
    assert (r.area.c1, r.area.c2, r.area.intersection) == (4, 4, 1)
    assert (r.area.c1_minus_c2, r.area.c2_minus_c1, r.area.union) == (3, 3, 7)
    assert r.area.symmetric_difference == 6
    assert r.crossings == 2 and r.touches == 0 and r.shared_arcs == 0
    assert r.orientation == ("counter_clockwise", "counter_clockwise")
    assert 0 <= r.error.rounding.c1_minus_c2 < 1e-14
    assert r.error.discretisation.c1_minus_c2 >= 0


def test_nodes_are_those_of_the_curves(squares):
    nodes = lober.overlay(*squares).nodes
    assert {(float(n["x"]), float(n["y"])) for n in nodes} == {(2.0, 1.0), (1.0, 2.0)}
    assert sorted(nodes["rho"]) == [-1, 1]
    assert sorted(nodes["order2"]) == [0, 1]
    assert set(zip(nodes["segment1"].tolist(), nodes["t1"].tolist())) == {(1, 0.5), (2, 0.5)}


def test_pieces(squares):
    r = lober.overlay(*squares)
    pieces = r.pieces("c1_minus_c2")
    assert len(pieces) == 1 and pieces.area.tolist() == [3.0]
    assert pieces[0].holes == 0 and pieces[-1].area == 3
    assert sorted(pieces[0].crossings.tolist()) == [0, 1]
    (outline,) = pieces[0].outline
    assert lober.area(outline) == 3
    np.testing.assert_allclose(r.pieces("intersection").centroids, [[1.5, 1.5]], rtol=1e-15)
    assert len(r.pieces("c1_minus_c2").slivers) == 0
    with pytest.raises(IndexError):
        pieces[1]
    with pytest.raises(lober.UsageError, match="c1_minus_c2, c2_minus_c1, intersection, union"):
        r.pieces("c1")


def test_totals_only(squares):
    r = lober.overlay(*squares, areas_only=True)
    assert r.area.c1_minus_c2 == 3 and len(r.pieces("c1_minus_c2")) == 0


def test_circle_with_hole():
    r = lober.overlay(ring(400, radius=2), ring(300))
    piece = r.pieces("c1_minus_c2")[0]
    assert piece.holes == 1 and len(piece.outline) == 2
    assert lober.area(piece.outline[0]) > 0 > lober.area(piece.outline[1])


def test_classes_and_sigma():
    r = lober.overlay(ring(500), ring(500, 0.5 + 0.1j))
    assert r.class_count == 1 and r.classes.tolist() == [0, 0]
    steps = r.sigma("c1_minus_c2")
    assert 0.5 * steps["s"].sum() == pytest.approx(r.area.c1_minus_c2, rel=1e-13)


def test_smooth_areas_are_those_of_circles():
    r = lober.overlay(ring(200), ring(200, 1.0))
    lens = 2 * math.pi / 3 - math.sqrt(3) / 2
    exact = math.pi - lens
    assert abs(r.smooth.area.c1_minus_c2 - exact) <= r.smooth.error.c1_minus_c2 < 1e-6
    assert abs(r.area.c1_minus_c2 - exact) > 1e-5
    assert abs(r.area.c1_minus_c2 - exact) < 4 * r.error.discretisation.c1_minus_c2


def test_interior_method_agrees_with_overlay():
    first, second = ring(1000), ring(900, 0.3 + 0.2j, 0.9)
    a, b = lober.overlay(first, second), lober.interior(first, second)
    for name in ("c1", "c2", "intersection", "union", "c1_minus_c2", "c2_minus_c1"):
        bar = getattr(a.error.rounding, name) + getattr(b.error.rounding, name)
        assert abs(getattr(a.area, name) - getattr(b.area, name)) <= bar
    assert b.q[0] == pytest.approx(a.area.symmetric_difference, rel=1e-13)
    ends = lober.interior(first, second, method="ends", passes=3, points=9)
    assert ends.area.c1_minus_c2 == pytest.approx(a.area.c1_minus_c2, abs=1e-5)
    with pytest.raises(lober.UsageError, match="split, ends"):
        lober.interior(first, second, method="middle")


def test_winding():
    numbers, on = lober.winding(ring(8), [[0, 0], [2, 0], [1, 0]])
    assert numbers.tolist() == [1, 0, 0] and on.tolist() == [False, False, True]
    assert numbers.dtype == np.int32 and on.dtype == np.bool_
    twice = np.concatenate([ring(8), ring(8, radius=1.5)])
    assert lober.winding(twice[::-1], [[0, 0]])[0].tolist() == [-2]
    values = lober.interior_function(ring(8), [[0, 0], [2, 0]])
    np.testing.assert_allclose(values, [2 * math.pi, 0], atol=1e-14)
    with pytest.raises(lober.DataError, match="point 1 is not finite"):
        lober.winding(ring(8), [[0, 0], [math.nan, 0]])


def test_pickle_gives_the_same_bits():
    r = lober.overlay(ring(300), ring(200, 0.4), areas_only=True)
    for again in (pickle.loads(pickle.dumps(r)), copy.deepcopy(r)):
        assert again.area == r.area
        assert again.nodes.tobytes() == r.nodes.tobytes()
        assert len(again.pieces("c1_minus_c2")) == 0
    areas = pickle.loads(pickle.dumps(r.area))
    assert areas == r.area and areas != lober.overlay(ring(300), ring(200, 0.5)).area


def test_threads_do_not_change_a_bit():
    first, second = ring(20000), ring(20000, 0.1 + 0.1j)
    expected = lober.overlay(first, second, threads=1)
    for threads in (0, 2, 3):
        r = lober.overlay(first, second, threads=threads)
        assert r.area == expected.area and r.nodes.tobytes() == expected.nodes.tobytes()
    with pytest.raises(lober.UsageError, match="threads"):
        lober.overlay(first, second, threads=-1)


def test_calls_from_several_python_threads():
    shapes = [(ring(3000 + k), ring(2000 + k, 0.1 * k)) for k in range(8)]
    expected = [lober.overlay(*pair).area for pair in shapes]
    found = [[] for _ in shapes]

    def work(k):
        for _ in range(5):
            found[k].append(lober.overlay(*shapes[k]).area)

    workers = [threading.Thread(target=work, args=(k,)) for k in range(len(shapes))]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert all(areas == [area] * 5 for areas, area in zip(found, expected))


def test_names_for_people(squares):
    r = lober.overlay(*squares)
    assert "C1 \\ C2 = 3" in repr(r)
    html = r._repr_html_()
    assert html.count("<tr>") == 8 and "discretisation" in html
    assert "area 3" in repr(r.pieces()[0]) and "3" in repr(r.pieces())
    assert repr(r.area).startswith("Areas(c1=4.0, c2=4.0, intersection=1.0, union=7.0")
    assert "rounding" in lober.interior(*squares)._repr_html_()
    assert set(r.timing) == {"index", "check", "crossings", "order", "areas", "total"}
    assert 0 < r.timing["index"] < r.timing["total"]
