#!/usr/bin/env python3
"""The commands that write pages, without a browser: command_test.py LOBER LIBRARY."""

import hashlib
import json
import os
import shutil
import sqlite3
import subprocess
import sys
import tempfile

PROGRAM = os.path.abspath(sys.argv[1])
LIBRARY = os.path.abspath(sys.argv[2])  # which leaves a file named "loaded" where it is loaded
EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../examples")


def run(*arguments, status=0, says=""):
    answer = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True)
    assert answer.returncode == status, (arguments, answer.returncode, answer.stderr)
    assert says in answer.stderr, (arguments, answer.stderr)
    return answer.stdout


def content(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def results_are_repeated():
    """The page of a result is the one that its own run writes."""
    with open("table.csv", "w") as file:
        file.write("id,lon,lat\n")
        for name, west in (("one", 350.5), ("two", 355.25)):
            corners = ((0, 0), (10, 0), (10, 5), (0, 5))
            file.writelines(f"{name},{(west + x) % 360},{52 + y}\n" for x, y in corners)
    shutil.copy("manifolds.dat", "odd: name#1.dat")
    runs = {
        "columns": ["table.csv:lon,lat,by=id#one", "table.csv:lon,lat,by=id#two", "--periodic=x=360"],
        "numbers": ["table.csv:2,3,by=1#0", "table.csv:2,3,by=1#1", "--periodic=x=360", "--periodic=y=180"],
        "names": ["odd: name#1.dat#0", "odd: name#1.dat#1"],
        "bip_near": ["manifolds.dat#0", "manifolds.dat#1", "--bip=1,1.5"],
        "manifolds": ["--manifolds", "manifolds.dat", "--iterates=2"],
        "manifolds_of_files": ["--manifolds", "manifolds.dat#0", "manifolds.dat#1", "--bip=-1.2,0.7"],
        "curve-transport": ["manifolds.dat#0", "manifolds.dat#1", "--iterates=3"],
        "regions": ["resonance.dat", "resonance_image.dat", "--rule=evenodd"],
        "regions_of_one": ["resonance.dat"],
        "overlay": ["resonance.dat", "resonance_image.dat"],
        "rule": ["resonance.dat", "resonance_image.dat", "--rule=evenodd"],
        "classes": ["resonance.dat", "resonance_image.dat", "--classes", "--no-discretisation"],
        "tangle": ["manifolds.dat#0", "manifolds.dat#1", "--bip=2", "--overlaps"],
        "system": ["ovp", "--param=gamma=0.5", "--param=eps=0.1", "--no-smooth"],
        "transport": ["standard", "--iterates=1"],
        "escape": ["capsize", "--energy=0.253", "--crossings=1"],
        "grow": ["henon", "--stable", "--length=3"],
    }
    commands = {"rule": "overlay", "classes": "overlay", "system": "tangle", "columns": "overlay", "numbers": "overlay",
                "names": "tangle", "bip_near": "tangle", "manifolds": "transport", "manifolds_of_files": "transport",
                "regions_of_one": "regions"}
    for name, arguments in runs.items():
        run(commands.get(name, name), *arguments, "--html", "a.html", "--json", "a.json")
        run("view", "a.json", "-o", "b.html")
        assert content("a.html") == content("b.html"), name


def what_cannot_be_shown_is_refused():
    run("interior", "resonance.dat", "resonance_image.dat", "--json", "i.json")
    run("view", "i.json", "-o", "c.html", status=1, says="there are pages of overlay")
    run("overlay", "resonance.dat", "resonance_image.dat", "--json", "o.json")
    with open("resonance.dat", "a") as file:
        file.write("# changed\n")
    run("view", "o.json", "-o", "c.html", status=1, says="is not as it was when o.json was computed")
    run("regions", "resonance_image.dat", "--json", "r.json")
    with open("resonance_image.dat", "a") as file:
        file.write("# changed\n")
    run("view", "r.json", "-o", "c.html", status=1, says="is not as it was when r.json was computed")
    run("view", "nothing.dat", "-o", "c.html", status=1, says="No such file")
    run("view", "manifolds.dat", "-o", "c.svg", status=2, says=".html")
    run("view", "manifolds.dat", "-o", "manifolds.dat", status=2)
    run("view", "manifolds.dat", status=2, says="--output is missing")
    run("transport", "ovp", "--sweep", "eps=0.1:0.2:0.1", "--html", "c.html", status=2, says="cannot be given together")
    shutil.copy("manifolds.dat", "--json=stolen.json")  # a file whose name could be taken for an option
    run("regions", "./--json=stolen.json#0", "--json", "dash.json")
    result = json.loads(content("dash.json"))
    result["inputs"] = ["--json=stolen.json#0"]
    with open("dash.json", "w") as file:
        file.write(json.dumps(result))
    run("view", "dash.json", "-o", "dash.html")
    assert not os.path.exists("stolen.json")
    with open("bad.json", "w") as file:
        file.write('{"program": {}, "command": "overlay", "inputs": 3, "options": {}}')
    run("view", "bad.json", "-o", "c.html", status=1, says="cannot be read as a result of lober")
    assert not os.path.exists("c.html")


def with_changes(source, target, **changes):
    result = json.loads(content(source))
    for key, value in changes.items():
        at = result
        *path, last = key.split("__")
        for one in path:
            at = at[one]
        at[last] = value
    with open(target, "w") as file:
        file.write(json.dumps(result))


def loaded():
    """Whether the library has been loaded since the last call."""
    found = os.path.exists("loaded")
    if found:
        os.remove("loaded")
    return found


def results_of_others_load_no_library():
    shutil.copy(LIBRARY, "loud.so")
    map_of = ["--from=1.520408798,1.155821457", "--unstable", "--length=1"]
    run("grow", "./loud.so", *map_of, "--json", "own.json", "--html", "own.html")
    assert loaded()
    run("view", "own.json", "-o", "again.html", status=2, says="give --library FILE")
    for name in ("./loud.so", "loud.so", os.path.abspath("loud.so"), "--json=stolen.json"):
        with_changes("own.json", "bad.json", system__name=name)
        run("view", "bad.json", "-o", "again.html", status=2, says="give --library FILE")
    assert not loaded()
    with open("loud.so", "rb") as file:
        digest = hashlib.sha256(file.read()).hexdigest()
    run("tangle", "manifolds.dat#0", "manifolds.dat#1", "--json", "t.json")
    for spec in ("loud.so", "./loud.so"):  # in place of a curve, which tangle and transport take for a system
        with_changes("t.json", "bad.json", inputs=[{"file": "loud.so", "spec": spec, "sha256": digest}])
        run("view", "bad.json", "-o", "again.html", status=1, says="where a curve is expected")
    with_changes("own.json", "bad.json", system__name="henon", options__side="json=stolen.json")
    subprocess.run([PROGRAM, "view", "bad.json", "-o", "no.html"], capture_output=True)
    assert not os.path.exists("stolen.json") and not os.path.exists("again.html") and not loaded()
    made = json.loads(content("own.json"))["system"]["library"]
    assert made == {"file": "./loud.so", "sha256": digest}, made
    with_changes("own.json", "bad.json", system__library={"file": "./loud.so", "sha256": "0" * 64})
    run("view", "bad.json", "-o", "no.html", "--library", "./loud.so", status=1, says="is not the one with which bad.json")
    loaded()
    run("grow", "./loud.so", *map_of, "-o", "own.geojson")
    assert "sha256 " + digest in content("own.geojson")
    run("view", "own.json", "-o", "again.html", "--library", "./loud.so")
    assert loaded() and content("again.html") == content("own.html")
    with_changes("own.json", "bad.json", system__name="henon")
    run("view", "bad.json", "-o", "no.html", "--library", "./loud.so", status=2, says="is a result of")
    run("view", "manifolds.dat", "-o", "no.html", "--library", "./loud.so", status=2, says="curves need no system")
    run("view", "own.json", "-o", "no.html", "--library", "loud", status=2, says="does not end in .so")
    run("view", "own.json", "-o", "loud.so", "--library", "loud.so", status=2)
    loaded()


def checksum(data):
    """As in the stores of batches."""
    total = 0x9E3779B97F4A7C15
    words = [len(data)] + [int.from_bytes(data[k:k + 8], "little") for k in range(0, len(data), 8)]
    for word in words:
        total = (total ^ word) * 0xD6E8FEB86659FD93 % 2**64
        total ^= total >> 32
    return total - 2**64 if total >= 2**63 else total


def stores_of_others_load_no_library():
    shutil.copy(LIBRARY, "loud1.so")
    with open("b.toml", "w") as file:
        file.write('operation = "manifold_tangle"\noptions = { system = "standard" }\n'
                   "grid = { parameters.K = [1.2, 1.3] }\n")
    run("batch", "run", "b.toml", "--quiet")
    commands = [["batch", "export", "b.results", "-o", "b.csv"], ["batch", "page", "b.results", "-o", "b.html"],
                ["batch", "picture", "b.results", "--data", "b.json", "--operation", "manifold_tangle"],
                ["batch", "status", "b.results"], ["batch", "merge", "c.results", "b.results"],
                ["batch", "run", "b.toml", "--quiet"]]
    for command in commands:
        run(*command)
    os.remove("c.results")
    store = sqlite3.connect("b.results")
    (body, total), = store.execute("SELECT body, sum FROM plan")
    assert total == checksum(body), "the test knows the checksum"
    forged = body.replace(b"standard", b"loud1.so")
    assert forged != body
    store.execute("UPDATE plan SET body = ?, sum = ?", (forged, checksum(forged)))
    store.execute("UPDATE groups SET options = replace(options, 'standard', 'loud1.so')")
    store.commit()
    store.close()
    for command in commands:
        answer = subprocess.run([PROGRAM, *command], capture_output=True, text=True)
        assert answer.returncode in (0, 1, 2), (command, answer.stderr)  # it ends by itself
        assert not loaded(), command


def pages_have_the_same_bytes_for_any_threads():
    for threads in (1, 3):
        run("tangle", "manifolds.dat", "--html", f"t{threads}.html", f"--threads={threads}")
    assert content("t1.html") == content("t3.html")


def main():
    with tempfile.TemporaryDirectory() as folder:
        for name in os.listdir(EXAMPLES):
            if name.endswith(".dat"):
                shutil.copy(os.path.join(EXAMPLES, name), folder)
        os.chdir(folder)
        for check in (pages_have_the_same_bytes_for_any_threads, results_are_repeated, results_of_others_load_no_library,
                      stores_of_others_load_no_library, what_cannot_be_shown_is_refused):
            check()
            print(check.__name__, "passed")
        os.chdir("/")
    return 0


if __name__ == "__main__":
    sys.exit(main())
