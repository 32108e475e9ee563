#!/usr/bin/env bash
# Fails when the steps of .ci/run, with its own limits and not those of `make ci`, may take more than 75 minutes in
# all, or when the list of their limits has come apart.
# usage: ci_limits.sh SOURCE_FOLDER
set -euo pipefail
env -u LOBER_CI_ALL "$1/.ci/run" --limits | awk '
  {print}
  $1 !~ /^[0-9]+$/ || $1 < 1 {print "not a limit in minutes: " $0; bad = 1}
  {sum += $1; steps += 1}
  END {
    print sum " minutes in " steps " steps"
    if (steps < 8) {print "fewer steps than there were"; bad = 1}
    if (sum > 75) {print "more than 75"; bad = 1}
    exit bad
  }'
