"""What tests of pages in a browser have in common."""

import base64
import os
import struct
import subprocess
import sys
import tempfile
import time

from chromium import Chromium
from firefox import Firefox

PROGRAM = sys.argv[1]
EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../examples")
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
    """Runs checks in the browser that the last argument names, chromium or firefox; the exit status, 77 where it is not there."""
    kind = {"chromium": Chromium, "firefox": Firefox}[sys.argv[-1]]
    path = kind.find()
    if path is None:
        # In the form that scripts/run-tests.sh looks for.
        print(f"pages in {sys.argv[-1]}: Skipped\nno {sys.argv[-1]} is installed, which Debian's package {kind.PACKAGE} has")
        return 77
    with tempfile.TemporaryDirectory() as folder, kind(path) as browser:
        for check in checks:
            begin = time.monotonic()
            check(browser, folder)
            clean(browser)
            print(f"{check.__name__} passed after {time.monotonic() - begin:.1f} s", flush=True)
    return 0
