"""A build of the module by itself asks for what it uses, and for nothing else."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
UNUSED = ["CLI11", "spdlog", "GTest"]
#: What only batches use; setup.py leaves them out where one of these is missing.
OF_BATCHES = ["SQLite3", "tomlplusplus", "nlohmann_json"]


def constant(name: str):
    for statement in ast.parse((ROOT / "python" / "setup.py").read_text()).body:
        if isinstance(statement, ast.Assign) and statement.targets[0].id == name:
            return ast.literal_eval(statement.value)
    raise AssertionError(f"setup.py has no {name}")


@pytest.mark.parametrize("unused, more", [(UNUSED, []), ([*UNUSED, *OF_BATCHES], ["-DLOBER_BUILD_BATCH=OFF"])])
def test_configures_without_what_it_does_not_use(tmp_path, unused, more):
    # As a source distribution has it, without what is not built.
    source = tmp_path / "source"
    for name in constant("SOURCES"):
        (source / name).parent.mkdir(parents=True, exist_ok=True)
        (source / name).symlink_to(ROOT / name)
    without = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in unused]
    options = [*constant("OPTIONS"), "-DLOBER_BUILD_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}", *without, *more]
    command = ["cmake", "-S", source, "-B", tmp_path / "build", "-G", "Ninja", *options]
    run = subprocess.run(command, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert "lober_python" in (tmp_path / "build" / "build.ninja").read_text()
