#!/usr/bin/env bash
# Runs a part of the tests of a sanitized build: what is not chosen are long tests of numbers, which reach no code that
# the others do not. Each program runs as often as there are cores at once, every run with its share of the tests.
# usage: ci-sanitized.sh build-asan|build-tsan
set -uo pipefail
cd "$(dirname "$0")/.."
build=$1
if [ -n "${LOBER_CI_ALL:-}" ]; then
  export LOBER_RANDOM_PAIRS=500 LOBER_RANDOM_REGIONS=500 LOBER_RANDOM_TANGLES=2000 LOBER_STABILITY_PAIRS=20
  export LOBER_DISCRETISATION_PAIRS=20
  long='*Transport*:*Escape*:*Large*:*Discretisation*:*Grow*:*TangleOfMap*:*SaddleGuesses*'
else
  export LOBER_RANDOM_PAIRS=200 LOBER_RANDOM_REGIONS=200 LOBER_RANDOM_TANGLES=200 LOBER_STABILITY_PAIRS=5
  export LOBER_DISCRETISATION_PAIRS=5
  long='*OracleAgreement*:*Transport*:*Escape*:*Tube*:*ThinTangle*:*ActionAtRest*:*Systems*:*FixedPoints*:*Large*'
  long+=':*Discretisation*:*Grow*:*TangleOfMap*:*BulkMemory*:*SaddleGuesses*:Sweep.*:Melnikov.*'
  long+=':CInterface.IteratesInPieces*:ErrorBars.*:Windows.AreUsedBySearches:RequireSimple.EndsSoon*:CrossSign.*'
  long+=':Number.AgreesWithStrtod*:DoubleDouble.*:Generated.ImagesThatExplode*:OverlapsWithCopy.*'
  long+=':Callbacks.WhatOneThrows*:Callbacks.FractionsAscend*:Callbacks.AskingToStop*'
fi
export LOBER_KILLS=2 LOBER_SCENE_POINTS=20000
export ASAN_OPTIONS=strict_string_checks=1:detect_stack_use_after_return=1 UBSAN_OPTIONS=print_stacktrace=1
export LSAN_OPTIONS=suppressions=$PWD/scripts/lsan.supp:print_suppressions=0
export TSAN_OPTIONS="suppressions=$PWD/scripts/tsan.supp halt_on_error=1"
cores=${LOBER_CI_CORES:-$(nproc)}
status=0

logs=()
# When the time of this step is over, the tests that it stands at.
trap 'tail -q -n 1 "${logs[@]}"; exit 124' TERM

# run PROGRAM FILTER: the end of the output of what fails; one line of what does not, and its tests of ten seconds and
# more, which are to be made shorter or not to be chosen.
run() {
  local program=$build/bin/$1 filter=$2 shard pids=()
  if [ ! -x "$program" ]; then
    echo "no $program" >&2
    status=1
    return
  fi
  for ((shard = 0; shard < cores; ++shard)); do
    logs[shard]=$(mktemp)
    GTEST_TOTAL_SHARDS=$cores GTEST_SHARD_INDEX=$shard "$program" --gtest_filter="$filter" >"${logs[shard]}" 2>&1 &
    pids[shard]=$!
  done
  for ((shard = 0; shard < cores; ++shard)); do
    if wait "${pids[shard]}"; then
      echo "$1: $(grep '^\[  PASSED' "${logs[shard]}")"
      grep -E '^\[       OK .*\([0-9]{5,} ms\)' "${logs[shard]}"
    else
      status=1
      grep -vE '^\[( RUN  |  +OK|-----)' "${logs[shard]}" | tail -n 200
    fi
    rm -f "${logs[shard]}"
  done
}

case $build in
  build-asan)
    run lober_tests "-$long"
    if [ -n "${LOBER_CI_ALL:-}" ]; then
      # Tests of transport and escape take too long; the program goes the same ways once.
      for arguments in "transport henon --tolerance 1e-4 --particles 1000" "tangle --system standard --tolerance 1e-3" \
          "escape capsize --crossings 1 --tolerance 1e-3"; do
        # shellcheck disable=SC2086
        timeout 300 "$build/bin/lober" $arguments >/dev/null || { echo "lober $arguments: status $?" && status=1; }
      done
      run lober_cli_tests '*BadInput*:*Json*:*PublishedForm*:Overlay*:Interior*:Densify*:Batch.*'
    fi
    ;;
  build-tsan)
    run lober_thread_tests '*'
    LOBER_SCENE_POINTS=5000 run lober_determinism_tests 'Determinism/*'
    ;;
  *)
    echo "usage: ci-sanitized.sh build-asan|build-tsan" >&2
    exit 2
    ;;
esac
exit $status
