"""Links of documents of the repository, turned into links between pages of the site."""

import os
import re
import shutil
from pathlib import Path

LINK = re.compile(r"\]\(([^)\s]+)\)")
ELSEWHERE = re.compile(r"^(https?:|mailto:|#)")


class Rewriter:
    """Rewrites the links of pages and copies the files that they name beside them."""

    def __init__(self, root: Path, stage: Path, pages: dict[str, str]):
        self.root, self.stage, self.pages = root, stage, pages
        self.missing: list[str] = []

    def rewrite(self, source: str, page: str, text: str) -> str:
        lines, fence = [], ""
        for line in text.splitlines():
            opening = re.match(r"^(```+|~~~+)", line)
            if opening and not fence:
                fence = opening[1]
            elif fence and line.startswith(fence):
                fence = ""
            elif not fence:
                line = LINK.sub(lambda found: f"]({self.target(source, page, found[1])})", line)
            lines.append(line)
        return "\n".join(lines) + "\n"

    def target(self, source: str, page: str, link: str) -> str:
        """Where a link of the page leads on the site."""
        if ELSEWHERE.match(link):
            return link
        path, _, anchor = link.partition("#")
        anchor = f"#{anchor}" if anchor else ""
        folder = os.path.dirname(page)
        staged = self.stage / folder / path
        if staged.is_file():  # made by the site itself
            return link
        repository = os.path.normpath(os.path.join(os.path.dirname(source), path))
        if repository in self.pages:
            return os.path.relpath(f"{self.pages[repository]}.md", folder or ".") + anchor
        found = self.root / repository
        if found.is_dir():
            return "#"
        if not found.is_file():
            # A page that is generated, by its name on the site.
            if source.startswith("docs/site/") or os.path.normpath(os.path.join(folder, path)).removesuffix(
                ".md"
            ) in self.pages.values():
                return link
            self.missing.append(f"{source}: {link}")
            return link
        copy = self.stage / "files" / repository
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(found, copy)
        return os.path.relpath(copy.relative_to(self.stage), folder or ".")

    def finish(self) -> None:
        if self.missing:
            raise SystemExit("links to nothing:\n  " + "\n  ".join(self.missing))
