"""Quantities by two independent routes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .errors import DisagreementError


@dataclass(frozen=True)
class Comparison:
    """One quantity by two routes; `bar` is the sum of both error bars."""

    what: str
    first_by: str
    second_by: str
    first: float
    second: float
    bar: float

    @property
    def difference(self) -> float:
        return abs(self.first - self.second)

    @property
    def agrees(self) -> bool:
        return self.first == self.second or self.difference <= self.bar

    def __str__(self) -> str:
        return (
            f"{self.what}: {self.first!r} by {self.first_by}, {self.second!r} by {self.second_by}; "
            f"they differ by {self.difference:.3g}, the bars allow {self.bar:.3g}"
        )


@dataclass(frozen=True)
class Agreement:
    """All comparisons of a result. True where all agree."""

    comparisons: list[Comparison]

    def __bool__(self) -> bool:
        return all(comparison.agrees for comparison in self.comparisons)

    @property
    def disagreements(self) -> list[Comparison]:
        return [comparison for comparison in self.comparisons if not comparison.agrees]

    def require(self) -> None:
        """Raises DisagreementError where two routes differ by more than their bars."""
        for c in self.disagreements:
            raise DisagreementError(str(c))


def agreement_of(comparisons: list[tuple[Any, ...]]) -> Agreement:
    return Agreement([Comparison(*entry) for entry in comparisons])
