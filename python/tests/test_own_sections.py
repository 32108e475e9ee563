"""Return maps of flows of one's own: the digits of the built-in three-body problem, by three ways to give it."""

from __future__ import annotations

import math
import pickle
import time

import numpy as np
import pytest
import sympy

import lober

MU = 9.537e-4
WINDOW = (-3, -0.5, -1.05, 0.5)
HILL = (MU / 3) ** (1 / 3)
SADDLES = [(1 - MU - HILL, 0), (1 - MU + HILL, 0)]


def velocity(x, y, px, py, mu):
    """The three-body problem."""
    a, b = x + mu, x - 1 + mu
    pull1 = (1 - mu) / (a * a + y * y) ** 1.5
    pull2 = mu / (b * b + y * y) ** 1.5
    return px + y, py - x, py - a * pull1 - b * pull2, -px - y * (pull1 + pull2)


def energy_of(x, y, px, py, mu):
    kinetic = (px**2 + py**2) / 2 + px * y - py * x
    return kinetic - (1 - mu) / np.hypot(x + mu, y) - mu / np.hypot(x - 1 + mu, y) - mu * (1 - mu) / 2


three_body = lober.section_system(
    velocity,
    hamiltonian=energy_of,
    section="y=0",
    bound="x<-1",
    energy=-1.525,
    params={"mu": MU},
    saddles=lambda mu: [(1 - mu - (mu / 3) ** (1 / 3), 0), (1 - mu + (mu / 3) ** (1 / 3), 0)],
    window=WINDOW,
    name="own",
)


@lober.section_system(section="y=0", bound="x<-1", energy=-1.525, params={"mu": MU}, hamiltonian=energy_of, window=WINDOW)
def decorated(x, y, px, py, mu):
    """By a decorator."""
    return velocity(x, y, px, py, mu)


def of_sympy(**options):
    x, y, px, py, mu = sympy.symbols("x y px py mu")
    r1, r2 = sympy.sqrt((x + mu) ** 2 + y**2), sympy.sqrt((x - 1 + mu) ** 2 + y**2)
    h = (px**2 + py**2) / 2 + px * y - py * x - (1 - mu) / r1 - mu / r2 - mu * (1 - mu) / 2
    hill = sympy.cbrt(mu / 3)
    given = dict(
        coordinates=[x, y, px, py],
        section="y=0",
        bound="x<-1",
        energy=-1.525,
        params={mu: MU},
        saddles=[(1 - mu - hill, 0), (1 - mu + hill, 0)],
        window=WINDOW,
        name="of_sympy",
    )
    return lober.section_system(h, **{**given, **options})


@pytest.fixture(scope="module")
def built_in():
    return lober.system("pcr3bp")


def ways():
    return {"compiled": of_sympy(), "numpy": of_sympy(compiler=""), "function": three_body, "decorator": decorated}


@pytest.mark.parametrize("way", ["compiled", "numpy", "function", "decorator"])
def test_images_are_those_of_the_built_in_system(way, built_in):
    points = np.random.default_rng(3).uniform((-2.4, -0.1), (-1.9, 0.1), (200, 2))
    own = ways()[way]()
    assert own.dimension == 4 and own.parameters == {"mu": MU, "energy": -1.525}
    for iterates in (1, -2):
        expected = built_in.iterate(points, iterates)
        assert np.isfinite(expected).sum() > 300
        np.testing.assert_allclose(own.iterate(points, iterates), expected, atol=1e-9)
    # Derivatives by differences are good to nine digits.
    exact = 1e-8 if way in ("compiled", "numpy") else 1e-6
    expected = built_in.derivative(points[:20])
    np.testing.assert_allclose(own.derivative(points[:20]), expected, atol=exact * np.abs(expected).max())


@pytest.mark.parametrize("way", ["compiled", "function"])
def test_fixed_points_are_those_of_the_built_in_system(way, built_in):
    began = time.monotonic()
    own = lober.fixed_points(ways()[way]())
    assert time.monotonic() - began < 200  # seconds on an idle machine
    theirs = lober.fixed_points(built_in)
    assert [point.type for point in own] == [point.type for point in theirs]
    np.testing.assert_allclose(own.at, theirs.at, atol=2e-11)
    # Derivatives by differences are good to six digits at a saddle.
    exact = 1e-9 if way == "compiled" else 1e-6
    for mine, other in zip(own, theirs):
        assert mine.multipliers[0] == pytest.approx(other.multipliers[0], rel=exact)


def test_searches_ask_seldom_and_for_few_velocities():
    asked = []

    def counted(x, y, px, py, mu):
        asked.append(len(x))
        return velocity(x, y, px, py, mu)

    own = lober.section_system(
        counted, hamiltonian=energy_of, section="y=0", bound="x<-1", energy=-1.525, params={"mu": MU}, window=WINDOW
    )()
    assert len(lober.fixed_points(own, grid=12)) == 4
    # Half a million calls and 39 million velocities before iterations that creep were ended, shortened steps were tried
    # without derivatives, and these were taken along tangent vectors.
    assert len(asked) < 200_000 and sum(asked) < 10_000_000


@pytest.mark.parametrize("mass", [MU, 0.01215])
def test_parameters_are_those_of_the_built_in_system(mass):
    points = np.random.default_rng(4).uniform((-2.2, -0.1), (-1.9, 0.1), (50, 2))
    built = lober.system("pcr3bp", mu=mass, energy=-1.57)
    for family in (of_sympy(), three_body):
        own = family(mu=mass, energy=-1.57)
        # Some pass near the smaller body: images are as far apart as rounding is stretched.
        stretch = np.abs(built.derivative(points)).max(axis=(1, 2))
        apart = np.abs(own.iterate(points) - built.iterate(points)).max(axis=1)
        assert np.isfinite(apart).sum() > 20
        assert np.nanmax(apart / (1 + stretch**2)) < 1e-9
        assert [saddle[0] for saddle in own.saddles] == pytest.approx([saddle[0] for saddle in built.saddles])


def test_tangle_of_ones_own_section(built_in):
    own = of_sympy(connection=built_in.connection)
    mine, theirs = lober.manifold_tangle(own), lober.manifold_tangle(built_in)
    assert mine.agreement
    np.testing.assert_allclose(mine.area_by_action.value, theirs.area_by_action.value, atol=1e-10)


@pytest.mark.parametrize("way", ["compiled", "function"])
def test_levels_are_those_of_the_built_in_system(way, built_in):
    box, grid = (-1.5, -1.5, 1.5, 1.5), (60, 60)
    mine = lober.levels(ways()[way](), energy=-1.525, box=box, grid=grid)
    theirs = lober.levels(built_in, energy=-1.525, box=box, grid=grid)
    assert len(mine.levels.outline) == len(theirs.levels.outline) > 0
    for one, other in zip(mine.levels.outline, theirs.levels.outline):
        np.testing.assert_allclose(one, other, atol=1e-9)
    np.testing.assert_allclose(mine.saddles.energy, theirs.saddles.energy, atol=1e-12)


def test_tubes_at_another_mass_ratio():
    """Earth and Moon: Hill's region, the tube of L1 into the realm of the Earth, and what leaves that of the Moon."""
    own, built = of_sympy()(mu=0.01215, energy=-1.59), lober.system("pcr3bp", mu=0.01215, energy=-1.59)
    mine, theirs = (lober.levels(system, energy=-1.59) for system in (own, built))
    np.testing.assert_allclose(mine.levels.outline[0], theirs.levels.outline[0], atol=1e-9)
    inwards = dict(saddle="1", section="y=0", direction="-", bound="x<0", crossings=0)
    one, other = (lober.escape(system, **inwards) for system in (own, built))
    assert one.agreement
    assert one.bottlenecks[0].orbit_period == pytest.approx(other.bottlenecks[0].orbit_period, abs=1e-10)
    assert one.bottlenecks[0].area.value == pytest.approx(other.bottlenecks[0].area.value, abs=1e-12)
    assert abs(lober.area(one.bottlenecks[0].entry[0])) == pytest.approx(one.bottlenecks[0].area.value, rel=1e-5)
    through = dict(energy=-1.5915, section="x=0.98785", crossings=1, tolerance=1e-4, monte_carlo=500)
    table, again = (lober.escape(system, **through) for system in (own, built))
    assert table.agreement and table.table["fraction"][0] > 0.2
    np.testing.assert_allclose(table.table["fraction"], again.table["fraction"], atol=1e-7)


def test_escape_of_ones_own_well():
    """Henon and Heiles' potential, by expressions and by functions: the same bottleneck and tubes."""
    x, y, px, py = sympy.symbols("x y px py")
    h = (px**2 + py**2) / 2 + (x**2 + y**2) / 2 + x**2 * y - y**3 / 3
    at = [(math.sqrt(3) / 2, -0.5), (-math.sqrt(3) / 2, -0.5), (0, 1)]
    common = dict(section="x=0", energy=0.18, saddles=at, window=(-0.6, -0.6, 0.9, 0.6))
    by_sympy = lober.section_system(h, coordinates=[x, y, px, py], name="henon_heiles", **common)
    by_function = lober.section_system(
        lambda x, y, px, py: (px, py, -x - 2 * x * y, -y - x * x + y * y),
        hamiltonian=lambda x, y, px, py: (px**2 + py**2 + x**2 + y**2) / 2 + x**2 * y - y**3 / 3,
        **common,
    )
    options = dict(saddle="0,1", section="y=-0.2", direction="-", crossings=0)
    mine, other = lober.escape(by_sympy, **options), lober.escape(by_function, **options)
    assert mine.agreement and other.agreement
    assert mine.bottlenecks[0].area.value == pytest.approx(other.bottlenecks[0].area.value, rel=1e-8)
    two = dict(saddle="1;2", section="x=0", energy=0.17, crossings=1, tolerance=1e-4, monte_carlo=500)
    table = lober.escape(by_sympy, **two)
    assert table.agreement and len(table.bottlenecks) == 2


def test_three_coordinates():
    built = lober.system("abc")
    a, b, c = (built.parameters[key] for key in ("A", "B", "C"))

    def abc(x, y, z):
        sin, cos = np.sin, np.cos
        return a * sin(z) + c * cos(y), b * sin(x) + a * cos(z), c * sin(y) + b * cos(x)

    window = built.window
    own = lober.section_system(abc, section="z=0", angle=2 * np.pi, window=window)()
    points = np.random.default_rng(8).uniform(window[:2], window[2:], (100, 2))
    expected = built.iterate(points)
    assert np.isfinite(expected).any()
    np.testing.assert_allclose(own.iterate(points), expected, atol=1e-8)


def test_pickles():
    points = np.random.default_rng(5).uniform((-2.2, -0.1), (-1.9, 0.1), (20, 2))
    for system in (of_sympy()(mu=0.001), three_body(mu=0.001), decorated(mu=0.001), lober.system("pcr3bp", mu=0.001)):
        again = pickle.loads(pickle.dumps(system))
        assert again.parameters == system.parameters
        np.testing.assert_array_equal(again.iterate(points), system.iterate(points))
    local = lober.map(lambda x, y: (x + y, y), name="local")
    try:
        import cloudpickle  # noqa: F401
    except ImportError:
        with pytest.raises(pickle.PicklingError, match="system local cannot be pickled: .* define it at the top of a module"):
            pickle.dumps(local())
    else:
        np.testing.assert_array_equal(pickle.loads(pickle.dumps(local())).iterate(points), local().iterate(points))


def test_compiled_functions_at_an_address(built_in):
    numba = pytest.importorskip("numba")
    from numba import types

    number, pointer = types.float64, types.CPointer(types.float64)

    @numba.cfunc(types.int32(pointer, pointer, number, pointer))
    def rates(p, s, t, d):
        mu, x, y, px, py = p[0], s[0], s[1], s[2], s[3]
        a, b = x + mu, x - 1 + mu
        r1, r2 = a * a + y * y, b * b + y * y
        pull1, pull2 = (1 - mu) / (r1 * math.sqrt(r1)), mu / (r2 * math.sqrt(r2))
        d[0] = px + y
        d[1] = py - x
        d[2] = py - a * pull1 - b * pull2
        d[3] = -px - y * (pull1 + pull2)
        return 0

    @numba.cfunc(number(pointer, pointer, number))
    def h(p, s, t):
        mu, x, y, px, py = p[0], s[0], s[1], s[2], s[3]
        kinetic = (px * px + py * py) / 2 + px * y - py * x
        r1, r2 = math.hypot(x + mu, y), math.hypot(x - 1 + mu, y)
        return kinetic - (1 - mu) / r1 - mu / r2 - mu * (1 - mu) / 2

    family = lober.section_system(
        rates, hamiltonian=h, section="y=0", bound="x<-1", energy=-1.525, params={"mu": MU}, window=WINDOW, name="numba"
    )
    points = np.random.default_rng(6).uniform((-2.4, -0.1), (-1.9, 0.1), (2000, 2))
    np.testing.assert_allclose(family().iterate(points), built_in.iterate(points), atol=1e-9)
    mine, theirs = lober.fixed_points(family()), lober.fixed_points(built_in)
    np.testing.assert_allclose(mine.at, theirs.at, atol=2e-11)
    with pytest.raises(lober.UsageError, match="numba.cfunc"):
        lober.section_system(rates, hamiltonian=energy_of, section="y=0", energy=-1.525, params={"mu": MU})()


@pytest.mark.parametrize(
    ("options", "text"),
    [
        ({"section": "z=0"}, "'z' is not a coordinate; the coordinates are x, y, px, py"),
        ({"section": "y"}, "section has to be a text like 'y=0'"),
        ({"section": "y=zero"}, "'zero' is not a number"),
        ({"direction": 0}, "direction has to be 1 or -1"),
        ({"bound": "x=1"}, "bound has to be a text like 'x<-1'"),
        ({"energy": None}, "energy is missing"),
        ({"hamiltonian": None, "energy": None}, "a flow of 4 coordinates has no return map"),
        ({"saddles": [(1, 2, 3)]}, "a saddle is a position of 2 numbers or a state of 4"),
    ],
)
def test_sections_that_do_not_fit(options, text):
    given = dict(section="y=0", energy=-1.525, params={"mu": MU}, hamiltonian=energy_of, window=WINDOW)
    with pytest.raises(lober.UsageError, match=text):
        lober.section_system(velocity, **{**given, **options})()


def test_hamiltonian_and_velocity_have_to_belong_together():
    wrong = lambda x, y, px, py, mu: energy_of(x, y, px, py, mu) + 0.1 * px  # noqa: E731
    with pytest.raises(lober.DataError, match="the Hamiltonian, or the velocity"):
        lober.section_system(velocity, hamiltonian=wrong, section="y=0", energy=-1.525, params={"mu": MU}, window=WINDOW)()

    def fails(x, y, px, py, mu):
        raise ZeroDivisionError("mine")

    bad = lober.section_system(fails, hamiltonian=energy_of, section="y=0", energy=-1.525, params={"mu": MU}, window=WINDOW)()
    with pytest.raises(ZeroDivisionError, match="mine"):
        bad.iterate([(-2, 0.0)])
