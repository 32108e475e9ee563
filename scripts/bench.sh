#!/usr/bin/env bash
# Runs the benchmarks of build/bin.
# usage: bench.sh [full|quick|own] [EARLIER]
#   full    10^6 points, all rivals, about half an hour; writes bench/RESULTS.md, which the README quotes
#   quick   10^5 points, fast rivals, a few minutes; writes build/bench-quick.md
#   own     the parts of full about overlays without rivals, growth and other ways to areas, ten minutes; replaces them
# EARLIER, a program of an earlier version, runs the first table's commands beside the present one.
set -euo pipefail
cd "$(dirname "$0")/.."
mode=${1:-full} earlier=${2:-}
case $mode in
  full) results=bench/RESULTS.md overlay=(--n 1000000 --rivals all --limit 30 --repeat 11) kernels=(--benchmark_min_time=0.5) batch=() rounds=5 ;;
  quick) results=build/bench-quick.md overlay=(--n 100000 --rivals fast --limit 20 --no-growth) kernels=(--benchmark_min_time=0.1) batch=(--quick) rounds=1 ;;
  own) results=bench/RESULTS.md overlay=(--n 1000000 --rivals none --repeat 11) ;;
  *) echo "usage: bench.sh [full|quick|own] [EARLIER]" >&2; exit 2 ;;
esac
tables=$(mktemp)
older=$(mktemp)
draft=$(mktemp)
curves=$(mktemp -d)
trap 'rm -rf "$tables" "$older" "$draft" "$curves"' EXIT

processor=$(lscpu | sed -n 's/^Model name: *//p' | head -n 1)
commit=$(git log -1 --format='%h of %cs' 2>/dev/null || echo 'no commit yet')
# Under each heading, so that a table that is quoted alone can be told from older ones.
stamped() {
  awk -v where="_$processor, $(nproc) cores; commit $commit._" '/^##+ / { print; print ""; print where; next } { print }'
}
ways_to_areas() {
  echo '## Other ways to areas'
  echo
  build/bin/bench_areas "${overlay[1]}"
}

build/bin/bench_overlay "${overlay[@]}" --markdown "$tables"
# The same without AVX-512, where there is any.
if grep -q avx512vl /proc/cpuinfo; then
  LOBER_ISA=avx2 build/bin/bench_overlay --n "${overlay[1]}" --threads 1 --rivals none --no-growth --markdown "$older"
fi
if [ "$mode" = own ]; then
  {
    cat "$tables" "$older"
    ways_to_areas
  } | stamped >"$draft"
  # Each part goes from its heading to the next one.
  awk '
    FNR == 1 { part = "" }
    /^##+ / { part = $0 }
    NR == FNR { if (part != "") new[part] = new[part] $0 "\n"; next }
    !(part in new) { print; next }
    $0 == part { printf "%s", new[part]; put[part] = 1 }
    END {
      for (part in new) if (!(part in put)) { print "bench.sh: no part of the results is called " part >"/dev/stderr"; bad = 1 }
      exit bad
    }' "$draft" "$results" >"$tables"
  cp "$tables" "$results"
  echo "wrote $results"
  exit
fi

compiler=$("$(sed -n 's/^CMAKE_CXX_COMPILER:[^=]*=//p' build/CMakeCache.txt)" --version | head -n 1)
{
  echo '# Results of the benchmarks'
  echo
  echo "Written by \`scripts/bench.sh $mode\`. $processor, $(nproc) cores; $compiler; commit $commit."
  echo 'Where others share the machine, the floors tell how quiet it was.'
  echo 'Scenes, what is measured and what the rivals are asked for: `bench/scenes`, `bench/harness`, `bench/rivals`.'
  echo
  echo '## What you wait for'
  echo
  echo 'Commands from beginning to end, reading and writing included, on one and on two threads: medians in seconds.'
  echo
  scripts/bench-commands.sh build/bin/lober "$rounds" "$earlier"
  echo
  cat "$tables" "$older"
  echo '## Run time against error'
  echo
  echo 'One thread; error of [C1 \ C2] relative to the true area of the smooth curves, for each number of points a curve.'
  echo
  build/bin/bench_accuracy --svg docs/accuracy.svg
  ways_to_areas
  echo '## Settings of the densifier'
  echo
  echo 'As in figure 8 of Naik, Lekien & Ross (2017): the difference of the area from the one with segments split where the curves meet,'
  echo 'points inserted, microseconds on one thread. Written by `bench_settings --svg docs/paper/fig-08.svg`, which shows the same as a picture.'
  echo
  # shellcheck disable=SC2046
  build/bin/bench_settings $(LOBER=build/bin/lober scripts/densifier-pairs.sh "$curves") --svg docs/paper/fig-08.svg
  echo '## Integrators'
  echo
  echo 'One period of forced flows, a time of 7 of autonomous ones: what an error costs, method by method, all in the vectors of the processor'
  echo 'with the same steps and the same control of errors, beside the plain loops of Odeint and SciPy (one point at a time). Written by'
  echo '`bench_integrators --plot docs/integrators.svg`, which shows the same as a picture. Errors are against a long double reference.'
  echo
  build/bin/bench_integrators --plot docs/integrators.svg
  for suite in kernels reading interior densify tangle grow; do
    [ -x "build/bin/bench_$suite" ] || continue
    echo "### ${suite^}"
    echo
    echo '```'
    "build/bin/bench_$suite" "${kernels[@]}" --benchmark_color=false 2>/dev/null
    echo '```'
    echo
  done
  echo '### Sweeps'
  echo
  echo 'Evaluations of the map for each value of `transport --sweep`, one with a derivative counted three times, and of the values by themselves.'
  echo
  build/bin/bench_sweep
  echo
  echo '### Batches'
  echo
  echo 'Whole runs of `lober batch run`, store included, the best of several. One thread is kept to one core, which the thread that stores shares.'
  echo
  build/bin/bench_batch "${batch[@]}"
} >"$draft"
stamped <"$draft" >"$results"
echo "wrote $results"
