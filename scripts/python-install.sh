#!/usr/bin/env bash
# Builds the Python package in a build folder and installs it into a virtual environment there. Needs no network: all
# packages are Debian's, the environment sees them.
# usage: python-install.sh [BUILD]
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
build=$(realpath -m "${1:-build}")
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
