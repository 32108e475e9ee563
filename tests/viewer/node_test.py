#!/usr/bin/env python3
"""The script that reads series of numbers, in node, without a browser: node_test.py LOBER. Ends with 77 without node."""

import json
import math
import os
import random
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib
from base64 import b64decode, b64encode

HERE = os.path.dirname(os.path.abspath(__file__))
SCRIPT = """
import { readFileSync } from "fs";
import { decodeSeries } from "./series.js";
const { bytes, count } = JSON.parse(readFileSync(0, "utf8"));
const axes = [new Float64Array(count), new Float64Array(count)];
decodeSeries(new Uint8Array(Buffer.from(bytes, "base64")), count, axes);
process.stdout.write(axes.map((values) => Buffer.from(values.buffer).toString("base64")).join(" "));
"""


def curves():
    """Names and points: what is smooth, breaks, lies on grids, is noise, or has neither size nor end."""
    chance = random.Random(5)
    any_double = lambda: struct.unpack("<d", chance.randbytes(8))[0]
    finite = lambda: next(value for value in iter(any_double, None) if math.isfinite(value))
    yield "smooth", [(math.cos(1e-3 * k), math.sin(1e-3 * k)) for k in range(3000)]
    steps = [0.0]
    for _ in range(500):
        step = chance.uniform(1e-4, 2e-4)
        steps += [steps[-1] + step * (k + 1) for k in range(chance.randrange(4, 9))]
    yield "pieces", [(math.cos(s) + s, math.sin(3 * s)) for s in steps]
    yield "noise", [(math.sin(k / 50) + chance.gauss(0, 1e-9), chance.choice([-0.0, 1e-320, k, -k / 3])) for k in range(3000)]
    yield "decimals", [(round(math.sin(k / 50), 3), round(52 + k / 977, 6)) for k in range(3000)]
    yield "powers", [(k * 0.25, 1e15 + k * k) for k in range(3000)]
    yield "huge and small", [(1e300 * math.cos(k), 1e-300 * k) for k in range(3000)]
    yield "any bits", [(finite(), finite()) for _ in range(3000)]
    yield "one point", [(0.1, -0.0)]


def came_back(node, folder, name, points):
    source, page = os.path.join(folder, "c.csv"), os.path.join(folder, "c.html")
    with open(source, "w") as file:
        file.writelines(f"{x!r},{y!r}\n" for x, y in points)
    subprocess.run([sys.argv[1], "view", source, "-o", page], check=True, capture_output=True)
    with open(page, encoding="utf-8") as file:
        text = file.read()
    scene = json.loads(re.search(r'id="scene">(.*?)</script>', text, re.S)[1])
    data = b64decode(re.search(r'id="s0">(.*?)</script>', text)[1])
    packed, written = len(data), len(re.search(r'id="s0">(.*?)</script>', text)[1])
    data = zlib.decompress(data) if scene["deflated"] else data
    ask = json.dumps({"bytes": b64encode(data).decode(), "count": len(points)})
    answer = subprocess.run([node, os.path.join(folder, "read.js")], input=ask, text=True, check=True, capture_output=True)
    for axis, values in enumerate(answer.stdout.split()):
        expected = struct.pack(f"<{len(points)}d", *(point[axis] for point in points))
        assert b64decode(values) == expected, f"{name}, axis {axis}: not every bit came back"
    print(f"{name}: {len(points)} points came back bit for bit, {written / len(points):.2f} bytes a point as "
          f"written, {packed / len(points):.2f} before base64")


def main():
    node = shutil.which("node") or shutil.which("nodejs")
    if node is None:
        print("pages in node: Skipped\nno node is installed, which Debian's package nodejs has")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        for module in ("series.js", "predictor.js"):
            shutil.copy(os.path.join(HERE, "../../viewer/page", module), folder)
        for name, content in (("package.json", '{"type": "module"}'), ("read.js", SCRIPT)):
            with open(os.path.join(folder, name), "w") as file:
                file.write(content)
        for name, points in curves():
            came_back(node, folder, name, points)
    return 0


if __name__ == "__main__":
    sys.exit(main())
