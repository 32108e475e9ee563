"""How long batches take on one machine, ten and a thousand, and what ends first: a simulation of the schedule of lober.batch.run
with a client, with the costs that cluster_costs.py has measured. Prints the tables of docs/explanation/size.md; some seconds.

    python3 bench/cluster_schedule.py             prints the tables
    scripts/docs.sh make docs/explanation/size.md puts them into the page

Simulated are: portions as WorkQueue cuts them, workers that take the next one when they are done and keep as many of the curves
that they have read as their memory holds, one process for each store that hands out portions and takes results one after the
other, a file system that all read from, workers that die and take their portion along. Assumed, and not measured: the numbers in Machine.
"""

from __future__ import annotations

import argparse
import heapq
import json
import math
import random
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
COSTS = json.loads((ROOT / "bench" / "CLUSTER.json").read_text())

# As engine/batch/work_queue.cpp.
MIN_COST, MIN_COST_PER_PROCESS, MAX_COST, MAX_JOBS = 2e-3, 1e-3, 20.0, 50_000
# As python/lober/_dask_worker.py and engine/batch/queue/curve_cache.cpp: the part of the memory, bytes for a point.
MEMORY_PART, POINT_BYTES = 0.6, 21


@dataclass(frozen=True)
class Machine:
    """The assumptions."""

    threads: int = 16
    #: Bytes of memory; a thread is a worker with its share.
    memory: float = 64e9
    #: Bytes a second of the file system that all machines share.
    file_system: float = 5e9
    #: Seconds after which a machine has died, on average: a month.
    life: float = 30 * 86400.0
    #: Logarithmic standard deviation of the time of a portion.
    spread: float = 0.3


@dataclass(frozen=True)
class Scene:
    title: str
    jobs: float
    points: int
    #: Whether each curve meets all others, or only the next one.
    all_pairs: bool = True


SCENES = [
    Scene("10^6 pairs of 1 000 points", 1e6, 1_000),
    Scene("10^9 pairs of 1 000 points", 1e9, 1_000),
    Scene("10^9 pairs of 100 000 points", 1e9, 100_000),
    Scene("10^12 points: 10^6 curves of a million, each with the next", 1e6, 1_000_000, all_pairs=False),
]


def measured(points: int) -> dict[str, Any]:
    return next(row for row in COSTS["families"] if row["points"] == points)


def curves_of(jobs: float, all_pairs: bool) -> float:
    """Curves that a portion reads: measured for all pairs, as a multiple of the root."""
    if not all_pairs:
        return jobs + 1
    row = measured(1_000)
    factor = row["curves_read"] / row["portions"] / math.sqrt(row["jobs"] / row["portions"])
    return factor * math.sqrt(jobs)


@dataclass
class Outcome:
    seconds: float
    busy: float
    coordinator: float
    files: float
    portions: int


class Coordinator:
    """The process of one store, with its share of the jobs and of the workers."""

    def __init__(self, jobs: float, workers: int, cost: float) -> None:
        self.left, self.workers, self.cost = jobs, workers, cost
        self.free_at = self.worked = 0.0

    def portion(self) -> float:
        low = max(MIN_COST, self.workers * MIN_COST_PER_PROCESS)
        share = min(max(self.left * self.cost / (4 * self.workers), low), MAX_COST)
        jobs = min(self.left, MAX_JOBS, max(1.0, share // self.cost))
        self.left -= jobs
        return jobs

    def serve(self, now: float, seconds: float) -> float:
        """The time at which it has done this, after what it was asked for before."""
        self.free_at = max(self.free_at, now) + seconds
        self.worked += seconds
        return self.free_at


def simulate(scene: Scene, machines: int, stores: int, of: Machine = Machine()) -> Outcome:
    costs, chance = measured(scene.points), random.Random(1)
    result = costs["store"] / costs["jobs"] if scene.points < 100_000 else measured(1_000)["store"] / measured(1_000)["jobs"]
    hand_out = measured(1_000)["hand out"] / measured(1_000)["jobs"]
    task = COSTS["task"]["client_seconds"]
    workers = machines * of.threads
    owners = [Coordinator(scene.jobs / stores, max(1, workers // stores), costs["pair"]) for _ in range(stores)]
    # Any curve of a portion is among those that its worker keeps with the same chance.
    all_curves = math.sqrt(2 * scene.jobs) if scene.all_pairs else math.inf
    held = [0.0] * workers
    most_held = MEMORY_PART * of.memory / of.threads / (POINT_BYTES * scene.points)
    file_free = file_worked = busy = end = 0.0
    portions = 0
    # Events: a worker wants a portion, or, with a number of jobs, has the results of one.
    events = [(0.0, number, 0.0) for number in range(min(workers, int(scene.jobs)))]
    heapq.heapify(events)
    while events:
        now, number, results = heapq.heappop(events)
        owner = owners[number % stores]
        if results > 0:
            end = max(end, owner.serve(now, result * results))
            continue
        if owner.left <= 0:
            continue
        jobs = owner.portion()
        portions += 1
        # Handed out while the portion before is computed, so that only a busy coordinator is waited for.
        start = max(now, owner.serve(now, task + hand_out * jobs))
        curves = curves_of(jobs, scene.all_pairs) * (1 - held[number] / all_curves)
        held[number] = min(held[number] + curves, most_held, all_curves)
        file_free = max(file_free, start) + curves * 16 * scene.points / of.file_system
        file_worked += curves * 16 * scene.points / of.file_system
        seconds = (jobs * costs["pair"] + curves * costs["curve"]) * chance.lognormvariate(-of.spread**2 / 2, of.spread)
        if chance.random() < seconds / of.life:
            seconds *= 1.5  # it dies in the middle, and another one begins anew
        done = max(start + seconds, file_free)
        busy += seconds
        heapq.heappush(events, (done, number, jobs))
        heapq.heappush(events, (done, number, 0.0))
    return Outcome(end, busy / (end * workers), max(owner.worked for owner in owners) / end, file_worked / end, portions)


def time_text(seconds: float) -> str:
    for limit, unit, name in ((120, 1, "s"), (7200, 60, "min"), (172800, 3600, "h"), (math.inf, 86400, "days")):
        if seconds < limit:
            value = seconds / unit
            return f"{value:.2g} {name}" if value < 10 else f"{value:.0f} {name}"
    raise AssertionError


def bytes_text(value: float) -> str:
    for unit in ("B", "kB", "MB", "GB"):
        if value < 1000:
            return f"{value:.3g} {unit}"
        value /= 1000
    return f"{value:.3g} TB"


def costs_table() -> str:
    lines = ["| points of a curve | a pair, us | a point of a pair, ns | a curve, us | a result in the store, us | threads that one store keeps busy |", "|---:|---:|---:|---:|---:|---:|"]
    stored = measured(1_000)
    result = (stored["store"] + stored["hand out"]) / stored["jobs"]
    for row in COSTS["families"]:
        pair = row["pair"]
        lines.append(f"| {row['points']:,} | {1e6 * pair:.3g} | {1e9 * pair / (2 * row['points']):.2g} | {1e6 * row['curve']:.3g} | {1e6 * result:.2g} | {pair / result:.2g} |".replace(",", " "))
    return "\n".join(lines)


def schedule_table() -> str:
    lines = ["| | machines | stores | time | threads at work | store's process | file system | store | memory of the plan, a manifest a store |", "|---|---:|---:|---:|---:|---:|---:|---:|---:|"]
    for scene in SCENES:
        row = measured(1_000)
        size, plan = scene.jobs * row["store_bytes"], scene.jobs * COSTS["plan"]["plan_bytes"]
        title = scene.title
        for machines in (1, 10, 1000):
            for stores in (1, 10, 100) if scene.jobs > 1e8 else (1,):
                if stores > 1 and stores * 8 > machines * Machine.threads:
                    continue
                found = simulate(scene, machines, stores)
                lines.append(
                    f"| {title} | {machines} | {stores} | {time_text(found.seconds)} | {100 * found.busy:.0f} % | {100 * found.coordinator:.0f} % | "
                    f"{100 * found.files:.0f} % | {bytes_text(size / stores)} | {bytes_text(plan / stores)} |"
                )
                title = ""
    return "\n".join(lines)


def ratios_text(times: dict[str, Any]) -> str:
    alone = "; one worker alone is faster than that thread too, since the client stores beside it" if min(times["one"]) < min(times["threads_one"]) else ""
    ratios, control = (", ".join(f"{ratio:.2f}" for ratio in times[name]) for name in ("ratios", "threads_ratios"))
    return (
        f"{times['jobs']} pairs by one worker and by two, in turns, {min(times['one']):.2f} s and {min(times['two']):.2f} s at best: "
        f"ratios {ratios}. By one thread and two of one process, {min(times['threads_one']):.2f} s and {min(times['threads_two']):.2f} s at best: "
        f"ratios {control}, the most that the machine had to give then. Two workers are {min(times['threads_one']) / min(times['two']):.2g} times as fast "
        f"as one thread of one process{alone}."
    )


def measured_text() -> str:
    workers, task, plan = COSTS["workers"], COSTS["task"], COSTS["plan"]
    return (
        f"Commit {COSTS['commit']} of {COSTS['date']}, {COSTS['processor']}, {COSTS['cores']} cores{COSTS['beside']}. "
        f"{' '.join(map(ratios_text, workers))} A task of one small job takes "
        f"{1e3 * task['seconds']:.2g} ms from hand to hand, {1e3 * task['client_seconds']:.2g} ms of them processor time of the process "
        f"that owns the store. A job that waits takes {plan['plan_bytes']:.0f} bytes of its memory and {1e6 * plan['plan_seconds']:.2g} us."
    )


def main() -> None:
    blocks = {"costs": costs_table, "measured": measured_text, "schedule": schedule_table}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("block", nargs="?", choices=blocks, help="only this one")
    chosen = parser.parse_args().block
    print("\n\n".join(make() for name, make in blocks.items() if chosen in (None, name)))


if __name__ == "__main__":
    main()
