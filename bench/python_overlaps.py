"""A million pairs of small curves in memory, from Python, on one thread: against the batch engine, which reads the same
curves from a file and keeps a store, and against shapely in the same run.

    build/python/venv/bin/python bench/python_overlaps.py [POINTS...]

Each row is a set of curves with so many points each; all pairs of two sets of 1000 curves cross. Another thread of Python
counts meanwhile: it runs, since the GIL is released.
"""

from __future__ import annotations

import os
import sys
import tempfile
import threading
import time
from collections.abc import Callable

import numpy as np
from shapely.geometry import Polygon

import lober


def wavy(count: int, points: int, seed: int) -> list[np.ndarray]:
    rng = np.random.default_rng(seed)
    angle = 2 * np.pi * np.arange(points) / points
    radius = 1 + 0.1 * np.cos(rng.integers(2, 5, (count, 1)) * angle + rng.uniform(0, 6, (count, 1)))
    centre = 0.3 * rng.standard_normal((count, 1)) + 0.3j * rng.standard_normal((count, 1))
    return list(centre + radius * np.exp(1j * angle))


def timed(work: Callable[[], object]) -> tuple[float, object]:
    begin = time.perf_counter()
    result = work()
    return time.perf_counter() - begin, result


def counting(work: Callable[[], object]) -> tuple[float, object, float]:
    """Seconds, the result, and the times a second that another thread woke up meanwhile."""
    ended, woke = threading.Event(), [0]

    def count() -> None:
        while not ended.wait(0.001):
            woke[0] += 1

    other = threading.Thread(target=count)
    other.start()
    seconds, result = timed(work)
    ended.set()
    other.join()
    return seconds, result, woke[0] / seconds


def batch_rate(first: list[np.ndarray], second: list[np.ndarray]) -> float:
    """Pairs a second of lober.batch on one thread for a tenth of the pairs, the reading of the file and the store
    included."""
    with tempfile.TemporaryDirectory() as folder:
        a, b = os.path.join(folder, "a.dat"), os.path.join(folder, "b.dat")
        lober.write(a, {str(k): curve for k, curve in enumerate(first[:316])})
        lober.write(b, {str(k): curve for k, curve in enumerate(second[:316])})
        manifest = {"operation": "overlay", "curves": a + "#*", "with": b + "#*", "options": {"areas_only": True}}
        store = lober.batch.run(manifest, os.path.join(folder, "store"), threads=1)
        assert store.report is not None and store.report.failed == 0
        return store.report.run / store.report.seconds


def shapely_rate(first: list[np.ndarray], second: list[np.ndarray]) -> float:
    a, b = ([Polygon(np.stack([z.real, z.imag], axis=1)) for z in curves[:60]] for curves in (first, second))
    seconds, _ = timed(lambda: [p.intersection(q).area for p in a for q in b])
    return len(a) * len(b) / seconds


def main() -> None:
    sizes = [int(one) for one in sys.argv[1:]] or [16, 100, 1000]
    print("| points a curve | pairs | overlap_matrix, pairs a second and core | the same from a file, with a store | shapely | "
          "wakes of another thread, 1/s |")
    print("|---:|---:|---:|---:|---:|---:|")
    for points in sizes:
        first, second = wavy(1000, points, 1), wavy(1000, points, 2)
        seconds, found, wakes = counting(lambda: lober.overlap_matrix(first, second, ("intersection", "crossings"), threads=1))
        pairs = found["crossings"].size
        assert (found["intersection"] > 0).mean() > 0.9
        one = lober.overlay(first[3], second[4])
        assert found["intersection"][3, 4] == one.area.intersection and found["crossings"][3, 4] == one.crossings
        print(f"| {points} | {pairs} | {pairs / seconds:.3g} | {batch_rate(first, second):.3g} | "
              f"{shapely_rate(first, second):.3g} | {wakes:.0f} |")


if __name__ == "__main__":
    main()
