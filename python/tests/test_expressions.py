"""Systems of expressions: all numbers are doubles in C and in NumPy, and no text becomes code."""

from __future__ import annotations

import numpy as np
import pytest
import sympy

import lober

q, p, t = sympy.symbols("q p t")
ALL = pytest.mark.parametrize("compiler", [None, ""], ids=["compiled", "vectorised"])


def oscillator(stiffness, compiler=None, **options):
    """H = p^2/2 + stiffness q^2/2: a rotation where stiffness is 1."""
    return lober.hamiltonian(p**2 / 2 + stiffness * q**2 / 2, q, p, t, period=1, compiler=compiler, **options)


@ALL
@pytest.mark.parametrize("c", [2**31, 2**32, 2**64, 6 * 10**23, 10**100])
def test_whole_numbers_of_any_size(c, compiler):
    k = sympy.Symbol("k")
    angle = np.array([[0.5, 0.0]])
    expected = 0.5 * np.array([[np.cos(1), -np.sin(1)]])
    family = oscillator(sympy.Integer(c) * k, compiler, params={k: 1 / c})
    np.testing.assert_allclose(family().iterate(angle), expected, atol=1e-11)


@ALL
def test_fractions_and_constants_are_doubles(compiler):
    stiffness = sympy.Rational(10**40, 3 * 10**40 + 3) * 3 * sympy.EulerGamma / sympy.EulerGamma.evalf(30)
    image = oscillator(stiffness, compiler)().iterate(np.array([[1.0, 0.0]]))
    np.testing.assert_allclose(image, [[np.cos(1), -np.sin(1)]], atol=1e-11)


@ALL
def test_numbers_that_no_double_holds(compiler):
    with pytest.raises(lober.UsageError, match="too large for a double; scale the units"):
        oscillator(sympy.Integer(10) ** 400, compiler)()


def test_functions_that_both_forms_have():
    """Functions with other names in C and NumPy: remainders, roots of negative numbers, maxima with constants."""
    velocity = [p + sympy.Mod(-t, sympy.Rational(1, 10)) + sympy.sqrt(sympy.Max(1, p)), -q + sympy.cbrt(q) + sympy.Abs(p)]
    families = [lober.equations(velocity, (q, p), t, period=sympy.Rational(1, 10), compiler=c) for c in (None, "")]
    points = np.random.default_rng(4).uniform(-2, 2, (200, 2))
    compiled, vectorised = (family().iterate(points) for family in families)
    np.testing.assert_allclose(compiled, vectorised, atol=1e-9)
    assert np.isfinite(compiled).any()


@ALL
@pytest.mark.parametrize(
    "force",
    [
        p / sympy.sec(q) + sympy.cot(q + 5) ** 2,
        sympy.coth(q + 5) ** 2 - 1 / sympy.csch(q + 5),
        sympy.erf(q) + sympy.exp(-q * p),
        sympy.Abs(q) * sympy.sign(p) + sympy.Heaviside(q - 1),
        sympy.Piecewise((q**2, q < 0), (q**3, True)),
        sympy.cosh(10 * q) - sympy.sinh(10 * q),
    ],
    ids=str,
)
def test_velocities_are_those_of_sympy(force, compiler):
    """For a period of next to nothing the image is x + period * velocity."""
    period = 1e-4
    system = lober.equations([p, force], (q, p), t, period=period, compiler=compiler, window=(-1, -1, 1, 1))()
    points = np.random.default_rng(3).uniform(-0.9, 0.9, (20, 2))
    expected = [float(force.subs({q: x, p: y}).evalf(30)) for x, y in points]
    velocity = (system.iterate(points)[:, 1] - points[:, 1]) / period
    np.testing.assert_allclose(velocity, expected, rtol=5e-2, atol=5e-3)


def test_functions_that_c_does_not_have():
    with pytest.raises(lober.UsageError, match='Derivative cannot be written in C; give compiler=""'):
        lober.equations([p, sympy.Mod(q, 2)], (q, p), t, period=1)
    with pytest.raises(lober.UsageError, match="cannot be written in NumPy"):
        lober.equations([p, sympy.besselj(1, q)], (q, p), t, period=1, compiler="")
    remainder = lober.equations([p, sympy.Mod(q, 2) - q], (q, p), t, period=1, compiler="")()
    assert np.isfinite(remainder.iterate(np.array([[0.5, 0.1]]))).all()


def test_compiled_form_that_differs_is_refused():
    """A compiler that takes the cosine for the sine stands for whatever may go wrong between the two forms."""
    with pytest.raises(lober.DisagreementError, match="compiled and .* in NumPy"):
        lober.equations([p, -sympy.sin(q)], (q, p), t, period=1, compiler="cc -Dsin=cos")()


CODE = """__import__('pathlib').Path('made').touch()"""


def refused_texts():
    h, k = p**2 / 2, sympy.Symbol("k")
    yield lambda: lober.hamiltonian(CODE, q, p, t, period=1)
    yield lambda: lober.hamiltonian(h, q, p, t, period=CODE)
    yield lambda: lober.hamiltonian(h, CODE, p, t, period=1)
    yield lambda: lober.hamiltonian(h, q, CODE, t, period=1)
    yield lambda: lober.hamiltonian(h, q, p, CODE, period=1)
    yield lambda: lober.hamiltonian(h, q, p, t, period=1, params={CODE: 1})
    yield lambda: lober.hamiltonian(h, q, p, t, period=1, params={k: CODE})
    yield lambda: lober.hamiltonian(h, q, p, t, period=1, phase=CODE)
    yield lambda: lober.hamiltonian(h, q, p, t, period=1, window=(CODE, 0, 1, 1))
    yield lambda: lober.hamiltonian(h, q, p, t, period=1, lattice=(CODE, 0))
    yield lambda: lober.hamiltonian(h, q, p, t, period=1, params={k: 1})(k=CODE)
    yield lambda: lober.equations([CODE, q], (q, p), t, period=1)
    yield lambda: lober.equations([q, p], (CODE, p), t, period=1)
    yield lambda: lober.hamiltonian(sympy.Function(CODE)(q), q, p, t, period=1, compiler="")
    yield lambda: lober.hamiltonian(sympy.Sum(q, (sympy.Symbol(CODE), 0, 3)), q, p, t, period=1, compiler="")
    for bad in [(CODE, 0), CODE]:
        yield lambda bad=bad: lober.hamiltonian(
            h, q, p, t, period=1, connection=lober.Connection(bad, (1, 1), (0, 0), (1, 0))
        )()
        yield lambda bad=bad: lober.flow(
            lambda x, y, t: (y, x), period=1, connection=lober.Connection(bad, (1, 1), (0, 0), (1, 0))
        )()
    yield lambda: lober.flow(lambda x, y, t: (y, x), period="1")()


@pytest.mark.parametrize("call", list(refused_texts()))
def test_texts_are_not_evaluated(call, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(lober.UsageError):
        call()
    assert not list(tmp_path.iterdir())


NAMES = ['a"; } int system(const char *); //', "int", "a\\", "two words", "line\nbreak", "??/", "α", "sin", "x0_", "p1_", CODE]


@ALL
@pytest.mark.parametrize("name", NAMES)
def test_names_are_texts_only(name, compiler, tmp_path, monkeypatch):
    """Names of systems, of parameters and of coordinates."""
    monkeypatch.chdir(tmp_path)
    k, other, coordinate = sympy.Symbol(name), sympy.Symbol("other"), sympy.Symbol(name, real=True)
    params = {other: 2.0, k: 1.0}
    family = oscillator(k + sympy.sin(other) - sympy.sin(2), compiler, params=params, name=name)
    made = family()
    expected = [[np.cos(1), -np.sin(1)]]
    np.testing.assert_allclose(made.iterate(np.array([[1.0, 0.0]])), expected, atol=1e-11)
    assert made.name == name and {key: value for key, value in made.parameters.items() if key != "phase"} == {
        "other": 2.0,
        name: 1.0,
    }
    of_coordinate = lober.equations([p, -coordinate], (coordinate, p), t, period=1, compiler=compiler)
    np.testing.assert_allclose(of_coordinate().iterate(np.array([[1.0, 0.0]])), expected, atol=1e-11)
    assert not list(tmp_path.iterdir())


def test_names_that_are_refused():
    k = sympy.Symbol("k")
    with pytest.raises(lober.UsageError, match="zero byte"):
        oscillator(1, name="a\0b")
    with pytest.raises(lober.UsageError, match="not a text"):
        oscillator(1, name="\ud800")
    with pytest.raises(lober.UsageError, match="phase is that of the section"):
        oscillator(1, params={sympy.Symbol("phase"): 1})
    with pytest.raises(lober.UsageError, match="two roles"):
        oscillator(k, params={k: 1, sympy.Symbol("k", real=True): 2})
    with pytest.raises(lober.UsageError, match="two roles"):
        oscillator(q, params={q: 1})
