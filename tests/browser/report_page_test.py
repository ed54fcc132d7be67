"""The HTML report in headless Chromium: what it shows, how it is worked, what it never does."""
import subprocess

from page_test import PageTest, Tools, run_tests

kHostile = """border;0;20;20;0;#
obstacle;1;1;3;</script><script>window.broken=1</script>;#
2;2;4;2;3;1;<img src=https://example.org/x.png onerror=window.broken=1>;#
4;2;4;4;3;1;<!--<script>;#
4;4;2;2;3;1;wall;#
obstacle;1;2;1;fence & "wall" \u2028;#
6;6;9;6;3;1;wall;#
"""


class Report(PageTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.page = cls.path(cls, "broken.html")
        subprocess.run([Tools.program, "validate", cls.sample(cls, "broken/square_broken.txt"), "--format",
                        "html", "-o", cls.page, "--quiet"], check=False)

    def setUp(self):
        self.browser.set_colours("light")
        self.browser.requests()
        self.browser.messages()
        self.browser.open(self.page)
        self.browser.wait_painted()

    def tearDown(self):
        self.assert_quiet(self.page)

    def selected(self):
        return self.browser.run("[...document.querySelectorAll('tr[aria-selected] td')].slice(0, 3)"
                                ".map((cell) => cell.textContent)")

    def test_shows_map_and_findings(self):
        self.assertIn("1 map: 0 fit, 1 not", self.text("#summary"))
        self.assertIn("34 obstacles, 200 segments", self.text("#about"))
        self.assertEqual(self.count("tbody tr"), 14)
        self.assertEqual(self.text("#count"), "14 of 14")
        self.assertTrue(self.browser.run("document.getElementById('maps').hidden"))

    def test_click_on_a_finding_flies_to_it(self):
        before = self.pixels()
        self.click("tbody tr:nth-child(5) button")
        self.browser.wait_painted()
        self.assertEqual(self.selected(), ["error", "S101", "310"])
        self.assertNotEqual(self.pixels(), before)
        self.assertIn("duplicate_obstacle_id", self.text("#inspector h3"))
        self.assertIn("16;1;4;flowerpot", self.text("#inspector pre"))
        self.assertIn("# S101", self.text("#inspector pre.page"))
        self.assertIn("finding=5", self.browser.run("location.hash"))

    def test_the_address_names_a_finding(self):
        self.browser.open(self.page, "#map=1&finding=5")
        self.assertEqual(self.selected(), ["error", "S101", "310"])

    def test_keys_go_from_finding_to_finding_and_move_the_map(self):
        self.browser.run("document.getElementById('top').focus()")
        self.browser.type_keys("n", "n")
        self.assertEqual(self.selected()[1], "G107")
        self.browser.type_keys("p")
        self.assertEqual(self.selected()[1], "F109")
        self.browser.type_keys("\ue00c")  # Escape
        self.assertEqual(self.selected(), [])
        self.assertTrue(self.browser.run("document.getElementById('inspector').hidden"))
        self.browser.wait_painted()
        for keys in (["+"], ["\ue012"], ["\ue013"], ["-"], ["0"]):  # left, up
            before = self.pixels()
            self.browser.type_keys(*keys)
            self.browser.wait_painted()
            self.assertNotEqual(self.pixels(), before, keys)

    def test_table_is_worked_by_keys(self):
        self.browser.run("document.querySelector('tbody button').focus()")
        self.browser.type_keys("\ue015", "\ue007")  # down, Enter
        self.assertEqual(self.selected()[1], "G107")

    def test_dragging_and_wheel_move_the_map(self):
        before = self.pixels()
        self.browser.drag((800, 400), (700, 450))
        self.browser.wait_painted()
        moved = self.pixels()
        self.assertNotEqual(moved, before)
        self.browser.call("POST", "/actions", {"actions": [{"type": "wheel", "id": "wheel", "actions": [
            {"type": "scroll", "x": 900, "y": 400, "deltaX": 0, "deltaY": -200, "duration": 0}]}]})
        self.browser.wait_painted()
        self.assertNotEqual(self.pixels(), moved)

    def test_click_on_an_obstacle_tells_what_it_is(self):
        # Where, in a window of this size, the large building on the left stands.
        self.browser.click_at(680, 420)
        self.assertIn("building", self.text("#inspector h3"))
        self.assertIn("closed polygon", self.text("#inspector dl"))
        self.browser.click_at(880, 640)
        self.assertTrue(self.browser.run("document.getElementById('inspector').hidden"))

    def test_layers_can_be_hidden(self):
        before = self.pixels()
        self.browser.run("[...document.querySelectorAll('#layers label')]"
                         ".find((l) => l.textContent.startsWith('building')).querySelector('input').click()")
        self.browser.wait_painted()
        self.assertNotEqual(self.pixels(), before)
        self.browser.click_at(680, 420)
        self.assertTrue(self.browser.run("document.getElementById('inspector').hidden"))

    def test_table_filters_and_sorts(self):
        self.browser.run("(() => { const s = document.getElementById('code'); s.value = 'S107';"
                         " s.dispatchEvent(new Event('change')); })()")
        codes = "[...document.querySelectorAll('tbody td:nth-child(2)')].map((c) => c.textContent)"
        self.assertEqual(set(self.browser.run(codes)), {"S107"})
        self.browser.run("(() => { const s = document.getElementById('code'); s.value = '';"
                         " s.dispatchEvent(new Event('change')); })()")
        self.click("th[data-key=code] button")
        up = self.browser.run(codes)
        self.assertEqual(up, sorted(up))
        self.click("th[data-key=code] button")
        self.assertEqual(self.browser.run(codes), sorted(up, reverse=True))
        self.assertEqual(self.count("th[aria-sort=descending]"), 1)
        self.browser.run("(() => { const w = document.getElementById('words'); w.value = 'DECIMAL comma';"
                         " w.dispatchEvent(new Event('input')); })()")
        self.assertEqual(self.browser.run(codes), ["F109"])
        self.click("#levels input[value=error]")
        self.assertEqual(self.text("#count"), "0 of 14")

    def test_colours_follow_the_system_and_the_switch(self):
        ground = "getComputedStyle(document.body).backgroundColor"
        light = self.browser.run(ground)
        light_map = self.pixels()
        self.browser.set_colours("dark")
        self.browser.wait_painted()
        dark = self.browser.run(ground)
        self.assertNotEqual(dark, light)
        self.assertNotEqual(self.pixels(), light_map)
        self.click(".theme input[value=light]")
        self.assertEqual(self.browser.run(ground), light)
        self.click(".theme input[value=dark]")
        self.browser.set_colours("light")
        self.assertEqual(self.browser.run(ground), dark)
        self.click(".theme input[value=system]")
        self.assertEqual(self.browser.run(ground), light)

    def test_every_control_has_a_name(self):
        unnamed = self.browser.run(
            "[...document.querySelectorAll('button, select, input, canvas[tabindex]')].filter((e) =>"
            " !(e.ariaLabel || e.textContent.trim() || e.closest('label')?.textContent.trim()))"
            ".map((e) => e.outerHTML)")
        self.assertEqual(unnamed, [])


class Policy(PageTest):
    def setUp(self):
        self.browser.requests()
        self.browser.messages()

    def test_nothing_in_a_map_becomes_markup(self):
        page = self.path("hostile.html")
        hostile = self.file("hostile & <b>.txt", kHostile)
        self.mapwright("validate", hostile, "--format", "html", "-o", page, expect=1)
        self.browser.open(page, "#map=1&finding=1")
        self.browser.wait_painted()
        self.assertIsNone(self.browser.run("window.broken ?? null"))
        self.assertIn("<b>.txt", self.text("#about h2"))
        self.assertEqual(self.count("img, b, iframe"), 0)
        self.assert_quiet(page)

    def test_the_policy_stops_requests_and_foreign_scripts(self):
        page = self.path("fit.html")
        self.mapwright("validate", self.sample("campus/campus.txt"), "--format", "html", "-o", page, expect=0)
        self.browser.open(page)
        self.assertEqual(self.browser.run_async(
            "fetch('https://example.org/').then(() => done('sent'), () => done('stopped'))"), "stopped")
        self.browser.run("(() => { const s = document.createElement('style'); s.textContent = 'body{display:none}';"
                         " document.head.append(s); })()")
        self.assertNotEqual(self.browser.run("getComputedStyle(document.body).display"), "none")
        self.assertRegex("\n".join(self.browser.messages()), "Content Security Policy")

    def show_map(self, name):
        self.browser.run("[...document.querySelectorAll('#maps button')]"
                         ".find((b) => b.textContent.includes('" + name + "')).click()")
        self.browser.wait_painted()

    def test_several_maps_and_what_check_says_of_them(self):
        page = self.path("check.html")
        self.mapwright("check", self.sample("campus/campus.txt"), self.sample("broken/square_broken.txt"),
                       self.path("missing.txt"), "--trials", "1", "--plans", "2", "--format", "html", "-o", page,
                       expect=3)
        self.browser.open(page)
        self.assertEqual(self.count("#maps button"), 3)
        self.show_map("campus.txt")
        self.assertIn("reachability", self.text("#about"))
        self.show_map("square_broken.txt")
        self.assertIn("square_broken.txt", self.text("#about h2"))
        self.assertIn("area out of reach", self.text("#layers"))
        self.show_map("missing.txt")
        self.assertIn("missing.txt", self.text("#about .level-error"))
        self.assert_quiet(page)


class Speed(PageTest):
    def test_50000_segments_move_smoothly(self):
        with open(self.path("large.txt"), "w") as file:
            subprocess.run([Tools.make_campus, "52000"], stdout=file, check=True)
        page = self.path("large.html")
        self.mapwright("validate", self.path("large.txt"), "--format", "html", "-o", page, expect=0)
        for gesture in ("pan", "zoom"):
            median, most, _ = self.frame_times(page, gesture)
            # 16.7 ms is the display's; the bounds leave room for machines that do other work too.
            self.assertLess(median, 35)
            self.assertLess(most, 100)


if __name__ == "__main__":
    run_tests()
