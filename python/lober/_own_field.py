"""Vector fields of one's own, as the engine needs them (bindings/python_field.cpp): of functions of many points at a time,
and of compiled functions at an address."""

from __future__ import annotations

import inspect
from typing import Any, Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from .errors import UsageError

Array = NDArray[np.float64]
Function = Callable[..., Any]


class Columns:
    """The answer of a function for coordinates and its other arguments, as an array of coordinates x N.

    It has to give that number of coordinates, numbers or arrays of N. For as many points one array could hold them either
    way, so that the first call is for one more.
    """

    def __init__(self, function: Function, name: str, coordinates: int = 2) -> None:
        self._function = function
        self._name = name
        self._coordinates = coordinates
        self._seen = False

    def __call__(self, *arguments: Array) -> Array:
        count = len(arguments[0])
        if not self._seen and count > 0:
            self._of([entry[np.arange(self._coordinates + 1) % count] for entry in arguments])
            self._seen = True
        return self._of(list(arguments))

    def _of(self, arguments: list[Array]) -> Array:
        count, wanted = len(arguments[0]), self._coordinates
        answer = self._function(*arguments)
        try:
            parts = list(answer)
        except TypeError:
            raise UsageError(f"{self._name} has to give {wanted} coordinates, not one {type(answer).__name__}") from None
        if len(parts) != wanted:
            shape = getattr(answer, "shape", None)
            seen = len(parts) if shape is None else f"{len(parts)}, an array of shape {shape} for {count} points"
            arrays = "two arrays, such as (a[:, 0], a[:, 1])" if wanted == 2 else f"{wanted} arrays"
            raise UsageError(f"{self._name} has to give {wanted} coordinates, not {seen}; return {arrays}")
        result = np.empty((wanted, count))
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


class VectorisedField:
    """`velocity` and `hamiltonian` are functions of the coordinates and, where `period` is not 0, of the time."""

    has_jacobian = False

    def __init__(
        self,
        name: str,
        dimension: int,
        velocity: Function,
        hamiltonian: Function | None,
        period: float,
        extent: float,
        jacobian: Function | None = None,
    ) -> None:
        self._name = name
        self.dimension = dimension
        self.period = period
        self.extent = extent
        half = dimension // 2
        self.pairs = [] if hamiltonian is None else [(k, half + k) for k in range(half)]
        self._velocity = Columns(velocity, name, dimension)
        self._hamiltonian = hamiltonian
        self._jacobian = jacobian
        self.has_jacobian = jacobian is not None

    def _arguments(self, x: Array, t: Array) -> tuple[Array, ...]:
        return (*x, t) if self.period != 0 else tuple(x)

    def velocities(self, x: Array, t: Array) -> Array:
        with np.errstate(all="ignore"):
            return self._velocity(*self._arguments(x, t))

    def jacobians(self, x: Array, t: Array) -> Array:
        assert self._jacobian is not None
        found = np.empty((self.dimension**2, x.shape[1]))
        with np.errstate(all="ignore"):
            for row, entry in enumerate(self._jacobian(*self._arguments(x, t))):
                found[row] = entry
        return found

    def slips(self, x: Array, shift: Array) -> list[tuple[str, Array, Array]]:
        """Rules that hold at points: in words what does not, by how much it is off there, and what rounding allows."""
        found = []
        for phase in (0.0, 0.3):
            t = np.full(x.shape[1], phase * self.period)
            here = self.velocities(x, t)
            later = self.velocities(x, t + self.period)
            others = [(f"the velocity does not repeat after its period {self.period:g}", later)]
            if shift.any():
                lattice = tuple(shift.ravel().tolist())
                others.append((f"the velocity does not repeat after its lattice {lattice}", self.velocities(x + shift, t)))
            for what, there in others:
                allowed = 1e-6 * (np.abs(here).max(axis=0) + np.abs(there).max(axis=0))
                found.append((what, np.abs(there - here).max(axis=0), allowed))
        return found

    def hamiltonians(self, x: Array, t: Array) -> Array:
        assert self._hamiltonian is not None
        with np.errstate(all="ignore"):
            energy = self._hamiltonian(*self._arguments(x, t))
        if np.iscomplexobj(energy):
            raise UsageError(f"{self._name}: hamiltonian has to give real numbers, not complex ones")
        if np.shape(energy) not in ((), (1,), (x.shape[1],)):
            raise UsageError(
                f"{self._name}: hamiltonian has to give {x.shape[1]} numbers for as many points, not shape {np.shape(energy)}"
            )
        found = np.empty(x.shape[1])
        found[:] = energy
        return found


def address_of(function: Any, what: str) -> int:
    """The address of a compiled function, such as a cfunc of numba; 0 for None."""
    if function is None:
        return 0
    address = getattr(function, "address", None)
    if not isinstance(address, int) or address == 0:
        raise UsageError(f"{what} is not a compiled function with an address; make it with numba.cfunc, like the velocity")
    return address


def is_compiled(function: Any) -> bool:
    return isinstance(getattr(function, "address", None), int)


class AddressField:
    """Functions of the form of those of lober_flow (engine/lober/lober_system.h), such as those of `numba.cfunc`:

        velocity(params, x, t, dxdt) -> int     0 where there is a velocity
        jacobian(params, x, t, jacobian) -> int  row by row; may be missing
        hamiltonian(params, x, t) -> float

    `params`, `x` and results are pointers to doubles, the parameters in their order.
    """

    def __init__(
        self, name: str, dimension: int, velocity: Any, hamiltonian: Any, period: float, extent: float, jacobian: Any = None
    ) -> None:
        self.dimension = dimension
        self.period = period
        self.extent = extent
        half = dimension // 2
        self.pairs = [] if hamiltonian is None else [(k, half + k) for k in range(half)]
        self.velocity = address_of(velocity, f"system {name}: the velocity")
        self.jacobian = address_of(jacobian, f"system {name}: jacobian")
        self.hamiltonian = address_of(hamiltonian, f"system {name}: hamiltonian")
        self._kept = (velocity, jacobian, hamiltonian)


def bound(function: Any, params: Mapping[str, float], coordinates: int, name: str) -> Any:
    """Makes of a function and a choice of parameters one of its coordinates alone."""
    if function is None or is_compiled(function):
        return lambda values: function
    names = list(inspect.signature(function).parameters)[coordinates:]
    for key in names:
        if key not in params:
            raise UsageError(f"{name}: {key} is neither a coordinate nor among params")

    def bind(values: Mapping[str, float]) -> Function:
        chosen = [values[key] for key in names]
        given: Function = function
        return lambda *arguments: given(*arguments, *chosen)

    return bind


def field_of(
    name: str,
    dimension: int,
    velocity: Any,
    hamiltonian: Any,
    period: float,
    extent: float,
    jacobian: Any = None,
) -> VectorisedField | AddressField:
    made: Any = AddressField if is_compiled(velocity) else VectorisedField
    field: VectorisedField | AddressField = made(name, dimension, velocity, hamiltonian, period, extent, jacobian)
    return field


def names_of_coordinates(function: Any, params: Mapping[str, float], given: Sequence[str] | None) -> list[str]:
    """Names of the coordinates of a function: its first arguments, or those given."""
    if given is not None:
        return [str(one) for one in given]
    if is_compiled(function):
        return ["x", "y", "px", "py"]
    return [key for key in inspect.signature(function).parameters if key not in params]
