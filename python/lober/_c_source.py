"""C that implements engine/lober/lober_system.h, whose structures are repeated here."""

from __future__ import annotations

import math
from typing import Any

import sympy

from ._forms import Form
from ._printers import in_c
from .errors import UsageError

#: What `lober_values` writes: velocity, Jacobian, period, Hamiltonian.
VALUES = 8


def quoted(text: str) -> str:
    """A literal of C with the bytes of a text in UTF-8."""
    try:
        data = text.encode()
    except UnicodeEncodeError:
        raise UsageError(f"the name {text!r} is not a text; use characters of Unicode") from None
    if b"\0" in data:
        raise UsageError(f"the name {text!r} has a zero byte; leave it out")
    plain = b" !#$%&'()*+,-./:;<=>@[]^_`{|}~"
    # Three octal digits end by themselves, unlike \x; a question mark may begin a trigraph.
    return '"' + "".join(chr(c) if chr(c).isalnum() and c < 128 or c in plain else f"\\{c:03o}" for c in data) + '"'


def double(value: float, what: str) -> str:
    if not math.isfinite(value):
        raise UsageError(f"{what} is not finite; give numbers")
    return repr(value)


def statements(expressions: list[Any], targets: list[str]) -> str:
    common, reduced = sympy.cse(expressions, symbols=sympy.numbered_symbols("c_"))
    lines = [f"const double {symbol} = {in_c(value)};" for symbol, value in common]
    lines += [f"{target} = {in_c(value)};" for target, value in zip(targets, reduced)]
    return "\n  ".join(lines)


def source_of(form: Form, window: tuple[float, ...], lattice: tuple[float, ...]) -> str:
    unpacked = "".join(f"  const double p{k}_ = p[{k}]; (void)p{k}_;\n" for k in range(len(form.symbols)))
    state = "  const double x0_ = x[0], x1_ = x[1], t_ = t; (void)x0_; (void)x1_; (void)t_;\n" + unpacked
    box = ", ".join(double(float(entry), "window") for entry in window)
    shift = ", ".join(double(float(entry), "lattice") for entry in lattice)
    rows = "".join(
        f'  {{{quoted(key)}, {double(value, f"parameter {key}")}, ""}},\n' for key, value in form.parameters.items()
    )
    rows += '  {"phase", 0, "of the section, as a fraction of the period"}'
    has_h = form.h is not None
    energy = (
        f"""
static double hamiltonian(const double *p, const double *x, double t) {{
{state}  double h;
  {statements([form.h], ["h"])}
  return h;
}}
static const lober_pair pairs[] = {{{{0, 1, 0}}}};
"""
        if has_h
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
{state}  {statements(form.velocity, ["d[0]", "d[1]"])}
  return 0;
}}

static int jacobian(const double *p, const double *x, double t, double *d) {{
{state}  {statements(form.jacobian, ["d[0]", "d[1]", "d[2]", "d[3]"])}
  return 0;
}}

static void velocity_batch(const double *p, size_t n, const double *restrict x, const double *restrict t,
                           double *restrict d) {{
{unpacked}  for (size_t k = 0; k < n; ++k) {{
  const double x0_ = x[k], x1_ = x[n + k], t_ = t[k]; (void)x0_; (void)x1_; (void)t_;
  {statements(form.velocity, ["d[k]", "d[n + k]"])}
  }}
}}

static double period(const double *p) {{
{unpacked}  (void)p;
  double length;
  {statements([form.length], ["length"])}
  return length;
}}
{energy}
static const lober_parameter parameters[] = {{
{rows}
}};
static const lober_flow flow = {{2, velocity, jacobian, period, hamiltonian, {int(has_h)}, pairs, 0, velocity_batch}};
static const lober_system description = {{
  3, 2, {quoted(form.name)}, "of expressions", {len(form.symbols) + 1}, parameters, {{{box}}},
  {{{shift}}}, 0, &flow, 0, 0, 0}};

__attribute__((visibility("default"))) const lober_system *lober_system_describe(void) {{ return &description; }}

/* For the comparison with the form in NumPy. */
__attribute__((visibility("default"))) void lober_values(const double *p, const double *x, double t, double *to) {{
  (void)velocity(p, x, t, to);
  (void)jacobian(p, x, t, to + 2);
  to[6] = period(p);
  to[7] = {"hamiltonian(p, x, t)" if has_h else "0"};
}}
"""
