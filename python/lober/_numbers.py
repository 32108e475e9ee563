"""Numbers that a caller gives, where no text will do."""

from __future__ import annotations

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
