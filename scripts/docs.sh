#!/usr/bin/env bash
# The figures and the numbers of the documents, made anew from the program and from bench/RESULTS.md.
# usage: docs.sh make [cheap|paper]   writes docs/*.svg, docs/paper/*, the blocks of numbers and what ```console blocks show
#        docs.sh check [cheap|paper]  makes them elsewhere, and fails when a committed one differs
# The pictures of the gallery, docs/gallery/*.svg, are those of docs/gallery/pictures.txt.
# cheap: only those that take seconds. paper: only what docs/paper.md shows, cheap or not. In place of these: one document
# or figure.
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

# File, cheap or costly, and the command: its last argument is the picture; what goes to a .txt is what it prints. Files
# of work/ are what later commands read, as @work. Texts with blanks stand in double quotes.
figures='
docs/demo.svg                       cheap   overlay examples/resonance.dat examples/resonance_image.dat --svg
docs/tangle.svg                     cheap   tangle examples/manifolds.dat --smooth --overlaps --svg
docs/section.svg                    cheap   section pendulum --orbits 40 --iterates 120 --svg
docs/section-abc.svg                cheap   section abc --orbits 400 --iterates 300 --svg
docs/winding.svg                    cheap   winding examples/loops.csv --grid 300,300 --svg
docs/paper/fig-01.svg        cheap   transport ovp --param gamma=0.5 --all-regions --iterates 1 --tolerance 1e-4 --picture
docs/paper/fig-02a.svg       cheap   tangle --system henon --before 2 --after 2 --tolerance 1e-4 --labels --window=-2.4,-2.2,3,2.6 --svg
docs/paper/fig-02bc.svg      cheap   overlay examples/six-crossings.dat#C1 examples/six-crossings.dat#C2 --svg
docs/paper/fig-03.svg        cheap   overlay examples/resonance.dat examples/resonance_image.dat --classes --window 4.45,2.95,4.95,3.3 --svg
docs/paper/fig-04.svg        cheap   overlay examples/six-crossings.dat#C1 examples/six-crossings.dat#C2 --classes --svg
docs/paper/tables-1-4.txt    cheap   overlay examples/six-crossings.dat#C1 examples/six-crossings.dat#C2 --classes
work/boundaries.dat          cheap   image ovp --boundary --param gamma=0.5 --iterates -1:0 --tolerance 1e-4 -o
work/B.dat                   cheap   densify @work/boundaries.dat#1 --simplify 0.05 -o
work/pre-image.dat           cheap   densify @work/boundaries.dat#0 --simplify 0.05 -o
docs/paper/fig-05.svg        cheap   overlay @work/B.dat @work/pre-image.dat --inset=-1.33,0.98,-1.05,1.26 --labels --title "C_{1}: the boundary B(q), C_{2}: its pre-image, coarsely" --svg
docs/paper/fig-06a.svg       cheap   tangle --system pcr3bp --tolerance 1e-4 --window=-1.56,0.165,-1.24,0.205 --labels --svg
docs/paper/fig-06b.svg       cheap   tangle --system pcr3bp --tolerance 1e-4 --labels --svg
docs/paper/fig-07.svg        cheap   interior examples/six-crossings.dat#C1 examples/six-crossings.dat#C2 --svg
docs/paper/fig-09a.svg       cheap   levels ovp --param eps=0 --box=-3,-3,3,3 --svg
docs/paper/fig-11a.svg       cheap   tangle --system ovp --param gamma=0.5 --after 1 --before 2 --tolerance 1e-4 --inset=-1.55,-0.05,-0.85,0.9 --svg
docs/paper/fig-11b.svg       cheap   tangle --system ovp --param gamma=1.81 --after 1 --before 2 --tolerance 1e-4 --window=-2,-0.1,2.2,2.1 --inset=-1.7,-0.05,-1.1,0.6 --svg
docs/paper/fig-11c.svg       cheap   tangle --system ovp1 --param gamma=0.5 --after 1 --before 2 --tolerance 1e-4 --inset=-1.55,-0.05,-0.85,0.9 --svg
docs/paper/fig-11d.svg       cheap   tangle --system ovp1 --param gamma=1.81 --after 1 --before 2 --tolerance 1e-4 --window=-2,-0.1,2.2,2.1 --inset=-1.7,-0.05,-1.1,0.6 --svg
docs/paper/fig-11e.svg       cheap   tangle --system ovp --param gamma=0.5 --param eps=0.5 --after 1 --tolerance 1e-4 --svg
docs/paper/fig-11f.svg       cheap   tangle --system ovp --param gamma=1.81 --param eps=0.5 --tolerance 1e-3 --max-work 1e9 --svg
work/U-1.dat                 cheap   grow ovp1 --param gamma=0.5 --param eps=0.5 --unstable --length 4.6 --tolerance 1e-4 --box=-4,-4,4,4 -o
work/S-1.dat                 cheap   grow ovp1 --param gamma=0.5 --param eps=0.5 --stable --length 4.6 --tolerance 1e-4 --box=-4,-4,4,4 -o
docs/paper/fig-11g.svg       cheap   tangle @work/U-1.dat @work/S-1.dat --title "ovp1: gamma = 0.5, eps = 0.5, phase = 0" --svg
work/U-2.dat                 cheap   grow ovp1 --param gamma=1.81 --param eps=0.5 --unstable --length 4 --tolerance 1e-4 --box=-4,-4,4,4 -o
work/S-2.dat                 cheap   grow ovp1 --param gamma=1.81 --param eps=0.5 --stable --length 4 --tolerance 1e-4 --box=-4,-4,4,4 -o
docs/paper/fig-11h.svg       cheap   tangle @work/U-2.dat @work/S-2.dat --title "ovp1: gamma = 1.81, eps = 0.5, phase = 0" --svg
docs/paper/fig-12.svg        cheap   image ovp --boundary --param gamma=0.5 --iterates -4:0 --tolerance 1e-4 --svg
docs/paper/fig-12-zoom.svg   cheap   image ovp --boundary --param gamma=0.5 --iterates -4:0 --tolerance 1e-4 --window 0.7,-0.02,1.6,0.78 --svg
docs/paper/fig-13.svg        cheap   transport ovp --param gamma=0.5 --iterates 5 --tolerance 1e-4 --inset=-1.3,0.05,-0.85,0.7 --picture
docs/paper/fig-13b.svg       cheap   transport ovp --param gamma=1.81 --iterates 5 --tolerance 1e-4 --window=-1.8,-0.1,2.2,2.1 --inset=-1.68,-0.05,-1.08,0.6 --picture
docs/paper/fig-14a.svg       costly  transport ovp --sweep gamma=0.2:2.5:0.05 --find-zero --melnikov --tolerance 1e-3 --svg
docs/paper/melnikov-eps.svg  cheap   transport ovp --sweep eps=0.01:0.3:0.01 --melnikov --tolerance 1e-3 --svg
docs/paper/fig-14a-ovp1.svg  costly  transport ovp1 --sweep gamma=0.2:2.5:0.05 --find-zero --tolerance 1e-3 --svg
docs/paper/fig-14b.svg       costly  transport ovp --param gamma=0.5 --iterates 7 --tolerance 1e-5 --normalise --svg
docs/paper/fig-14b-ovp1.svg  cheap   transport ovp1 --param gamma=0.5 --iterates 7 --tolerance 1e-5 --normalise --svg
docs/paper/fig-15.svg        cheap   levels capsize --at 0.125,0.25,0.5,1 --box=-2,-1.2,2,1.8 --grid 320,240 --svg
docs/paper/fig-16a.svg       cheap   levels capsize --energy 0.22 --box=-1.8,-0.8,1.8,1.4 --svg
docs/paper/fig-16b.svg       cheap   levels capsize --energy 0.25 --box=-1.8,-0.8,1.8,1.4 --svg
docs/paper/fig-16c.svg       cheap   levels capsize --energy 0.28 --box=-1.8,-0.8,1.8,1.4 --periodic-orbits --svg
docs/paper/fig-17a.svg       cheap   section capsize --param energy=0.22 --orbits 60 --iterates 500 --svg
docs/paper/fig-17b.svg       cheap   section capsize --param energy=0.25 --orbits 60 --iterates 500 --svg
docs/paper/fig-17c.svg       cheap   section capsize --param energy=0.28 --orbits 2000 --iterates 500 --svg
docs/paper/exit-times.svg    cheap   section capsize --exit-times --iterates 6 --svg
docs/paper/fig-18a.svg       costly  escape capsize --energy 0.28 --saddle 2 --crossings 0 --direction + --tubes-of stable --trajectory=-0.1,0.28 --trajectory=0.2,0.4 --tubes
docs/paper/fig-18b.svg       costly  escape capsize --energy 0.28 --crossings 0 --direction + --tubes
docs/paper/fig-19a.svg       costly  escape capsize --energy 0.25307 --crossings 1 --svg
docs/paper/fig-19b.svg       costly  escape capsize --energy 0.25307 --crossings 4 --svg
docs/paper/table-5.txt       costly  escape capsize --energy 0.25307 --crossings 4
docs/paper/table-5-0.253.txt costly  escape capsize --energy 0.253 --crossings 4
docs/escape-pcr3bp.svg              costly  escape pcr3bp --energy -1.515 --crossings 0 --saddle 2 --svg
'
# Those of the gallery, all cheap: files of work/ and pictures.
figures+=$(sed -E '/^#/d; /^\|/d; s/@/@work\//g; s/^([^ |]+\.[^ |]+) *\|[^|]*\| *(.*)$/work\/\1 cheap \2/; s/^([^ |/]+) *\|[^|]*\| *(.*)$/docs\/gallery\/\1.svg cheap \2/' docs/gallery/pictures.txt)
# Documents with blocks; those of the costly kind are only made with all.
documents='README.md docs/reference/formats.md docs/paper.md docs/figures.md docs/published-forms.md docs/reference.md '$(ls docs/explanation/*.md docs/how-to/*.md docs/tutorials/*.md | tr '\n' ' ')
costly_blocks=''

stale=0
# PLACE NEW: the committed file becomes the new one, or has to be it.
settle() {
  if [ "$mode" = make ]; then
    cmp -s "$2" "$1" || { mkdir -p "$(dirname "$1")"; cp "$2" "$1"; echo "wrote $1"; }
  elif [[ $1 == *.svg ]] && awk -f scripts/same-figure.awk "$1" "$2" >/dev/null; then
    :  # to a tenth of a pixel
  elif ! cmp -s "$2" "$1"; then
    stale=$((stale + 1))
    echo "$1 is stale (make docs-figures):"
    diff "$1" "$2" | head -n 6 | cut -c 1-160 | sed 's/^/    /'
  fi
}

# Whether files of this name and price are made.
wanted() {
  case $cost in
    all) ;;
    paper) [[ $1 == docs/paper/* || $1 == work/* ]] ;;
    cheap) [ "$2" = cheap ] ;;
    *.md) false ;;
    *) [[ $1 == "$cost" || $1 == work/* ]] ;;
  esac
}

make_figures() {
  local figure price arguments made
  mkdir -p "$work/work"
  while read -r figure price arguments; do
    [ -n "$figure" ] && wanted "$figure" "$price" || continue
    arguments=${arguments//@work/$work/work}
    made=$work/figure.${figure##*.}
    case $figure in
      work/*) made=$work/$figure ;&
      *.svg) arguments="$arguments $made" ;;
    esac
    eval "set -- $arguments"
    "$lober" "$@" >"$work/printed" 2>"$work/err" || { echo "$figure cannot be made: $(cat "$work/err")"; stale=$((stale + 1)); continue; }
    [[ $figure != *.txt ]] || cp "$work/printed" "$made"
    [[ $figure == work/* ]] || settle "$figure" "$made"
  done <<<"$figures"
}

# What stands between the marks of a block, replaced by what its script prints.
make_blocks() {
  local document=$1 name
  cp "$document" "$work/document"
  for name in $(sed -n 's/^<!-- begin \([a-z-]*\) -->$/\1/p' "$document"); do
    [ "$cost" != cheap ] || [[ " $costly_blocks " != *" $name "* ]] || continue
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
    [ "$cost" != cheap ] || [ "$info" != slow ] || continue
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

case "$mode $cost" in
  "make all" | "make cheap" | "make paper" | "check all" | "check cheap" | "check paper") ;;
  "make "*.md | "check "*.md) documents=$cost ;;
  "make docs/"* | "check docs/"*) documents= ;;
  *) sed -n 3,7p "$0" >&2; exit 2 ;;
esac
[ "$cost" != paper ] || documents=docs/paper.md
make_figures
for document in $documents; do
  [ -f "$document" ] || continue
  make_blocks "$document"
  [ "$mode" = check ] || make_consoles
  settle "$document" "$work/document"
done
[ "$mode" = make ] || echo "$stale stale"
[ "$stale" -eq 0 ]
