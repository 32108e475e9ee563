"""The expressions of a flow as functions of NumPy."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Sequence

import numpy as np
from numpy.typing import NDArray

from ._forms import T, Form
from ._printers import in_numpy


class NumPyForm:
    def __init__(self, form: Form) -> None:
        symbols = [*form.coordinates, T, *form.symbols]
        self._form = form
        #: Of the coordinates, t and the parameters, arrays or numbers.
        self.velocity = in_numpy(symbols, form.velocity)
        self.hamiltonian: Any = None if form.h is None else in_numpy(symbols, form.h)
        self._length = None if form.length is None else in_numpy(form.symbols, form.length)

    def period(self, values: Sequence[float]) -> float:
        """0 where there is none."""
        if self._length is None:
            return 0.0
        with np.errstate(all="ignore"):
            return float(self._length(*map(np.float64, values)))

    @cached_property
    def jacobian(self) -> Any:
        """When it is asked for: NumPy alone does without, and a remainder, say, has no derivative in SymPy."""
        return in_numpy([*self._form.coordinates, T, *self._form.symbols], self._form.jacobian)

    def values(self, points: NDArray[np.float64], times: NDArray[np.float64], values: Sequence[float]) -> NDArray[np.float64]:
        """The values that `lober_values` of the library writes (_c_source.py), a column for each point."""
        arguments: list[Any] = [*points, times, *map(np.float64, values)]
        n = len(points)
        found = np.zeros((n + n * n + 2, len(times)))
        with np.errstate(all="ignore"):
            for row, entry in enumerate([*self.velocity(*arguments), *self.jacobian(*arguments)]):
                found[row] = entry
            found[-2] = self.period(values)
            if self.hamiltonian is not None:
                found[-1] = self.hamiltonian(*arguments)
        return found
