"""Results as other packages take them: dictionaries, datasets, features, arrays, tables; and random numbers."""

from __future__ import annotations

import json
import pickle
import shutil
import subprocess
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr
from conftest import ring
from shapely.geometry import shape

import lober

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
C1, C2 = (lober.read(EXAMPLES / name) for name in ("resonance.dat", "resonance_image.dat"))
U = np.stack([np.linspace(0, 6, 400), np.sin(np.linspace(0, 6, 400))], axis=1)
#: Members of the program's JSON that say what was asked for, of which bytes, and how long it took.
ABOUT = ("program", "command", "inputs", "sha256", "system", "options", "timing", "curve", "points_file")
FILES = [str(EXAMPLES / "resonance.dat"), str(EXAMPLES / "resonance_image.dat")]

#: A call, and the command of the program that is the same.
CASES: dict[str, tuple[Any, list[str]]] = {
    "overlay": (lambda: lober.overlay(C1, C2), ["overlay", *FILES]),
    "interior": (lambda: lober.interior(C1, C2), ["interior", *FILES]),
    "regions": (lambda: lober.regions(C1, C2), ["regions", *FILES]),
    "densify": (lambda: lober.densify(C1, max_length=0.05), ["densify", FILES[0], "--max-length", "0.05", "-o", "out.dat"]),
    "fixed_points": (lambda: lober.fixed_points("standard"), ["fixed-points", "standard"]),
    "manifold_tangle": (lambda: lober.manifold_tangle("henon"), ["tangle", "--system", "henon"]),
    "transport": (lambda: lober.transport("standard", iterates=2), ["transport", "standard", "--iterates", "2"]),
    "sweep": (lambda: lober.sweep("standard", range="K=1:1.2:0.1"), ["sweep", "standard", "--range", "K=1:1.2:0.1"]),
    "levels": (lambda: lober.levels("pendulum", number=3), ["levels", "pendulum", "--number", "3"]),
}


def program() -> str:
    """The program of the same build."""
    folder = Path(lober.__file__).resolve()
    for parent in folder.parents:
        if (parent / "bin" / "lober").exists():
            return str(parent / "bin" / "lober")
    found = Path(__file__).resolve().parents[2] / "build" / "bin" / "lober"
    if found.exists():
        return str(found)
    pytest.skip("the program is not built, so that its JSON cannot be compared: make build")


@pytest.fixture(scope="module")
def results() -> dict[str, Any]:
    return {name: call() for name, (call, _) in CASES.items()}


@pytest.mark.parametrize("name", CASES)
def test_dictionaries_are_the_json_of_the_program(results: dict[str, Any], name: str, tmp_path: Path) -> None:
    shutil.copytree(EXAMPLES, tmp_path / "examples")
    run = subprocess.run([program(), *CASES[name][1], "--json", "-"], capture_output=True, text=True, cwd=tmp_path)
    assert run.returncode == 0, run.stderr
    expected = {key: value for key, value in json.loads(run.stdout).items() if key not in ABOUT}
    found = results[name].to_dict()
    json.dumps(found, allow_nan=False)
    assert {key: found.get(key) for key in expected} == expected
    assert set(found) == set(expected)


@pytest.mark.filterwarnings("ignore:numpy.ndarray size changed")  # of Debian's netCDF4
@pytest.mark.parametrize("name", CASES)
def test_datasets_have_names_units_and_provenance(results: dict[str, Any], name: str, tmp_path: Path) -> None:
    data = results[name].to_xarray()
    assert isinstance(data, xr.Dataset) and data.attrs["source"] == f"lober {lober.__version__}"
    assert data.attrs["operation"] == name
    assert all(variable.attrs["long_name"] for variable in data.data_vars.values())
    data.to_netcdf(tmp_path / "result.nc")
    with xr.open_dataset(tmp_path / "result.nc") as again:
        assert set(again.data_vars) == set(data.data_vars)


def test_numbers_of_datasets(results: dict[str, Any]) -> None:
    data, r = results["overlay"].to_xarray(), results["overlay"]
    assert float(data.areas_c1_minus_c2) == r.area.c1_minus_c2 and data.areas_c1_minus_c2.attrs["units"] == "area"
    assert float(data.error_rounding_union) == r.error.rounding.union
    assert np.array_equal(data.pieces_c1_minus_c2_area, r.pieces("c1_minus_c2").area)
    flux, t = results["transport"].to_xarray(), results["transport"]
    assert np.array_equal(flux.steps_T_ij, t.total.value, equal_nan=True)
    assert np.array_equal(flux.steps_T_ij_error, t.total.error)
    assert flux.steps_T_ij.dims[0] == "steps"


@pytest.mark.parametrize("name", CASES)
def test_results_are_shown_in_notebooks(results: dict[str, Any], name: str) -> None:
    html = results[name]._repr_html_()
    assert "<table>" in html and "object at 0x" not in html
    assert "object at 0x" not in repr(results[name]) and len(repr(results[name])) < 600


@pytest.mark.parametrize("name", CASES)
def test_results_pickle_with_all_of_this(results: dict[str, Any], name: str) -> None:
    again = pickle.loads(pickle.dumps(results[name]))
    assert again.to_dict() == results[name].to_dict()


def test_pieces_are_features() -> None:
    with warnings.catch_warnings():  # of pyproj, where its data are not installed
        warnings.simplefilter("ignore")
        import geopandas

        r = lober.overlay(ring(400, 0, 2), ring(100, 0.1, 1))
        for pairing in ("c1_minus_c2", "intersection", "union"):
            pieces = r.pieces(pairing)
            frame = geopandas.GeoDataFrame.from_features(pieces)
            assert np.allclose(frame.area, pieces.area, rtol=1e-12) and frame["area"].tolist() == pieces.area.tolist()
        holed = shape(r.pieces("c1_minus_c2")[0].__geo_interface__["geometry"])
        assert len(holed.interiors) == 1 and holed.is_valid
    piece = lober.overlay(ring(400), ring(400, 0.5)).pieces()[0]
    assert lober.area(piece) == pytest.approx(piece.area, rel=1e-13)
    regions = lober.regions(ring(40), ring(30, 0.5)).pieces()
    assert len(regions.__geo_interface__["features"]) == len(regions)
    lobes = lober.manifold_tangle("henon").lobes
    areas = [shape(one["geometry"]).area for one in lobes.__geo_interface__["features"]]
    assert np.allclose(areas, np.abs(lobes.polygon_area), rtol=1e-6)


def test_arrays_and_tables() -> None:
    r = lober.overlay(C1, C2)
    pieces = r.pieces("union")
    assert np.array_equal(np.asarray(pieces), pieces.area)
    frame = r.pieces().to_pandas()
    assert frame["area"].tolist() == r.pieces().area.tolist() and frame.index.name == "piece"
    assert frame["crossings"].tolist() == [len(piece.crossings) for piece in r.pieces()]
    assert [piece.area for piece in r.pieces()[1:3]] == r.pieces().area[1:3].tolist()
    assert r.pieces()[-1].area == r.pieces().area[-1] == r.pieces()[np.int64(len(r.pieces()) - 1)].area
    for wrong, error in ((len(r.pieces()), IndexError), (1.0, TypeError)):
        with pytest.raises(error):
            r.pieces()[wrong]  # type: ignore[index]
    lobes = lober.manifold_tangle("henon").lobes
    assert np.asarray(lobes)["area"].tolist() == lobes.to_pandas()["area"].tolist() == lobes.area.tolist()
    flux = lober.transport("henon", iterates=2).total
    assert np.array_equal(np.asarray(flux), flux.value, equal_nan=True) and "<table>" in flux._repr_html_()


def test_random_numbers_are_drawn_from_a_generator() -> None:
    def counted(**how: Any) -> Any:
        return lober.transport("henon", iterates=2, particles=2000, **how).by_particles.value

    first = counted(rng=np.random.default_rng(7))
    assert np.array_equal(first, counted(rng=7), equal_nan=True)
    assert np.array_equal(first, counted(rng=np.random.SeedSequence(7)), equal_nan=True)
    rng = np.random.default_rng(7)
    assert np.array_equal(first, counted(rng=rng), equal_nan=True)
    assert not np.array_equal(first, counted(rng=rng), equal_nan=True)  # it goes on
    assert not np.array_equal(first, counted(seed=7), equal_nan=True)
    with pytest.raises(lober.UsageError, match="seed and rng"):
        counted(seed=7, rng=7)


@pytest.mark.parametrize("threads", [None, 0, 1, np.int32(2)])
def test_numbers_of_threads(threads: Any) -> None:
    assert lober.overlay(C1, C2, threads=threads).crossings == 16


@pytest.mark.parametrize("threads", [1.5, "2", True, [1]])
def test_what_is_not_a_number_of_threads(threads: Any) -> None:
    with pytest.raises(TypeError, match="threads has to be a whole number, 0 for one of each core"):
        lober.overlay(C1, C2, threads=threads)
    with pytest.raises(TypeError, match="threads has to be a whole number"):
        lober.winding(C1, [[0, 0]], threads=threads)


def test_files_are_shown_and_taken(tmp_path: Path) -> None:
    lober.write(tmp_path / "two.dat", {"a": ring(10), "b": ring(12, 0.5)})
    file = lober.read_zones(tmp_path / "two.dat")
    assert "2 zones, 22 points: 'a', 'b'" in repr(file) and "<table>" in file._repr_html_()
    assert len(file) == 2 and [zone.title for zone in file] == ["a", "b"] and repr(file["b"]) == "<Zone 'b': 12 points>"
    with pytest.raises(KeyError, match="no zone 'c'"):
        file["c"]
    assert np.array_equal(np.asarray(file[0]), ring(10))
    assert lober.overlay(file["a"], file[1]).area == lober.overlay(ring(10), ring(12, 0.5)).area
    assert lober.overlap_matrix(file).shape == (2, 2)
    with pytest.raises(lober.UsageError, match="file of 2 curves"):
        lober.overlay(file, ring(10))


def test_one_number_is_the_period_of_x(tmp_path: Path) -> None:
    lon = np.array([350.0, 358.0, 6.0, 6.0, 350.0])
    lober.write(tmp_path / "seam.csv", np.stack([lon, [0, -5, -5, 5, 5]], axis=1))
    expected = lober.read(tmp_path / "seam.csv", periods=(360, None))
    assert np.array_equal(lober.read(tmp_path / "seam.csv", periods=360), expected)
    assert np.ptp(expected[:, 0]) < 20
    with pytest.raises(lober.UsageError, match="periods are those of x and y"):
        lober.read(tmp_path / "seam.csv", periods=(1, 2, 3))  # type: ignore[arg-type]
    with pytest.raises(lober.UsageError, match="periods has to be a number"):
        lober.read(tmp_path / "seam.csv", periods="360")  # type: ignore[arg-type]


def test_results_are_drawn() -> None:
    import matplotlib

    matplotlib.use("Agg")
    for result in (lober.overlay(C1, C2), lober.manifold_tangle("henon"), lober.transport("henon", iterates=2)):
        assert result.plot().figure is not None
    with pytest.raises(lober.UsageError, match="no picture of a Densify"):
        lober.densify(C1, max_length=0.1).plot()


def test_a_curve_is_read_near_another_one(tmp_path: Path) -> None:
    """Where the two begin on different sides of the seam they did not meet, and nothing said so."""
    t = 2 * np.pi * np.arange(60) / 60
    first, second = (np.stack([x + 5 * np.cos(t), 5 * np.sin(t)], axis=1) for x in (179, 182))
    expected = lober.overlay(first, second).area.intersection
    for shift in (0, 20, 40):
        for name, curve in (("first", first), ("second", second)):
            stored = np.roll(curve, shift if name == "second" else 0, axis=0)
            stored = np.stack([(stored[:, 0] + 180) % 360 - 180, stored[:, 1]], axis=1)
            lober.write(tmp_path / f"{name}.npy", stored)
        a = lober.read(tmp_path / "first.npy", periods=360)
        b = lober.read(tmp_path / "second.npy", periods=360, near=a)
        assert lober.overlay(a, b).area.intersection == pytest.approx(expected, rel=1e-12)
    with pytest.raises(lober.UsageError, match="near moves a curve by whole periods"):
        lober.read(tmp_path / "second.npy", near=first)
