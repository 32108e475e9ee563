"""A browser without a window: the face that its kinds have in common. Each is driven by a protocol of its own, which needs
no package beside the browser."""

import base64
import os
import shutil
import time


class Browser:
    """One page of a browser; a context manager. Kinds have run, size, dark, click, move, wheel and key; `complaints`, errors
    and warnings of the page, and `requests`, addresses that it asked for, since the last call of forget."""

    @classmethod
    def find(cls):
        """The path of the browser, or None."""
        return next((path for path in map(shutil.which, cls.NAMES) if path), None)

    def open(self, path, link=""):
        """Opens a file and waits until it is ready; gives the seconds that took."""
        begin = time.monotonic()
        self.navigate("file://" + os.path.abspath(path) + link)
        while self.run("document.documentElement?.dataset?.ready ?? ''") != "yes":
            if time.monotonic() - begin > 30:
                raise RuntimeError(f"{path} is not ready: {self.complaints} {self.run('document.body?.innerText')}")
            time.sleep(0.02)
        return time.monotonic() - begin

    def settle(self):
        """Waits for the next two frames."""
        self.run("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def picture(self, path=None):
        """The page as it is seen, as PNG."""
        data = base64.b64decode(self.screenshot())
        if path:
            with open(path, "wb") as file:
                file.write(data)
        return data
