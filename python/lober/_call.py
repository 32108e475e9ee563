"""Operations of the engine's table, as the functions of the package run them."""

from __future__ import annotations

import keyword
import warnings
from functools import cached_property
from typing import Any, Callable, Sequence

import numpy as np

from . import _lober
from ._agreement import Agreement, agreement_of
from ._arrays import kept_points_of, points_of, sealed
from ._numbers import number_of, numbers_of, threads_of
from ._progress import Progress, watching
from ._systems import Connection, System, is_own, pair_of, system_of
from .errors import DisagreementWarning, IncompleteWarning, UsageError

TABLE = {operation["name"]: operation for operation in _lober.table()}


def identifier(key: str) -> str:
    """The name of an argument for an option: "from" is a word of the language."""
    return key + "_" if keyword.iskeyword(key) else key


class Run:
    """An operation that has run: what it found, and the call of a function of the package that repeats it."""

    def __init__(
        self,
        name: str,
        of: _lober.OperationRun,
        arguments: tuple[Any, ...],
        options: dict[str, Any],
        again: Callable[[], _lober.OperationRun] | None,
    ) -> None:
        self.name = name
        self.of = of
        self.arguments = arguments
        self.options = options
        self._again = again  # with the parts that are computed when asked for

    @cached_property
    def value(self) -> dict[str, Any]:
        """All fields of the result, as `lober schema OPERATION` describes them: lists as dictionaries of columns, numbers
        with error bars as pairs of both. Arrays are read-only."""
        found: dict[str, Any] = sealed(self.of.value())
        return found

    @cached_property
    def whole(self) -> Run:
        """The run with all parts that the program computes: this one, or one more."""
        return self if self._again is None else Run(self.name, self._again(), self.arguments, self.options, None)

    @cached_property
    def json(self) -> str:
        """The fields in JSON, as the program writes them."""
        return self.of.json()

    @cached_property
    def comparisons(self) -> list[tuple[Any, ...]]:
        return self.of.comparisons()

    @property
    def agreement(self) -> Agreement:
        return agreement_of(self.comparisons)

    def __reduce__(self) -> tuple[Any, ...]:
        whole = self.whole
        return _stored, (self.name, whole.value, whole.json, whole.comparisons)


def _stored(name: str, value: dict[str, Any], json: str, comparisons: list[tuple[Any, ...]]) -> Run:
    """A run that was pickled: what it found."""
    run = Run.__new__(Run)
    run.__dict__.update(name=name, value=value, json=json, comparisons=comparisons, _again=None)
    return run


def system_input(system: System, connection: Connection | None = None) -> tuple[Any, ...]:
    """The system, with a tangle of the caller's own in place of that which it is known for; and how to make its
    relatives: by a name, or by a function."""
    name, values, tolerance = system._named()
    if connection is None or is_own(system, connection):
        return system._of, name, list(values.items()), tolerance, None if name else lambda changed: system._relative(changed)._of

    parts = connection._parts()

    def with_it(of: _lober.System) -> _lober.System:
        return _lober.with_connection(of, parts)

    return with_it(system._of), None, [], tolerance, lambda changed: with_it(system._relative(changed)._of)


def _setting(key: str, value: Any, kind: str) -> Any:
    if value is None or isinstance(value, (bool, str)):
        return value
    if isinstance(value, np.bool_):
        return bool(value)
    if kind == "str" and not np.isscalar(value):  # a vector where a word can be too: the branch of a manifold
        return ",".join(repr(number) for number in pair_of(value, key))
    if kind == "point":
        return pair_of(value, key)
    if kind == "numbers" and (np.ndim(value) == 2 or np.iscomplexobj(value)):  # the corners of a path
        value = points_of(value, key).ravel()
    if kind in ("box", "numbers"):
        return numbers_of(value, key)
    if kind == "int" and isinstance(value, (int, np.integer)):
        if abs(int(value)) >= 2**63:
            raise UsageError(f"{key}: {value} is too large")
        return int(value)
    return number_of(value, key)


def run(
    name: str,
    given: Sequence[Any],
    settings: dict[str, Any],
    threads: int,
    progress: Progress,
    connection: Connection | None = None,
    lazy: dict[str, bool | None] | None = None,
) -> Run:
    """Runs an operation on the inputs `given`, in the order of the table; None for one that is left out.

    Warns where a part is missing that was asked for (`IncompleteWarning`), and where routes disagree, where the program
    ends with exit status 3 (`DisagreementWarning`).

    `connection` is that of the system, which comes first. Its bip is insisted on where it is the caller's own. `lazy` are
    further settings, which are not those of the caller.
    """
    operation = TABLE[name]
    kinds = {option["key"]: option["type"] for option in operation["options"]}
    arguments: list[Any] = []
    inputs: list[Any] = []
    for spec, value in zip(operation["inputs"], given):
        if spec["system"]:
            made = system_of(value)
            if connection is not None and not is_own(made, connection) and settings.get("bip") is None:
                settings = {**settings, "bip": connection.bip}
            arguments.append(made)
            inputs.append(system_input(made, connection))
        elif value is not None or not spec["optional"]:
            arguments.append(kept_points_of(value, spec["name"]))
            inputs.append(arguments[-1])
    if connection is not None:
        arguments.append(connection)
    made_fit = {key: _setting(key, value, kinds.get(key, "")) for key, value in settings.items()}
    threads = threads_of(threads)
    with watching(progress, name) as callback:
        found = _lober.run(name, inputs, {**made_fit, **(lazy or {})}, threads, callback)
    if found.incomplete:
        warnings.warn(found.incomplete, IncompleteWarning, stacklevel=3)
    if apart := agreement_of(found.comparisons()).disagreements:
        more = f" (and {len(apart) - 1} more)" if len(apart) > 1 else ""
        warnings.warn(f"two routes disagree: {apart[0]}{more}", DisagreementWarning, stacklevel=3)
    again = (lambda: _lober.run(name, inputs, made_fit, threads, None)) if lazy else None
    return Run(name, found, tuple(arguments), {identifier(key): value for key, value in made_fit.items()}, again)
