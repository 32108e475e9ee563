"""Progress, cancellation, interrupts and the GIL."""

from __future__ import annotations

import os
import signal
import threading
import time

import numpy as np
import pytest
from conftest import ring

import lober


def star(count: int, turns: int) -> np.ndarray:
    """A curve that crosses itself very often: work for seconds, all of it in one call."""
    t = 2 * np.pi * np.arange(count) / count
    z = np.exp(1j * t * turns) * (1 + 0.5 * np.cos(t * (turns + 1)))
    return np.stack([z.real, z.imag], axis=1)


def test_progress_is_called_and_can_cancel():
    seen = []
    first, second = ring(50000), ring(50000, 0.5)
    lober.overlay(first, second, progress=lambda fraction, text: seen.append((fraction, text)))
    assert len(seen) > 1 and seen == sorted(seen) and all(0 <= f <= 1 and t is None for f, t in seen)
    with pytest.raises(lober.Cancelled, match="cancelled"):
        lober.overlay(first, second, progress=lambda fraction, text: False)


def test_exceptions_of_a_callback_pass_through():
    class Mine(Exception):
        pass

    def fails(fraction, text):
        raise Mine("no")

    for function in (lober.overlay, lober.interior, lober.regions, lober.tangle):
        with pytest.raises(Mine, match="no"):
            function(ring(2000), ring(2000, 0.5), progress=fails)
    with pytest.raises(TypeError, match="callable"):
        lober.overlay(ring(20), ring(20), progress=3)


def test_answers_of_a_callback_that_are_neither_true_nor_false():
    """An array was a SystemError."""
    for answer in (np.zeros(3), np.ones((2, 2))):
        with pytest.raises(lober.UsageError, match="True, False or None, not ndarray"):
            lober.overlay(ring(2000), ring(2000, 0.5), progress=lambda fraction, text: answer)
    assert lober.overlay(ring(2000), ring(2000, 0.5), progress=lambda fraction, text: np.bool_(True)).crossings == 2
    with pytest.raises(lober.Cancelled):
        lober.overlay(ring(2000), ring(2000, 0.5), progress=lambda fraction, text: np.bool_(False))


def test_a_callback_may_call_lober():
    areas = []

    def inner(fraction, text):
        areas.append(lober.overlay(ring(50), ring(50, 0.5)).area.c1)

    lober.overlay(ring(5000), ring(5000, 0.5), progress=inner)
    assert areas and len(set(areas)) == 1


def test_bar(capsys):
    lober.overlay(ring(5000), ring(5000, 0.5), progress=True)
    shown = capsys.readouterr()
    assert "overlay [" in shown.err and "%" in shown.err and shown.out == ""
    assert shown.err.endswith("\r")


def test_other_threads_run_meanwhile():
    """The GIL is released: another thread counts while a long call works."""
    count = 0
    done = threading.Event()
    found = []

    def work():
        try:
            found.append(lober.regions(star(3000, 301), threads=1))
        finally:
            done.set()

    worker = threading.Thread(target=work)
    worker.start()
    begin = time.monotonic()
    while not done.is_set():
        count += 1
        time.sleep(0.001)
    took = time.monotonic() - begin
    worker.join()
    assert found and count > 100 * took


@pytest.mark.parametrize("handler", ["default", "silent"])
def test_interrupt(handler):
    """Ctrl-C ends a call of many seconds within half a second, with KeyboardInterrupt."""
    before = signal.getsignal(signal.SIGINT)
    if handler == "silent":
        signal.signal(signal.SIGINT, lambda *_: None)
    sent = []

    def interrupt():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.5, interrupt)
    curve, points = star(20000, 2001), np.random.default_rng(1).uniform(-1.5, 1.5, (1_000_000, 2))
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            lober.winding(curve, points)
        ended = time.monotonic()
        assert sent, "the call was over before the signal"
        assert ended - sent[0] < 0.5
    finally:
        timer.cancel()
        timer.join()
        signal.signal(signal.SIGINT, before)
    assert lober.overlay(ring(50), ring(50, 0.5)).crossings == 2


@pytest.mark.parametrize("threads", [-1, 4097, 100_000, 1_000_000_000])
def test_threads_that_no_machine_gives(threads):
    for call in (
        lambda: lober.overlay(ring(50), ring(50, 0.5), threads=threads),
        lambda: lober.section("standard", orbits=5, iterates=5, threads=threads),
        lambda: lober.system("standard").iterate(ring(50), threads=threads),
        lambda: lober.manifold_tangle("duffing", threads=threads),
    ):
        with pytest.raises(lober.UsageError, match=f"threads has to be 0 .* to 4096, not {threads}"):
            call()
    assert lober.overlay(ring(50), ring(50, 0.5), threads=4096).crossings == 2


def test_handler_is_put_back():
    before = signal.getsignal(signal.SIGINT)
    lober.overlay(ring(50), ring(50, 0.5))
    assert signal.getsignal(signal.SIGINT) is before
    with pytest.raises(KeyboardInterrupt):
        os.kill(os.getpid(), signal.SIGINT)
        time.sleep(1)


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda: lober.levels("capsize", grid=8000), TypeError, "grid has to be two numbers, not 8000"),
        (lambda: lober.levels("capsize", box=3), TypeError, "box has to be numbers, not 3"),
        (lambda: lober.fixed_point("henon", 3), TypeError, "near has to be two numbers, not 3"),
        (lambda: lober.fixed_point("henon", (1, 2, 3)), lober.UsageError, r"near has to be two numbers, not \(1, 2, 3\)"),
        (lambda: lober.fixed_point("henon", ("a", 2)), lober.UsageError, "near has to be a number, not the text 'a'"),
        (lambda: own_flow((0, 0, 1)), lober.UsageError, r"window has to be the four numbers x0, y0, x1, y1, not \(0, 0, 1\)"),
        (lambda: own_flow(3), TypeError, "window has to be the four numbers x0, y0, x1, y1, not 3"),
        (lambda: own_map((0, 0, 1)), lober.UsageError, "window has to be the four numbers x0, y0, x1, y1"),
    ],
)
def test_numbers_that_are_too_few_are_named(call, error, message):
    with pytest.raises(error, match=message):
        call()


def own_flow(window):
    return lober.flow(lambda x, y, t: (y, -x), period=1, window=window)()


def own_map(window):
    return lober.map(lambda x, y: (y, -x), inverse=lambda x, y: (-y, x), window=window)()
