#!/usr/bin/env bash
# Runs every fuzz target of a build for some time, two at once, and fails on any finding.
# usage: fuzz.sh [seconds a target, default 600 [build folder, default build-fuzz]]
set -uo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-600}
build=${2:-build-fuzz}
at_once=2
folder=$build/findings
export LSAN_OPTIONS=suppressions=$PWD/scripts/lsan.supp:print_suppressions=0
mkdir -p "$folder"

# Inputs that reach new code are kept between runs in BUILD/corpus; the seeds stay as they are.
run_target() {
  local binary=$1 name extra=()
  name=$(basename "$binary")
  # matio asks for any memory that a file promises, and can do without.
  [ "$name" = fuzz_formats ] && extra=(-malloc_limit_mb=1000000) && export ASAN_OPTIONS=allocator_may_return_null=1
  mkdir -p "$build/corpus/$name"
  if "$binary" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 -print_final_stats=1 "${extra[@]}" \
      -artifact_prefix="$folder/$name-" "$build/corpus/$name" "tests/corpus/${name#fuzz_}" >"$folder/$name.log" 2>&1; then
    echo "$name: no finding, $(sed -n 's/^stat::number_of_executed_units: *//p' "$folder/$name.log") inputs"
  else
    echo "$name: FINDING, see $folder/$name.log"
    tail -n 40 "$folder/$name.log"
    return 1
  fi
}
export -f run_target
export seconds build folder

targets=("$build"/bin/fuzz_*)
[ -x "${targets[0]}" ] || { echo "no fuzz targets; configure with LOBER_BUILD_FUZZ and build" >&2; exit 1; }
printf '%s\0' "${targets[@]}" | xargs -0 -P "$at_once" -I{} bash -c 'run_target {}'
