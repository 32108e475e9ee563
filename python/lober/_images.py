"""One image of a curve."""

from __future__ import annotations

from typing import Any

from ._dynamics import Image
from ._generated import images


def image(system: Any, curve: Any = None, iterates: int = 1, **options: Any) -> Image:
    """The image of a curve under `iterates` steps. Options as `images`. Raises UsageError, DataError, Cancelled."""
    return images(system, curve, iterates, iterates, **options)[0]
