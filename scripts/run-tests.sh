#!/usr/bin/env bash
# Runs the test suite of a build folder and ends with the plain line `N passed, N failed, N skipped`.
# usage: run-tests.sh BUILD [ctest options]
set -uo pipefail
build=$1
shift
report=$build/tests.xml
rm -f "$report"
ctest --test-dir "$build" --output-on-failure --output-junit "$(realpath "$build")/tests.xml" -j "$(nproc)" "$@"
status=$?
[ -f "$report" ] || { echo "no test report written" >&2; echo "0 passed, 1 failed, 0 skipped"; exit 1; }
count() { sed -n "s/^[[:space:]]*$1=\"\([0-9]*\)\".*/\1/p" "$report" | head -n 1; }
tests=$(count tests) failed=$(count failures) skipped=$(count skipped)
# A skip must say why: print each with its reason.
grep -h -A 1 ': Skipped$' "$report" | grep -v -e ': Skipped$' -e '^--$' | sed 's/^/skipped: /' | sort | uniq -c
[ "$tests" -gt 0 ] || { echo "no test ran" >&2; status=1; }
echo "$((tests - failed - skipped)) passed, $failed failed, $skipped skipped"
exit $status
