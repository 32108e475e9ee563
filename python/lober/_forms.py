"""The expressions of a flow in symbols of our own, for the printers of C and of NumPy.

Names of the caller's symbols reach neither: a name may be a keyword, a function, or a piece of code.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Sequence

import sympy
from sympy.core.function import AppliedUndef

from ._numbers import number_of
from .errors import UsageError

#: What stands for the coordinates and the time.
COORDINATES = sympy.symbols("x0_ x1_ x2_ x3_", real=True)
T = sympy.Symbol("t_", real=True)


@dataclass(frozen=True)
class Form:
    """A flow whose period is `length`, None for one that does not depend on time. `parameters` are names and defaults,
    `symbols` stand for them in expressions; `jacobian` is row by row."""

    name: str
    velocity: list[Any]
    jacobian: list[Any]
    h: Any
    length: Any
    parameters: dict[str, float]
    symbols: list[Any]

    @property
    def coordinates(self) -> list[Any]:
        return list(COORDINATES[: len(self.velocity)])

    @property
    def pairs(self) -> list[tuple[int, int]]:
        """Positions and their momenta, which come behind all positions; none where there is no Hamiltonian."""
        half = len(self.velocity) // 2
        return [] if self.h is None else [(k, half + k) for k in range(half)]


def expression(given: Any, what: str) -> Any:
    """An expression of SymPy, or a number as one. Texts are refused, since SymPy would evaluate them as Python."""
    try:
        found = sympy.sympify(given, strict=True)
    except sympy.SympifyError:
        found = None
    if not isinstance(found, sympy.Expr):
        raise UsageError(f"{what} has to be an expression of SymPy or a number, not {type(given).__name__}")
    for node in found.atoms(AppliedUndef):
        raise UsageError(f"{what} has the function {str(node.func)!r}, which is not defined; write its formula")
    if found.has(sympy.nan, sympy.oo, -sympy.oo, sympy.zoo):
        raise UsageError(f"{what} is not finite")
    if found.has(sympy.I):
        raise UsageError(f"{what} has the imaginary unit; give a real expression")
    return found


def symbols_of(given: Sequence[Any], what: str) -> list[Any]:
    found = list(given)
    for entry in found:
        if not isinstance(entry, sympy.Symbol):
            raise UsageError(f"{what} have to be symbols of SymPy, not {type(entry).__name__}; make them with sympy.symbols")
    return found


def _with_steps(entry: Any) -> Any:
    """Heaviside's function by cases, which C and NumPy have."""

    def step(at: Any, half: Any = sympy.Rational(1, 2)) -> Any:
        return sympy.Piecewise((0, at < 0), (1, at > 0), (half, True))

    return entry.replace(sympy.Heaviside, step)


def form_of(
    name: str,
    velocity: Sequence[Any] | None,
    h: Any,
    coordinates: Sequence[Any],
    time: Any,
    length: Any,
    params: Mapping[Any, float],
) -> Form:
    """That of right-hand sides, or of a Hamiltonian of positions and then momenta. A flow without `length` does not depend
    on time. Raises UsageError for what is neither expression nor number."""
    given = symbols_of(coordinates, f"system {name}: coordinates")
    given += symbols_of([sympy.Symbol("t") if time is None else time], f"system {name}: times")
    keys = symbols_of(list(params), f"system {name}: the keys of params")
    names = [str(key) for key in keys]
    if len({*given, *keys}) < len(given) + len(keys) or len(set(names)) < len(names):
        raise UsageError(f"system {name}: a symbol has two roles; give coordinates, time and params different names")
    section = "phase" if length is not None else "energy"
    if section in names:
        raise UsageError(f"system {name}: the parameter {section} is that of the section; give yours another name")
    ours = [sympy.Symbol(f"p{k}_", real=True) for k in range(len(keys))]
    ours_of_state = list(COORDINATES[: len(given) - 1])
    roles = dict(zip([*given, *keys], [*ours_of_state, T, *ours]))

    def renamed(entry: Any, what: str) -> Any:
        found = expression(entry, f"system {name}: {what}")
        # Bound symbols, those of sums and integrals, too: they have names as well.
        foreign = sorted(str(symbol) for symbol in found.atoms(sympy.Symbol) - set(roles))
        if foreign:
            raise UsageError(f"system {name}: {foreign[0]} is neither a coordinate nor among params")
        return found.subs(roles, simultaneous=True)

    energy = None if h is None else renamed(h, "the Hamiltonian")
    if velocity is not None:
        speed = [renamed(entry, "a right-hand side") for entry in velocity]
    else:
        half = len(ours_of_state) // 2
        positions, momenta = ours_of_state[:half], ours_of_state[half:]
        speed = [*(sympy.diff(energy, p) for p in momenta), *(-sympy.diff(energy, q) for q in positions)]
    period = None if length is None else renamed(length, "the period")
    if period is not None and period.free_symbols - set(ours):
        raise UsageError(f"system {name}: the period is a number or an expression of params")
    # At the jump of a sign or a step there is no derivative; at all other places this is one.
    slopes = [sympy.diff(entry, coordinate) for entry in speed for coordinate in ours_of_state]
    jacobian = [_with_steps(slope.replace(sympy.DiracDelta, lambda *_: sympy.S.Zero)) for slope in slopes]
    speed = [_with_steps(entry) for entry in speed]
    values = {key: number_of(value, f"system {name}: parameter {key}") for key, value in zip(names, params.values())}
    return Form(name, speed, jacobian, None if h is None else _with_steps(energy), period, values, ours)
