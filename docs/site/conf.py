"""Sphinx configuration of the site; `make docs` builds it from the folder that stage.py lays out."""

import os
import re
from pathlib import Path

ROOT = Path(os.environ["LOBER_SOURCE"])

project = "lober"
copyright = "the lober authors, BSD 3-Clause"
version = release = ".".join(
    re.findall(r"VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", (ROOT / "engine/lober/base/version.hpp").read_text())
)

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.mathjax",
    "sphinx_copybutton",
]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
exclude_patterns = ["files"]
root_doc = "index"
nitpicky = False

myst_enable_extensions = ["dollarmath", "amsmath", "colon_fence"]
myst_heading_anchors = 4
myst_dmath_allow_labels = False

# MathJax lies beside the pages; nothing is loaded from elsewhere.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_SVG"
mathjax2_config = {
    "SVG": {"font": "TeX"},
    "tex2jax": {"processClass": "math"},
    "showMathMenu": False,
    "messageStyle": "none",
}
myst_update_mathjax = False  # its settings are those of MathJax 3

html_theme = "furo"
html_title = "lober"
html_static_path = [str(ROOT / "docs/site/static"), os.environ["LOBER_SITE_STATIC"]]
html_css_files = ["lober.css"]
html_show_sphinx = False
html_copy_source = False
html_theme_options = {"navigation_with_keys": True}
copybutton_prompt_text = "$ "
copybutton_only_copy_prompt_lines = True

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
python_use_unqualified_type_names = True

PARAMETER = re.compile(r"^(\*{0,2}[A-Za-z_]\w*): (.*)$")


def as_rst(lines):
    """Comments of the package as RST: `code`, lists of `name: meaning` and of points, indented lines as code."""
    out = []
    kind = "text"  # or "list", "code"
    for line in lines:
        before = out[-1] if out else ""
        found = PARAMETER.match(line)
        if kind == "code" and line and not line.startswith(" "):
            out.append("")
            kind = "text"
        if found and (not before.strip() or kind == "list"):
            line = f":{found[1]}: {found[2]}"
            kind = "list"
        elif line.startswith("- ") and (not before.strip() or kind == "list"):
            kind = "list"
        elif line.startswith(" ") and kind == "text":
            out += ["", ".. code-block:: python", ""]
            kind = "code"
        elif line.strip() and not line.startswith(" ") and kind == "list":
            if before.strip():
                out.append("")
            kind = "text"
        if kind == "code":
            out.append("    " + line if line else line)
            continue
        pieces = re.split(r"(`[^`]*`)", line)
        out.append("".join(f"`{each}`" if each.startswith("`") else re.sub(r"(\*|\||(?<=\w)_(?!\w)|(?<=\bFILE):)", r"\\\1", each) for each in pieces))
    return out


def process_docstring(app, what, name, thing, options, lines):
    lines[:] = as_rst(lines)


def setup(app):
    from pygments.lexers.special import TextLexer

    app.add_lexer("usage", TextLexer)
    app.connect("autodoc-process-docstring", process_docstring)
