"""The common part of all results: as dictionaries, datasets, tables of a notebook and pictures."""

from __future__ import annotations

import itertools
import json
from typing import TYPE_CHECKING, Any, TypeVar

from . import _lober
from ._areas import html_table
from ._call import TABLE, Run
from ._labelled import dataset_of, lists_of, numbers_of
from .errors import UsageError

if TYPE_CHECKING:
    import xarray

Kind = TypeVar("Kind")


class Result:
    """A result of an operation of the engine."""

    _run: Run
    #: The function of lober.plot that draws it.
    _picture: str | None = None

    def to_dict(self) -> dict[str, Any]:
        """The result as the program writes it in JSON: the fields that `lober schema OPERATION` describes, and `agreement`
        and `disagreements` where two routes are compared. Numbers that are not finite are None.

        Parts that are computed when asked for are computed for it, in the way of the program.
        """
        run = self._run.whole
        compared: dict[str, Any] = {}
        if TABLE[run.name]["compares"]:
            compared["agreement"] = bool(run.agreement)
            compared["disagreements"] = [
                {
                    "what": one.what,
                    "first": {"by": one.first_by, "value": one.first},
                    "second": {"by": one.second_by, "value": one.second},
                    "difference": one.difference,
                    "bar": one.bar,
                }
                for one in run.agreement.disagreements
            ]
        return {**compared, **json.loads(run.json)}

    def to_xarray(self) -> xarray.Dataset:
        """All fields of the result: numbers with `units` and `long_name`, error bars beside them, lists along dimensions
        of their own. Names are the paths of the fields with _ between. Attributes say which program computed it."""
        run = self._run.whole
        about = {"operation": run.name, "source": f"lober {_lober.__version__}", "title": TABLE[run.name]["title"]}
        if TABLE[run.name]["compares"]:
            about["agreement"] = str(bool(run.agreement)).lower()
        return dataset_of(TABLE[run.name]["result"], run.value, about)

    def plot(self, ax: Any = None, **options: Any) -> Any:
        """Draws it with matplotlib, by the function of `lober.plot` for such results; returns the axes."""
        from . import plot

        if self._picture is None:
            raise UsageError(f"there is no picture of a {type(self).__name__}; lober.plot has functions for others")
        return getattr(plot, self._picture)(self, ax, **options)

    def view(self, **options: Any) -> Any:
        """Shows it in a viewer, where this build has one."""
        try:
            from . import _view
        except ImportError:
            raise UsageError("this build of lober has no viewer; plot() draws with matplotlib") from None
        return _view.view(self, **options)

    def __repr__(self) -> str:
        """Its first numbers with their error bars, and how long its lists are. Nothing is computed for it."""
        fields, value = TABLE[self._run.name]["result"], self._run.value
        parts = [
            f"{path} = {number:.15g}" if error is None else f"{path} = {number:.15g} +- {error:.1e}"
            for path, number, error, _ in itertools.islice(numbers_of(fields, value), 6)
        ]
        parts += [f"{count} {path}" for path, count in itertools.islice(lists_of(fields, value), 6)]
        return f"<{type(self).__name__}: {', '.join(parts)}>"

    def _repr_html_(self) -> str:
        """Numbers, and how long lists are. Nothing is computed for it."""
        fields, value = TABLE[self._run.name]["result"], self._run.value
        rows = [
            [path, f"{number:.15g}", "" if error is None else f"{error:.1e}", unit]
            for path, number, error, unit in numbers_of(fields, value)
        ]
        lists = ", ".join(f"{count} {path}" for path, count in lists_of(fields, value))
        return f"<p>{TABLE[self._run.name]['title']}</p>" + html_table(["", "value", "error", "unit"], rows) + f"<p>{lists}</p>"


def kept(found: Kind, run: Run) -> Kind:
    """The result, which knows its run from now on."""
    if isinstance(found, Result):
        object.__setattr__(found, "_run", run)
    return found
