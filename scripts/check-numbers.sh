#!/usr/bin/env bash
# Fails where README.md has a number of a measurement, one with a unit of time or speed or a factor, that bench/RESULTS.md
# has not. Code blocks show what the program prints and are checked elsewhere (docs.sh).
# usage: check-numbers.sh
set -euo pipefail
cd "$(dirname "$0")/.."
awk '
  FNR == NR { gsub(/[|,;=()]/, " "); for (k = 1; k <= NF; ++k) { word = $k; sub(/[MGx%]?(\/s)?$/, "", word); known[word] = 1 } next }
  /^```/ { code = !code }
  code { next }
  {
    rest = $0
    while (match(rest, /[0-9][0-9.]*(x|( |%| ?)(ns|us|ms|s|MB|GB|plain passes|times faster|points a second)([^A-Za-z]|$))/)) {
      found = substr(rest, RSTART, RLENGTH)
      number = found
      sub(/[^0-9.].*/, "", number)
      checked += 1
      if (!(number in known)) { print "README.md:" FNR ": " number " is not in bench/RESULTS.md: " found; bad += 1 }
      rest = substr(rest, RSTART + RLENGTH - 1)
    }
    # The cells of the table of speed.
    if (/begin speed-table/) table = 1
    if (/end speed-table/) table = 0
    if (table && /^[|].*[0-9]/) {
      cells = split($0, cell, "|")
      for (k = 3; k < cells; ++k) {
        number = cell[k]; gsub(/[ x]/, "", number)
        if (number !~ /^[0-9.]+$/) continue
        checked += 1
        if (!(number in known)) { print "README.md:" FNR ": " number " is not in bench/RESULTS.md"; bad += 1 }
      }
    }
  }
  END { print checked + 0 " numbers, " bad + 0 " of them not measured"; exit bad > 0 || checked < 50 }
' bench/RESULTS.md README.md
