"""A page for each public header: its opening comment, then every type and function, from the XML that Doxygen writes."""

import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field
from pathlib import Path

SPECIAL = re.compile(r"([\\`*_{}\[\]<>|$#~])")


def escaped(text: str) -> str:
    """Text as Markdown; what stands between backticks stays."""
    return re.sub(r"(`[^`]*`)|([^`]+|`)", lambda found: found[1] or SPECIAL.sub(r"\\\1", found[2]), text)


def plain(element: ElementTree.Element | None) -> str:
    """The text of an element of code, blanks as C++ is written here."""
    text = "".join(element.itertext()) if element is not None else ""
    text = re.sub(r"\s+", " ", text).strip()
    return re.sub(r"< (.*?) >", r"<\1>", text).replace(" &", "&").replace(" *", "*").replace(" >", ">")


def prose(element: ElementTree.Element | None) -> str:
    """A description as Markdown."""
    if element is None:
        return ""
    blocks: list[str] = []
    for child in element:
        if child.tag == "para":
            blocks.append(paragraph(child))
        elif child.tag.startswith("sect"):
            blocks.append(prose(child))
    return "\n\n".join(block for block in blocks if block.strip())


def paragraph(element: ElementTree.Element) -> str:
    parts = [escaped(element.text or "")]
    for child in element:
        if child.tag == "computeroutput":
            parts.append(f"`{''.join(child.itertext())}`")
        elif child.tag in ("itemizedlist", "orderedlist"):
            items = ["- " + " ".join(paragraph(para) for para in item.findall("para")) for item in child]
            parts.append("\n\n" + "\n".join(items) + "\n\n")
        elif child.tag in ("verbatim", "programlisting"):
            parts.append(f"\n\n```text\n{''.join(child.itertext()).strip()}\n```\n\n")
        elif child.tag == "linebreak":
            parts.append(" ")
        else:
            parts.append(escaped("".join(child.itertext())))
        parts.append(escaped(child.tail or ""))
    return re.sub(r"(?m)^ +", "", "".join(parts)).strip()


def description(member: ElementTree.Element) -> str:
    return "\n\n".join(filter(None, (prose(member.find("briefdescription")), prose(member.find("detaileddescription")))))


def declaration(member: ElementTree.Element) -> str:
    kind = member.get("kind")
    name = member.findtext("name", "")
    if kind == "define":
        parameters = ", ".join(each.findtext("defname", "") for each in member.findall("param"))
        return f"#define {name}" + (f"({parameters})" if parameters else "") + f" {plain(member.find('initializer'))}".rstrip()
    template = ", ".join(
        " ".join(filter(None, (plain(each.find("type")), each.findtext("declname", ""))))
        for each in member.findall("templateparamlist/param")
    )
    opening = f"template <{template}> " if template else ""
    kind_of = plain(member.find("type"))
    arguments = re.sub(r"\s+", " ", member.findtext("argsstring", ""))
    arguments = re.sub(r" ([&*])(?=[\w)])", r"\1 ", arguments)
    arguments = re.sub(r"< (.*?) ?>", r"<\1>", arguments).replace("=default", " = default").replace("=delete", " = delete")
    if kind == "enum":
        values = ", ".join(
            value.findtext("name", "") + (f" {plain(value.find('initializer'))}" if value.find("initializer") is not None else "")
            for value in member.findall("enumvalue")
        )
        return f"enum {'class ' if member.get('strong') == 'yes' else ''}{name} {{ {values} }}"
    if kind == "typedef":
        definition = member.findtext("definition", "")
        return definition if definition.startswith("using") else f"typedef {kind_of} {name}{arguments}"
    static = "static " if member.get("static") == "yes" and not kind_of.startswith("static") else ""
    initial = plain(member.find("initializer")) if kind == "variable" else ""
    return f"{opening}{static}{kind_of}{' ' if kind_of else ''}{name}{arguments} {initial}".rstrip()


@dataclass
class Entry:
    """A symbol on a page: at its line, with the text that describes it."""

    line: int
    text: str


@dataclass
class Page:
    entries: list[Entry] = field(default_factory=list)


def cell(text: str) -> str:
    return re.sub(r"\s*\n+\s*", " ", text).replace("|", r"\|") if "`" in text else re.sub(r"\s*\n+\s*", " ", text)


def code_cell(text: str) -> str:
    return "`" + text.replace("|", r"\|") + "`"


def table(members: list[ElementTree.Element]) -> str:
    rows = ["| member | |", "|---|---|"]
    for member in members:
        code = declaration(member)
        text = description(member)
        if not text:  # Doxygen lets only these pass
            text = "Refused by the compiler." if code.endswith("= delete") else "As the compiler makes it."
        rows.append(f"| {code_cell(code)} | {cell(text)} |")
        for value in member.findall("enumvalue"):
            if description(value):
                rows.append(f"| {code_cell(value.findtext('name', ''))} | {cell(description(value))} |")
    return "\n".join(rows)


def symbol(name: str, code: str, text: str, level: str = "##") -> str:
    return f"{level} {escaped(name)}\n\n```cpp\n{code}\n```\n\n{text}\n"


def members_of(compound: ElementTree.Element) -> list[ElementTree.Element]:
    found = [
        member
        for section in compound.findall("sectiondef")
        if not section.get("kind", "").startswith(("private", "protected"))
        for member in section.findall("memberdef")
        if member.get("kind") != "friend" or "operator" in member.findtext("name", "")
    ]
    return sorted(found, key=lambda member: int(member.find("location").get("line")))


def read(xml: Path) -> dict[str, Page]:
    """The symbols of each header, by its name as it is included."""
    pages: dict[str, Page] = {}

    def add(location: ElementTree.Element, text: str) -> None:
        pages.setdefault(location.get("file"), Page()).entries.append(Entry(int(location.get("line")), text))

    for path in sorted(xml.glob("*.xml")):
        if path.name == "index.xml":
            continue
        compound = ElementTree.parse(path).getroot().find("compounddef")
        if compound is None:
            continue
        kind, name = compound.get("kind"), compound.findtext("compoundname", "")
        if kind in ("struct", "class", "union") and "detail" not in name.split("::"):
            location = compound.find("location")
            template = ", ".join(plain(each) for each in compound.findall("templateparamlist/param/type"))
            bases = ", ".join(plain(base) for base in compound.findall("basecompoundref"))
            code = (f"template <{template}> " if template else "") + f"{kind} {name}" + (f" : {bases}" if bases else "") + ";"
            members = members_of(compound)
            text = description(compound) + ("\n\n" + table(members) if members else "")
            add(location, symbol(name.removeprefix("lober::"), code, text))
        elif kind in ("namespace", "file") and "detail" not in name.split("::"):
            for member in members_of(compound):
                location = member.find("location")
                if kind == "file" and member.get("kind") not in ("define",) and not location.get("file").endswith(".h"):
                    continue  # members of namespaces are listed there
                values = [value for value in member.findall("enumvalue") if description(value)]
                text = description(member)
                if values:
                    text += "\n\n" + "\n".join(f"- `{value.findtext('name', '')}`: {description(value)}" for value in values)
                prefix = name.removeprefix("lober").removeprefix("::")
                title = (f"{prefix}::" if prefix and kind == "namespace" else "") + member.findtext("name", "")
                add(location, symbol(title, declaration(member) + ("" if member.get("kind") == "define" else ";"), text))
    for page in pages.values():
        page.entries.sort(key=lambda entry: entry.line)
    return pages


def opening(text: str) -> list[str]:
    """The lines of the comment at the beginning of a header."""
    if text.startswith("/*"):
        lines = text[2 : text.index("*/")].splitlines()
        indent = min((len(line) - len(line.lstrip()) for line in lines[1:] if line.strip()), default=0)
        return [lines[0].strip()] + [line[indent:] for line in lines[1:]]
    lines = []
    for line in text.splitlines():
        if not line.startswith("//"):
            break
        lines.append(line[3:])
    return lines


def as_markdown(lines: list[str]) -> str:
    """Paragraphs with their special characters escaped; indented lines literally."""
    out: list[str] = []
    literal = False
    for line in lines:
        if line.startswith("  ") and not literal:
            out += ["", "```text"]
            literal = True
        elif literal and line.strip() and not line.startswith("  "):
            out += ["```", ""]
            literal = False
        if not literal:
            line = escaped(line)
        out.append(line)
    return "\n".join(out + (["```"] if literal else []))


def write(root: Path, xml: Path, folder: Path) -> None:
    """Writes the pages and an index of them into the folder."""
    symbols = read(xml)
    headers = sorted((root / "engine" / "lober").rglob("*.h*"), key=lambda path: (path.parent != root / "engine/lober", path))
    topics: dict[str, list[tuple[str, str, str]]] = {}
    folder.mkdir(parents=True, exist_ok=True)
    for header in headers:
        name = str(header.relative_to(root / "engine"))
        text = header.read_text()
        lines = opening(text)
        page = name.removeprefix("lober/").replace("/", "-").replace(".", "-")
        body = as_markdown(lines)
        if name in symbols:
            body += "\n\n" + "\n".join(entry.text for entry in symbols[name].entries)
        else:
            included = re.findall(r'#include "(lober/[^"]+)"', text)
            body += "\n\nThis header includes " + ", ".join(f"`<{each}>`" for each in included) + ".\n"
        (folder / f"{page}.md").write_text(f"# {name.removeprefix('lober/')}\n\n`#include <{name}>`\n\n{body}\n")
        summary = escaped(" ".join(lines).split(". ")[0].split(":")[0].rstrip("."))
        topics.setdefault(str(header.parent.relative_to(root / "engine/lober")), []).append((page, name, summary))
    out = ["# C++ and C headers\n", "Each topic has a header that includes those in its folder; `<lober/lober.hpp>` includes all of them.\n"]
    for topic, entries in topics.items():
        out.append(f"## {'Topics and C' if topic == '.' else topic}\n")
        out += [f"- [{name}]({page}.md): {summary}" for page, name, summary in entries]
        out.append("")
    out += ["```{toctree}", ":hidden:", ""] + [page for entries in topics.values() for page, _, _ in entries] + ["```", ""]
    (folder / "index.md").write_text("\n".join(out))
    print(sum(len(page.entries) for page in symbols.values()), "symbols on", len(headers), "pages of headers")
