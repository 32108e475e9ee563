# Prints each function that a public header declares, whose code is in the library, and which is not marked with
# LOBER_API: the user of a shared library could not link it. Relies on the layout of clang-format.
FNR == 1 { in_class = 0; text = "" }
{ sub(/ *\/\/.*/, "") }
# A marked class marks its members; what is private need not be linked.
/^(class|struct) .*{$/ { in_class = 1; skipped = /LOBER_API|^class/; marked = /LOBER_API/; text = ""; next }
/^};/ { in_class = 0; text = ""; next }
/^ (public|protected|private):/ { skipped = marked || !/public/; text = ""; next }
/^[#}]|^namespace|^$/ { text = ""; next }
# Where a statement begins: members are indented by two, their bodies by four.
text == "" && !(in_class ? /^  [^ }]/ : /^[^ ]/) { next }
{
  text = text " " $0
  if ($0 !~ /[;{}]$/) next
  plain = text
  while (gsub(/<[^<>]*>/, "", plain)) {}
  if (!(in_class && skipped) && plain ~ /;$/ && plain ~ /[A-Za-z0-9_=\]]\(/ &&
      plain !~ /LOBER_API|= (0|default|delete);|using |friend |static_assert|template|{[^}]|^[^()]*[^r=]=[^=()]*\(/)
    printf "%s:%d:%s\n", FILENAME, FNR, text
  text = ""
}
