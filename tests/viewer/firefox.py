"""Firefox, driven over a socket by Marionette, the protocol that it has of its own."""

import json
import os
import shutil
import socket
import subprocess
import tempfile
import time

from browser import Browser

KEYS = {"Tab": "\ue004", "Enter": "\ue007", "Escape": "\ue00c", "End": "\ue010", "Home": "\ue011", "ArrowLeft": "\ue012",
        "ArrowUp": "\ue013", "ArrowRight": "\ue014", "ArrowDown": "\ue015"}
PREFERENCES = {"marionette.port": 0, "app.update.enabled": False, "browser.aboutwelcome.enabled": False,
               "datareporting.policy.dataSubmissionEnabled": False, "toolkit.telemetry.reportingpolicy.firstRun": False}

# Notes requests of the page, and takes the browser off the network.
WATCH = """
  Services.io.offline = true;
  window.lober_requests = [];
  const note = (channel) => {
    channel.QueryInterface(Ci.nsIChannel);
    if (channel.loadInfo?.browsingContext) window.lober_requests.push(channel.URI.spec);
  };
  Services.obs.addObserver(note, "http-on-opening-request");"""
# Errors and warnings of pages, which the browser has.
ERRORS = """
  const found = Services.console.getMessageArray().filter((one) => one instanceof Ci.nsIScriptError &&
    /^(file|blob|data|about):/.test(one.sourceName)).map((one) => one.errorMessage);
  Services.console.reset();
  return found;"""
# Those that scripts write, which the process of the page has.
WRITTEN = """
  const storage = Cc["@mozilla.org/consoleAPI-storage;1"].getService(Ci.nsIConsoleAPIStorage);
  const found = storage.getEvents().filter((one) => /^(error|warn|assert)/.test(one.level)).map((one) => one.arguments.join(" "));
  storage.clearEvents();
  return found;"""
SIZE = """
  const browser = gBrowser.selectedBrowser;
  for (const [name, value] of [["width", arguments[0]], ["height", arguments[1]]]) {
    for (const limit of ["", "min-", "max-"]) browser.style.setProperty(limit + name, `${value}px`);
  }"""


class Firefox(Browser):
    PACKAGE = "firefox-esr"
    NAMES = ["firefox-esr", "firefox"]

    def __init__(self, path, width=1000, height=800):
        self.profile = tempfile.mkdtemp()
        with open(os.path.join(self.profile, "user.js"), "w") as file:
            file.writelines(f"user_pref({json.dumps(name)}, {json.dumps(value)});\n" for name, value in PREFERENCES.items())
        self.process = subprocess.Popen(
            [path, "--headless", "--marionette", "--remote-allow-system-access", "--no-remote", "--profile", self.profile],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env={**os.environ, "HOME": self.profile})
        self.known = []
        self.buffer = b""
        self.number = 0
        self.socket = socket.create_connection(("127.0.0.1", self.port()))
        self.read()  # its greeting
        self.call("WebDriver:NewSession")
        self.call("WebDriver:SetTimeouts", script=60_000, pageLoad=60_000)
        self.inside(WATCH)
        self.size(width, height)

    def port(self):
        file = os.path.join(self.profile, "MarionetteActivePort")
        for _ in range(600):
            if os.path.exists(file) and os.path.getsize(file) > 0:
                with open(file) as text:
                    return int(text.read())
            time.sleep(0.1)
        self.process.kill()
        raise RuntimeError("the browser does not answer")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.call("Marionette:Quit", flags=["eForceQuit"])
            self.process.wait(10)
        except (OSError, RuntimeError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
        self.socket.close()
        shutil.rmtree(self.profile, ignore_errors=True)

    def read(self):
        def until(is_enough):
            while not is_enough():
                piece = self.socket.recv(1 << 20)
                if not piece:
                    raise RuntimeError("the browser ended")
                self.buffer += piece

        until(lambda: b":" in self.buffer)
        size, self.buffer = self.buffer.split(b":", 1)
        until(lambda: len(self.buffer) >= int(size))
        message, self.buffer = self.buffer[:int(size)], self.buffer[int(size):]
        return json.loads(message)

    def call(self, method, **arguments):
        self.number += 1
        message = json.dumps([0, self.number, method, arguments]).encode()
        self.socket.sendall(b"%d:%s" % (len(message), message))
        _, _, error, result = self.read()
        if error:
            raise RuntimeError(f"{method}: {error['error']}: {error['message'][:1000]}")
        return result

    def inside(self, script, *arguments):
        """Runs a script in the browser itself, not in the page."""
        self.call("Marionette:SetContext", value="chrome")
        try:
            return self.call("WebDriver:ExecuteScript", script=script, args=list(arguments), newSandbox=False)["value"]
        finally:
            self.call("Marionette:SetContext", value="content")

    @property
    def complaints(self):
        self.known += self.inside(ERRORS)
        self.known += self.call("WebDriver:ExecuteScript", script=WRITTEN, args=[], sandbox="system")["value"]
        return self.known

    @property
    def requests(self):
        return self.inside("return window.lober_requests")

    def forget(self):
        self.inside("Services.console.reset(); window.lober_requests = []")
        self.complaints.clear()

    def size(self, width, height, mobile=False):
        self.inside(SIZE, width, height)

    def dark(self, on):
        self.inside("gBrowser.selectedBrowser.browsingContext.prefersColorSchemeOverride = arguments[0]", "dark" if on else "light")

    def navigate(self, address):
        self.call("WebDriver:Navigate", url="about:blank")
        self.call("WebDriver:Navigate", url=address)

    def run(self, script):
        """The value of an expression, which may be a promise."""
        answer = self.call("WebDriver:ExecuteAsyncScript", args=[script], script="""
            const [script, done] = arguments;
            (async () => eval(script))().then((value) => done({ value }), (error) => done({ error: String(error) }));""")["value"]
        if "error" in answer:
            raise RuntimeError(answer["error"])
        return answer.get("value")

    def act(self, kind, actions, **parameters):
        self.call("WebDriver:PerformActions", actions=[{"type": kind, "id": kind, "actions": actions, **parameters}])

    def mouse(self, *actions):
        self.act("pointer", list(actions), parameters={"pointerType": "mouse"})

    def click(self, x, y, count=1):
        press = [{"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}]
        self.mouse({"type": "pointerMove", "x": x, "y": y, "duration": 0}, *press * count)
        self.settle()

    def move(self, x, y):
        self.mouse({"type": "pointerMove", "x": x, "y": y, "duration": 0})
        self.settle()

    def wheel(self, x, y, delta):
        self.act("wheel", [{"type": "scroll", "x": x, "y": y, "deltaX": 0, "deltaY": delta, "duration": 0}])

    def pinch(self, x, y, begin, end):
        """Two fingers, that far from the middle, move away from each other, or nearer."""
        def finger(number, side):
            path = [{"type": "pointerMove", "x": x + side * (begin + (end - begin) * k / 8), "y": y, "duration": 16} for k in range(9)]
            return {"type": "pointer", "id": f"finger{number}", "parameters": {"pointerType": "touch"},
                    "actions": [path[0], {"type": "pointerDown", "button": 0}, *path[1:], {"type": "pointerUp", "button": 0}]}
        self.call("WebDriver:PerformActions", actions=[finger(1, -1), finger(2, 1)])
        self.settle()

    def key(self, key, settle=True):
        self.act("key", [{"type": kind, "value": KEYS.get(key, key)} for kind in ("keyDown", "keyUp")])
        if settle:
            self.settle()

    def screenshot(self):
        return self.call("WebDriver:TakeScreenshot", full=False)["value"]
