"""As much of the WebDriver protocol as the tests of our pages need, over headless Chromium."""
import base64
import json
import shutil
import socket
import subprocess
import tempfile
import time
import urllib.request

FLAGS = """--headless --no-sandbox --disable-gpu --disable-quic --no-first-run
  --disable-background-networking --disable-component-update --disable-sync""".split()


class Browser:
    """A Chromium with a profile of its own; screenshots go to `folder`, where it is given."""

    def __init__(self, profile, folder=None):
        self.folder = folder
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        self.driver = subprocess.Popen(["chromedriver", f"--port={port}"],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.base = f"http://127.0.0.1:{port}"
        until(lambda: self.ask("GET", "/status")["ready"], "chromedriver", patient=True)
        options = {"args": [*FLAGS, f"--user-data-dir={profile}", "--window-size=1200,1100"],
                   "binary": shutil.which("chromium")}
        session = self.ask("POST", "/session", {"capabilities": {"alwaysMatch": {
            "goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"}}}})
        self.base += "/session/" + session["sessionId"]

    def ask(self, method, path, body=None):
        data = json.dumps(body or {}).encode() if method == "POST" else None
        request = urllib.request.Request(self.base + path, data, method=method)
        with urllib.request.urlopen(request, timeout=120) as answer:
            return json.load(answer)["value"]

    def run(self, script):
        return self.ask("POST", "/execute/sync", {"script": script, "args": []})

    def text(self, element):
        return self.run(f"return document.getElementById('{element}').textContent")

    def devtools(self, command, **parameters):
        self.ask("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def click(self, x, y):
        at = [{"type": "pointerMove", "duration": 0, "x": x, "y": y},
              {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}]
        self.ask("POST", "/actions", {"actions": [{"type": "pointer", "id": "m", "actions": at}]})

    def press(self, *keys):
        steps = [{"type": "keyDown", "value": k} for k in keys]
        steps += [{"type": "keyUp", "value": k} for k in reversed(keys)]
        self.ask("POST", "/actions", {"actions": [{"type": "key", "id": "k", "actions": steps}]})

    def screenshot(self, name):
        if self.folder:
            with open(f"{self.folder}/{name}.png", "wb") as out:
                out.write(base64.b64decode(self.ask("GET", "/screenshot")))

    def element_screenshot(self, selector, path):
        element = self.run(f"return document.querySelector({json.dumps(selector)})")
        name = next(iter(element.values()))
        with open(path, "wb") as out:
            out.write(base64.b64decode(self.ask("GET", f"/element/{name}/screenshot")))

    def check_quiet(self):
        """Nothing was asked of anyone else, and nothing went wrong on the way."""
        names = self.run("return performance.getEntriesByType('resource').map((e) => e.name)")
        assert all(name.startswith(("file:", "data:", "blob:")) for name in names), names
        errors = [entry for entry in self.ask("POST", "/se/log", {"type": "browser"})
                  if entry["level"] == "SEVERE"]
        assert not errors, errors


def until(condition, what, patient=False):
    """Waits up to a minute: the page follows a program that compiles."""
    for _ in range(600):
        try:
            if condition():
                return
        except OSError:
            if not patient:
                raise
        time.sleep(0.1)
    raise AssertionError("never came: " + what)


def in_browser(test, folder=None):
    """Runs test(browser), and ends the browser whatever comes of it."""
    with tempfile.TemporaryDirectory() as profile:
        chromium = Browser(profile, folder)
        try:
            test(chromium)
        finally:
            try:
                chromium.ask("DELETE", "")
            finally:
                chromium.driver.terminate()
                chromium.driver.wait()
