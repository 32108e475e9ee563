"""Batches on a cluster of Dask: a real scheduler and workers that are processes of their own, some of which are ended."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import lober

distributed = pytest.importorskip("distributed", reason="python3-distributed is not installed")
import psutil  # noqa: E402, which distributed needs

from dask_cluster import Cluster, wait_until  # noqa: E402

pytestmark = [
    # Those of Dask and of what it uses.
    pytest.mark.filterwarnings("ignore::DeprecationWarning"),
    pytest.mark.filterwarnings("ignore::ResourceWarning"),
    pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning"),
    pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning"),
    pytest.mark.filterwarnings("ignore::lober.IncompleteWarning"),
]

PAIRS = 'operation = "overlay"\ncurves = "c*"\npairs = "all"\noptions = { lobes = true }\n'
SINGLES = 'operation = "interior"\ncurves = "c*.npy"\npairs = { lag = 1 }\n'


@pytest.fixture(scope="module")
def cluster(tmp_path_factory):
    made = Cluster(tmp_path_factory.mktemp("cluster"))
    made.start_scheduler()
    yield made
    made.end()


@pytest.fixture(autouse=True)
def no_workers_left(request):
    yield
    if "cluster" in request.fixturenames:
        cluster = request.getfixturevalue("cluster")
        cluster.end_workers()


def flower(count: int, k: int) -> np.ndarray:
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    return (1 + 0.3 * np.cos((5 + k % 7) * angle + 0.1 * k)) * np.exp(1j * angle) + 0.003 * k


def family(folder: Path, manifest: str, count: int = 40, points: int = 500, bad: bool = True) -> Path:
    """Curves c000, c001, ..., one that crosses itself, a file that cannot be read, and the manifest."""
    for k in range(count):
        lober.write(folder / f"c{k:03}.npy", flower(points, k))
    if bad:
        (folder / "c_bad.csv").write_text("x,y\n0,0\n1,1\n1,0\n0,1\n")
        (folder / "c_worse.csv").write_text("x,y\n0,0\n1,what\n1,0\n")
    (folder / "job.toml").write_text(manifest)
    return folder / "job.toml"


def exported(store: lober.batch.Store) -> bytes:
    path = Path(store.path + ".jsonl")
    store.export(path)
    return path.read_bytes()


def expected(manifest: Path) -> bytes:
    """The export of one process."""
    return exported(lober.batch.run(manifest, manifest.with_name("one"), threads=1))


def shared(manifest: Path, client, store: str = "shared", **options) -> lober.batch.Store:
    return lober.batch.run(manifest, manifest.with_name(store), client=client, **options)


class during:
    """A function on a thread beside the block; what it raises comes out at the end."""

    def __init__(self, function) -> None:
        self._function = function
        self._error = None
        self._thread = threading.Thread(target=self._run)

    def _run(self) -> None:
        try:
            self._function()
        except BaseException as error:  # noqa: BLE001
            self._error = error

    def __enter__(self) -> None:
        self._thread.start()

    def __exit__(self, *_) -> None:
        self._thread.join()
        if self._error is not None:
            raise self._error


# As if portions took longer, so that there is time to disturb them.
SLOW = """
import time
import lober._dask_worker as tasks
tasks.plain = getattr(tasks, "plain", tasks.compute)  # a preload runs twice
def compute(*given):
    time.sleep(0.2)
    return tasks.plain(*given)
tasks.compute = compute
"""


def test_same_bytes_as_one_process(cluster, tmp_path, monkeypatch):
    cluster.start_workers(2)
    manifest = family(tmp_path, PAIRS)
    whole = expected(manifest)
    assert b"c_bad.csv: is not simple" in whole and f"{tmp_path}/c_worse.csv".encode() in whole
    with cluster.client(2) as client:
        seen = []
        store = shared(manifest, client, progress=lambda fraction, text: seen.append((fraction, text)))
        assert exported(store) == whole
        assert (store.report.jobs, store.report.run, store.report.failed) == (861, 861, 81)
        assert store.report.points > 0 and store.report.threads == 2
        assert seen and all(0 <= fraction <= 1 and "of 861 jobs on" in text for fraction, text in seen)
        again = shared(manifest, client)
        assert (again.report.finished_before, again.report.run) == (780, 81)
        assert exported(again) == whole
        # Relative to the working folder, with contents sent along, absolute names, and from a dictionary.
        monkeypatch.chdir(tmp_path)
        relative = exported(lober.batch.run("job.toml", "one-relative"))
        assert relative != whole  # messages name files as the manifest finds them
        for scatter in (False, True):
            assert exported(lober.batch.run("job.toml", f"r{scatter}", client=client, scatter=scatter)) == relative
        by_name = {"operation": "overlay", "curves": [f"{tmp_path}/c_*", f"{tmp_path}/c00*"], "pairs": "all"}
        for scatter in (False, True):
            one, two = lober.batch.run(by_name), lober.batch.run(by_name, client=client, scatter=scatter)
            assert exported(one) == exported(two)


def test_workers_keep_curves(cluster, tmp_path):
    cluster.start_workers(2)
    manifest = family(tmp_path, PAIRS, count=60, points=2000, bad=False)
    time.sleep(2.1)  # a younger file is read each time
    kept_counts = lambda: sys.modules["lober._dask_worker"].KEPT.counts  # noqa: E731, which Dask sends by value
    with cluster.client(2) as client:
        first = exported(shared(manifest, client, "first"))
        for store in ("second", "third"):
            assert exported(shared(manifest, client, store)) == first
        # Each worker has read each curve once at most, for all portions of three runs.
        both = list(client.run(kept_counts).values())
        for counts in both:
            assert counts["kept"] == counts["curves"] <= 60
            assert counts["occupied_bytes"] == 0 and counts["dropped"] == 0
        assert sum(counts["found"] for counts in both) > sum(counts["kept"] for counts in both)
        # Of the same size, and in place of the other.
        lober.write(tmp_path / "c003.npy", flower(2000, 77))
        os.replace(tmp_path / "c004.npy", tmp_path / "c005.npy")
        lober.write(tmp_path / "c004.npy", flower(2000, 78))
        changed = exported(shared(manifest, client, "fourth"))
        assert changed != first and changed == expected(manifest)
        # In little memory: room for two curves.
        memory = 2 * 2000 * 21
        assert exported(shared(manifest, client, "little", memory=memory)) == changed
        for counts in client.run(kept_counts).values():
            assert counts["idle_bytes"] <= memory and counts["dropped"] > 0 and counts["occupied_bytes"] == 0


def test_files_that_vanish(cluster, tmp_path):
    """Jobs fail that have not begun, as in one process, and the rest goes on."""
    cluster.start_workers(2, preload=SLOW)
    manifest = family(tmp_path, PAIRS, count=60, points=3000, bad=False)
    gone = []

    def vanish(fraction, text):
        if fraction > 0.1 and not gone:
            gone.append([(tmp_path / f"c{k:03}.npy").unlink() for k in (3, 58)])
        return True

    with cluster.client(2) as client:
        store = shared(manifest, client, progress=vanish)
    assert gone and store.report.run == 1770
    # Failures of a curve that others have read before are counted and not stored.
    assert 0 < store.report.failed <= 117 and store.jobs.failed <= store.report.failed
    assert {one.message.split(": ")[-1] for one in store.failures} <= {"No such file or directory"}


@pytest.mark.parametrize("limit, left", [(10**9, 9), (None, 0)])
def test_curves_at_rest(tmp_path, monkeypatch, limit, left):
    """Between runs a worker keeps curves in a part of its memory, none if that has no limit."""
    from lober import _dask_worker as tasks
    from lober import _lober

    monkeypatch.setattr(tasks, "KEPT", None)
    manifest = family(tmp_path, SINGLES, count=9, bad=False)
    time.sleep(2.1)  # as above
    run = _lober.start_shared_run(str(manifest), None, store=str(tmp_path / "s"), threads=1)
    _lober.run_portion(run.encoded(range(run.pending)), str(manifest), threads=1, kept=tasks._kept(0))
    assert tasks.KEPT.counts["curves"] == 9
    memory = SimpleNamespace(memory_limit=limit)
    tasks.rest("none", SimpleNamespace(local_directory=str(tmp_path), memory_manager=memory))
    assert tasks.KEPT.counts["curves"] == left


def test_two_runs_at_once_share_workers(cluster, tmp_path):
    cluster.start_workers(2)
    manifest = family(tmp_path, PAIRS, count=60, points=2000)
    whole = expected(manifest)
    with cluster.client(2) as client, cluster.client(2) as other:
        stores = []
        with during(lambda: stores.append(shared(manifest, other, "other"))):
            stores.append(shared(manifest, client))
        assert [exported(store) for store in stores] == [whole, whole]
        # Into one store: one of them is told, or finds the results of the other one.
        with during(lambda: stores.append(shared(manifest, other, "both"))):
            stores.append(shared(manifest, client, "both"))
        assert exported(stores[-1]) == whole


def test_workers_killed_at_random(cluster, tmp_path):
    (nanny,) = cluster.start_workers(4, nanny=True, preload=SLOW)
    manifest = family(tmp_path, PAIRS, count=90, points=3000)
    whole = expected(manifest)
    chance = random.Random(7)
    killed = []

    def children() -> list[int]:
        return [one.pid for one in psutil.Process(nanny.pid).children() if "spawn_main" in " ".join(one.cmdline())]

    def kill() -> None:
        while not over.wait(chance.uniform(0.1, 0.5)) and len(killed) < 6:
            if candidates := children():
                pid = chance.choice(candidates)
                os.kill(pid, signal.SIGKILL)
                killed.append(pid)

    over = threading.Event()
    with cluster.client(4) as client:
        with during(kill):
            try:
                store = shared(manifest, client)
            finally:
                over.set()
    assert exported(store) == whole
    assert len(killed) >= 3


def test_scheduler_started_again(tmp_path):
    cluster = Cluster(tmp_path)
    cluster.start_scheduler()
    try:
        cluster.start_workers(2, preload=SLOW)
        manifest = family(tmp_path, PAIRS, count=60, points=3000)
        whole = expected(manifest)
        restarted = []

        def restart() -> None:
            wait_until(lambda: some.is_set())
            cluster.scheduler.kill()
            cluster.scheduler.wait()
            cluster.end_workers()
            cluster.start_scheduler()
            cluster.start_workers(2, preload=SLOW)
            restarted.append(True)

        some = threading.Event()
        with cluster.client(2) as client:
            with during(restart):
                store = shared(manifest, client, progress=lambda fraction, text: fraction > 0.05 and some.set() or True)
            assert restarted
        assert exported(store) == whole
        # And one that stays away: what came in is kept.
        with distributed.Client(cluster.address, timeout=1, set_as_default=False) as client:
            some.clear()
            with during(lambda: (wait_until(some.is_set), cluster.end())):
                with pytest.raises(lober.DataError, match="the scheduler is gone; what came in is in the store"):
                    shared(manifest, client, "second", progress=lambda fraction, text: fraction > 0.05 and some.set() or True)
        done = lober.batch.open(tmp_path / "second").jobs.done
        assert 0 < done < 1770
        assert exported(lober.batch.run(manifest, tmp_path / "second")) == whole
    finally:
        cluster.end()


def test_worker_that_joins_late(cluster, tmp_path):
    cluster.start_workers(1, preload=SLOW.replace("0.2", "0.5"))
    manifest = family(tmp_path, PAIRS, count=90, points=3000)
    some = threading.Event()
    with cluster.client(1) as client:
        before = set(client.scheduler_info()["workers"])
        with during(lambda: (wait_until(some.is_set), cluster.start_workers(1, preload=SLOW.replace("0.2", "0.5")))):
            store = shared(manifest, client, progress=lambda fraction, text: some.set() or True)
        counts = client.run(lambda dask_worker: dask_worker.state.executed_count)
    assert exported(store) == expected(manifest)
    (late,) = set(counts) - before
    assert counts[late] > 0
    assert store.report.threads == 2


# A portion in which the curve is ends its worker, as the out-of-memory killer or a fault in a library would.
POISON = """
import os
import lober._dask_worker as tasks
tasks.plain = getattr(tasks, "plain", tasks.compute)  # a preload runs twice
def compute(work, portion, contents):
    if any(file.endswith("c007.npy") for file in portion.files):
        os._exit(9)
    return tasks.plain(work, portion, contents)
tasks.compute = compute
"""


def test_jobs_that_end_their_workers_are_noted_and_the_rest_goes_on(tmp_path, monkeypatch):
    monkeypatch.setenv("DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES", "0")  # sooner than after four workers
    cluster = Cluster(tmp_path)
    cluster.start_scheduler()
    try:
        cluster.start_workers(2, nanny=True, preload=POISON)
        manifest = family(tmp_path, SINGLES, count=9, bad=False)
        with cluster.client(2) as client:
            store = shared(manifest, client)
    finally:
        cluster.end()
    failures = [(one.message, one.jobs) for one in store.failures]
    assert failures == [("every worker that ran it alone ended (1 tried)", 2)]
    assert (store.report.run, store.report.failed) == (8, 2)
    # Noted as failed, so that a run elsewhere does them.
    assert exported(lober.batch.run(manifest, store.path)) == expected(manifest)


FAULT = POISON.replace("os._exit(9)", 'raise RuntimeError("this worker is not well")')


def test_a_task_that_fails_for_good_ends_the_run_and_keeps_results(cluster, tmp_path):
    cluster.start_workers(1, preload=FAULT)
    manifest = family(tmp_path, SINGLES, count=24, points=20000, bad=False)
    with cluster.client(1) as client:
        with pytest.raises(RuntimeError, match="this worker is not well"):
            shared(manifest, client)
    assert lober.batch.open(tmp_path / "shared").runs[-1].how == "broken off by a failure"
    assert exported(lober.batch.run(manifest, tmp_path / "shared")) == expected(manifest)


# A machine on which the folder is not mounted.
BLIND = """
import os
import lober._dask_worker as tasks
class path:
    join = os.path.join
    dirname = os.path.dirname
    exists = staticmethod(lambda path: not path.startswith("FOLDER") and os.path.exists(path))
class blind:
    path = path
    fdopen = os.fdopen
    makedirs = os.makedirs
    replace = os.replace
tasks.os = blind
"""


def test_workers_without_the_files(cluster, tmp_path):
    blind = cluster.start_workers(1, preload=BLIND.replace("FOLDER", str(tmp_path)))
    manifest = family(tmp_path, PAIRS)
    whole = expected(manifest)
    with cluster.client(1) as client:
        with pytest.raises(lober.DataError, match=r"no worker can compute this, of 1: tcp:.* does not find .*c0"):
            shared(manifest, client)
        assert exported(shared(manifest, client, "sent", scatter=True)) == whole
        cluster.start_workers(1)
        client.wait_for_workers(2, timeout=60)
        assert exported(shared(manifest, client)) == whole
    assert blind[0].poll() is None


def test_other_versions_and_wrong_calls(cluster, tmp_path):
    manifest = family(tmp_path, PAIRS, count=3)
    with pytest.raises(TypeError, match="client has to be a distributed.Client, not str"):
        shared(manifest, cluster.address)
    with pytest.raises(lober.UsageError, match="scatter is for the workers of a client"):
        lober.batch.run(manifest, scatter=True)
    cluster.start_workers(1, preload='import lober._lober\nlober._lober.__version__ = "0.0.1"\n')
    with cluster.client(1) as client:
        with pytest.raises(lober.UsageError, match=r"has lober 0\.0\.1, and this is lober .*; install the same version"):
            shared(manifest, client)
        with pytest.raises(lober.UsageError, match="curvs"):
            lober.batch.run({"operation": "overlay", "curvs": "c*"}, client=client)
        manifest.write_text('operation = "densify"\ncurves = "c*.npy"\noptions = { max_length = 1, output = "{name}.fine" }\n')
        with pytest.raises(lober.UsageError, match="do without scatter"):
            shared(manifest, client, scatter=True)


def command(*arguments: object, **options) -> subprocess.Popen[str]:
    line = [sys.executable, "-P", "-W", "ignore", "-m", "lober._dask_command", *map(str, arguments)]
    return subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)


def has_results(store):
    """Whether a store that is being made has results by now."""
    try:
        return store.exists() and len(lober.batch.open(store)) > 0
    except lober.DataError:
        return False


def test_command(cluster, tmp_path):
    cluster.start_workers(1, preload=SLOW)
    manifest = family(tmp_path, PAIRS)
    whole = expected(manifest)
    run = command(manifest, "--scheduler", cluster.address, "--store", tmp_path / "s", "--quiet", "--memory", "100M")
    out, err = run.communicate()
    assert run.returncode == 1 and "81 jobs failed, first" in err
    assert out.startswith("861 jobs: 0 done before, 861 run, 81 failed\n")
    assert exported(lober.batch.open(tmp_path / "s")) == whole
    for arguments, status, message in [
        ([tmp_path / "none.toml", "--scheduler", cluster.address], 1, "none.toml"),
        ([manifest, "--scheduler", cluster.address, "--memory", "much"], 2, "--memory: 'much' is not a size"),
        ([manifest, "--scheduler", "tcp://127.0.0.1:1", "--wait", "0.2"], 1, "there is no scheduler at tcp://127.0.0.1:1"),
        ([manifest, "--scheduler-file", tmp_path / "none", "--wait", "0.2"], 1, "none (the file does not exist)"),
        ([manifest, "--scheduler", cluster.address, "--shard", "3/2"], 2, "--shard: '3/2' is not of the form I/N"),
        ([manifest], 2, "one of the arguments --scheduler --scheduler-file is required"),
    ]:
        run = command(*arguments)
        assert message in run.communicate()[1]
        assert run.returncode == status, arguments
    # Interrupted in the middle, and gone on with.
    for left in tmp_path.glob("c_*"):
        left.unlink()
    manifest = family(tmp_path, PAIRS, count=90, points=3000, bad=False)
    run = command(manifest, "--scheduler", cluster.address, "--store", tmp_path / "broken", stdin=subprocess.DEVNULL)
    wait_until(lambda: has_results(tmp_path / "broken"))
    run.send_signal(signal.SIGINT)
    assert "the same line goes on from there" in run.communicate()[1] and run.returncode == 130
    assert lober.batch.open(tmp_path / "broken").runs[-1].how == "stopped"
    run = command(manifest, "--scheduler", cluster.address, "--store", tmp_path / "broken", "-q")
    assert "0 failed" in run.communicate()[0] and run.returncode == 0
    assert exported(lober.batch.open(tmp_path / "broken")) == expected(manifest)


def longitudes(folder: Path) -> Path:
    """A box in longitudes from -180 to 180, one in those from 0 to 360, and some across the date line."""
    ends = {"west": (-170, -166), "east": (191, 195), **{f"line{k}": (178, -178) for k in range(12)}}
    for name, (w, e) in ends.items():
        (folder / name).write_text(f"lon,lat\n{w},10\n{e},10\n{e},14\n{w},14\n")
    (folder / "job.toml").write_text('operation = "overlay"\ncurves = ["west", "east", "line*"]\npairs = "all"\n')
    return folder / "job.toml"


def test_warnings_arrive(cluster, tmp_path, monkeypatch):
    cluster.start_workers(2)
    manifest = longitudes(tmp_path)
    monkeypatch.chdir(tmp_path)
    with cluster.client(2) as client:
        for given in (manifest, "job.toml"):
            with pytest.warns(UserWarning) as warned:
                one = lober.batch.run(given, tmp_path / "one")
            assert len(warned) == len(one.report.warnings) == 13, one.report.warnings
            assert any("line3: its segment 0 runs back across the whole map" in line for line in one.report.warnings)
            assert any("those of east from 191 to 195" in line for line in one.report.warnings)
            for scatter in (False, True):
                with pytest.warns(UserWarning) as warned:
                    many = lober.batch.run(given, tmp_path / f"many{scatter}", client=client, scatter=scatter)
                assert many.report.warnings == one.report.warnings
                assert [str(line.message) for line in warned] == one.report.warnings
                (tmp_path / f"many{scatter}").unlink()
            (tmp_path / "one").unlink()
        # Those of the jobs that run, and no others.
        with pytest.warns(UserWarning, match="those of east"):
            again = lober.batch.run(manifest, tmp_path / "again", client=client, shard=(1, 91))
        assert again.report.run == len(again.report.warnings) == 1
    run = command("job.toml", "--scheduler", cluster.address, "--quiet")
    out, err = run.communicate()
    assert run.returncode == 0 and out.startswith("91 jobs: 0 done before, 91 run, 0 failed\n")
    # The program's own lines, and no others.
    assert err == "".join(f"lober-dask: {line}\n" for line in one.report.warnings)
    for k in range(12, 30):
        (tmp_path / f"line{k}").write_text((tmp_path / "line3").read_text().replace("14", f"{k}"))
    err = command("job.toml", "--scheduler", cluster.address, "--quiet").communicate()[1]
    assert err.count("\n") == 21 and err.endswith("lober-dask: and 10 more such lines\n"), err


@pytest.mark.parametrize("two", [False, True])
def test_overlap_matrix(cluster, two):
    cluster.start_workers(2)
    curves = [flower(200, k) + 0.4 * np.exp(1j * k) for k in range(31)]
    others = [flower(150, k) - 0.2 for k in range(17)] if two else None
    names = ["intersection", "c1_minus_c2", "c2_minus_c1", "crossings", "union", "rounding_c1_minus_c2"]
    with cluster.client(2) as client:
        seen = []
        one = lober.overlap_matrix(curves, others, names)
        shared = lober.overlap_matrix(curves, others, names, client=client, progress=lambda f, _: seen.append(f))
        for name in names:
            np.testing.assert_array_equal(shared[name], one[name], strict=True)
        assert seen[-1] == 1 and len(seen) > 4
        far = [curve + 3 * (k % 4) for k, curve in enumerate(curves)]
        one, shared = (lober.overlap_matrix(far, others, "crossings", sparse=True, client=c) for c in (None, client))
        for part in ("data", "indices", "indptr"):
            np.testing.assert_array_equal(getattr(shared, part), getattr(one, part))
        # Curves that cannot be used have the numbers that they have in the whole.
        curves[20] = np.array([0, 1 + 1j, 1, 1j])
        if two:
            others[16] = np.array([0, 1 + 1j, 1, 1j])
        messages, matrices = [], []
        for c in (None, client):
            with pytest.raises(lober.DataError) as error:
                lober.overlap_matrix(curves, others, client=c)
            with pytest.warns(lober.IncompleteWarning) as warned:
                matrices.append(lober.overlap_matrix(curves, others, keep_going=True, client=c))
            messages.append((str(error.value), str(warned[0].message)))
        assert messages[0] == messages[1] and "curve 20" in messages[0][0]
        np.testing.assert_array_equal(*matrices)
        with pytest.raises(lober.UsageError, match="offsets ascend"):
            lober.overlap_matrix((np.zeros((9, 2)), [0, 6, 3, 9]), client=client)
