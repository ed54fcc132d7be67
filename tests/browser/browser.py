"""Drives a headless Chromium by the WebDriver protocol, with nothing but Python's own library.

Needs the programs chromium and chromedriver (Debian's packages chromium and chromium-driver). Where
they are missing, tests end with kSkipped, which ctest shows as skipped.
"""
import base64
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

kSkipped = 77


def skip_unless_there():
    missing = [name for name in ("chromium", "chromedriver") if not shutil.which(name)]
    if missing:
        print("skipped: not installed: " + ", ".join(missing))
        sys.exit(kSkipped)


class Browser:
    """A window of its own; use as a context manager."""

    def __init__(self, width=1400, height=900):
        self.home = tempfile.TemporaryDirectory(prefix="mapwright-browser-")
        log = os.path.join(self.home.name, "log")
        with open(log, "w") as file:
            self.driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=file, stderr=file,
                                           env={**os.environ, "HOME": self.home.name})
        self.address = "http://127.0.0.1:%d" % self.port(log)
        arguments = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage",
                     "--disable-background-networking", "--disable-component-update",
                     "--force-device-scale-factor=1", f"--window-size={width},{height}",
                     f"--user-data-dir={self.home.name}/profile"]
        options = {"binary": shutil.which("chromium"), "args": arguments}
        capabilities = {"browserName": "chrome", "goog:chromeOptions": options,
                        "goog:loggingPrefs": {"performance": "ALL", "browser": "ALL"}}
        answer = self.call("POST", "/session", {"capabilities": {"alwaysMatch": capabilities}})
        self.address += "/session/" + answer["sessionId"]
        self.set_size(width, height)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.call("DELETE", "")
        finally:
            self.driver.terminate()
            self.driver.wait()
            self.home.cleanup()

    @staticmethod
    def port(log):
        for _ in range(400):
            with open(log) as file:
                text = file.read()
            for line in text.splitlines():
                if "started successfully on port" in line:
                    return int(line.rstrip(".").rsplit(" ", 1)[1])
            time.sleep(0.05)
        raise RuntimeError("chromedriver does not start: " + text)

    def call(self, method, path, body=None):
        request = urllib.request.Request(self.address + path, method=method,
                                         data=None if body is None else json.dumps(body).encode(),
                                         headers={"Content-Type": "application/json"})
        try:
            with urllib.request.urlopen(request, timeout=120) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(error.read().decode()) from error

    def open(self, path, fragment=""):
        self.call("POST", "/url", {"url": "about:blank"})
        self.call("POST", "/url", {"url": "file://" + os.path.abspath(path) + fragment})
        self.wait("document.documentElement.dataset.ready === 'yes'")

    def run(self, script):
        """The value of a JavaScript expression."""
        return self.call("POST", "/execute/sync", {"script": "return " + script, "args": []})

    def run_async(self, script):
        """What the script passes to done(…)."""
        script = "const done = arguments[0];" + script
        return self.call("POST", "/execute/async", {"script": script, "args": []})

    def wait(self, condition, seconds=30):
        end = time.time() + seconds
        while time.time() < end:
            if self.run(condition):
                return
            time.sleep(0.02)
        raise AssertionError(f"never came true: {condition}\n{self.messages()}")

    def wait_painted(self):
        """Until nothing moves and the map is painted."""
        self.run_async("requestAnimationFrame(() => requestAnimationFrame(() => done(1)))")
        self.wait("document.getElementById('top').dataset.painted === 'yes'")
        time.sleep(0.6)
        self.wait("document.getElementById('top').dataset.painted === 'yes'")

    def devtools(self, command, parameters):
        return self.call("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def set_size(self, width, height):
        self.devtools("Emulation.setDeviceMetricsOverride",
                      {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})

    def set_colours(self, scheme):
        """What the system asks for: "light" or "dark"."""
        self.devtools("Emulation.setEmulatedMedia",
                      {"features": [{"name": "prefers-color-scheme", "value": scheme}]})

    def type_keys(self, *keys):
        actions = [{"type": kind, "value": key} for key in keys for kind in ("keyDown", "keyUp")]
        self.call("POST", "/actions", {"actions": [{"type": "key", "id": "keys", "actions": actions}]})

    def pointer(self, *actions):
        self.call("POST", "/actions", {"actions": [
            {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": list(actions)}]})

    def click_at(self, x, y):
        self.pointer({"type": "pointerMove", "x": int(x), "y": int(y)},
                     {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0})

    def drag(self, start, end):
        self.pointer({"type": "pointerMove", "x": start[0], "y": start[1]},
                     {"type": "pointerDown", "button": 0},
                     {"type": "pointerMove", "x": end[0], "y": end[1], "duration": 200},
                     {"type": "pointerUp", "button": 0})

    def screenshot(self, path):
        with open(path, "wb") as file:
            file.write(base64.b64decode(self.call("GET", "/screenshot")))

    def requests(self):
        """Addresses asked for since the last call."""
        events = [json.loads(entry["message"])["message"]
                  for entry in self.call("POST", "/se/log", {"type": "performance"})]
        return [event["params"]["request"]["url"] for event in events
                if event["method"] == "Network.requestWillBeSent"]

    def messages(self):
        """What the browser's console says: errors of scripts, breaches of the policy."""
        return [entry["message"] for entry in self.call("POST", "/se/log", {"type": "browser"})]
