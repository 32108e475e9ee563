"""Results that pickle as the call that made them: the same input gives the same bits anywhere."""

from __future__ import annotations

from typing import Any


def recompute(function: str, arguments: tuple[Any, ...], options: dict[str, Any]) -> Any:
    import lober

    return getattr(lober, function)(*arguments, **options)


class Recomputed:
    """Keeps the call that made it. Loading a pickle, or copying, repeats the call."""

    _call: tuple[str, tuple[Any, ...], dict[str, Any]]

    def __reduce__(self) -> tuple[Any, ...]:
        return recompute, self._call
