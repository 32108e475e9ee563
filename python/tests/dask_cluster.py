"""A scheduler of Dask and workers as processes of their own on this machine, for tests that end them."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path
from typing import Any


def free_port() -> int:
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Cluster:
    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._port = free_port()
        self.address = f"tcp://127.0.0.1:{self._port}"
        self.scheduler: subprocess.Popen[bytes] | None = None
        self.workers: list[subprocess.Popen[bytes]] = []
        self._files = 0

    def start_scheduler(self) -> None:
        self.scheduler = self._started("dask_scheduler", "--host", "127.0.0.1", "--port", str(self._port), "--no-show")

    def start_workers(self, count: int, *, preload: str = "", nanny: bool = False) -> list[subprocess.Popen[bytes]]:
        """Each with one thread; `preload` is a module that it executes first. With a nanny one process starts all of
        them, and each that ends again."""
        options = ["--nthreads", "1", "--memory-limit", "1GB", "--local-directory", str(self._folder / "workers")]
        if preload:
            self._files += 1
            path = self._folder / f"preload_{self._files}.py"
            path.write_text(preload)
            options += ["--preload", str(path)]
        if nanny:
            started = [self._started("dask_worker", self.address, "--nworkers", str(count), *options)]
        else:
            started = [self._started("dask_worker", self.address, "--no-nanny", *options) for _ in range(count)]
        self.workers += started
        return started

    def client(self, count: int, **options: Any) -> Any:
        """A client that waits until so many workers are there."""
        from distributed import Client

        client = Client(self.address, timeout=60, set_as_default=False, **options)
        client.wait_for_workers(count, timeout=60)
        return client

    def end_workers(self) -> None:
        for worker in self.workers:
            end(worker)
        self.workers = []

    def end(self) -> None:
        self.end_workers()
        if self.scheduler is not None:
            end(self.scheduler)

    def _started(self, program: str, *arguments: str) -> subprocess.Popen[bytes]:
        self._files += 1
        with open(self._folder / f"{program}_{self._files}.log", "wb") as log:
            return subprocess.Popen(
                [sys.executable, "-P", "-W", "ignore", "-m", f"distributed.cli.{program}", "--no-dashboard", *arguments],
                stdout=log,
                stderr=log,
                cwd=self._folder,
                start_new_session=True,
            )


def end(process: subprocess.Popen[bytes]) -> None:
    """A process with all that it has started."""
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    process.wait()


def wait_until(condition: Any, seconds: float = 240) -> None:
    deadline = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < deadline, "this takes too long"
        time.sleep(0.02)
