"""Numbers that a caller gives, where no text will do."""

from __future__ import annotations

import operator
from typing import Any

import numpy as np

from .errors import UsageError


def number_of(given: Any, what: str) -> float:
    """A number as a double. `float` would read a text too, and what looks like a number may have come from a file."""
    if isinstance(given, (str, bytes, bytearray)):
        raise UsageError(f"{what} has to be a number, not the text {given!r}; convert it with float()")
    if np.iscomplexobj(given):
        # float() of a complex number of NumPy leaves the imaginary part out, with a warning.
        raise TypeError(f"{what} has to be a real number, not {type(given).__name__}")
    try:
        return float(given)
    except (TypeError, ValueError):
        raise TypeError(f"{what} has to be a number, not {type(given).__name__}") from None
    except OverflowError:
        raise UsageError(f"{what} is too large for a double; scale the units") from None


def numbers_of(given: Any, what: str, count: int = 0) -> tuple[float, ...]:
    """Several numbers, as many as `count` says where it says something."""
    words = {0: "numbers", 2: "two numbers", 4: "the four numbers x0, y0, x1, y1"}[count]
    try:
        entries = [given] if isinstance(given, (str, bytes)) else list(given)
    except TypeError:
        raise TypeError(f"{what} has to be {words}, not {given!r}") from None
    if count and len(entries) != count:
        raise UsageError(f"{what} has to be {words}, not {given!r}")
    return tuple(number_of(one, what) for one in entries)


def threads_of(given: Any) -> int:
    """A number of threads: 0 or None for one of each core. Whole numbers of every type are taken, nothing else."""
    if given is None:
        return 0
    try:
        if isinstance(given, (bool, np.bool_)):
            raise TypeError
        return operator.index(given)
    except TypeError:
        raise TypeError(f"threads has to be a whole number, 0 for one of each core, not {given!r}") from None


def seed_of(seed: int, default: int, rng: Any) -> int:
    """The seed of random numbers: as it is given, or drawn from `rng`, which is what numpy.random.default_rng takes."""
    if rng is None:
        return seed
    if seed != default:
        raise UsageError("seed and rng are both given; give one of them")
    return int(np.random.default_rng(rng).integers(2**63))
