#!/usr/bin/env bash
# Installs the Python package into a virtual environment of a build folder (python-install.sh), runs its tests there and
# checks its types.
# usage: python.sh [BUILD [pytest options]]
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
build=$(realpath -m "${1:-build}")
[ $# -gt 0 ] && shift
venv=$build/python/venv
scripts/python-install.sh "$build"

# The stub of the extension against the extension, the types of the package, and those that a user sees.
check_types() {
  set -e
  cd "$build/python"
  "$venv/bin/python" -m mypy.stubtest lober._lober --ignore-missing-stub --allowlist "$root/python/tests/stubtest.txt"
  "$venv/bin/python" -m mypy --config-file "$root/python/pyproject.toml" --cache-dir "$build/python/mypy" -p lober
  MYPYPATH=$root/python/tests "$venv/bin/python" -m mypy --strict --config-file "$root/python/pyproject.toml" \
    --cache-dir "$build/python/mypy" "$root/python/tests/consumer.py"
}
check_types &
types=$! status=0

cd python/tests
pytest=(timeout --kill-after=10 "${LOBER_PYTHON_LIMIT:-600}" "$venv/bin/python" -P -m pytest -q -c ../pyproject.toml
        --rootdir=. -o testpaths=. -p no:cacheprovider)
if [ $# -gt 0 ]; then
  "${pytest[@]}" "$@" || status=1
else
  # Two files in a process, long files first: many tests wait for others' processes, or compute on one core.
  ls -S test_*.py | xargs -P "${LOBER_CI_CORES:-$(nproc)}" -n 2 "${pytest[@]}" || status=1
fi
wait "$types" || status=1
exit "$status"
