"""Systems from expressions of SymPy: derivatives and C code are generated, and compiled where there is a compiler."""

from __future__ import annotations

import os
import shutil
from typing import Any, Mapping, Sequence

import numpy as np

from . import _lober
from ._numbers import number_of, numbers_of
from ._own import Family, flow_system, period_flow
from ._systems import Connection, Pair, System, pair_of
from .errors import UsageError

Box = tuple[float, float, float, float]


def hamiltonian(
    h: Any,
    q: Any,
    p: Any,
    t: Any = None,
    *,
    period: Any,
    params: Mapping[Any, float] | None = None,
    phase: float = 0.0,
    window: Box = (-2.0, -2.0, 2.0, 2.0),
    lattice: Pair = (0.0, 0.0),
    connection: Any = None,
    name: str = "hamiltonian",
    compiler: str | None = None,
) -> Family:
    """The flow dq/dt = dH/dp, dp/dt = -dH/dq of a Hamiltonian that is periodic in time, an expression of SymPy.

    `q`, `p`, `t` and the keys of `params` are symbols, `params` has the defaults. `period` is a number or an expression of
    parameters, and so are the coordinates in `connection`. C is generated and compiled by `compiler` (default: $CC or cc),
    and compared with NumPy before it is used; where there is none the flow is a vectorised function of NumPy. The rest as
    `flow`. Raises UsageError for texts, which SymPy would evaluate as Python, and DisagreementError where C and NumPy differ.
    """
    made = _family(None, (q, p), t, h, period, params, phase, window, lattice, connection, name, compiler)
    options = dict(q=q, p=p, t=t, period=period, params=params, phase=phase, window=window, lattice=lattice)
    return made.made_by(hamiltonian, h, {**options, "connection": connection, "name": name, "compiler": compiler})


def equations(
    velocity: Sequence[Any],
    coordinates: Sequence[Any],
    t: Any = None,
    *,
    period: Any,
    params: Mapping[Any, float] | None = None,
    phase: float = 0.0,
    window: Box = (-2.0, -2.0, 2.0, 2.0),
    lattice: Pair = (0.0, 0.0),
    connection: Any = None,
    name: str = "equations",
    compiler: str | None = None,
) -> Family:
    """The flow of two right-hand sides, expressions of SymPy. As `hamiltonian` otherwise; there are no areas by action."""
    if isinstance(velocity, str) or isinstance(coordinates, str) or len(velocity) != 2 or len(coordinates) != 2:
        raise UsageError("a flow with a planar map has two coordinates and two right-hand sides")
    pair = (coordinates[0], coordinates[1])
    made = _family(velocity, pair, t, None, period, params, phase, window, lattice, connection, name, compiler)
    options = dict(coordinates=pair, t=t, period=period, params=params, phase=phase, window=window, lattice=lattice)
    return made.made_by(equations, velocity, {**options, "connection": connection, "name": name, "compiler": compiler})


def _family(
    velocity: Sequence[Any] | None,
    coordinates: tuple[Any, Any],
    t: Any,
    h: Any,
    period: Any,
    params: Mapping[Any, float] | None,
    phase: float,
    window: Box,
    lattice: Pair,
    connection: Any,
    name: str,
    compiler: str | None,
) -> Family:
    # These import SymPy, which the rest of the package does without.
    from ._c_source import source_of
    from ._compiled import compiled, require_same
    from ._forms import form_of
    from ._numpy_form import NumPyForm

    parameters = dict(params or {})
    form = form_of(name, velocity, h, coordinates, t, period, parameters)
    x0, y0, x1, y1 = numbers_of(window, f"system {name}: window", 4)
    box, shift = (x0, y0, x1, y1), pair_of(lattice, f"system {name}: lattice")
    begin = number_of(phase, f"system {name}: phase")
    in_numpy = NumPyForm(form)
    with_compiler = compiler if compiler is not None else os.environ.get("CC", "cc")
    if not with_compiler or shutil.which(with_compiler.split()[0]) is None:

        def vectorised(values: Mapping[str, float], tolerance: float) -> System:
            numbers: list[Any] = [np.float64(value) for value in values.values()]
            field = period_flow(
                name,
                lambda x, y, t: in_numpy.velocity(x, y, t, *numbers),
                None if form.h is None else lambda x, y, t: in_numpy.hamiltonian(x, y, t, *numbers),
                in_numpy.period(numbers),
                box,
            )
            between = _numeric(connection, parameters, values)
            return flow_system(name, None, values, field, box, shift, begin, tolerance, between)

        return Family(name, form.parameters, vectorised)

    source = source_of(form, box, shift)

    def make(values: Mapping[str, float], tolerance: float) -> System:
        library = compiled(source, with_compiler)
        require_same(library, form, in_numpy, list(values.values()), np.array([box[::2], box[1::2]]))
        pairs = [*values.items(), ("phase", begin)]
        made = System(_lober.system(library, pairs, tolerance), ())
        between = _numeric(connection, parameters, values)
        if between is not None:
            made._of.connect(between._parts())
        return made

    return Family(name, form.parameters, make)


def _numeric(connection: Any, parameters: Mapping[Any, float], values: Mapping[str, float]) -> Connection | None:
    """A connection whose coordinates may be expressions of parameters."""
    from ._forms import expression

    if connection is None:
        return None
    chosen = {symbol: values[str(symbol)] for symbol in parameters}

    def number(entry: Any) -> float:
        found = expression(entry, "a coordinate of connection")
        return number_of(found.subs(chosen), "a coordinate of connection")

    def pair(point: Any) -> Pair:
        x, y = (number(entry) for entry in point)
        return x, y

    bip = None if connection.bip is None else pair(connection.bip)
    return Connection(
        pair(connection.from_saddle),
        pair(connection.u_direction),
        pair(connection.to_saddle),
        pair(connection.s_direction),
        bip,
        tuple(pair(corner) for corner in connection.closure),
    )
