"""Fixed points that are not isolated: they fill a curve or an area."""

from __future__ import annotations

import time

import numpy as np
import pytest

import lober


def found_in(map_, **options):
    begun = time.monotonic()
    found = lober.fixed_points(lober.map(map_)(), **options)
    assert time.monotonic() - begun < 20
    return found


@pytest.mark.parametrize(
    "map_",
    [
        lambda x, y: (x, y),
        lambda x, y: (x + y - 0.3, y),
        lambda x, y: (x + y * y - 0.25, y),
        lambda x, y: (x, 0.5 * y + 0.2 * np.sin(3 * x)),
    ],
    ids=["identity", "shear", "curved shear", "attracting curve"],
)
def test_fixed_points_that_fill_a_curve_or_an_area_are_said_to(map_):
    found = found_in(map_, box=(0, -1, 1, 1))
    assert not found.isolated
    assert not found.settled
    assert 6 <= len(found) <= 100
    assert max(one.residual for one in found) < 1e-6


def test_points_of_the_standard_map_without_a_kick_are_not_isolated():
    found = lober.fixed_points(lober.system("standard", K=0))
    assert not found.isolated


def test_isolated_points_stay_isolated_even_where_they_are_degenerate():
    # A saddle-node where it is born, and the Henon map.
    found = found_in(lambda x, y: (x + x * x, 0.5 * y), box=(-1, -1, 1, 1.1))
    assert found.isolated
    assert lober.fixed_points("henon").isolated
