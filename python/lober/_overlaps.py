"""Many curves against many, in memory."""

from __future__ import annotations

import os
import warnings
from collections import deque
from concurrent.futures import Future, ThreadPoolExecutor
from typing import TYPE_CHECKING, Any, Iterable, Iterator, Sequence, Sized

import numpy as np
from numpy.typing import NDArray

from . import _dask_overlaps, _lober
from ._arrays import points_of
from ._curve_sets import curve_set_of
from ._generated import overlay
from ._numbers import threads_of
from ._overlay import Overlay
from ._progress import Progress, watching
from .errors import Cancelled, IncompleteWarning, UsageError

if TYPE_CHECKING:
    import distributed

MEASURES = tuple(_lober.overlap_measures())
#: What is 0 for curves without a common point.
SPARSE = ("intersection", "crossings", "touches", "shared_arcs")
BOUND = "rounding_"


def overlap_matrix(
    curves_a: Any,
    curves_b: Any = None,
    what: str | Sequence[str] = "intersection",
    *,
    sparse: bool = False,
    check_simple: bool = True,
    keep_going: bool = False,
    threads: int = 0,
    progress: Progress = None,
    client: distributed.Client | None = None,
) -> Any:
    """Areas and counts of all pairs of two sets of closed curves, as a matrix with a row for each curve of `curves_a` and
    a column for each of `curves_b`; without `curves_b`, of the curves of one set with each other.

    The numbers are those of `overlay`, bit for bit (but sums of two areas, for curves whose boxes are apart, are rounded
    twice). Each curve is indexed and checked once, and only pairs whose boxes meet are overlaid. A set is a list of curves, a GeoSeries, an array of curves x points x 2 numbers, a matrix of
    complex numbers with a curve a row, or (points, offsets) where curve k are the points offsets[k]:offsets[k + 1]; the
    last is not copied and must not change during the call. Files, a store that outlives the call, and all other
    operations: `lober.batch`. Raises UsageError, DataError, which names the curve, Cancelled.

    what: intersection, union, c1_minus_c2, c2_minus_c1, symmetric_difference (areas), crossings, touches, shared_arcs
        (counts), or rounding_NAME, bounds on the error of an area by rounding; of several, a dictionary of matrices
    sparse: whether to return a csr_array of scipy, whose entries are the pairs that have a point in common; for what is 0
        otherwise
    check_simple: whether to refuse curves that are not simple
    keep_going: whether curves that cannot be used are NaN (in sparse matrices: missing) and warned of
        (`IncompleteWarning`), and not an error
    client: a cluster of Dask, whose workers compute tiles of the matrix, each with one thread, from curves that are sent to
        them; the matrix has to fit here. The same bits
    """
    if not isinstance(what, Iterable):
        raise TypeError(f"what is a name or a list of names, not {type(what).__name__}")
    names = [what] if isinstance(what, str) else list(what)
    measures = list(dict.fromkeys(_measure_of(name, sparse) for name in names))
    first = curve_set_of(curves_a, "curves_a")
    second = None if curves_b is None else curve_set_of(curves_b, "curves_b")
    points2, offsets2 = second or (None, None)
    has_bounds = any(name.startswith(BOUND) for name in names)
    threads = threads_of(threads)
    options: dict[str, Any] = {
        "measures": measures,
        "dense": not sparse,
        "bounds": has_bounds,
        "check_simple": check_simple,
        "keep_going": keep_going,
    }
    with watching(progress, "overlap_matrix") as callback:
        if client is None:
            found_here = _lober.overlap_matrix(*first, points2, offsets2, callback, threads=threads, **options)
        else:
            found_here = _dask_overlaps.overlap_matrix(client, first, second, options, callback)
        numbers, begin, column, _, failures = found_here
    if failures:
        warnings.warn(f"{len(failures)} failures, the first: {failures[0]}", IncompleteWarning, stacklevel=2)
    shape = (len(first[1]) - 1, len((second or first)[1]) - 1)
    found = {}
    for name in names:
        values, bounds = numbers[name.removeprefix(BOUND)]
        chosen = bounds if bounds is not None and name.startswith(BOUND) else values
        found[name] = _csr(chosen, begin, column, shape) if sparse else _typed(chosen, name, bool(failures))
    return found[names[0]] if isinstance(what, str) else found


def _measure_of(name: Any, sparse: bool) -> str:
    measure = name.removeprefix(BOUND) if isinstance(name, str) else name
    areas = MEASURES[: MEASURES.index("crossings")]
    if measure not in MEASURES or (measure != name and measure not in areas):
        raise UsageError(f"what: {name!r} is not known; there are {', '.join(MEASURES)}, and rounding_NAME of areas")
    if sparse and measure not in SPARSE:
        raise UsageError(f"what: {name} is not 0 for curves that lie apart; sparse matrices are of {', '.join(SPARSE)}")
    return str(measure)


def _typed(matrix: NDArray[np.float64], name: str, failed: bool) -> NDArray[Any]:
    """Counts are whole numbers, unless some are NaN."""
    is_count = name in MEASURES[MEASURES.index("crossings") :]
    return matrix.astype(np.int64) if is_count and not failed else matrix


def _csr(values: NDArray[np.float64], begin: NDArray[np.int64], column: NDArray[np.uint32], shape: tuple[int, int]) -> Any:
    try:
        from scipy.sparse import csr_array
    except ImportError:
        raise UsageError("sparse: scipy is not installed; install python3-scipy") from None
    return csr_array((values, column.astype(np.int64), begin), shape=shape)


def overlay_many(
    pairs: Iterable[tuple[Any, Any]], *, threads: int = 0, progress: Progress = None, **options: Any
) -> Iterator[Overlay]:
    """The overlays of many pairs of curves with all their parts, one after the other in the order of the pairs, as they
    are asked for: a few are computed ahead on other threads, and none is kept. Options as `overlay`.

    Raises what `overlay` raises when the turn of the pair comes; the message begins with its number. For areas and counts
    alone, `overlap_matrix` takes a fraction of the time.
    """
    threads = threads_of(threads)
    if threads < 0:
        raise UsageError(f"threads has to be 0 (one for each core) or more, not {threads}")
    return _overlays(pairs, threads or os.cpu_count() or 1, progress, options)


#: Pairs with more points are computed one at a time on all threads.
LARGE = 200_000


def _overlays(
    pairs: Iterable[tuple[Any, Any]], threads: int, progress: Progress, options: dict[str, Any]
) -> Iterator[Overlay]:
    total = len(pairs) if isinstance(pairs, Sized) else None
    waiting: deque[Future[Overlay]] = deque()
    done = 0
    with watching(progress, "overlay_many") as callback, ThreadPoolExecutor(threads) as pool:

        def next_one() -> Overlay:
            nonlocal done
            future = waiting.popleft()
            try:
                found = future.result()
            except ValueError as error:
                error.args = (f"pair {done}: {error}", *error.args[1:])
                raise
            done += 1
            if callback is not None and callback(done / total if total else None, f"{done} pairs") is False:
                raise Cancelled(f"cancelled after {done} pairs")
            return found

        try:
            for number, pair in enumerate(pairs):
                waiting.append(pool.submit(_overlay_of, number, pair, threads, options))
                while len(waiting) > 2 * threads:
                    yield next_one()
            while waiting:
                yield next_one()
        finally:
            for future in waiting:
                future.cancel()


def _overlay_of(number: int, pair: Any, threads: int, options: dict[str, Any]) -> Overlay:
    try:
        first, second = pair
    except (TypeError, ValueError):
        raise UsageError("is not two curves") from None
    c1, c2 = points_of(first, "c1"), points_of(second, "c2")
    return overlay(c1, c2, threads=threads if len(c1) + len(c2) > LARGE else 1, **options)
