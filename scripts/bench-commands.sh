#!/usr/bin/env bash
# How long commands take from beginning to end, on one and on two threads.
# usage: bench-commands.sh [PROGRAM, default build/bin/lober [ROUNDS, default 5 [EARLIER]]]
# Prints a table of medians in seconds. EARLIER, a program of an earlier version, runs in turns with PROGRAM; options that
# it spelled differently are translated. What takes more than ten seconds runs once, for a
# minute at most.
set -euo pipefail
cd "$(dirname "$0")/.."
program=$(realpath "${1:-build/bin/lober}") rounds=${2:-5} earlier=${3:-}
[ -z "$earlier" ] || earlier=$(realpath "$earlier")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export LC_ALL=C
limit=60

commands='--version
overlay examples/resonance.dat examples/resonance_image.dat
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
  [ "$1" = --version ] || set -- "$@" --threads "$threads"  # which it refuses
  timeout --signal=KILL "$limit" "$program" "$@" >"$scratch/out" 2>"$scratch/err" || status=$?
  end=$EPOCHREALTIME
  [ "$status" -ne 137 ] || { echo ">$limit"; return; }
  if [ "$status" -eq 2 ]; then  # an option that it does not know, or did not then
    [ "$program" != "$earlier" ] || { echo -; return; }
    echo "$program $*: $(tail -n 1 "$scratch/err")" >&2
    exit 1
  fi
  awk -v a="$begin" -v b="$end" 'BEGIN { printf "%.4f\n", b - a }'
}
is_long() { awk '/^>/ || $1 > 10 { long = 1 } END { exit !long }' "$1"; }
median() { sort -n "$1" | awk '{ v[NR] = $1 } END { m = v[int((NR + 1) / 2)]; print m ~ /^[->]/ ? m : sprintf("%.2g", m) }'; }

programs=("$program")
[ -z "$earlier" ] || programs=("$earlier" "$program")
row='| command |' line='|:--|'
for threads in '1 thread' '2 threads'; do
  [ -z "$earlier" ] || row+=" earlier, $threads |" line+='--:|'
  row+=" $threads |" line+='--:|'
done
echo "$row"
echo "$line"
while read -r command; do
  row="| \`lober $command\` |"
  for threads in 1 2; do
    rm -f "$scratch"/times.*
    for _ in $(seq "$rounds"); do
      for k in "${!programs[@]}"; do
        spelled=${command//OUT/$scratch/out}
        [ ! -s "$scratch/times.$k" ] || ! is_long "$scratch/times.$k" || continue
        [ "${programs[k]}" = "$program" ] || spelled=$(earlier_spelling "$spelled")
        # shellcheck disable=SC2086
        seconds "${programs[k]}" "$threads" $spelled >>"$scratch/times.$k"
      done
    done
    for k in "${!programs[@]}"; do row+=" $(median "$scratch/times.$k") |"; done
  done
  echo "$row"
done <<<"$commands"
