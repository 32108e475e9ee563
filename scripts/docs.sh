#!/usr/bin/env bash
# The figures and the numbers of the documents, made anew from the program and from bench/RESULTS.md.
# usage: docs.sh make [cheap]   writes docs/*.svg, docs/figures/*, the blocks of numbers and what ```console blocks show
#        docs.sh check [cheap]  makes them elsewhere, and fails when a committed one differs
# cheap: only those that take seconds.
#
# A block of numbers lies between <!-- begin NAME --> and <!-- end NAME -->; scripts/docs-blocks/NAME.sh prints it.
set -uo pipefail
cd "$(dirname "$0")/.."
mode=${1:-check}
cost=${2:-all}
lober=$(realpath "${BUILD:-build}")/bin/lober
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export LOBER=$lober

# Figure, cheap or costly, and the command whose last argument is the picture.
figures='
docs/demo.svg                       cheap   overlay examples/resonance.dat examples/resonance_image.dat --svg
docs/tangle.svg                     cheap   tangle examples/manifolds.dat --smooth --overlaps --svg
docs/section.svg                    cheap   section pendulum --orbits 40 --iterates 120 --svg
docs/winding.svg                    cheap   winding examples/loops.csv --grid 300,300 --svg
docs/figures/boundary-images-0.5.svg cheap  image ovp --boundary --param gamma=0.5 --iterates -3:0 --tolerance 1e-4 --svg
docs/figures/manifolds-0.5.svg      costly  tangle --system ovp --param gamma=0.5 --after 1 --before 2 --tolerance 1e-4 --svg
docs/figures/manifolds-1.81.svg     costly  tangle --system ovp --param gamma=1.81 --after 1 --before 2 --tolerance 1e-4 --svg
docs/figures/turnstile-0.5.svg      costly  transport ovp --param gamma=0.5 --iterates 5 --tolerance 1e-4 --picture
docs/figures/fluxes-0.5.svg         costly  transport ovp --param gamma=0.5 --iterates 7 --tolerance 1e-5 --svg
docs/figures/areas-over-gamma.svg   costly  transport ovp --sweep gamma=0.2:2.5:0.05 --find-zero --tolerance 1e-3 --svg
docs/escape.svg                     costly  escape capsize --energy 0.25307 --crossings 4 --svg
docs/escape-pcr3bp.svg              costly  escape pcr3bp --energy -1.515 --crossings 0 --saddle 2 --svg
'
# Documents with blocks; those of the costly kind are only made with all.
documents='README.md docs/figures.md docs/winding.md docs/images.md docs/sections.md docs/escape.md docs/published-forms.md'
costly_blocks='escape-table'

stale=0
# PLACE NEW: the committed file becomes the new one, or has to be it.
settle() {
  if [ "$mode" = make ]; then
    cmp -s "$2" "$1" || { mkdir -p "$(dirname "$1")"; cp "$2" "$1"; echo "wrote $1"; }
  elif ! cmp -s "$2" "$1"; then
    stale=$((stale + 1))
    echo "$1 is stale (make docs-figures):"
    diff "$1" "$2" | head -n 6 | cut -c 1-160 | sed 's/^/    /'
  fi
}

make_figures() {
  local figure price arguments
  while read -r figure price arguments; do
    [ -n "$figure" ] || continue
    [ "$cost" = all ] || [ "$price" = cheap ] || continue
    # shellcheck disable=SC2086
    "$lober" $arguments "$work/figure.svg" >/dev/null 2>"$work/err" ||
      { echo "$figure cannot be made: $(cat "$work/err")"; stale=$((stale + 1)); continue; }
    settle "$figure" "$work/figure.svg"
  done <<<"$figures"
}

# What stands between the marks of a block, replaced by what its script prints.
make_blocks() {
  local document=$1 name
  cp "$document" "$work/document"
  for name in $(sed -n 's/^<!-- begin \([a-z-]*\) -->$/\1/p' "$document"); do
    [ "$cost" = all ] || [[ " $costly_blocks " != *" $name "* ]] || continue
    "scripts/docs-blocks/$name.sh" >"$work/block" ||
      { echo "$document: block $name cannot be made"; stale=$((stale + 1)); continue; }
    awk -v block="$work/block" -v name="$name" '
      $0 == "<!-- end " name " -->" { inside = 0 }
      !inside { print }
      $0 == "<!-- begin " name " -->" { inside = 1; while ((getline line < block) > 0) print line }
    ' "$work/document" >"$work/next" && mv "$work/next" "$work/document"
  done
}

# The blocks of kind console: as many lines of what the command prints as are shown now, `...` for the rest. With check they
# are left to check-readme.sh, which knows how much a number may differ.
make_consoles() {
  local number kind line info command shown
  rm -rf "$work/blocks" && mkdir "$work/blocks"
  awk -v out="$work/blocks" -f scripts/blocks.awk "$work/document" >"$work/index"
  while read -r number kind line info; do
    [ "$kind" = console ] || continue
    [ "$cost" = all ] || [ "$info" != slow ] || continue
    command=$(sed -n '1s/^\$ //p' "$work/blocks/$number.body")
    shown=$(($(wc -l <"$work/blocks/$number.body") - 1))
    (PATH=$(dirname "$lober"):$PATH; eval "$command") >"$work/printed" 2>/dev/null </dev/null ||
      { echo "fails: $command"; stale=$((stale + 1)); continue; }
    { sed -n 1p "$work/blocks/$number.body"
      if [ "$(wc -l <"$work/printed")" -le "$shown" ]; then cat "$work/printed"; else head -n $((shown - 1)) "$work/printed"; echo ...; fi
    } >"$work/block"
    awk -v block="$work/block" -v first="$line" '
      NR > first && /^```/ && inside { inside = 0 }
      !inside { print }
      NR == first { inside = 1; while ((getline line < block) > 0) print line }
    ' "$work/document" >"$work/next"
    # The lines of the blocks that follow move only if this one became shorter.
    [ "$(wc -l <"$work/next")" -eq "$(wc -l <"$work/document")" ] || { mv "$work/next" "$work/document"; make_consoles; return; }
    mv "$work/next" "$work/document"
  done <"$work/index"
}

case $mode in make | check) ;; *) sed -n 3,5p "$0" >&2; exit 2 ;; esac
make_figures
for document in $documents; do
  [ -f "$document" ] || continue
  make_blocks "$document"
  [ "$mode" = check ] || make_consoles
  settle "$document" "$work/document"
done
[ "$mode" = make ] || echo "$stale stale"
[ "$stale" -eq 0 ]
