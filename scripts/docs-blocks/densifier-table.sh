#!/usr/bin/env bash
# Figure 8 of Naik, Lekien & Ross (2017) as a table: areas by the interior method with the settings of -DENS that are
# compared there, beside the same with segments split exactly; and what passes cost for one refinement.
set -euo pipefail
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

mapfile -t pairs < <(scripts/densifier-pairs.sh "$work")

# PAIR OPTIONS...: mean of [C1 - C2] and [C2 - C1], and points inserted.
measure() {
  local pair=$1
  shift
  # shellcheck disable=SC2086
  "$LOBER" interior $pair "$@" --json - | awk '
    function member(name) {
      if (!match($0, "\"" name "\":[-+0-9.e]+")) return 0
      value = substr($0, RSTART, RLENGTH); sub(/.*:/, "", value)
      return value + 0
    }
    /^"areas"/ { mean = 0.5 * (member("c1_minus_c2") + member("c2_minus_c1")) }
    /points_inserted/ { inserted = member("points_inserted") }
    END { printf "%.15g %d\n", mean, inserted }'
}

echo "| | vortex pair, lobes | | three bodies, lobes | | vortex pair, boundaries | | three bodies, boundaries | |"
echo "|---|---:|---:|---:|---:|---:|---:|---:|---:|"
line="| exact"
exact=()
for pair in "${pairs[@]}"; do
  read -r area _ < <(measure "$pair")
  exact+=("$area")
  line+=" | $(printf '%.9f' "$area") | inserted"
done
echo "$line |"
row() {
  local name=$1 k area inserted line
  shift
  line="| $name"
  for k in 0 1 2 3; do
    read -r area inserted < <(measure "${pairs[k]}" "$@")
    line+=$(awk -v a="$area" -v n="$inserted" -v exact="${exact[k]}" 'BEGIN { printf " | %.0e | %d", a - exact, n }')
  done
  echo "$line |"
}
row '`-DENS 0`' --method ends
row '`-DENS 1 10`' --method ends --passes 1 --points 10
row '`-DENS 3 10`' --method ends --passes 3 --points 10
row '`-DENS 5 100`' --method ends --passes 5 --points 100
row 'default, split'
row '`-DENS 1 4095`' --method ends --passes 1 --points 4095
row '`-DENS 2 63`' --method ends --passes 2 --points 63
row '`-DENS 3 15`' --method ends --passes 3 --points 15
row '`-DENS 4 7`' --method ends --passes 4 --points 7
row '`-DENS 6 3`' --method ends --passes 6 --points 3
row '`-DENS 12 1`' --method ends --passes 12 --points 1
