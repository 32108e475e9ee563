#!/usr/bin/env bash
# The claim at the top of README.md, from bench/RESULTS.md: the scene of two circles.
set -euo pipefail
results=$(dirname "$0")/../../bench/RESULTS.md
# Column K (from 1, the scene's name) of the row of the lens in the first table whose heading matches.
column() {
  awk -F'|' -v heading="$1" -v want="$2" '
    $0 ~ heading { here = 1 }
    here && $2 ~ /^ *lens *$/ { gsub(/ /, "", $(want + 1)); print $(want + 1); exit }
  ' "$results"
}
own=$(column '^### 1000000 [+] 1000000 points$' 5)
checked=$(column '^### 1000000 [+] 1000000 points$' 7)
floors=$(column '^### 1000000 [+] 1000000 points$' 8)
rival=$(column '^### Against general overlay libraries' 11)
[ -n "$own" ] && [ -n "$checked" ] && [ -n "$floors" ] && [ -n "$rival" ]
printf 'Two circles with a million points each: crossings, order, all pieces and areas in %s ms on one core, %s ms with the proof\n' "$own" "$checked"
printf 'that both curves are simple. That is %s plain passes over the points, and %s times faster than the fastest general overlay\n' "$floors" "$rival"
printf 'library that gets it right ([how measured](bench/RESULTS.md)).\n'
