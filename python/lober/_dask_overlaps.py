"""overlap_matrix on a cluster of Dask: tiles of the matrix are tasks."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any, Callable

import numpy as np
from numpy.typing import NDArray

from . import _lober
from ._curve_sets import CurveSet
from ._dask import require_client
from .errors import Cancelled, DataError, UsageError

#: Tiles for each thread of the workers, so that all of them are done at about the same time.
TILES = 4
#: A measure of two curves is this one of the curves the other way round.
MIRRORED = {"c1_minus_c2": "c2_minus_c1", "c2_minus_c1": "c1_minus_c2"}
#: How often blocks that were lost with a worker are sent again.
TRIES = 5

#: As _lober.overlap_matrix: of each measure the values and the bounds, which may be None; where rows begin, the columns
#: of the entries; the number of pairs; messages.
Found = tuple[dict[str, tuple[Any, Any]], NDArray[Any], NDArray[Any], int, list[str]]


@dataclass(frozen=True)
class Tile:
    rows: range
    columns: range
    #: On the diagonal of the matrix of one set.
    one_set: bool = False


def compute(block_a: CurveSet, block_b: CurveSet | None, options: dict[str, Any]) -> Found:
    """A tile, by a worker; curves that cannot be used are in its messages."""
    points, offsets = block_b if block_b is not None else (None, None)
    found: Found = _lober.overlap_matrix(*block_a, points, offsets, None, **options)
    return found


def overlap_matrix(
    client: Any,
    first: CurveSet,
    second: CurveSet | None,
    options: dict[str, Any],
    progress: Callable[[float | None, str | None], Any] | None,
) -> Found:
    """As _lober.overlap_matrix, with its options but for threads and the same bits."""
    require_client(client)
    measures = options["measures"]
    for curves, name in ((first, "curves_a"), (second or first, "curves_b")):
        if (np.diff(curves[1]) < 0).any() or not 0 <= curves[1][0] <= curves[1][-1] <= len(curves[0]):
            raise UsageError(f"{name}: offsets ascend from 0 to the number of points, {len(curves[0])}")
    slots = max(1, sum(client.nthreads().values()))
    tiles = _tiles(len(first[1]) - 1, None if second is None else len(second[1]) - 1, TILES * slots)
    asked = list(dict.fromkeys(measures + [MIRRORED.get(one, one) for one in measures])) if second is None else measures
    of_tile = {**options, "measures": asked, "keep_going": True, "threads": 1}
    found = _computed(client, first, second, tiles, of_tile, progress)
    numbered = (line for tile, one in zip(tiles, found) for line in _numbered(one[4], tile, second is None))
    failures = sorted(set(numbered), key=_order)
    if failures and not options["keep_going"]:
        raise DataError(failures[0])
    shape = (len(first[1]) - 1, len((second or first)[1]) - 1)
    pairs = sum(one[3] for one in found)
    if options["dense"]:
        return _dense(tiles, found, measures, shape, second is None), np.zeros(0), np.zeros(0), pairs, failures
    numbers, begin, column = _sparse(tiles, found, measures, shape, second is None)
    return numbers, begin, column, pairs, failures


def _order(line: str) -> tuple[bool, bool, list[int]]:
    """Messages about curves before those about pairs, each in the order of the numbers."""
    numbers = [int(number) for number in re.findall(r"\d+", line)]
    return line.startswith("curves "), line.startswith("second"), numbers


def _parts(count: int, number: int) -> list[range]:
    edges = [count * k // number for k in range(number + 1)]
    return [range(a, b) for a, b in zip(edges, edges[1:]) if b > a]


def _tiles(rows: int, columns: int | None, wanted: int) -> list[Tile]:
    if columns is None:
        parts = _parts(rows, int(np.ceil(np.sqrt(2 * wanted))))
        return [Tile(a, b, a is b) for k, a in enumerate(parts) for b in parts[k:]]
    side = int(np.ceil(np.sqrt(wanted)))
    return [Tile(a, b) for a in _parts(rows, side) for b in _parts(columns, side)]


def _block(curves: CurveSet, part: range) -> CurveSet:
    points, offsets = curves
    begin = offsets[part.start : part.stop + 1]
    return np.ascontiguousarray(points[begin[0] : begin[-1]]), np.ascontiguousarray(begin - begin[0])


def _computed(
    client: Any, first: CurveSet, second: CurveSet | None, tiles: list[Tile], options: dict[str, Any], progress: Any
) -> list[Found]:
    import distributed

    completed: Any = distributed.as_completed
    found: dict[int, Found] = {}
    for _ in range(TRIES):
        missing = [number for number in range(len(tiles)) if number not in found]
        parts_a = list(dict.fromkeys(tiles[number].rows for number in missing))
        parts_b = list(dict.fromkeys(tiles[number].columns for number in missing if not tiles[number].one_set))
        # Each block goes to a worker once and from there to those that need it.
        blocks_a = dict(zip(parts_a, client.scatter([_block(first, part) for part in parts_a], hash=False)))
        blocks_b = dict(zip(parts_b, client.scatter([_block(second or first, part) for part in parts_b], hash=False)))
        futures = {}
        for number in missing:
            block_b = None if tiles[number].one_set else blocks_b[tiles[number].columns]
            futures[client.submit(compute, blocks_a[tiles[number].rows], block_b, options, pure=False)] = number
        try:
            for future in completed(list(futures), loop=client.loop):
                if future.status == "error":
                    raise future.exception()
                if future.status == "finished":
                    found[futures[future]] = future.result()
                future.release()
                if progress is not None and progress(len(found) / len(tiles), None) is False:
                    raise Cancelled(f"cancelled with {len(found)} of {len(tiles)} tiles done")
        finally:
            client.cancel([future for future, number in futures.items() if number not in found], force=True)
        if len(found) == len(tiles):
            return [found[number] for number in range(len(tiles))]
    raise DataError(f"the workers lost their curves {TRIES} times, each with the worker that had them; start workers that stay")


def _numbered(lines: list[str], tile: Tile, one_set: bool) -> list[str]:
    """Messages with the numbers of the whole sets."""

    def pair(match: re.Match[str]) -> str:
        return f"curves {int(match[1]) + tile.rows.start} and {int(match[2]) + tile.columns.start}"

    def row(match: re.Match[str]) -> str:
        return f"curve {int(match[1]) + tile.rows.start}"

    def column(match: re.Match[str]) -> str:
        return f"curve {int(match[1]) + tile.columns.start}"

    numbered = []
    for line in lines:
        of_columns = line.startswith("second set: ")
        line = re.sub(r"^curves (\d+) and (\d+)", pair, line)
        line = re.sub(r"\bcurve (\d+)", column if of_columns else row, line, count=1)
        numbered.append(re.sub(r"^(first|second) set: ", "", line) if one_set else line)
    return numbered


def _dense(tiles: list[Tile], found: list[Found], measures: list[str], shape: tuple[int, int], one_set: bool) -> Any:
    numbers = {name: (np.empty(shape), np.empty(shape)) for name in measures}
    for tile, one in zip(tiles, found):
        for name in measures:
            others = one[0][MIRRORED.get(name, name)] if one_set else (None, None)
            for whole, part, across in zip(numbers[name], one[0][name], others):
                if part is None:
                    continue
                whole[tile.rows.start : tile.rows.stop, tile.columns.start : tile.columns.stop] = part
                if one_set and not tile.one_set and across is not None:
                    whole[tile.columns.start : tile.columns.stop, tile.rows.start : tile.rows.stop] = across.T
    return numbers


def _sparse(tiles: list[Tile], found: list[Found], measures: list[str], shape: tuple[int, int], one_set: bool) -> Any:
    """Entries of all tiles, by rows and then columns. What sparse matrices are of is the same the other way round."""
    rows, columns, entries = [], [], {name: ([], []) for name in measures}  # type: ignore[var-annotated]
    for tile, (numbers, begin, column, _, _) in zip(tiles, found):
        row = np.repeat(np.arange(len(begin) - 1), np.diff(begin)) + tile.rows.start
        other = column.astype(np.int64) + tile.columns.start
        for a, b in ((row, other), (other, row)) if one_set and not tile.one_set else ((row, other),):
            rows.append(a)
            columns.append(b)
            for name in measures:
                for all_of_them, some in zip(entries[name], numbers[name]):
                    all_of_them.append(np.zeros(len(a)) if some is None else some)
    row, column = np.concatenate(rows), np.concatenate(columns)
    order = np.lexsort((column, row))
    begin = np.zeros(shape[0] + 1, np.int64)
    np.cumsum(np.bincount(row, minlength=shape[0]), out=begin[1:])
    sorted_entries = {name: tuple(np.concatenate(some)[order] for some in entries[name]) for name in measures}
    return sorted_entries, begin, column[order].astype(np.uint32)
