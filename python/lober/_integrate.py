"""Trajectories of a vector field that is a Python function of many points at a time.

Gragg's method with extrapolation, of order 12, as the engine integrates its own fields
(engine/dynamics/integration/extrapolation.hpp): all points take their steps side by side, each of a length by its own
errors, so that a point has the same image in whatever company.
"""

from __future__ import annotations

from typing import Callable

import numpy as np
from numpy.typing import NDArray

from . import _lober

Array = NDArray[np.float64]
#: Of the state, an array of dimension x N, and the times, an array of N: the velocity, dimension x N.
Field = Callable[[Array, Array], Array]

COLUMNS = 6
EVALUATIONS = 1 + COLUMNS**2  # of the field in a step
_SUBSTEPS = [2 * (column + 1) for column in range(COLUMNS)]
_FIRST_LEVEL, _DEEPEST_LEVEL = 3, 40


def _weight(column: int, first: int) -> float:
    """The weight of a column in the extrapolation from the columns first, first + 1, ..."""
    weight = 0.0 if column < first else 1.0
    for other in range(first, COLUMNS):
        if other != column:
            here, there = _SUBSTEPS[column] ** 2, _SUBSTEPS[other] ** 2
            weight *= here / (here - there)
    return weight


_CHANGE = [_weight(column, 0) for column in range(COLUMNS)]
_ERROR = [_weight(column, 0) - _weight(column, 1) for column in range(COLUMNS)]


def step(field: Field, x: Array, t: Array, h: Array, tolerance: float) -> tuple[Array, Array]:
    """The states after steps of lengths h, and the errors over what is allowed; NaN where there is no step."""
    slope = field(x, t)
    change, error = np.zeros_like(x), np.zeros_like(x)
    for column, substeps in enumerate(_SUBSTEPS):
        substep = h / substeps
        before, here = np.zeros_like(x), substep * slope
        for k in range(1, substeps):
            before, here = here, before + 2 * substep * field(x + here, t + k * substep)
        change += _CHANGE[column] * here
        error += _ERROR[column] * here
    allowed = tolerance * (1 + np.abs(x) + np.abs(h * slope))
    return x + change, (np.abs(error) / allowed).max(axis=0)


def over_period(
    field: Field,
    states: Array,
    begin: float,
    period: float,
    tolerance: float,
    escape: float = 1e6,
    max_steps: int = 20000,
    guarded: int | None = None,
) -> tuple[Array, int]:
    """The states after a period, which may be negative, NaN where they are lost; and the evaluations it took.

    Lost is a trajectory one of whose first `guarded` coordinates (default: all) exceeds `escape`, or that takes more steps
    than `max_steps`. Steps are period / 2^level and begin at whole multiples of themselves.
    """
    result = np.full_like(states, np.nan)
    item = np.flatnonzero(np.isfinite(states).all(axis=0))
    x = np.ascontiguousarray(states[:, item])
    level = np.full(len(item), _FIRST_LEVEL)
    position = np.zeros(len(item), dtype=np.int64)
    evaluations = 0
    for _ in range(max_steps):
        if len(item) == 0:
            break
        _lober.check_cancelled()
        h = period * 0.5**level
        with np.errstate(all="ignore"):
            end, error = step(field, x, begin + position * h, h, tolerance)
        evaluations += EVALUATIONS * len(item)
        good = error <= 1
        lost = (good & ~(np.abs(end[:guarded]).max(axis=0) <= escape)) | (~good & (level == _DEEPEST_LEVEL))
        x = np.where(good, end, x)
        position = np.where(good, position + 1, 2 * position)
        level = np.where(good, level, level + 1)
        done = good & (position == 2**level)
        result[:, item[done & ~lost]] = x[:, done & ~lost]
        # A step of twice the length has about 2^12 times the error.
        double = good & ~done & (position % 2 == 0) & (level > 0) & (error < 0.25 * 2.0**-12)
        position = np.where(double, position // 2, position)
        level = np.where(double, level - 1, level)
        left = ~(done | lost)
        item, level, position = item[left], level[left], position[left]
        x = np.ascontiguousarray(x[:, left])
    return result, evaluations
