"""Systems from expressions of SymPy: derivatives and C code are generated, and compiled where there is a compiler."""

from __future__ import annotations

import atexit
import hashlib
import os
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Any, Mapping, Sequence


from . import _lober
from ._own import Family, flow
from ._systems import Connection, Pair, System
from .errors import UsageError

Box = tuple[float, float, float, float]

_libraries: dict[str, str] = {}
_folder: str | None = None


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
    parameters, and so are the coordinates in `connection`. C is generated and compiled by `compiler` (default: $CC or cc);
    where there is none the flow is a vectorised function of NumPy. The rest as `flow`.
    """
    import sympy

    h = sympy.sympify(h)
    return _family([sympy.diff(h, p), -sympy.diff(h, q)], (q, p), t, h, period, params, phase, window, lattice,
                   connection, name, compiler)


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
    import sympy

    expressions = [sympy.sympify(entry) for entry in velocity]
    if len(expressions) != 2 or len(coordinates) != 2:
        raise UsageError("a flow with a planar map has two coordinates and two right-hand sides")
    return _family(expressions, (coordinates[0], coordinates[1]), t, None, period, params, phase, window, lattice, connection, name,
                   compiler)


def _family(
    velocity: list[Any],
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
    import sympy

    time = sympy.Symbol("t") if t is None else t
    parameters = {symbol: float(value) for symbol, value in (params or {}).items()}
    known = {*coordinates, time, *parameters}
    for expression in [*velocity, *([] if h is None else [h])]:
        foreign = sorted(str(symbol) for symbol in expression.free_symbols - known)
        if foreign:
            raise UsageError(f"system {name}: {foreign[0]} is neither a coordinate nor among params")
    length = sympy.sympify(period)
    if length.free_symbols - set(parameters):
        raise UsageError(f"system {name}: the period is a number or an expression of params")
    with_compiler = compiler if compiler is not None else os.environ.get("CC", "cc")
    if not with_compiler or shutil.which(with_compiler.split()[0]) is None:
        return _vectorised(velocity, coordinates, time, h, length, parameters, phase, window, lattice, connection, name)
    source = _source(velocity, coordinates, time, h, length, parameters, window, lattice, name)
    defaults = {str(symbol): value for symbol, value in parameters.items()}

    def make(values: Mapping[str, float], tolerance: float) -> System:
        pairs = [*values.items(), ("phase", float(phase))]
        made = System(_lober.system(_compiled(source, with_compiler), pairs, tolerance), ())
        between = _numeric(connection, parameters, values)
        if between is not None:
            made._of.connect(between._parts())
        return made

    return Family(name, defaults, make)


def _numeric(connection: Any, parameters: Mapping[Any, float], values: Mapping[str, float]) -> Connection | None:
    """A connection whose coordinates may be expressions of parameters."""
    import sympy

    if connection is None:
        return None
    chosen = {symbol: values[str(symbol)] for symbol in parameters}

    def pair(point: Any) -> Pair:
        x, y = (float(sympy.sympify(entry).subs(chosen)) for entry in point)
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


def _vectorised(
    velocity: list[Any],
    coordinates: tuple[Any, Any],
    time: Any,
    h: Any,
    length: Any,
    parameters: Mapping[Any, float],
    phase: float,
    window: Box,
    lattice: Pair,
    connection: Any,
    name: str,
) -> Family:
    import sympy

    symbols = [*coordinates, time, *parameters]
    field = sympy.lambdify(symbols, velocity, "numpy", cse=True)
    energy = sympy.lambdify(symbols, 0 if h is None else h, "numpy", cse=True)
    periods = sympy.lambdify(list(parameters), length, "numpy")
    names = {str(symbol): value for symbol, value in parameters.items()}

    def make(values: Mapping[str, float], tolerance: float) -> System:
        numbers = list(values.values())

        def at(x: Any, y: Any, t: Any) -> Any:
            return field(x, y, t, *numbers)

        def h_at(x: Any, y: Any, t: Any) -> Any:
            return energy(x, y, t, *numbers)

        own = flow(
            at,
            period=float(periods(*numbers)),
            hamiltonian=h_at if h is not None else None,
            phase=phase,
            window=window,
            lattice=lattice,
            connection=_numeric(connection, parameters, values),
            name=name,
        )
        made: System = own(integration_tolerance=tolerance)
        return made

    return Family(name, names, make)


def _compiled(source: str, compiler: str) -> str:
    """The path of a shared library; kept until the process ends."""
    global _folder
    key = hashlib.sha256((compiler + "\n" + source).encode()).hexdigest()
    if key in _libraries:
        return _libraries[key]
    if _folder is None:
        _folder = tempfile.mkdtemp(prefix="lober-")
        atexit.register(shutil.rmtree, _folder, True)
    code, library = Path(_folder) / f"{key}.c", Path(_folder) / f"{key}.so"
    code.write_text(source)
    command = [*compiler.split(), "-shared", "-fPIC", "-O2", "-ffp-contract=off", str(code), "-o", str(library), "-lm"]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode != 0:
        raise UsageError(f"{' '.join(command)} fails: {run.stderr.strip()}")
    _libraries[key] = str(library)
    return _libraries[key]


def _source(
    velocity: list[Any],
    coordinates: tuple[Any, Any],
    time: Any,
    h: Any,
    length: Any,
    parameters: Mapping[Any, float],
    window: Box,
    lattice: Pair,
    name: str,
) -> str:
    """C that implements engine/lober/lober_system.h, whose structures are repeated here."""
    import sympy

    # Names that cannot clash with those of C.
    arguments = {coordinates[0]: sympy.Symbol("x0_"), coordinates[1]: sympy.Symbol("x1_"), time: sympy.Symbol("t_")}
    arguments.update({symbol: sympy.Symbol(f"p{k}_") for k, symbol in enumerate(parameters)})

    def statements(expressions: list[Any], targets: list[str]) -> str:
        renamed = [sympy.sympify(entry).subs(arguments, simultaneous=True) for entry in expressions]
        common, reduced = sympy.cse(renamed, symbols=sympy.numbered_symbols("c_"))
        lines = [f"const double {symbol} = {sympy.ccode(value)};" for symbol, value in common]
        lines += [f"{target} = {sympy.ccode(value)};" for target, value in zip(targets, reduced)]
        return "\n  ".join(lines)

    jacobian = [sympy.diff(entry, coordinate) for entry in velocity for coordinate in coordinates]
    unpacked = "".join(f"  const double p{k}_ = p[{k}]; (void)p{k}_;\n" for k in range(len(parameters)))
    state = "  const double x0_ = x[0], x1_ = x[1], t_ = t; (void)x0_; (void)x1_; (void)t_;\n" + unpacked
    numbers = ", ".join(repr(float(entry)) for entry in (*window, *lattice)).split(", ")
    rows = "".join(f'  {{"{symbol}", {value!r}, ""}},\n' for symbol, value in parameters.items())
    rows += '  {"phase", 0, "of the section, as a fraction of the period"}'
    energy = (
        f"""
static double hamiltonian(const double *p, const double *x, double t) {{
{state}  double h;
  {statements([h], ["h"])}
  return h;
}}
static const lober_pair pairs[] = {{{{0, 1, 0}}}};
"""
        if h is not None
        else "\nstatic const lober_pair pairs[1];\n#define hamiltonian 0\n"
    )
    return f"""#include <math.h>
#include <stddef.h>

typedef struct {{ const char *name; double value; const char *meaning; }} lober_parameter;
typedef struct {{ int q, p; double (*factor)(const double *); }} lober_pair;
typedef struct {{
  int dimension;
  int (*velocity)(const double *, const double *, double, double *);
  int (*jacobian)(const double *, const double *, double, double *);
  double (*period)(const double *);
  double (*hamiltonian)(const double *, const double *, double);
  size_t pair_count;
  const lober_pair *pairs;
  const void *section;
  void (*velocity_batch)(const double *, size_t, const double *, const double *, double *);
}} lober_flow;
typedef struct {{
  unsigned abi;
  int kind;
  const char *name, *summary;
  size_t parameter_count;
  const lober_parameter *parameters;
  double window[4], lattice[2];
  const void *map;
  const lober_flow *flow;
  size_t connection_count;
  int (*connection)(const double *, size_t, void *);
  int all_bound_region_1;
}} lober_system;

static int velocity(const double *p, const double *x, double t, double *d) {{
{state}  {statements(velocity, ["d[0]", "d[1]"])}
  return 0;
}}

static int jacobian(const double *p, const double *x, double t, double *d) {{
{state}  {statements(jacobian, ["d[0]", "d[1]", "d[2]", "d[3]"])}
  return 0;
}}

static void velocity_batch(const double *p, size_t n, const double *restrict x, const double *restrict t,
                           double *restrict d) {{
{unpacked}  for (size_t k = 0; k < n; ++k) {{
  const double x0_ = x[k], x1_ = x[n + k], t_ = t[k]; (void)x0_; (void)x1_; (void)t_;
  {statements(velocity, ["d[k]", "d[n + k]"])}
  }}
}}

static double period(const double *p) {{
{unpacked}  (void)p;
  double length;
  {statements([length], ["length"])}
  return length;
}}
{energy}
static const lober_parameter parameters[] = {{
{rows}
}};
static const lober_flow flow = {{2, velocity, jacobian, period, hamiltonian, {int(h is not None)}, pairs, 0, velocity_batch}};
static const lober_system description = {{
  3, 2, "{name}", "of expressions", {len(parameters) + 1}, parameters, {{{", ".join(numbers[:4])}}},
  {{{", ".join(numbers[4:])}}}, 0, &flow, 0, 0, 0}};

__attribute__((visibility("default"))) const lober_system *lober_system_describe(void) {{ return &description; }}
"""
