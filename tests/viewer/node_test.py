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
const source = require("fs").readFileSync(process.argv[1], "utf8");
import("data:text/javascript," + encodeURIComponent(source)).then(({ decodeSeries }) => {
  const { bytes, count } = JSON.parse(require("fs").readFileSync(0, "utf8"));
  const values = decodeSeries(new Uint8Array(Buffer.from(bytes, "base64")), count, new Float64Array(count));
  process.stdout.write(Buffer.from(values.buffer).toString("base64"));
});
"""


def main():
    node = shutil.which("node") or shutil.which("nodejs")
    if node is None:
        print("skipped: no node is installed (apt-get install nodejs)")
        return 77
    chance = random.Random(5)
    points = [(math.sin(k / 50) + chance.gauss(0, 1e-9), chance.choice([-0.0, 1e-320, k, -k / 3])) for k in range(3000)]
    with tempfile.TemporaryDirectory() as folder:
        source, page = os.path.join(folder, "c.csv"), os.path.join(folder, "c.html")
        with open(source, "w") as file:
            file.writelines(f"{x!r},{y!r}\n" for x, y in points)
        subprocess.run([sys.argv[1], "view", source, "-o", page], check=True, capture_output=True)
        with open(page, encoding="utf-8") as file:
            text = file.read()
    scene = json.loads(re.search(r'id="scene">(.*?)</script>', text, re.S)[1])
    for axis in (0, 1):
        data = b64decode(re.search(rf'id="s{axis}">(.*?)</script>', text)[1])
        data = zlib.decompress(data) if scene["deflated"] else data
        ask = json.dumps({"bytes": b64encode(data).decode(), "count": len(points)})
        module = os.path.join(HERE, "../../viewer/page/series.js")
        answer = subprocess.run([node, "-e", SCRIPT, module], input=ask, text=True, check=True, capture_output=True).stdout
        expected = struct.pack(f"<{len(points)}d", *(point[axis] for point in points))
        assert b64decode(answer) == expected, f"axis {axis}: not every bit came back"
    print(f"{len(points)} points came back bit for bit")
    return 0


if __name__ == "__main__":
    sys.exit(main())
