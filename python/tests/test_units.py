"""Systems of one's own in any units: the same orbits, returns and fixed points as in units of order one."""

from __future__ import annotations

import numpy as np
import pytest
import sympy

import lober

MASS, DEPTH, RATE, PERIOD = 1.66e-27, 7e-19, 2e10, 1e-14
LENGTH, MOMENTUM, TIME = 1 / RATE, np.sqrt(MASS * DEPTH), np.sqrt(MASS / DEPTH) / RATE
Q, P = sympy.symbols("q p")


def morse(mass, depth, rate, period, tolerance=1e-12):
    return lober.hamiltonian(P**2 / (2 * mass) + depth * (1 - sympy.exp(-rate * Q)) ** 2, Q, P, period=period)(
        integration_tolerance=tolerance
    )


@pytest.mark.parametrize("start", [(5e-11, 1e-24), (5e-11, 0), (0, 1e-24), (-1e-11, -2e-24)])
def test_orbits_of_a_molecule_in_si_units_are_those_in_its_own_units(start):
    si, own = morse(MASS, DEPTH, RATE, PERIOD), morse(1, 1, 1, PERIOD / TIME, 1e-14)
    units = np.array([LENGTH, MOMENTUM])
    at = np.array([start])
    for iterates in (1, 20, -3):
        got, expected = si.iterate(at, iterates) / units, own.iterate(at / units, iterates)
        assert np.abs(got - expected).max() < 1e-10 * np.abs(expected).max()
    # The coordinates pass through zero on the way: the energy is kept all the same.
    energy = lambda z: z[:, 1] ** 2 / (2 * MASS) + DEPTH * (1 - np.exp(-RATE * z[:, 0])) ** 2
    assert energy(si.iterate(at, 20)) == pytest.approx(energy(at), rel=1e-10)


def test_a_rest_point_stays_in_any_units():
    assert morse(MASS, DEPTH, RATE, PERIOD).iterate(np.array([[0.0, 0.0]])).tolist() == [[0, 0]]


def gyre(x, y, t):
    a = 0.25 * np.sin(2 * np.pi * t)
    f, slope = a * x * x + (1 - 2 * a) * x, 2 * a * x + 1 - 2 * a
    return -0.1 * np.pi * np.sin(np.pi * f) * np.cos(np.pi * y), 0.1 * np.pi * np.cos(np.pi * f) * np.sin(np.pi * y) * slope


def test_walls_where_a_velocity_is_zero_but_for_rounding_are_kept():
    walls = np.array([[0.3, 1.0], [0.3, 0.0], [0.0, 0.4], [2.0, 0.4]])
    own = lober.flow(gyre, period=1.0, window=(0, 0, 2, 1))()
    ends = own.iterate(walls, 5)
    assert np.abs(ends[:2, 1] - walls[:2, 1]).max() < 1e-14
    assert np.abs(ends[2:, 0] - walls[2:, 0]).max() < 1e-14
    assert len(lober.fixed_points(own, grid=8)) > 0


X, Y, PX, PY = sympy.symbols("x y px py")


def henon_heiles(length):
    x, y, px, py = (one / length for one in (X, Y, PX, PY))
    h = ((px**2 + py**2 + x**2 + y**2) / 2 + x**2 * y - y**3 / 3) * length**2
    return lober.section_system(
        h,
        coordinates=[X, Y, PX, PY],
        section="x=0",
        energy=length**2 / 8,
        window=(-0.5 * length, -0.5 * length, 0.7 * length, 0.5 * length),
    )()


@pytest.mark.parametrize("length", [1e-20, 1e-10, 1e-6, 1e7, 1.5e11])
def test_returns_to_a_section_do_not_depend_on_the_unit_of_length(length):
    system, unit = henon_heiles(length), henon_heiles(1.0)
    at = np.array([[0.1, 0.1], [0.3, -0.1]])
    assert system.iterate(at * length, 5) / length == pytest.approx(unit.iterate(at, 5), abs=1e-10)
    found, expected = lober.fixed_points(system), lober.fixed_points(unit)
    assert len(found) == len(expected) == 7
    assert found.settled
    # Points at x = 0 but for rounding come in any order.
    parts = lambda points, unit: sorted((round(p.at[0] / unit, 6) + 0.0, p.at[1] / unit, p.residue) for p in points)
    assert np.array(parts(found, length)) == pytest.approx(np.array(parts(expected, 1)), abs=1e-6)


def test_an_escape_names_the_coordinates_of_its_system():
    q1, q2, p1, p2 = sympy.symbols("q1 q2 p1 p2")
    h = (p1**2 + p2**2 + q1**2 + q2**2) / 2 + q1**2 * q2 - q2**3 / 3
    family = lober.section_system(
        h, coordinates=[q1, q2, p1, p2], section="q2=0", energy=0.18, window=(-0.6, -0.6, 0.9, 0.6), saddles=[(0, 1)]
    )
    options = dict(saddle="0,1", direction="-", crossings=0)
    orbit = lober.escape(family(), section="q2=-0.2", **options).bottlenecks[0]
    assert orbit.area.value == pytest.approx(lober.escape(family(), section="y=-0.2", **options).bottlenecks[0].area.value)
    with pytest.raises(lober.UsageError, match="has to be q1 or q2, not"):
        lober.escape(family(), section="p1=0", **options)
