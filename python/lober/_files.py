"""Curves from and to files."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Mapping, Union

from . import _lober
from ._arrays import Points, points_of

Path = Union[str, "os.PathLike[str]"]

@dataclass(frozen=True)
class Zone:
    title: str
    points: Points


@dataclass(frozen=True)
class CurveFile:
    """All curves of a file: zones, groups of a table, rings of polygons."""

    path: str
    format: str
    sha256: str
    zones: list[Zone]


def read(path: Path, *, closed: bool = True, periods: tuple[float | None, float | None] = (None, None)) -> Points:
    """The points of one curve: of FILE, or of one zone, FILE#2 by its number from 0 or FILE#TITLE. FILE:lon,lat and
    FILE:2,3 choose columns of a table by name or number, FILE:lon,lat,by=id#a one of its groups; FILE.h5:/group/x,/group/y
    two arrays of an HDF5, NetCDF, MAT or NPZ file, FILE.npz:xy one of N x 2.

    The format is recognised by the content, compressed by gzip or not: `formats()` lists them. A closed curve loses a
    last point that repeats the first. `periods` are those of x and y: a curve that was stored modulo them is followed
    across the seam. Raises DataError, which names file and line.
    """
    return _lober.read_one(os.fspath(path), closed, periods[0] or 0, periods[1] or 0)


def read_zones(path: Path, *, columns: str = "") -> CurveFile:
    """All curves of FILE or FILE:COLUMNS, or the one of FILE#ZONE, as in `read`, with the SHA-256 of the file. `columns`
    are the same as behind the colon: "lon,lat", "2,3,by=id", "/group/x,/group/y". Raises DataError.
    """
    name = os.fspath(path)
    format_name, sha256, zones = _lober.read_zones(name, True, columns)
    return CurveFile(name, format_name, sha256, [Zone(_text(title), points) for title, points in zones])


def write(
    path: Path,
    curve: Any,
    *,
    format: str = "",
    closed: bool = True,
    notes: Mapping[str, str] | None = None,
) -> None:
    """Writes a curve, or a mapping of titles to curves, into one file.

    The ending names the format, or `format` does: `formats()` lists them. GeoJSON, WKT and VTK hold polygons where the
    curves are closed, and lines where they are not. `notes` are kept beside the curves, with the version of lober, in all
    formats but NPY and raw float64; in tables of text they are comments, which are there only where there are notes. Numbers read back to the same bits. The file appears under its name when it is
    complete. Raises UsageError, DataError.
    """
    zones = curve.items() if isinstance(curve, Mapping) else [("", curve)]
    _lober.write_zones(
        os.fspath(path),
        [(title, points_of(points, title or "curve")) for title, points in zones],
        format,
        closed,
        [(key, str(value)) for key, value in (notes or {}).items()],
    )


@dataclass(frozen=True)
class Format:
    """A format of curve files."""

    name: str
    meaning: str
    endings: tuple[str, ...]
    reads: bool
    writes: bool
    takes_several: bool
    """Whether a file can hold several curves."""
    library: str
    """Debian's package of the library that it needs; empty for none."""
    missing: str
    """Why that library is not there, and what to do; empty where it is."""


def formats() -> list[Format]:
    """All formats of curve files, with those whose libraries are not installed here."""
    return [
        Format(name, meaning, tuple(endings.split()), reads, writes, takes_several, library, missing)
        for name, meaning, endings, reads, writes, takes_several, library, missing in _lober.list_formats()
    ]


def _text(title: bytes) -> str:
    return title.decode("utf-8", "replace")
