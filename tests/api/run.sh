#!/usr/bin/env bash
# What users of engine/lober/ rely on: each header compiles by itself with all warnings as errors, needs no other header
# of ours, the examples in their comments compile, and curves of the wrong kind and views of temporaries do not. "Private" is a fact: who includes what is looked at too.
# What a shared library must export is marked, and inline functions have no bits that depend on the flags of the user.
# usage: run.sh SOURCE_FOLDER COMPILER...
set -uo pipefail
root=$1
shift
headers=$root/engine/lober
public=("$headers"/*.hpp "$headers"/*/*.hpp)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

compiles() { "$compiler" -std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -I"$root/engine" "$@" >"$work/log" 2>&1; }

checked=0
for compiler in "$@"; do
  command -v "$compiler" >/dev/null || { echo "no $compiler here"; continue; }
  for header in "${public[@]}"; do
    echo "#include \"lober/${header#"$headers/"}\"" >"$work/one.cpp"
    compiles "$work/one.cpp" || { fail "$compiler, ${header#"$headers/"} alone:"; head -n 5 "$work/log"; }
    checked=$((checked + 1))
  done
  for header in lober.h lober_system.h; do
    echo "#include \"lober/$header\"" | tee "$work/one.cpp" >"$work/one.c"
    compiles "$work/one.cpp" || { fail "$compiler, $header alone:"; head -n 5 "$work/log"; }
    "$compiler" -x c -std=c99 -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Werror -I"$root/engine" "$work/one.c" >"$work/log" 2>&1 ||
      { fail "$compiler, $header alone, as C:"; head -n 5 "$work/log"; }
    checked=$((checked + 1))
  done
  awk -f "$root/tests/api/examples.awk" "${public[@]}" >"$work/examples.cpp"
  compiles -Wno-unused-variable -Wno-unused-parameter -Wno-shadow -include "$root/tests/api/example_names.hpp" "$work/examples.cpp" ||
    { fail "$compiler, examples of the headers:"; head -n 15 "$work/log"; }
  examples=$(grep -c '^void example' "$work/examples.cpp")
  [ "$examples" -ge 9 ] || fail "there are $examples examples in the headers"
  checked=$((checked + 1))
  # What compiles in one file; what does not case by case, with the headers read once.
  source=$root/tests/api/must_not_compile/curves.cpp
  awk '/^#(el)?if RIGHT ==/ {in_case = right = 1; print "{"; next}
       /^#elif WRONG ==/ {if (right) print "}"; right = 0; next}
       /^#endif/ {in_case = 0; next}
       right || !in_case' "$source" >"$work/right.cpp"
  compiles -Wno-unused-variable -Wno-unused-parameter "$work/right.cpp" || { fail "$compiler, what has to compile does not:"; head -n 5 "$work/log"; }
  grep '^#include "' "$source" >"$work/headers.hpp"
  read_once=(-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -Wno-unused-variable -Wno-unused-parameter)
  "$compiler" -std=c++20 "${read_once[@]}" -x c++-header -I"$root/engine" "$work/headers.hpp" -o "$work/headers.hpp.gch"
  wrong=$(grep -oE 'WRONG == [0-9]+' "$source" | grep -oE '[0-9]+')
  [ "$(echo "$wrong" | wc -w)" -ge 25 ] || fail "cases that must not compile: $wrong"
  for number in 0 $wrong; do
    if compiles "${read_once[@]}" -include "$work/headers.hpp" -DRIGHT=0 -DWRONG="$number" "$source"; then
      [ "$number" = 0 ] || fail "$compiler, case $number compiles"
    else
      [ "$number" != 0 ] || { fail "$compiler, no case at all does not compile:"; head -n 5 "$work/log"; }
    fi
    checked=$((checked + 1))
  done
  rm -f "$work"/headers.hpp*
done

# The commands that comments show to users: of the examples, in the folder of the sources; of lober_system.h, with a system
# of one's own. The program is there in tests of the build (LOBER).
mkdir "$work/user"
ln -s "$root/engine" "$root/examples" "$work/user/"
cp "$root/examples/quadratic_map.c" "$work/user/mysystem.c"
shown=0
for file in "$root"/examples/*.c "$root"/examples/*.cpp "$headers/lober_system.h"; do
  while read -r command; do
    shown=$((shown + 1))
    case $command in
      "lober "*) [ -n "${LOBER:-}" ] || continue; command="$LOBER ${command#lober }" ;;
    esac
    (cd "$work/user" && CPATH=$([ "$file" = "$headers/lober_system.h" ] && echo "$root/engine") bash -c "$command") >"$work/log" 2>&1 ||
      { fail "$(basename "$file") shows a command that fails: $command"; head -n 5 "$work/log"; }
  done < <(head -n 12 "$file" | grep -oE '(cc|c\+\+) -[^*]* -o [^*]*|^ +lober [a-z].*' | sed 's/^ *//; s/ *$//')
done
[ "$shown" -ge 4 ] || fail "comments show $shown commands"
grep -q -- '--system' "$headers/lober_system.h" && fail "lober_system.h names --system, which most commands do not have"
# A shell takes < and > for itself. COORDINATE<VALUE is the name of the value in a table of options.
bad=$(grep -nE -- '--bound [^" `|]*[<>]' "$root"/README.md "$root"/docs/*.md "$root"/docs/*/*.md | grep -vF -- '`--bound COORDINATE<VALUE`')
[ -z "$bad" ] || fail "limits without quotes:
$bad"

# What is public is in namespace lober, all else of the engine and the kernels in lober::detail.
bad=$(grep -rnE '^namespace lober( |$|::[a-ce-z])' "$root/kernels" "$root/engine" --include=*.hpp --include=*.inl | grep -v "^$headers/")
[ -z "$bad" ] || fail "private headers that are not in lober::detail:
$bad"
bad=$(awk '/^namespace detail/ {inside = 1; next} /^}  \/\/ namespace detail/ {inside = 0} FILENAME !~ /curve\.hpp$/ && inside && !/^(class|struct) [A-Za-z]+;/ {print FILENAME ": " $0}' "${public[@]}")
[ -z "$bad" ] || fail "public headers with more of lober::detail than names:
$bad"

# Who may include what. Public headers stand on themselves.
bad=$(grep -nE '#include "' "${public[@]}" | grep -v '#include "lober/')
[ -z "$bad" ] || fail "public headers that include private ones:
$bad"
# A library of engine/ takes from another one only what is public; base and kernels are there for all of them.
for library in geometry files dynamics batch c; do
  bad=$(grep -rnE '#include "engine/' "$root/engine/$library" | grep -vE "#include \"engine/(base|$library)/")
  [ -z "$bad" ] || fail "engine/$library includes private headers of another library:
$bad"
done
bad=$(grep -rnE '#include "engine/(geometry|dynamics)/' "$root/cli" "$root/examples" "$root/tests/consumer")
[ -z "$bad" ] || fail "private headers of geometry and dynamics outside of the engine:
$bad"

# Users of C and Python have no options of the command line: messages name the quantity (engine/base/quantities.hpp).
bad=$(grep -rnE --include='*.cpp' --include='*.hpp' --include='*.inl' '^[^/]*"[^"]*(--[a-z]|-DENS)' "$root/engine")
[ -z "$bad" ] || fail "messages of the engine that name options of the program:
$bad"

bad=$(awk -f "$root/tests/api/exported.awk" "${public[@]}")
[ -z "$bad" ] || fail "functions of public headers without LOBER_API:
$bad"

# Users compile our inline functions with flags of their own. A product and a sum in one of them could be fused there
# (docs/conventions.md, section 12): made to, GCC shows where.
if [ "$(uname -m)" = x86_64 ] && command -v g++ >/dev/null; then
  for header in "${public[@]}"; do echo "#include \"lober/${header#"$headers/"}\""; done >"$work/all.cpp"
  g++ -std=c++20 -O2 -fno-tree-vectorize -mfma -ffp-contract=fast -fkeep-inline-functions -I"$root/engine" -S -o "$work/all.s" "$work/all.cpp" ||
    fail "all headers together"
  bad=$(awk '/^_Z.*:/ {ours = /^_ZN?K?5lober/; name = $1} /vfn?m/ && ours {print name, $0}' "$work/all.s" | c++filt)
  [ -z "$bad" ] || fail "inline functions of public headers that are not the same under contraction:
$bad"
  grep -q '^_ZN5lober' "$work/all.s" || fail "GCC keeps no inline function"
else
  echo "contraction of inline functions: not looked at, because it takes g++ for x86-64"
fi

echo "$checked compilations, $failures failures"
[ "$failures" -eq 0 ]
