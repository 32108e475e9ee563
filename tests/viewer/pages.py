"""What tests of pages in a browser have in common."""

import base64
import os
import struct
import subprocess
import sys
import tempfile

from browser import Browser, find_browser

PROGRAM = sys.argv[1]
OVP = ["tangle", "ovp", "--param", "gamma=0.5", "--param", "eps=0.1"]


def lober(*arguments):
    return subprocess.run([PROGRAM, *arguments], check=True, capture_output=True, text=True).stdout


def write_npy(path, points):
    head = "{'descr': '<f8', 'fortran_order': False, 'shape': (%d, 2), }" % len(points)
    head += " " * (-(len(head) + 11) % 64) + "\n"
    with open(path, "wb") as file:
        file.write(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head.encode())
        file.write(struct.pack(f"<{2 * len(points)}d", *(value for point in points for value in point)))


def curve_of(browser, layer, curve=0):
    """The points of a curve as the page has them, bit for bit."""
    text = browser.run(
        f"(() => {{ const one = lober.scene.layers[{layer}].curves[{curve}]; const all = new Float64Array(2 * one.n);"
        "for (let k = 0; k < one.n; ++k) { all[2 * k] = one.curve.x[k]; all[2 * k + 1] = one.curve.y[k]; }"
        "let text = ''; for (const byte of new Uint8Array(all.buffer)) text += String.fromCharCode(byte); return btoa(text); })()")
    values = struct.unpack(f"<{len(base64.b64decode(text)) // 8}d", base64.b64decode(text))
    return list(zip(values[::2], values[1::2]))


def clean(browser):
    assert browser.complaints == [], browser.complaints
    assert all(url.startswith(("file:", "about:", "blob:", "data:")) for url in browser.requests), browser.requests


def run(checks):
    """Runs checks in one browser; the exit status, 77 where there is none."""
    path = find_browser()
    if path is None:
        print("skipped: no chromium is installed (apt-get install chromium)")
        return 77
    with tempfile.TemporaryDirectory() as folder, Browser(path) as browser:
        for check in checks:
            check(browser, folder)
            clean(browser)
            print(check.__name__, "passed", flush=True)
    return 0
