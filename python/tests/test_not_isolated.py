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


def test_a_map_without_its_inverse_has_points_of_longer_periods():
    def logistic(x, y):
        return 3.2 * x * (1 - x), 0.5 * y + x - 0.5

    found = lober.fixed_points(lober.map(logistic)(), box=(-0.2, -2.1, 1.2, 2.2), period=2)
    assert found.settled
    of_period_2 = sorted(one.at[0] for one in found if one.period == 2)
    # The two of the logistic map, (1 + r +- sqrt((r - 3) (r + 1))) / 2 r.
    assert of_period_2 == pytest.approx([0.5130445095326298, 0.7994554904673701], abs=1e-12)
