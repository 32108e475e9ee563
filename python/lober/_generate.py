"""Writes _generated.py, the functions of operations that follow from the engine's table alone:

    python -m lober._generate > python/lober/_generated.py
"""

from __future__ import annotations

import keyword
import textwrap
from typing import Any

from . import _lober

#: Those whose functions are written by hand, with conveniences of their own.
BY_HAND = {
    "escape",
    "fixed_points",
    "grow",
    "image",
    "interior",
    "manifold_tangle",
    "overlay",
    "regions",
    "section",
    "tangle",
    "transport",
    "winding",
}

HEAD = '''"""Functions of operations, written by _generate.py from the engine's table. Not to be edited."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Sequence

import numpy as np
from numpy.typing import NDArray

from ._agreement import Agreement, agreement_of
from ._arrays import points_of
from ._call import call, system_input
from ._measured import Measured
from ._progress import Progress
from ._systems import Box, Pair
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
ARGUMENTS = {
    "bool": "bool",
    "int": "int",
    "float": "float",
    "str": "str",
    "point": "Pair",
    "box": "Box",
    "numbers": "Sequence[float]",
}


def identifier(name: str) -> str:
    return name + "_" if keyword.iskeyword(name) else name


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

    def add(self, name: str, fields: list[dict[str, Any]], columns: bool, meaning: str, compares: bool = False) -> str:
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
            f'\n\n@dataclass(frozen=True)\nclass {name}:\n    """{wrapped(what, 4)}"""\n\n{lines}\n'
            f'    @classmethod\n    def _of(cls, v: dict[str, Any]{more}) -> "{name}":\n        return cls(\n{made}        )\n'
        )
        return name


def function(operation: dict[str, Any]) -> str:
    name = operation["name"]
    options = sorted(operation["options"], key=lambda option: not option["required"])
    parameters, settings, about = "", "", ""
    for option in options:
        member, of = identifier(option["key"]), ARGUMENTS[option["type"]]
        default = option["default"]
        if option["required"]:
            parameters += f"    {member}: {of},\n"
        elif default is None:
            parameters += f"    {member}: {of} | None = None,\n"
        else:
            parameters += f"    {member}: {of} = {default!r},\n"
        settings += f'        "{option["key"]}": {member},\n'
        otherwise = f"; default: {option['otherwise']}" if option["otherwise"] else ""
        about += "\n    " + wrapped(f"{member}: {option['meaning']}{otherwise}", 8)
    classes = Classes()
    title = "".join(part.capitalize() for part in name.split("_"))
    result = classes.add(title, operation["result"], False, f"The result of `{name}`", operation["compares"])
    given, passed, what = inputs(operation["inputs"])
    made = f'call("{name}", {passed}, settings, threads, progress)'
    arguments = f"*{made}" if operation["compares"] else f"{made}[0]"
    doc = wrapped(operation["summary"], 4)
    return (
        f"{classes.text}\n\ndef {name}(\n{given}    *,\n{parameters}    threads: int = 0,\n"
        f"    progress: Progress = None,\n) -> {result}:\n"
        f'    """{doc}\n\n    {what} Raises UsageError, DataError, Cancelled.\n{about}\n    """\n'
        f"    settings = {{\n{settings}    }}\n"
        f"    return {result}._of({arguments})\n"
    )


def inputs(specs: list[dict[str, Any]]) -> tuple[str, str, str]:
    """The arguments of a function, what it passes on, and what a reader has to know of them."""
    if specs[0]["system"]:
        return "    system: Any,\n", "[system_input(system)]", "`system` is a system or its name."
    given, passed = "", []
    for spec in specs:
        name = spec["name"]
        given += f"    {name}: Any{' = None' if spec['optional'] else ''},\n"
        points = f'points_of({name}, "{name}")'
        passed.append(f"*([] if {name} is None else [{points}])" if spec["optional"] else points)
    what = "; ".join(f"`{spec['name']}`: {spec['meaning']}" for spec in specs)
    return given, f"[{', '.join(passed)}]", f"{what}; arrays of N x 2 numbers, complex vectors, or polygons of shapely."


def text() -> str:
    made = HEAD
    for operation in _lober.table():
        if operation["name"] not in BY_HAND:
            made += function(operation)
    return made


if __name__ == "__main__":
    print(text(), end="")
