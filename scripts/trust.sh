#!/usr/bin/env bash
# docs/trust.md: the tables of what was tried and of the cases that other libraries get wrong.
# usage: trust.sh make            runs lober, GEOS and two versions of Boost.Geometry on the cases (seconds), writes the page
#        trust.sh check           does it elsewhere, and fails when a committed result or the page differs
#        trust.sh check page      only whether the page is what the committed results give
#        trust.sh boost           unpacks the headers of the newest Boost that Debian 12 has into build/boost
#        trust.sh record NAME     runs what takes long, and records what it prints: tests, stress or fuzz; then `make`
# The programs are those of the preset `bench`, in build or where BUILD says.
#
# Results lie in tests/trust: rivals.tsv, and NAME.txt with the command, the commit and the output. A block of the page lies
# between <!-- begin NAME --> and <!-- end NAME -->.
set -euo pipefail
export LC_ALL=C
cd "$(dirname "$0")/.."
build=${BUILD:-build}
lober=$build/bin/lober
page=docs/trust.md
cases=tests/corpus/trackers
results=tests/trust
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Each case by every library, into the file $1.
run_rivals() {
  local programs=("$build/bin/trackers_geos" "$build/bin/trackers_boost" "$build/bin/trackers_boost_newer"
    "$build/bin/trackers_clipper") program
  for program in "$build/bin/bench_trackers" "${programs[@]}"; do
    [ -x "$program" ] || { echo "$program is missing; make trust builds it" >&2; return 1; }
  done
  "$build/bin/bench_trackers" "$cases" "${programs[@]}" >"$1"
}

# What a line `# KEY: VALUE` of the case $1 says.
said() { sed -n "s/^# $2: //p" "$cases/$1.dat"; }

# The table of the cases, from rivals.tsv ($1).
cases_table() {
  local name exact error bar verdicts
  IFS=$'\t' read -r _ _ _ _ verdicts <"$1"
  echo "| case | reported | exact area | error of lober, its bar | ${verdicts//$'\t'/ | } |"
  echo "|---|---|---:|---:|$(tr -cd '\t' <<<"$verdicts" | sed 's/./---|/g')---|"
  tail -n +2 "$1" | while IFS=$'\t' read -r name exact error bar verdicts; do
    printf '| [%s](%s) | %s | %.6g | %s, %s | %s |\n' "$(said "$name" tracker)" "$(said "$name" link)" \
      "$(said "$name" reported)" "$exact" "$error" "$bar" "${verdicts//$'\t'/ | }"
  done | sort -t'[' -k2,2V
}

# How many cases each library has right, from rivals.tsv ($1).
cases_summary() {
  awk -F'\t' '
    NR == 1 { for (k = 5; k <= NF; ++k) name[k] = $k; columns = NF; next }
    {
      ++count
      if ($3 + 0 > $4 + 0) { print "an area of lober outside its bar: " $1 > "/dev/stderr"; bad = 1 }
      for (k = 5; k <= columns; ++k) {
        if ($k == "-") continue
        ++asked[k]
        if ($k ~ /\*\*wrong/) ++wrong[k]
        else if ($k ~ /^right(; as integers: right)?$/) ++right[k]
        else ++between[k]
      }
    }
    END {
      if (bad || !count) exit 1
      print "| | cases | all right | a small area, precision or validity wrong, or no answer | an area **wrong** |"
      print "|---|---:|---:|---:|---:|"
      print "| lober | " count " | " count " | 0 | 0 |"
      for (k = 5; k <= columns; ++k) print "| " name[k] " | " asked[k] + 0 " | " right[k] + 0 " | " between[k] + 0 " | " wrong[k] + 0 " |"
    }
  ' "$1"
}

# The notes of cases that have one.
cases_notes() {
  local file note
  for file in "$cases"/*.dat; do
    note=$(sed -n 's/^# note: //p' "$file")
    [ -z "$note" ] || echo "- $(sed -n 's/^# tracker: //p' "$file"): $note."
  done
  echo "- Of several rings, and so with \`--rule nonzero\`: $(grep -l -- '--rule nonzero$' "$cases"/*.dat | while read -r file; do
    sed -n 's/^# tracker: //p' "$file"
  done | sort -uV | paste -sd, | sed 's/,/, /g')."
}

# What took long is run again, and what it prints is kept: the command, the commit, the lines that say something.
record() {
  local command keep
  case $1 in
    tests) command="ctest --test-dir $build -N" keep='^Total Tests:' ;;
    stress) command=scripts/stress.sh keep='.' ;;
    fuzz) command='scripts/fuzz.sh 60' keep='.' ;;
    *) echo "trust.sh record tests|stress|fuzz" >&2; return 2 ;;
  esac
  $command >"$work/output" 2>&1 || { tail -n 40 "$work/output"; echo "$command fails; nothing is recorded" >&2; return 1; }
  { echo "\$ $command"
    echo "commit $(git rev-parse --short HEAD) of $(git log -1 --format=%cs), $(nproc) cores"
    grep -E "$keep" "$work/output" | grep -vE '^\[ +(RUN|OK) |^\[-+\]|^Running main|^Note: Google' | uniq
  } >"$results/$1.txt"
  echo "wrote $results/$1.txt"
}

# The rows of what was tried, from the records that there are.
tried() {
  local record records=()
  for record in tests stress fuzz; do
    [ ! -f "$results/$record.txt" ] || records+=("$results/$record.txt")
  done
  echo '| tried | how often | outcome | by |'
  echo '|---|---:|---|---|'
  # shellcheck disable=SC2016
  awk -v kills="$(sed -n 's/^LOBER_KILLS=\([0-9]*\) .*/\1/p' scripts/stress.sh)" '
    function number(value,   text) { text = sprintf("%d", value); while (match(text, /[0-9][0-9][0-9][0-9]( |$)/)) text = substr(text, 1, RSTART) " " substr(text, RSTART + 1); return text }
    function row(what, count, outcome, by) {
      if (!count) { print "nothing recorded of: " what > "/dev/stderr"; bad = 1 }
      printf "| %s | %s | %s | `%s` |\n", what, number(count), outcome, by
    }
    FILENAME ~ /tests.txt$/ && /^Total Tests:/ { tests = $3 }
    / overlays, [0-9]+ wrong; / { ++families; overlays += $2; overlays_wrong += $4; match($0, /area [0-9.e+-]+ of itself/); e = substr($0, RSTART + 5) + 0; if (e > overlay_error) overlay_error = e }
    / pairs, [0-9]+ wrong, / { ++shapes; regions += $2; regions_wrong += $4; pieces += $6; match($0, /area [0-9.e+-]+ of itself/); e = substr($0, RSTART + 5) + 0; if (e > region_error) region_error = e }
    / tangles \(/ { tangles = $1 }
    / with the same areas exactly; / { ++transformations }
    /, (overlay|interior) +[0-9]/ { sub(/^.*, (overlay|interior) +/, ""); areas += $1; outside += $2 }
    /^[0-9]+ pairs of / { pairs += $1; ++kinds }
    /^(C1|C2|intersection|union|symmetric difference|C1 minus C2|C2 minus C1) +[0-9.]+ .*%$/ { within = $NF + 0; if (lowest == "" || within < lowest) lowest = within }
    /^bars of transport/ { match($0, /[0-9]+ of [0-9]+ comparisons outside/); split(substr($0, RSTART), part, " "); compared = part[3]; compared_out = part[1]; match($0, /is [0-9.e+-]+ bars/); largest = substr($0, RSTART + 3) + 0 }
    FILENAME ~ /fuzz.txt$/ && /no finding, / { inputs += $(NF - 1); ++targets }
    # The programs of stress.sh in their order: pairs, stability, transport, the same bits, killed batches.
    FILENAME ~ /stress.txt$/ && /PASSED/ { passed[++programs] = $4 }
    FILENAME ~ /stress.txt$/ && /FAILED/ { print "the recorded stress has failures" > "/dev/stderr"; bad = 1 }
    END {
      if (tests) row("tests of the suite", tests, "a change lands only when all pass", "make test")
      row("overlays of random pairs of " families " families, against rational arithmetic (GMP) written from the definitions", overlays, overlays_wrong " wrong; an area is off by " overlay_error " of itself at most", "make stress")
      row("winding regions of random pairs of " shapes " families that cross themselves, against exact slabs", regions, regions_wrong " wrong in " number(pieces) " pieces; an area is off by " region_error " of itself at most", "make stress")
      row("tangles of random curves: primary crossings against their definition in rational arithmetic, areas against overlays", tangles, "none wrong", "make stress")
      row("areas of random pairs under " transformations " transformations (moved, scaled, rotated, subdivided, ...), by `overlay` and by `interior`: is the exact area inside the bar?", areas, outside " outside", "make stress")
      row("pairs of smooth curves of " kinds " kinds: is the estimated discretisation error within a factor 2 of the true one?", pairs, lowest " % of each area at least", "make stress")
      row("fluxes, lobes and regions by two independent routes: do they agree within the sum of their bars?", compared, compared_out " outside; the largest difference is " largest " bars", "make stress")
      row("scenes of a million points and systems, each with all numbers of threads, indices and instruction sets: are the bits the same?", passed[4], "all the same", "make stress")
      row("batches killed in the middle: is a stored result lost or changed?", passed[5] >= 1 ? kills : 0, "none", "make stress")
      if (targets) row("inputs to the " targets " fuzz targets (readers of curves and stores) under ASan and UBSan", inputs, "no finding", "scripts/fuzz.sh 60")
      exit bad
    }
  ' "${records[@]}"
  echo
  for record in "${records[@]}"; do
    sed -n "2s|^commit \(.*\)|\`$record\`: commit \1.|p" "$record"
  done | paste -sd' '
}

# What lober prints for two polygons that overlap by little; another library called one of them their intersection.
example() {
  echo '```text'
  echo '$ lober overlay boost-geometry-1439.dat#C1 boost-geometry-1439.dat#C2'
  (program=$(realpath "$lober") && cd "$cases" && "$program" overlay boost-geometry-1439.dat#C1 boost-geometry-1439.dat#C2) | sed -n '/^area of/,/^C1 or C2/p'
  echo ...
  echo '```'
}

# The page with its blocks made anew from $1, the results of the rivals, into $2.
make_page() {
  local name
  cp "$page" "$2"
  for name in $(sed -n 's/^<!-- begin \([a-z-]*\) -->$/\1/p' "$page"); do
    case $name in
      example) example ;;
      tried) tried ;;
      cases-summary) cases_summary "$1" ;;
      cases-table) cases_table "$1" ;;
      cases-notes) cases_notes ;;
      *) echo "no block $name" >&2; return 1 ;;
    esac >"$work/block"
    awk -v block="$work/block" -v name="$name" '
      $0 == "<!-- end " name " -->" { inside = 0 }
      !inside { print }
      $0 == "<!-- begin " name " -->" { inside = 1; while ((getline line < block) > 0) print line }
    ' "$2" >"$work/next"
    mv "$work/next" "$2"
  done
}

# Results are of the cases that there are: their names and exact areas.
check_results() {
  local name exact
  tail -n +2 "$1" | cut -f1 >"$work/names"
  diff <(for name in "$cases"/*.dat; do basename "$name" .dat; done) "$work/names" >/dev/null ||
    { echo "tests/trust/rivals.tsv has not the cases of $cases; make trust" >&2; return 1; }
  tail -n +2 "$1" | while IFS=$'\t' read -r name exact _; do
    [ "$(said "$name" "area $(said "$name" operation)")" = "$exact" ] ||
      { echo "tests/trust/rivals.tsv has another area of $name; make trust" >&2; return 1; }
  done
}

# same COMMITTED NEW: whether they are the same; shows where not.
same() {
  cmp -s "$1" "$2" && return
  echo "$1 is stale (make trust):"
  diff "$1" "$2" | head -n 6 | cut -c 1-160 | sed 's/^/    /'
  return 1
}

case "${1:-} ${2:-}" in
  "make ")
    run_rivals "$work/rivals.tsv"
    check_results "$work/rivals.tsv"
    cp "$work/rivals.tsv" "$results/rivals.tsv"
    make_page "$results/rivals.tsv" "$work/page"
    cmp -s "$work/page" "$page" || { cp "$work/page" "$page"; echo "wrote $page"; }
    ;;
  "check " | "check page")
    if [ -z "${2:-}" ]; then
      run_rivals "$work/rivals.tsv"
      same "$results/rivals.tsv" "$work/rivals.tsv"
    fi
    check_results "$results/rivals.tsv"
    make_page "$results/rivals.tsv" "$work/page"
    same "$page" "$work/page"
    echo "$(wc -l <"$work/names") cases, 0 stale"
    ;;
  "boost ")
    [ -f "$build/boost/usr/include/boost/version.hpp" ] && exit
    mkdir -p "$build/boost"
    (cd "$build/boost" && apt-get -q download libboost1.81-dev && dpkg-deb -x libboost1.81-dev_*.deb . && rm libboost1.81-dev_*.deb)
    ;;
  "record "*) record "$2" ;;
  *) sed -n 3,8p "$0" >&2; exit 2 ;;
esac
