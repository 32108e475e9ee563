#!/usr/bin/env bash
# The pairs of curves on which settings of the densifier are compared, made in a folder: two names a line. Lobes that cross,
# L12(2) with L21(0) and two of one turnstile; boundaries with their pre-images, which share an arc.
# usage: LOBER=PROGRAM densifier-pairs.sh FOLDER
set -euo pipefail
work=$1
"$LOBER" tangle --system ovp --param gamma=0.5 --before 2 --after 1 --tolerance 1e-3 --lobes "$work/lobes-ovp.dat" >/dev/null
"$LOBER" tangle --system pcr3bp --tolerance 1e-3 --lobes "$work/lobes-pcr3bp.dat" >/dev/null
"$LOBER" image ovp --param gamma=0.5 --boundary --iterates -1:0 --tolerance 1e-3 -o "$work/boundaries-ovp.dat" >/dev/null
"$LOBER" image pcr3bp --boundary --iterates -1:0 --tolerance 1e-3 -o "$work/boundaries-pcr3bp.dat" >/dev/null
echo "$work/lobes-ovp.dat#0 $work/lobes-ovp.dat#5"
echo "$work/lobes-pcr3bp.dat#2 $work/lobes-pcr3bp.dat#5"
echo "$work/boundaries-ovp.dat#1 $work/boundaries-ovp.dat#0"
echo "$work/boundaries-pcr3bp.dat#1 $work/boundaries-pcr3bp.dat#0"
