#!/usr/bin/env bash
# What a change has to pass to land: `make test` first, then format, documents, consumers, benchmarks, the scenes at a
# million points; the same code with clang under sanitizers with a chosen part of the tests, fuzz targets, clang-tidy.
# LOBER_CI_ALL=1 (`make ci`) takes all tests there, LOBER_CI_SANITIZED= (empty) leaves these steps out. Each step has a
# limit of its own, and none begins after an hour.
# Ends with the line `N passed, N failed, N skipped`: the tests of `make test`, and each further step as one.
set -uo pipefail
cd "$(dirname "$0")/.."
export LOBER_CI_CORES=${LOBER_CI_CORES:-$(nproc)}
sanitized=${LOBER_CI_SANITIZED-1}
last_begin=${LOBER_CI_LAST_BEGIN:-60}  # minutes
passed=0 failed=0 skipped=0 summary=()
log=$(mktemp)
trap 'rm -f "$log"' EXIT

minutes() { echo $((SECONDS / 60)); }

# step NAME LIMIT COMMAND...
step() {
  local name=$1 limit=$2 begin=$SECONDS status
  shift 2
  if [ "$(minutes)" -ge "$last_begin" ]; then
    summary+=("left out  $name: it is minute $(minutes)")
    skipped=$((skipped + 1))
    return 1
  fi
  echo "== $name"
  timeout --kill-after=30 "$limit" "$@"
  status=$?
  local took="$(((SECONDS - begin) / 60)) min $(((SECONDS - begin) % 60)) s"
  case $status in
    0) summary+=("passed    $name, $took") passed=$((passed + 1)) ;;
    77) summary+=("skipped   $name, see above") skipped=$((skipped + 1)) ;;
    124 | 137) summary+=("FAILED    $name: not done within $limit") failed=$((failed + 1)) ;;
    *) summary+=("FAILED    $name, status $status, $took") failed=$((failed + 1)) ;;
  esac
  return $status
}

leave_out() {
  summary+=("skipped   $1: $2")
  skipped=$((skipped + 1))
}

# The tests come first, and count one by one.
echo "== make test"
timeout --kill-after=30 55m make test 2>&1 | tee "$log"
status=${PIPESTATUS[0]}
counts=$(grep -E '^[0-9]+ passed, [0-9]+ failed, [0-9]+ skipped$' "$log" | tail -n 1)
if [ -n "$counts" ]; then
  read -r passed failed skipped < <(echo "$counts" | sed 's/[^0-9]\+/ /g')
fi
if [ "$status" -ne 0 ] && [ "$failed" -eq 0 ]; then failed=1; fi
summary+=("make test: ${counts:-no result}, status $status, $(minutes) min")

step "Debian packages" 10m scripts/install-packages.sh clang clang-tidy clang-format libclang-rt-14-dev
step "format" 5m scripts/check-format.sh
step "words" 1m scripts/check-words.sh
step "the Python module, its tests and types" 15m make -s python
if [ -x scripts/check-readme.sh ]; then
  step "commands and code of README and documents" 15m scripts/check-readme.sh
else
  leave_out "commands and code of README and documents" "no scripts/check-readme.sh"
fi
step "another project builds lober inside it, with GCC and clang" 15m scripts/run-consumers.sh build
step "the benchmarks build" 10m make -s bench-build
step "the same bits at a million points" 8m env LOBER_SCENE_POINTS=1000000 build/bin/lober_determinism_tests \
    --gtest_brief=1 --gtest_filter='*Overlay*'
if [ -n "${LOBER_CI_ALL:-}$sanitized" ]; then
  instrumented=(lober lober_tests fuzz_text fuzz_raw fuzz_npy fuzz_store)
  threaded=(lober_determinism_tests lober_thread_tests)
  if [ -n "${LOBER_CI_ALL:-}" ]; then
    instrumented=()
    threaded+=(lober)
  fi
  if step "clang with ASan and UBSan, warnings as errors" 25m scripts/ci-build.sh asan-ubsan "${instrumented[@]}"; then
    step "tests under ASan and UBSan" 15m scripts/ci-sanitized.sh build-asan
    step "fuzz targets, half a minute each" 8m scripts/fuzz.sh 30 build-asan
  else
    leave_out "tests under ASan and UBSan, fuzz targets" "there is no build"
  fi
  if step "clang with ThreadSanitizer" 20m scripts/ci-build.sh tsan "${threaded[@]}"; then
    step "tests under ThreadSanitizer" 12m scripts/ci-sanitized.sh build-tsan
  else
    leave_out "tests under ThreadSanitizer" "there is no build"
  fi
  step "clang-tidy on what changed" 9m scripts/tidy-changed.sh 5
else
  leave_out "clang, ASan, UBSan, fuzz targets, ThreadSanitizer, clang-tidy" "LOBER_CI_SANITIZED is empty"
fi

echo
printf '%s\n' "${summary[@]}"
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]
