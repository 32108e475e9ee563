#!/usr/bin/env bash
# Builds and runs the project in subdirectory/, which compiles the part of lober that it uses: some minutes of processor
# time. Status 77, with the reason, where the compiler is missing.
# usage: subdirectory.sh CMAKE SOURCE_FOLDER static|shared COMPILER
set -euo pipefail
cmake=$1 source=$2 form=$3 compiler=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
if ! command -v "$compiler" >/dev/null; then
  printf '%s: Skipped\nthere is no %s here, for which add_subdirectory is tested\n' "$0" "$compiler"
  exit 77
fi
shared=OFF
[ "$form" = static ] || shared=ON
# What the geometry does not need must not be looked for.
options=(-DBUILD_SHARED_LIBS=$shared)
for package in SQLite3 tomlplusplus Eigen3 Boost CLI11 nlohmann_json spdlog GTest; do
  options+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
done
"$cmake" -G Ninja -S "$source/tests/consumer/subdirectory" -B "$work/build" -DLOBER_SOURCE="$source" \
  -DCMAKE_CXX_COMPILER="$compiler" "${options[@]}"
"$cmake" --build "$work/build" --target consumer --parallel "${LOBER_CI_CORES:-$(nproc)}"
"$work/build/consumer"
"$cmake" --build "$work/build" --target consumer | grep -q 'no work to do' || { echo "FAILED: it is built twice"; exit 1; }
"$cmake" --install "$work/build" --prefix "$work/prefix"
installed=$(find "$work/prefix" -type f)
[ "$installed" = "$work/prefix/bin/consumer" ] || { printf 'FAILED: more is installed than the consumer:\n%s\n' "$installed"; exit 1; }
