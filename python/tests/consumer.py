"""A program that uses the package and has types: checked by mypy --strict (scripts/python.sh), and run by test_consumer.py."""

from __future__ import annotations

from typing import Iterator

import numpy as np
from numpy.typing import NDArray

import lober

Curve = NDArray[np.complex128]


def circles(count: int) -> list[Curve]:
    angle = 2 * np.pi * np.arange(100) / 100
    return [np.exp(1j * angle) + 0.5 * k for k in range(count)]


def lobes(first: Curve, second: Curve) -> list[float]:
    r: lober.Overlay = lober.overlay(first, second, threads=1)
    bars: lober.AreaErrors = r.error
    assert bars.discretisation is not None
    total: float = r.area.c1_minus_c2 + bars.rounding.c1_minus_c2 + bars.discretisation.c1_minus_c2
    pieces: lober.Pieces = r.pieces("c1_minus_c2")
    one: lober.Piece = pieces[0]
    some: list[lober.Piece] = pieces[0:2]
    outline: NDArray[np.float64] = one.outline[0]
    assert total > 0 and len(outline) > 0 and len(some) == min(2, len(pieces))
    return [piece.area for piece in pieces]


def shared(curves: list[Curve]) -> float:
    def watch(fraction: float | None, text: str | None) -> bool:
        return fraction is None or fraction <= 1

    matrix: NDArray[np.float64] = lober.overlap_matrix(curves, progress=watch)
    return float(matrix.sum())


def largest(curves: list[Curve]) -> float:
    results: Iterator[lober.Overlay] = lober.overlay_many(zip(curves, curves[1:]))
    return max(r.area.c1_minus_c2 for r in results)


def batch(path: str) -> tuple[int, int]:
    manifest = {"operation": "overlay", "curves": path + "#*", "pairs": "all"}
    estimate: lober.batch.Estimate = lober.batch.check(manifest)
    store: lober.batch.Store = lober.batch.run(manifest)
    jobs: lober.batch.Jobs = store.jobs
    messages: list[str] = [failure.message for failure in store.failures]
    assert estimate.jobs == len(jobs) and not messages
    return jobs.done, len(store.to_pandas())


def flux() -> tuple[float, float]:
    tangle: lober.SystemTangle = lober.manifold_tangle("henon")
    area: lober.Measured = tangle.area_by_action
    result: lober.Transport = lober.transport(lober.system("henon"), iterates=2, particles=1000, rng=np.random.default_rng(1))
    as_json: dict[str, object] = result.to_dict()
    assert "steps" in as_json and bool(tangle.agreement)
    return float(np.asarray(area)[0]), float(result.boundaries[0].flux12.value)


def main(path: str) -> None:
    curves = circles(4)
    lober.write(path, {f"c{k}": curve for k, curve in enumerate(curves)})
    file: lober.CurveFile = lober.read_zones(path)
    zone: lober.Zone = file["c1"]
    assert len(zone) == 100 and len(file) == 4
    print(lobes(curves[0], curves[1]), shared(curves), largest(curves), batch(path), flux())


if __name__ == "__main__":
    import sys

    main(sys.argv[1])
