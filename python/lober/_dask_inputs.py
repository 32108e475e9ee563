"""Inputs of a batch for workers that do not see the files: each goes to a worker once, and from there to others."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from .errors import DataError

#: Endings of files that belong to a file of that ending.
COMPANIONS = {".shp": (".dbf", ".shx", ".prj", ".cpg")}


class Scattered:
    """Contents of files as futures of a cluster. Those that the cluster has lost, with the only worker that had them or with
    the scheduler, are read and sent again."""

    def __init__(self, client: Any) -> None:
        self._client = client
        self._futures: dict[str, Any] = {}

    def of(self, files: list[str]) -> dict[str, Any]:
        """A future for each of the files and their companions; files that cannot be read have none, so that the jobs say
        so, as they would here."""
        wanted = [one for file in files for one in (file, *_companions(file))]
        missing = [path for path in wanted if not self._is_there(path)]
        contents = {path: content for path in missing if (content := _content(path)) is not None}
        if contents:
            # Lists, as a dictionary would be taken for names of keys that are there from before.
            sent = self._client.scatter(list(contents.values()), hash=False)
            self._futures.update(zip(contents, sent))
        return {path: self._futures[path] for path in wanted if path in self._futures}

    def _is_there(self, path: str) -> bool:
        future = self._futures.get(path)
        if future is not None and future.status in ("cancelled", "lost", "error"):
            del self._futures[path]
            return False
        return future is not None


def _companions(path: str) -> list[str]:
    stem, ending = os.path.splitext(path)
    candidates = [stem + other for other in COMPANIONS.get(ending.lower(), ())]
    return [one for one in candidates if os.path.exists(one)]


def _content(path: str) -> bytes | None:
    try:
        if os.path.isfile(path):
            return Path(path).read_bytes()
    except OSError as error:
        raise DataError(f"{path}: {error.strerror}") from None
    return None
