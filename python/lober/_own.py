"""Systems of one's own, made of Python functions of many points at a time: `map`, `flow`, and the checks of both."""

from __future__ import annotations

import inspect
from typing import Any, Callable, Mapping

import numpy as np

from . import _lober
from ._numbers import number_of, numbers_of
from ._own_field import AddressField, Array, Function, VectorisedField, bound, field_of
from ._own_maps import FormulaMap, OwnMap
from ._pickles import pickled
from ._systems import Connection, Pair, System, pair_of
from .errors import DataError, UsageError

Box = tuple[float, float, float, float]


class Family:
    """A system whose parameters are still to be chosen: called with values of parameters it gives a `System`.

    Functions that take a system take a family too, with its defaults.
    """

    def __init__(self, name: str, parameters: Mapping[str, float], make: Callable[..., System]) -> None:
        self.name = name
        self.parameters = dict(parameters)
        self._make = make
        self._default: System | None = None
        self._made_by: tuple[Any, Any, dict[str, Any]] | None = None

    def __call__(self, *, integration_tolerance: float = 1e-12, **values: float) -> System:
        for key in values:
            if key not in self.parameters:
                known = ", ".join(self.parameters) or "none"
                raise UsageError(f"system {self.name} has no parameter '{key}'; it has: {known}")
        if not 0 < integration_tolerance < 1:
            raise UsageError("the tolerance of integration must be in (0, 1)")
        chosen = {**self.parameters, **values}
        numbers = {key: number_of(value, f"system {self.name}: parameter {key}") for key, value in chosen.items()}
        for key, value in numbers.items():
            if not np.isfinite(value):
                raise UsageError(f"system {self.name}: parameter {key} is not finite")
        made = self._make(numbers, integration_tolerance)
        made._call = (_member, (self, values, integration_tolerance))
        return made

    def default(self) -> System:
        if self._default is None:
            self._default = self()
        return self._default

    def made_by(self, maker: Any, given: Any, options: dict[str, Any]) -> Family:
        """Notes the call maker(given, **options) that makes this family again, for pickles."""
        self._made_by = (maker, given, options)
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        assert self._made_by is not None
        return pickled(self, *self._made_by)

    def __repr__(self) -> str:
        values = ", ".join(f"{key} = {value:g}" for key, value in self.parameters.items())
        return f"<Family {self.name}: {values}>"


def _member(family: Family, values: dict[str, float], tolerance: float) -> System:
    return family(integration_tolerance=tolerance, **values)


def _value(given: Any, values: Mapping[str, float]) -> Any:
    """A number or a pair, or a function of parameters that gives one."""
    if callable(given):
        return given(**{key: values[key] for key in inspect.signature(given).parameters})
    return given


def map(
    forward: Function | None = None,
    /,
    *,
    inverse: Function | None = None,
    action: Function | None = None,
    params: Mapping[str, float] | None = None,
    window: Box = (-2.0, -2.0, 2.0, 2.0),
    lattice: Pair = (0.0, 0.0),
    connection: Any = None,
    name: str | None = None,
) -> Any:
    """Makes a system of a vectorised function `f(x, y, ...parameters) -> (x', y')`; also a decorator.

    `inverse` is the inverse map, of the same form. `action` is the generating function L(x, x', ...) of a map that
    preserves area, with dL/dx' = y' and dL/dx = -y: areas by action need it. `window` is where fixed points of interest are,
    `lattice` the shift after which the map repeats itself. `connection` is a `Connection`, or a function of parameters that
    gives one.

        @lober.map(params={"k": 0.9}, inverse=...)
        def standard(x, y, k):
            y = y + k * np.sin(x)
            return x + y, y
    """
    parameters = dict(params or {})
    options = dict(
        inverse=inverse, action=action, params=parameters, window=window, lattice=lattice, connection=connection, name=name
    )

    def decorate(function: Function) -> Family:
        title = name or function.__name__
        forwards = bound(function, parameters, 2, title)
        backwards = bound(inverse, parameters, 2, title)
        actions = bound(action, parameters, 2, title)

        def make(values: Mapping[str, float], tolerance: float) -> System:
            own = FormulaMap(title, forwards(values), backwards(values), actions(values), extent_of(title, window))
            return own_system(title, function, values, own, window, lattice, _value(connection, values))

        return Family(title, parameters, make).made_by(map, function, options)

    return decorate if forward is None else decorate(forward)


def flow(
    velocity: Function | None = None,
    /,
    *,
    period: Any,
    params: Mapping[str, float] | None = None,
    hamiltonian: Function | None = None,
    phase: float = 0.0,
    window: Box = (-2.0, -2.0, 2.0, 2.0),
    lattice: Pair = (0.0, 0.0),
    connection: Any = None,
    name: str | None = None,
) -> Any:
    """Makes a system of the velocity `f(x, y, t, ...parameters) -> (dx/dt, dy/dt)` of a flow that is periodic in time; also
    a decorator.

    The function is called with arrays of many points, each with its own time. Its planar map is that over one `period` from
    `phase` periods on; `period` is a number, or a function of parameters. `hamiltonian(x, y, t, ...)` with dx/dt = dH/dy and
    dy/dt = -dH/dx gives areas by action. The rest as `map`.

        @lober.flow(period=2 * np.pi, params={"eps": 0.1})
        def pendulum(x, y, t, eps):
            return y, -np.sin(x) + eps * np.cos(t)
    """
    parameters = dict(params or {})
    options = dict(
        period=period,
        params=parameters,
        hamiltonian=hamiltonian,
        phase=phase,
        window=window,
        lattice=lattice,
        connection=connection,
        name=name,
    )

    def decorate(function: Function) -> Family:
        title = name or str(getattr(function, "__name__", "flow"))
        velocities = bound(function, parameters, 3, title)
        hamiltonians = bound(hamiltonian, parameters, 3, title)
        begin = number_of(phase, f"system {title}: phase")

        def make(values: Mapping[str, float], tolerance: float) -> System:
            length = number_of(_value(period, values), f"system {title}: the period")
            made = period_flow(title, velocities(values), hamiltonians(values), length, window)
            return flow_system(title, function, values, made, window, lattice, begin, tolerance, _value(connection, values))

        return Family(title, parameters, make).made_by(flow, function, options)

    return decorate if velocity is None else decorate(velocity)


def extent_of(name: str, window: Box) -> float:
    """The extent of a system's window, which knows the units of its coordinates; infinite for an empty one, which is refused
    where it is used."""
    x0, y0, x1, y1 = numbers_of(window, f"system {name}: window", 4)
    extent = max(x1 - x0, y1 - y0)
    return extent if 0 < extent < np.inf else np.inf


def _window_points(window: Box) -> Array:
    """Points off the middle and off round fractions, where symmetries hide slips, as an array of 2 x N."""
    x0, y0, x1, y1 = window
    across, up = np.meshgrid((np.arange(5) + 0.37) / 5, (np.arange(5) + 0.61) / 5)
    return np.stack([x0 + (x1 - x0) * across.ravel(), y0 + (y1 - y0) * up.ravel()])


def require_consistent(name: str, own: OwnMap | VectorisedField, window: Box, shift: Pair) -> None:
    """Raises DataError where functions do not belong together, at some points of the window: an inverse that is none, or
    a map or field that does not repeat after the lattice or the period. Points where they give no number are left out; a
    function that raises does so again where it is used."""
    x = _window_points(window)
    move = np.array(shift).reshape(2, 1)
    try:
        with np.errstate(all="ignore"):
            slips = own.slips(x, move)
    except Exception:
        return
    for what, gap, allowed in slips:
        wrong = np.flatnonzero(np.isfinite(gap) & np.isfinite(allowed) & ~(gap <= allowed))
        if len(wrong):
            at = tuple(float(number) for number in x[:, wrong[0]])
            raise DataError(f"system {name}: {what}; at {at} it is off by {gap[wrong[0]]:.3g}")


def own_system(
    name: str,
    function: Any,
    values: Mapping[str, float],
    own: OwnMap,
    window: Box,
    lattice: Pair,
    connection: Connection | None,
) -> System:
    parts = None if connection is None else connection._parts()
    x0, y0, x1, y1 = numbers_of(window, f"system {name}: window", 4)
    shift = pair_of(lattice, f"system {name}: lattice")
    require_consistent(name, own, (x0, y0, x1, y1), shift)
    made = _lober.own_system(
        own,
        name=name,
        summary=summary_of(function),
        values=list(values.items()),
        window=(x0, y0, x1, y1),
        lattice=shift,
        connection=parts,
    )
    return System(made, ())


def summary_of(function: Any) -> str:
    return "of expressions" if function is None else (inspect.getdoc(function) or "").partition("\n")[0]


def period_flow(
    name: str, velocity: Any, hamiltonian: Any, period: float, window: Box
) -> VectorisedField | AddressField:
    """The field of a flow of two coordinates over its period."""
    if not (np.isfinite(period) and period > 0):
        raise UsageError(f"system {name}: its period is not positive")
    return field_of(name, 2, velocity, hamiltonian, period, extent_of(name, window))


def flow_system(
    name: str,
    function: Any,
    values: Mapping[str, float],
    field: VectorisedField | AddressField,
    window: Box,
    lattice: Pair,
    phase: float,
    tolerance: float,
    connection: Connection | None,
) -> System:
    x0, y0, x1, y1 = numbers_of(window, f"system {name}: window", 4)
    shift = pair_of(lattice, f"system {name}: lattice")
    if isinstance(field, VectorisedField):
        require_consistent(name, field, (x0, y0, x1, y1), shift)
    # Whole periods change nothing but rounding.
    begin = phase - np.floor(phase) if abs(phase) >= 1 else phase
    made = _lober.field_system(
        field,
        name=name,
        summary=summary_of(function),
        values=list(values.items()),
        window=(x0, y0, x1, y1),
        lattice=shift,
        phase=float(begin),
        tolerance=tolerance,
    )
    if connection is not None:
        made.connect(connection._parts())
    return System(made, ())
