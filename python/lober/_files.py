"""Curves from and to files."""

from __future__ import annotations

import html
import os
import warnings
from dataclasses import dataclass
from typing import Any, Iterator, Mapping, Union

import numpy as np
from numpy.typing import NDArray

from . import _lober
from ._areas import html_table
from ._arrays import Points, points_of
from ._numbers import number_of
from .errors import UsageError

Path = Union[str, "os.PathLike[str]"]


@dataclass(frozen=True, eq=False)
class Zone:
    """A curve of a file. It is taken for its points wherever a curve is."""

    title: str
    points: Points

    def __array__(self, dtype: Any = None) -> NDArray[Any]:
        return np.asarray(self.points, dtype)

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        return f"<Zone {self.title!r}: {len(self.points)} points>"


@dataclass(frozen=True, eq=False)
class CurveFile:
    """All curves of a file: zones, groups of a table, rings of polygons. A sequence of zones, which are named by their
    numbers and titles."""

    path: str
    format: str
    sha256: str
    zones: list[Zone]

    def __len__(self) -> int:
        return len(self.zones)

    def __iter__(self) -> Iterator[Zone]:
        return iter(self.zones)

    def __getitem__(self, which: int | str) -> Zone:
        if not isinstance(which, str):
            return self.zones[which]
        found = [zone for zone in self.zones if zone.title == which]
        if not found:
            raise KeyError(f"{self.path} has no zone {which!r}; it has {_listed([repr(zone.title) for zone in self.zones])}")
        return found[0]

    def __repr__(self) -> str:
        points = sum(len(zone) for zone in self.zones)
        titles = _listed([repr(zone.title) for zone in self.zones if zone.title])
        return f"<CurveFile {self.path}, {self.format}: {len(self.zones)} zones, {points} points{titles and ': ' + titles}>"

    def _repr_html_(self) -> str:
        rows = [[str(k), html.escape(zone.title), str(len(zone))] for k, zone in enumerate(self.zones[:20])]
        more = f"<p>and {len(self.zones) - 20} more</p>" if len(self.zones) > 20 else ""
        return f"<p>{html.escape(repr(self)[1:-1])}</p>" + html_table(["zone", "title", "points"], rows) + more


def read(
    path: Path,
    *,
    closed: bool = True,
    periods: float | tuple[float | None, float | None] | None = None,
    near: Any = None,
) -> Points:
    """The points of one curve: of FILE, or of one zone, FILE#2 by its number from 0 or FILE#TITLE. FILE:lon,lat and
    FILE:2,3 choose columns of a table by name or number, FILE:lon,lat,by=id#a one of its groups; FILE.h5:/group/x,/group/y
    two arrays of an HDF5, NetCDF, MAT or NPZ file, FILE.npz:xy one of N x 2.

    The format is recognised by the content, compressed by gzip or not: `formats()` lists them. A closed curve loses a
    last point that repeats the first. `periods` are those of x and y, None for none; a number is that of x, as of
    longitudes: 360. A curve that was stored modulo them is followed across the seam, and moved by whole periods to where
    the curve `near` is: the other one of a pair, which it would not meet else where the two begin on different sides of
    the seam. A warning is issued for longitudes that jump at the date line without a period. Raises UsageError,
    DataError, which names file and line.
    """
    x, y = _periods_of(periods)
    if near is not None and x == 0 and y == 0:
        raise UsageError("near moves a curve by whole periods: give periods too")
    others = None if near is None else points_of(near, "near")
    points, warning = _lober.read_one(os.fspath(path), closed, x, y, others)
    if warning:
        warnings.warn(f"{os.fspath(path)}: {warning}", stacklevel=2)
    return points


def _periods_of(periods: Any) -> tuple[float, float]:
    both = (periods, None) if periods is None or np.ndim(periods) == 0 else tuple(periods)
    if len(both) != 2:
        raise UsageError(f"periods are those of x and y, or a number for x, not {periods!r}")
    x, y = (0.0 if one is None else number_of(one, "periods") for one in both)
    return x, y


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


def _listed(names: list[str]) -> str:
    return ", ".join(names[:6]) + (f" and {len(names) - 6} more" if len(names) > 6 else "")


def _text(title: bytes) -> str:
    return title.decode("utf-8", "replace")
