# Prints the examples of the public headers, each as a function of a C++ file: runs of comment lines that are indented by
# three blanks and name something of lober. What they use without saying where it is from has example_names.hpp.
function finish() {
  if (example ~ /lober::/)
    printf "#include \"lober/%s\"\nvoid example%d(EXAMPLE_NAMES) {{\n%s}}\n", header, ++count, example
  example = ""
}
FNR == 1 { finish(); header = FILENAME; sub(/.*engine\/lober\//, "", header) }
/^ *\/\/\/?   [^ ]/ || (example != "" && /^ *\/\/\/?    /) {
  line = $0
  sub(/^ *\/+/, "", line)
  if (example == "") example = "#line " FNR " \"" FILENAME "\"\n"
  example = example line "\n"
  next
}
{ finish() }
END { finish() }
