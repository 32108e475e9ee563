"""Results that pickle as the call that made them: the same input gives the same bits anywhere."""

from __future__ import annotations

from typing import Any

from ._result import Result


def recompute(function: str, arguments: tuple[Any, ...], options: dict[str, Any]) -> Any:
    import lober

    return getattr(lober, function)(*arguments, **options)


class Recomputed(Result):
    """Keeps the run that made it. Loading a pickle, or copying, repeats the call."""

    #: The function of the package.
    _function: str

    def __reduce__(self) -> tuple[Any, ...]:
        return recompute, (self._function, self._run.arguments, self._run.options)
