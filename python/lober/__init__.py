"""Exact crossings, lobes and areas of curves for phase-space transport.

    >>> import numpy as np, lober
    >>> angle = np.linspace(0, 2 * np.pi, 1000, endpoint=False)
    >>> circle = np.exp(1j * angle)
    >>> r = lober.overlay(circle, circle + 1)
    >>> r.crossings
    2

`lober.show_versions()` prints versions, `lober.test()` tests the installed package in a second.

Results do not depend on the number of threads. Definitions and signs are in docs/conventions.md of the project.
"""

from . import _generated, batch, plot
from ._agreement import Agreement, Comparison
from ._areas import AreaErrors, Areas
from ._dynamics import (
    FixedPoint,
    FixedPoints,
    GrowthDiagnostic,
    Image,
    Manifold,
    fixed_point,
)
from ._generated import *  # noqa: F403
from ._files import CurveFile, Format, Zone, formats, read, read_zones, write
from ._lober import __version__
from ._own import Family, flow, map
from ._overlay import (
    Interior,
    Overlay,
    Piece,
    Pieces,
    SmoothAreas,
    area,
    interior_function,
    winding,
)
from ._overlaps import overlap_matrix, overlay_many
from ._regions import RegionPieces, Regions
from ._section_system import section_system
from ._self_test import test
from ._show_versions import show_versions
from ._symbolic import equations, hamiltonian
from ._systems import Connection, Parameter, System, SystemInfo, system, systems
from ._tangle import Boundary, Lobes, Tangle, TangleErrors
from ._images import image
from ._measured import Measured
from ._melnikov import Melnikov
from ._operation import call
from ._transport import (
    Bottleneck,
    Escape,
    Region,
    SystemTangle,
    Transport,
    TransportBoundary,
)
from ._view import Page, page, view
from .errors import Cancelled, DataError, DisagreementError, DisagreementWarning, Error, IncompleteWarning, NotSimpleError, UsageError

__all__ = [
    "Agreement",
    "AreaErrors",
    "Areas",
    "Bottleneck",
    "Boundary",
    "Cancelled",
    "Comparison",
    "Connection",
    "CurveFile",
    "DataError",
    "DisagreementError",
    "DisagreementWarning",
    "Error",
    "IncompleteWarning",
    "Escape",
    "Family",
    "FixedPoint",
    "FixedPoints",
    "Format",
    "GrowthDiagnostic",
    "Image",
    "Interior",
    "Lobes",
    "Manifold",
    "Measured",
    "Melnikov",
    "NotSimpleError",
    "Overlay",
    "Page",
    "Parameter",
    "Piece",
    "Pieces",
    "Region",
    "RegionPieces",
    "Regions",
    "SmoothAreas",
    "System",
    "SystemInfo",
    "SystemTangle",
    "Tangle",
    "TangleErrors",
    "Transport",
    "TransportBoundary",
    "UsageError",
    "Zone",
    "__version__",
    "area",
    "batch",
    "call",
    "equations",
    "fixed_point",
    "flow",
    "formats",
    "hamiltonian",
    "image",
    "interior_function",
    "map",
    "overlap_matrix",
    "overlay_many",
    "page",
    "plot",
    "read",
    "read_zones",
    "section_system",
    "show_versions",
    "system",
    "systems",
    "test",
    "view",
    "winding",
    "write",
]
__all__ += _generated.__all__
