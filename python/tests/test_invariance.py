"""A flow of one's own has the same transport wherever its plane has its origin, in any unit, turned, reflected and run
backwards."""

from __future__ import annotations

import numpy as np
import pytest
import sympy

import lober

X, Y, T = sympy.symbols("x y t")
ITERATES = 4


def double_well(q, p, t):
    """A rocked double well without symmetry; the right well is bounded by the turnstile."""
    return p**2 / 2 - q**2 / 2 + q**4 / 4 + q**3 / 10 - sympy.cos(2 * t) * q**2 / 8


def moved(origin=(0.0, 0.0), turn=0.0, unit=(1.0, 1.0), reflected=False, backwards=False):
    """The system in other coordinates: its transport between the regions in the units of the first ones, with errors, and
    residues of its fixed points."""
    to_well = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]) / np.array(unit)
    if reflected:
        to_well[1] *= -1
    from_well = np.linalg.inv(to_well)
    q, p = sympy.Matrix(to_well) * sympy.Matrix([X - origin[0], Y - origin[1]])
    area = float(np.linalg.det(to_well))
    h = double_well(q, p, -T if backwards else T) * (-1 if backwards else 1) / area
    reach = np.abs(from_well) @ np.array([1.9, 1.3])
    window = (*(np.array(origin) - reach), *(np.array(origin) + reach))
    system = lober.hamiltonian(h, X, Y, T, period=sympy.pi, window=window)()
    outwards, inwards = from_well @ np.array([1.0, 1.0]), from_well @ np.array([1.0, -1.0])
    if backwards:
        outwards, inwards = inwards, outwards
    loop = lober.Connection(origin, tuple(outwards), origin, tuple(inwards))
    result = lober.transport(system, connection=loop, iterates=ITERATES)
    residues = sorted(point.residue for point in lober.fixed_points(system))
    scale = abs(area)
    return np.abs(result.total.value[:, 0, 1]) * scale, result.total.error[:, 0, 1] * scale, residues, result.to_dict()


@pytest.fixture(scope="module")
def at_home():
    return moved()


@pytest.mark.parametrize(
    "where",
    [
        {"origin": (10.0, 0.0)},
        {"origin": (0.5, -3.0)},
        {"origin": (1000.0, -1000.0)},
        {"turn": 0.7},
        {"turn": np.pi / 2},
        {"unit": (1e-10, 1e-10)},
        {"unit": (1e-3, 1e-3)},
        {"unit": (1e3, 1e3)},
        {"unit": (1e7, 1e7)},
        {"unit": (100.0, 0.01)},
        {"reflected": True},
        {"backwards": True},
        {"origin": (3.0, 2.0), "turn": 2.0, "unit": (7.0, 0.2), "reflected": True, "backwards": True},
    ],
    ids=str,
)
def test_transport_does_not_depend_on_coordinates(at_home, where):
    expected, at_most, residues, _ = at_home
    got, errors, others, result = moved(**where)
    assert result["agreement"]
    assert len(got) == ITERATES
    assert np.all(np.abs(got - expected) <= errors + at_most + 1e-11)
    assert errors.max() < 2e-3  # the bars say something
    # A turned window is larger, and may have more of them.
    assert all(min(abs(other - residue) for other in others) < 1e-5 for residue in residues)


def test_equal_units_have_equal_bars(at_home):
    for unit in (1e-10, 1e-3, 1e3, 1e7):
        errors = moved(unit=(unit, unit))[1]
        assert errors == pytest.approx(at_home[1], rel=0.01)
