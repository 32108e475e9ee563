"""Numbers with error bars."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._areas import html_table


@dataclass(frozen=True)
class Measured:
    """A value, or an array of values, and an estimate of what it may be wrong by, on the safe side."""

    value: Any
    error: Any

    def __array__(self, dtype: Any = None) -> NDArray[Any]:
        """The value."""
        return np.asarray(self.value, dtype)

    def __float__(self) -> float:
        return float(self.value)

    def _repr_html_(self) -> str:
        if np.ndim(self.value) == 0:
            return f"{self.value:.15g} &plusmn; {self.error:.1e}"
        values, errors = np.ravel(self.value), np.ravel(self.error)
        rows = [[str(k), f"{values[k]:.15g}", f"{errors[k]:.1e}"] for k in range(min(len(values), 20))]
        return html_table(["", f"value, of shape {np.shape(self.value)}", "error"], rows)

    def __str__(self) -> str:
        return f"{self.value} +- {self.error}"
