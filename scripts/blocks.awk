# The code blocks of a Markdown file: awk -v out=FOLDER -f blocks.awk FILE.md
# writes the n-th one to FOLDER/NNN.body and prints `NNN kind line info`, the kind being the first word after the fence, or
# `none`. A block by indentation is of kind `indented`.
function begin(name, words) {
  number = sprintf("%03d", ++count)
  body = out "/" number ".body"
  printf "" > body
  print number, name, NR, words
}
fence == "" && match($0, /^(```+|~~~+)/) {
  fence = substr($0, RSTART, RLENGTH)
  rest = substr($0, RLENGTH + 1)
  kind = rest
  sub(/ .*/, "", kind)
  sub(/^[^ ]* */, "", rest)
  begin(kind == "" ? "none" : kind, rest)
  blank = 0
  next
}
fence != "" {
  if (index($0, fence) == 1 && substr($0, length(fence) + 1) !~ /[^ ]/) {
    close(body)
    fence = ""
  } else {
    print >> body
  }
  next
}
# Four blanks after an empty line, outside of lists.
/^    / && (blank || indented) && !list {
  if (!indented) begin("indented", "")
  indented = 1
  print substr($0, 5) >> body
  next
}
{
  if (indented && $0 ~ /[^ ]/) {
    indented = 0
    close(body)
  }
  if ($0 ~ /^ *([-*+]|[0-9]+\.) /) list = 1
  else if ($0 ~ /^[^ ]/) list = 0
  blank = $0 !~ /[^ ]/
}
