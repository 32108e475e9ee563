"""Libraries compiled of expressions, and the comparison of each with the form in NumPy before its first use."""

from __future__ import annotations

import atexit
import ctypes
import hashlib
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Any, Callable

import numpy as np
from numpy.typing import NDArray

from ._forms import Form
from ._numpy_form import NumPyForm
from .errors import DisagreementError, UsageError

Array = NDArray[np.float64]

POINTS = 64
#: Loops over points become vector instructions; roundings stay those of the source.
FLAGS = ["-shared", "-fPIC", "-O3", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math"]

_libraries: dict[str, str] = {}
_folder: str | None = None


def compiled(source: str, compiler: str) -> str:
    """The path of a shared library; kept until the process ends."""
    global _folder
    key = hashlib.sha256((compiler + "\n" + source).encode()).hexdigest()
    if key in _libraries:
        return _libraries[key]
    if _folder is None:
        _folder = tempfile.mkdtemp(prefix="lober-")
        atexit.register(shutil.rmtree, _folder, True)
    code, library = Path(_folder) / f"{key}.c", Path(_folder) / f"{key}.so"
    code.write_text(source)
    command = [*compiler.split(), *FLAGS, str(code), "-o", str(library), "-lm"]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode != 0:
        raise UsageError(f"{' '.join(command)} fails: {run.stderr.strip()}")
    _libraries[key] = str(library)
    return _libraries[key]


def _names(coordinates: int) -> list[str]:
    names = ["x", "y"] if coordinates == 2 else [f"x{k}" for k in range(coordinates)]
    rates = [f"d{name}/dt" for name in names]
    return [*rates, *(f"d({rate})/d{name}" for rate in rates for name in names), "the period", "the Hamiltonian"]


def require_same(library: str, form: Form, in_numpy: NumPyForm, values: list[float], box: Array) -> None:
    """Raises DisagreementError where a library differs from NumPy at random points of a box, whose rows are the bounds of a coordinate,
    by more than rounding does."""
    random = np.random.default_rng(18)
    length = in_numpy.period(values)
    points: Array = np.ascontiguousarray(random.uniform(box[:, 0], box[:, 1], (POINTS, len(box))).T)
    times = random.uniform(0, length if np.isfinite(length) and length > 0 else 1, POINTS)
    by_numpy = in_numpy.values(points, times, values)
    by_c = _values(library, points, times, values)
    # What rounding does is what moving all numbers by a few units in the last place does.
    noise = np.zeros_like(by_numpy)
    with np.errstate(all="ignore"):
        for _ in range(8):
            moved: Array = points + 1e-14 * random.uniform(-1, 1, points.shape) * (1 + np.abs(points))
            later = times + 1e-14 * random.uniform(-1, 1, POINTS) * (1 + np.abs(times))
            others = [value * (1 + 1e-14 * random.uniform(-1, 1)) for value in values]
            noise = np.fmax(noise, np.abs(in_numpy.values(moved, later, others) - by_numpy))
        apart = np.abs(by_c - by_numpy) > 1e-10 * np.abs(by_numpy) + 1e3 * noise
    different = np.where(np.isfinite(by_c) & np.isfinite(by_numpy), apart, np.isfinite(by_c) != np.isfinite(by_numpy))
    for row, k in np.argwhere(different):
        at = ", ".join(f"{number:.9g}" for number in points[:, k])
        raise DisagreementError(
            f"system {form.name}: {_names(len(points))[row]} at ({at}), t = {times[k]:.9g}, is "
            f"{by_c[row, k]:.17g} compiled and {by_numpy[row, k]:.17g} in NumPy; "
            'give compiler="", and the flow is a function of NumPy'
        )


def _values(library: str, points: Array, times: Array, values: list[float]) -> Array:
    function: Callable[..., Any] = ctypes.CDLL(library).lober_values
    n = len(points)
    doubles = ctypes.c_double * max(len(values) + 1, n)
    function.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_double, ctypes.c_void_p]  # type: ignore[attr-defined]
    function.restype = None  # type: ignore[attr-defined]
    parameters = doubles(*values)
    found = np.empty((POINTS, n + n * n + 2))
    for k in range(POINTS):
        at = doubles(*points[:, k])
        to = (ctypes.c_double * found.shape[1])()
        function(parameters, at, float(times[k]), to)
        found[k] = to
    return np.ascontiguousarray(found.T)
