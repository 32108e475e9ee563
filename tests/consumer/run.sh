#!/usr/bin/env bash
# Installs the built package into a temporary folder, then configures, builds and runs the consumer project against it.
# usage: run.sh CMAKE BUILD_FOLDER COMPILER SANITIZERS
set -euo pipefail
cmake=$1 build=$2 compiler=$3 sanitize=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$cmake" --install "$build" --prefix "$work/prefix" >/dev/null
flags=${sanitize:+-fsanitize=$sanitize}
"$cmake" -S "$(dirname "$0")" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_CXX_FLAGS="$flags" -DCMAKE_BUILD_TYPE=Release >/dev/null
"$cmake" --build "$work/build" >/dev/null
"$work/build/consumer"
