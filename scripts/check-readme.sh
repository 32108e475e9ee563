#!/usr/bin/env bash
# Executes every code block of README.md and of the documents: what they tell a reader to type works, on the files of the
# repository, in a temporary folder. Fails where a block fails, where a block says no kind, and where README.md has none of a
# kind that a reader begins with.
# usage: check-readme.sh [FILE.md...]        BUILD=build is the build folder
#
#   ```sh        run, in the order of the file; `make TARGET` is only asked whether it knows what to do
#   ```console   `$ command`, then what it prints: compared (same-output.awk). "slow" after the kind: not run with FAST=1
#   ```usage     the form of a command: every option is one that its --help knows
#   ```toml      a manifest: lober batch check, then lober batch run
#   ```cpp       a program: compiled against the installed package, and run
#   ```python    a program: run with the package that `make python` has installed, in the order of the file, all of a file
#                together; left out where there is none
#   ```output    what the programs before it printed last: compared
#   ```text      a picture in letters: nothing is done
set -uo pipefail
cd "$(dirname "$0")/.."
root=$PWD
build=$(realpath "${BUILD:-build}")
[ $# -gt 0 ] && files=("$@") || files=(README.md CONTRIBUTING.md docs/*.md docs/{tutorials,how-to,reference,explanation}/*.md)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r examples "$work/examples"
mkdir -p "$work/engine/lober"
cp engine/lober/lober_system.h "$work/engine/lober/"
export PATH=$build/bin:$PATH
[ -x "$build/bin/lober" ] || { echo "no program in $build/bin; build it first" >&2; exit 1; }

failures=0
blocks=0
fail() { # PLACE MESSAGE, then what was printed
  failures=$((failures + 1))
  echo "$1: $2"
  sed 's/^/    /' | head -n 15
}

run_sh() {
  sed "s|^make \(.*\)|make -n -C '$root' \1 >/dev/null|" "$1" >"$work/.script"
  (cd "$work" && timeout 600 bash -euo pipefail .script) >"$work/.out" 2>&1 </dev/null ||
    fail "$2" "a command fails" <"$work/.out"
}

run_console() {
  local command
  command=$(sed -n '1s/^\$ //p' "$1")
  [ -n "$command" ] || { fail "$2" "the first line is no \"\$ command\"" <"$1"; return; }
  tail -n +2 "$1" >"$work/.shown"
  (cd "$work" && timeout 600 bash -euo pipefail -c "$command") >"$work/.printed" 2>"$work/.err" </dev/null ||
    { fail "$2" "fails: $command" <"$work/.err"; return; }
  awk -f "$root/scripts/same-output.awk" "$work/.shown" "$work/.printed" >"$work/.out" ||
    fail "$2" "prints something else (make docs-figures): $command" <"$work/.out"
}

# The last lines that the Python programs of the same file have printed.
check_output() {
  [ -x "$build/python/venv/bin/python" ] || { echo "$2: left out, because there is no Python module (make python)"; return; }
  tail -n "$(wc -l <"$1")" "$work/.python.out" >"$work/.printed"
  awk -f "$root/scripts/same-output.awk" "$1" "$work/.printed" >"$work/.out" ||
    fail "$2" "the programs print something else" <"$work/.out"
}

# What is wrong with the form of a command, if anything.
usage_faults() {
  local form help option
  while read -r form; do
    case $form in
      "lober <"* | "lober -light "*) help=$(lober --help) ;;
      "lober batch "*) help=$(lober batch "$(cut -d' ' -f3 <<<"$form")" --help) ;;
      "lober transport --manifolds "*) help=$(lober transport --manifolds u s --help) ;;
      "lober tangle SYSTEM "*) help=$(lober tangle henon --help) ;;
      "lober "*) help=$(lober "$(cut -d' ' -f2 <<<"$form")" --help) ;;
      *) help= ;;
    esac
    [ -n "$help" ] || echo "there is no such command: $form"
    grep -oE '(^|[][ |=])-{1,2}[A-Za-z][A-Za-z-]*' <<<"$form" | tr -d '[]|= ' | sort -u | while read -r option; do
      grep -qE -- "(^|[^A-Za-z-])$option([^A-Za-z-]|$)" <<<"$help" || echo "$option is not in the help of: $form"
    done
  done
}

# A form goes on over the lines that begin with a blank.
check_usage() {
  awk '/^ /{line = line " " $0; next} {if (line != "") print line; line = $0} END {print line}' "$1" | usage_faults \
    >"$work/.out" 2>&1
  [ ! -s "$work/.out" ] || fail "$2" "a form that does not exist" <"$work/.out"
}

run_toml() {
  local manifest=$work/readme-$3.toml
  cp "$1" "$manifest"
  (cd "$work" && timeout 600 lober batch check "$manifest" && timeout 600 lober batch run --quiet "$manifest") \
    >"$work/.out" 2>&1 </dev/null || fail "$2" "the manifest fails" <"$work/.out"
}

run_cpp() {
  local project=$work/cpp-$3
  if [ ! -d "$work/prefix" ]; then
    cmake --install "$build" --prefix "$work/prefix" >"$work/.out" 2>&1 || { fail "$2" "does not install" <"$work/.out"; return; }
  fi
  mkdir -p "$project"
  cp "$1" "$project/main.cpp"
  cp tests/consumer/CMakeLists.txt "$project/"
  (cmake -S "$project" -B "$project/build" -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_BUILD_TYPE=Release &&
    cmake --build "$project/build" && cd "$work" && timeout 600 "$project/build/consumer") >"$work/.out" 2>&1 ||
    fail "$2" "does not compile, or fails" < <(tail -n 15 "$work/.out")
}

# The block and those before it in the same file, as a reader who follows it would have typed them.
run_python() {
  cat "$1" >>"$work/.python-$4.py"
  if [ ! -x "$build/python/venv/bin/python" ]; then
    echo "$2: left out, because there is no Python module (make python)"
    return
  fi
  (cd "$work" && MPLBACKEND=Agg timeout 600 "$build/python/venv/bin/python" -P ".python-$4.py") >"$work/.python.out" 2>&1 </dev/null ||
    fail "$2" "a program fails" < <(tail -n 15 "$work/.python.out")
}

for file in "${files[@]}"; do
  folder=$work/.blocks
  rm -rf "$folder"
  mkdir "$folder"
  awk -v out="$folder" -f scripts/blocks.awk "$file" >"$work/.index"
  if [ "$file" = README.md ]; then
    for kind in sh console python output; do
      grep -q "^[0-9]* $kind " "$work/.index" || fail "$file" "has no block of kind $kind" </dev/null
    done
  fi
  while read -r number kind line info; do
    place=$file:$line
    body=$folder/$number.body
    blocks=$((blocks + 1))
    if [ -n "${FAST:-}" ] && [ "$info" = slow ]; then
      echo "$place: left out, because it is slow"
      continue
    fi
    case $kind in
      sh) run_sh "$body" "$place" ;;
      console) run_console "$body" "$place" ;;
      usage) check_usage "$body" "$place" ;;
      toml) run_toml "$body" "$place" "$number" ;;
      cpp) run_cpp "$body" "$place" "$number" ;;
      python) run_python "$body" "$place" "$number" "$(basename "$file")" ;;
      output) check_output "$body" "$place" ;;
      text) ;;
      *) fail "$place" "a block of kind $kind: nobody checks it" <"$body" ;;
    esac
  done <"$work/.index"
done
echo "$blocks blocks of ${#files[@]} documents, $failures failures"
[ "$failures" -eq 0 ] && [ "$blocks" -gt 0 ]
