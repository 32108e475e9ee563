#!/usr/bin/env bash
# How long commands take from beginning to end, on one and on two threads: an earlier program beside this one, in turns.
# usage: bench-commands.sh EARLIER_PROGRAM [PROGRAM, default build/bin/lober [ROUNDS, default 5]]
# Prints a table of medians in seconds. Options that the earlier program spelled differently are translated.
set -euo pipefail
cd "$(dirname "$0")/.."
earlier=$(realpath "$1") program=$(realpath "${2:-build/bin/lober}") rounds=${3:-5}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export LC_ALL=C

commands='overlay examples/resonance.dat examples/resonance_image.dat
tangle examples/manifolds.dat --smooth --overlaps
grow standard --unstable --iterates 9 --tolerance 1e-8 -o OUT.npy
grow ovp --unstable --iterates 5 --tolerance 1e-6 -o OUT.npy
transport ovp
transport duffing
transport double-gyre
transport pcr3bp
transport henon
transport ovp --sweep gamma=0.2:2.5:0.05 --find-zero --tolerance 1e-3
escape capsize
escape capsize --energy 0.25307 --crossings 4
escape pcr3bp --energy -1.515 --crossings 0 --saddle 2'

# What the command was called before version 0.2.
earlier_spelling() {
  local line=$1
  case $line in
    escape*) line=${line/--crossings/--iterates} ;;
    grow*) line=${line/--tolerance/--tol} ;;
  esac
  echo "$line"
}

# seconds PROGRAM THREADS ARGUMENTS...; other ends than that of a wrong command line count as work done.
seconds() {
  local program=$1 threads=$2 begin=$EPOCHREALTIME status=0 end
  shift 2
  "$program" "$@" --threads "$threads" >"$scratch/out" 2>"$scratch/err" || status=$?
  end=$EPOCHREALTIME
  if [ "$status" -eq 2 ]; then
    echo "$program $*: $(tail -n 1 "$scratch/err")" >&2
    exit 1
  fi
  awk -v a="$begin" -v b="$end" 'BEGIN { printf "%.4f\n", b - a }'
}
median() { sort -n "$1" | awk '{ v[NR] = $1 } END { printf "%.2g", v[int((NR + 1) / 2)] }'; }

echo '| command | earlier, 1 thread | now | earlier, 2 threads | now |'
echo '|:--|--:|--:|--:|--:|'
while read -r line; do
  row="| \`lober $line\` |"
  for threads in 1 2; do
    : >"$scratch/earlier"
    : >"$scratch/now"
    for _ in $(seq "$rounds"); do
      # shellcheck disable=SC2046
      seconds "$earlier" "$threads" $(earlier_spelling "${line//OUT/$scratch/out}") >>"$scratch/earlier"
      # shellcheck disable=SC2086
      seconds "$program" "$threads" ${line//OUT/$scratch/out} >>"$scratch/now"
    done
    row+=" $(median "$scratch/earlier") | $(median "$scratch/now") |"
  done
  echo "$row"
done <<<"$commands"
