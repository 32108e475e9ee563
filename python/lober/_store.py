"""Stores of batches: what was computed, what failed, as arrays, as tables and by SQL."""

from __future__ import annotations

import html
import json
import os
import shutil
import sqlite3
import tempfile
import weakref
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Sequence

import numpy as np
from numpy.typing import NDArray

from . import _lober
from ._areas import html_table
from .errors import UsageError

if TYPE_CHECKING:
    import pandas
    import xarray

#: Columns of a table that say which job a row is, before those of swept options.
KEYS = ("job", "failed", "group", "options", "first", "second", "message")


@dataclass(frozen=True)
class Report:
    """The account of a run."""

    #: Jobs of the manifest, or of the shard.
    jobs: int
    #: Those whose results were in the store already.
    finished_before: int
    #: Those that ran, and those of them that failed.
    run: int
    failed: int
    #: Points of the curves of all jobs that ran, a curve counted as often as it was used.
    points: int
    threads: int
    #: Wall time.
    seconds: float
    #: A line for each stored result that could not be read; its job was done again.
    damaged: list[str]
    #: A line for each curve, and each pair, whose results may not mean what you think: longitudes that were stored modulo
    #: 360, and no period in the manifest. Sorted, the first thousand that were found.
    warnings: list[str]
    #: Results of the store that are not of this manifest and its inputs as they are now: tables show this manifest alone.
    hidden: int
    #: Results that another process stored while this run computed them too: parallel processes need a shard each.
    stored_meanwhile: int

    @classmethod
    def _of(cls, parts: dict[str, Any]) -> Report:
        return cls(**{name: parts[name] for name in cls.__dataclass_fields__})


@dataclass(frozen=True)
class Jobs:
    """How many jobs of the plan of a store there are: with a result, failed, and without either."""

    done: int
    failed: int
    missing: int
    #: A line for each result that is damaged; its job counts as missing.
    damaged: list[str]

    def __len__(self) -> int:
        return self.done + self.failed + self.missing


@dataclass(frozen=True)
class Failure:
    """Jobs that failed with the same message."""

    message: str
    #: The first of them: its curves, and what a grid varies.
    first: str
    jobs: int


@dataclass(frozen=True)
class StoreRun:
    """A run that wrote into a store. Times are UTC; `how` is "complete", "stopped", or empty where it was broken off."""

    started: str
    ended: str
    how: str
    version: str
    commit: str
    compiler: str
    flags: str
    host: str
    shard: str
    threads: int
    #: The folder that names of files in `manifest`, its text, are relative to.
    folder: str
    manifest: str


class Store:
    """The results of a batch, in a file that also answers SQL. It is read anew at each question, so that it may be asked
    while another process computes.

    `numpy.asarray(store)` and the other tables have a row for each job with a result or a failure, in the order of the
    plan.
    """

    def __init__(self, path: str, *, folder: str | None = None) -> None:
        """`folder`: a temporary one, which is removed with the store."""
        self.path = path
        #: The account of the run that returned the store; None for one that was opened.
        self.report: Report | None = None
        if folder is not None:
            weakref.finalize(self, shutil.rmtree, folder, ignore_errors=True)

    # ------------------------------------------------------------------------------------------------------ the plan

    @property
    def operations(self) -> list[str]:
        """The operations of the plan."""
        return _lober.batch_operations_of(self.path)

    @property
    def jobs(self) -> Jobs:
        """How far the plan is. Reads and verifies all results."""
        return Jobs(**_lober.batch_survey(self.path)[0])

    @property
    def failures(self) -> list[Failure]:
        """The failures, each message once, in the order of the plan; the next run computes their jobs again."""
        return [Failure(*failure) for failure in _lober.batch_survey(self.path)[1]]

    @property
    def runs(self) -> list[StoreRun]:
        """Who computed, when, and with what."""
        return [StoreRun(**run) for run in _lober.batch_runs(self.path)]

    def __len__(self) -> int:
        """Jobs with a result or a failure."""
        return int(self.sql("SELECT count(*) FROM results")[0][0])

    # -------------------------------------------------------------------------------------------------------- tables

    def results(self, operation: str | None = None) -> NDArray[Any]:
        """A structured array: `job`, `failed`, `group`, `options`, `first`, `second` (names of the curves), `message`, a
        field for each option that a grid varies, and the numbers of the operation, by the names that
        `lober.batch.operations()` explains. Numbers of jobs that failed are NaN, counts -1.

        `operation` has to be named where the plan has several.
        """
        operation = self._operation(operation)
        with tempfile.TemporaryDirectory(prefix="lober-") as folder:
            path = os.path.join(folder, "results.npy")
            _lober.batch_export(self.path, path, "npy", operation)
            table = np.load(path)
        columns = {name: _texts(table[name]) if table.dtype[name].kind == "S" else table[name] for name in _names(table)}
        found = np.empty(len(table), [(name, column.dtype) for name, column in columns.items()])
        for name, column in columns.items():
            found[name] = column
        return found

    def __array__(self, dtype: Any = None) -> NDArray[Any]:
        found = self.results()
        return found if dtype is None else found.astype(dtype)

    def lists(self, operation: str | None = None) -> dict[str, list[NDArray[np.float64]]]:
        """The lists of the results, such as the areas of the pieces, where the manifest asks for them: of each an array
        for each row of `results`; empty for a job that failed."""
        name = self._operation(operation)
        rows = self.results(name)["job"]
        view = operations()[name].view
        texts = dict(self.sql(f'SELECT job, lists FROM "{view}"'))
        parsed = [json.loads(texts.get(int(job)) or "{}") for job in rows]
        return {
            key: [np.array(one.get(key, []), dtype=np.float64) for one in parsed] for key in operations()[name].lists
        }

    def to_pandas(self, operation: str | None = None, *, lists: bool = False) -> pandas.DataFrame:
        """`results` as a DataFrame; with `lists` a column of arrays for each list too."""
        import pandas

        table = self.results(operation)
        frame = pandas.DataFrame({name: table[name] for name in _names(table)})
        for name, column in self.lists(operation).items() if lists else ():
            frame[name] = column
        return frame

    def to_xarray(self, operation: str | None = None) -> xarray.Dataset:
        """`results` as a Dataset along the dimension `job`: which job a row is and what a grid varies are coordinates,
        numbers are variables with `units` and `long_name`; attributes say which program computed them from what."""
        import xarray

        name = self._operation(operation)
        table = self.results(name)
        about = {column.name: column for column in operations()[name].columns}
        data = {
            key: ("job", table[key], {"units": column.unit, "long_name": column.meaning}) for key, column in about.items()
        }
        keys = {key: ("job", table[key]) for key in _names(table) if key not in about}
        last = self.runs[-1]
        return xarray.Dataset(
            data,
            coords=keys,
            attrs={
                "operation": name,
                "source": f"lober {last.version} ({last.commit})",
                "history": f"{last.started} lober batch run on {last.host}",
                "manifest": last.manifest,
            },
        )

    def export(self, path: str | os.PathLike[str], format: str = "", *, operation: str | None = None) -> Jobs:
        """Writes a table: .csv, .jsonl (with lists and messages), .npy or .nc by the ending, or by `format`. Returns how
        many jobs are in it. Raises UsageError, DataError."""
        return Jobs(**_lober.batch_export(self.path, os.fspath(path), format, operation))

    # ----------------------------------------------------------------------------------------------------------- SQL

    def connect(self) -> sqlite3.Connection:
        """A connection that only reads, for pandas.read_sql and the like; `.schema` of sqlite3 shows the views."""
        uri = Path(self.path).absolute().as_uri() + "?mode=ro"
        try:
            return sqlite3.connect(uri, uri=True)
        except sqlite3.Error as error:
            raise UsageError(f"{self.path}: {error}") from None

    def sql(self, query: str, parameters: Sequence[Any] = ()) -> list[Any]:
        """The rows that a query finds: `SELECT curve1, curve2, area FROM overlaps WHERE crossings > 0`. Each operation
        has a view, `results` and `failures` are views of all (docs/reference/batch.md)."""
        connection = self.connect()
        try:
            return connection.execute(query, parameters).fetchall()
        except sqlite3.Error as error:
            raise UsageError(f"{self.path}: {error}") from None
        finally:
            connection.close()

    # --------------------------------------------------------------------------------------------------------- shown

    def _operation(self, operation: str | None) -> str:
        known = self.operations
        if operation is None and len(known) == 1:
            return known[0]
        if operation not in known:
            named = "the plan has several operations" if operation is None else f"the plan has no operation {operation!r}"
            raise UsageError(f"{self.path}: {named}; choose one of {', '.join(known)}")
        return operation

    def __repr__(self) -> str:
        jobs = self.jobs
        more = f", {jobs.missing} to do" if jobs.missing else ""
        return f"<Store {self.path}: {', '.join(self.operations)}, {jobs.done} jobs done, {jobs.failed} failed{more}>"

    def _repr_html_(self) -> str:
        head = html.escape(repr(self)[1:-1])
        if len(self.operations) != 1:
            return f"<p>{head}</p>"
        table = self.results()
        names = [name for name in _names(table) if name not in ("job", "failed", "group", "options", "message")][:8]
        rows = [[f"{row[name]:.6g}" if isinstance(row[name], float) else html.escape(str(row[name])) for name in names] for row in table[:10]]
        more = f"<p>and {len(table) - 10} more</p>" if len(table) > 10 else ""
        return f"<p>{head}</p>" + html_table(names, rows) + more


@dataclass(frozen=True)
class Column:
    """A number of a result."""

    name: str
    unit: str
    meaning: str


@dataclass(frozen=True)
class Operation:
    """An operation that a manifest can name."""

    summary: str
    columns: list[Column]
    lists: list[str]
    #: The view of its results, for SQL.
    view: str


def operations() -> dict[str, Operation]:
    """The operations that a manifest can name, with the columns of their results. Options are those of
    [the operation](docs/reference.md); those of systems are named in the manifest too."""
    return {
        name: Operation(one["summary"], [Column(*column) for column in one["columns"]], one["lists"], one["view"])
        for name, one in _lober.batch_operations().items()
    }


def _names(table: NDArray[Any]) -> tuple[str, ...]:
    return table.dtype.names or ()


def _texts(column: NDArray[Any]) -> NDArray[Any]:
    try:
        return column.astype("U")
    except UnicodeDecodeError:  # slower, for what is not ASCII
        return np.char.decode(column, "utf-8", "replace")
