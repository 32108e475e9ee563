"""Tutorials: documents whose code is executed when the site is built, with the results behind each block.

A ```python block is a cell, and an ```output block what it prints, which is compared. A ```console block is a command and what it
printed; here it is run again, and so is a ```sh block.
Pictures are those of matplotlib, and those that a command writes with --svg or --picture.
"""

import base64
import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

import nbclient
import nbformat

ROOT = Path(__file__).resolve().parent.parent.parent
FENCE = re.compile(r"^```(\w*)(.*)$")
PICTURE = re.compile(r"--(?:svg|picture|tubes) (\S+\.svg)")
ANSI = re.compile(r"\x1b\[[0-9;]*m")
# Lines with times and dates, which differ from run to run.
TIMES = re.compile(r"jobs a second|^time of the threads|\d{4}-\d\d-\d\dT\d\d:")
START = """%config InlineBackend.figure_formats = ['svg']
%matplotlib inline
import matplotlib
matplotlib.rcParams.update({'figure.figsize': (6.4, 4.2), 'svg.hashsalt': 'lober', 'figure.autolayout': True})
"""


def parts_of(text: str) -> list[tuple[str, str]]:
    """The document as (kind, text), where kind is the language of a block, or empty between blocks."""
    parts, kind, lines = [], "", []
    for line in text.splitlines():
        found = FENCE.match(line)
        if found and not kind:
            parts.append(("", "\n".join(lines)))
            kind, lines = found[1] or "text", []
        elif line == "```" and kind:
            parts.append((kind, "\n".join(lines)))
            kind, lines = "", []
        else:
            lines.append(line)
    parts.append(("", "\n".join(lines)))
    return parts


def executed(source: Path, build: Path, files: Path) -> str:
    """The document with results. Its pictures and the notebook, to be taken away, go to the folder `files`."""
    parts = parts_of(source.read_text())
    book = nbformat.v4.new_notebook(metadata={"kernelspec": {"name": "lober", "display_name": "lober", "language": "python"}})
    book.cells.append(nbformat.v4.new_code_cell(START))
    cell_of: dict[int, int] = {}
    expected: dict[int, str] = {}  # by the part of the cell
    for index, (kind, text) in enumerate(parts):
        if kind == "python":
            cell = nbformat.v4.new_code_cell(text)
        elif kind == "console":
            cell = nbformat.v4.new_code_cell("%%bash\n" + text.splitlines()[0].removeprefix("$ "))
        elif kind == "sh":
            cell = nbformat.v4.new_code_cell("%%bash\n" + text)
        elif kind == "output":
            expected[max(cell_of)] = text
            continue
        elif text.strip():
            shown = text if not kind else f"```{kind}\n{text}\n```"
            cell = nbformat.v4.new_markdown_cell(shown.strip())
        else:
            continue
        cell_of[index] = len(book.cells)
        book.cells.append(cell)
    files.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as work:
        shutil.copytree(ROOT / "examples", Path(work) / "examples")
        run(book, build, Path(work))
        pieces = []
        for index, (kind, text) in enumerate(parts):
            if not kind:
                pieces.append(text)
                continue
            if kind == "output":
                continue  # as it was printed now, behind the cell
            if kind == "console":
                pieces.append(f"```console\n{text.splitlines()[0]}\n```")
            else:
                pieces.append(f"```{kind}\n{text}\n```")
            if index in cell_of and book.cells[cell_of[index]].cell_type == "code":
                pieces += results(book.cells[cell_of[index]], files, f"{index:02d}")
                if index in expected:
                    require_same(expected[index], book.cells[cell_of[index]], source)
                for picture in PICTURE.findall(text):
                    shutil.copyfile(Path(work) / picture, files / f"{index:02d}-{Path(picture).name}")
                    pieces.append(image(files, f"{index:02d}-{Path(picture).name}"))
    del book.cells[0]
    for cell in book.cells:
        cell.pop("id", None)
    book.nbformat_minor = 4
    nbformat.write(book, files / f"{source.stem}.ipynb")
    pieces.append(f"\n[This page as a notebook]({files.name}/{source.stem}.ipynb)\n")
    return "\n".join(pieces)


def run(book: nbformat.NotebookNode, build: Path, work: Path) -> None:
    """Executes the cells in the environment of the build folder; a cell that fails is an error."""
    python = build / "python" / "venv" / "bin" / "python"
    kernels = work / ".kernels" / "kernels" / "lober"
    kernels.mkdir(parents=True)
    (kernels / "kernel.json").write_text(
        '{"argv": ["%s", "-P", "-Xfrozen_modules=off", "-m", "ipykernel_launcher", "-f", "{connection_file}"],'
        ' "display_name": "lober", "language": "python"}' % python
    )
    os.environ["JUPYTER_PATH"] = str(work / ".kernels")
    os.environ["PATH"] = f"{build / 'bin'}:{os.environ['PATH']}"
    os.environ["IPYTHONDIR"] = str(work / ".ipython")
    client = nbclient.NotebookClient(book, timeout=300, kernel_name="lober", record_timing=False,
                                     resources={"metadata": {"path": str(work)}})
    client.execute()
    shutil.rmtree(work / ".kernels")


def require_same(shown: str, cell: nbformat.NotebookNode, source: Path) -> None:
    """Raises SystemExit unless a cell has printed what the document shows, as scripts/check-readme.sh compares it."""
    text = "".join(output.text for output in cell.outputs if output.output_type == "stream" and output.name == "stdout")
    with tempfile.TemporaryDirectory() as folder:
        names = [Path(folder) / name for name in ("shown", "printed")]
        for name, content in zip(names, (shown, text)):
            name.write_text(content.rstrip("\n") + "\n")
        done = subprocess.run(["awk", "-f", ROOT / "scripts" / "same-output.awk", *names], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{source}: a cell prints something else\n{done.stdout}")


def image(files: Path, name: str) -> str:
    return f"\n![{Path(name).stem.split('-', 1)[-1].replace('-', ' ')}]({files.name}/{name})\n"


def results(cell: nbformat.NotebookNode, files: Path, number: str) -> list[str]:
    """What a cell printed, showed and drew, as Markdown."""
    pieces = []
    outputs: list[nbformat.NotebookNode] = []
    for output in cell.outputs:  # lines that were printed one by one
        if outputs and output.output_type == "stream" == outputs[-1].output_type:
            outputs[-1].text += output.text
        else:
            outputs.append(output)
    cell.outputs = outputs
    if "SOURCE_DATE_EPOCH" in os.environ:  # a build that has to give the same files each time
        for output in outputs:
            if output.output_type == "stream":
                output.text = "\n".join("..." if TIMES.search(line) else line for line in output.text.split("\n"))
    for index, output in enumerate(outputs):
        if output.output_type == "stream":
            pieces.append(printed(output.text))
            continue
        data = output.get("data", {})
        if "image/svg+xml" in data or "image/png" in data:
            kind = "svg" if "image/svg+xml" in data else "png"
            name = f"{number}-figure-{index}.{kind}"
            if kind == "svg":
                (files / name).write_text(data["image/svg+xml"])
            else:
                (files / name).write_bytes(base64.b64decode(data["image/png"]))
            pieces.append(image(files, name))
        elif "text/html" in data:
            pieces.append(f"\n```{{raw}} html\n<div class=\"result-table\">{data['text/html']}</div>\n```\n")
        elif "text/plain" in data:
            pieces.append(printed(data["text/plain"]))
    return pieces


def printed(text: str) -> str:
    return f"\n```text\n{ANSI.sub('', text).rstrip()}\n```\n"
