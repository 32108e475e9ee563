"""Any operation of the engine's table by its name."""

from __future__ import annotations

from typing import Any

from ._call import TABLE, run
from ._progress import Progress
from .errors import UsageError


def call(operation: str, *inputs: Any, threads: int = 0, progress: Progress = None, **options: Any) -> dict[str, Any]:
    """Runs an operation of the engine's table, which `lober schema` lists, and returns its result: a dictionary of the
    fields that `lober schema OPERATION` describes, lists as dictionaries of columns, numbers with error bars as pairs of
    both, and `agreement`.

    `inputs`: in the order of the operation, a System or its name, and curves or points, as arrays of N x 2 numbers or
    complex vectors. `options`: those of the operation; None stands for the default. Raises UsageError, DataError,
    Cancelled.
    """
    if operation not in TABLE:
        raise UsageError(f"there is no operation {operation!r}; there are {', '.join(sorted(TABLE))}")
    specs = TABLE[operation]["inputs"]
    if len(inputs) > len(specs):
        raise UsageError(f"{operation} takes {len(specs)} inputs or fewer, not {len(inputs)}")
    known = {option["key"] for option in TABLE[operation]["options"]}
    for key in options:
        if key not in known:
            raise UsageError(f"{operation} has no option {key!r}; it has {', '.join(sorted(known))}")
    found = run(operation, inputs, options, threads, progress)
    return {**found.value, "agreement": found.agreement}
