# Whether two SVG pictures of ours are the same: the same text, and all numbers in it within a tenth of a pixel (coordinates
# are twentieths of pixels). A last digit may be rounded another way where a compiler, or a library, is another one.
# usage: awk -f same-figure.awk FIRST SECOND      exit status 1 and the first line that differs where they are not
function fail() {
  print FILENAME ":" FNR ": " substr($0, 1, 120)
  failed = 1
  exit 1
}
function number_from(text) {
  return match(text, /-?[0-9]+(\.[0-9]+)?/)
}
NR == FNR { line[NR] = $0; lines = NR; next }
$0 != line[FNR] {
  first = line[FNR]
  second = $0
  while (number_from(first)) {
    before = substr(first, 1, RSTART - 1)
    value = substr(first, RSTART, RLENGTH)
    first = substr(first, RSTART + RLENGTH)
    if (!number_from(second) || substr(second, 1, RSTART - 1) != before) fail()
    off = value - substr(second, RSTART, RLENGTH)
    if (off > 2 || off < -2 || (off != 0 && before ~ /#[0-9a-f]*$/)) fail()  # colours are no coordinates
    second = substr(second, RSTART + RLENGTH)
  }
  if (first != second) fail()
}
END {
  if (!failed && FNR != lines) { print FILENAME " has " FNR " lines, not " lines; exit 1 }
}
