"""Systems: maps and flows with their parameters chosen."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import Any, Mapping, Union

import numpy as np
from numpy.typing import NDArray

from . import _lober
from ._arrays import Points, points_of
from ._numbers import number_of, numbers_of
from .errors import UsageError

Pair = tuple[float, float]
Box = tuple[float, float, float, float]


@dataclass(frozen=True)
class Parameter:
    """A parameter of a system, its default and the values that make sense."""

    name: str
    value: float
    meaning: str
    min: float
    max: float
    min_excluded: bool


@dataclass(frozen=True)
class SystemInfo:
    """The description of a system before its parameters are chosen."""

    name: str
    summary: str
    parameters: list[Parameter]


@dataclass(frozen=True)
class Connection:
    """A pair of manifolds: the unstable one of a saddle and the stable one of another or the same.

    `from_saddle` and `to_saddle` are points near them, `u_direction` and `s_direction` vectors roughly along the branches,
    away from their saddles; `bip` is a point near the pip where the boundary passes from one to the other, `closure` the
    corners of the path that closes it.
    """

    from_saddle: Pair
    u_direction: Pair
    to_saddle: Pair
    s_direction: Pair
    bip: Pair | None = None
    closure: tuple[Pair, ...] = field(default=())

    def _parts(self) -> tuple[Any, ...]:
        bip = None if self.bip is None else pair_of(self.bip, "bip of a connection")
        return (
            pair_of(self.from_saddle, "from_saddle of a connection"),
            pair_of(self.u_direction, "u_direction of a connection"),
            pair_of(self.to_saddle, "to_saddle of a connection"),
            pair_of(self.s_direction, "s_direction of a connection"),
            bip,
            tuple(pair_of(corner, "a corner of a connection") for corner in self.closure),
        )


def pair_of(given: Any, what: str) -> Pair:
    x, y = numbers_of(given, what, 2)
    return x, y


def _info(parts: tuple[Any, ...]) -> SystemInfo:
    name, summary, parameters = parts
    return SystemInfo(name, summary, [Parameter(*entry) for entry in parameters])


def systems() -> list[SystemInfo]:
    """The built-in systems, in the order of their names."""
    return [_info(parts) for parts in _lober.systems()]


class System:
    """A system with its parameters chosen. Made by `system`, or by the decorators `flow` and `map`."""

    def __init__(self, of: _lober.System, call: tuple[Any, ...]) -> None:
        self._of = of
        self._call = call

    def __reduce__(self) -> tuple[Any, ...]:
        return self._call

    def _named(self) -> tuple[str | None, dict[str, float], float]:
        """Name, parameters and tolerance that make this system; no name where it is one of one's own."""
        function, (name, values, tolerance) = self._call
        return name if function is _system_of else None, values, tolerance

    def _relative(self, changed: Mapping[str, float]) -> System:
        """The same system with other values of some parameters."""
        function, (of, values, tolerance) = self._call
        made: System = function(of, {**values, **changed}, tolerance)
        return made

    @property
    def name(self) -> str:
        return self._of.info[0]

    @property
    def summary(self) -> str:
        return self._of.info[1]

    @property
    def parameters(self) -> dict[str, float]:
        return {entry[0]: entry[1] for entry in self._of.info[2]}

    @property
    def window(self) -> tuple[float, float, float, float]:
        """Where the fixed points of interest are: x0, y0, x1, y1."""
        return self._of.window

    @property
    def picture(self) -> tuple[float, float, float, float]:
        """The box that a picture of orbits shows: x0, y0, x1, y1; the window, unless the system says otherwise."""
        return self._of.picture

    @property
    def lattice(self) -> Pair:
        """The shift after which the map repeats itself; (0, 0) for none."""
        return self._of.lattice

    @property
    def connection(self) -> Connection | None:
        """The pair of manifolds that the system is known for."""
        parts = self._of.connection
        return None if parts is None else Connection(*parts)

    @property
    def dimension(self) -> int:
        """Dimension of the flow; 0 for a map."""
        return self._of.dimension

    @property
    def period(self) -> float:
        """Period of the flow in time; 0 for autonomous flows and for maps."""
        return self._of.period

    @property
    def saddles(self) -> list[tuple[float, ...]]:
        """Points of phase space near the saddles that bound a well."""
        return self._of.saddles

    def iterate(self, points: Any, iterates: int = 1, *, threads: int = 0) -> Points:
        """Images of points under the planar map; pre-images for negative `iterates`. NaN for an orbit that is lost."""
        return _lober.images(self._of, points_of(points, "points"), iterates, threads)

    def derivative(self, points: Any, iterates: int = 1, *, threads: int = 0) -> NDArray[np.float64]:
        """Derivatives of the planar map at points, N x 2 x 2."""
        return _lober.derivatives(self._of, points_of(points, "points"), iterates, threads)

    def __repr__(self) -> str:
        values = ", ".join(f"{name} = {value:g}" for name, value in self.parameters.items())
        return f"<System {self.name}: {values}>"


def system(
    name: Union[str, "os.PathLike[str]"],
    parameters: Mapping[str, float] | None = None,
    /,
    *,
    integration_tolerance: float = 1e-12,
    **more: float,
) -> System:
    """A built-in system by its name, or the one in a shared library by its path, with values of its parameters.

    Parameters that are not given take their defaults. `integration_tolerance` is the error that a step of the integration
    of a flow may have. Raises UsageError, DataError.

        lober.system("duffing", eps=0.2)
    """
    values = {**(parameters or {}), **more}
    text = os.fspath(name)
    numbers = [(key, number_of(value, f"system {text}: parameter {key}")) for key, value in values.items()]
    return System(
        _lober.system(text, numbers, integration_tolerance), (_system_of, (text, values, integration_tolerance))
    )


def _system_of(name: str, values: dict[str, float], tolerance: float) -> System:
    return system(name, values, integration_tolerance=tolerance)


def system_of(given: Any) -> System:
    """A system where a system or its name is accepted."""
    if isinstance(given, System):
        return given
    if isinstance(given, (str, os.PathLike)):
        return system(given)
    default = getattr(given, "default", None)  # of a Family
    if callable(default):
        made = default()
        assert isinstance(made, System)
        return made
    raise TypeError(f"a system or its name is needed, not {type(given).__name__}")


def is_own(given: System, connection: Connection | None) -> bool:
    """Whether a connection is that which the system is known for."""
    own = given.connection
    # Compared as numbers: a caller's may be arrays.
    return connection is None or (own is not None and connection._parts() == own._parts())
