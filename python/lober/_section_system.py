"""Return maps of flows of one's own: `section_system`."""

from __future__ import annotations

import os
import shutil
from typing import Any, Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from . import _lober
from ._numbers import number_of, numbers_of
from ._own import Family, _value, extent_of, summary_of
from ._own_field import bound as bound_to
from ._own_field import field_of, names_of_coordinates
from ._section import Section, section_of
from ._systems import Connection, Pair, System, pair_of
from .errors import UsageError

Box = tuple[float, float, float, float]


def section_system(
    given: Any = None,
    /,
    *,
    section: str,
    direction: int = 1,
    bound: str | None = None,
    energy: float | None = None,
    coordinates: Sequence[Any] | None = None,
    hamiltonian: Any = None,
    jacobian: Any = None,
    params: Mapping[Any, float] | None = None,
    saddles: Any = (),
    angle: float = 0.0,
    window: Box = (-2.0, -2.0, 2.0, 2.0),
    lattice: Pair = (0.0, 0.0),
    connection: Any = None,
    name: str | None = None,
    compiler: str | None = None,
) -> Any:
    """Makes a system of an autonomous flow whose map is the first return to a section; also a decorator.

    The flow has four coordinates, two positions and then their momenta, and a Hamiltonian H: dq/dt = dH/dp, dp/dt = -dH/dq;
    or three coordinates. `given` is one of these:

    - an expression of SymPy, the Hamiltonian, or a list of three, the right-hand sides; `coordinates` are its symbols. C is
      generated and compiled by `compiler` (default: $CC or cc) and compared with NumPy; without one NumPy is used;
    - a vectorised function f(x, y, px, py, ...parameters) of arrays that gives as many arrays, with the function
      `hamiltonian` of the same arguments; the names of its arguments are those of the coordinates. `jacobian`, if it is
      given, returns the 16 derivatives row by row; otherwise differences are taken;
    - a compiled function with an address, a `numba.cfunc` of the form of lober_system.h, and such a `hamiltonian` and
      `jacobian`; coordinates are x, y, px and py unless `coordinates` names them.

    `section` is a text like "y=0", `direction` the sign of the rate of that coordinate at crossings that count, `bound`
    a text like "x<-1" for the part of the section that counts. The map's coordinates are the two that are left, in their
    order; the momentum of the section's coordinate follows from the energy, whose default is `energy`: the system has a
    parameter energy beside those of `params`. H must be a quadratic function of that momentum. `angle` is the period of the
    section's coordinate where that is an angle. `saddles` are positions, or states of four numbers, near the saddles that
    bound a well, for `escape` and `levels`: a list, or a function of parameters that gives one. `window` is the box of the
    map in which points of interest are; the rest as `flow`. Raises UsageError, and DataError where H and the velocity do not
    belong together.

        x, y, px, py, mu = sympy.symbols("x y px py mu")
        h = ...
        jupiter = lober.section_system(h, coordinates=[x, y, px, py], section="y=0", bound="x<-1", energy=-1.525,
                                       params={mu: 9.537e-4}, window=(-3, -0.5, -1.05, 0.5))
    """
    options: dict[str, Any] = dict(
        section=section,
        direction=direction,
        bound=bound,
        energy=energy,
        coordinates=None if coordinates is None else list(coordinates),
        hamiltonian=hamiltonian,
        jacobian=jacobian,
        params=dict(params or {}),
        saddles=saddles,
        angle=angle,
        window=tuple(window),
        lattice=lattice,
        connection=connection,
        name=name,
        compiler=compiler,
    )
    if given is None:
        return lambda function: _family(function, options)
    return _family(given, options)


def _family(given: Any, options: dict[str, Any]) -> Family:
    made = _of_function(given, options) if callable(given) or hasattr(given, "address") else _of_expressions(given, options)
    made.made_by(section_system, given, options)
    return made


def _energy(title: str, hamiltonian: bool, energy: Any) -> float | None:
    if not hamiltonian:
        if energy is not None:
            raise UsageError(f"system {title}: energy is that of a Hamiltonian; give hamiltonian, or leave energy out")
        return None
    if energy is None:
        raise UsageError(f"system {title}: energy is missing; give that of the surface on which the section lies")
    return number_of(energy, f"system {title}: energy")


def _made(
    field: Any,
    title: str,
    summary: str,
    values: Mapping[str, float],
    box: Box,
    shift: Pair,
    where: Section,
    tolerance: float,
) -> _lober.System:
    """The system of a field for these parameters, which say its energy too."""
    return _lober.field_system(
        field,
        name=title,
        summary=summary,
        values=list(values.items()),
        window=box,
        lattice=shift,
        section=where.as_dict(),
        energy=values.get("energy", 0.0),
        tolerance=tolerance,
    )


def _complete(made: _lober.System, saddles: Sequence[Any], connection: Connection | None, name: str, names: Sequence[str]) -> System:
    """Adds what is known of a system for its parameters."""
    states = []
    for saddle in saddles:
        numbers = [number_of(entry, f"system {name}: a saddle") for entry in saddle]
        if len(numbers) == 2 and made.dimension == 4:
            states.append(list(_lober.at_rest(made, (numbers[0], numbers[1]))))
        elif len(numbers) == made.dimension:
            states.append(numbers)
        else:
            raise UsageError(f"system {name}: a saddle is a position of 2 numbers or a state of {made.dimension}, not {saddle!r}")
    _lober.set_saddles(made, states, list(names))
    if connection is not None:
        made.connect(connection._parts())
    return System(made, ())


def _of_function(function: Any, options: dict[str, Any]) -> Family:
    title = options["name"] or getattr(function, "__name__", "section")
    params = {str(key): value for key, value in options["params"].items()}
    names = names_of_coordinates(function, {**params, "energy": 0.0}, options["coordinates"])
    h = options["hamiltonian"]
    where = section_of(title, names, h is not None, options["section"], options["direction"], options["bound"], options["angle"])
    energy = _energy(title, h is not None, options["energy"])
    n = len(names)
    velocities, hamiltonians, jacobians = (
        bound_to(one, {**params, "energy": 0.0}, n, title) for one in (function, h, options["jacobian"])
    )
    box, shift = _box(title, options["window"]), pair_of(options["lattice"], f"system {title}: lattice")
    parameters = {**params, **({} if energy is None else {"energy": energy})}

    def make(values: Mapping[str, float], tolerance: float) -> System:
        field = field_of(
            title, n, velocities(values), hamiltonians(values), 0.0, extent_of(title, box), jacobians(values)
        )
        made = _made(field, title, summary_of(function), values, box, shift, where, tolerance)
        saddles = _value(options["saddles"], values)
        return _complete(made, saddles, _value(options["connection"], values), title, names)

    return Family(title, parameters, make)


def _of_expressions(given: Any, options: dict[str, Any]) -> Family:
    # These import SymPy, which the rest of the package does without.
    from ._c_source import source_of
    from ._compiled import compiled, require_same
    from ._forms import form_of, symbols_of
    from ._numpy_form import NumPyForm

    title = options["name"] or "section"
    if options["hamiltonian"] is not None or options["jacobian"] is not None:
        raise UsageError(f"system {title}: of expressions the Hamiltonian comes first, and derivatives are found by themselves")
    if options["coordinates"] is None:
        raise UsageError(f"system {title}: coordinates are missing; give the symbols of the expressions")
    symbols = symbols_of(options["coordinates"], f"system {title}: coordinates")
    sides = isinstance(given, (list, tuple))
    names = [str(symbol) for symbol in symbols]
    where = section_of(title, names, not sides, options["section"], options["direction"], options["bound"], options["angle"])
    energy = _energy(title, not sides, options["energy"])
    if sides and len(given) != len(symbols):
        raise UsageError(f"system {title}: {len(given)} right-hand sides for {len(symbols)} coordinates")
    form = form_of(title, given if sides else None, None if sides else given, symbols, None, None, options["params"])
    box, shift = _box(title, options["window"]), pair_of(options["lattice"], f"system {title}: lattice")
    in_numpy = NumPyForm(form)
    parameters = {**form.parameters, **({} if energy is None else {"energy": energy})}
    known = options["params"]

    def complete(made: _lober.System, values: Mapping[str, float]) -> System:
        from ._symbolic import _numeric

        saddles = [_numbers(saddle, known, values) for saddle in _value(options["saddles"], values)]
        return _complete(made, saddles, _numeric(options["connection"], known, values), title, names)

    compiler = options["compiler"] if options["compiler"] is not None else os.environ.get("CC", "cc")
    if not compiler or shutil.which(compiler.split()[0]) is None:

        def vectorised(values: Mapping[str, float], tolerance: float) -> System:
            numbers: list[Any] = [np.float64(values[key]) for key in form.parameters]
            none = np.float64(0)

            def velocity(*x: Any) -> Any:
                return in_numpy.velocity(*x, none, *numbers)

            def hamiltonian(*x: Any) -> Any:
                return in_numpy.hamiltonian(*x, none, *numbers)

            def jacobian(*x: Any) -> Any:
                return in_numpy.jacobian(*x, none, *numbers)

            h = None if form.h is None else hamiltonian
            field = field_of(title, len(symbols), velocity, h, 0.0, extent_of(title, box), jacobian)
            return complete(_made(field, title, "of expressions", values, box, shift, where, tolerance), values)

        return Family(title, parameters, vectorised)

    source = source_of(form, box, shift, where, energy or 0.0)

    def make(values: Mapping[str, float], tolerance: float) -> System:
        library = compiled(source, compiler)
        require_same(library, form, in_numpy, [values[key] for key in form.parameters], _region(where, box, len(symbols)))
        return complete(_lober.system(library, list(values.items()), tolerance), values)

    return Family(title, parameters, make)


def _box(title: str, window: Sequence[float]) -> Box:
    x0, y0, x1, y1 = numbers_of(window, f"system {title}: window", 4)
    return x0, y0, x1, y1


def _region(where: Section, box: Box, coordinates: int) -> NDArray[np.float64]:
    """Bounds of the coordinates near the section: those of the window for the map's, as much around it for others."""
    reach = max(box[2] - box[0], box[3] - box[1]) / 2
    region = np.tile([-reach, reach], (coordinates, 1))
    region[where.coordinate] += where.value
    region[where.chart[0]] = box[::2]
    region[where.chart[1]] = box[1::2]
    return region


def _numbers(entries: Any, params: Mapping[Any, float], values: Mapping[str, float]) -> list[float]:
    """Numbers of expressions of parameters."""
    from ._forms import expression

    chosen = {symbol: values[str(symbol)] for symbol in params}
    found: Callable[[Any], float] = lambda entry: number_of(expression(entry, "a saddle").subs(chosen), "a saddle")
    return [found(entry) for entry in entries]
