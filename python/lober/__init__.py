"""Exact crossings, lobes and areas of curves for phase-space transport.

    >>> import numpy as np, lober
    >>> angle = np.linspace(0, 2 * np.pi, 1000, endpoint=False)
    >>> circle = np.exp(1j * angle)
    >>> r = lober.overlay(circle, circle + 1)
    >>> r.crossings
    2

Results do not depend on the number of threads. Definitions and signs are in docs/conventions.md of the project.
"""

from ._areas import AreaErrors, Areas
from ._densify import Densified, Diagnostic, densify, densify_near, simplify
from ._files import CurveFile, Zone, read, read_zones, write
from ._lober import __version__
from ._overlay import (
    Interior,
    Overlay,
    Piece,
    Pieces,
    SmoothAreas,
    area,
    interior,
    interior_function,
    overlay,
    winding,
)
from ._regions import RegionPieces, Regions, regions
from ._tangle import Boundary, Lobes, Tangle, TangleErrors, tangle
from .errors import Cancelled, DataError, DisagreementError, Error, NotSimpleError, UsageError

__all__ = [
    "AreaErrors",
    "Areas",
    "Boundary",
    "Cancelled",
    "CurveFile",
    "DataError",
    "Densified",
    "Diagnostic",
    "DisagreementError",
    "Error",
    "Interior",
    "Lobes",
    "NotSimpleError",
    "Overlay",
    "Piece",
    "Pieces",
    "RegionPieces",
    "Regions",
    "SmoothAreas",
    "Tangle",
    "TangleErrors",
    "UsageError",
    "Zone",
    "__version__",
    "area",
    "densify",
    "densify_near",
    "interior",
    "interior_function",
    "overlay",
    "read",
    "read_zones",
    "regions",
    "simplify",
    "tangle",
    "winding",
    "write",
]
