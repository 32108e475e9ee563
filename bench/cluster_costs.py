"""The costs that decide how large a batch on a cluster can get: of a pair, of a curve that is read, of a result in the store, of
a task of Dask; and how much faster two workers are than one. Writes bench/CLUSTER.json, from which cluster_schedule.py makes the
tables of docs/explanation/size.md. Five minutes.

    build/python/venv/bin/python bench/cluster_costs.py [--rounds N] [-o FILE]

Costs of one process are its processor time, which other work on the machine changes little. What several processes do is wall time,
one and two workers in turns.
"""

from __future__ import annotations

import argparse
import datetime
import importlib
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

import lober
from lober import _dask, _dask_worker, _lober

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "python" / "tests"))
from dask_cluster import Cluster  # noqa: E402

#: Numbers of curves, and points of each.
FAMILIES = [(400, 100), (300, 1_000), (60, 10_000), (14, 100_000), (4, 1_000_000)]
#: Numbers of curves of the batches that one worker and two are timed with: some seconds of work, and four times as much.
BATCHES = [250, 500]
#: Processes that wait for a core, this one among them, from which on others disturb the measurement.
LOAD = 1.5


def family(folder: Path, count: int, points: int, waves: int = 2) -> Path:
    """Closed curves of which most pairs cross some times, and a manifest of all pairs."""
    angle = np.linspace(0, 2 * np.pi, points, endpoint=False)
    for k in range(count):
        radius = 1 + 0.1 * np.cos((waves + k % 3) * angle + k)
        lober.write(folder / f"p{points}_{k:05}.npy", radius * np.exp(1j * angle) + 0.3 * np.exp(1j * k))
    manifest = folder / f"{points}.toml"
    manifest.write_text(f'operation = "overlay"\ncurves = "p{points}_*.npy"\npairs = "all"\n')
    return manifest


class Clock:
    """Processor time by what it was spent on."""

    def __init__(self) -> None:
        self.spent: dict[str, float] = {}
        self._last = time.process_time()

    def lap(self, name: str) -> None:
        now = time.process_time()
        self.spent[name] = self.spent.get(name, 0) + now - self._last
        self._last = now


def resident() -> int:
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def one_process(folder: Path, count: int, points: int) -> dict[str, Any]:
    """All portions, one after the other: seconds a job, bytes a result. Each portion runs twice, the second time with the curves that the
    first one has kept."""
    manifest = family(folder, count, points)
    kept = _lober.kept_curves()
    time.sleep(2.1)  # younger files are not kept
    store = folder / f"{points}.results"
    clock = Clock()
    run = _lober.start_shared_run(str(manifest), None, store=str(store), threads=1)
    clock.lap("plan")
    jobs = portions = sent = read = 0
    operations = 0.0
    while portion := run.next_portion(4):
        encoded = run.encoded(portion)
        read += len(run.files(portion))
        clock.lap("hand out")
        for turn in ("first run", "run"):
            results, _, seconds = _lober.run_portion(encoded, str(folder / "manifest.toml"), threads=1, kept=kept)
            clock.lap(turn)
        run.add(portion, results)
        clock.lap("store")
        operations += seconds
        sent += len(results)
        jobs += len(portion)
        portions += 1
    run.finish("complete")
    clock.lap("store")
    return {"points": points, "jobs": jobs, "portions": portions, "curves_read": read, "result_bytes": sent / jobs,
            "store_bytes": store.stat().st_size / jobs, "operations": operations, **clock.spent}


def costs_of_curves(folder: Path, points: int, count: int) -> float:
    """Processor time to read, index and check a curve: a portion of pairs (k, k + 1) against one with the same pairs twice."""
    manifest = folder / f"{points}.toml"
    times = []
    for pairs in ('{ lag = 1 }', '"all"'):
        text = manifest.read_text().replace('"all"', pairs)
        run = _lober.start_shared_run(str(manifest), text, store=str(folder / "curves.results"), threads=1)
        jobs = list(range(run.pending))
        encoded = run.encoded(jobs)
        best = float("inf")
        for _ in range(3):
            begin = time.process_time()
            _lober.run_portion(encoded, str(folder / "manifest.toml"), threads=1)
            best = min(best, time.process_time() - begin)
        run.finish("stopped")
        os.remove(folder / "curves.results")
        times.append((len(jobs), best))
    (few, fast), (many, slow) = times
    pair = (slow - fast) / (many - few)
    return max(0.0, (fast - few * pair) / count)


def plan_of(folder: Path) -> dict[str, float]:
    """Bytes of memory and seconds a job that waits: a plan of 500 500 pairs."""
    (folder / "plan").mkdir()
    for k in range(1001):
        (folder / "plan" / f"q{k:04}.csv").write_text("x,y\n0,0\n1,0\n0,1\n")
    manifest = folder / "plan" / "job.toml"
    manifest.write_text('operation = "overlay"\ncurves = "q*.csv"\npairs = "all"\n')
    before, begin = resident(), time.process_time()
    run = _lober.start_shared_run(str(manifest), None, store=str(folder / "plan.results"), threads=1)
    made = {"jobs": run.pending, "plan_bytes": (resident() - before) / run.pending,
            "plan_seconds": (time.process_time() - begin) / run.pending}
    run.finish("stopped")
    return made


def tasks_of(client: Any, folder: Path, count: int = 400) -> dict[str, float]:
    """Wall time a task of one small job, and the part of it that this process works."""
    manifest = folder / "100.toml"
    run = _lober.start_shared_run(str(manifest), None, store=str(folder / "tasks.results"), threads=1)
    work = _dask_worker.Work(lober.__version__, str(folder), "", "", "", 1, 0)

    class OneJob:
        """The same run, in portions of one job."""

        pending = count
        report = {"run": 0, "failed": 0}

        def __init__(self) -> None:
            self._jobs = iter(range(count))

        def __getattr__(self, name: str) -> Any:
            return getattr(run, name)

        def next_portion(self, _: int) -> list[int]:
            return [job] if (job := next(self._jobs, None)) is not None else []

    begin, processor = time.monotonic(), time.process_time()
    _dask.SharedBatch(client, OneJob(), work, False, None).to_the_end()
    seconds = (time.monotonic() - begin) / count
    run.finish("stopped")
    os.remove(folder / "tasks.results")
    return {"tasks": count, "seconds": seconds, "client_seconds": (time.process_time() - processor) / count}


def two_workers(folder: Path, rounds: int) -> tuple[list[dict[str, Any]], dict[str, float]]:
    """Wall times of the same batch by one worker and by two, in turns, for each of BATCHES; and the costs of a task."""
    batches = []
    for number, count in enumerate(BATCHES):
        sub = folder / f"speed{number}"
        sub.mkdir()
        batches.append((sub, family(sub, count, 20_000, waves=60)))
    cluster = Cluster(folder)
    cluster.start_scheduler()
    try:
        found = [times_of(cluster, *batch, rounds) for batch in batches]
        cluster.start_workers(2)
        with cluster.client(2) as client:
            return found, tasks_of(client, folder)
    finally:
        cluster.end()


def times_of(cluster: Cluster, sub: Path, manifest: Path, rounds: int) -> dict[str, Any]:
    times: dict[int, list[float]] = {1: [], 2: []}
    alone: dict[int, list[float]] = {1: [], 2: []}
    for turn in range(rounds + 1):
        for count in (1, 2):
            cluster.start_workers(count)
            with cluster.client(count) as client:
                client.run(importlib.import_module, "lober")
                store = lober.batch.run(manifest, sub / f"{turn}_{count}.results", client=client)
                assert store.report is not None
                if turn > 0:  # the first round is for the caches of the system
                    times[count].append(store.report.seconds)
            cluster.end_workers()
            wait_for_none(cluster)
            # The same by threads of one process, which says how much of two cores the machine has to give.
            begin = time.monotonic()
            lober.batch.run(manifest, sub / f"{turn}_{count}.alone", threads=count)
            if turn > 0:
                alone[count].append(time.monotonic() - begin)
    return {"one": times[1], "two": times[2], "threads_one": alone[1], "threads_two": alone[2],
            "ratios": ratios(times), "threads_ratios": ratios(alone), "jobs": store.report.jobs}


def ratios(times: dict[int, list[float]]) -> list[float]:
    return [one / two for one, two in zip(times[1], times[2])]


def wait_for_none(cluster: Cluster) -> None:
    from distributed import Client

    with Client(cluster.address, set_as_default=False) as client:
        while client.nthreads():
            time.sleep(0.05)


def processor() -> str:
    lines = Path("/proc/cpuinfo").read_text().splitlines()
    return next((line.split(":")[1].strip() for line in lines if line.startswith("model name")), "unknown")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=3, help="how often one and two workers take turns (default: 3)")
    parser.add_argument("-o", "--output", default=str(ROOT / "bench" / "CLUSTER.json"))
    given = parser.parse_args()
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True).stdout.strip()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        plan = plan_of(folder)  # first, while the process has no memory to use again
        rows = []
        for count, points in FAMILIES:
            row = one_process(folder, count, points)
            row["curve"] = costs_of_curves(folder, points, count)
            row["pair"] = row["run"] / row["jobs"]
            rows.append(row)
        load = os.getloadavg()[0]
        workers, task = two_workers(folder, given.rounds)
        beside = ", with other work beside it" if load > LOAD else ""
        found = {"commit": commit, "date": datetime.date.today().isoformat(), "processor": processor(), "cores": os.cpu_count(),
                 "beside": beside, "families": rows, "plan": plan, "workers": workers, "task": task}
    Path(given.output).write_text(json.dumps(found, indent=1) + "\n")
    print(f"wrote {given.output}")


if __name__ == "__main__":
    main()
