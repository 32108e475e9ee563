#!/usr/bin/env bash
# Runs the tests of the Python package with the engine and the bindings under AddressSanitizer: what reads or writes where no memory
# of its own is, ends the run with the place. The module is built into a folder of its own; a quarter of an hour on one core, a few
# minutes once it is there. Leaks are not looked for: the interpreter itself keeps memory until the end. What a fault of another
# kind leaves is shown by faulthandler.
# usage: python-asan.sh [BUILD [pytest options]]
set -euo pipefail
cd "$(dirname "$0")/.."
build=$(realpath -m "${1:-build-python-asan}")
[ $# -gt 0 ] && shift
asan=$(g++ -print-file-name=libasan.so)
[ -e "$asan" ] || { echo "skipped: g++ has no libasan.so"; exit 77; }
# GCC takes members of empty optionals for values where it instruments code: a warning that says nothing here.
[ -e "$build/CMakeCache.txt" ] || cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_COMPILER=g++ \
  -DCMAKE_CXX_FLAGS='-fsanitize=address -fno-omit-frame-pointer -O1 -g1 -Wno-maybe-uninitialized' -DLOBER_BUILD_CLI=OFF -DLOBER_BUILD_TESTS=OFF \
  -DLOBER_INSTALL=OFF -DLOBER_UNITY=ON -DLOBER_BUILD_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3
scripts/python-install.sh "$build"
cd python/tests
# The runtime has to come before all libraries. NumPy and the interpreter are not built for it: what goes on between them and the
# module is seen by the functions that it replaces. Python's own allocator hides what lies beside small objects.
export LD_PRELOAD=$(realpath "$asan"):$(realpath "$(g++ -print-file-name=libstdc++.so)")
export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1:handle_segv=0:abort_on_error=1 PYTHONMALLOC=malloc
exec timeout --kill-after=10 "${LOBER_PYTHON_LIMIT:-1800}" "$build/python/venv/bin/python" -X faulthandler -P -m pytest -q \
  -c ../pyproject.toml --rootdir=. -o testpaths=. -p no:cacheprovider "$@"
