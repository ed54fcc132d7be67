"""What tests of pages share: the program, scratch files, checks that hold for every page."""
import os
import subprocess
import sys
import tempfile
import unittest

from browser import Browser, skip_unless_there


class Tools:
    """Set from the command line by run_tests."""
    program = make_campus = source = None


class PageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory(prefix="mapwright-page-")
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.scratch.cleanup()

    def path(self, name):
        return os.path.join(self.scratch.name, name)

    def file(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def mapwright(self, *arguments, expect):
        run = subprocess.run([Tools.program, *arguments, "--quiet"], capture_output=True, text=True)
        self.assertEqual(run.returncode, expect, run.stderr)
        return run.stdout

    def sample(self, name):
        return os.path.join(Tools.source, "samples", name)

    def text(self, selector):
        return self.browser.run(f"document.querySelector({selector!r})?.textContent ?? null")

    def count(self, selector):
        return self.browser.run(f"document.querySelectorAll({selector!r}).length")

    def click(self, selector):
        self.browser.run(f"document.querySelector({selector!r}).click()")

    def pixels(self):
        """A number that tells pictures of the map apart."""
        return self.browser.run(
            "(() => { const map = document.getElementById('base');"
            " const c = Object.assign(document.createElement('canvas'), { width: map.width, height: map.height });"
            " const copy = c.getContext('2d', { willReadFrequently: true }); copy.drawImage(map, 0, 0);"
            " const d = copy.getImageData(0, 0, c.width, c.height).data; let h = 0;"
            " for (let i = 0; i < d.length; i += 4) h = (h * 31 + d[i] + 7 * d[i + 1] + 13 * d[i + 2]) | 0;"
            " return h; })()")

    def assert_quiet(self, page):
        """Nothing was asked for but the page, and nothing went wrong."""
        asked = [url for url in self.browser.requests()
                 if not url.startswith(("chrome:", "about:", "data:"))]
        self.assertEqual(set(asked), {"file://" + page})
        self.assertEqual(self.browser.messages(), [])

    def frame_times(self, page, gesture):
        """Milliseconds between frames while the map is moved; the 10 first are thrown away."""
        self.browser.open(page)
        self.browser.wait_painted()
        pan = "true" if gesture == "pan" else "false"
        times = self.browser.run_async("""
          const top = document.getElementById('top');
          const times = [];
          let last = performance.now();
          top.setPointerCapture = () => {};
          const fire = (Kind, type, more) => top.dispatchEvent(
              new Kind(type, { pointerId: 1, bubbles: true, cancelable: true, ...more }));
          const at = (n) => ({ clientX: 900 + 200 * Math.sin(n / 15), clientY: 400 + 150 * Math.cos(n / 15) });
          if (%s) fire(PointerEvent, 'pointerdown', at(0));
          requestAnimationFrame(function step(now) {
            times.push(now - last);
            last = now;
            if (%s) fire(PointerEvent, 'pointermove', at(times.length));
            else fire(WheelEvent, 'wheel', { clientX: 900, clientY: 400, deltaY: times.length %% 120 < 60 ? -40 : 40 });
            if (times.length < 250) requestAnimationFrame(step);
            else { fire(PointerEvent, 'pointerup', at(0)); done(times.slice(10)); }
          });""" % (pan, pan))
        times.sort()
        figures = times[len(times) // 2], times[len(times) * 95 // 100], times[-1]
        print("%s %s: %d frames, median %.1f ms, 95 of 100 within %.1f ms, longest %.1f ms"
              % (os.path.basename(page), gesture, len(times), *figures))
        return figures


def run_tests():
    """For `python3 TEST.py PROGRAM MAKE_CAMPUS SOURCE_FOLDER`."""
    skip_unless_there()
    Tools.program, Tools.make_campus, Tools.source = (os.path.abspath(path) for path in sys.argv[1:4])
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=2)
