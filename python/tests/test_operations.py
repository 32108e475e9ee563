"""Operations of the engine's table."""

import inspect

import numpy as np
import pytest

import lober
from lober import _generate, _lober


def test_generated_functions_are_those_of_the_table():
    """python -m lober._generate > python/lober/_generated.py makes them anew."""
    with open(lober._generated.__file__, encoding="utf-8") as file:
        assert file.read() == _generate.text()


def test_each_operation_has_a_function():
    for operation in _lober.table():
        assert callable(getattr(lober, operation["name"]))


def test_functions_have_all_options():
    """And no others: a function of the package has the options of its operation, but for those that would only choose
    what it computes when asked for."""
    for operation in _lober.table():
        name = operation["name"]
        face = _generate.FACES.get(name)
        parameters = set(inspect.signature(getattr(lober, face.name if face and face.name else name)).parameters)
        options = {_generate.identifier(option["key"]) for option in operation["options"]}
        inputs = {one["name"] for one in operation["inputs"]} | ({"connection"} if face and face.connection else set())
        assert ("rng" in parameters) == ("seed" in options)
        assert parameters - {"threads", "progress", "rng"} == (options - set(face.lazy if face else ())) | inputs, name


def test_verify_compares():
    square = np.array([[0, 0], [2, 0], [2, 2], [0, 2]], dtype=float)
    for found in (lober.overlay(square, square + 1, verify=True), lober.interior(square, square + 1, verify=True)):
        assert found.agreement and len(found.agreement.comparisons) == 7


def test_connections_by_options_and_by_an_object():
    """A tangle of one's own is the same, however its saddles are given."""
    own = lober.system("henon", k=1.2).connection
    by_object = lober.manifold_tangle(lober.system("henon", k=1.2), own, tolerance=1e-4)
    by_options = lober.manifold_tangle(lober.system("henon", k=1.2), from_=own.from_saddle, u_direction=own.u_direction,
                                       s_direction=own.s_direction, bip=own.bip, tolerance=1e-4)  # fmt: skip
    assert by_object.connection == by_options.connection and len(by_object.lobes)
    np.testing.assert_array_equal(by_object.lobes.area, by_options.lobes.area)


def test_sweep():
    found = lober.sweep("henon", range="k=0.9:1.1:0.1", tolerance=1e-4, find_zeros=True)
    assert found.parameter == "k" and found.failures == 0 and found.agreement
    assert found.rows.value.tolist() == [0.9, 1.0, 1.1]
    assert len(found.zeros.value) == 0 and "does not change sign" in found.no_zero
    for k, row in zip(found.rows.value, found.rows.flux21.value):
        one = lober.transport(lober.system("henon", k=k), iterates=1, tolerance=1e-4)
        assert row == pytest.approx(one.boundaries[0].flux21.value, rel=1e-6)
    assert found.rows.from_.shape == (3, 2)


@pytest.mark.parametrize("error", [KeyboardInterrupt, SystemExit, ValueError])
def test_exceptions_of_progress_end_a_sweep(error):
    """They became the failure of its values, or vanished."""

    def progress(fraction, text):
        raise error

    with pytest.raises(error):
        lober.sweep("standard", range="K=1:1.3:0.1", tolerance=1e-3, progress=progress)


def test_sweep_keeps_what_works():
    found = lober.sweep("henon", range="k=-2:0.5:1.25", tolerance=1e-4)
    assert found.failures == 1 and "no fixed points" in found.rows.failure[0] and found.rows.failure[1] is None
    assert np.isnan(found.rows.flux12.value[0]) and np.isfinite(found.rows.flux12.value[1:]).all()
    assert np.isnan(found.rows.from_[0]).all()


def test_melnikov():
    found = lober.sweep("duffing", range="eps=0.01:0.01:1", tolerance=1e-4, melnikov=True)
    amplitude = np.sqrt(2) * np.pi / np.cosh(np.pi / 2)
    assert found.rows.first_order[0] == pytest.approx(0.02 * amplitude, abs=1e-10)
    moved = lober.transport("duffing", iterates=1, melnikov=True)
    function = moved.melnikov
    assert function.parameter == "eps" and function.period == pytest.approx(2 * np.pi)
    at = np.linspace(0, 7, 50)
    np.testing.assert_allclose(np.abs(function(at)).max(), function.largest, rtol=1e-2)
    np.testing.assert_allclose(function(function.zeros["t0"]), 0, atol=1e-12)
    assert function(function.zeros["t0"][0]).shape == () and function.largest == pytest.approx(amplitude, abs=1e-10)
    step = 1e-5
    slopes = (function(function.zeros["t0"] + step) - function(function.zeros["t0"] - step)) / (2 * step)
    np.testing.assert_allclose(slopes, function.zeros["slope"], rtol=1e-8)
    written = moved.to_dict()["melnikov"]
    assert [one["area"] for one in written["lobes"]] == function.lobes["area"].tolist()
    assert written["exact"] == function.exact._asdict() and written["first_order"] == function.first_order._asdict()
    assert function.exact.left == pytest.approx(function.first_order.left, rel=function.eps)
    assert lober.transport("duffing", iterates=1).melnikov is None


def test_levels():
    found = lober.levels(lober.system("ovp", eps=0), at=[0, -0.5], box=(-3, -3, 3, 3), grid=(90, 80))
    assert found.levels.energy.tolist() == [-0.5, 0]
    assert np.isnan(found.levels.saddle[0]).all() and np.isfinite(found.levels.saddle[1]).all()
    assert found.saddles.at.shape == (2, 2) and found.saddles.energy == pytest.approx(0, abs=1e-12)
    for curves, points, closed, outline in zip(
        found.levels.curves, found.levels.points, found.levels.closed, found.levels.outline
    ):
        assert np.isnan(outline[:, 0]).sum() == curves and np.isfinite(outline[:, 0]).sum() == points + closed
    hill = [lober.levels("capsize", energy=energy, box=(-1.8, -0.8, 1.8, 1.4)).levels.closed[0] for energy in (0.22, 0.28)]
    assert hill == [1, 0]
    with pytest.raises(lober.UsageError, match="cannot be given together"):
        lober.levels("capsize", at=[0.1], energy=0.2)
    with pytest.raises(lober.UsageError, match="at: has to be a number, not the text|at has to be a number, not the text"):
        lober.levels("capsize", at=["0.1"])


def test_what_makes_no_sense_is_refused():
    with pytest.raises(lober.UsageError, match="FIRST:LAST:STEP"):
        lober.sweep("henon", range="k=1:2")
    with pytest.raises(lober.UsageError, match="tolerance: has to be above 0"):
        lober.sweep("henon", range="k=1:2:0.5", tolerance=0)
    with pytest.raises(lober.UsageError, match="has to be a number, not the text|has to be a number"):
        lober.sweep("henon", range="k=1:2:0.5", tolerance="1e-3")
    with pytest.raises(lober.UsageError, match="has to be a whole number"):
        lober.transport("henon", iterates=1.5)
    with pytest.raises(lober.UsageError, match="iterates: 1000000000000000000000000000000 is too large"):
        lober.transport("henon", iterates=10**30)
    with pytest.raises(lober.UsageError, match="system shear has no parameter 'k'; it has: none"):
        lober.sweep(lober.map(lambda x, y: (x + y, y), name="shear"), range="k=1:2:1")


def test_call_runs_any_operation():
    square = np.array([[0, 0], [2, 0], [2, 2], [0, 2]], dtype=float)
    found = lober.call("regions", square, square + 1, rule="nonzero")
    assert found["areas"]["union"] == 7 and found["areas"]["intersection"] == 1 and found["agreement"]
    made = lober.call("transport", "henon", iterates=2, tolerance=1e-4)
    same = lober.transport("henon", iterates=2, tolerance=1e-4)
    flux = same.boundaries[0].flux12
    assert made["turnstile"]["flux12"] == (flux.value, flux.error)
    for operation in _lober.table():
        with pytest.raises(lober.UsageError, match="has no option 'none'"):
            lober.call(operation["name"], none=1)
    with pytest.raises(lober.UsageError, match="there is no operation 'areas'; there are curve_transport, densify"):
        lober.call("areas", square)
    with pytest.raises(lober.UsageError, match="takes 2 inputs or fewer, not 3"):
        lober.call("regions", square, square, square)
    with pytest.raises(lober.UsageError):
        lober.call("regions")


def test_a_manifold_that_is_given_inward_is_asked_for() -> None:
    u, s = (lober.grow("henon", side="stable" if side else "unstable", length=60).points for side in (False, True))
    with pytest.raises(lober.DataError, match="one pip only, and enclose no lobe; is U given inward"):
        lober.curve_transport(u[::-1], s)
