"""Batches on a cluster of Dask: portions of the plan are tasks, and their results stream into one store.

Dask places the tasks, moves them to workers that are idle or join late, and starts them again elsewhere when a worker ends.
What it does not know stands here: which jobs share curves (the engine cuts the portions), workers that lack an input, jobs
that end every worker, a scheduler that is started again.
"""

from __future__ import annotations

import os
import queue
import time
import uuid
from dataclasses import dataclass, field
from typing import Any, Callable, Optional

from . import _lober
from ._dask_inputs import Scattered
from ._dask_worker import Done, Portion, Unfit, Work, compute, rest
from .errors import DataError, UsageError

Callback = Optional[Callable[[Optional[float], Optional[str]], Any]]

#: Tasks that wait at the scheduler, for each thread of the workers: none of them runs dry while results travel.
AHEAD = 2
#: Seconds between two looks at the workers.
LOOK = 1.0
#: Warnings of a run that are kept, as many as a run of one process keeps.
MAX_WARNINGS = 1000
#: How often an exception that is not the end of a worker is met with another try.
RETRIES = 2


@dataclass(eq=False)
class Task:
    """A portion that a worker is to compute."""

    jobs: list[int]
    future: Any = None
    #: It has ended workers and is to be the only one that runs.
    alone: bool = False


@dataclass
class Workers:
    """The workers, as of the last look."""

    threads: dict[str, int] = field(default_factory=dict)
    #: Those that lack an input, each with what it said.
    unfit: dict[str, str] = field(default_factory=dict)

    @property
    def slots(self) -> int:
        return max(1, sum(count for address, count in self.threads.items() if address not in self.unfit))

    @property
    def fit(self) -> list[str]:
        return [address for address in self.threads if address not in self.unfit]


def run_batch(
    client: Any, path: str, text: str | None, options: dict[str, Any], scatter: bool, progress: Callback
) -> dict[str, Any]:
    """As _lober.batch_run, by the workers of `client`; `memory` and `threads` of the options are those of a task."""
    require_client(client)
    begin = time.monotonic()
    options = {**options, "threads": options["threads"] or 1}
    output_root = options["output_root"]
    shared = _lober.start_shared_run(path, text, **options)
    parent = os.path.dirname(path)
    work = Work(
        version=_lober.__version__,
        folder=os.path.abspath(parent or "."),
        shown_folder=parent + "/" if parent and not parent.endswith("/") else parent,
        store=os.path.abspath(options["store"]),
        output_root=os.path.abspath(output_root) if output_root else "",
        threads=options["threads"],
        memory=options["memory"],
        run=uuid.uuid4().hex,
    )
    run = SharedBatch(client, shared, work, scatter, progress)
    how = "broken off by a failure"
    try:
        if scatter and shared.has_outputs:
            raise UsageError("jobs that write files need a folder that all workers share; do without scatter")
        run.to_the_end()
        how = "stopped" if run.stopped else "complete"
    except KeyboardInterrupt:
        how = "stopped"
        raise
    finally:
        run.close()
        shared.finish(how)
    return {
        **shared.report,
        "stopped": run.stopped,
        "warnings": sorted(run.warnings),
        "points": run.points,
        "threads": run.max_threads,
        "seconds": time.monotonic() - begin,
    }


class SharedBatch:
    """A run: what waits, what is under way, what has come in."""

    def __init__(self, client: Any, shared: Any, work: Work, scatter: bool, progress: Callback) -> None:
        self._client = client
        self._shared = shared
        self._work = work
        self._inputs = Scattered(client) if scatter else None
        self._progress = progress
        self._workers = Workers()
        self._looked = -LOOK
        self._waiting: list[Task] = []
        self._suspects: list[Task] = []
        self._under_way: set[Task] = set()
        self._ended: queue.SimpleQueue[Task] = queue.SimpleQueue()
        self._all_handed_out = False
        self._watched = time.monotonic()
        self.stopped = False
        self.points = 0
        self.warnings: set[str] = set()
        self.max_threads = 0

    # ------------------------------------------------------------------------------------------------------- the loop

    def to_the_end(self) -> None:
        while True:
            self._look()
            self._hand_out()
            if not self._under_way and not self._waiting and not self._suspects and self._all_handed_out:
                self._tell()  # also a batch that took no time
                return
            for task in self._come_back(0.1):
                self._take(task)
            if not self._goes_on():
                self.stopped = True
                return

    def close(self) -> None:
        """Takes back what is under way; tasks that run end by themselves."""
        if self._client.status != "running":
            return
        futures = [task.future for task in self._under_way]
        if futures:
            self._client.cancel(futures, force=True)
        self._client.run(rest, self._work.run, on_error="ignore")

    def _look(self) -> None:
        """Asks the scheduler who is there. A client whose scheduler is gone tries to find it for a while and then closes."""
        if self._client.status == "closed":
            raise DataError(
                "the scheduler is gone; what came in is in the store, and the same call goes on from there when it is back"
            )
        if time.monotonic() - self._looked < LOOK or self._client.status != "running":
            return
        self._looked = time.monotonic()
        try:
            self._workers.threads = dict(self._client.nthreads())
        except OSError:  # the client will notice
            return
        self.max_threads = max(self.max_threads, sum(self._workers.threads.values()))
        if self._workers.threads and not self._workers.fit:
            address, why = next(iter(self._workers.unfit.items()))
            raise DataError(
                f"no worker can compute this, of {len(self._workers.threads)}: {address} {why}; put the inputs where all workers "
                "find them under the same path, or send them along (scatter)"
            )

    def _hand_out(self) -> None:
        if self._client.status != "running" or not self._workers.threads:
            return
        ahead = AHEAD * self._workers.slots + 1
        while len(self._under_way) < ahead and not any(task.alone for task in self._under_way):
            task = self._next()
            if task is None:
                return
            self._submit(task)

    def _next(self) -> Task | None:
        if self._waiting:
            return self._waiting.pop()
        if not self._all_handed_out:
            jobs = self._shared.next_portion(self._workers.slots)
            if jobs:
                return Task(jobs)
            self._all_handed_out = True
        # What may end its worker runs when nothing else can be taken along.
        return self._suspects.pop() if self._suspects and not self._under_way else None

    def _submit(self, task: Task) -> None:
        files = [os.path.join(self._work.folder, file) for file in self._shared.files(task.jobs)]
        files = [file for file in files if os.path.exists(file)]  # without the others jobs fail, here as there
        contents = self._inputs.of(files) if self._inputs is not None else None
        task.future = _submitted(
            self._client,
            self._work,
            Portion(self._shared.encoded(task.jobs), files),
            contents,
            pure=False,
            retries=RETRIES,
            # A worker that joins and finds the inputs is taken at the next look.
            workers=self._workers.fit if self._workers.unfit else None,
            allow_other_workers=bool(self._workers.unfit),
        )
        self._under_way.add(task)
        task.future.add_done_callback(lambda _, task=task: self._ended.put(task))

    def _come_back(self, seconds: float) -> list[Task]:
        """The tasks that have ended since, after at most so long."""
        tasks = []
        try:
            tasks.append(self._ended.get(timeout=seconds))
            while True:
                tasks.append(self._ended.get_nowait())
        except queue.Empty:
            return tasks

    def _goes_on(self) -> bool:
        if time.monotonic() - self._watched < 0.1:
            return True
        self._watched = time.monotonic()
        return self._tell()

    def _tell(self) -> bool:
        if self._progress is None:
            return True
        done, failed = (self._shared.report[name] for name in ("run", "failed"))
        text = f"{done} of {self._shared.pending} jobs on {len(self._workers.threads)} workers"
        text += f", {failed} failed" if failed else ""
        return self._progress(done / max(1, self._shared.pending), text) is not False

    # ----------------------------------------------------------------------------------------------- what comes back

    def _take(self, task: Task) -> None:
        self._under_way.discard(task)
        future, task.future = task.future, None
        if future.status == "error":
            self._failed(task, future.exception())
        elif future.status == "finished":
            try:
                self._came(task, future.result())
            except (OSError, _cancelled()):  # the worker that had it, or the scheduler, has gone since
                self._waiting.append(task)
        else:  # cancelled: scheduler or scattered inputs have gone
            self._waiting.append(task)

    def _came(self, task: Task, outcome: Done | Unfit) -> None:
        if isinstance(outcome, Unfit):
            if outcome.version:
                raise UsageError(
                    f"the worker {outcome.worker} {outcome.why}, and this is lober {self._work.version}; install the same version"
                )
            if os.path.exists(outcome.missing):  # else it has gone here too, since it was asked for, and its jobs fail
                self._workers.unfit[outcome.worker] = outcome.why
            self._waiting.append(task)
            return
        self._shared.add(task.jobs, outcome.results)
        self.points += outcome.points
        for line in outcome.warnings:
            if len(self.warnings) < MAX_WARNINGS:
                self.warnings.add(line)

    def _failed(self, task: Task, error: BaseException) -> None:
        """A task that ended its workers is parted until the job is found that does it. All tasks of a worker count as
        suspicious to Dask, so that one is accused for good only after it has run alone."""
        if not isinstance(error, (_killed(), MemoryError)):
            raise error
        middle = len(task.jobs) // 2
        if middle > 0:
            self._waiting += [Task(task.jobs[:middle]), Task(task.jobs[middle:])]
        elif not task.alone:
            self._suspects.append(Task(task.jobs, alone=True))
        elif isinstance(error, MemoryError):
            self._shared.fail(task.jobs[0], "out of memory")
        else:
            count = getattr(error, "allowed_failures", 0) + 1
            self._shared.fail(task.jobs[0], f"every worker that ran it alone ended ({count} tried)")


def _submitted(client: Any, *given: Any, **how: Any) -> Any:
    """A function of its own, as Dask parses the source of the one that submits, for its dashboard, each time."""
    return client.submit(compute, *given, **how)


def _killed() -> type[BaseException]:
    from distributed.scheduler import KilledWorker

    return KilledWorker


def _cancelled() -> type[BaseException]:
    from concurrent.futures import CancelledError

    return CancelledError


def require_client(client: Any) -> None:
    try:
        from distributed import Client
    except ImportError:
        raise UsageError(
            "batches on a cluster need Dask: apt install python3-distributed, or pip install 'lober[dask]'"
        ) from None
    if not isinstance(client, Client):
        raise TypeError(f"client has to be a distributed.Client, not {type(client).__name__}")
    if client.asynchronous:
        raise UsageError("client is asynchronous; give one that is not")
