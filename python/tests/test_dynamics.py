"""Systems, fixed points, manifolds, tangles, transport, escape."""

from __future__ import annotations

import math
import os
import pickle
import signal
import threading
import time

import numpy as np
import pytest
from conftest import ring

import lober


def test_list_of_systems():
    found = {info.name: info for info in lober.systems()}
    assert {"duffing", "pendulum", "standard"} <= set(found)
    assert all(info.summary and info.parameters for info in found.values())
    duffing = lober.system("duffing")
    assert duffing.parameters == {p.name: p.value for p in found["duffing"].parameters}
    assert duffing.dimension == 2 and duffing.period > 0 and duffing.connection is not None
    assert lober.system("duffing", eps=0.25).parameters["eps"] == 0.25
    assert lober.system("duffing", {"eps": 0.25}).parameters["eps"] == 0.25
    again = pickle.loads(pickle.dumps(lober.system("standard", {"K": 0.7})))
    assert again.parameters["K"] == 0.7 and "K = 0.7" in repr(again)


def test_systems_that_are_refused():
    with pytest.raises(lober.UsageError, match="no system is called 'dufing'; there are:"):
        lober.system("dufing")
    with pytest.raises(lober.UsageError, match="has no parameter 'epsilon'; it has:"):
        lober.system("duffing", epsilon=1)
    with pytest.raises(lober.UsageError, match="not finite"):
        lober.system("duffing", eps=math.nan)
    with pytest.raises(TypeError, match="eps has to be a number, not list"):
        lober.system("duffing", eps=[1])
    with pytest.raises(lober.UsageError, match="eps has to be a number, not the text '0.2'"):
        lober.system("duffing", eps="0.2")
    with pytest.raises(lober.DataError, match="cannot load"):
        lober.system("./missing.so")
    with pytest.raises(TypeError, match="a system or its name"):
        lober.fixed_points(3)


def test_images_of_points():
    k = 0.8
    standard = lober.system("standard", {"K": k})
    points = np.random.default_rng(3).uniform(-1, 1, (10000, 2))
    image = standard.iterate(points)
    y = points[:, 1] + k / (2 * math.pi) * np.sin(2 * math.pi * points[:, 0])
    if not np.allclose(image[:, 1], y):  # the angle is in radians
        y = points[:, 1] + k * np.sin(points[:, 0])
    np.testing.assert_allclose(image[:, 1], y, atol=1e-14)
    np.testing.assert_allclose(image[:, 0], points[:, 0] + y, atol=1e-14)
    np.testing.assert_allclose(standard.iterate(image, -1), points, atol=1e-13)
    assert standard.iterate(points, 3, threads=1).tobytes() == standard.iterate(points, 3).tobytes()
    np.testing.assert_allclose(np.linalg.det(standard.derivative(points, 2)), 1, rtol=1e-12)


def test_fixed_points():
    found = lober.fixed_points(lober.system("standard", {"K": 0.9}))
    assert found.settled and len(found) == len(found.at) >= 2
    types = {point.type for point in found}
    assert {"saddle", "centre"} <= types
    saddle = next(point for point in found if point.type == "saddle")
    assert saddle.multipliers[0].imag == 0 and saddle.multipliers[0].real > 1 and saddle.residue < 0
    assert saddle.multipliers[0] * saddle.multipliers[1] == pytest.approx(1)
    near = lober.fixed_point("standard", (saddle.at[0] + 0.01, saddle.at[1]))
    assert near.residual < 1e-12
    assert "<table>" in found._repr_html_() and found[0] is found.points[0]
    with pytest.raises(lober.UsageError, match="x0 < x1"):
        lober.fixed_points("standard", box=(1, 0, 0, 1))
    with pytest.raises(lober.UsageError, match="does not repeat"):
        lober.fixed_points("henon", turns=1)
    assert len(lober.fixed_points("henon", box=(5, 5, 6, 6))) == 0
    two = lober.fixed_point(lober.system("standard", {"K": 1.2}), (0, 3.1), period=2, turns=1)
    assert two.period == 2 and two.residue == pytest.approx(0.36)
    five = lober.fixed_points("standard", box=(-0.1, 0, 6.1, 6), period=5, turns=2)
    assert len(five) == 10 and five.index_of_box == 0 and five.box == (-0.1, 0, 6.1, 6)
    for point in five:
        there = lober.fixed_point("standard", point.at, period=5, turns=2)
        assert point.type == there.type and point.multipliers == pytest.approx(there.multipliers, rel=1e-6)
        assert np.trace(point.derivative) == pytest.approx(2 - 4 * point.residue)


def test_manifolds_meet_the_tolerance_asked_for():
    for side in ("unstable", "stable"):
        coarse = lober.grow("duffing", side, tolerance=1e-3, length=8)
        fine = lober.grow("duffing", side, tolerance=1e-6, length=8)
        assert coarse.stop == fine.stop == "length" and len(fine.points) > 2 * len(coarse.points)
        assert fine.length == pytest.approx(8, abs=0.1) and abs(fine.multiplier) > 1
        assert tuple(fine.points[0]) == fine.saddle and fine.defect < 1e-10
        assert fine.generation_begin[-1] == len(fine.points) == len(fine.parameters)
    by_iterates = lober.grow("duffing", iterates=3, tolerance=1e-4)
    assert by_iterates.stop == "iterates"
    other = lober.grow("duffing", iterates=2, tolerance=1e-4, from_=(0, 0), branch="-")
    assert other.points[-1, 0] != by_iterates.points[-1, 0]
    with pytest.raises(lober.UsageError, match="iterates or length"):
        lober.grow("duffing", tolerance=1e-3)
    with pytest.raises(lober.UsageError, match="unstable, stable"):
        lober.grow("duffing", "left", from_=(0, 0), tolerance=1e-3, length=1)
    with pytest.raises(lober.UsageError, match="vector roughly along"):
        lober.grow("duffing", from_=(0, 0), branch="up", tolerance=1e-3, length=1)


def test_images_of_curves_keep_their_area():
    circle = ring(50, radius=0.2)
    before = lober.area(circle)
    for image in lober.images("standard", circle, -2, 2, tolerance=1e-6):
        assert lober.area(image.points) == pytest.approx(before, abs=2e-5)
        assert image.closed and image.stop == "iterates" and len(image.parts) == 1
        assert len(image.parameters) == len(image.points) >= 50
    one = lober.image("standard", circle, 2, tolerance=1e-6)
    assert one.iterate == 2
    with pytest.warns(lober.IncompleteWarning, match="f.2 ends early, with .* points, since max_points"):
        short = lober.image("standard", circle, 2, tolerance=1e-6, max_points=60)
    assert short.stop == "points"


def test_section():
    orbits = lober.section("standard", orbits=20, iterates=100)
    assert orbits.shape == (20, 101, 2) and np.isfinite(orbits).all()
    lifted = lober.section("standard", orbits[:, 0], iterates=5, lifted=True)
    np.testing.assert_allclose(lifted[:, 5], lober.system("standard").iterate(orbits[:, 0], 5), atol=1e-12)
    seen = []
    lober.section("standard", orbits=5, iterates=10, progress=lambda fraction, text: seen.append(fraction))
    assert seen[-1] == 1
    torus = lober.section("abc", orbits=20, iterates=10)
    corner = np.array(lober.system("abc").picture[:2])
    assert (np.nanmin(torus, axis=(0, 1)) >= corner).all() and (np.nanmax(torus, axis=(0, 1)) <= corner + 2 * math.pi).all()
    with pytest.raises(lober.UsageError):
        lober.section("standard", iterates=-1)


def test_tangle_of_a_system():
    steps = []
    t = lober.manifold_tangle("duffing", tolerance=1e-4, progress=lambda fraction, text: steps.append(text))
    assert any(steps) and t.bip in range(len(t.pips)) and t.period
    assert len(t.turnstile) == t.period == len(t.area_by_action.value)
    assert set(t.area_by_action.labels) == {"L12(1)", "L21(1)"}
    assert t.area_by_action["L12(1)"].value == t.area_by_action.value[t.area_by_action.labels.index("L12(1)")] < 0
    assert "L21(1): 0.3" in str(t.area_by_action)
    with pytest.raises(KeyError, match="the lobes are"):
        t.area_by_action["L12(2)"]
    areas = t.lobes.area[list(t.turnstile)]
    bars = t.lobes.error.discretisation[list(t.turnstile)] + t.area_by_action.error
    assert (np.abs(areas - t.area_by_action.value) <= bars + t.lobes.error.rounding[list(t.turnstile)]).all()
    assert t.agreement and t.agreement.comparisons and not t.agreement.disagreements
    t.agreement.require()
    assert tuple(t.u[0]) == t.saddles[0]
    again = pickle.loads(pickle.dumps(t))
    assert again.lobes.area.tobytes() == t.lobes.area.tobytes()
    with pytest.raises(lober.Cancelled):
        lober.manifold_tangle("duffing", progress=lambda *_: False)


def test_connections_of_ones_own():
    duffing = lober.system("duffing")
    c = duffing.connection
    mine = lober.Connection(c.from_saddle, c.u_direction, c.to_saddle, c.s_direction)
    t = lober.manifold_tangle(duffing, mine, tolerance=1e-4)
    own = lober.manifold_tangle(duffing, tolerance=1e-4)
    assert sorted(np.abs(t.area_by_action.value)) == pytest.approx(sorted(np.abs(own.area_by_action.value)), rel=1e-9)


@pytest.mark.parametrize("k", [4.8, 5, 10])
def test_the_bip_of_a_system_is_a_hint(k):
    """The program took it for one; here it was asked for, and no pip was near."""
    henon = lober.system("henon", k=k)
    t = lober.manifold_tangle(henon, tolerance=1e-4)
    assert t.agreement
    r = lober.transport(henon, iterates=1, tolerance=1e-4)
    lobes = t.lobes.area[list(t.turnstile)]
    assert r.boundaries[0].lobe_area12.value == pytest.approx(lobes[lobes > 0].sum(), rel=1e-6)
    assert lober.manifold_tangle(henon, henon.connection, tolerance=1e-4).bip == t.bip
    c = henon.connection
    # A bip that the caller gives is asked for.
    far = lober.Connection(c.from_saddle, c.u_direction, c.to_saddle, c.s_direction, (c.from_saddle[0] + 50, 50.0))
    with pytest.raises(lober.DataError):
        lober.manifold_tangle(henon, far, tolerance=1e-4, max_work=1e5)


def test_agreement_that_fails():
    comparison = lober.Comparison("area", "overlay", "interior", 1.0, 2.0, 0.5)
    agreement = lober.Agreement([comparison])
    assert not agreement and agreement.disagreements == [comparison]
    with pytest.raises(lober.DisagreementError, match="area: 1.0 by overlay, 2.0 by interior"):
        agreement.require()
    assert lober.Comparison("area", "a", "b", 1.0, 1.0, math.nan).agrees


def test_transport():
    r = lober.transport("duffing", iterates=3, tolerance=1e-4, particles=20000)
    assert r.n.tolist() == [1, 2, 3] and len(r.regions) == 2 and r.regions[0].bounded
    assert r.flux.value.shape == (3, 2, 2) == r.total.error.shape
    assert r.flux.value[0, 0, 1] == pytest.approx(r.boundaries[0].flux12.value, abs=1e-9)
    both = r.total.error[:, 0, 1] + r.by_boundaries.error[:, 0, 1]
    assert (np.abs(r.total.value - r.by_boundaries.value)[:, 0, 1] <= both).all()
    assert (np.abs(r.total.value - r.by_particles.value)[:, 0, 1] <= 5 * r.by_particles.error[:, 0, 1]).all()
    assert r.agreement and "<table>" in r._repr_html_()
    again = pickle.loads(pickle.dumps(r))
    assert again.total.value.tobytes() == r.total.value.tobytes()


def test_escape():
    r = lober.escape("capsize", crossings=1, tolerance=1e-4)
    assert r.stop == "done" and len(r.bottlenecks) == 2 and r.agreement
    known = r.table[np.isfinite(r.table["fraction"])]
    assert len(known) and ((known["fraction"] >= 0) & (known["fraction"] <= 1)).all()
    entry = r.bottlenecks[0]
    assert abs(lober.area(entry.entry[0])) == pytest.approx(entry.area.value, rel=1e-3)
    two = lober.escape("capsize", crossings=2, tolerance=1e-4, monte_carlo=0)
    assert two.survival["crossings"].tolist() == [1, 2, 1, 2] and two.survival["entry"].tolist() == [0, 0, 1, 1]
    for row in two.survival:
        of_entry = two.table[(two.table["entry"] == row["entry"]) & (two.table["crossings"] <= row["crossings"])]
        left = [of_entry["fraction"][of_entry["exit"] == k].sum() for k in range(2)]
        assert row["left"] == pytest.approx(left, abs=1e-15) and row["remains"] == pytest.approx(1 - sum(left), abs=1e-15)
    assert two.survival["remains"].min() < 0.9
    assert pickle.loads(pickle.dumps(two)).survival.tobytes() == two.survival.tobytes()
    with pytest.raises(ValueError, match="read-only"):
        two.survival["remains"] = 0
    with pytest.raises(lober.UsageError, match="is a map"):
        lober.escape("standard", energy=1)
    with pytest.raises(lober.UsageError, match="two degrees of freedom"):
        lober.escape("ovp")


@pytest.mark.parametrize(
    "call",
    [
        lambda: lober.grow("ovp", tolerance=1e-12, length=1e6),
        lambda: lober.section("ovp", orbits=10_000, iterates=10_000),
        lambda: lober.transport(lober.system("henon", k=10), iterates=16),
        lambda: lober.escape("capsize", crossings=9, tolerance=1e-9, budget=1e9),
    ],
    ids=["grow", "section", "transport", "escape"],
)
def test_interrupts_end_work_within_half_a_second(call):
    sent = []

    def interrupt():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.4, interrupt)
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            call()
        ended = time.monotonic()
    finally:
        timer.cancel()
        timer.join()
    assert sent and ended - sent[0] < 0.5
