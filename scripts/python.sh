#!/usr/bin/env bash
# Builds the Python package in a build folder, installs it into a virtual environment, runs its tests there and checks
# its types. Needs no network: all packages are Debian's, the environment sees them.
# usage: python.sh [BUILD [pytest options]]
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
build=$(realpath -m "${1:-build}")
[ $# -gt 0 ] && shift
venv=$build/python/venv
[ -x "$venv/bin/python" ] || /usr/bin/python3 -m venv --system-site-packages "$venv"
# Built from a copy: setuptools writes beside the sources.
copy=$build/python/package
rm -rf "$copy"
mkdir -p "$copy"
cp -r python/pyproject.toml python/setup.py python/README.md python/lober "$copy/"
ln -sfn "$root" "$copy/source"
LOBER_BUILD=$build "$venv/bin/python" -m pip install --quiet --no-index --no-build-isolation --no-deps --force-reinstall \
  --disable-pip-version-check --root-user-action=ignore "$copy"
cd python/tests
timeout --kill-after=10 "${LOBER_PYTHON_LIMIT:-600}" "$venv/bin/python" -P -m pytest -q -c ../pyproject.toml --rootdir=. -o testpaths=. -p no:cacheprovider "$@"
# The stub of the extension against the extension, and the types of the package.
cd "$build/python"
"$venv/bin/python" -m mypy.stubtest lober._lober --ignore-missing-stub --allowlist "$root/python/tests/stubtest.txt"
"$venv/bin/python" -m mypy --config-file "$root/python/pyproject.toml" --cache-dir "$build/python/mypy" -p lober
