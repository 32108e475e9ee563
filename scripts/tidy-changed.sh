#!/usr/bin/env bash
# clang-tidy on the sources that changed since the last landed commit, and on those of changed headers of the same name.
# Stops after so many minutes and names what it did not read: about 16 s of processor time a file.
# usage: tidy-changed.sh [MINUTES, default 8 [COMMIT to compare with]]
set -euo pipefail
cd "$(dirname "$0")/.."
minutes=${1:-8}

# Where this branch left main, or, on main itself, the commit before.
base() {
  local main found
  for main in origin/main main; do
    found=$(git merge-base "$main" HEAD 2>/dev/null) || continue
    if [ "$found" != "$(git rev-parse HEAD)" ]; then
      echo "$found"
      return
    fi
  done
  git rev-parse --verify --quiet 'HEAD^1'
}
if ! commit=${2:-$(base)}; then
  echo "skipped: there is no commit to compare with"
  exit 77
fi

# Large changes first: where the time does not suffice, they are what matters.
mapfile -t changed < <(git diff --numstat --diff-filter=AMR "$commit" HEAD -- kernels engine cli | sort -rn | cut -f 3)
declare -A seen=()
files=()
for file in "${changed[@]}"; do
  source=${file%.hpp}
  source=${source%.cpp}.cpp
  [[ $file == *.?pp && -f $source && -z ${seen[$source]:-} ]] || continue
  seen[$source]=1
  files+=("$source")
done
if [ ${#files[@]} -eq 0 ]; then
  echo "nothing changed since $(git log -1 --format=%h "$commit")"
  exit 0
fi
# A build folder of its own, where each file is compiled by itself.
cmake -S . -B build-tidy -G Ninja -DCMAKE_BUILD_TYPE=Release -DLOBER_UNITY=OFF >/dev/null

end=$((SECONDS + 60 * minutes))
logs=$(mktemp -d)
trap 'rm -rf "$logs"' EXIT
export logs
read_one() {
  local log=$logs/${1//\//_}
  if clang-tidy -p build-tidy --quiet --warnings-as-errors='*' --extra-arg=-Wno-unknown-warning-option "$1" >"$log" 2>"$log.err"; then
    echo "$1" >>"$logs/good"
  else
    echo "$1" >>"$logs/bad"
    cat "$log"
    grep -v 'warnings generated\|Suppressed\|Use -header-filter' "$log.err" || true
  fi
}
export -f read_one
touch "$logs/good" "$logs/bad"
printf '%s\0' "${files[@]}" |
    timeout --kill-after=5 $((end - SECONDS)) xargs -0 -n 1 -P "${LOBER_CI_CORES:-$(nproc)}" bash -c 'read_one "$0"' || true
good=$(wc -l <"$logs/good") bad=$(wc -l <"$logs/bad")
echo "clang-tidy since $(git log -1 --format=%h "$commit"): $good of ${#files[@]} files clean, $bad not"
for file in "${files[@]}"; do
  grep -qxF "$file" "$logs/good" "$logs/bad" || echo "not read within $minutes minutes: $file"
done
[ "$bad" -eq 0 ]
