#!/usr/bin/env python3
"""Pages of many points, of many lobes, of none, of any size, of hostile names, and without a mouse, in a browser:
limits_test.py LOBER BROWSER. Ends with 77, and says why, where that browser is not there."""

import math
import os
import sys

from pages import EXAMPLES, OVP, clean, lober, run, write_npy

# The median of the milliseconds from frame to frame, of 40 movements.
FRAMES = """(async () => { const times = []; let last = performance.now();
    for (let k = 0; k < 40; ++k) { lober.moved(() => %s);
    await new Promise((done) => requestAnimationFrame(() => setTimeout(done, 0)));
    const now = performance.now(); times.push(now - last); last = now; }
    return times.sort((a, b) => a - b)[20]; })()"""


def millions_of_points(browser, folder):
    sources = []
    for number in (1, 2):
        sources.append(os.path.join(folder, f"m{number}.npy"))
        write_npy(sources[-1], [(math.cos(6e-6 * number * k) * (1 + 0.3 * math.sin(4e-5 * k)),
                                math.sin(6e-6 * number * k) + (k * 2654435761 % 1024 - 512) * 1e-16)
                                for k in range(1_000_000)])
    page = os.path.join(folder, "m.html")
    lober("view", *sources, "-o", page)
    size = os.path.getsize(page)
    assert size <= 12_000_000, size
    seconds = browser.open(page)
    frames = browser.run(FRAMES % "lober.view.zoom(k % 2 ? 1.2 : 0.9, 400, 300)")
    print(f"2x10^6 points: {size / 1e6:.1f} MB, ready after {seconds:.2f} s, {1000 / frames:.0f} frames a second")
    assert seconds < 10 and frames < 200, "an order of magnitude off, on whatever machine"


def nothing_and_hostile_names(browser, folder):
    source, page = os.path.join(folder, "h.dat"), os.path.join(folder, "h.html")
    bad = ["</script><script>window.hit=1</script>", "<img src=x onerror=window.hit=1>", "' onload='window.hit=1",
           "a<!--", "{{data}}", "x" * 10000, "\u202e\u0007 & &amp;"]
    with open(source, "w", encoding="utf-8") as file:
        for title in bad:
            file.write(f'ZONE T="{title}"\n0 0\n1 1\n2 0\n')
    lober("view", source, "-o", page)
    browser.open(page)
    names = browser.run("lober.scene.layers.map((layer) => layer.name)")
    assert names == bad, [a for a, b in zip(names, bad) if a != b]
    assert browser.run("[...document.querySelectorAll('#layers .name')].map((one) => one.textContent)") == bad
    browser.run("lober.hover(lober.view.px(1), lober.view.py(1))")
    status = browser.run("document.getElementById('status').textContent")
    assert len(status) < 400 and "\u202e" not in status and status.endswith("(1, 1)"), status
    notes = browser.run("document.getElementById('notes').textContent")
    assert "\u202e" not in notes, notes
    assert browser.run("window.hit === undefined && document.querySelectorAll('img').length === 0")
    for link in ("#%,%E0%A4%A,1", "#,,,", "#NaN,1,1", "#1e308,-1e308,1e-300,99.x", "#1%2C0.5%2C30", "#</script><img src=x>"):
        browser.open(page, link)
        browser.settle()
        assert browser.run("document.getElementById('loading').hidden && lober.view.box().every(Number.isFinite)"), link
        clean(browser)
    browser.open(page, "#1%2C0.5%2C30")
    assert browser.run("lober.view.x === 1 && lober.view.y === 0.5")
    one = os.path.join(folder, "one.dat")
    with open(one, "w") as file:
        file.write("3 4\n")
    lober("view", one, "-o", page)
    browser.open(page)
    assert browser.run("lober.view.box().every(Number.isFinite)")


def policy_holds(browser, folder):
    """Texts do not become scripts, nothing is asked of a network, and the browser says so where the tests look."""
    page = os.path.join(folder, "p.html")
    lober("view", os.path.join(EXAMPLES, "manifolds.dat"), "-o", page)
    attempts = {
        "a timer": "setTimeout('window.hit = 1', 0)",
        "a script": "document.body.append(Object.assign(document.createElement('script'), { textContent: 'window.hit = 1' }))",
        "a handler": "(document.body.setAttribute('onclick', 'window.hit = 1'), document.body.click())",
        "a request": "fetch('http://127.0.0.1:8999/').then(() => { window.hit = 1; }, () => 0)",
        "an image": "document.body.append(Object.assign(new Image(), { src: 'http://127.0.0.1:8999/' }))",
    }
    for name, attempt in attempts.items():
        browser.open(page)
        try:
            browser.run(f"void {attempt}")
        except RuntimeError as error:
            assert "Content Security Policy" in str(error) or "EvalError" in str(error), error
            continue
        browser.run("new Promise((done) => setTimeout(done, 100))")
        assert browser.run("window.hit === undefined"), name
        assert any("Content" in one and "Policy" in one for one in browser.complaints), (name, browser.complaints)
        browser.forget()
    bare = os.path.join(folder, "bare.html")
    with open(bare, "w") as file:
        file.write('<!DOCTYPE html><html data-ready="yes"><img src="http://127.0.0.1:8999/"></html>')
    browser.open(bare)
    browser.run("new Promise((done) => setTimeout(done, 100))")
    assert "http://127.0.0.1:8999/" in browser.requests, browser.requests
    browser.run("console.error('written')")
    assert any("written" in one for one in browser.complaints), browser.complaints
    browser.forget()


def ten_thousand_lobes(browser, folder):
    sources, page = [os.path.join(folder, f"l{k}.npy") for k in (1, 2)], os.path.join(folder, "l.html")
    for source, bend in zip(sources, (0.02, 0)):
        turn = [2 * math.pi * k / 60_000 for k in range(60_000)]
        write_npy(source, [((1 + bend * math.sin(5000 * a)) * math.cos(a), (1 + bend * math.sin(5000 * a)) * math.sin(a)) for a in turn])
    lober("overlay", *sources, "--no-discretisation", "--html", page)
    seconds = browser.open(page)
    assert browser.run("lober.scene.layers.filter((one) => one.kind === 'areas').reduce((sum, one) => sum + one.n, 0)") > 10_000
    frames = browser.run(FRAMES % "lober.view.pan(k % 2 ? 7 : -5, 3)")
    print(f"10^4 lobes: ready after {seconds:.2f} s, {1000 / frames:.0f} frames a second")
    assert seconds < 10 and frames < 200, "an order of magnitude off, on whatever machine"


def any_size(browser, folder):
    """Curves as large and as small as doubles, far away, and of one point, are seen."""
    page = os.path.join(folder, "size.html")
    circle = [(math.cos(k / 50), math.sin(k / 50)) for k in range(320)]
    curves = {
        "huger": [(1e306 * x, 1e306 * y) for x, y in circle],
        "huge": [(1e300 * x, 1e300 * y) for x, y in circle], "tiny": [(1e-300 * x, 1e-300 * y) for x, y in circle],
        "denormal": [(1e-315 * x, 1e-315 * y) for x, y in circle], "flat": [(1e300 * x, 1e-300 * y) for x, y in circle],
        "far": [(1e15 + 100 * x, 100 * y - 1e15) for x, y in circle], "one point": [(3, 4)], "equal points": [(3, 4)] * 50,
    }
    for name, points in curves.items():
        source = os.path.join(folder, "size.npy")
        write_npy(source, points)
        lober("view", source, "-o", page)
        browser.open(page)
        browser.settle()
        red = browser.run("(() => { const c = lober.canvas, d = lober.context.getImageData(0, 0, c.width, c.height).data;"
                          "let n = 0; for (let k = 0; k < d.length; k += 4) n += d[k] > d[k + 2] + 60; return n; })()")
        assert red >= (2 if len(set(points)) == 1 or name == "denormal" else 300), (name, red)
        browser.run("lober.view.zoom(1e9, lober.view.px(lober.scene.layers[0].curves[0].curve.x[9]), 300)")
        labels = browser.run("(async () => new DOMParser().parseFromString(lober.svg(), 'text/xml'))().then((svg) =>"
                             "[...svg.querySelectorAll('text')].map((one) => one.textContent))")
        assert labels and all(len(label) < 30 for label in labels), (name, labels)
        clean(browser)


def largest_doubles(browser, folder):
    """A curve wider than the largest double reaches beyond the view, which has axes all the same, and can be moved."""
    source, page = os.path.join(folder, "largest.npy"), os.path.join(folder, "largest.html")
    write_npy(source, [(-1.7e308, -1.7e308), (1.7e308, -1.7e308), (1.7e308, 1.7e308), (-1.7e308, 1.6e308), (0, 0)])
    lober("view", source, "-o", page)
    browser.open(page)
    for change in ("1", "lober.view.zoom(1e-9)", "lober.view.zoom(1e9, 3, 3)", "lober.view.pan(1e6, 1e6)", "lober.view.reset()"):
        browser.run(f"lober.moved(() => {change})")
        browser.settle()
        assert browser.run("lober.view.box().every(Number.isFinite)"), change
        labels = browser.run("(lober.svg().match(/<text/g) ?? []).length")
        assert labels >= 2 and "NaN" not in browser.run("lober.svg()"), (change, labels)


def areas_of_any_size(browser, folder):
    """A square is found by what is within it, and not beside it."""
    page = os.path.join(folder, "square.html")
    for size in (1e140, 1.0, 1e-140):
        sources = []
        for number, west in enumerate((0, 1)):
            sources.append(os.path.join(folder, f"square{number}.npy"))
            write_npy(sources[-1], [(size * (west + x), size * y) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))])
        lober("overlay", *sources, "--no-discretisation", "--html", page)
        browser.open(page)
        for x, name in ((0.5, "C1 \\ C2 0"), (2.5, "C2 \\ C1 0"), (5, None)):
            found = browser.run(f"(() => {{ const found = lober.thingAt(lober.view.px({x * size!r}), lober.view.py({0.5 * size!r}));"
                                "return found && `${found.layer.name} ${found.index}`; })()")
            assert found == name, (size, x, found)


def on_a_phone(browser, folder):
    """All is there at 360 pixels, and two fingers zoom about the point between them."""
    page = os.path.join(folder, "phone.html")
    lober(*OVP, "--html", page)
    browser.size(360, 640, mobile=True)
    try:
        browser.open(page)
        browser.settle()
        assert browser.run("document.documentElement.scrollWidth <= 360"), browser.run("document.documentElement.scrollWidth")
        inside = browser.run("[...document.querySelectorAll('button')].filter((one) => one.offsetParent).every((one) =>"
                             "one.closest('#panel') || one.getBoundingClientRect().right <= 360)")
        assert inside and browser.run("lober.canvas.clientHeight > 150")
        left, top = browser.run("(({ left, top }) => [left, top])(lober.canvas.getBoundingClientRect())")
        kept = browser.run("lober.view.at(180, 120)")
        browser.pinch(left + 180, top + 120, 30, 90)
        assert abs(browser.run("lober.view.depth") - 3) < 0.2, browser.run("lober.view.depth")
        size = 1 / browser.run("lober.view.scale")
        assert all(abs(a - b) < 4 * size for a, b in zip(kept, browser.run("lober.view.at(180, 120)")))
        browser.pinch(left + 180, top + 120, 90, 30)
        assert abs(browser.run("lober.view.depth") - 1) < 0.1, browser.run("lober.view.depth")
    finally:
        browser.size(1000, 800)


def keyboard_alone(browser, folder):
    page = os.path.join(folder, "ovp.html")
    lober(*OVP, "--html", page)
    browser.open(page)
    focused = "document.activeElement.textContent"
    seen = set()
    for _ in range(60):
        browser.key("Tab", settle=False)
        seen.add(browser.run("document.activeElement.id || document.activeElement.textContent"))
    assert {"zoom-in", "picture", "filter", "rows"} <= seen and any("L12(1)" in one for one in seen), seen
    browser.run("document.querySelector('[data-thing]').focus()")
    first = browser.run(focused)
    for key in ("End", "ArrowDown", "ArrowUp"):  # the first does nothing
        browser.key(key)
        assert browser.run(focused + " !== ''"), key
    assert browser.run(focused) == first
    browser.key("Enter")
    assert browser.run(focused) == first and browser.run("lober.view.depth") > 1.5
    assert browser.run("document.querySelector('tr.chosen').textContent").startswith(first)
    browser.run("document.querySelectorAll('#heads button')[1].focus()")
    browser.run("document.activeElement.click()")
    assert browser.run("document.activeElement.closest('th').ariaSort") == "descending"


if __name__ == "__main__":
    sys.exit(run([millions_of_points, ten_thousand_lobes, nothing_and_hostile_names, policy_holds, any_size, largest_doubles,
                  areas_of_any_size, on_a_phone, keyboard_alone]))
