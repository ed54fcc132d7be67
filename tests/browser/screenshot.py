"""Takes a picture of a page of mapwright in headless Chromium.

Usage: screenshot.py PAGE.html PICTURE.png [#FRAGMENT [light|dark]]
"""
import sys

from browser import Browser, skip_unless_there


def main(page, picture, fragment="", scheme="light"):
    skip_unless_there()
    with Browser(1400, 860) as browser:
        browser.set_colours(scheme)
        browser.open(page, fragment)
        browser.wait_painted()
        browser.screenshot(picture)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
