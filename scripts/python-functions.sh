#!/usr/bin/env bash
# Writes python/lober/_generated.py anew from the engine's table, with a module that is built: after a change of an
# operation's options or result.
# usage: python-functions.sh [BUILD]
set -euo pipefail
cd "$(dirname "$0")/.."
build=$(realpath -m "${1:-build}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# A package without the functions that are to be written, which may not fit the table yet.
mkdir "$work/lober"
cp python/lober/*.py "$build"/python/lober/_lober*.so "$work/lober/"
: >"$work/lober/__init__.py"
(cd "$work" && /usr/bin/python3 -m lober._generate) >"$work/generated.py"
cp "$work/generated.py" python/lober/_generated.py
echo "wrote python/lober/_generated.py"
