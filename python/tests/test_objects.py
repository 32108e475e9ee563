"""Objects of the extension come from its functions only."""

from __future__ import annotations

import copy
import pickle

import pytest
from conftest import ring

import lober
from lober import _lober

CLASSES = [entry for entry in vars(_lober).values() if isinstance(entry, type)]


@pytest.mark.parametrize("of", CLASSES, ids=lambda of: of.__name__)
def test_no_object_without_a_result(of):
    """An attribute of one was read from memory of nobody."""
    for make in (of, lambda: of.__new__(of), lambda: object.__new__(of), lambda: of.__mro__[1].__new__(of)):
        with pytest.raises(TypeError):
            make()
    with pytest.raises(TypeError):
        type("Derived", (of,), {})()


def test_objects_of_results():
    names = {"Areas", "Interior", "KeptCurves", "OperationRun", "Overlay", "RegionPieces", "Regions"}
    names |= {"SharedRun", "System", "Tangle"}
    assert names == {of.__name__ for of in CLASSES}
    r = lober.overlay(ring(50), ring(50, 0.5))
    for again in (pickle.loads(pickle.dumps(r.area)), copy.copy(r.area), copy.deepcopy(r.area)):
        assert again == r.area and again is not r.area
    with pytest.raises(TypeError):
        copy.copy(r._of)
