"""Maps and flows of one's own, as Python functions of many points at a time."""

from __future__ import annotations

import inspect
from typing import Any, Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from . import _lober
from ._integrate import over_period
from ._numbers import number_of
from ._systems import Connection, Pair, System, pair_of
from .errors import DataError, UsageError

Array = NDArray[np.float64]
Function = Callable[..., Any]
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

    def __repr__(self) -> str:
        values = ", ".join(f"{key} = {value:g}" for key, value in self.parameters.items())
        return f"<Family {self.name}: {values}>"


def _member(family: Family, values: dict[str, float], tolerance: float) -> System:
    return family(integration_tolerance=tolerance, **values)


class _Columns:
    """The answer of a function for two coordinates and its other arguments, as an array of 2 x N.

    It has to give two coordinates, numbers or arrays of N. For two points one array of 2 x 2 could hold them either way, so
    that the first call is for three.
    """

    def __init__(self, function: Function, name: str) -> None:
        self._function = function
        self._name = name
        self._seen = False

    def __call__(self, *arguments: Array) -> Array:
        count = len(arguments[0])
        if not self._seen and count > 0:
            self._of([entry[np.arange(3) % count] for entry in arguments])
            self._seen = True
        return self._of(list(arguments))

    def _of(self, arguments: list[Array]) -> Array:
        count = len(arguments[0])
        answer = self._function(*arguments)
        try:
            parts = list(answer)
        except TypeError:
            raise UsageError(f"{self._name} has to give 2 coordinates, not one {type(answer).__name__}") from None
        if len(parts) != 2:
            shape = getattr(answer, "shape", None)
            seen = len(parts) if shape is None else f"{len(parts)}, an array of shape {shape} for {count} points"
            raise UsageError(
                f"{self._name} has to give 2 coordinates, not {seen}; return two arrays, such as (a[:, 0], a[:, 1])"
            )
        result = np.empty((2, count))
        for k, part in enumerate(parts):
            if np.shape(part) not in ((), (1,), (count,)):
                raise UsageError(
                    f"{self._name} has to give an array of {count} numbers, or one, for each coordinate of {count} points, "
                    f"not one of shape {np.shape(part)}"
                )
            if np.iscomplexobj(part):
                raise UsageError(f"{self._name} has to give real numbers, not complex ones; return their parts as coordinates")
            result[k] = part
        return result


def _parameters(function: Function, known: Mapping[str, float], coordinates: int, name: str) -> list[str]:
    """Names of the parameters that a function takes after its coordinates (and the time)."""
    names = list(inspect.signature(function).parameters)[coordinates:]
    for key in names:
        if key not in known:
            raise UsageError(f"{name}: {key} is neither a coordinate nor among params")
    return names


def differences(function: Callable[[Array], Array], x: Array, extent: float, step: float = 1e-3) -> tuple[Array, Array]:
    """A function of 2 x N numbers at x, and its derivatives, 2 x 2 x N, by central differences of order 4. The step is
    relative to the smaller of 1 + |x| and the extent of the window, which knows the units."""
    h = step * np.minimum(1 + np.abs(x).max(axis=0), extent)
    around = [x]
    for axis in range(2):
        for factor in (1, -1, 2, -2):
            moved = x.copy()
            moved[axis] += factor * h
            around.append(moved)
    values = function(np.concatenate(around, axis=1)).reshape(2, 9, x.shape[1])
    derivatives = np.empty((2, 2, x.shape[1]))
    for axis in range(2):
        near = values[:, 1 + 4 * axis] - values[:, 2 + 4 * axis]
        far = values[:, 3 + 4 * axis] - values[:, 4 + 4 * axis]
        derivatives[:, axis] = (8 * near - far) / (12 * h)
    return np.ascontiguousarray(values[:, 0]), derivatives


class _OwnMap:
    """The methods that the engine needs of a map (bindings/python_map.cpp)."""

    action_accuracy = 1e-15

    def step(self, x: Array, forward: bool) -> tuple[Array, int]:
        """Images of points, an array of 2 x N, and the evaluations of a field they took."""
        raise NotImplementedError

    def step_with_derivatives(self, x: Array, forward: bool) -> tuple[Array, Array]:
        """Images and derivatives, the latter 2 x 2 x N."""
        raise NotImplementedError

    def slips(self, x: Array, shift: Array) -> list[tuple[str, Array, Array]]:
        """Rules that hold at points: in words what does not, by how much it is off there, and what rounding allows."""
        return []

    def once(self, points: Array, forward: bool) -> tuple[Array, int]:
        images, evaluations = self.step(np.ascontiguousarray(points.T), forward)
        return np.ascontiguousarray(images.T), evaluations

    def iterate_with_derivatives(self, points: Array, iterates: int) -> tuple[Array, Array]:
        x = np.ascontiguousarray(points.T)
        product = np.zeros((2, 2, len(points)))
        product[0, 0] = product[1, 1] = 1
        for _ in range(abs(iterates)):
            x, derivatives = self.step_with_derivatives(x, iterates > 0)
            product = np.einsum("ijn,jkn->ikn", derivatives, product)
        return np.ascontiguousarray(x.T), np.ascontiguousarray(product.transpose(2, 0, 1))

    def action(self, start: Pair, end: Pair) -> float | None:
        return None

    def finer(self) -> Any:
        return None


class _FormulaMap(_OwnMap):
    def __init__(
        self, name: str, forward: Function, inverse: Function | None, action: Function | None, extent: float
    ) -> None:
        self._name = name
        self._extent = extent
        self._forward = _Columns(forward, name)
        self._inverse = None if inverse is None else _Columns(inverse, name)
        self._action = action

    def step(self, x: Array, forward: bool) -> tuple[Array, int]:
        function = self._forward if forward else self._inverse
        if function is None:
            raise UsageError(f"system {self._name} has no inverse, which this needs; give inverse")
        with np.errstate(all="ignore"):
            return function(*x), 0

    def slips(self, x: Array, shift: Array) -> list[tuple[str, Array, Array]]:
        images, derivatives = self.step_with_derivatives(x, True)
        size = 1 + np.abs(derivatives).sum(axis=(0, 1))
        _, finer = differences(lambda points: self.step(points, True)[0], x, self._extent, 1.25e-4)
        gap = np.abs(derivatives - finer).max(axis=(0, 1))
        if np.median(gap / size) <= 1e-4:  # where the map jumps, a few are far off
            gap = np.zeros_like(gap)
        found = [("differences over a thousandth of the window give no derivatives: it is not of the size of the motion", gap, 1e-4 * size)]
        if self._inverse is not None:
            determinant = np.abs(derivatives[0, 0] * derivatives[1, 1] - derivatives[0, 1] * derivatives[1, 0])
            stretch = 1 + size / np.maximum(determinant, 1e-4)
            back, _ = self.step(images, False)
            allowed = 1e-6 * stretch * (np.abs(x).max(axis=0) + np.abs(images).max(axis=0) + np.ptp(x))
            found.append(("inverse is not that of the map", np.abs(back - x).max(axis=0), allowed))
        if shift.any():
            there, _ = self.step(x + shift, True)
            gap = np.abs(there - images - shift).max(axis=0)
            allowed = 1e-6 * size * (np.abs(shift).max() + np.abs(images).max(axis=0))
            found.append((f"the map does not repeat after its lattice {tuple(shift.ravel().tolist())}", gap, allowed))
        return found

    def step_with_derivatives(self, x: Array, forward: bool) -> tuple[Array, Array]:
        return differences(lambda points: self.step(points, forward)[0], x, self._extent)

    def action(self, start: Pair, end: Pair) -> float | None:
        return None if self._action is None else number_of(self._action(start[0], end[0]), f"{self._name}: action")


class _PeriodMap(_OwnMap):
    def __init__(
        self,
        name: str,
        velocity: Function,
        hamiltonian: Function | None,
        begin: float,
        period: float,
        tolerance: float,
        escape: float,
        extent: float,
    ) -> None:
        self._name = name
        self._extent = extent
        self._velocity = velocity
        self._columns = _Columns(velocity, name)
        self._hamiltonian = hamiltonian
        self._begin = begin
        self._period = period
        self._tolerance = tolerance
        self._escape = escape
        self.action_accuracy = 10 * max(0.01 * tolerance, 1e-15)

    def step(self, x: Array, forward: bool) -> tuple[Array, int]:
        period = self._period if forward else -self._period
        return over_period(self._field, x, self._begin, period, self._tolerance, self._escape)

    def step_with_derivatives(self, x: Array, forward: bool) -> tuple[Array, Array]:
        """By the variational equations, whose errors slow Newton's method and do nothing else.

        Differences of the velocity are good to 1e-12 or so: a tolerance near that would take steps of no length.
        """
        period = self._period if forward else -self._period
        one, zero = np.ones(x.shape[1]), np.zeros(x.shape[1])
        states = np.stack([*x, one, zero, zero, one])
        tolerance = max(self._tolerance, 1e-9)
        found, _ = over_period(self._with_tangents, states, self._begin, period, tolerance, self._escape, guarded=2)
        images, _ = self.step(x, forward)
        return images, np.ascontiguousarray(found[2:].reshape(2, 2, -1))

    def action(self, start: Pair, end: Pair) -> float | None:
        """The integral of y dx - H dt, and y' dx' for the gap between `end` and the image."""
        if self._hamiltonian is None:
            return None
        state = np.array([[start[0]], [start[1]], [0.0]])
        tolerance = max(0.01 * self._tolerance, 1e-15)
        (x, _, along), _ = over_period(self._with_action, state, self._begin, self._period, tolerance, self._escape, guarded=2)
        return float(along[0] + end[1] * (end[0] - x[0]))

    def finer(self) -> Any:
        tolerance = min(self._tolerance, max(0.01 * self._tolerance, 1e-15))
        return _PeriodMap(
            self._name, self._velocity, self._hamiltonian, self._begin, self._period, tolerance, self._escape, self._extent
        )

    def slips(self, x: Array, shift: Array) -> list[tuple[str, Array, Array]]:
        found = []
        for phase in (0.0, 0.3):
            t = np.full(x.shape[1], self._begin + phase * self._period)
            here = self._field(x, t)
            others = [(f"the velocity does not repeat after its period {self._period:g}", self._field(x, t + self._period))]
            if shift.any():
                lattice = tuple(shift.ravel().tolist())
                others.append((f"the velocity does not repeat after its lattice {lattice}", self._field(x + shift, t)))
            for what, there in others:
                allowed = 1e-6 * (np.abs(here).max(axis=0) + np.abs(there).max(axis=0))
                found.append((what, np.abs(there - here).max(axis=0), allowed))
        return found

    def _field(self, x: Array, t: Array) -> Array:
        return self._columns(*x, t)

    def _with_tangents(self, x: Array, t: Array) -> Array:
        times = np.tile(t, 9)
        velocity, jacobian = differences(lambda points: self._field(points, times), np.ascontiguousarray(x[:2]), self._extent)
        tangents = np.einsum("ijn,jkn->ikn", jacobian, x[2:].reshape(2, 2, -1))
        return np.concatenate([velocity, tangents.reshape(4, -1)])

    def _with_action(self, x: Array, t: Array) -> Array:
        assert self._hamiltonian is not None
        velocity = self._field(np.ascontiguousarray(x[:2]), t)
        energy = self._hamiltonian(x[0], x[1], t)
        if np.iscomplexobj(energy):
            raise UsageError(f"{self._name}: hamiltonian has to give real numbers, not complex ones")
        return np.stack([*velocity, x[1] * velocity[0] - energy])


def _bound(function: Any, params: Mapping[str, float], coordinates: int, name: str) -> Any:
    """Makes of a function and a choice of parameters one of its coordinates alone."""
    if function is None:
        return lambda values: None
    names = _parameters(function, params, coordinates, name)

    def bind(values: Mapping[str, float]) -> Function:
        chosen = [values[key] for key in names]
        given: Function = function
        return lambda *arguments: given(*arguments, *chosen)

    return bind


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

    def decorate(function: Function) -> Family:
        title = name or function.__name__
        forwards = _bound(function, parameters, 2, title)
        backwards = _bound(inverse, parameters, 2, title)
        actions = _bound(action, parameters, 2, title)

        def make(values: Mapping[str, float], tolerance: float) -> System:
            own = _FormulaMap(title, forwards(values), backwards(values), actions(values), extent_of(title, window))
            return own_system(title, function, values, own, window, lattice, _value(connection, values))

        return Family(title, parameters, make)

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

    def decorate(function: Function) -> Family:
        title = name or function.__name__
        velocities = _bound(function, parameters, 3, title)
        hamiltonians = _bound(hamiltonian, parameters, 3, title)
        begin = number_of(phase, f"system {title}: phase")

        def make(values: Mapping[str, float], tolerance: float) -> System:
            length = number_of(_value(period, values), f"system {title}: the period")
            own = period_map(title, velocities(values), hamiltonians(values), begin, length, tolerance, window)
            return own_system(title, function, values, own, window, lattice, _value(connection, values))

        return Family(title, parameters, make)

    return decorate if velocity is None else decorate(velocity)


def period_map(
    name: str,
    velocity: Function,
    hamiltonian: Function | None,
    phase: float,
    period: float,
    tolerance: float,
    window: Box,
) -> _OwnMap:
    if not (np.isfinite(period) and period > 0):
        raise UsageError(f"system {name}: its period is not positive")
    # A trajectory is lost far outside the window, in whatever units that is.
    farthest = max(abs(number_of(edge, f"system {name}: window")) for edge in window)
    return _PeriodMap(name, velocity, hamiltonian, phase * period, period, tolerance, max(1e6, 1e3 * farthest), extent_of(name, window))


def extent_of(name: str, window: Box) -> float:
    """The extent of a system's window, which knows the units of its coordinates; infinite for an empty one, which is refused
    where it is used."""
    x0, y0, x1, y1 = (number_of(edge, f"system {name}: window") for edge in window)
    extent = max(x1 - x0, y1 - y0)
    return extent if 0 < extent < np.inf else np.inf


def _window_points(window: Box) -> Array:
    """Points off the middle and off round fractions, where symmetries hide slips, as an array of 2 x N."""
    x0, y0, x1, y1 = window
    across, up = np.meshgrid((np.arange(5) + 0.37) / 5, (np.arange(5) + 0.61) / 5)
    return np.stack([x0 + (x1 - x0) * across.ravel(), y0 + (y1 - y0) * up.ravel()])


def require_consistent(name: str, own: _OwnMap, window: Box, shift: Pair) -> None:
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
    own: _OwnMap,
    window: Box,
    lattice: Pair,
    connection: Connection | None,
) -> System:
    summary = "of expressions" if function is None else (inspect.getdoc(function) or "").partition("\n")[0]
    parts = None if connection is None else connection._parts()
    x0, y0, x1, y1 = (number_of(entry, f"system {name}: window") for entry in window)
    shift = pair_of(lattice, f"system {name}: lattice")
    require_consistent(name, own, (x0, y0, x1, y1), shift)
    made = _lober.own_system(name, summary, list(values.items()), own, (x0, y0, x1, y1), shift, parts)
    return System(made, ())
