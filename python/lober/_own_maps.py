"""Maps whose steps Python functions of many points at a time compute, with their derivatives."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np
from numpy.typing import NDArray

from ._integrate import over_period
from ._numbers import number_of
from ._systems import Pair
from .errors import UsageError

Array = NDArray[np.float64]
Function = Callable[..., Any]


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


class OwnMap:
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


class FormulaMap(OwnMap):
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


class PeriodMap(OwnMap):
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
        return PeriodMap(
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
