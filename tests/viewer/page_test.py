#!/usr/bin/env python3
"""Pages of lober in a real browser: page_test.py LOBER BROWSER. Ends with 77, and says why, where that browser is not there."""

import base64
import csv
import math
import os
import random
import re
import struct
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from fractions import Fraction

from pages import OVP, PROGRAM, curve_of, lober, run, write_npy


def points_are_exact(browser, folder):
    chance = random.Random(1)
    kinds = [
        [(chance.uniform(-1, 1), chance.gauss(0, 1e-7)) for _ in range(2000)],
        [(math.cos(k / 300), 1e-3 * k) for k in range(70000)],
        [(1e300 * chance.uniform(-1, 1), 1e-300 * chance.uniform(-1, 1)) for _ in range(600)],
        [(-0.0, 5e-324 * k) for k in range(600)] + [(1.0, -0.0)],
        [(1e15 + k, -1e15 + 0.25 * k) for k in range(513)],
    ]
    for number, points in enumerate(kinds):
        source, page = os.path.join(folder, "c.npy"), os.path.join(folder, "c.html")
        write_npy(source, points)
        lober("view", source, "-o", page)
        browser.open(page)
        found = curve_of(browser, 0)
        assert len(found) == len(points)
        wrong = [k for k, (a, b) in enumerate(zip(found, points)) if struct.pack("<2d", *a) != struct.pack("<2d", *b)]
        assert not wrong, (number, wrong[:3], found[wrong[0]], points[wrong[0]])


def expected_pixels(points, view):
    """Points of the curve's segments in pixels, about one each pixel, by exact arithmetic."""
    x, dx, y, dy, scale = (Fraction(view[key]) for key in ("x", "dx", "y", "dy", "scale"))
    width, height = view["width"], view["height"]

    def pixel(point):
        return (float((Fraction(point[0]) - x - dx) * scale + Fraction(width, 2)),
                float(Fraction(height, 2) - (Fraction(point[1]) - y - dy) * scale))

    reach = max(width, height) / view["scale"]
    centre = (view["x"], view["y"])
    pixels = []
    for a, b in zip(points, points[1:]):
        low = [min(a[k], b[k]) - centre[k] for k in (0, 1)]
        high = [max(a[k], b[k]) - centre[k] for k in (0, 1)]
        if any(high[k] < -reach or low[k] > reach for k in (0, 1)):
            continue
        (ax, ay), (bx, by) = pixel(a), pixel(b)
        # The part in the frame, as in Liang & Barsky (1984), in exact arithmetic of the pixels' doubles.
        first, last = Fraction(0), Fraction(1)
        for start, step, limit in ((ax, bx - ax, width), (ay, by - ay, height)):
            for speed, gap in ((-step, start), (step, limit - start)):
                if speed == 0:
                    last = last if gap >= 0 else Fraction(-1)
                elif speed < 0:
                    first = max(first, Fraction(gap) / Fraction(speed))
                else:
                    last = min(last, Fraction(gap) / Fraction(speed))
        if first > last:
            continue
        length = float((last - first)) * math.hypot(bx - ax, by - ay)
        count = max(1, math.ceil(length))
        for k in range(count + 1):
            t = first + (last - first) * Fraction(k, count)
            pixels.append((ax + float(t * Fraction(bx - ax)), ay + float(t * Fraction(by - ay))))
    return pixels


# The pixels of the canvas that are not ground, as a string of 0 and 1.
DRAWN = """(() => { const c = lober.canvas, d = lober.context.getImageData(0, 0, c.width, c.height).data; let t = '';
for (let k = 0; k < d.length; k += 4) t += d[k] + d[k + 1] + d[k + 2] < 600 ? '1' : '0'; return t; })()"""
ONLY_LINES = ("for (const layer of lober.scene.layers) layer.shown = layer.kind === 'lines';"
              "lober.paintAxes = false; lober.redraw()")
VIEW = "({x: lober.view.x, dx: lober.view.dx, y: lober.view.y, dy: lober.view.dy, scale: lober.view.scale, width: lober.view.width, height: lober.view.height})"


def zooms_into_a_pip(browser, folder):
    page = os.path.join(folder, "ovp.html")
    lober(*OVP, "--html", page)
    browser.open(page)
    x, y = browser.run("(({ things }) => [things.x[0], things.y[0]])(lober.scene.layers.find((one) => one.name === 'pips'))")
    for depth in (1, 1e4, 1e8, 1e12):
        browser.open(page, f"#{x!r},{y!r},{depth!r},")
        browser.run(ONLY_LINES)
        browser.settle()
        browser.settle()
        view, drawn = browser.run(VIEW), browser.run(DRAWN)
        width, height = int(view["width"]), int(view["height"])
        lines = [k for k, kind in enumerate(browser.run("lober.scene.layers.map((one) => one.kind)")) if kind == "lines"]
        expected = set()
        for layer in lines:
            pixels = expected_pixels(curve_of(browser, layer), view)
            assert depth > 1 or len(pixels) > 300
            assert len(pixels) > 100, (depth, layer, "the curve goes through the view")
            # Within two pixels of where it belongs there is ink; axes and labels lie along the edges.
            missing = [(x, y) for x, y in pixels if 60 < x < width - 60 and 40 < y < height - 60 and not any(
                drawn[(int(y) + j) * width + int(x) + i] == "1" for i in (-1, 0, 1, 2) for j in (-1, 0, 1, 2))]
            assert not missing, (depth, layer, missing[:5], len(missing))
            expected.update((int(x) + i, int(y) + j) for x, y in pixels for i in range(-3, 5) for j in range(-3, 5))
        stray = [(k % width, k // width) for k, one in enumerate(drawn) if one == "1"]
        stray = [(x, y) for x, y in stray if (x, y) not in expected and 200 < x < width - 200 and 40 < y < height - 80]
        assert not stray, (depth, stray[:5], len(stray))
    assert browser.run("lober.view.zoom(1e9), lober.view.atEnd")
    browser.run("lober.redraw()")
    browser.settle()
    assert not browser.run("document.getElementById('end').hidden")


# Both pictures, pixel by pixel: the plot of the program's own, drawn over a canvas of the page's size, and the page's.
# Gives, of each colour, its pixels in page and picture, and those of either with none of the other nearby. Marks cover
# what is about some points.
COMPARED = """(async ([file, left, top, wide, high], covered, colours) => {
  const image = new Image();
  await new Promise((done, failed) => { image.onload = done; image.onerror = failed; image.src = file; });
  const { width, height } = lober.canvas, other = new OffscreenCanvas(width, height).getContext("2d");
  const [w, h] = [image.width, image.height];
  other.drawImage(image, left * w, top * h, wide * w, high * h, 0, 0, width, height);
  const data = [lober.context, other].map((context) => context.getImageData(0, 0, width, height).data);
  const near = (data, [red, green, blue]) => {
    const marks = new Uint8Array(width * height);
    for (let k = 0; k < marks.length; ++k) {
      marks[k] = Math.abs(data[4 * k] - red) + Math.abs(data[4 * k + 1] - green) + Math.abs(data[4 * k + 2] - blue) < 90;
    }
    return marks;
  };
  const alone = (marks, others) => {
    let all = 0, found = 0;
    for (let y = 12; y < height - 12; ++y) for (let x = 12; x < width - 12; ++x) {
      if (!marks[y * width + x] || covered.some(([px, py]) => Math.hypot(px - x, py - y) < 24)) continue;
      ++all;
      let near = false;
      for (let j = -3; j <= 3; ++j) for (let i = -3; i <= 3; ++i) near ||= others[(y + j) * width + x + i] === 1;
      found += near ? 0 : 1;
    }
    return [all, found];
  };
  return colours.map((colour) => {
    const [page, picture] = data.map((one) => near(one, colour));
    return [...alone(page, picture), ...alone(picture, page)];
  });
})"""


def agrees_with_pictures_of_the_program(browser, folder):
    page, png, svg = (os.path.join(folder, "ovp." + ending) for ending in ("html", "png", "svg"))
    answer = subprocess.run([PROGRAM, *OVP, "--picture", png], capture_output=True, text=True)
    if "librsvg" in answer.stderr:
        print("skipped, without pictures as PNG: " + answer.stderr.strip())
        return
    lober(*OVP, "--html", page)
    browser.open(page)
    x, y = browser.run("(({ things }) => [things.x[0], things.y[0]])(lober.scene.layers.find((one) => one.name === 'pips'))")
    for depth in (1, 1e4, 1e8, 1e12):
        browser.open(page, f"#{x!r},{y!r},{depth!r},")
        browser.run("for (const layer of lober.scene.layers) layer.width = 3;" + ONLY_LINES)
        browser.settle()
        browser.settle()
        window = ",".join(repr(value) for value in browser.run("lober.view.box()"))
        for path in (png, svg):
            lober(*OVP, "--picture", path, f"--window={window}", "--size", "60", "--no-legend", "--no-labels")
        with open(svg, encoding="utf-8") as file:
            text = file.read()
        width, height = map(float, re.search(r'viewBox="0 0 (\S+) (\S+)"', text).groups())
        plot = re.search(r'id="plot"><rect x="(\S+)" y="(\S+)" width="(\S+)" height="(\S+)"', text).groups()
        left, top, wide, high = (float(value) / (width, height)[k % 2] for k, value in enumerate(plot))
        with open(png, "rb") as file:
            data = "data:image/png;base64," + base64.b64encode(file.read()).decode()
        # Pips, and the saddles, where curves begin.
        marks = browser.run("lober.scene.layers.flatMap(({ kind, things, curves }) => kind === 'dots' ? [things] : kind === 'lines' ?"
                            "[{ x: [curves[0].curve.x[0]], y: [curves[0].curve.y[0]] }] : [])"
                            ".flatMap(({ x, y }) => Array.from(x, (_, k) => [lober.view.px(x[k]), lober.view.py(y[k])]))")
        lines = [colour for colour, kind in browser.run("lober.scene.layers.map((one) => [one.colour, one.kind])") if kind == "lines"]
        colours = [[int(colour[k:k + 2], 16) for k in (1, 3, 5)] for colour in lines]
        found = browser.run(f"{COMPARED}({[data, left, top, wide, high]}, {marks}, {colours})")
        print(f"  zoom {depth:g}: " + "; ".join(f"{line}: {in_page} pixels of the page, {in_picture} of the picture, {a} and {b} alone"
                                              for line, (in_page, a, in_picture, b) in zip(lines, found)))
        assert all(in_page > 300 and in_picture > 300 and a == b == 0 for in_page, a, in_picture, b in found), (depth, found)


def lobes_are_read(browser, folder):
    page = os.path.join(folder, "ovp.html")
    browser.open(page)
    x, y = browser.run("(() => { const box = lober.canvas.getBoundingClientRect();"
                       "return [box.left + lober.view.px(1.0), box.top + lober.view.py(0.6)]; })()")
    browser.move(x, y)
    assert "L12(1)" in browser.run("document.getElementById('status').textContent")
    browser.click(x, y)
    status = browser.run("document.getElementById('status').textContent")
    assert re.match(r"lobe 0 L12\(1\): area 0\.254106\d* ± \S+, n 1", status), status
    assert "L12(1)" in browser.run("document.querySelector('tr.chosen').textContent")
    browser.click(x, y)  # the second one of a double click, or a click again
    browser.run("lober.double(%g, %g)" % tuple(browser.run("[lober.view.px(1.0), lober.view.py(0.6)]")))
    browser.settle()
    assert browser.run("lober.view.depth") > 1.5
    browser.run("new Promise((done) => setTimeout(done, 400))")
    link, view = browser.run("location.hash"), browser.run("lober.view.box()")
    shown = browser.run("document.querySelectorAll('#layers input')[0].click(), lober.writeLink(), location.hash")
    assert link != shown
    browser.open(page, shown)
    assert browser.run("lober.scene.layers[0].shown") is False
    size = view[2] - view[0]
    assert all(abs(a - b) < 1e-9 * size for a, b in zip(view, browser.run("lober.view.box()")))
    assert browser.run("typeof svgOf") == "undefined"  # modules keep their names to themselves


def keys_and_wheel(browser, folder):
    browser.open(os.path.join(folder, "ovp.html"))
    browser.run("lober.canvas.focus()")
    before = browser.run("lober.view.depth")
    browser.key("+")
    assert abs(browser.run("lober.view.depth") / before - 1.5) < 1e-9
    browser.key("0")
    assert browser.run("lober.view.depth") == 1
    x, y = 300, 400
    kept = browser.run(f"lober.view.at({x}, {y} - lober.canvas.getBoundingClientRect().top)")
    browser.wheel(x, y, -200)
    browser.run("new Promise((done) => setTimeout(done, 200))")
    now = browser.run(f"lober.view.at({x}, {y} - lober.canvas.getBoundingClientRect().top)")
    assert browser.run("lober.view.depth") > 1.2
    assert all(abs(a - b) < 1e-12 for a, b in zip(kept, now)), (kept, now)
    names = browser.run("[...document.querySelectorAll('button, input, select, canvas, [role=region]')].filter((one) =>"
                        "!(one.getAttribute('aria-label') || one.textContent.trim() || one.closest('label') ||"
                        "document.querySelector(`label[for='${one.id}']`))).map((one) => one.outerHTML)")
    assert names == [], names


def exports_measure_and_iterates(browser, folder):
    page, svg = os.path.join(folder, "tr.html"), os.path.join(folder, "view.svg")
    lober("transport", *OVP[1:], "--iterates", "3", "--html", page)
    browser.open(page)
    whole = browser.run("lober.csv()")
    rows = list(csv.reader(whole.splitlines()))
    assert {len(row) for row in rows} == {len(rows[0])}
    head = rows[0]
    areas = {row[1]: row for row in rows if row[1].endswith("L12(1)")}
    assert len(areas) == 1, areas
    row = next(iter(areas.values()))
    assert abs(float(row[head.index("area")]) - 0.2541062771) < 1e-7
    assert 0 < float(row[head.index("area_error")]) < 1e-6
    with open(svg, "w", encoding="utf-8") as file:
        file.write(browser.run("lober.svg()"))
    ElementTree.parse(svg)
    assert any(row[0].startswith("U,") for row in rows), "points of curves"
    play = browser.run("[...lober.scene.iterates]")
    assert len(play) > 1
    browser.run("(() => { const s = document.getElementById('iterate'); s.value = 1; s.dispatchEvent(new Event('input')); })()")
    browser.settle()
    assert browser.run("document.getElementById('iterate-text').textContent") == f"n = {play[0]}"
    assert len(browser.run("lober.csv()")) < len(whole)
    browser.run("document.getElementById('measure').click(); lober.click(100, 100); lober.click(200, 100); lober.click(200, 200)")
    text = browser.run("lober.measure.text")
    side = 100 / browser.run("lober.view.scale")
    length, area = re.match(r"3 points, length (\S+), signed area (\S+)", text).groups()
    assert abs(float(length) - 2 * side) < 1e-6 * side and abs(float(area.replace("−", "-")) + side * side / 2) < 1e-6, text


def batches(browser, folder):
    manifest, page = os.path.join(folder, "b.toml"), os.path.join(folder, "b.html")
    with open(manifest, "w") as file:
        file.write('operation = "manifold_tangle"\noptions = { system = "ovp", overlaps = true, before = 2, after = 2 }\n'
                   "grid = { parameters.eps = [0.1, 0.15], parameters.gamma = [0.4, 0.5] }\n")
    lober("batch", "run", manifest, "--quiet")
    lober("batch", "page", os.path.join(folder, "b.results"), "-o", page)
    browser.open(page)
    assert browser.run("document.getElementById('counts').textContent") == "4 done, 0 failed, 0 to do"
    assert browser.run("document.querySelectorAll('#body tr').length") == 4
    browser.run("(() => { const f = document.getElementById('filter'); f.value = 'eps>0.12'; f.dispatchEvent(new Event('input')); })()")
    assert browser.run("document.querySelectorAll('#body tr').length") == 2
    browser.run("(() => { const k = document.getElementById('kind'); k.value = 'jobs'; k.dispatchEvent(new Event('change')); })()")
    colours = browser.run("(() => { const c = document.getElementById('map'), d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;"
                          "const all = new Set(); for (let k = 0; k < d.length; k += 4) all.add(`${d[k]} ${d[k + 1]} ${d[k + 2]}`); return all.size; })()")
    assert colours >= 4, colours
    browser.run("(() => { const f = document.getElementById('filter'); f.value = ''; f.dispatchEvent(new Event('input')); })()")
    heads = browser.run("[...document.querySelectorAll('#heads button')].map((one) => one.textContent)")
    assert heads[:4] == ["job \u25b4", "status", "eps", "gamma"] and "lobe_area12" in heads, heads
    browser.run("document.querySelectorAll('#heads button')[3].click()")
    assert browser.run("[...document.querySelectorAll('#body tr')].map((one) => one.children[3].textContent)") == ["0.5", "0.5", "0.4", "0.4"]
    browser.run("(() => { const k = document.getElementById('kind'); k.value = 'lobes'; k.dispatchEvent(new Event('change')); })()")
    browser.run("document.querySelector('[data-thing=\"2\"]').closest('tr').click()")
    assert browser.run("document.getElementById('of').textContent").startswith("job 2:")
    with open(os.path.join(folder, "b.csv"), "w", encoding="utf-8") as file:
        file.write(lober("batch", "export", os.path.join(folder, "b.results")))
    with open(os.path.join(folder, "b.csv"), encoding="utf-8") as file:
        exported = list(csv.DictReader(file))
    for name in ("crossings", "lobe_area12"):
        shown = browser.run(f"lober.columns.find((one) => one.name === '{name}')?.value(3) ?? 'not seen'")
        assert float(exported[3][name]) == shown, (name, shown)


def batches_of_lists(browser, folder):
    """Lists that an operation spreads are columns of the page, as they are of exports."""
    manifest, page = os.path.join(folder, "e.toml"), os.path.join(folder, "e.html")
    with open(manifest, "w") as file:
        file.write('operation = "escape"\noptions = { system = "capsize", crossings = 2, monte_carlo = 0, tolerance = 1e-3 }\n'
                   "grid = { energy = [0.26, 0.265, 0.27] }\n")
    lober("batch", "run", manifest, "--quiet")
    lober("batch", "page", os.path.join(folder, "e.results"), "-o", page)
    exported = list(csv.DictReader(lober("batch", "export", os.path.join(folder, "e.results")).splitlines()))
    browser.open(page)
    fractions = [name for name in exported[0] if re.fullmatch(r"fraction(_\d+)+(_error)?", name)]
    assert len(fractions) >= 16, exported[0]
    for name in fractions:
        shown = browser.run(f"[0, 1, 2].map((k) => lober.columns.find((one) => one.name === '{name}')?.value(k) ?? null)")
        assert shown == [float(row[name]) if row[name] else None for row in exported], (name, shown)
    drawn = browser.run("document.getElementById('value').selectedOptions[0].textContent")
    assert drawn == "fraction_1_1_2", drawn
    assert browser.run("document.getElementById('y').hidden") # one option differs, so the map has one row
    assert browser.run("document.getElementById('of').textContent") == "fraction_1_1_2 over energy"
    assert browser.run("document.getElementById('range').textContent").count(" (") == 2
    values = sorted(float(row[drawn]) for row in exported)
    browser.run("(() => { const f = document.getElementById('filter');"
                f"f.value = '{drawn}>={values[1]!r}'; f.dispatchEvent(new Event('input')); }})()")
    assert browser.run("document.querySelectorAll('#body tr').length") == 2
    low, _, _ = browser.run("document.getElementById('range').textContent").partition(" ")
    assert abs(float(low) - values[1]) < 1e-5 * values[1], (low, values) # the map has the rows of the table


def cells_of_several_jobs(browser, folder):
    """Where jobs differ in more than both axes, the page says so, and a filter chooses."""
    manifest, page = os.path.join(folder, "c.toml"), os.path.join(folder, "c.html")
    with open(manifest, "w") as file:
        file.write('operation = "manifold_tangle"\noptions = { system = "standard" }\n'
                   "grid = { parameters.K = [1.2, 1.5], tolerance = [1e-3, 1e-2], before = [1, 2] }\n")
    lober("batch", "run", manifest, "--quiet")
    lober("batch", "page", os.path.join(folder, "c.results"), "-o", page)
    browser.open(page)
    assert "4 more jobs lie on the same cells" in browser.run("document.getElementById('range').textContent")
    left = browser.run("['K', 'tolerance', 'before'].find((name) => !['x', 'y'].some((id) => "
                       "document.getElementById(id).selectedOptions[0].textContent === name))")
    value = {"K": "1.2", "tolerance": "0.01", "before": "1"}[left]
    browser.run("(() => { const f = document.getElementById('filter');"
                f"f.value = '{left}={value}'; f.dispatchEvent(new Event('input')); }})()")
    assert "more jobs" not in browser.run("document.getElementById('range').textContent")


if __name__ == "__main__":
    sys.exit(run([points_are_exact, zooms_into_a_pip, agrees_with_pictures_of_the_program, lobes_are_read, keys_and_wheel,
                  exports_measure_and_iterates, batches, batches_of_lists,
                  cells_of_several_jobs]))
