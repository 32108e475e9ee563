"""The part of a batch that Dask's workers execute; imported there by name, so that lober has to be installed on each."""

from __future__ import annotations

import os
import shutil
import tempfile
import threading
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from . import _lober
from .errors import Error

#: Part of a worker's memory that is for curves and the work on them; Dask pauses a worker at 0.8 of its limit.
MEMORY_PART = 0.6
#: Part of it that curves keep between two runs, so that other work finds room.
REST_PART = 0.15
#: Curves that the tasks of this process share, as long as their files stay what they are; made by the first of them.
KEPT: Any = None
LOCK = threading.Lock()
#: Files that came with tasks, below the worker's own folder; removed with it.
COPIES = "lober-inputs"


@dataclass(frozen=True)
class Work:
    """The common part of all portions of a run."""

    version: str
    #: Absolute folder of the manifest, and how messages name it: "" or with a slash at its end.
    folder: str
    shown_folder: str
    store: str
    output_root: str
    threads: int
    memory: int
    #: Name of the folder of this run's copies on a worker; other runs have others.
    run: str = ""


@dataclass(frozen=True)
class Portion:
    """Jobs for one task. Not a tuple or a list: Dask looks for futures in those, name by name."""

    #: As SharedRun.encoded.
    plan: bytes
    #: Absolute paths of the inputs, which have to be there.
    files: list[str]


class Done(NamedTuple):
    """The results of a portion, as bytes for the store."""

    results: bytes
    points: int
    seconds: float
    #: A line for each curve or pair whose results may not mean what a user thinks.
    warnings: list[str]


class Unfit(NamedTuple):
    """Why a worker cannot compute a portion, which another one may."""

    worker: str
    why: str
    #: The other version of lober; empty where an input is missing, and then which one.
    version: str = ""
    missing: str = ""


def compute(work: Work, portion: Portion, contents: dict[str, bytes] | None) -> Done | Unfit:
    """With `contents` the files come along: it has a path for each of them, of a file beside a shapefile too."""
    try:
        return _computed(work, portion, contents)
    except (Error, MemoryError):
        raise
    except Exception as error:
        # Dask sends exceptions pickled; of one that cannot be, the client never hears.
        raise RuntimeError(f"{type(error).__name__}: {error}") from None


def _computed(work: Work, portion: Portion, contents: dict[str, bytes] | None) -> Done | Unfit:
    worker = _worker()
    address = worker.address if worker is not None else "here"
    if work.version != _lober.__version__:
        return Unfit(address, f"has lober {_lober.__version__}", _lober.__version__)
    root = ""
    if contents is not None:
        root = _copied(work.run, contents, worker)
    else:
        missing = next((file for file in portion.files if not os.path.exists(file)), None)
        if missing is not None:
            return Unfit(address, f"does not find {missing}", missing=missing)
    # "/." tells names relative to the manifest, in messages, from absolute ones below the same folder.
    folder = root + work.folder.rstrip("/") + "/."
    names = [(folder + "/", work.shown_folder), (root, "")]
    memory = work.memory or _memory(worker)
    done = _lober.run_portion(
        portion.plan,
        os.path.join(folder, "manifest.toml"),
        files_root=root,
        output_root=work.output_root,
        store=work.store,
        threads=work.threads,
        memory=memory,
        names=names,
        kept=_kept(memory * _threads(worker)),
    )
    return Done(*done)


def _kept(budget: int) -> Any:
    """The curves of the tasks before, which keep room for those that run."""
    global KEPT
    with LOCK:
        if KEPT is None:
            KEPT = _lober.kept_curves()
        KEPT.set_budget(budget)
        return KEPT


def _worker() -> Any:
    """The worker that executes this task; None outside of one."""
    from distributed import get_worker

    try:
        return get_worker()
    except ValueError:
        return None


def _memory(worker: Any) -> int:
    """The share of one task; 0, half of the machine's, where the worker has no limit."""
    return int(MEMORY_PART * _limit(worker) / _threads(worker))


def _limit(worker: Any) -> int:
    return (worker.memory_manager.memory_limit or 0) if worker is not None else 0


def _threads(worker: Any) -> int:
    return int(worker.state.nthreads) if worker is not None else 1


def _copied(run: str, contents: dict[str, bytes], worker: Any) -> str:
    """Writes the files that are not there yet below a folder, each at its absolute path, and returns the folder."""
    base = Path(worker.local_directory if worker is not None else tempfile.gettempdir())
    root = str(base.resolve() / COPIES / run)
    for path, content in contents.items():
        target = root + path
        if os.path.exists(target) and Path(target).read_bytes() == content:
            continue
        os.makedirs(os.path.dirname(target), exist_ok=True)
        handle, part = tempfile.mkstemp(dir=os.path.dirname(target))
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        os.replace(part, target)  # two tasks of a worker may write the same file
    return root


def rest(run: str, dask_worker: Any) -> None:
    """At the end of a run: removes its copies, and all curves but those that a next run may use."""
    shutil.rmtree(Path(dask_worker.local_directory).resolve() / COPIES / run, ignore_errors=True)
    if KEPT is not None:
        KEPT.set_budget(int(REST_PART * _limit(dask_worker)) or 1)  # nothing where the worker has no limit: 0 is a share of all
