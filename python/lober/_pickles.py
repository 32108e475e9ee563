"""Families of systems of one's own in pickles: by the expressions that they are made of, or by the import path of their
function."""

from __future__ import annotations

import importlib
import pickle
from functools import reduce
from typing import Any

MAIN = "__main__"


def pickled(family: Any, maker: Any, given: Any, options: dict[str, Any]) -> tuple[Any, ...]:
    """For `__reduce__`. A family of expressions is made again of these. That of a function is imported from where it
    stands; where it stands nowhere, in a notebook or within another function, its code goes along by cloudpickle, as
    Dask does it, where that is installed. Raises PicklingError."""
    function = getattr(given, "_pyfunc", given)  # of a cfunc of numba
    if not callable(function) or not hasattr(function, "__qualname__"):
        return again, (maker.__module__, maker.__name__, given, options)
    module, path = function.__module__, function.__qualname__
    stands = _at(module, path) is family
    if stands and module != MAIN:
        return _imported, (module, path)
    try:
        import cloudpickle  # type: ignore[import]

        return _loaded, (cloudpickle.dumps((maker.__module__, maker.__name__, given, options)),)
    except Exception:  # it is not installed, or there is something that it cannot take along
        if stands:
            return _imported, (module, path)
    raise pickle.PicklingError(
        f"system {family.name} cannot be pickled: {module}.{path} is not where it can be imported from; define it at the top of "
        "a module, make it of expressions, or install cloudpickle"
    )


def _at(module: str, path: str) -> Any:
    try:
        return reduce(getattr, path.split("."), importlib.import_module(module))
    except (ImportError, AttributeError):
        return None


def _imported(module: str, path: str) -> Any:
    return reduce(getattr, path.split("."), importlib.import_module(module))


def again(module: str, name: str, given: Any, options: dict[str, Any]) -> Any:
    return getattr(importlib.import_module(module), name)(given, **options)


def _loaded(call: bytes) -> Any:
    return again(*pickle.loads(call))
