"""Shapes that several tests use."""

from __future__ import annotations

import faulthandler

import numpy as np
import pytest
from hypothesis import settings

faulthandler.enable()
settings.register_profile("lober", deadline=None, derandomize=True, print_blob=True)
settings.load_profile("lober")


def ring(count: int, centre: complex = 0, radius: float = 1) -> np.ndarray:
    """A regular polygon as N x 2 doubles, counter-clockwise."""
    points = centre + radius * np.exp(2j * np.pi * np.arange(count) / count)
    return np.ascontiguousarray(np.stack([points.real, points.imag], axis=1))


@pytest.fixture
def squares() -> tuple[np.ndarray, np.ndarray]:
    """[0, 2]^2 and [1, 3]^2: areas that doubles hold exactly."""
    square = np.array([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]])
    return square, square + 1
