"""Batches: manifests as files and dictionaries, and stores as objects."""

from __future__ import annotations

import os
import signal
import sqlite3
import subprocess
import sys
import threading
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import lober

ANGLE = 2 * np.pi * np.arange(200) / 200


def circle(centre: complex, points: int = 200) -> np.ndarray:
    return centre + np.exp(2j * np.pi * np.arange(points) / points)


def flowers(count: int) -> dict[str, np.ndarray]:
    """Two of these cross a thousand times: jobs enough for a run that takes long beside a tenth of a second, the
    pause between two calls of its progress."""
    turn = 2j * np.pi * np.arange(10000) / 10000
    return {str(k): np.exp(turn) * (1 + 0.1 * np.cos((500 + k) * turn.imag)) for k in range(count)}


@pytest.fixture
def curves(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Four circles in a file, in the working folder."""
    monkeypatch.chdir(tmp_path)
    lober.write("circles.dat", {f"c{k}": circle(0.5 * k) for k in range(4)})
    return tmp_path


OVERLAYS = {"operation": "overlay", "curves": "circles.dat#*", "pairs": "all"}


def test_a_dictionary_is_run_and_agrees_with_overlay(curves: Path) -> None:
    store = lober.batch.run(OVERLAYS)
    assert store.report is not None and store.report.run == 6 and store.report.failed == 0
    table = np.asarray(store)
    assert len(table) == len(store) == 6
    for row in table:
        first, second = (circle(0.5 * int(row[name].rsplit("#")[1])) for name in ("first", "second"))
        r = lober.overlay(first, second)
        assert (row["intersection"], row["crossings"]) == (r.area.intersection, r.crossings)
        assert row["rounding_union"] == r.error.rounding.union


def test_a_file_has_its_store_beside_it_and_goes_on_where_it_was(curves: Path) -> None:
    Path("all.toml").write_text('operation = "overlay"\ncurves = "circles.dat#*"\npairs = "all"\n')
    assert lober.batch.check("all.toml").jobs == 6
    part = lober.batch.run("all.toml", shard=(1, 2))
    assert part.path == "all.results" and part.jobs.missing == 3 and len(part.jobs) == 6
    rest = lober.batch.run("all.toml")
    assert rest.report is not None and (rest.report.finished_before, rest.report.run) == (3, 3)
    again = lober.batch.open("all.results")
    assert again.jobs == lober.batch.Jobs(6, 0, 0, []) and again.report is None
    assert [run.shard for run in again.runs] == ["1/2", "1/1"]
    assert again.runs[0].manifest.startswith("operation")
    assert again.operations == ["overlay"]


def test_a_report_counts_what_the_tables_hide(curves: Path) -> None:
    first = lober.batch.run(OVERLAYS, store="both.results")
    assert first.report is not None and (first.report.hidden, first.report.stored_meanwhile) == (0, 0)
    other = lober.batch.run({**OVERLAYS, "curves": ["circles.dat#0", "circles.dat#1"]}, store="both.results")
    assert other.report is not None and (other.report.run, other.report.hidden) == (0, 5)


def test_tables(curves: Path) -> None:
    store = lober.batch.run({**OVERLAYS, "options": {"lobes": True}})
    frame = store.to_pandas(lists=True)
    assert frame["first"].tolist()[:3] == ["circles.dat#0"] * 3
    assert frame["lobes_c1_minus_c2"][0].sum() == pytest.approx(frame["c1_minus_c2"][0], rel=1e-14)
    data = store.to_xarray()
    assert data.intersection.attrs["units"] == "area" and data.intersection.attrs["long_name"]
    assert data.sizes["job"] == 6 and set(data.coords) == {"job", "failed", "group", "options", "first", "second", "message"}
    assert lober.__version__ in data.attrs["source"] and "circles.dat#*" in data.attrs["manifest"]
    assert store.export("all.csv").done == 6
    assert pd.read_csv("all.csv")["union"].tolist() == frame["union"].tolist()
    rows = store.sql("SELECT curve1, curve2, area FROM overlaps WHERE crossings > ? ORDER BY job", [0])
    assert [row[2] for row in rows] == frame["intersection"][frame["crossings"] > 0].tolist()
    connection = store.connect()
    with pytest.raises(sqlite3.OperationalError, match="readonly"):
        connection.execute("DELETE FROM plan")
    connection.close()
    assert "6 jobs done" in repr(store) and "<table>" in store._repr_html_()


def test_grids_are_columns_and_coordinates(curves: Path) -> None:
    manifest = {"operation": "transport", "options": {"system": "standard"}, "grid": {"parameters": {"K": np.array([1.0, 1.1])}}}
    store = lober.batch.run(manifest)
    assert store.results()["parameters.K" if "parameters.K" in store.results().dtype.names else "K"].tolist() == [1.0, 1.1]
    flux = [lober.transport(lober.system("standard", K=k)).boundaries[0].flux12.value for k in (1.0, 1.1)]
    assert store.results()["flux12"].tolist() == flux


def test_failures_are_kept_and_warned_of(curves: Path) -> None:
    lober.write("eight.dat", np.array([[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]))
    manifest = {**OVERLAYS, "curves": ["circles.dat#*", "eight.dat"]}
    with pytest.warns(lober.IncompleteWarning, match="4 of 10 jobs failed, first circles.dat#0 eight.dat"):
        store = lober.batch.run(manifest)
    assert [failure.jobs for failure in store.failures] == [4]
    failed = store.results()[store.results()["failed"]]
    assert np.isnan(failed["union"]).all() and (failed["crossings"] == -1).all() and all(failed["message"])
    assert store.lists()["lobes_c1_minus_c2"][-1].size == 0


@pytest.mark.parametrize(
    "manifest, message",
    [
        ({"operation": "overlai", "curves": "circles.dat#*"}, 'manifest: operation: there is no operation "overlai"'),
        ({"operation": "overlay"}, "manifest: curves: is missing"),
        ({"operation": "overlay", "curves": [ANGLE + 1j]}, "curves: a value of type ndarray.*lober.overlap_matrix"),
        ({"operation": "overlay", "curves": "no.*"}, "manifest: .*no"),
        ({3: 4}, "keys of a manifest"),
        ('operation = "overlay"\ncurves = "*"', "not a text in TOML"),
    ],
)
def test_wrong_manifests_are_explained(curves: Path, manifest: object, message: str) -> None:
    with pytest.raises(lober.UsageError, match=message) as raised:
        lober.batch.run(manifest)  # type: ignore[arg-type]
    assert ":1:" not in str(raised.value)


def test_wrong_arguments_are_explained(curves: Path) -> None:
    with pytest.raises(lober.DataError, match="none.toml"):
        lober.batch.run("none.toml")
    with pytest.raises(TypeError, match="name of a file or a dictionary"):
        lober.batch.run(3)  # type: ignore[arg-type]
    for shard in ((0, 2), (3, 2), 2, (1, 2.5), None):
        with pytest.raises(lober.UsageError, match="shard: "):
            lober.batch.run(OVERLAYS, shard=shard)  # type: ignore[arg-type]
    with pytest.raises(lober.UsageError, match="memory"):
        lober.batch.run(OVERLAYS, memory=-1)
    with pytest.raises(lober.UsageError, match="memory has to be a number"):
        lober.batch.run(OVERLAYS, memory="4G")  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="threads has to be"):
        lober.batch.run(OVERLAYS, threads=1.5)  # type: ignore[arg-type]
    assert lober.batch.run(OVERLAYS, memory=1e9, threads=None).jobs.done == 6  # type: ignore[arg-type]
    with pytest.raises(lober.DataError):
        lober.batch.open("circles.dat")
    with pytest.raises(lober.DataError, match="none.results"):
        lober.batch.open("none.results")
    store = lober.batch.run(OVERLAYS)
    with pytest.raises(lober.UsageError, match="no such table"):
        store.sql("SELECT * FROM no_table")
    with pytest.raises(lober.UsageError, match="no operation 'tangle'"):
        store.lists("tangle")


def test_a_plan_of_several_operations(curves: Path) -> None:
    groups = [{"operation": name, "curves": "circles.dat#*", "pairs": "consecutive"} for name in ("overlay", "interior")]
    store = lober.batch.run({"group": groups})
    assert store.operations == ["overlay", "interior"] and store.jobs.done == 6
    with pytest.raises(lober.UsageError, match="several operations; choose one of overlay, interior"):
        store.to_pandas()
    areas = [store.results(name)["intersection"] for name in store.operations]
    assert len(areas[0]) == 3 and np.allclose(*areas, rtol=1e-14)


def test_odd_texts_are_written_as_toml(curves: Path) -> None:
    name = 'odd "name" \\ ä\x7f\n.dat'
    lober.write(name, {"a": circle(0), "b": circle(1)}, format="tecplot")
    store = lober.batch.run({"operation": "overlay", "curves": name + "#*", "options": {"areas_only": np.True_}})
    assert store.results()["first"].tolist() == [name + "#0"]


def test_progress_cancels_and_the_next_run_goes_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    lober.write("curves.dat", flowers(40))
    manifest = {"operation": "overlay", "curves": "curves.dat#*", "pairs": "all"}
    calls: list[str | None] = []

    def stop(fraction: float | None, text: str | None) -> bool:
        calls.append(text)
        return False

    with pytest.raises(lober.Cancelled, match="run the manifest again"):
        lober.batch.run(manifest, "all.results", progress=stop)
    assert len(calls) == 1 and "of 780 jobs" in str(calls[0])
    done = lober.batch.open("all.results").jobs.done
    assert done < 780
    store = lober.batch.run(manifest, "all.results")
    assert store.report is not None and store.report.finished_before == done and store.jobs.done == 780


def test_other_threads_run_meanwhile(curves: Path) -> None:
    counts = [0]
    ended = threading.Event()

    def count() -> None:
        while not ended.is_set():
            counts[0] += 1
            ended.wait(0.001)

    lober.write("more.dat", flowers(30))
    other = threading.Thread(target=count)
    other.start()
    lober.batch.run({**OVERLAYS, "curves": "more.dat#*"})
    ended.set()
    other.join()
    assert counts[0] > 5


def test_an_interrupt_ends_a_run_and_keeps_what_is_done(tmp_path: Path) -> None:
    lober.write(tmp_path / "curves.dat", flowers(200))
    program = (
        "import lober, sys\n"
        "def say(fraction, text):\n    if not text.startswith('0 '): print('running', flush=True)\n"
        "manifest = {'operation': 'overlay', 'curves': 'curves.dat#*', 'pairs': 'all'}\n"
        "try:\n    lober.batch.run(manifest, 'all.results', progress=say)\n"
        "except KeyboardInterrupt:\n    print('interrupted')\n"
    )
    child = subprocess.Popen([sys.executable, "-P", "-c", program], cwd=tmp_path, stdout=subprocess.PIPE, text=True)
    assert child.stdout is not None
    assert child.stdout.readline() == "running\n"
    os.kill(child.pid, signal.SIGINT)
    assert child.communicate(timeout=60)[0].endswith("interrupted\n")
    jobs = lober.batch.open(tmp_path / "all.results").jobs
    assert 0 < jobs.done < len(jobs)


def test_stores_of_shards_are_merged(curves: Path) -> None:
    whole = lober.batch.run(OVERLAYS, "whole.results")
    parts = [lober.batch.run(OVERLAYS, f"part{k}.results", shard=(k, 2)) for k in (1, 2)]
    joined = lober.batch.merge("joined.results", [parts[0], "part2.results"])
    assert joined.path == "joined.results" and joined.jobs == lober.batch.Jobs(6, 0, 0, [])
    np.testing.assert_array_equal(np.asarray(joined), np.asarray(whole))
    with pytest.raises(lober.UsageError, match="are the same store"):
        lober.batch.merge("joined.results", ["part1.results", Path("part1.results")])
    with pytest.raises(lober.UsageError, match="stores is empty"):
        lober.batch.merge("joined.results", [])
    with pytest.raises(TypeError, match="a list of stores"):
        lober.batch.merge("joined.results", "part1.results")
    with pytest.raises(lober.DataError):
        lober.batch.merge("new.results", ["none.results"])
    other = lober.batch.run({**OVERLAYS, "pairs": "consecutive"}, "other.results")
    with pytest.raises(lober.DataError, match="is for another manifest"):
        lober.batch.merge("new.results", [parts[0], other])
    assert not Path("new.results").exists()


def test_exports_in_netcdf_say_what_columns_are(curves: Path) -> None:
    netcdf = pytest.importorskip("scipy.io").netcdf_file
    store = lober.batch.run(OVERLAYS, "whole.results")
    store.export("table.nc")
    columns = lober.batch.operations()["overlay"].columns
    with netcdf("table.nc", mmap=False) as file:
        for column in columns:
            variable = file.variables[column.name]
            assert getattr(variable, "units", b"").decode() == column.unit
            assert getattr(variable, "long_name", b"").decode() == column.meaning
            assert variable[:].tobytes() == np.asarray(store)[column.name].astype(">f8").tobytes()
        assert any(column.unit for column in columns)
        assert not hasattr(file.variables["job"], "units")


def test_paths_of_a_wrong_type(tmp_path):
    manifest = {"operation": "overlay", "curves": [f"{tmp_path}/c0.npy", f"{tmp_path}/c1.npy"]}
    for k in range(2):
        lober.write(tmp_path / f"c{k}.npy", np.exp(1j * np.arange(6)) + k)
    with pytest.raises(TypeError, match="store is a path, not int"):
        lober.batch.run(manifest, 3)
    with pytest.raises(TypeError, match="output_root is a path, not NoneType"):
        lober.batch.run(manifest, output_root=None)
    with pytest.raises(TypeError, match="target is a path, not NoneType"):
        lober.batch.merge(None, [tmp_path / "a"])
    with pytest.raises(lober.DataError, match="is a folder, not a manifest"):
        lober.batch.run(tmp_path)
    assert lober.batch.run(manifest, os.fsencode(tmp_path / "s")).path == str(tmp_path / "s")


def test_the_name_of_a_manifest_is_not_empty() -> None:
    with pytest.raises(lober.UsageError, match="the name of the manifest is empty"):
        lober.batch.run("")


def test_sql_finds_the_fractions_of_escapes(tmp_path: Path) -> None:
    """Their number depends on the results, so that a view cannot have them as columns: the query of the document."""
    document = (Path(__file__).parents[2] / "docs" / "reference" / "batch.md").read_text()
    query = next(block for block in document.split("```text\n") if block.startswith("SELECT")).split("```")[0]
    store = lober.batch.run(
        {"operation": "escape", "options": {"system": "capsize", "monte_carlo": 0}, "grid": {"energy": [0.2525, 0.253]}}
    )
    table = store.to_pandas()
    rows = store.sql(query)
    names = [f"fraction_{i}_{j}_{n}" for i in (1, 2) for j in (1, 2) for n in (1, 2, 3, 4)]
    assert len(rows) == 2 * len(names) and {row[0] for row in rows} == {0.2525, 0.253}
    for (energy, crossing, fraction, error), name in zip(rows, names * 2):
        columns = table[table["total_energy"] == energy]
        assert (columns[name].item(), columns[name + "_error"].item()) == (fraction, error) and name.endswith(f"_{crossing:g}")
