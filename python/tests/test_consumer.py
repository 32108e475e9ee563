"""The program of consumer.py, whose types scripts/python.sh checks, runs."""

from __future__ import annotations

from pathlib import Path

import consumer
import pytest


def test_consumer(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    consumer.main(str(tmp_path / "circles.dat"))
    assert "(6, 6)" in capsys.readouterr().out
