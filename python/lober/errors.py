"""Exceptions of lober, those of the library with the same text.

Each derives from `Error`; those that say that arguments or data cannot be used are `ValueError` too. A result without a
part that was asked for is a warning, `IncompleteWarning`, and one whose routes disagree another, `DisagreementWarning`.
"""

from __future__ import annotations


class Error(Exception):
    """Base of all exceptions of lober."""


class UsageError(Error, ValueError):
    """Contradictory or impossible options."""


class DataError(Error, ValueError):
    """A file or a curve that cannot be used."""


class NotSimpleError(DataError):
    """A curve that has to be simple and crosses or touches itself.

    `curve` is its number among the arguments, from 1; `segment1` and `segment2` meet at the point `at`.
    """

    def __init__(
        self, message: str, curve: int = 0, segment1: int = 0, segment2: int = 0, at: tuple[float, float] = (0.0, 0.0)
    ) -> None:
        super().__init__(message, curve, segment1, segment2, at)
        self.curve = curve
        self.segment1 = segment1
        self.segment2 = segment2
        self.at = at

    def __str__(self) -> str:
        return str(self.args[0])


class DisagreementError(Error):
    """Two independent routes to a quantity differ by more than their error bars."""


class Cancelled(Error):
    """A callback for progress returned False."""


class IncompleteWarning(UserWarning):
    """A part of a result is missing that was asked for: a manifold or an image ends early at a limit."""


class DisagreementWarning(UserWarning):
    """Two independent routes to a quantity of a result differ by more than their error bars: its `agreement` is false."""
