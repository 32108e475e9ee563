"""Pictures: what is drawn is what the result holds."""

from __future__ import annotations

import subprocess
import sys

import matplotlib
import numpy as np
import pytest
from conftest import ring

import lober

matplotlib.use("Agg")


@pytest.fixture(scope="module")
def grown():
    return lober.manifold_tangle("duffing", tolerance=1e-4)


@pytest.fixture(autouse=True)
def close_figures():
    yield
    import matplotlib.pyplot as pyplot

    pyplot.close("all")


def line(ax, label):
    return next(entry for entry in ax.get_lines() if entry.get_label() == label).get_xydata()


def test_matplotlib_is_imported_when_it_is_needed():
    code = "import sys, lober; assert 'matplotlib' not in sys.modules; assert lober.plot.tangle"
    subprocess.run([sys.executable, "-P", "-c", code], check=True)


def test_overlay():
    first, second = ring(100), ring(100, 0.5)
    r = lober.overlay(first, second)
    ax = lober.plot.overlay(r)
    np.testing.assert_array_equal(line(ax, "C1")[:-1], first)
    np.testing.assert_array_equal(line(ax, "nodes"), np.stack([r.nodes["x"], r.nodes["y"]], axis=1))
    assert len(ax.patches) == 2
    assert lober.plot.overlay(r, ax) is ax


def test_tangle_and_turnstile(grown):
    ax = lober.plot.tangle(grown)
    np.testing.assert_array_equal(line(ax, "U"), grown.u)
    assert len(ax.patches) == len(grown.lobes) == len(ax.texts)
    ax = lober.plot.turnstile(grown)
    assert sorted(text.get_text() for text in ax.texts) == ["L12(1)", "L21(1)"]
    colours = {patch.get_facecolor()[:3] for patch in ax.patches}
    assert len(colours) == 2
    x = np.linspace(-0.5, 3.5, 500)
    u, s = np.stack([x, np.sin(np.pi * x)], axis=1), np.array([[3.5, 0.0], [-0.5, 0.0]])
    short = lober.tangle(u, s)
    if len(short.turnstile) == 0:
        with pytest.raises(lober.UsageError):
            lober.plot.turnstile(short)


def test_flux_and_exits():
    r = lober.transport("duffing", iterates=2, tolerance=1e-4)
    ax = lober.plot.flux(r)
    assert len(ax.containers) == 2  # no particles
    np.testing.assert_array_equal(ax.containers[0][0].get_ydata(), r.total.value[:, 0, 1])
    escape = lober.escape("capsize", crossings=1, tolerance=1e-4)
    ax = lober.plot.exits(escape)
    known = escape.table[np.isfinite(escape.table["fraction"])]
    assert sorted(patch.get_height() for patch in ax.patches) == sorted(known["fraction"])
