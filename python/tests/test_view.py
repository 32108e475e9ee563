"""Pages of results and of curves."""

import copy
import pickle
import re
import webbrowser

import numpy as np
import pytest

import lober

ANGLE = np.linspace(0, 2 * np.pi, 400, endpoint=False)
CIRCLE = np.exp(1j * ANGLE)


def test_pages_of_results_and_curves(tmp_path):
    overlay = lober.overlay(CIRCLE, CIRCLE + 1)
    text = lober.page(overlay, title="<two> circles").text
    assert "<title>&lt;two&gt; circles</title>" in text
    assert '"name":"C1 \\\\ C2"' in text and "Content-Security-Policy" in text
    regions = lober.regions(CIRCLE, CIRCLE + 1)
    assert "by the rule nonzero" in lober.page(regions).text
    curves = lober.page(CIRCLE, np.array([[0.0, 0], [1, 1], [0, 0]])).text
    assert re.findall(r'"closed":(\w+)', curves) == ["false", "true"]
    saved = lober.page(CIRCLE).save(tmp_path / "a.html")
    assert saved.read_text(encoding="utf-8") == lober.page(CIRCLE).text
    assert list(tmp_path.iterdir()) == [saved]


def test_pages_of_systems():
    transport = lober.transport(lober.system("standard", K=1.2), iterates=1)
    assert "Transport across" in lober.page(transport).text
    grown = lober.grow(lober.system("henon"), side="stable", length=3.0)
    assert '"n":' + str(len(grown.points)) in lober.page(grown).text
    assert lober.page(copy.copy(transport)).text == lober.page(transport).text
    with pytest.raises(lober.UsageError, match="compute it again"):
        lober.page(pickle.loads(pickle.dumps(transport)))


def test_view_opens_the_page(tmp_path, monkeypatch):
    opened = []
    monkeypatch.setattr(webbrowser, "open", opened.append)
    path = lober.view(CIRCLE, path=tmp_path / "b.html")
    assert opened == [path.resolve().as_uri()]
    lober.view(CIRCLE, path=tmp_path / "c.html", open=False)
    assert len(opened) == 1 and (tmp_path / "c.html").exists()


def test_notebooks_show_a_page_in_a_frame():
    frame = lober.page(CIRCLE)._repr_html_()
    assert frame.startswith("<iframe") and "sandbox=" in frame and "<script" not in frame


@pytest.mark.parametrize("what", [(), (3,), ("text",), (lober.overlay(CIRCLE, CIRCLE + 1), CIRCLE)])
def test_what_has_no_page(what):
    with pytest.raises(lober.UsageError):
        lober.page(*what)
