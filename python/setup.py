"""Builds the extension with CMake; all else is in pyproject.toml.

LOBER_BUILD names a build folder of the project that is to be used, such as `build`; without it the extension gets one of
its own, where the program and its tests are not built.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist

here = Path(__file__).resolve().parent
# In a source distribution the C++ code lies beside this file, in the repository it is the folder above.
source = ((here / "source") if (here / "source").is_dir() else here.parent).resolve()
SOURCES = ["CMakeLists.txt", "cmake", "engine", "kernels", "python/CMakeLists.txt", "python/bindings", "viewer"]
# This module's own build, without the program and the tests.
OPTIONS = ["-DCMAKE_BUILD_TYPE=Release", "-DLOBER_BUILD_CLI=OFF", "-DLOBER_BUILD_TESTS=OFF", "-DLOBER_INSTALL=OFF", "-DLOBER_UNITY=ON"]


def version() -> str:
    header = (source / "engine" / "lober" / "base" / "version.hpp").read_text()
    return ".".join(re.findall(r"#define LOBER_VERSION_[A-Z]+ ([0-9]+)", header))


class build_with_cmake(build_ext):
    def build_extension(self, ext: Extension) -> None:
        build = Path(os.environ.get("LOBER_BUILD") or Path(self.build_temp) / "cmake").resolve()
        if not (build / "CMakeCache.txt").exists():
            configure = ["cmake", "-S", source, "-B", build, "-G", "Ninja", *OPTIONS]
            if subprocess.call(configure) != 0:
                # lober.batch then says what is missing.
                print("trying again without batches, which need SQLite, toml++ and nlohmann-json", file=sys.stderr)
                subprocess.check_call([*configure, "-DLOBER_BUILD_BATCH=OFF"])
        options = ["-DLOBER_BUILD_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}"]
        subprocess.check_call(["cmake", "-S", source, "-B", build, *options])
        jobs = os.environ.get("LOBER_JOBS") or str(os.cpu_count() or 1)
        subprocess.check_call(["cmake", "--build", build, "--target", "lober_python", "--parallel", jobs])
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(build / "python" / "lober" / target.name, target)


class sdist_with_source(sdist):
    def make_release_tree(self, base_dir: str, files: list[str]) -> None:
        super().make_release_tree(base_dir, files)
        for name in SOURCES:
            copy = Path(base_dir) / "source" / name
            copy.parent.mkdir(parents=True, exist_ok=True)
            original = source / name
            shutil.copytree(original, copy) if original.is_dir() else shutil.copy2(original, copy)


setup(
    version=version(),
    ext_modules=[Extension("lober._lober", sources=[])],
    cmdclass={"build_ext": build_with_cmake, "sdist": sdist_with_source},
)
