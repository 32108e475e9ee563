"""A test of the installed package that needs nothing but itself: results that are known exactly.

It shows that the package is whole and that its library runs on this machine. The tests of the project are `make test`.
"""

from __future__ import annotations

import math
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

from . import _lober
from ._files import read, read_zones, write
from ._generated import grow, interior, manifold_tangle, overlay, regions
from ._overlay import area, winding
from ._systems import system

SQUARE = np.array([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]])


def _require(what: str, found: Any, expected: Any) -> None:
    if found != expected:
        raise AssertionError(f"lober.test: {what} is {found!r} and should be {expected!r}; install lober again")


def _require_within(what: str, found: float, expected: float, error: float) -> None:
    if not abs(found - expected) <= error:
        raise AssertionError(
            f"lober.test: {what} is {found!r} and should be {expected!r} within {error:.1e}; install lober again"
        )


def _circle(points: int, centre: complex) -> Any:
    return centre + np.exp(2j * np.pi * np.arange(points) / points)


def _squares() -> None:
    """[0, 2]^2 and [1, 3]^2, by two methods: doubles hold all areas."""
    results: dict[str, Any] = {"overlay": overlay(SQUARE, SQUARE + 1), "interior": interior(SQUARE, SQUARE + 1)}
    for name, r in results.items():
        found = (r.area.c1, r.area.c2, r.area.intersection, r.area.union, r.area.c1_minus_c2, r.area.c2_minus_c1)
        _require(f"{name} of two squares", found, (4.0, 4.0, 1.0, 7.0, 3.0, 3.0))
    _require("number of crossings of two squares", overlay(SQUARE, SQUARE + 1).crossings, 2)
    _require("signed area of a square against the clock", area(SQUARE), 4.0)


def _circles() -> None:
    """A lens of two unit circles, of which the polygons are inscribed ones."""
    r = overlay(_circle(2000, 0), _circle(2000, 1), threads=1)
    lens = 2 * math.pi / 3 - math.sqrt(3) / 2
    _require_within("area of a lens", r.smooth.area.intersection, lens, r.smooth.error.intersection)
    again = overlay(_circle(2000, 0), _circle(2000, 1))
    _require("overlay with another number of threads", again.area, r.area)


def _winding() -> None:
    """A square that is run through twice and one of its corners."""
    numbers, on_curve = winding(np.concatenate([SQUARE, SQUARE]), [[1.0, 1.0], [3.0, 1.0], [2.0, 2.0]])
    _require("winding numbers", (numbers.tolist(), on_curve.tolist()), ([2, 0, 0], [False, False, True]))
    bow_tie = np.array([[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]])
    _require("area of a bow tie", regions(bow_tie, SQUARE).area().c1, 2.0)


def _manifold() -> None:
    """The separatrix of the Duffing oscillator without a force, y^2 = x^2 - x^4 / 2."""
    grown = grow(system("duffing", eps=0.0), iterates=2, tolerance=1e-6)
    x, y = grown.points.T
    energy = np.abs(y**2 / 2 - x**2 / 2 + x**4 / 4).max()
    _require_within("energy on a separatrix", float(energy), 0.0, 1e-10)
    _require("end of a manifold", grown.stop, "iterates")


def _tangle() -> None:
    """The area of a lobe by geometry and by the actions of two orbits."""
    tangle = manifold_tangle("henon")
    _require("agreement of two routes to the area of a lobe", bool(tangle.agreement), True)


def _files() -> None:
    """Every format of points keeps the bits of what it is given."""
    curve = np.ascontiguousarray(np.stack([np.cos(np.arange(20)), np.sin(np.arange(20)) / 3], axis=1))
    with tempfile.TemporaryDirectory(prefix="lober-test-") as folder:
        for ending in ("npy", "csv", "txt", "dat", "raw"):
            file = Path(folder) / f"curve.{ending}"
            write(file, curve)
            _require(f"curve of a file .{ending}", read(file).tobytes(), curve.tobytes())
        zones = Path(folder) / "zones.dat"
        write(zones, {"one": curve, "two": SQUARE})
        _require("titles of zones", [zone.title for zone in read_zones(zones).zones], ["one", "two"])


CHECKS = (_squares, _circles, _winding, _manifold, _tangle, _files)


def test() -> bool:
    """Computes results that are known exactly, prints one line and returns True: areas, winding numbers, a manifold, a
    tangle, files in a temporary folder.

    Takes less than a second. Raises AssertionError with one line where a result is another one.
    """
    begin = time.perf_counter()
    for check in CHECKS:
        check()
    print(f"lober {_lober.__version__}: {len(CHECKS)} checks passed in {time.perf_counter() - begin:.2f} s")
    return True
