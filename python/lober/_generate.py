"""Writes _generated.py, the functions of operations that follow from the engine's table alone:

    python -m lober._generate > python/lober/_generated.py
"""

from __future__ import annotations

import textwrap
from dataclasses import dataclass, field
from typing import Any

from . import _lober
from ._call import identifier


@dataclass(frozen=True)
class Face:
    """A result that is made by hand, since its parts are computed when asked for, or are views of memory."""

    #: What makes it of a run, and its type.
    maker: str
    returns: str
    #: Options that would only choose what is computed when asked for, with the values that compute nothing.
    lazy: dict[str, bool | None] = field(default_factory=dict)
    #: Options that may be given without their names.
    positional: tuple[str, ...] = ()
    #: Whether it is a Result that has to be told its run.
    keeps: bool = False
    #: Whether a Connection may stand for the options that choose one.
    connection: bool = False
    #: The name of the function, where it is not that of the operation.
    name: str | None = None


FACES = {
    "escape": Face("Escape._of", "Escape", keeps=True),
    "fixed_points": Face("FixedPoints._of", "FixedPoints", keeps=True),
    "grow": Face("Manifold._of", "Manifold", positional=("side",), keeps=True),
    "image": Face("images_of", "list[Image]", positional=("first", "last"), name="images"),
    "interior": Face("Interior", "Interior"),
    "manifold_tangle": Face("SystemTangle", "SystemTangle", lazy={"overlaps": False}, connection=True),
    "overlay": Face(
        "Overlay", "Overlay", lazy={"discretisation": False, "smooth": False, "classes": False}
    ),
    "regions": Face("Regions", "Regions", lazy={"rule": None, "areas_only": True}),
    "section": Face("orbits_of", "NDArray[np.float64]"),
    "tangle": Face("Tangle", "Tangle", lazy={"overlaps": False}),
    "transport": Face("Transport._of", "Transport", connection=True, keeps=True),
}
#: A function by hand: it has no options, and gives arrays for each point.
BY_HAND = {"winding"}

HEAD = '''"""Functions of operations, written by _generate.py from the engine's table. Not to be edited."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np
from numpy.typing import NDArray

from ._agreement import Agreement, agreement_of
from ._call import run
from ._dynamics import FixedPoints, Image, Manifold, images_of, orbits_of
from ._measured import Measured
from ._overlay import Interior, Overlay
from ._progress import Progress
from ._numbers import seed_of
from ._regions import Regions
from ._result import Result, kept
from ._systems import Box, Connection, Pair
from ._tangle import Tangle
from ._transport import Escape, SystemTangle, Transport
'''

IN_OBJECTS = {
    "whole": "int",
    "flag": "bool",
    "text": "str | None",
    "lines": "list[str]",
    "numbers": "NDArray[np.float64]",
    "wholes": "list[int]",
    "point": "Pair",
    "points": "NDArray[np.float64]",
    "matrix": "NDArray[np.float64]",
}
IN_COLUMNS = {
    "whole": "NDArray[Any]",
    "flag": "NDArray[Any]",
    "text": "list[str | None]",
    "lines": "list[list[str]]",
    "numbers": "list[NDArray[np.float64]]",
    "wholes": "list[list[int]]",
    "point": "NDArray[np.float64]",
    "points": "list[NDArray[np.float64]]",
    "matrix": "NDArray[np.float64]",
}
CURVES = (
    "Curves and points are arrays of N x 2 numbers, complex vectors, or polygons of shapely; the last point of a closed "
    "curve is joined to the first. Arrays of doubles of more than a megabyte are not copied and must not change while the "
    "result is in use."
)
ARGUMENTS = {
    "bool": "bool",
    "int": "int",
    "float": "float",
    "str": "str",
    "point": "Pair",
    "box": "Box",
    "numbers": "Sequence[float]",
}


def sentence(text: str) -> str:
    return text[:1].upper() + text[1:] + ("" if text.endswith(".") else ".")


def wrapped(text: str, indent: int) -> str:
    return textwrap.fill(text, 116 - indent).replace("\n", "\n" + " " * indent)


def comment(text: str) -> str:
    return "".join(f"    #: {line}\n" for line in textwrap.wrap(text, 110))


def has_lists(fields: list[dict[str, Any]]) -> bool:
    return any(field["kind"] == "list" or has_lists(field["members"]) for field in fields)


class Classes:
    """The classes of a result, inner ones first."""

    def __init__(self) -> None:
        self.text = ""

    def add(
        self,
        name: str,
        fields: list[dict[str, Any]],
        columns: bool,
        meaning: str,
        compares: bool = False,
        of_result: str = "",
    ) -> str:
        """The name of the class; `of_result`: the base of the outermost one."""
        lines, made = "", ""
        for field in fields:
            kind, key = field["kind"], field["name"]
            member = identifier(key)
            camel = name + "".join(part.capitalize() for part in key.split("_"))
            value = f'v["{key}"]'
            if kind in ("object", "list"):
                as_rows = kind == "list" and not columns and has_lists(field["members"])
                of = self.add(camel, field["members"], not as_rows and (columns or kind == "list"), field["meaning"])
                if as_rows:
                    annotation, value = f"list[{of}]", f"[{of}._of(one) for one in {value}]"
                elif kind == "object" and not columns:
                    annotation, value = f"{of} | None", f"None if {value} is None else {of}._of({value})"
                else:
                    annotation, value = of, f"{of}._of({value})"
            elif field["bar"]:
                annotation, value = "Measured", f"Measured(*({value} or (np.nan, np.nan)))"
            elif kind == "number":
                annotation = "NDArray[np.float64]" if columns else "float"
            else:
                annotation = (IN_COLUMNS if columns else IN_OBJECTS)[kind]
            unit = f" (unit: {field['unit']})" if field["unit"] else ""
            lines += comment(sentence(field["meaning"] + unit)) + f"    {member}: {annotation}\n"
            made += f"            {member}={value},\n"
        if compares:
            lines += "    #: By independent routes.\n    agreement: Agreement\n"
            made += "            agreement=agreement_of(comparisons),\n"
        more = ", comparisons: list[tuple[Any, ...]]" if compares else ""
        what = sentence(meaning) + (" A column each." if columns else "")
        self.text += (
            f'\n\n@dataclass(frozen=True{", repr=False" if of_result else ""})\nclass {name}{of_result}:\n    """{wrapped(what, 4)}"""\n\n{lines}\n'
            f'    @classmethod\n    def _of(cls, v: dict[str, Any]{more}) -> "{name}":\n        return cls(\n{made}        )\n'
        )
        return name


def parameter(option: dict[str, Any]) -> str:
    name, of, default = identifier(option["key"]), ARGUMENTS[option["type"]], option["default"]
    if option["required"]:
        return f"    {name}: {of},\n"
    more = "    rng: Any = None,\n" if name == "seed" else ""
    return f"    {name}: {of} | None = None,\n" if default is None else f"    {name}: {of} = {default!r},\n{more}"


def setting(option: dict[str, Any]) -> str:
    """The value of an option as a function passes it on."""
    name = identifier(option["key"])
    return f"seed_of(seed, {option['default']!r}, rng)" if name == "seed" else name


def explained(option: dict[str, Any]) -> str:
    otherwise = f"; default: {option['otherwise']}" if option["otherwise"] else ""
    rng = "\n    rng: what numpy.random.default_rng takes, from which the seed is drawn, in place of one"
    return "\n    " + wrapped(f"{identifier(option['key'])}: {option['meaning']}{otherwise}", 8) + (
        rng if option["key"] == "seed" else ""
    )


def function(operation: dict[str, Any]) -> str:
    name, face = operation["name"], FACES.get(operation["name"])
    lazy = face.lazy if face else {}
    options = [one for one in operation["options"] if one["key"] not in lazy]
    settings = "".join(f'        "{one["key"]}": {setting(one)},\n' for one in options)
    by_position = [one for one in options if face and one["key"] in face.positional]
    by_name = sorted((one for one in options if one not in by_position), key=lambda one: not one["required"])
    given, passed, what = inputs(operation["inputs"])
    more = ""
    if face and face.connection:
        given += "    connection: Connection | None = None,\n"
        more = ", connection"
        what += " `connection`: in place of the options that choose one."
    if lazy:
        more += f", lazy={lazy}".replace("'", '"')
    given += "".join(map(parameter, by_position))
    ran = f'run("{name}", {passed}, settings, threads, progress{more})'
    if face:
        classes, returns = "", face.returns
        made = f"    ran = {ran}\n    return {face.maker}(ran)\n"
        if face.keeps:
            made = f"    ran = {ran}\n    return kept({face.maker}(ran), ran)\n"
    else:
        of = Classes()
        title = "".join(part.capitalize() for part in name.split("_"))
        returns = of.add(title, operation["result"], False, f"The result of `{name}`", operation["compares"], "(Result)")
        classes = of.text
        compared = ", ran.comparisons" if operation["compares"] else ""
        made = f"    ran = {ran}\n    return kept({returns}._of(ran.value{compared}), ran)\n"
    return (
        f"{classes}\n\ndef {face and face.name or name}(\n{given}    *,\n{''.join(map(parameter, by_name))}"
        f"    threads: int = 0,\n    progress: Progress = None,\n) -> {returns}:\n"
        f'    """{wrapped(operation["summary"], 4)}\n\n    {what} Raises UsageError, DataError, Cancelled.\n'
        f'{"".join(map(explained, options))}\n    """\n'
        f"    settings = {{\n{settings}    }}\n{made}"
    )


def inputs(specs: list[dict[str, Any]]) -> tuple[str, str, str]:
    """The arguments of a function, what it passes on, and what a reader has to know of them."""
    given, passed, about = "", "", []
    for spec in specs:
        name = spec["name"]
        given += f"    {name}: Any{' = None' if spec['optional'] else ''},\n"
        passed += f"{name}, "
        about.append("`system` is a system or its name" if spec["system"] else f"`{name}`: {spec['meaning']}")
    what = wrapped("; ".join(about) + "." + ("" if all(spec["system"] for spec in specs) else f" {CURVES}"), 4)
    return given, f"({passed.rstrip() if len(specs) == 1 else passed[:-2]})", what


def text() -> str:
    made, names = "", []
    for operation in _lober.table():
        name, face = operation["name"], FACES.get(operation["name"])
        if name in BY_HAND:
            continue
        made += function(operation)
        names += [face.name or name] if face else [name, "".join(part.capitalize() for part in name.split("_"))]
    listed = "".join(f'    "{name}",\n' for name in sorted(names))
    return f"{HEAD}\n__all__ = [\n{listed}]\n{made}"


if __name__ == "__main__":
    print(text(), end="")
