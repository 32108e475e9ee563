"""Fields of a result, as the engine's table describes them, with names and units."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterator

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import xarray

Fields = list[dict[str, Any]]


def numbers_of(fields: Fields, value: dict[str, Any], prefix: str = "") -> Iterator[tuple[str, float, float | None, str]]:
    """Path, number, error and unit of all numbers outside lists that are known."""
    for field in fields:
        entry, path = value[field["name"]], prefix + field["name"]
        if entry is None:
            continue
        if field["kind"] == "object":
            yield from numbers_of(field["members"], entry, path + ".")
        elif field["kind"] in ("number", "whole"):
            number, error = entry if field["bar"] else (entry, None)
            yield path, number, error, field["unit"]


def lists_of(fields: Fields, value: dict[str, Any], prefix: str = "") -> Iterator[tuple[str, int]]:
    """Paths of lists and their lengths."""
    for field in fields:
        entry, path = value[field["name"]], prefix + field["name"]
        if entry is None:
            continue
        if field["kind"] == "object":
            yield from lists_of(field["members"], entry, path + ".")
        elif field["kind"] == "list":
            yield path, _rows(field, entry)


def _rows(field: dict[str, Any], entry: Any) -> int:
    if isinstance(entry, list):
        return len(entry)
    return _length(entry)


def _length(column: Any) -> int:
    if isinstance(column, tuple):
        return _length(column[0])
    if isinstance(column, dict):
        return max((_length(one) for one in column.values()), default=0)
    return 0 if column is None else len(column)


class _Variables:
    """The variables of a dataset."""

    def __init__(self) -> None:
        self.all: dict[str, Any] = {}
        self.about: dict[str, str] = {}
        self._rows: dict[str, int] = {}

    def _begin(self, name: str, columns: dict[str, Any]) -> str:
        self._rows[name] = _length(columns)
        return name

    def add_fields(self, fields: Fields, value: dict[str, Any], prefix: str, row: str | None) -> None:
        """`row`: the dimension of the list that the values are columns of."""
        for field in fields:
            entry, name = value[field["name"]], prefix + field["name"]
            if entry is None:
                continue
            kind = field["kind"]
            if kind == "object":
                # One that not every element of the list has is a list of its own.
                of_some = row is not None and _length(entry) != self._rows[row]
                self.add_fields(field["members"], entry, name + "_", self._begin(name, entry) if of_some else row)
            elif kind == "list" and isinstance(entry, list):
                for number, one in enumerate(entry):
                    self.add_fields(field["members"], one, f"{name}_{number}_", None)
            elif kind == "list":
                self.add_fields(field["members"], entry, name + "_", self._begin(name, entry))
            elif field["bar"]:
                self._put(name, entry[0], row, field)
                error = {**field, "meaning": f"error of {name}", "kind": kind}
                self._put(prefix + field["bar"], entry[1], row, error)
            elif kind == "text" and row is None:
                self.about[name] = entry
            elif kind == "lines":
                if row is None:
                    self.about[name] = "\n".join(entry)
            else:
                self._put(name, entry, row, field)

    def _put(self, name: str, entry: Any, row: str | None, field: dict[str, Any]) -> None:
        array = _array(entry, row is not None and field["kind"] in ("numbers", "wholes", "points"))
        if array is None:
            return
        dimensions = [] if row is None else [row]
        for axis in range(len(dimensions), array.ndim):
            is_point = field["kind"] in ("point", "points") and axis == array.ndim - 1
            dimensions.append("coordinate" if is_point else f"{name}_{axis - len([row] if row else [])}")
        unit = field["unit"]
        attrs = {"long_name": field["meaning"], **({"units": unit} if unit else {})}
        self.all[name] = (dimensions, array, attrs)


def _array(entry: Any, is_ragged: bool) -> NDArray[Any] | None:
    """An array; lists of different lengths are filled up with NaN."""
    if not is_ragged:
        array = np.asarray(["" if one is None else one for one in entry] if isinstance(entry, list) else entry)
        return None if array.dtype.kind == "O" else array
    parts = [np.atleast_1d(np.asarray([] if part is None else part, dtype=np.float64)) for part in entry]
    if not parts:
        return None
    filled = np.full((len(parts), max(len(part) for part in parts), *parts[0].shape[1:]), np.nan)
    for k, part in enumerate(parts):
        filled[k, : len(part)] = part
    return filled


def dataset_of(fields: Fields, value: dict[str, Any], about: dict[str, str]) -> xarray.Dataset:
    import xarray

    variables = _Variables()
    variables.add_fields(fields, value, "", None)
    uses_points = any("coordinate" in dimensions for dimensions, *_ in variables.all.values())
    coords = {"coordinate": ["x", "y"]} if uses_points else {}
    return xarray.Dataset(variables.all, coords=coords, attrs={**about, **variables.about})
