"""`lober-dask`: `lober batch run` by the workers of a cluster."""

from __future__ import annotations

import argparse
import os
import sys
import time
import warnings
from typing import Any, Sequence

from . import __version__, batch
from .errors import Cancelled, DataError, Error, UsageError

#: Warnings that are printed.
MAX_LINES = 20

UNITS = {"": 1, "K": 1 << 10, "M": 1 << 20, "G": 1 << 30, "T": 1 << 40}


def main(arguments: Sequence[str] | None = None) -> int:
    """The exit status: 0; 1 where jobs failed or something cannot be read; 2 for a wrong call; 130 for an interrupt."""
    given = _parser().parse_args(arguments)
    try:
        return _run(given)
    except (Cancelled, KeyboardInterrupt):
        line = "interrupted; results that came in are in the store, and the same line goes on from there"
        print(f"lober-dask: {line}", file=sys.stderr)
        return 130
    except UsageError as error:
        print(f"lober-dask: {error}", file=sys.stderr)
        return 2
    except (Error, OSError) as error:
        print(f"lober-dask: {error}", file=sys.stderr)
        return 1


def _run(given: argparse.Namespace) -> int:
    client = _client(given)
    try:
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", module=__name__.replace(".", r"\."))  # what follows says all of it
            store = batch.run(
                given.manifest,
                given.store,
                shard=_shard(given.shard),
                memory=_bytes(given.memory),
                output_root=given.output_root,
                threads=given.threads,
                progress=not given.quiet,
                client=client,
                scatter=given.scatter,
            )
    finally:
        client.close()
    report = store.report
    assert report is not None
    print(f"{report.jobs} jobs: {report.finished_before} done before, {report.run} run, {report.failed} failed")
    print(f"{report.seconds:.3f} s on {report.threads} threads of workers")
    print(f"results in {store.path}")
    if report.hidden:
        print(f"it has {report.hidden} results of another manifest or of earlier inputs too: tables show this manifest alone")
    if report.stored_meanwhile:
        print(f"{report.stored_meanwhile} results had been stored by another process meanwhile")
    _warn([f"{line}; it was done again" for line in report.damaged])
    _warn(report.warnings)
    if report.failed:
        first = store.failures[0]
        print(f"lober-dask: {report.failed} jobs failed, first {first.first}: {first.message}", file=sys.stderr)
        print(f"lober-dask: lober batch status {store.path} lists the messages", file=sys.stderr)
    return 1 if report.failed else 0


def _warn(lines: list[str]) -> None:
    for line in lines[:MAX_LINES]:
        print(f"lober-dask: {line}", file=sys.stderr)
    if len(lines) > MAX_LINES:
        print(f"lober-dask: and {len(lines) - MAX_LINES} more such lines", file=sys.stderr)


def _client(given: argparse.Namespace) -> Any:
    try:
        import distributed
    except ImportError:
        raise UsageError("this needs Dask: apt install python3-distributed, or pip install 'lober[dask]'") from None
    where = {"scheduler_file": given.scheduler_file} if given.scheduler_file else {"address": given.scheduler}
    make: Any = distributed.Client
    try:
        if given.scheduler_file:  # Dask would wait for ever
            _wait_for(given.scheduler_file, given.wait)
        # Long enough for a scheduler that is started again.
        return make(**where, timeout=given.wait, set_as_default=False)
    except (OSError, ValueError) as error:
        raise DataError(
            f"there is no scheduler at {given.scheduler_file or given.scheduler} ({error}); dask scheduler starts one"
        ) from None


def _wait_for(file: str, seconds: float) -> None:
    deadline = time.monotonic() + seconds
    while not os.path.exists(file):
        if time.monotonic() > deadline:
            raise FileNotFoundError("the file does not exist")
        time.sleep(0.1)


def _bytes(text: str) -> int:
    number, unit = (text[:-1], text[-1].upper()) if text[-1:].isalpha() else (text, "")
    try:
        value = float(number) * UNITS[unit]
    except (ValueError, KeyError):
        advice = "give bytes, or a number with K, M, G or T, such as 4G"
        raise UsageError(f"--memory: {text!r} is not a size; {advice}") from None
    if not 0 <= value < 1 << 62:
        raise UsageError(f"--memory: {text} is not a size of memory")
    return int(value)


def _shard(text: str) -> tuple[int, int]:
    number, slash, of = text.partition("/")
    if not (slash and number.isdecimal() and of.isdecimal() and 1 <= int(number) <= int(of)):
        raise UsageError(f"--shard: {text!r} is not of the form I/N with 1 <= I <= N")
    return int(number), int(of)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="lober-dask",
        description="Runs the jobs of a manifest that have no result in the store yet, by the workers of a cluster of Dask. "
        "The store is written here, and has the same results as that of lober batch run, which it goes on with and vice versa.",
        epilog="A cluster: dask scheduler on one machine, dask worker ADDRESS --nthreads 1 --nworkers auto on each of the "
        "others, where lober is installed in the same version.",
    )
    add = parser.add_argument
    add("manifest", metavar="MANIFEST", help="the manifest, a TOML file that names the operation and the curves")
    where = parser.add_mutually_exclusive_group(required=True)
    where.add_argument("--scheduler", metavar="ADDRESS", help="the address of the scheduler, as tcp://head:8786")
    where.add_argument("--scheduler-file", metavar="FILE", help="the file of dask scheduler --scheduler-file FILE")
    add("--store", metavar="FILE", help="the store of results (default: MANIFEST with the ending .results)")
    add(
        "--output-root",
        metavar="DIR",
        default="",
        help="the folder below which jobs write their files; all workers share it (default: the folder of the manifest)",
    )
    add(
        "--scatter",
        action="store_true",
        help="send the inputs to the workers, which do not see the files (default: all find them under the same path)",
    )
    add(
        "--memory",
        metavar="SIZE",
        default="0",
        help="memory of a task for curves and the work on them, as 4G or 500M (default: 0.6 of the worker's memory, shared "
        "by its threads)",
    )
    add(
        "--threads",
        metavar="N",
        type=int,
        default=1,
        help="threads of a task; each thread of a worker runs a task (default: 1)",
    )
    add(
        "--shard",
        metavar="I/N",
        default="1/1",
        help="the part of the jobs to run, into a store of its own; lober batch merge joins them (default: 1/1)",
    )
    add(
        "--wait",
        metavar="SECONDS",
        type=float,
        default=120,
        help="how long to look for a scheduler that is not there, or not any more (default: 120)",
    )
    add("-q", "--quiet", action="store_true", help="do not show the progress")
    add("--version", action="version", version=f"lober-dask {__version__}")
    return parser


if __name__ == "__main__":
    sys.exit(main())
