#!/usr/bin/env bash
# The pictures of docs/gallery/pictures.txt: each with its sentence and its command.
set -euo pipefail
cd "$(dirname "$0")/../.."
before=
while IFS='|' read -r name about command; do
  name=$(echo $name) about=$(echo "$about" | sed 's/^ *//; s/ *$//') command=$(echo "$command" | sed 's/^ *//; s/ *$//; s/@//g')
  case $name in
    '#'*) ;;
    '') [ -n "$about" ] && printf '\n## %s\n' "$about" ;;
    *.*) before+="lober $command $name"$'\n' ;;
    *)
      printf '\n%s\n\n```sh\n%slober %s %s.svg\n```\n\n![%s](../gallery/%s.svg)\n' \
        "$about" "$before" "$command" "$name" "${about%.}" "$name"
      before=
      ;;
  esac
done <docs/gallery/pictures.txt
echo
