"""Maps whose steps Python functions of many points at a time compute, with their derivatives."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np

from ._numbers import number_of
from ._own_field import Array, Columns, Function
from ._systems import Pair
from .errors import UsageError


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
    has_inverse = True
    extent = np.inf

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
        self.extent = extent
        self._forward = Columns(forward, name)
        self._inverse = None if inverse is None else Columns(inverse, name)
        self.has_inverse = inverse is not None
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
        _, finer = differences(lambda points: self.step(points, True)[0], x, self.extent, 1.25e-4)
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
        return differences(lambda points: self.step(points, forward)[0], x, self.extent)

    def action(self, start: Pair, end: Pair) -> float | None:
        return None if self._action is None else number_of(self._action(start[0], end[0]), f"{self._name}: action")
