"""Expressions as C and as NumPy, where every number is a double with all its digits.

Printed as they are, whole numbers would be integers of C, which wrap at 2^64, and objects in arrays of NumPy; fractions
would be long doubles.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, Callable

import numpy as np
import sympy
from sympy.printing.c import C99CodePrinter
from sympy.printing.numpy import NumPyPrinter

from .errors import UsageError


def literal(number: Any) -> str:
    """A number as both languages write a double: the nearest one, by digits that read back to it."""
    try:
        value = float(Fraction(int(number.p), int(number.q)) if isinstance(number, sympy.Rational) else number.evalf(40))
    except OverflowError:
        value = math.inf
    if not math.isfinite(value):
        text = str(number)
        raise UsageError(f"the number {text if len(text) < 40 else text[:30] + '...'} is too large for a double; scale the units")
    return repr(value)


class _Doubles:
    """For both printers, ahead of what they say themselves."""

    def _print_Rational(self, expr: Any) -> str:
        return literal(expr)

    _print_Integer = _print_Zero = _print_One = _print_NegativeOne = _print_Half = _print_Rational
    _print_Float = _print_NumberSymbol = _print_Pi = _print_Exp1 = _print_EulerGamma = _print_Rational
    _print_GoldenRatio = _print_Catalan = _print_TribonacciConstant = _print_Rational

    def _print_Function(self, expr: Any) -> str:
        """In parentheses where SymPy writes another formula for it: it takes that for one term, so that y/sec(x) would
        be y/1/cos(x), and cot(x)**2 tan(x)**-1**2."""
        text: str = super()._print_Function(expr)  # type: ignore[misc]
        return f"({text})" if type(expr).__name__ in self._rewriteable_functions else text  # type: ignore[attr-defined]


class DoublesInC(_Doubles, C99CodePrinter):  # type: ignore[misc]
    def __init__(self) -> None:
        super().__init__({"human": False, "math_macros": {}})

    def _print_Pow(self, expr: Any, rational: bool = False) -> str:
        if expr.exp == sympy.Rational(1, 3):
            # Not cbrt, which takes negative numbers: NumPy does not, nor is it the root that SymPy means.
            return f"pow({self._print(expr.base)}, {literal(expr.exp)})"
        half = sympy.Rational(1, 2)
        if isinstance(expr.exp, sympy.Rational) and expr.exp.q <= 2 and abs(expr.exp.p) <= 8 and expr.exp not in (1, -1, half):
            # Products and roots, which processors compute several at a time; pow takes twenty times as long.
            base = f"({self._print(expr.base)})"
            factors = [base] * (abs(expr.exp.p) // expr.exp.q) + [f"sqrt({base})"] * (expr.exp.q - 1)
            power = "*".join(factors)
            return f"(1.0/({power}))" if expr.exp.p < 0 else f"({power})"
        text: str = super()._print_Pow(expr)
        return text

    def _print_Mod(self, expr: Any) -> str:
        """With the sign of the divisor, as SymPy and NumPy have it; fmod has the other one."""
        value, divisor = (f"({self._print(part)})" for part in expr.args)
        return f"({value} - {divisor}*floor({value}/{divisor}))"


class DoublesInNumPy(_Doubles, NumPyPrinter):  # type: ignore[misc]
    def __init__(self, human: bool = True) -> None:
        settings = {"fully_qualified_modules": False, "inline": True, "allow_unknown_functions": False}
        super().__init__({**settings, "human": human})

    def _print_Max(self, expr: Any) -> str:
        return self._by_pairs("maximum", expr)

    def _print_Min(self, expr: Any) -> str:
        return self._by_pairs("minimum", expr)

    def _by_pairs(self, function: str, expr: Any) -> str:
        """amax would need arrays of one shape, and constants have none."""
        text = self._print(expr.args[0])
        for part in expr.args[1:]:
            text = f"{function}({text}, {self._print(part)})"
        return str(text)


def _each(function: Callable[[float], float]) -> Any:
    """A function of Python's math for arrays: NaN where it has no value, as in C."""

    def value(number: float) -> float:
        try:
            return function(number)
        except (ValueError, OverflowError):
            return math.nan

    return np.vectorize(value, otypes=[float])


#: What NumPy does not have.
_OF_MATH = {
    "erf": _each(math.erf),
    "erfc": _each(math.erfc),
    "gamma": _each(math.gamma),
    "lgamma": _each(math.lgamma),
}


def in_c(entry: Any) -> str:
    """An expression of C. Raises UsageError for a function that C does not have."""
    _, missing, text = DoublesInC().doprint(entry)
    if missing:
        raise UsageError(f'{_names(missing)} cannot be written in C; give compiler="", and the flow is a function of NumPy')
    return str(text).replace("\n", " ")


def in_numpy(symbols: list[Any], entries: Any) -> Any:
    """A function of arrays, or of numbers, that gives what the expressions are there. Raises as `in_c`."""
    for entry in entries if isinstance(entries, list) else [entries]:
        _, missing, _ = DoublesInNumPy(human=False).doprint(entry)
        if missing:
            raise UsageError(f"{_names(missing)} cannot be written in NumPy; write a formula of functions that it has")
    return sympy.lambdify(symbols, entries, [_OF_MATH, "numpy"], printer=DoublesInNumPy(), cse=True)


def _names(missing: Any) -> str:
    return ", ".join(sorted(type(one).__name__ for one in missing))
