"""Curves from and to files."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Mapping, Union

from . import _lober
from ._arrays import Points, points_of
from .errors import UsageError

Path = Union[str, "os.PathLike[str]"]

_ENDINGS = {".npy": "npy", ".csv": "csv", ".txt": "text", ".dat": "tecplot", ".raw": "raw", ".f64": "raw"}


@dataclass(frozen=True)
class Zone:
    title: str
    points: Points


@dataclass(frozen=True)
class CurveFile:
    """All zones of a file, or all curves of a table; binary formats have one."""

    path: str
    format: str
    sha256: str
    zones: list[Zone]


def read(path: Path, *, closed: bool = True) -> Points:
    """The points of one curve: of FILE, or of one zone, FILE#2 by its number from 0 or FILE#TITLE. FILE:lon,lat and
    FILE:2,3 choose columns of a table by name or number, FILE:lon,lat,by=id#a one of its groups.

    The format is recognised by the content: Tecplot ASCII, text in columns, NPY, raw float64. A closed curve loses a
    last point that repeats the first. Raises DataError, which names file and line.
    """
    return _lober.read_one(os.fspath(path), closed)


def read_zones(path: Path, *, columns: str = "") -> CurveFile:
    """All zones of a file, with the SHA-256 of its bytes; `columns` as in `read`, "lon,lat" or "2,3,by=id". Raises
    DataError.
    """
    name = os.fspath(path)
    format_name, sha256, zones = _lober.read_zones(name, True, columns)
    return CurveFile(name, format_name, sha256, [Zone(_text(title), points) for title, points in zones])


def write(path: Path, curve: Any) -> None:
    """Writes a curve, or a mapping of titles to curves as the zones of a Tecplot file.

    The ending names the format: .npy, .csv, .txt, .dat (Tecplot) or .raw. Numbers read back to the same bits. The file
    appears under its name when it is complete. Raises UsageError, DataError.
    """
    name = os.fspath(path)
    ending = os.path.splitext(name)[1].lower()
    if ending not in _ENDINGS:
        raise UsageError(
            f"{name}: the ending does not name a format of points; use .npy, .csv, .txt, .dat (Tecplot) or .raw"
        )
    zones = curve if isinstance(curve, Mapping) else None
    if _ENDINGS[ending] == "tecplot":
        titled = zones.items() if zones is not None else [("", curve)]
        _lober.write_zones(name, [(title, points_of(points, title or "curve")) for title, points in titled])
    elif zones is not None:
        raise UsageError(f"{name}: several curves need a Tecplot file (.dat)")
    else:
        _lober.write_one(name, points_of(curve), _ENDINGS[ending])


def _text(title: bytes) -> str:
    return title.decode("utf-8", "replace")
