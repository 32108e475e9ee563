#!/usr/bin/env bash
# No object that is compiled for a newer processor than the rest may hold a weak function: the linker keeps one of all
# weak functions of a name and could take that one for the whole program (kernels/inline.hpp). Looks at the objects of
# the build and at the same sources compiled without optimisation, where nothing is inlined that need not be.
# usage: isa_symbols.sh SOURCE_FOLDER BUILD_FOLDER COMPILER
set -euo pipefail
source=$1 build=$2 compiler=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0 looked_at=0

# Functions without a type letter for locals (t) or strong globals (T). Those that name the instruction set as their
# first argument are another function in each copy.
look_at() {
  local weak
  weak=$(nm -C "$1" | grep -E '^[0-9a-f]+ [Wi] ' | grep -vF 'steps_in_vectors<(lober::detail::InstructionSet)' || true)
  looked_at=$((looked_at + 1))
  [ -z "$weak" ] && return
  printf '%s has weak functions:\n%s\n' "$2" "$weak"
  status=1
}

systems=engine/dynamics/CMakeFiles/lober_dynamics.dir/systems
objects=("$build"/kernels/CMakeFiles/lober_kernels.dir/avx{2,512}.cpp.o "$build/$systems"/*_avx{2,512}.cpp.o)
sources=("$source"/kernels/avx{2,512}.cpp "$source"/engine/dynamics/systems/*_avx{2,512}.cpp)
for object in "${objects[@]}"; do look_at "$object" "$(basename "$object") of this build"; done
for file in "${sources[@]}"; do
  name=$(basename "$file" .cpp)
  flags=(-mavx2 -mfma)
  [[ $name == *avx512 ]] && flags+=(-mavx512f -mavx512vl -mavx512dq -mbmi2)
  "$compiler" -std=c++20 -O0 -g -fPIC -ffp-contract=off -Wno-psabi "-I$source" "-I$source/engine" "${flags[@]}" -c "$file" -o "$scratch/$name.o"
  look_at "$scratch/$name.o" "$name.cpp without optimisation"
done
[ "$looked_at" -eq $((2 * ${#sources[@]})) ] || { echo "$looked_at objects of ${#sources[@]} sources"; status=1; }
echo "$looked_at objects inspected"
exit $status
