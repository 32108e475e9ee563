"""Doxygen's input filter: a comment that covers several declarations becomes one for each, line by line.

    double inside = 0, outside = 0;  ///< areas of its parts        two members with the same comment
    /* In a C header. */                                            a comment of the declaration that follows

The number of lines stays, so that messages name lines of the header.
"""

import re
import sys

# TYPE NAME [= VALUE][{}], NAME [= VALUE]...;  without parentheses, which would be a function
DECLARATION = re.compile(r"^(\s*)((?:(?:inline|static|constexpr|const) )*[A-Za-z_][\w:]*(?:<[^;=(]*?>)?[*&]?) ([A-Za-z_]\w*[^;()]*,[^;]*);(.*)$")
# Operators that Doxygen takes for members whose name it cannot tell.
FUNCTION = re.compile(r"\(")


def names(text: str) -> list[str]:
    """The declarators, cut at the commas outside of brackets."""
    parts, depth, last = [], 0, 0
    for index, letter in enumerate(text):
        depth += letter in "([{<"
        depth -= letter in ")]}>"
        if letter == "," and depth == 0:
            parts.append(text[last:index].strip())
            last = index + 1
    parts.append(text[last:].strip())
    return parts


def cpp(lines: list[str]) -> list[str]:
    out: list[str] = []
    above: list[str] = []
    for line in lines:
        comment = re.match(r"^\s*///(?!<) ?(.*)$", line)
        if comment:
            above.append(comment[1])
            out.append(line)
            continue
        found = DECLARATION.match(line)
        if found and len(names(found[3])) > 1:
            behind = re.search(r"///< ?(.*)$", found[4])
            text = behind[1] if behind else " ".join(above)
            each = [f"{found[2]} {name};" + (f" /**< {text} */" if text else "") for name in names(found[3])]
            if above and not behind:  # the first one has the comment above
                each[0] = f"{found[2]} {names(found[3])[0]};"
            line = found[1] + " ".join(each)
        out.append(line)
        above = []
    return out


def c(text: str) -> str:
    """Comments before a declaration become /** */, those behind one /**< */."""
    text = re.sub(r"(?m)^(\s*)/\* (?=[\s\S]*?\*/\n\s*[A-Za-z#])", r"\1/** ", text)
    text = re.sub(r"(?m)^(#define [^\n]*?|\s*[^\s/][^\n]*?[;,])(\s*)/\* ", r"\1\2/**< ", text)
    lines = text.split("\n")
    out = []
    comment = ""
    inside = False
    for line in lines:
        # Two declarators of one comment above.
        if line.lstrip().startswith("/** "):
            comment, inside = "", True
        if inside:
            comment += line.strip().removeprefix("/** ").removesuffix("*/").strip() + " "
            inside = "*/" not in line
            out.append(line)
            continue
        found = DECLARATION.match(line)
        if found and "(" not in line and len(names(found[3])) > 1:
            behind = re.search(r"/\*\*< (.*)\*/", found[4])
            said = behind[1] if behind else comment.strip()
            each = [f"{found[2]} {name};" + (f" /**< {said} */" if said else "") for name in names(found[3])]
            if comment and not behind:
                each[0] = f"{found[2]} {names(found[3])[0]};"
            line = found[1] + " ".join(each)
        out.append(line)
        if line.strip():
            comment = ""
    return "\n".join(out)


def escaped(line: str) -> str:
    """A comment without what Doxygen would take for a link or a tag: FILE#K, <passes>."""
    code, slashes, comment = line.partition("///")
    return code + slashes + re.sub(r"(?<!\\)([#<])(?=[A-Za-z])", r"\\\1", comment)


def main() -> None:
    text = open(sys.argv[1], encoding="utf-8").read()
    if sys.argv[1].endswith(".h"):
        opening = text.index("*/")
        sys.stdout.write("/** \\file\n" + text[2:opening].replace("\n", " ", 1) + c(text[opening:]))
    elif sys.argv[1].endswith(".dox"):
        sys.stdout.write(text)
    else:
        text = "/// \\file\n" + text.split("\n", 1)[1]
        sys.stdout.write("\n".join(cpp([escaped(line) for line in text.split("\n")])))


main()
