"""A headless Chromium that is told what to do through a pipe (Chrome DevTools Protocol), with the standard library."""

import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")


def found():
    """The path of a browser, or None."""
    return os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, NAMES)), None)


class Browser:
    """One page in a browser of its own. WebGL is done in software, so that no device is needed."""

    def __init__(self, *flags):
        self.home = tempfile.mkdtemp(prefix="daphnis-browser.")
        to_read, self.to_write = os.pipe()
        self.from_read, from_write = os.pipe()
        # The browser reads orders at descriptor 3 and answers at 4.
        command = [
            "/bin/sh", "-c", f'exec "$@" 3<&{to_read} 4>&{from_write}', "sh", found(), "--headless=new",
            "--remote-debugging-pipe", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars",
            "--no-first-run", "--disable-extensions", "--disable-background-networking",
            "--enable-unsafe-swiftshader", "--use-angle=swiftshader", f"--user-data-dir={self.home}", *flags,
        ]
        self.process = subprocess.Popen(
            command, pass_fds=(to_read, from_write), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )
        os.close(to_read)
        os.close(from_write)
        self.number = 0
        self.rest = b""
        self.events = []
        target = self.tell("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.tell("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.tell(f"{domain}.enable")

    session = None

    def tell(self, method, **words):
        """Gives an order and returns its answer; events that come before it are kept."""
        self.number += 1
        order = {"id": self.number, "method": method, "params": words}
        if self.session:
            order["sessionId"] = self.session
        os.write(self.to_write, json.dumps(order).encode() + b"\0")
        while True:
            answer = self.read(time.monotonic() + 60)
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise AssertionError(f"{method}: {answer['error']}")
                return answer["result"]
            self.events.append(answer)

    def read(self, deadline):
        while b"\0" not in self.rest:
            if not select.select([self.from_read], [], [], max(0, deadline - time.monotonic()))[0]:
                raise AssertionError("the browser does not answer")
            part = os.read(self.from_read, 1 << 20)
            if not part:
                raise AssertionError("the browser has ended")
            self.rest += part
        message, self.rest = self.rest.split(b"\0", 1)
        return json.loads(message)

    def size(self, width, height, dark=False, touch=False):
        self.tell("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
        self.tell("Emulation.setEmulatedMedia", features=[scheme])
        self.tell("Emulation.setTouchEmulationEnabled", enabled=touch)

    def open(self, address):
        self.tell("Page.navigate", url=address)
        self.wait(f"location.href === {json.dumps(address)} && document.readyState === 'complete'")

    def js(self, words):
        """The value of an expression of the page, awaited where it is a promise."""
        answer = self.tell("Runtime.evaluate", expression=words, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            raise AssertionError(answer["exceptionDetails"])
        return answer["result"].get("value")

    def wait(self, words, seconds=60):
        """Waits until an expression is true, which may be a while on a machine that is busy."""
        deadline = time.monotonic() + seconds
        while time.monotonic() < deadline:
            try:
                if self.js(words):
                    return
            except AssertionError as e:
                if "Execution context" not in str(e):
                    raise
            time.sleep(0.05)
        raise AssertionError(f"not within {seconds} s: {words}")

    def key(self, key, code=None, number=0):
        text = {"text": key} if len(key) == 1 else {}
        for kind in ("keyDown", "keyUp"):
            more = text if kind == "keyDown" else {}
            self.tell("Input.dispatchKeyEvent", type=kind, key=key, code=code or key,
                      windowsVirtualKeyCode=number, **more)

    def mouse(self, kind, x, y, **words):
        self.tell("Input.dispatchMouseEvent", type=kind, x=x, y=y, **words)

    def click(self, element):
        x, y = self.middle(element)
        self.mouse("mousePressed", x, y, button="left", clickCount=1)
        self.mouse("mouseReleased", x, y, button="left", clickCount=1)

    def middle(self, element):
        self.js(f"document.getElementById('{element}').scrollIntoView({{block: 'nearest'}})")
        return self.js(f"(r => [r.x + r.width / 2, r.y + r.height / 2])"
                       f"(document.getElementById('{element}').getBoundingClientRect())")

    def picture(self, path=None, **words):
        """What is seen, as the bytes of a PNG; of a part of the page with clip."""
        if "clip" in words:
            words["clip"]["scale"] = 1
        data = base64.b64decode(self.tell("Page.captureScreenshot", format="png", **words)["data"])
        if path:
            with open(path, "wb") as file:
                file.write(data)
        return data

    def complaints(self):
        """Errors of the page so far: of its code, of its policy, of requests."""
        self.js("0")
        wrong = []
        for event in self.events:
            method, words = event.get("method"), event.get("params", {})
            if method == "Runtime.exceptionThrown":
                wrong.append(words["exceptionDetails"])
            if method == "Log.entryAdded" and words["entry"]["level"] == "error":
                wrong.append(words["entry"])
        return wrong

    def close(self):
        self.process.kill()
        self.process.wait()
        os.close(self.to_write)
        os.close(self.from_read)
        shutil.rmtree(self.home, ignore_errors=True)
