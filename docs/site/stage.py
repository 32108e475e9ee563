"""Lays out the sources of the site in a build folder: pages by kind, files that they link, tutorials with their results.

usage: stage.py BUILD FOLDER        BUILD is the build folder with program and Python module, FOLDER becomes Sphinx's source

contents.toml says which pages there are and in which order. Links between documents are those of the repository; here they
become links between pages, and a link to nothing is an error.
"""

import inspect
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import cpp_pages
import links
import notebook

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def commands_page(lober: Path, _: Path) -> str:
    """The help of every command, as the program prints it."""
    names = subprocess.run(
        [lober, "--generate", "commands"], check=True, capture_output=True, text=True
    ).stdout.split()
    parts = ["# Commands and options\n", "The help of every command, printed by the program when this site was built.\n"]

    def add(title: str, arguments: list[str]) -> None:
        text = subprocess.run([lober, *arguments, "--help"], check=True, capture_output=True, text=True).stdout
        parts.append(f"## {title}\n\n```text\n{text.rstrip()}\n```\n")

    add("lober", [])
    for name in names:
        add(f"lober {name}", [name])
        if name == "batch":
            for verb in ("run", "check", "status", "export", "merge", "manifest", "operations"):
                add(f"lober batch {verb}", [name, verb])
    if len(names) < 15:
        raise SystemExit(f"only {len(names)} commands listed by {lober}")
    return "\n".join(parts)


def manifest_page(lober: Path, _: Path) -> str:
    """The keys of a manifest, as the program lists them."""
    text = subprocess.run([lober, "batch", "manifest"], check=True, capture_output=True, text=True).stdout
    return f"# Keys of a manifest\n\nPrinted by `lober batch manifest`.\n\n```text\n{text.rstrip()}\n```\n"


def json_page(lober: Path, stage: Path) -> str:
    """The JSON Schema of each result, as files to be taken away."""
    listed = subprocess.run([lober, "schema"], check=True, capture_output=True, text=True).stdout
    folder = stage / "files" / "schemas"
    folder.mkdir(parents=True)
    parts = [
        "# JSON\n",
        "`--json FILE` writes one JSON object. The members that all commands share, and what holds for numbers, are in the "
        "[conventions](conventions.md), section 13; the members of a result with units and meanings in the "
        "[operations](operations.md). The same as JSON Schema, printed by `lober schema NAME`:\n",
    ]
    for line in listed.splitlines():
        name, title = line.split(maxsplit=1)
        schema = subprocess.run([lober, "schema", name], check=True, capture_output=True, text=True).stdout
        (folder / f"{name}.json").write_text(schema)
        parts.append(f"- [{name}.json](../files/schemas/{name}.json): {title}")
    return "\n".join(parts) + "\n"


def python_page(_: Path, __: Path) -> str:
    """Everything that `import lober` gives, in the order of its topics, by autodoc."""
    import lober

    functions = sorted(name for name in vars(lober) if inspect.isfunction(getattr(lober, name)))
    classes = [getattr(lober, name) for name in sorted(vars(lober)) if inspect.isclass(getattr(lober, name))]
    results = [each.__name__ for each in classes if not issubclass(each, (Exception, Warning))]
    errors = [each.__name__ for each in classes if issubclass(each, (Exception, Warning))]
    plots = sorted(name for name, each in vars(lober.plot).items() if inspect.isfunction(each) and name[0] != "_")
    parts = ["# Python, every function and class\n", "From the comments in the package. Examples are on the page before.\n"]

    def add(title: str, module: str, names: list[str], kind: str) -> None:
        parts.append(f"## {title}\n\n```{{eval-rst}}\n.. currentmodule:: {module}\n")
        for name in names:
            if name.startswith("_"):
                continue
            options = "   :members:\n" if kind != "function" else ""
            parts.append(f".. auto{kind}:: {name}\n{options}")
        parts.append("```\n")

    add("Functions", "lober", functions, "function")
    add("Pictures", "lober.plot", plots, "function")
    add("Results and systems", "lober", results, "class")
    add("Errors", "lober", errors, "exception")
    return "\n".join(parts)


def kind_page(kind: dict, titles: dict[str, str]) -> str:
    """The first page of a kind: its purpose and its pages, each with a sentence."""
    lines = [f"# {kind['title']}\n", kind["about"].strip() + "\n"]
    for page in kind["pages"]:
        where = page["page"].split("/", 1)[1]
        lines.append(f"- [{titles[page['page']]}]({where}.md): {page['about']}")
    entries = "\n".join(page["page"].split("/", 1)[1] for page in kind["pages"])
    if kind["folder"] == "reference":
        lines.append("- [C++ and C headers](cpp/index.md): every public type and function, from the comments in the headers")
        entries += "\ncpp/index"
    lines.append(f"\n```{{toctree}}\n:hidden:\n\n{entries}\n```\n")
    return "\n".join(lines)


def title_of(text: str) -> str:
    for line in text.splitlines():
        if line.startswith("# "):
            return line[2:].strip()
    raise SystemExit("a page without a title")


def main() -> None:
    build, stage = (Path(each).resolve() for each in sys.argv[1:3])
    lober = build / "bin" / "lober"
    contents = tomllib.loads((HERE / "contents.toml").read_text())
    shutil.rmtree(stage, ignore_errors=True)
    stage.mkdir(parents=True)

    generated = {"commands": commands_page, "manifest": manifest_page, "json": json_page, "python_api": python_page}
    for kind in contents["kind"]:
        kind["pages"] = [page for page in kind["pages"] if not page.get("optional") or (ROOT / page["source"]).is_file()]
    pages = {page["source"]: page["page"] for kind in contents["kind"] for page in kind["pages"] if "source" in page}
    pages["docs/site/index.md"] = "index"
    for page in list(pages):
        if not (ROOT / page).is_file():
            raise SystemExit(f"contents.toml names {page}, which is not there")
    listed = {ROOT / page for page in pages}
    left_out = [each for each in (ROOT / "docs").rglob("*.md") if each not in listed]
    if left_out:
        raise SystemExit("not in contents.toml: " + ", ".join(str(each.relative_to(ROOT)) for each in left_out))

    rewriter = links.Rewriter(ROOT, stage, pages)
    titles: dict[str, str] = {}

    def write(page: str, text: str) -> None:
        target = stage / f"{page}.md"
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text)

    for kind in contents["kind"]:
        for page in kind["pages"]:
            name = page["page"]
            if "generated" in page:
                text = generated[page["generated"]](lober, stage)
            elif name.startswith("tutorials/"):
                text = notebook.executed(ROOT / page["source"], build, stage / f"{name}_files")
                text = rewriter.rewrite(page["source"], name, text)
            else:
                text = rewriter.rewrite(page["source"], name, (ROOT / page["source"]).read_text())
            write(name, text)
            titles[name] = title_of(text)
        write(f"{kind['folder']}/index", kind_page(kind, titles))
    write("index", rewriter.rewrite("docs/site/index.md", "index", (HERE / "index.md").read_text()))
    cpp_pages.write(ROOT, build / "docs" / "doxygen" / "xml", stage / "reference" / "cpp")
    rewriter.finish()


if __name__ == "__main__":
    main()
