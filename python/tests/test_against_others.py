"""Random polygons against shapely and against exact arithmetic."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from shapely.geometry import Polygon, shape
from shapely.ops import unary_union

import lober


@st.composite
def star_polygons(draw) -> list[tuple[int, int]]:
    """Simple polygons with corners on a grid: sorted by angle about a centre, one for each direction."""
    centre_x, centre_y = draw(st.integers(-20, 20)), draw(st.integers(-20, 20))
    directions = [(1, 0), (3, 1), (2, 1), (1, 1), (1, 2), (0, 1), (-1, 2), (-1, 1), (-2, 1), (-1, 0)]
    directions += [(-3, -1), (-1, -1), (-1, -2), (0, -1), (1, -2), (1, -1), (2, -1)]
    lengths = draw(st.lists(st.integers(1, 9), min_size=len(directions), max_size=len(directions)))
    points = [(centre_x + r * x, centre_y + r * y) for (x, y), r in zip(directions, lengths)]
    return points[::-1] if draw(st.booleans()) else points


def exact_area(polygon) -> Fraction:
    points = [(Fraction(x), Fraction(y)) for x, y in polygon]
    return sum((a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1])), Fraction(0)) / 2


@given(star_polygons())
def test_area_is_exact(polygon):
    assert Fraction(lober.area(polygon)) == exact_area(polygon)


@given(star_polygons(), star_polygons())
def test_areas_are_those_of_shapely(first, second):
    r = lober.overlay(first, second)
    a, b = Polygon(first), Polygon(second)
    expected = {
        "intersection": a.intersection(b).area,
        "union": a.union(b).area,
        "c1_minus_c2": a.difference(b).area,
        "c2_minus_c1": b.difference(a).area,
        "symmetric_difference": a.symmetric_difference(b).area,
    }
    for name, value in expected.items():
        assert abs(getattr(r.area, name) - value) <= 1e-9, name
    for pairing in ("intersection", "union", "c1_minus_c2", "c2_minus_c1"):
        pieces = r.pieces(pairing)
        assert abs(pieces.area.sum() - getattr(r.area, pairing)) <= 1e-10


@given(star_polygons(), star_polygons())
def test_areas_add_up_exactly_within_their_bars(first, second):
    """|A1| + |A2| = |A1 u A2| + |A1 n A2|, and |A1 \\ A2| = |A1| - |A1 n A2|, with |A1| known as a fraction."""
    r = lober.overlay(first, second)
    bars = r.error.rounding
    a1, a2 = abs(exact_area(first)), abs(exact_area(second))
    assert Fraction(r.area.c1) == a1 and Fraction(r.area.c2) == a2
    union, both = Fraction(r.area.union), Fraction(r.area.intersection)
    assert abs(union + both - a1 - a2) <= Fraction(bars.union) + Fraction(bars.intersection)
    assert abs(Fraction(r.area.c1_minus_c2) + both - a1) <= Fraction(bars.c1_minus_c2) + Fraction(bars.intersection)


@given(st.lists(star_polygons(), min_size=1, max_size=6), st.lists(star_polygons(), min_size=1, max_size=6))
def test_matrices_are_those_of_shapely_and_of_fractions(first, second):
    found = lober.overlap_matrix(first, second, ("intersection", "union", "rounding_union", "rounding_intersection"))
    sparse = lober.overlap_matrix(first, second, sparse=True).toarray()
    assert np.array_equal(sparse, found["intersection"])
    for i, a in enumerate(first):
        for k, b in enumerate(second):
            assert abs(found["intersection"][i, k] - Polygon(a).intersection(Polygon(b)).area) <= 1e-9
            total = Fraction(found["union"][i, k]) + Fraction(found["intersection"][i, k])
            bars = Fraction(found["rounding_union"][i, k]) + Fraction(found["rounding_intersection"][i, k])
            assert abs(total - abs(exact_area(a)) - abs(exact_area(b))) <= bars
    one = lober.overlap_matrix(first, what=("intersection", "shared_arcs"))
    assert [Fraction(area) for area in one["intersection"].diagonal()] == [abs(exact_area(a)) for a in first]
    assert (one["shared_arcs"].diagonal() == 1).all() and np.array_equal(one["intersection"], one["intersection"].T)


@given(star_polygons(), star_polygons())
def test_pieces_are_the_polygons_of_shapely(first, second):
    r = lober.overlay(first, second)
    expected = {"intersection": Polygon(first).intersection(Polygon(second)), "union": Polygon(first).union(Polygon(second))}
    for pairing, polygon in expected.items():
        found = unary_union([shape(piece.__geo_interface__["geometry"]).buffer(0) for piece in r.pieces(pairing)])
        assert found.symmetric_difference(polygon).area <= 1e-9


@given(star_polygons(), st.lists(st.tuples(st.integers(-30, 30), st.integers(-30, 30)), min_size=1, max_size=20))
def test_winding_is_exact(polygon, points):
    numbers, on = lober.winding(polygon, points)
    for (x, y), number, lies_on in zip(points, numbers, on):
        expected_on, expected = winding_by_fractions(polygon, x, y)
        assert (bool(lies_on), int(number)) == (expected_on, expected)


def winding_by_fractions(polygon, x, y) -> tuple[bool, int]:
    turns = 0
    for (ax, ay), (bx, by) in zip(polygon, polygon[1:] + polygon[:1]):
        cross = (bx - ax) * (y - ay) - (by - ay) * (x - ax)
        if cross == 0 and min(ax, bx) <= x <= max(ax, bx) and min(ay, by) <= y <= max(ay, by):
            return True, 0
        if ay <= y < by and cross > 0:
            turns += 1
        if by <= y < ay and cross < 0:
            turns -= 1
    return False, turns


@given(st.lists(st.tuples(st.integers(-9, 9), st.integers(-9, 9)), min_size=3, max_size=12))
def test_regions_of_any_polygon_add_up(polygon):
    """Regions of polygons that cross and overlap themselves at will."""
    points = np.array(polygon, dtype=float)
    if len(np.unique(points, axis=0)) < 3:
        return
    r = lober.regions(points)
    total = sum(Fraction(float(row["area"])) * int(row["w1"]) for row in r.table)
    assert abs(total - exact_area(polygon)) <= Fraction(1, 10**10)
