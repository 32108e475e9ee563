"""Manifests of batches: a file, or a dictionary with the keys of one, written out as TOML."""

from __future__ import annotations

import json
import math
import os
from typing import Any, Mapping

import numpy as np

from .errors import UsageError

#: The name of a manifest that is not a file, in messages; its files are relative to the working folder.
UNNAMED = "manifest"


def toml_of(manifest: Mapping[str, Any]) -> str:
    """A dictionary as TOML, a line for each of its keys. Raises UsageError for a value that TOML does not have."""
    return "".join(f"{_key(key)} = {_value(value, str(key))}\n" for key, value in manifest.items() if value is not None)


def _key(key: Any) -> str:
    if not isinstance(key, str):
        raise UsageError(f"the keys of a manifest are texts, not {type(key).__name__}")
    return _text(key)


def _text(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _value(value: Any, where: str) -> str:
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (str, os.PathLike)):
        return _text(os.fspath(value))
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        number = float(value)
        return repr(number) if math.isfinite(number) else str(number)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_key(key)} = {_value(one, f'{where}.{key}')}" for key, one in value.items()) + " }"
    if isinstance(value, np.ndarray) and value.ndim == 1 and value.dtype.kind in "biufU":
        value = value.tolist()
    if isinstance(value, (list, tuple, range)):
        return "[" + ", ".join(_value(one, where) for one in value) + "]"
    advice = ""
    if where.split(".")[-1] in ("curves", "with", "pairs"):
        advice = "; curves of a batch are files: lober.write puts arrays into one, and lober.overlap_matrix takes arrays"
    raise UsageError(f"{UNNAMED}: {where}: a value of type {type(value).__name__} cannot be used{advice}")
