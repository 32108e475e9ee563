"""Versions of lober and of what it uses here, for a report of an error."""

from __future__ import annotations

import os
import platform
import shutil
from importlib import metadata
from pathlib import Path

from . import _lober
from ._files import formats

#: Packages that are imported when they are used, and for what.
OPTIONAL = {
    "matplotlib": "lober.plot",
    "sympy": "lober.hamiltonian, lober.equations",
    "numba": "functions that it compiles, as systems",
    "pandas": "to_pandas of results",
    "xarray": "to_xarray of results",
    "distributed": "batches on a cluster of Dask",
    "shapely": "its polygons and lines, as curves",
}


def _version(package: str) -> str:
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return "not installed"


def _program(command: str) -> str:
    found = shutil.which(command.split()[0]) if command else None
    return found or "NumPy, as there is no compiler here"


def _libraries() -> list[tuple[str, str]]:
    """The libraries that read and write formats of files, by Debian's names."""
    found: dict[str, tuple[str, list[str]]] = {}
    for entry in formats():
        if entry.library:
            found.setdefault(entry.library, (entry.missing or "there", []))[1].append(entry.name)
    return [(library, f"{state} ({', '.join(names)})") for library, (state, names) in found.items()]


def show_versions() -> None:
    """Prints the versions of lober, Python and NumPy, compiler, instruction set and threads, the optional packages, and
    the libraries for formats of files.

    Nothing is imported for it. A report of an error is complete with these lines.
    """
    build = _lober.build()
    compiler = os.environ.get("CC", "cc")
    lines = [
        ("lober", f"{_lober.__version__} in {Path(__file__).parent}"),
        ("Python", f"{platform.python_version()}, {platform.platform()}"),
        ("NumPy", _version("numpy")),
        ("compiler", f"{build['compiler']} built lober; systems are compiled with {_program(compiler)}"),
        ("instructions", build["instruction_set"]),
        ("threads", str(build["threads"])),
        *((package, f"{_version(package)} ({use})") for package, use in OPTIONAL.items()),
        *_libraries(),
    ]
    width = max(len(name) for name, _ in lines)
    print("\n".join(f"{name:<{width}}  {value}" for name, value in lines))
