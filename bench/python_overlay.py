"""Overlay of two curves from Python against the engine's own time, and against shapely in the same run.

    build/python/venv/bin/python bench/python_overlay.py [POINTS]

Two wavy circles that cross some hundred times; the shortest of five runs each.
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
        r = lober.overlay(first, second)
        inside.append(r.timing["total"])
        return r

    seconds, r = shortest(ours)
    a, b = Polygon(first), Polygon(second)
    theirs, area = shortest(lambda: a.difference(b).area, runs=2)
    one, _ = shortest(lambda: lober.overlay(first, second, threads=1), runs=2)
    print(f"{2 * count} points, {r.crossings} crossings")
    print(f"lober from Python {seconds:.4f} s, of which the engine {min(inside):.4f} s; with one thread {one:.4f} s")
    print(f"shapely, one of the four areas, {theirs:.4f} s: {theirs / one:.1f} times lober with one thread")
    print(f"areas {r.area.c1_minus_c2!r} and {area!r}")


if __name__ == "__main__":
    main()
