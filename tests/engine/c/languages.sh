#!/usr/bin/env bash
# The examples of examples/c against an installed liblober.so, each in its language, where that is on this machine: all have
# to print the same. usage: languages.sh CMAKE SOURCE BUILD
set -euo pipefail
cmake=$1 source=$2 build=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# A build of static libraries installs the shared one only by the name of its component.
components=()
! grep -q "^BUILD_SHARED_LIBS:BOOL=OFF" "$build/CMakeCache.txt" || components=(--component lober_shared_form)
"$cmake" --install "$build" --prefix "$work/installed" "${components[@]}" >"$work/install.log"
lib=$(dirname "$(find "$work/installed" -name liblober.so)")
export PKG_CONFIG_PATH=$lib/pkgconfig LD_LIBRARY_PATH=$lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
cd "$work"
cp "$source"/examples/c/* .
include=$work/installed/include

cc -std=c99 -O1 -Wall -Wextra -Wpedantic -Wconversion -Werror lobes.c -I"$include" -L"$lib" -llober -lm -o lobes
./lobes | tee expected
grep -q '^5 lobes of area 0.3685' expected  # 0.4 - 0.01 pi of the curves

same() {
  if ! diff expected "$1.out"; then
    echo "$1 differs from C"
    exit 1
  fi
  echo "$1: the same"
}
if /usr/bin/python3 -c 'import numpy' 2>/dev/null; then
  /usr/bin/python3 lobes.py "$lib/liblober.so" >ctypes.out
  same ctypes
else
  echo "skipped: ctypes (no numpy for /usr/bin/python3)"
fi
if command -v gfortran >/dev/null; then
  gfortran -std=f2003 -Wall -Werror lobes.f90 -L"$lib" -llober -o fortran
  ./fortran | sed -E 's/(^| )\./\10./' >fortran.out
  same fortran
else
  echo "skipped: Fortran (no gfortran)"
fi
if command -v mkoctfile >/dev/null && command -v octave-cli >/dev/null; then
  for mex in lober_overlay_mex lober_overlap_matrix_mex; do
    mkoctfile --mex "$mex.c" -I"$include" -L"$lib" -llober 2>mex.log || { cat mex.log; exit 1; }
  done
  octave-cli --no-gui --quiet --eval '
    t = 2 * pi * (0:999) / 1000; r = 1 + 0.2 * sin(5 * t); circle = [cos(t); sin(t)];
    [area, lobes] = lober_overlay_mex(circle, [r .* cos(t); r .* sin(t)]);
    printf("%d lobes of area %.12f in all\n", rows(lobes), area);
    row = [circle, circle + [0.6; 0], circle + [1.2; 0], circle + [1.8; 0], circle + [2.4; 0]];
    [areas, crossings] = lober_overlap_matrix_mex(row, 0:1000:5000);
    printf("%.9f %d\n", [areas(1, 2:5); crossings(1, 2:5)]);' >octave.out
  sed -i 2d expected  # the flux of a map
  same octave
else
  echo "skipped: Octave (no octave-cli, or no mkoctfile)"
fi
