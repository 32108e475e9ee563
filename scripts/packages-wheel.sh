#!/usr/bin/env bash
# Builds a wheel of the Python package with the extension of its own build, for the Python and the machine that run this.
# usage: packages-wheel.sh [FOLDER]   (build/wheel)
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$(realpath -m "${1:-build/wheel}")
rm -rf "$folder"/*.whl
# Built from a copy: setuptools writes beside the sources.
copy=$folder/package
mkdir -p "$copy"
rm -rf "$copy/lober" "$copy/build/lib"*
cp -r python/pyproject.toml python/setup.py python/README.md python/lober "$copy/"
ln -sfn "$PWD" "$copy/source"
(cd "$copy" && /usr/bin/python3 -m build --no-isolation --wheel --outdir "$folder") >"$folder/build.log" 2>&1 ||
  { tail -n 40 "$folder/build.log" | cut -c 1-300; exit 1; }
ls -l --block-size=K "$folder"/*.whl | awk '{print $5, $NF}'
echo "It needs the libraries of Debian that it was built with, libtbb12, libtbbmalloc2, libnettle8 and libsqlite3-0, and NumPy:"
echo "  python3 -m venv --system-site-packages VENV && VENV/bin/pip install $(basename "$folder"/*.whl)"
