#!/usr/bin/env bash
# Where and when the table of README.md was measured, its floor, growth and reading, from bench/RESULTS.md.
set -euo pipefail
results=$(dirname "$0")/../../bench/RESULTS.md
awk '
  function cells() { count = split($0, cell, "|"); for (k = 1; k <= count; ++k) gsub(/^ +| +$/, "", cell[k]) }
  function commit_of(stamp) { sub(/.*; commit /, "", stamp); sub(/[.]_$/, "", stamp); return stamp }
  /^#/ { section = $0 }
  /^_.*; commit / && section ~ /^### 1000000 [+] 1000000 points$/ { place = substr($0, 2); sub(/;.*/, "", place); commit = commit_of($0) }
  /^_.*; commit / && section ~ /^### Against general/ { rivals = commit_of($0) }
  section ~ /^### 1000000 [+]/ && /^[|] lens / && floor == "" { cells(); floor = cell[5] }
  section ~ /^### Growth with/ && /^[|] (lens|wavy16) / {
    cells()
    if (low == "" || cell[7] + 0 < low + 0) low = cell[7]
    if (high == "" || cell[7] + 0 > high + 0) high = cell[7]
  }
  /^read_17_digits\/one_thread\// { speed = $0; sub(/.*bytes_per_second=/, "", speed); sub(/\/s.*/, "", speed) }
  END {
    if (place == "" || floor == "" || low == "" || speed == "") { print "a number is not in the results" > "/dev/stderr"; exit 1 }
    sub(/M$/, " MB", speed); sub(/G$/, " GB", speed)
    print "Commit " commit ", " (rivals == commit ? "" : "rivals at " rivals ", ") place "; the floor is " floor " ms there, more where other processes"
    print "disturbed it. Time grows with the power " low " to " high " of N from 10^4 to 10^7 points at a fixed number of crossings."
    print "Text of 17-digit numbers is read at " speed "/s on one core. `make bench` measures all of this again and"
    print "writes [bench/RESULTS.md](bench/RESULTS.md)."
  }
' "$results"
