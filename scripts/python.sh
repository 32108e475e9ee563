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
cd python/tests
timeout --kill-after=10 "${LOBER_PYTHON_LIMIT:-600}" "$venv/bin/python" -P -m pytest -q -c ../pyproject.toml --rootdir=. -o testpaths=. -p no:cacheprovider "$@"
# The stub of the extension against the extension, and the types of the package.
cd "$build/python"
"$venv/bin/python" -m mypy.stubtest lober._lober --ignore-missing-stub --allowlist "$root/python/tests/stubtest.txt"
"$venv/bin/python" -m mypy --config-file "$root/python/pyproject.toml" --cache-dir "$build/python/mypy" -p lober
# And the types that a user sees.
MYPYPATH=$root/python/tests "$venv/bin/python" -m mypy --strict --config-file "$root/python/pyproject.toml" \
  --cache-dir "$build/python/mypy" "$root/python/tests/consumer.py"
