#!/usr/bin/env bash
# Runs the tests of the Python package, as python.sh has installed it, under the debug build of Python (Debian: python3-dbg): it
# checks reference counts, the GIL and memory that it hands out at every call, which the usual one does not. What a fault leaves is
# shown by faulthandler. Some minutes.
# usage: python-debug.sh [BUILD [pytest options]]
set -euo pipefail
cd "$(dirname "$0")/.."
build=$(realpath -m "${1:-build}")
[ $# -gt 0 ] && shift
command -v python3-dbg >/dev/null || { echo "skipped: there is no python3-dbg (apt install python3-dbg)"; exit 77; }
site=$(echo "$build"/python/venv/lib/python3.*/site-packages)
[ -d "$site/lober" ] || { echo "no package in $site; run scripts/python.sh $build first" >&2; exit 1; }
# An environment of its own, which sees the package of the other one: tests start further processes.
venv=$build/python/venv-debug
[ -x "$venv/bin/python" ] || python3-dbg -m venv --without-pip --system-site-packages "$venv"
echo "$site" >"$(echo "$venv"/lib/python3.*/site-packages)/lober.pth"
cd python/tests
# What development mode says of packages of others is not ours: only warnings that name lober are errors.
exec "$venv/bin/python" -X dev -X faulthandler -P -m pytest -q -c ../pyproject.toml --rootdir=. -o testpaths=. \
  -p no:cacheprovider -W ignore -W "error:::lober" "$@"
