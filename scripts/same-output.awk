# Whether what a program printed is what a document shows: awk -f same-output.awk SHOWN PRINTED
# Word by word. Numbers may differ by 1e-9 of themselves; where both are below 1e-6, as errors are, by a factor of ten.
# `...` at the end of what is shown stands for all that follows. Prints the first line that differs.
function same(a, b, x, y, larger) {
  if (a == b) return 1
  gsub(/[(),;]/, "", a)
  gsub(/[(),;]/, "", b)
  if (a !~ number || b !~ number) return a == b
  x = a + 0
  y = b + 0
  if (x < 0) x = -x
  if (y < 0) y = -y
  if (x < 1e-6 && y < 1e-6) return x <= 10 * y + 1e-15 && y <= 10 * x + 1e-15
  larger = x > y ? x : y
  return (a + 0 - (b + 0)) ^ 2 <= (1e-9 * larger) ^ 2
}
BEGIN { number = "^[-+]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?$" }
NR == FNR { shown[++lines] = $0; next }
{ printed[++got] = $0 }
END {
  for (k = 1; k <= lines; ++k) {
    if (k == lines && shown[k] ~ /^ *\.\.\.$/) exit 0
    n = split(shown[k], a)
    m = split(printed[k], b)
    equal = n == m
    for (j = 1; j <= n && equal; ++j) equal = same(a[j], b[j])
    if (!equal) {
      print "shown:   " shown[k]
      print "printed: " printed[k]
      exit 1
    }
  }
  if (got > lines) {
    print "printed, not shown: " printed[lines + 1]
    exit 1
  }
}
