"""Regions, densify, simplify, tangle and files."""

from __future__ import annotations

import math
import pickle

import numpy as np
import pytest
from conftest import ring

import lober


def test_regions_of_a_curve_that_winds_twice():
    twice = np.concatenate([ring(100), ring(100, radius=2)])
    r = lober.regions(twice)
    windings = sorted((int(row["w1"]), int(row["w2"])) for row in r.table)
    assert windings == [(1, 0), (2, 0)]
    assert r.signed_area[0] == pytest.approx(lober.area(twice), rel=1e-14)
    assert r.area("nonzero").c1 > r.area("evenodd").c1 > 0
    assert r.error().rounding.c1 < 1e-13 and r.rounding(1.0) > 0
    pieces = r.pieces("c1_minus_c2")
    assert len(pieces) == len(pieces.area) == 1
    assert pieces.area[0] == pytest.approx(r.area().c1_minus_c2, rel=1e-14)
    assert lober.area(pieces.outline(0)[0]) > 0 and pieces.holes(0) == 0
    assert pickle.loads(pickle.dumps(r)).area() == r.area()
    assert "<table>" in r._repr_html_()
    with pytest.raises(lober.UsageError, match="nonzero, evenodd"):
        r.area("odd")


def test_regions_of_two_curves(squares):
    r = lober.regions(*squares)
    assert r.area().c1_minus_c2 == 3
    assert lober.regions(squares[0][::-1], squares[1]).signed_area == (-4, 4)


def test_densify_keeps_vertices():
    square = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])
    fine = lober.densify(square, max_length=0.1)
    assert len(fine.points) == 40 and len(fine.diagnostics.list.segment) == 0 and fine.result.closed
    assert {tuple(p) for p in square} <= {tuple(p) for p in fine.points}
    assert lober.area(fine.points) == pytest.approx(1, rel=1e-14)
    circle = lober.densify(ring(32), hobson=True, interpolation="spline")
    assert abs(lober.area(circle.points) - math.pi) < 1e-3 < abs(lober.area(ring(32)) - math.pi)
    open_ = lober.densify(square, closed=False, max_length=0.5)
    assert len(open_.points) == 7
    with pytest.raises(lober.UsageError):
        lober.densify(square, angle=0.1, min_length=1e-3, interpolation="linear")
    with pytest.raises(lober.UsageError, match="linear, dritschel, spline"):
        lober.densify(square, max_length=0.1, interpolation="cubic")


def test_densify_near_another_curve(squares):
    near = lober.densify(*squares, passes=2, points=4)
    assert len(near.points) == 4 + 2 * 8
    assert lober.area(near.points) == 4


def test_simplify():
    fine = ring(10000)
    coarse = lober.simplify(fine, tolerance=1e-4).points
    assert 3 < len(coarse) < 500
    assert lober.area(coarse) == pytest.approx(math.pi, abs=1e-3)
    with pytest.raises(lober.UsageError):
        lober.simplify(fine, tolerance=-1)


def manifolds(count: int = 4000) -> tuple[np.ndarray, np.ndarray]:
    """y = sin x against y = 0, towards each other: lobes of area 2, alternately."""
    x = np.linspace(-0.5, 6 * np.pi + 0.5, count)
    return np.stack([x, np.sin(x)], axis=1), np.array([[6 * np.pi + 0.5, 0.0], [-0.5, 0.0]])


def test_tangle():
    u, s = manifolds()
    t = lober.tangle(u, s)
    assert len(t.pips) == 7 and len(t.lobes) == 6
    np.testing.assert_allclose(t.lobes.area, [2 if k % 2 else -2 for k in range(6)] if t.lobes.area[0] < 0 else
                               [-2 if k % 2 else 2 for k in range(6)], rtol=1e-5)
    assert (np.abs(np.abs(t.lobes.area) - 2) < 4 * t.lobes.error.discretisation + t.lobes.error.rounding).all()
    np.testing.assert_allclose(t.lobes.inside + t.lobes.outside, np.abs(t.lobes.area), rtol=1e-14)
    assert t.lobes.simple.all() and len(t.lobes.label) == 6
    assert lober.area(t.lobes.outline(0)) == pytest.approx(t.lobes.area[0], rel=1e-12)
    assert t.boundary is not None and t.boundary.error.rounding < 1e-12
    np.testing.assert_allclose(t.pips["x"], np.pi * np.arange(7), atol=1e-6)
    smooth = lober.tangle(u, s, smooth=True)
    assert (np.abs(np.abs(smooth.lobes.area) - 2) <= smooth.lobes.error.discretisation + 1e-14).all()
    assert "<table>" in t._repr_html_() and "6 lobes" in repr(t)
    assert pickle.loads(pickle.dumps(t)).lobes.area.tobytes() == t.lobes.area.tobytes()


def test_a_tangle_whose_lobes_change_their_areas():
    """The program ends with exit status 3: lobes whose images have another area, though the period was inferred."""
    x = np.linspace(0, 1, 401)
    t = np.linspace(0, 1, 101)
    u = np.stack([x, 0.3 * np.sin(5 * np.pi * x)], axis=1)
    s = np.stack([1.05 * (1 - t), -0.05 * np.sin(np.pi * (1 - t))], axis=1)
    with pytest.warns(lober.DisagreementWarning, match="two routes disagree: area of lobe 0: .* by itself"):
        found = lober.tangle(u, s, smooth=True)
    assert not found.agreement and len(found.agreement.disagreements) == 1 and "routes disagree" in repr(found)
    with pytest.raises(lober.DisagreementError, match="area of lobe 0"):
        found.agreement.require()
    # The path that closes the boundary crosses it.
    assert found.boundary is not None and found.boundary.crosses_itself
    assert abs(found.boundary.area - 0.1273334017) <= found.boundary.error.discretisation < 1e-7
    assert (found.lobes.parts_error >= found.lobes.error.discretisation).all() and (found.lobes.parts_error < 1e-6).all()
    given = lober.tangle(u, s, period=2)  # nothing is compared then, and nothing is known of the parts' errors
    assert given.agreement and not given.agreement.comparisons and np.isnan(given.lobes.parts_error).all()


def test_tangle_options():
    u, s = manifolds()
    t = lober.tangle(u, s, period=2, bip=4)
    assert t.period == 2 and t.boundary.bip == 4 and list(t.turnstile) == [2, 3]
    assert {t.lobes.label[2], t.lobes.label[3]} == {"L12(1)", "L21(1)"}
    assert lober.tangle(u, s, bip_near=(np.pi, 0)).boundary.bip == 1
    with pytest.raises(lober.UsageError):
        lober.tangle(u, s, bip=7)
    assert t.overlaps.dtype.names[:3] == ("i", "j", "area")
    assert lober.tangle(u, u + [0, 5]).boundary is None


@pytest.mark.parametrize("ending", ["npy", "csv", "txt", "dat", "raw", "f64"])
def test_files_read_back_to_the_same_bits(tmp_path, ending):
    curve = ring(77, 1 / 3)
    path = tmp_path / f"curve.{ending}"
    lober.write(path, curve)
    assert lober.read(path).tobytes() == curve.tobytes()
    assert lober.read(str(path), closed=False).tobytes() == curve.tobytes()


def test_zones(tmp_path):
    path = tmp_path / "two.dat"
    lober.write(path, {"first": ring(5), "second": ring(6, 2)})
    file = lober.read_zones(path)
    assert file.format == "tecplot" and len(file.sha256) == 64
    assert [zone.title for zone in file.zones] == ["first", "second"]
    assert lober.read(f"{path}#second").tobytes() == ring(6, 2).tobytes()
    assert lober.read(f"{path}#0").tobytes() == ring(5).tobytes()
    np.save(tmp_path / "numpy.npy", ring(9))
    assert lober.read(tmp_path / "numpy.npy").tobytes() == ring(9).tobytes()


def test_tables(tmp_path):
    path = tmp_path / "tracers.csv"
    path.write_text("id,lon,lat\na,0,0\nb,5,5\na,1,0\nb,6,5\na,0,1\nb,5,6\n")
    file = lober.read_zones(path, columns="lon,lat,by=id")
    assert [zone.title for zone in file.zones] == ["a", "b"]
    assert file.zones[1].points.tolist() == [[5, 5], [6, 5], [5, 6]]
    assert lober.read(f"{path}:lon,lat,by=id#b").tolist() == file.zones[1].points.tolist()
    assert len(lober.read(f"{path}:2,3", closed=False)) == 6
    with pytest.raises(lober.DataError, match="its columns are id, lon, lat"):
        lober.read(f"{path}:lon,lit")


def test_curves_across_a_seam(tmp_path):
    curve = ring(40) / 3 + [0.9, 0.5]
    lober.write(tmp_path / "seam.npy", curve % 1)
    assert abs(lober.area(lober.read(tmp_path / "seam.npy"))) != pytest.approx(abs(lober.area(curve)))
    assert lober.read(tmp_path / "seam.npy", periods=(1, None)) + [1, 0] == pytest.approx(curve)
    with pytest.raises(lober.UsageError, match="a period has to be positive"):
        lober.read(tmp_path / "seam.npy", periods=(-1, None))


def test_names_of_files_with_a_zero_byte(tmp_path):
    """They were cut there: another file was written, or read."""
    victim = tmp_path / "nul"
    victim.write_text("0 0\n1 0\n0 1\n")
    name = f"{victim}\0b.csv"
    for call in (
        lambda: lober.write(name, ring(5)),
        lambda: lober.write(f"{victim}\0b.dat", ring(5)),
        lambda: lober.read(name),
        lambda: lober.read_zones(name),
        lambda: lober.system(f"{victim}\0.so"),
    ):
        with pytest.raises(lober.DataError, match="zero byte"):
            call()
    assert victim.read_text() == "0 0\n1 0\n0 1\n" and list(tmp_path.iterdir()) == [victim]


def test_files_that_cannot_be_used(tmp_path):
    with pytest.raises(lober.DataError, match="missing.dat"):
        lober.read(tmp_path / "missing.dat")
    (tmp_path / "bad.txt").write_text("0 0\n1 x\n")
    with pytest.raises(lober.DataError, match="bad.txt:2"):
        lober.read(tmp_path / "bad.txt")
    with pytest.raises(lober.UsageError, match=".npy, .csv, .txt, .dat"):
        lober.write(tmp_path / "curve.png", ring(5))
    with pytest.raises(lober.UsageError, match="several curves"):
        lober.write(tmp_path / "curve.npy", {"a": ring(5), "b": ring(5)})
    with pytest.raises(lober.DataError):
        lober.write(tmp_path / "nan.npy", [[0, 0], [1, math.nan], [2, 2]])
    assert not (tmp_path / "nan.npy").exists()
