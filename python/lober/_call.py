"""Calls of operations of the engine's table by their names."""

from __future__ import annotations

from typing import Any, Sequence

import numpy as np

from . import _lober
from ._numbers import number_of
from ._progress import Progress, watching
from ._systems import Connection, is_own, pair_of, system_of


def system_input(system: Any, connection: Connection | None = None) -> tuple[Any, ...]:
    """The system, with a tangle of the caller's own in place of that which it is known for; and how to make its
    relatives, where it was made from a name."""
    given = system_of(system)
    if connection is not None and not is_own(given, connection):
        return (_lober.with_connection(given._of, connection._parts()), None, [], 0.0)
    name, values, tolerance = given._named()
    return (given._of, name, list(values.items()), tolerance)


def _setting(key: str, value: Any, kind: str) -> Any:
    if value is None or isinstance(value, (bool, str)):
        return value
    if kind == "point":
        return pair_of(value, key)
    if kind in ("box", "numbers"):
        return tuple(number_of(one, key) for one in value)
    if kind == "int" and isinstance(value, (int, np.integer)):
        return int(value)
    return number_of(value, key)


_kinds = {
    operation["name"]: {option["key"]: option["type"] for option in operation["options"]} for operation in _lober.table()
}


def call(
    name: str, inputs: Sequence[Any], settings: dict[str, Any], threads: int, progress: Progress
) -> tuple[dict[str, Any], list[tuple[Any, ...]]]:
    """The result of an operation, as a dictionary, and its comparisons. Inputs are those of `system_input`, and points."""
    kinds = _kinds[name]
    given = {key: _setting(key, value, kinds.get(key, "")) for key, value in settings.items()}
    with watching(progress, name) as callback:
        value, comparisons, _ = _lober.call(name, list(inputs), given, threads, callback)
    return value, comparisons
