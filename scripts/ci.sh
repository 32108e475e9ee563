#!/usr/bin/env bash
# What a change has to pass to land, what shows most per minute first: `make test` (one project that uses lober among
# it), format, words, the Python module, documents, the same code with clang under ASan and UBSan with a chosen part of the tests.
# Then the steps that watch a part of the sources: they run when that part is not as it was when they last passed
# (.ci/passed, which `make ci` writes and a commit brings along), and share a limit. `make ci` (LOBER_CI_ALL=1) runs all
# steps, with more tests and without the common limit.
# Ends with what was left out and why, and the line `N passed, N failed, N skipped`: the tests of `make test` one by one,
# each further step as one.
# usage: ci.sh [--limits]   --limits prints the limit of each step in minutes and runs nothing
set -uo pipefail
cd "$(dirname "$0")/.." || exit
export LOBER_CI_CORES=${LOBER_CI_CORES:-$(nproc)}
all=${LOBER_CI_ALL:-}
record=.ci/passed
watching_minutes=7  # of all steps that watch something together
passed=0 failed=0 skipped=0 summary=() left_out=() limits_only=
[ "${1:-}" = --limits ] && limits_only=1
output=$(mktemp)  # of the step that ran last
trap 'rm -f "$output"' EXIT

took() { echo "$((($SECONDS - $1) / 60)) min $((($SECONDS - $1) % 60)) s"; }

leave_out() {
  left_out+=("$1: $2")
  skipped=$((skipped + 1))
}

# What failed in the step that ran last, for the summary: who reads a log from its end sees it.
name_failures() {
  while read -r line; do summary+=("            ${line:0:200}"); done < <(
    grep -aE '^\[  FAILED  \] .*\(|^FAILED |^ERROR test|^SUMMARY: |runtime error: |\*\*\*(Failed|Timeout|Exception)|^FAILED:' "$output" | sort -u | head -n 12)
}

# step NAME MINUTES COMMAND...
step() {
  local name=$1 limit=$2 begin=$SECONDS status
  shift 2
  if [ -n "$limits_only" ]; then
    echo "$limit $name"
    return 0
  fi
  echo "== $name"
  timeout --kill-after=30 "${limit}m" "$@" > >(tee "$output") 2>&1
  status=$?
  sleep 1  # until tee has written all; to wait for it would be to wait for whatever a step has left behind
  case $status in
    0) summary+=("passed    $name, $(took "$begin")") passed=$((passed + 1)) ;;
    77) summary+=("skipped   $name, see above") skipped=$((skipped + 1)) ;;
    124 | 137)
      if [ -n "${may_run_out:-}" ]; then
        leave_out "$name" "the $watching_minutes minutes of the steps that watch sources were over"
      else
        summary+=("FAILED    $name: not done within $limit minutes") failed=$((failed + 1))
        name_failures
      fi
      ;;
    *)
      summary+=("FAILED    $name, status $status, $(took "$begin")") failed=$((failed + 1))
      name_failures
      ;;
  esac
  return $status
}

# One number for the content of the tracked files that are named.
state_of() {
  # shellcheck disable=SC2086
  git ls-files -z -- $1 | xargs -0 -r git hash-object | git hash-object --stdin
}

# watching NAME MINUTES FILES COMMAND...: the step when FILES have changed since it last passed.
watching() {
  local name=$1 limit=$2 files=$3 state may_run_out="" left
  shift 3
  [ -n "$limits_only" ] && return
  state=$(state_of "$files")
  if [ -z "$all" ]; then
    if grep -qxF "$name: $state" "$record" 2>/dev/null; then
      leave_out "$name" "as they were when it last passed: ${files//$'\n'/ }"
      return
    fi
    left=$((watching_minutes - (SECONDS - watching_begin) / 60))
    if [ "$left" -le 0 ]; then
      leave_out "$name" "the $watching_minutes minutes of the steps that watch sources were over"
      return
    fi
    if [ "$left" -lt "$limit" ]; then limit=$left may_run_out=1; fi
  fi
  step "$name" "$limit" "$@" || return
  touch "$record"
  { grep -v "^$name: " "$record"; echo "$name: $state"; } | sort >"$record.new"
  mv "$record.new" "$record"
}

step "make test" 21 make test
if [ -z "$limits_only" ]; then
  # The tests count one by one.
  counts=$(grep -E '^[0-9]+ passed, [0-9]+ failed, [0-9]+ skipped$' "$output" | tail -n 1)
  if [ -n "$counts" ]; then
    before=$failed
    read -r passed failed skipped < <(echo "$counts" | sed 's/[^0-9]\+/ /g')
    if [ "$failed" -lt "$before" ]; then failed=$before; fi
  fi
fi
step "Debian packages" 3 scripts/install-packages.sh clang clang-tidy clang-format libclang-rt-14-dev
step "format" 1 scripts/check-format.sh
step "words" 1 scripts/check-words.sh
step "numbers of README" 1 scripts/check-numbers.sh
step "the Python module, its tests and types" 7 make -s python
step "commands and code of README and documents" 3 scripts/check-readme.sh
# Without the program: operations_test runs all operations, and clang-tidy below compiles what has changed of it.
instrumented=(lober_tests fuzz_text fuzz_raw fuzz_npy fuzz_formats fuzz_store)
sanitized_minutes=11
if [ -n "$all" ]; then
  instrumented=()
  sanitized_minutes=30  # of all tests, not a chosen part
fi
if step "clang with ASan and UBSan, warnings as errors" 20 scripts/ci-build.sh asan-ubsan "${instrumented[@]}"; then
  step "tests under ASan and UBSan" "$sanitized_minutes" scripts/ci-sanitized.sh build-asan
fi
if [ -n "$limits_only" ]; then
  echo "$watching_minutes what watches sources, together"
  exit
fi

watching_begin=$SECONDS
parallel=$(git grep -l 'engine/base/parallel/' -- engine)
watching "the same bits at a million points" 4 "kernels engine/base engine/geometry" \
    env LOBER_SCENE_POINTS=1000000 build/bin/lober_determinism_tests --gtest_brief=1 --gtest_filter='*Overlay*'
watching "fuzz targets, half a minute each" 4 "engine/files engine/batch/*store* engine/batch/*bytes* tests/fuzz tests/corpus" \
    scripts/fuzz.sh 30 build-asan
threaded=(lober_determinism_tests lober_thread_tests)
[ -z "$all" ] || threaded+=(lober)
watching "tests under ThreadSanitizer" 12 "engine/base engine/batch $parallel cmake scripts/tsan.supp" \
    scripts/ci-threads.sh "${threaded[@]}"
watching "all projects that use lober" 10 "engine/lober engine/*.cmake CMakeLists.txt cmake tests/consumer tests/api" \
    scripts/run-consumers.sh build
watching "the benchmarks build" 6 "bench engine/*.hpp kernels/*.hpp" make -s bench-build
watching "clang-tidy on what changed" 6 "kernels engine cli .clang-tidy" scripts/tidy-changed.sh 5

echo
printf '%s\n' "${summary[@]}"
[ ${#left_out[@]} -eq 0 ] || printf 'left out: %s\n' "${left_out[@]}"
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]
