"""Results as features of GeoJSON, for `__geo_interface__`."""

from __future__ import annotations

from typing import Any, Iterable


def feature(rings: Iterable[Any], about: dict[str, Any]) -> dict[str, Any]:
    """A polygon, the outer ring first, with its properties. Rings end where they begin, as GeoJSON has them."""
    closed = [[*map(tuple, ring.tolist()), tuple(ring[0].tolist())] for ring in rings]
    return {"type": "Feature", "geometry": {"type": "Polygon", "coordinates": closed}, "properties": about}


def features(all_of_them: Iterable[dict[str, Any]]) -> dict[str, Any]:
    return {"type": "FeatureCollection", "features": list(all_of_them)}
