"""Melnikov's function of a transport, as the program compares it with the lobes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._systems import Pair


class Sides(NamedTuple):
    """Sums of the areas of a period's lobes, each counted as positive: on the left of U and on its right."""

    left: float
    right: float


@dataclass(frozen=True)
class Melnikov:
    """Melnikov's function M(t0) of a flow, and the areas of lobes to first order in the size of its perturbation.

    Called with t0, a number or an array, it gives M. `zeros` is a structured array of `t0` and `slope`, `lobes` one of
    `begin`, `end` and the signed `area` to first order, each from a zero to the next.
    """

    #: The parameter that is the size of the perturbation, and its value.
    parameter: str
    eps: float
    #: That of M.
    period: float
    #: Saddles of U and of S without the perturbation.
    saddles: tuple[Pair, Pair]
    #: M(t0) = cosines[0] + sum over k >= 1 of cosines[k] cos(2 pi k t0 / period) + sines[k] sin(2 pi k t0 / period).
    cosines: NDArray[np.float64]
    sines: NDArray[np.float64]
    #: The largest |M|, and an estimate of the error of M.
    largest: float
    error: float
    zeros: NDArray[Any]
    lobes: NDArray[Any]
    #: To first order, and by action (by geometry where the map has none).
    first_order: Sides
    exact: Sides

    @classmethod
    def _of(cls, found: dict[str, Any]) -> Melnikov:
        u, s = (tuple(map(float, at)) for at in found["saddles"]["at"])
        parts = {name: found[name] for name in ("parameter", "eps", "period", "cosines", "sines", "largest", "error")}
        return cls(
            saddles=(u, s),  # type: ignore[arg-type]
            zeros=_table(found["zeros"]),
            lobes=_table(found["lobes"]),
            first_order=Sides(**found["first_order"]),
            exact=Sides(**found["exact"]),
            **parts,
        )

    def __call__(self, t0: Any) -> Any:
        angle = 2 * np.pi / self.period * np.multiply.outer(np.asarray(t0, float), np.arange(len(self.cosines)))
        return np.cos(angle) @ self.cosines + np.sin(angle) @ self.sines


def _table(columns: dict[str, Any]) -> NDArray[Any]:
    table = np.empty(len(next(iter(columns.values()))), [(name, np.float64) for name in columns])
    for name, column in columns.items():
        table[name] = column
    return table
