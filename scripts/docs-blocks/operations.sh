#!/usr/bin/env bash
# Where each operation of the table is: as a command, in batches, in C and in Python. A face that lacks one fails.
set -euo pipefail
cd "$(dirname "$0")/../.."
batch=$("$LOBER" batch operations | awk '{ print $1 }')
echo "| operation | program | batch | C | Python |"
echo "|---|---|---|---|---|"
"$LOBER" schema | while read -r name _; do
  command=${name//_/-}
  "$LOBER" "$command" --help >/dev/null
  grep -qx "$name" <<<"$batch" || { echo "$name is not in batches" >&2; exit 1; }
  # Typed functions where there are some, beside what runs any operation.
  c="lober_call(\"$name\", ...)"
  grep -qE "\blober_$name\(" engine/lober/lober.h && c="lober_$name"
  python="call(\"$name\", ...)"
  grep -qhE "^def $name\(|^    def $name\(" python/lober/*.py && python=$name
  echo "| [$name](#$name) | \`lober $command\` | \`$name\` | \`$c\` | \`lober.$python\` |"
done
