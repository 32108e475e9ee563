"""Batches of many curves and pairs: a manifest says what to compute, a store keeps the results.

    >>> import lober
    >>> manifest = {"operation": "overlay", "curves": "days/*.csv", "pairs": "all"}
    >>> store = lober.batch.run(manifest, "days.results", progress=True)   # doctest: +SKIP
    >>> store.to_pandas()                                                  # doctest: +SKIP

Manifests and stores are those of `lober batch`: what one has computed, the other knows. `lober batch manifest` prints all
keys of a manifest.
"""

from __future__ import annotations

import operator
import os
import re
import tempfile
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterable, Mapping, Union

from . import _dask, _lober
from ._manifest import UNNAMED, toml_of
from ._numbers import number_of, threads_of
from ._progress import Progress, watching
from ._store import Column, Failure, Jobs, Operation, Report, Store, StoreRun, operations
from .errors import Cancelled, DataError, IncompleteWarning, UsageError

if TYPE_CHECKING:
    import distributed

__all__ = [
    "Column",
    "Estimate",
    "Failure",
    "Jobs",
    "Operation",
    "Report",
    "Store",
    "StoreRun",
    "check",
    "merge",
    "open",
    "operations",
    "run",
]

#: A file in TOML, or a dictionary with its keys.
Manifest = Union[str, "os.PathLike[str]", Mapping[str, Any]]


@dataclass(frozen=True)
class Estimate:
    """The work of a manifest, before anything is computed."""

    jobs: int
    curves: int
    files: int
    #: Points of all curves, and over all jobs, about.
    points: int
    points_in_jobs: int
    #: Bytes of all curves with their indexes, about.
    memory: int
    #: Seconds of one core if curves cross a few times; dense tangles take longer.
    core_seconds: float


def run(
    manifest: Manifest,
    store: str | os.PathLike[str] | None = None,
    *,
    shard: tuple[int, int] = (1, 1),
    memory: float = 0,
    output_root: str | os.PathLike[str] = "",
    threads: int = 0,
    progress: Progress = None,
    client: distributed.Client | None = None,
    scatter: bool = False,
) -> Store:
    """Computes what the manifest asks for and the store does not have yet, and returns the store.

    Jobs that fail do not end the run: they are in `failures` of the store, and `IncompleteWarning` says so. An interrupt
    or a `progress` that returns False lets running jobs end within a second; what is done stays in the store, and the
    next run goes on from there. Raises UsageError, which names the key, DataError, Cancelled.

    manifest: a file in TOML, or a dictionary with its keys, whose files are relative to the working folder
    store: file of the results, made where there is none; default: the name of the manifest with .results, and for a
        dictionary a file that lives as long as the Store
    shard: (2, 5) runs the second of five parts of the jobs, here into a store of its own
    memory: bytes for curves, their indexes and the work on them; default: half of the machine's
    output_root: folder below which jobs write their files; default: that of the manifest
    client: a cluster of Dask, whose workers compute; the store stays here. `memory` and `threads` are those of a task then, of
        which each thread of a worker runs one; default: a share of the worker's memory, and one thread
    scatter: the workers do not see the files: each input is sent to a worker once. Else all find them under the same path
    """
    _require_batches()
    path, text = _given(manifest)
    folder = None
    if store is None:
        if text is None:
            if os.path.isdir(path):
                raise DataError(f"{path}: is a folder, not a manifest")
            store = Path(path).with_suffix(".results")
        else:
            folder = tempfile.mkdtemp(prefix="lober-")
            store = os.path.join(folder, "batch.results")
    found = Store(_path_of(store, "store"), folder=folder)
    try:
        number, of = map(operator.index, shard)
    except (TypeError, ValueError):
        raise UsageError(f"shard: give (1, 5) for the first of five, not {shard!r}") from None
    if not 1 <= number <= of:
        raise UsageError(f"shard: ({number}, {of}) is not a part; give (1, 5) for the first of five")
    bytes_given = number_of(memory, "memory")
    if not 0 <= bytes_given < 2**63:
        raise UsageError(f"memory is a number of bytes, not {memory}")
    threads = threads_of(threads)
    with watching(progress, "batch") as callback, _explained(text):
        options: dict[str, Any] = {
            "store": found.path,
            "shard": (number - 1, of),
            "memory": int(bytes_given),
            "output_root": _path_of(output_root, "output_root"),
            "threads": threads,
        }
        if client is None:
            if scatter:
                raise UsageError("scatter is for the workers of a client")
            parts = _lober.batch_run(path, text, callback, **options)
        else:
            parts = _dask.run_batch(client, path, text, options, scatter, callback)
    found.report = Report._of(parts)
    if parts["stopped"]:
        raise Cancelled(
            f"{parts['run']} of {parts['jobs'] - parts['finished_before']} jobs were run and are in {found.path}; "
            "run the manifest again to go on"
        )
    for line in parts["damaged"]:
        warnings.warn(f"{line}; it was done again", IncompleteWarning, stacklevel=2)
    for line in parts["warnings"]:
        warnings.warn(line, stacklevel=2)
    if parts["failed"]:
        first = found.failures[0]
        warnings.warn(
            f"{parts['failed']} of {parts['jobs']} jobs failed, first {first.first}: {first.message}; "
            "failures of the store lists them",
            IncompleteWarning,
            stacklevel=2,
        )
    return found


def open(store: str | os.PathLike[str]) -> Store:
    """A store that `run` or `lober batch run` has written. Raises DataError where it is not one."""
    _require_batches()
    found = Store(_path_of(store, "store"))
    _lober.batch_runs(found.path)
    return found


def merge(target: str | os.PathLike[str], stores: Iterable[Store | str | os.PathLike[str]]) -> Store:
    """Copies the results of stores of the same plan, as the shards of `run` write them, to the store `target`, which is made
    where there is none; all of them, or nothing. A result takes the place of a failure of the same job.

    Damaged results are left out, and `IncompleteWarning` names them. Raises UsageError where a store is named twice, DataError
    where plans differ or an input was read with different contents.

        lober.batch.merge("all.results", [f"part{k}.results" for k in range(5)])
    """
    _require_batches()
    if isinstance(stores, (str, os.PathLike, Store)):
        raise TypeError("stores is a list of stores, not one")
    paths = [one.path if isinstance(one, Store) else _path_of(one, "stores") for one in stores]
    if not paths:
        raise UsageError("stores is empty; give the stores whose results are copied")
    for line in _lober.batch_merge(_path_of(target, "target"), paths):
        warnings.warn(f"{line}; it was left out", IncompleteWarning, stacklevel=2)
    return open(target)


def check(manifest: Manifest) -> Estimate:
    """Reads a manifest and says how much work it is; nothing is computed. Raises UsageError, which names the key."""
    _require_batches()
    path, text = _given(manifest)
    with _explained(text):
        return Estimate(**_lober.batch_check(path, text))


def _given(manifest: Manifest) -> tuple[str, str | None]:
    """The path of a manifest, and the text of one that is not a file."""
    if isinstance(manifest, Mapping):
        return UNNAMED, toml_of(manifest)
    if isinstance(manifest, (str, os.PathLike)):
        if isinstance(manifest, str) and "\n" in manifest:
            raise UsageError("a manifest is the name of a file or a dictionary, not a text in TOML")
        if not os.fspath(manifest):
            raise UsageError("the name of the manifest is empty")
        return os.fspath(manifest), None
    raise TypeError(f"a manifest is the name of a file or a dictionary, not {type(manifest).__name__}")


def _path_of(given: Any, name: str) -> str:
    try:
        return os.fsdecode(given)
    except TypeError:
        raise TypeError(f"{name} is a path, not {type(given).__name__}") from None


class _explained:
    """Messages about a dictionary without the number of a line, which it does not have."""

    def __init__(self, text: str | None) -> None:
        self._text = text

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: Any, error: Any, traceback: Any) -> None:
        if self._text is not None and isinstance(error, (UsageError, DataError)):
            raise type(error)(re.sub(rf"^{UNNAMED}:\d+: ", f"{UNNAMED}: ", str(error))) from None


def _require_batches() -> None:
    if not hasattr(_lober, "batch_run"):
        raise UsageError(
            "this build of lober has no batches, as SQLite, toml++ or nlohmann-json was missing: install libsqlite3-dev, "
            "libtomlplusplus-dev and nlohmann-json3-dev and build the package again"
        )
