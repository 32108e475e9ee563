"""C that implements engine/lober/lober_system.h, whose structures are repeated here."""

from __future__ import annotations

import math
from typing import Any

import sympy

from ._forms import Form
from ._printers import in_c
from ._section import Section
from .errors import UsageError


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


def _section(section: Section | None, energy: int) -> str:
    if section is None:
        return "#define section 0\n"
    bounded, bound, side = section.bound
    return (
        "static const lober_section section_ = {"
        f"{section.coordinate}, {double(section.value, 'section')}, {section.direction}, "
        f"{section.chart[0]}, {section.chart[1]}, {section.solved}, {energy if section.solved >= 0 else -1}, "
        f"{bounded}, {double(bound, 'bound')}, {side}, {double(section.angle, 'angle')}}};\n#define section &section_\n"
    )


def source_of(
    form: Form,
    window: tuple[float, ...],
    lattice: tuple[float, ...],
    section: Section | None = None,
    energy: float = 0.0,
) -> str:
    """The library of a flow: of its period, with a parameter `phase`, or with a section and, where there is a Hamiltonian, a
    parameter `energy`, whose default is given."""
    n = len(form.velocity)
    unpacked = "".join(f"  const double p{k}_ = p[{k}]; (void)p{k}_;\n" for k in range(len(form.symbols)))
    read = "".join(f"  const double x{k}_ = x[{k}]; (void)x{k}_;\n" for k in range(n))
    state = read + "  const double t_ = t; (void)t_;\n" + unpacked
    read_one = "".join(f"  const double x{k}_ = x[{k} * n + k_]; (void)x{k}_;\n" for k in range(n))
    rates = [f"d[{k}]" for k in range(n)]
    rates_of_one = [f"d[{k} * n + k_]" for k in range(n)]
    slopes = [f"d[{k}]" for k in range(n * n)]
    box = ", ".join(double(float(entry), "window") for entry in window)
    shift = ", ".join(double(float(entry), "lattice") for entry in lattice)
    rows = [f'{{{quoted(key)}, {double(value, f"parameter {key}")}, ""}}' for key, value in form.parameters.items()]
    if form.length is not None:
        rows.append('{"phase", 0, "of the section, as a fraction of the period"}')
    elif form.h is not None:
        rows.append(f'{{"energy", {double(energy, "energy")}, "value of the Hamiltonian"}}')
    has_h = form.h is not None
    pairs = ", ".join(f"{{{q}, {p}, 0}}" for q, p in form.pairs)
    hamiltonian = (
        f"""
static double hamiltonian(const double *p, const double *x, double t) {{
{state}  double h;
  {statements([form.h], ["h"])}
  return h;
}}
static const lober_pair pairs[] = {{{pairs}}};
"""
        if has_h
        else "\nstatic const lober_pair pairs[1];\n#define hamiltonian 0\n"
    )
    period = (
        f"""
static double period(const double *p) {{
{unpacked}  (void)p;
  double length;
  {statements([form.length], ["length"])}
  return length;
}}
"""
        if form.length is not None
        else "\n#define period 0\n"
    )
    listed = ",\n  ".join(rows) if rows else '{0, 0, 0}'
    perturbation = '"eps"' if "eps" in form.parameters else "0"
    return f"""#include <math.h>
#include <stddef.h>

typedef struct {{ const char *name; double value; const char *meaning; }} lober_parameter;
typedef struct {{ int q, p; double (*factor)(const double *); }} lober_pair;
typedef struct {{
  int coordinate;
  double value;
  int direction, chart_x, chart_y, solved, energy_parameter, bound_coordinate;
  double bound;
  int bound_side;
  double period;
}} lober_section;
typedef struct {{
  int dimension;
  int (*velocity)(const double *, const double *, double, double *);
  int (*jacobian)(const double *, const double *, double, double *);
  double (*period)(const double *);
  double (*hamiltonian)(const double *, const double *, double);
  size_t pair_count;
  const lober_pair *pairs;
  const lober_section *section_of_map;
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
  const void *ranges;
  const char *perturbation;
  double second_lattice[2];
}} lober_system;

static int velocity(const double *p, const double *x, double t, double *d) {{
{state}  {statements(form.velocity, rates)}
  return 0;
}}

static int jacobian(const double *p, const double *x, double t, double *d) {{
{state}  {statements(form.jacobian, slopes)}
  return 0;
}}

static void velocity_batch(const double *p, size_t n, const double *restrict x, const double *restrict t,
                           double *restrict d) {{
{unpacked}  for (size_t k_ = 0; k_ < n; ++k_) {{
{read_one}  const double t_ = t[k_]; (void)t_;
  {statements(form.velocity, rates_of_one)}
  }}
}}
{period}{hamiltonian}
{_section(section, len(form.symbols))}
static const lober_parameter parameters[] = {{
  {listed}
}};
static const lober_flow flow = {{{n}, velocity, jacobian, period, hamiltonian, {len(form.pairs)}, pairs, section,
                                velocity_batch}};
static const lober_system description = {{
  4, 2, {quoted(form.name)}, "of expressions", {len(rows)}, parameters, {{{box}}},
  {{{shift}}}, 0, &flow, 0, 0, 0, 0, {perturbation}, {{0, 0}}}};

__attribute__((visibility("default"))) const lober_system *lober_system_describe(void) {{ return &description; }}

/* For the comparison with the form in NumPy. */
__attribute__((visibility("default"))) void lober_values(const double *p, const double *x, double t, double *to) {{
  (void)velocity(p, x, t, to);
  (void)jacobian(p, x, t, to + {n});
  to[{n + n * n}] = {"period(p)" if form.length is not None else "0"};
  to[{n + n * n + 1}] = {"hamiltonian(p, x, t)" if has_h else "0"};
}}
"""
