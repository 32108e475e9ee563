"""Maps and flows of one's own: the same numbers as the built-in ones."""

from __future__ import annotations

import math
import os
import signal
import threading
import time

import numpy as np
import pytest
import sympy

import lober

K = 0.9


@lober.map(
    params={"K": K},
    inverse=lambda x, y, K: (x - y, y - K * np.sin(x - y)),
    action=lambda x, to, K: 0.5 * (to - x) ** 2 - K * np.cos(x),
    lattice=(2 * np.pi, 0),
    connection=lober.Connection((0, 0), (1, 1), (2 * np.pi, 0), (-1, 1)),
)
def own_standard(x, y, K):
    """The standard map."""
    y = y + K * np.sin(x)
    return x + y, y


@lober.flow(
    period=lambda omega: 2 * np.pi / omega,
    params={"eps": 0.1, "omega": 1.0},
    hamiltonian=lambda x, y, t, eps, omega: y**2 / 2 - np.cos(x) - eps * x * np.cos(omega * t),
    lattice=(2 * np.pi, 0),
)
def own_pendulum(x, y, t, eps, omega):
    return y, -np.sin(x) + eps * np.cos(omega * t)


def pendulum_of_sympy(**options):
    q, p, t, eps = sympy.symbols("q p t eps")
    h = p**2 / 2 - sympy.cos(q) - eps * q * sympy.cos(t)
    return lober.hamiltonian(h, q, p, t, period=2 * sympy.pi, params={eps: 0.1}, **options)


@pytest.fixture(scope="module")
def built_in():
    return lober.system("pendulum")


def test_map_of_ones_own():
    k = lober.system("standard", {"K": K})
    points = np.random.default_rng(5).uniform(-3, 3, (3000, 2))
    own = own_standard(K=K)
    np.testing.assert_allclose(own.iterate(points, 3), k.iterate(points, 3), atol=1e-12)
    np.testing.assert_allclose(own.iterate(points, -2), k.iterate(points, -2), atol=1e-12)
    np.testing.assert_allclose(own.derivative(points[:50]), k.derivative(points[:50]), atol=1e-8)
    assert own.name == "own_standard" and own.summary == "The standard map." and own.parameters == {"K": K}
    assert own.lattice == (2 * math.pi, 0)


def test_calls_get_many_points_at_a_time():
    sizes = []

    def forward(x, y):
        sizes.append(len(x))
        return x + y, y

    shear = lober.map(forward, name="shear")()
    shear.iterate(np.zeros((10000, 2)))
    assert max(sizes) >= 4096
    sizes.clear()
    lober.section(shear, orbits=3000, iterates=4)
    assert max(sizes) == 3000 and len(sizes) == 4


def test_tangle_of_a_map_of_ones_own():
    own = lober.manifold_tangle(own_standard, tolerance=1e-4)
    assert own.agreement and own.period == 2
    areas = np.abs(own.area_by_action.value)
    assert areas[0] == pytest.approx(areas[1], abs=1e-10)  # the map has a symmetry


def test_flow_of_ones_own(built_in):
    points = np.random.default_rng(7).uniform(-2, 2, (300, 2))
    own = own_pendulum()
    np.testing.assert_allclose(own.iterate(points), built_in.iterate(points), atol=1e-9)
    np.testing.assert_allclose(own.iterate(own.iterate(points), -1), points, atol=1e-8)
    together = own.iterate(points)
    alone = np.concatenate([own.iterate(points[k : k + 1]) for k in range(20)])
    assert alone.tobytes() == together[:20].tobytes()
    fast = own_pendulum(omega=2.0)
    np.testing.assert_allclose(
        fast.iterate(points), lober.system("pendulum", omega=2).iterate(points), atol=1e-9
    )


def lobe_area(system) -> float:
    return float(np.abs(lober.manifold_tangle(system).area_by_action.value).max())


def test_pendulum_in_five_lines(built_in):
    q, p, t, eps = sympy.symbols("q p t eps")
    h = p**2 / 2 - sympy.cos(q) - eps * q * sympy.cos(t)
    across = lober.Connection((-sympy.pi - eps / 2, 0), (1, 1), (sympy.pi - eps / 2, 0), (-1, 1))
    pendulum = lober.hamiltonian(h, q, p, t, period=2 * sympy.pi, params={eps: 0.1}, connection=across)
    tangle = lober.manifold_tangle(pendulum)
    assert tangle.agreement
    expected = lobe_area(built_in)
    assert np.abs(tangle.area_by_action.value).max() == pytest.approx(expected, abs=1e-10)
    # To first order in eps, by Melnikov's integral.
    assert expected == pytest.approx(4 * math.pi * 0.1 / math.cosh(math.pi / 2), rel=1e-3)


def test_vectorised_flow_gives_the_same_lobe(built_in):
    across = built_in.connection
    tangle = lober.manifold_tangle(own_pendulum, across, tolerance=1e-3)
    assert np.abs(tangle.area_by_action.value).max() == pytest.approx(lobe_area(built_in), abs=1e-10)


def test_sympy_without_a_compiler(built_in):
    points = np.random.default_rng(8).uniform(-2, 2, (100, 2))
    compiled, vectorised = pendulum_of_sympy()(), pendulum_of_sympy(compiler="")()
    np.testing.assert_allclose(compiled.iterate(points), built_in.iterate(points), atol=1e-9)
    np.testing.assert_allclose(vectorised.iterate(points), built_in.iterate(points), atol=1e-9)
    assert compiled.dimension == 2 and compiled.period == pytest.approx(2 * math.pi)
    half = pendulum_of_sympy(phase=0.5)()
    np.testing.assert_allclose(
        half.iterate(points), lober.system("pendulum", phase=0.5).iterate(points), atol=1e-9
    )


def test_equations_of_sympy(built_in):
    x, y, t = sympy.symbols("x y t")
    family = lober.equations([y, -sympy.sin(x) + sympy.cos(t) / 10], [x, y], t, period=2 * sympy.pi)
    points = np.random.default_rng(9).uniform(-2, 2, (100, 2))
    np.testing.assert_allclose(family().iterate(points), built_in.iterate(points), atol=1e-9)
    with pytest.raises(lober.UsageError, match="k is neither a coordinate nor among params"):
        lober.equations([y, sympy.Symbol("k") * x], [x, y], t, period=1)
    with pytest.raises(lober.UsageError, match="two coordinates"):
        lober.equations([y], [x], t, period=1)


@pytest.mark.parametrize(
    ("function", "text"),
    [
        (lambda x, y: x, "has to give 2 coordinates, not"),
        (lambda x, y: (x, y, x), "not 3"),
        (lambda x, y: 3.0, "not one float"),
    ],
)
def test_functions_of_the_wrong_form(function, text):
    with pytest.raises(lober.UsageError, match=text):
        lober.map(function, name="wrong")().iterate(np.zeros((5, 2)))


def as_rows(x, y):
    return np.stack([x + y, y], axis=1)


@pytest.mark.parametrize("count", [1, 2, 3, 7])
@pytest.mark.parametrize("inverse", [False, True])
def test_one_array_of_points_is_refused_for_any_number_of_points(count, inverse):
    """For two points it was unpacked as (x, y): wrong numbers without a word."""
    points = np.arange(2.0 * count).reshape(count, 2)
    own = lober.map(lambda x, y: (x, y), inverse=as_rows, name="rows") if inverse else lober.map(as_rows, name="rows")
    for system in [own(), *([] if inverse else [lober.flow(lambda x, y, t: as_rows(x, y), period=1, name="rows")()])]:
        with pytest.raises(lober.UsageError, match="rows has to give 2 coordinates.*return two arrays"):
            system.iterate(points, -1 if inverse else 1)


@pytest.mark.parametrize("count", [1, 2, 3, 7])
def test_forms_of_coordinates(count):
    points = np.arange(2.0 * count).reshape(count, 2)
    expected = np.stack([points[:, 0] + points[:, 1], np.full(count, 2.0)], axis=1)
    for forward in (
        lambda x, y: (x + y, 2),
        lambda x, y: [x + y, np.array([2.0])],
        lambda x, y: np.stack([x + y, np.full_like(x, 2)]),
    ):
        np.testing.assert_array_equal(lober.map(forward)().iterate(points), expected)
    with pytest.raises(lober.UsageError, match="for each coordinate"):
        lober.map(lambda x, y: (x[:, None], y))().iterate(points)


def test_complex_coordinates_are_refused():
    """Their imaginary parts were left out, with a warning of NumPy at best."""
    circle = 0.3 * np.exp(2j * np.pi * np.arange(20) / 20)
    turn = lober.map(lambda x, y: (1j * x, y), name="turn")
    with pytest.raises(lober.UsageError, match="turn has to give real numbers"):
        lober.image(turn, circle, tolerance=1e-3)
    standard = lober.system("standard")
    image = lober.image(standard, circle, tolerance=1e-3).points
    np.testing.assert_array_equal(image, lober.image(standard, np.stack([circle.real, circle.imag], 1), tolerance=1e-3).points)
    at = np.array([0, 1j])
    for call in (
        lambda: lober.image(standard, circle, tolerance=1e-3, box=np.array([-1, -1, 1, 1 + 1j])),
        lambda: lober.fixed_point(standard, at),
        lambda: lober.grow(standard, tolerance=1e-3, length=1, from_=at),
        lambda: lober.system("standard", K=np.complex64(1 + 1j)),
        lambda: lober.flow(lambda x, y, t: (y, x), period=np.complex128(1 + 1j))(),
        lambda: lober.manifold_tangle(standard, lober.Connection(at, (1, 1), (0, 0), (1, 1))),
    ):
        with pytest.raises((lober.UsageError, TypeError), match="real|complex"):
            call()


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: lober.map(lambda x, y: (x + y, y), inverse=lambda x, y: (x - 2 * y, y), name="shear"), "inverse is not that"),
        (lambda: lober.map(lambda x, y: (x + y, y + np.sin(x)), lattice=(3, 0), name="turns"), "after its lattice"),
        (lambda: lober.flow(lambda x, y, t: (y, np.cos(t) - x), period=6, name="forced"), "after its period 6"),
        (lambda: lober.flow(lambda x, y, t: (y, -np.sin(x)), period=1, lattice=(1, 0), name="turns"), "after its lattice"),
    ],
)
def test_functions_that_do_not_belong_together(make, text):
    """They gave numbers without a word."""
    with pytest.raises(lober.DataError, match=text):
        make()()


def test_other_units_of_length():
    """Coordinates above a million counted as lost, whatever the window."""

    def pendulum(unit):
        edge = (-4 * unit, -2.5 * unit, 4 * unit, 2.5 * unit)
        field = lambda x, y, t: (y, unit * (0.1 * np.cos(t) - np.sin(x / unit)))  # noqa: E731
        return lober.flow(field, period=2 * np.pi, window=edge, name="pendulum")()

    at = np.array([[3.1, 0.2], [-0.4, 1.2]])
    for unit in (1e6, 1e9):
        np.testing.assert_allclose(pendulum(unit).iterate(at * unit) / unit, pendulum(1.0).iterate(at), atol=1e-9)


def test_expressions_are_finite():
    q, p, t = sympy.symbols("q p t")
    for bad in (sympy.nan, sympy.oo, sympy.zoo):
        with pytest.raises(lober.UsageError, match="is not finite"):
            lober.hamiltonian(p**2 / 2 + bad * q, q, p, t, period=1.0)


def test_exceptions_of_functions_pass_through():
    def fails(x, y):
        raise ZeroDivisionError("mine")

    bad = lober.map(fails)()
    for call in (lambda: bad.iterate(np.zeros((5, 2))), lambda: lober.fixed_points(bad), lambda: lober.section(bad)):
        with pytest.raises(ZeroDivisionError, match="mine"):
            call()


def test_parameters_of_families():
    assert "eps = 0.1" in repr(own_pendulum)
    with pytest.raises(lober.UsageError, match="has no parameter 'k'; it has: eps, omega"):
        own_pendulum(k=1)
    with pytest.raises(lober.UsageError, match="not finite"):
        own_pendulum(eps=math.nan)
    with pytest.raises(lober.UsageError, match="z is neither"):
        lober.map(lambda x, y, z: (x, y))
    with pytest.raises(lober.UsageError, match="no inverse"):
        lober.map(lambda x, y: (x, y), name="identity")().iterate(np.zeros((1, 2)), -1)
    with pytest.raises(lober.UsageError, match="period is not positive"):
        lober.flow(lambda x, y, t: (y, -x), period=0)()
    with pytest.raises(lober.UsageError, match="names? the saddles"):
        lober.manifold_tangle(own_pendulum)
    assert np.isnan(lober.map(lambda x, y: (x / 0, y), name="lost")().iterate(np.ones((2, 2)))).all()


def test_interrupt_in_a_function_of_ones_own():
    sent = []

    def interrupt():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.5, interrupt)
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            lober.section(own_pendulum, orbits=5000, iterates=1000)
        ended = time.monotonic()
    finally:
        timer.cancel()
        timer.join()
    assert sent and ended - sent[0] < 0.5


def in_units(unit):
    def map(x, y):
        p = y / unit + 0.9 * np.sin(x / unit)
        return (x / unit + p) * unit, p * unit

    def inverse(x, y):
        before = (x - y) / unit
        return before * unit, (y / unit - 0.9 * np.sin(before)) * unit

    return map, inverse


def test_fixed_points_do_not_depend_on_units():
    found = {}
    for unit in (1e-9, 1.0, 1e6):
        forward, inverse = in_units(unit)
        window = tuple(unit * edge for edge in (-1.1, -4.0, 5.3, 4.0))
        own = lober.map(forward, inverse=inverse, name="units", window=window)
        found[unit] = lober.fixed_points(own)
        one = lober.fixed_point(own, (3 * unit, 0.1 * unit))
        assert one.at == pytest.approx((np.pi * unit, 0), abs=1e-8 * unit)
    for unit, points in found.items():
        assert len(points) == len(found[1.0]) == 2
        for point, other in zip(points, found[1.0]):
            assert point.type == other.type
            assert np.array(point.at) / unit == pytest.approx(np.array(other.at), abs=1e-8)
            assert np.array(point.multipliers) == pytest.approx(np.array(other.multipliers), abs=1e-7)


def test_windows_that_do_not_fit_the_motion_are_refused():
    forward, inverse = in_units(1e-4)
    with pytest.raises(lober.DataError, match="give no derivatives"):
        lober.map(forward, inverse=inverse, name="units", window=(-1, -1, 1, 1))()


def test_sweeps_of_families():
    """The same rows as those of the built-in system, and Melnikov's function, whose perturbation is called eps."""
    by_sympy = pendulum_of_sympy()
    known = lober.system("pendulum").connection
    branches = dict(from_=known.from_saddle, to=known.to_saddle, u_direction=known.u_direction, s_direction=known.s_direction)
    swept = lober.sweep(by_sympy, range="eps=0.05:0.1:0.025", melnikov=True, **branches)
    built = lober.sweep("pendulum", range="eps=0.05:0.1:0.025", melnikov=True, **branches)
    assert swept.rows.failure == [None] * 3
    np.testing.assert_allclose(swept.rows.lobe_area12.value, built.rows.lobe_area12.value, atol=1e-8)
    np.testing.assert_allclose(swept.rows.first_order, built.rows.first_order, atol=1e-8)
    # From a member the others are made by the same family.
    again = lober.sweep(by_sympy(eps=0.3), range="eps=0.05:0.1:0.025", **branches)
    np.testing.assert_array_equal(again.rows.lobe_area12.value, swept.rows.lobe_area12.value)
    periodic = pendulum_of_sympy(lattice=(2 * math.pi, 0))
    compared = lober.transport(periodic(), connection=known, iterates=1, melnikov=True).to_dict()["melnikov"]
    assert compared["zeros"]
    with pytest.raises(lober.UsageError, match="has no parameter 'k'"):
        lober.sweep(by_sympy, range="k=0:1:1", **branches)


def test_melnikov_asks_for_many_points_at_once():
    """A call of a Python function costs as much as a thousand points: it is not called for each of them."""
    calls = {}

    def velocity(x, y, t, eps):
        calls[np.size(x)] = calls.get(np.size(x), 0) + 1
        return y, -np.sin(x) + eps * np.cos(t)

    def energy(x, y, t, eps):
        return y * y / 2 - np.cos(x) - eps * x * np.cos(t)

    known = lober.system("pendulum").connection
    branches = dict(from_=known.from_saddle, to=known.to_saddle, u_direction=known.u_direction, s_direction=known.s_direction)
    own = lober.flow(
        velocity, period=2 * np.pi, params={"eps": 0.1}, hamiltonian=energy, window=(-3.2, -3, 3.2, 3), lattice=(2 * np.pi, 0)
    )
    counts, rows = [], []
    for melnikov in (False, True):
        calls.clear()
        rows.append(lober.sweep(own, range="eps=0.05:0.05:1", tolerance=1e-4, melnikov=melnikov, **branches).rows)
        counts.append(dict(calls))
    built = lober.sweep("pendulum", range="eps=0.05:0.05:1", tolerance=1e-4, melnikov=True, **branches)
    np.testing.assert_allclose(rows[1].first_order, built.rows.first_order, rtol=1e-12)
    # 155 000 calls, one for each point, before.
    assert sum(counts[1].values()) - sum(counts[0].values()) < 40_000, counts
    assert max(counts[1]) > 100 and sum(count for size, count in counts[1].items() if size > 100) > 500


def test_sweeps_note_values_without_a_system():
    def between(eps):
        if eps > 0.07:
            raise lober.DataError("no saddle is there")
        return lober.Connection((0, 0), (1, 1), (0, 0), (1, -1))

    def fails(x, y, t, eps):
        if eps > 0.12:
            raise ZeroDivisionError("mine")
        return y, x - x**3 + eps * x * np.cos(t)

    options = dict(period=2 * np.pi, params={"eps": 0.05}, window=(-2, -1.2, 2, 1.2))
    family = lober.flow(fails, connection=between, **options)
    swept = lober.sweep(family, range="eps=0.05:0.1:0.05", tolerance=1e-3)
    assert swept.rows.failure == [None, "no saddle is there"]
    with pytest.raises(ZeroDivisionError, match="mine"):
        lober.manifold_tangle(lober.flow(fails, connection=between(0), **options)(eps=0.2))
