#!/usr/bin/env bash
# Installs one form of the built package, moves it elsewhere, and uses it from a project that knows nothing of this one: by
# find_package and by pkg-config, with all warnings as errors. Status 77, with the reason, where something is missing.
# usage: run.sh CMAKE BUILD_FOLDER VERSION static|shared COMPILER [SANITIZERS]
set -euo pipefail
cmake=$1 build=$2 version=$3 form=$4 compiler=$5 sanitize=${6:-}
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
need() {
  command -v "$1" >/dev/null && return
  # In the words of GoogleTest, as scripts/run-tests.sh prints the line after this one.
  printf '%s: Skipped\nthere is no %s here, for which an installed lober is tested\n' "$0" "$1"
  exit 77
}
fail() {
  echo "FAILED: $*"
  exit 1
}
quietly() { "$@" >"$work/log" 2>&1 || { cat "$work/log"; fail "$*"; }; }
need "$compiler"

# A build of static libraries installs the shared one only by the name of its component.
components=()
[ "$form" = static ] || ! grep -q '^BUILD_SHARED_LIBS:BOOL=OFF' "$build/CMakeCache.txt" || components=(--component lober_shared_form)
quietly "$cmake" --install "$build" --prefix "$work/first" "${components[@]}"
mv "$work/first" "$work/prefix"
prefix=$work/prefix
library_folder=$(dirname "$(dirname "$(find "$prefix" -name lober.pc)")")
if [ "$form" = shared ]; then
  export LD_LIBRARY_PATH=$library_folder
  soname=liblober.so.$(cut -d. -f1-2 <<<"$version")
  readelf -d "$library_folder/liblober.so" | grep -q "SONAME.*\[$soname\]" || fail "the name of the library is not $soname"
  [ "$(readlink -f "$library_folder/$soname")" = "$library_folder/liblober.so.$version" ] || fail "no liblober.so.$version"
  foreign=$(nm -DC --defined-only "$library_folder/liblober.so" | cut -d' ' -f3- |
    grep -vE '^((typeinfo (name )?|vtable )for )?lober::|^lober_[a-z_]+(@@LOBER_[0-9.]+)?$|^LOBER_[0-9.]+$' || true)
  [ -z "$foreign" ] || fail "exported, and not ours:
$(head -n 20 <<<"$foreign")"
fi
found=$(grep -rlE "$work/first|$build|$here" "$prefix" --include='*.cmake' --include='*.pc' || true)
[ -z "$found" ] || fail "folders of this machine are in $found"

warnings=(-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
flags="${warnings[*]} ${sanitize:+-fsanitize=$sanitize}"
# package NAME OPTION...: configures and builds the project in a folder of that name.
package() {
  local folder=$work/$1
  shift
  "$cmake" -S "$here" -B "$folder" -DCMAKE_PREFIX_PATH="$prefix" -DLOBER_VERSION="${version%.*}" \
    -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="$flags" "$@" && "$cmake" --build "$folder"
}
# The folder is new, and one configuration is enough: what a component does not need must not be looked for.
without=(-DCMAKE_DISABLE_FIND_PACKAGE_nanoflann=ON -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON -DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON)
[ "$form" = static ] || without+=(-DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON -DCMAKE_DISABLE_FIND_PACKAGE_SQLite3=ON)
quietly package all "${without[@]}"
quietly "$work/all/consumer"
quietly "$work/all/consumer_of_all"
if [ -z "$sanitize" ]; then
  quietly package geometry "${without[@]}" -DLOBER_COMPONENT=geometry -DCMAKE_DISABLE_FIND_PACKAGE_SQLite3=ON
  quietly "$work/geometry/consumer"
  ! package wrong -DLOBER_COMPONENT=geometri >"$work/log" 2>&1 || fail "a component that does not exist is found"
  grep -q 'without the component geometri' "$work/log" || fail "it is not said that a component does not exist"
fi

need pkg-config
export PKG_CONFIG_PATH=$library_folder/pkgconfig
# compile SOURCE PACKAGE
compile() {
  local options
  options=$(pkg-config --cflags --libs "$2") || fail "pkg-config does not know $2"
  # shellcheck disable=SC2086
  quietly "$compiler" -std=c++20 $flags "$1" $options -o "$work/program"
  quietly "$work/program"
}
compile "$here/main.cpp" lober-geometry
compile "$here/all.cpp" lober
[ "$(pkg-config --modversion lober)" = "$version" ] || fail "another version in lober.pc"
(cd "$prefix/include" && for header in lober/*.hpp lober/*/*.hpp; do echo "#include <$header>"; done) >"$work/headers.cpp"
quietly "$compiler" -std=c++20 "${warnings[@]}" -fsyntax-only "-I$prefix/include" "$work/headers.cpp"
echo "$form, $compiler: find_package and pkg-config"
