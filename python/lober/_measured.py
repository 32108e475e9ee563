"""Numbers with error bars."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Measured:
    """A value, or an array of values, and an estimate of what it may be wrong by, on the safe side."""

    value: Any
    error: Any

    def __str__(self) -> str:
        return f"{self.value} +- {self.error}"
