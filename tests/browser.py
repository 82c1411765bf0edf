"""A headless Chromium to drive pages with, over its debugging pipe: no driver, no socket."""

from __future__ import annotations

import base64
import json
import os
import select
import shutil
import subprocess
import time
from itertools import count

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
PATIENCE = 30.0  # seconds for any one answer


def browser_path():
    """The browser's program: $TSPLAN_BROWSER, or the first Chromium or Chrome on the path."""
    named = os.environ.get("TSPLAN_BROWSER")
    return named or next((found for name in NAMES if (found := shutil.which(name))), None)


class Browser:
    """One browser with one page; everything it reports is kept in `events`."""

    def __init__(self, profile):
        to_browser, our_end = os.pipe()
        their_end, from_browser = os.pipe()
        self._write, self._read = our_end, their_end

        def wire():  # the browser reads from 3 and writes to 4
            reading, writing = os.dup(to_browser), os.dup(from_browser)
            os.dup2(reading, 3)
            os.dup2(writing, 4)

        self._process = subprocess.Popen(
            [
                browser_path(),
                "--headless=new",
                "--remote-debugging-pipe",
                f"--user-data-dir={profile}",
                "--window-size=1280,800",
                "--no-sandbox",
                "--no-first-run",
                "--disable-gpu",
                "--disable-dev-shm-usage",
                "--disable-extensions",
                "--disable-background-networking",
                "--disable-component-update",
                "--disable-sync",
                "--mute-audio",
                "about:blank",
            ],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            preexec_fn=wire,  # noqa: PLW1509  (the browser wants its pipe at 3 and 4)
            close_fds=False,
        )
        os.close(to_browser)
        os.close(from_browser)
        self._numbers = count(1)
        self._buffer = b""
        self._session = None
        self.events = []
        targets = self.ask("Target.getTargets")["targetInfos"]
        page = next(target for target in targets if target["type"] == "page")
        attached = self.ask("Target.attachToTarget", targetId=page["targetId"], flatten=True)
        self._session = attached["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(f"{domain}.enable")
        self.resize()

    def ask(self, method, **parameters):
        """Send one command and return its result."""
        number = next(self._numbers)
        message = {"id": number, "method": method, "params": parameters}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._write, json.dumps(message).encode() + b"\0")
        return self._until(lambda heard: heard.get("id") == number, method)["result"]

    def _until(self, wanted, what):
        end = time.monotonic() + PATIENCE
        while True:
            heard = self._next(end, what)
            if "method" in heard:
                self.events.append(heard)
            if wanted(heard):
                if "error" in heard:
                    raise RuntimeError(f"{what}: {heard['error']['message']}")
                return heard

    def _next(self, end, what):
        while b"\0" not in self._buffer:
            ready, _, _ = select.select([self._read], [], [], max(0, end - time.monotonic()))
            part = os.read(self._read, 1 << 20) if ready else b""
            if not part:
                raise TimeoutError(f"the browser did not answer: {what}")
            self._buffer += part
        message, self._buffer = self._buffer.split(b"\0", 1)
        return json.loads(message)

    def open(self, path, at=""):
        """Load a file from disk, at a part of its address, and wait until it has been shown."""
        self.ask("Page.navigate", url="about:blank")  # else a new part of an address loads nothing
        self.events.clear()
        self.ask("Page.navigate", url=path.resolve().as_uri() + at)
        self._until(lambda heard: heard.get("method") == "Page.loadEventFired", "loading")
        self.frames(3)

    def run(self, expression):
        """The value of a JavaScript expression on the page."""
        answer = self.ask(
            "Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True
        )
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"]["exception"]["description"])
        return answer["result"].get("value")

    def frames(self, number=2):
        """Wait until so many frames have been painted."""
        self.run(
            f"new Promise(done => {{ let left = {number};"
            " const next = () => left-- ? requestAnimationFrame(next) : done(); next(); })"
        )

    def press(self, key, modifiers=0):
        """Press and release a key."""
        text = {"text": key} if len(key) == 1 else {}
        for kind in ("keyDown", "keyUp"):
            extra = text if kind == "keyDown" else {}
            self.ask("Input.dispatchKeyEvent", type=kind, key=key, modifiers=modifiers, **extra)
        self.frames()

    def click(self, x, y):
        """Move to a place of the page and click there."""
        self.ask("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
        for kind in ("mousePressed", "mouseReleased"):
            self.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)
        self.frames()

    def click_on(self, selector, place=0):
        """Scroll an element into sight and click on its middle."""
        middle = self.run(
            f"(() => {{ const found = document.querySelectorAll({json.dumps(selector)})[{place}];"
            " found.scrollIntoView({block: 'nearest'}); const box = found.getBoundingClientRect();"
            " return [box.left + box.width / 2, box.top + box.height / 2]; })()"
        )
        self.click(*middle)

    def resize(self, width=1280, height=800):
        """Give the page another size."""
        self.ask(
            "Emulation.setDeviceMetricsOverride",
            width=width,
            height=height,
            deviceScaleFactor=1,
            mobile=False,
        )

    def prefer(self, **features):
        """Set what the system prefers, as prefers_color_scheme="dark"."""
        listed = [{"name": k.replace("_", "-"), "value": v} for k, v in features.items()]
        self.ask("Emulation.setEmulatedMedia", features=listed)
        self.frames()

    def screenshot(self):
        """The page as PNG bytes."""
        return base64.b64decode(self.ask("Page.captureScreenshot", format="png")["data"])

    def errors(self):
        """What the page complained about: exceptions, errors and refused loads."""
        return [event for event in self.events if _is_error(event)]

    def requests(self):
        """Everything the page asked for, its own file excepted."""
        urls = [
            event["params"]["request"]["url"]
            for event in self.events
            if event["method"] == "Network.requestWillBeSent"
        ]
        return urls[1:]

    def close(self):
        """End the browser that was started here."""
        try:
            self._session = None
            self.ask("Browser.close")
        except (RuntimeError, TimeoutError, OSError):
            self._process.kill()
        self._process.wait(timeout=PATIENCE)
        os.close(self._write)
        os.close(self._read)


def _is_error(event):
    kind, parameters = event["method"], event["params"]
    if kind == "Runtime.exceptionThrown":
        return True
    if kind == "Runtime.consoleAPICalled":
        return parameters["type"] in {"error", "warning", "assert"}
    return kind == "Log.entryAdded" and parameters["entry"]["level"] in {"error", "warning"}
