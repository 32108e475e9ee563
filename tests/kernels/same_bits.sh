#!/usr/bin/env bash
# Results that do not depend on the C library: nothing in engine/ and kernels/ calls its elementary functions, whose digits
# follow the processor and the version, but kernels/elementary.hpp; and flows have the same digits when the library
# chooses other ones.
# usage: same_bits.sh SOURCE LOBER
set -uo pipefail
source=$1 lober=$2
status=0

# Of long double there is one version only; the reason is beside the call.
calls=$(grep -rnE 'std::(sin|cos|tan|exp|exp2|expm1|log|log1p|log2|log10|pow|atan2?|asin|acos|sinh|cosh|tanh|cbrt|cyl_bessel_i)\(' \
    "$source/engine" "$source/kernels" --include='*.[ch]pp' --include='*.inl' | grep -v '/engine/c/\|const long double')
if [ -n "$calls" ]; then
  echo "calls of the C library, in place of kernels/elementary.hpp:"
  echo "$calls"
  status=1
fi

compared=0
for arguments in "transport ovp --iterates 2" "transport ovp1 --sweep eps=0.1:0.3:0.1" "transport duffing --iterates 2" \
    "transport double-gyre --iterates 1" "transport pendulum --iterates 2 --melnikov" "escape capsize --crossings 1"; do
  # shellcheck disable=SC2086
  here=$("$lober" $arguments 2>&1)
  # shellcheck disable=SC2086
  there=$(GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable "$lober" $arguments 2>&1)
  compared=$((compared + 1))
  if [ "$here" != "$there" ]; then
    echo "lober $arguments: other digits without AVX2 and FMA in the C library"
    diff <(echo "$here") <(echo "$there") | head -n 6
    status=1
  fi
done
echo "$compared outputs compared"
exit $status
