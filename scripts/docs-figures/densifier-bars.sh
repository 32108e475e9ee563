#!/usr/bin/env bash
# Figure 8 of Naik, Lekien & Ross (2017) as bars side by side, from the table of scripts/docs-blocks/densifier-table.sh: how
# far the areas of lobes are off by the settings of -DENS, and how many points they insert. Work is counted, not timed, so
# that the bytes are the same each time.
set -euo pipefail
cd "$(dirname "$0")/../.."
scripts/docs-blocks/densifier-table.sh | awk -F ' *[|] *' '
  function bars(k, x, y, width, height, low, high, value,   share) {
    share = value > 0 ? (log(value) / log(10) - low) / (high - low) : 0
    if (share < 0) share = 0
    printf "<rect x=\"%d\" y=\"%.1f\" width=\"%d\" height=\"%.1f\" fill=\"%s\"/>\n", x, y + height * (1 - share), width, height * share, colour[k]
  }
  function panel(left, top, title, low, high, step, unit, column,   i, k, e, x) {
    printf "<text x=\"%d\" y=\"%d\" font-size=\"15\">%s</text>\n", left, top - 14, title
    for (e = low; e <= high; e += step) {
      y = top + tall * (1 - (e - low) / (high - low))
      printf "<path d=\"M%d %.1fh%d\" stroke=\"#dddddd\"/><text x=\"%d\" y=\"%.1f\" text-anchor=\"end\" fill=\"#555555\">1e%d</text>\n", left, y, wide, left - 6, y + 4, e
    }
    for (i = 1; i <= rows; ++i) {
      x = left + (i - 0.5) * wide / rows
      for (k = 0; k < 2; ++k) {
        value = cell[i, column + 2 * k]
        if (value + 0 < 0) value = -value
        bars(k, x - 20 + 20 * k, top, 18, tall, low, high, value + 0)
        if (value + 0 == 0) printf "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\" fill=\"%s\">0</text>\n", x - 11 + 20 * k, top + tall - 4, colour[k]
      }
      printf "<text x=\"%d\" y=\"%d\" text-anchor=\"end\" transform=\"rotate(-35 %d %d)\">%s</text>\n", x + 6, top + tall + 18, x + 6, top + tall + 18, name[i]
    }
    printf "<path d=\"M%d %dh%d\" stroke=\"#222222\"/>\n", left, top + tall, wide
  }
  NR > 3 {
    ++rows
    name[rows] = $2
    gsub(/`/, "", name[rows])
    for (k = 3; k <= 6; ++k) cell[rows, k - 2] = $k
  }
  END {
    colour[0] = "#2b6cb0"; colour[1] = "#c05621"
    wide = 780; tall = 220
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900\" height=\"700\" viewBox=\"0 0 900 700\" font-family=\"sans-serif\" font-size=\"12\">"
    print "<title>The densifier compared</title><rect width=\"900\" height=\"700\" fill=\"#ffffff\"/>"
    panel(80, 60, "difference of the lobe areas from segments that are split where the curves meet", -14, 0, 2, "", 1)
    panel(80, 380, "points inserted", 0, 5, 1, "", 2)
    for (k = 0; k < 2; ++k)
      printf "<rect x=\"%d\" y=\"14\" width=\"14\" height=\"14\" fill=\"%s\"/><text x=\"%d\" y=\"26\">%s</text>\n", 80 + 160 * k, colour[k], 100 + 160 * k, k == 0 ? "vortex pair" : "three bodies"
    print "</svg>"
  }'
