"""Overlay of two curves from Python against the time of the C++ within the same call, indexes included, and against shapely
in the same run.

    build/python/venv/bin/python bench/python_overlay.py [POINTS]

Two wavy circles that cross some hundred times; the shortest of many runs each.
"""

from __future__ import annotations

import sys
import time

import numpy as np
from shapely.geometry import Polygon

import lober


def wavy(count: int, waves: int, phase: float) -> np.ndarray:
    angle = 2 * np.pi * np.arange(count) / count
    z = (1 + 0.05 * np.sin(waves * angle + phase)) * np.exp(1j * angle)
    return np.stack([z.real, z.imag], axis=1)


def shortest(work, runs: int = 5) -> tuple[float, object]:
    best, result = float("inf"), None
    for _ in range(runs):
        begin = time.perf_counter()
        result = work()
        best = min(best, time.perf_counter() - begin)
    return best, result


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000
    first, second = wavy(count, 60, 0.0), wavy(count, 60, 1.0)
    inside: list[float] = []

    def ours() -> lober.Overlay:
        r = lober.overlay(first, second, threads=1)
        inside.append(r._run.of.seconds)
        return r

    seconds, r = shortest(ours, runs=100)
    a, b = Polygon(first), Polygon(second)
    theirs, area = shortest(lambda: a.difference(b).area, runs=3)
    more = 100 * (seconds / min(inside) - 1)
    print(f"{2 * count} points, {r.crossings} crossings, one thread")
    print(f"lober from Python {1e3 * seconds:.2f} ms, the C++ in it {1e3 * min(inside):.2f} ms: {more:.1f} % more")
    print(f"shapely, one of the four areas, {1e3 * theirs:.1f} ms: {theirs / seconds:.0f} times lober")
    print(f"areas {r.area.c1_minus_c2!r} and {area!r}")


if __name__ == "__main__":
    main()
