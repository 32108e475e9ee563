#!/usr/bin/env bash
# The figures of section 5.1 of Naik, Lekien & Ross (2017), from the equations alone, into docs/figures (shown by
# docs/figures.md). The same bytes each time.
set -euo pipefail
cd "$(dirname "$0")/.."
lober=build/bin/lober
figures=docs/figures
mkdir -p "$figures"
for gamma in 0.5 1.81; do
  "$lober" tangle --system ovp --param "gamma=$gamma" --after 1 --before 2 --tolerance 1e-4 \
      --svg "$figures/manifolds-$gamma.svg" >/dev/null
done
"$lober" transport ovp --param gamma=0.5 --iterates 5 --tolerance 1e-4 --picture "$figures/turnstile-0.5.svg" >/dev/null
"$lober" transport ovp --param gamma=0.5 --iterates 7 --tolerance 1e-5 --svg "$figures/fluxes-0.5.svg"
"$lober" transport ovp --sweep gamma=0.2:2.5:0.05 --find-zero --tolerance 1e-3 \
    --svg "$figures/areas-over-gamma.svg"
