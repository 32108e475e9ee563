"""The first calls of a user: lober.show_versions() and lober.test()."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from types import SimpleNamespace

import numpy as np
import pytest

import lober
from lober import _lober, _self_test


def test_versions(capsys):
    assert lober.show_versions() is None
    lines = dict(line.split(maxsplit=1) for line in capsys.readouterr().out.splitlines())
    assert lines["lober"].startswith(lober.__version__ + " in ")
    assert lines["NumPy"] == np.__version__
    assert lines["Python"].startswith(sys.version.split()[0])
    assert lines["instructions"] in ("baseline", "avx2", "avx512")
    assert int(lines["threads"]) >= 1
    assert lines["compiler"].split()[0] in ("GCC", "clang")
    assert {"matplotlib", "sympy", "numba", "shapely"} <= set(lines)
    for entry in lober.formats():
        if entry.library:
            assert entry.name in lines[entry.library]
            assert lines[entry.library].startswith(entry.missing or "there (")


def test_versions_without_optional_packages(monkeypatch, capsys):
    monkeypatch.setenv("CC", "no-such-compiler")
    monkeypatch.setattr("lober._show_versions.OPTIONAL", {"no-such-package": "nothing"})
    lober.show_versions()
    out = capsys.readouterr().out
    assert "no-such-package  not installed (nothing)" in out
    assert "systems are compiled with NumPy, as there is no compiler here" in out


def test_instruction_set_is_the_one_that_runs():
    code = "import lober; lober.show_versions()"
    run = subprocess.run([sys.executable, "-c", code], env={**os.environ, "LOBER_ISA": "baseline"}, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert re.search(r"^instructions +baseline$", run.stdout, re.MULTILINE), run.stdout


def test_first_import_and_test_take_seconds_and_no_optional_package():
    code = (
        "import lober, sys; lober.show_versions(); assert lober.test() is True;"
        "print([name for name in ('matplotlib', 'sympy', 'numba', 'shapely', 'pytest') if name in sys.modules])"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert run.returncode == 0, run.stderr
    *_, passed, imported = run.stdout.splitlines()
    assert passed.startswith(f"lober {lober.__version__}: {len(_self_test.CHECKS)} checks passed in ")
    assert imported == "[]"


def wrong_area(c1, c2, **options):
    r = lober.overlay(c1, c2, **options)
    area = SimpleNamespace(**{name: getattr(r.area, name) for name in dir(r.area) if name[0] != "_"})
    area.union = np.nextafter(area.union, 8)
    return SimpleNamespace(area=area, crossings=r.crossings)


def wrong_lens(c1, c2, **options):
    smooth = lober.overlay(c1, c2, **options).smooth
    area = SimpleNamespace(intersection=smooth.area.intersection + 3 * smooth.error.intersection)
    return SimpleNamespace(smooth=SimpleNamespace(area=area, error=smooth.error))


def wrong_winding(curve, points):
    numbers, on_curve = lober.winding(curve, points)
    return -numbers, on_curve


def wrong_manifold(*arguments, **options):
    grown = lober.grow(*arguments, **options)
    return SimpleNamespace(points=grown.points + 1e-6, stop=grown.stop)


@pytest.mark.parametrize(
    ("check", "name", "wrong"),
    [
        ("_squares", "overlay", wrong_area),
        ("_circles", "overlay", wrong_lens),
        ("_winding", "winding", wrong_winding),
        ("_manifold", "grow", wrong_manifold),
        ("_tangle", "manifold_tangle", lambda system: SimpleNamespace(agreement=False)),
        ("_files", "read", lambda file: np.nextafter(lober.read(file), 9)),
    ],
)
def test_what_is_wrong_is_found(monkeypatch, check, name, wrong):
    monkeypatch.setattr(_self_test, name, wrong)
    with pytest.raises(AssertionError) as raised:
        getattr(_self_test, check)()
    message = str(raised.value)
    assert message.startswith("lober.test: ") and message.endswith("; install lober again") and "\n" not in message


def test_one_wrong_result_ends_the_test(monkeypatch, capsys):
    monkeypatch.setattr(_self_test, "overlay", wrong_area)
    with pytest.raises(AssertionError, match="lober.test: overlay of two squares is"):
        lober.test()
    assert capsys.readouterr().out == ""


def test_build_names_compiler_instructions_threads():
    assert set(_lober.build()) == {"compiler", "instruction_set", "threads"}
