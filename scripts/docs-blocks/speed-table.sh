#!/usr/bin/env bash
# The table of README.md from bench/RESULTS.md: a choice of its scenes, under names that say more.
set -euo pipefail
results=$(dirname "$0")/../../bench/RESULTS.md
awk -F'|' '
  function cell(k) { value = $(k + 1); gsub(/^ +| +$/, "", value); return value }
  BEGIN {
    count = split("lens wavy16 geometric shared-exact identical tangle hairs wavyN10 dense-tangle images14 rings shared-ulp near-tangent", order, " ")
    title["lens"] = "lens of two circles"; title["wavy16"] = "wavy circle, 16 crossings"
    title["geometric"] = "geometric density 1e-12 .. 1"; title["shared-exact"] = "half the boundary shared"
    title["identical"] = "identical"; title["tangle"] = "tangle"; title["hairs"] = "thousand bent hairs"
    title["wavyN10"] = "wavy circle"; title["dense-tangle"] = "dense tangle"
    title["shared-ulp"] = "shared up to one ulp"; title["near-tangent"] = "near-tangent at 1e-9"
    title["images14"] = "images of a circle"; title["rings"] = "rings across rings"
  }
  /^### 1000000 [+] 1000000 points$/ { table = 1 }
  /^Phases of/ { table = 0 }
  /^### Against general overlay libraries/ { table = 2 }
  /^#/ && !/^### 1000000 [+] 1000000 points$/ && !/^### Against/ { table = 0 }
  table == 1 && cell(1) in title {
    name = cell(1); crossings[name] = cell(2); sub(/,.*/, "", crossings[name])
    own[name] = cell(5); floors[name] = cell(6); simple[name] = cell(7); speedup[name] = cell(11); memory[name] = cell(12)
  }
  table == 2 && cell(1) in title { rival[cell(1)] = cell(11) }
  END {
    print "| scene | crossings | ms | x floor | simple, ms | 2 threads | rival | memory, B/point |"
    print "|---|---:|---:|---:|---:|---:|---:|---:|"
    for (k = 1; k <= count; ++k) {
      name = order[k]
      if (!(name in own)) { print "no scene " name " in the results" > "/dev/stderr"; exit 1 }
      fastest = rival[name] == "-" || rival[name] == "" ? "none" : rival[name] "x"
      printf "| %s | %s | %s | %s | %s | %sx | %s | %s |\n", title[name], crossings[name], own[name], floors[name], simple[name],
             speedup[name], fastest, memory[name]
    }
  }
' "$results"
