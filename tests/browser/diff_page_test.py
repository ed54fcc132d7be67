"""The HTML page of `mapwright diff` in headless Chromium."""
from page_test import PageTest, run_tests


class Diff(PageTest):
    def test_shows_what_changed_and_flies_to_it(self):
        before = self.sample("campus/campus.txt")
        with open(before, encoding="utf-8") as file:
            text = file.read()
        # The second obstacle goes, the last one becomes higher.
        head, *obstacles = text.split("obstacle;")
        del obstacles[1]
        last = obstacles[-1].split("#")
        obstacles[-1] = "#".join([last[0]] + [self.higher(part) for part in last[1:]])
        after = self.file("after.txt", head + "".join("obstacle;" + part for part in obstacles))
        page = self.path("diff.html")
        self.mapwright("diff", before, after, "--format", "html", "-o", page, expect=1)
        self.browser.requests()
        self.browser.messages()
        self.browser.open(page)
        self.browser.wait_painted()
        kinds = self.browser.run("[...document.querySelectorAll('tbody td.level')].map((c) => c.textContent)")
        self.assertIn("removed", kinds)
        self.assertIn("changed", kinds)
        self.assertIn("1 removed", self.text("#summary"))
        self.assertTrue(self.browser.run("document.getElementById('code').hidden"))
        start = self.pixels()
        self.browser.run("[...document.querySelectorAll('tbody tr')].find((r) =>"
                         " r.textContent.startsWith('removed')).querySelector('button').click()")
        self.browser.wait_painted()
        self.assertNotEqual(self.pixels(), start)
        self.assertEqual(self.text("#inspector h3"), "removed")
        shown = self.pixels()
        self.browser.run("[...document.querySelectorAll('#layers label')]"
                         ".find((l) => l.textContent.startsWith('removed')).querySelector('input').click()")
        self.browser.wait_painted()
        self.assertNotEqual(self.pixels(), shown)
        self.assert_quiet(page)

    @staticmethod
    def higher(record):
        """A segment's record, one metre higher."""
        fields = record.split(";")
        if len(fields) < 7:
            return record
        fields[4] = fields[4].replace(fields[4].strip(), str(float(fields[4]) + 1.0))
        return ";".join(fields)


if __name__ == "__main__":
    run_tests()
