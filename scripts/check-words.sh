#!/usr/bin/env bash
# Fails where a word that must not come back occurs in code, help, messages, JSON or documents (tracked files).
# CHANGELOG.md tells of old names, bench/RESULTS.md records output. The list, with what to write instead, is scripts/words.txt.
# usage: check-words.sh
set -uo pipefail
cd "$(dirname "$0")/.." || exit 2
ours=('*.cpp' '*.hpp' '*.h' '*.md' '*.toml')
words=0 places=0

# check PATTERN INSTEAD [PATHSPEC...]
check() {
  local pattern=$1 instead=$2 hits status
  shift 2
  hits=$(git grep -nIE -e "$pattern" -- "$@" ':!CHANGELOG.md' ':!bench/RESULTS.md')
  status=$?
  [ $status -le 1 ] || { echo "git grep fails for the pattern $pattern" >&2; exit 2; }
  words=$((words + 1))
  [ -n "$hits" ] || return
  places=$((places + $(wc -l <<<"$hits")))
  echo "not $pattern, but $instead:"
  cut -c 1-160 <<<"$hits"
}

while IFS=$'\t' read -r pattern instead files; do
  [[ -n $pattern && $pattern != '#'* ]] || continue
  [ -n "$instead" ] || { echo "scripts/words.txt: nothing instead of $pattern" >&2; exit 2; }
  read -ra scope <<<"$files"
  check "$pattern" "$instead" "${scope[@]:-${ours[@]}}"
done <scripts/words.txt
echo "$words patterns, $places places"
[ "$places" -eq 0 ] && [ "$words" -gt 0 ]
