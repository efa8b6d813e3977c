# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Usage: test_page_by_hand.py PROGRAM MESH FOLDER
# Lets the program write the viewer page of the mesh, moves the picture by one and two fingers, and saves pictures, which
# are read from disk. Leaves with status 77 without Chromium, and without three.js in the program.

import math
import pathlib
import re
import struct
import subprocess
import sys
import urllib.parse
import xml.etree.ElementTree

import chromium

SKIPPED = 77
WIDTH = 320  # of the saved picture, in pixels


def view(browser):
    """The place of the camera, relative to its target."""
    browser.evaluate("document.getElementById('link').click()")
    address = urllib.parse.parse_qs(browser.evaluate("location.hash.slice(1)"))
    eye, target = ([float(x) for x in address[name][0].split(",")] for name in ["eye", "target"])
    return [a - b for a, b in zip(eye, target)], target


def angle(a, b):
    return math.acos(min(1, sum(x * y for x, y in zip(a, b)) / math.hypot(*a) / math.hypot(*b)))


def drag(browser, before, after):
    """Moves fingers from the places `before` to the places `after`, in steps."""
    steps = 3
    browser.touch("touchStart", *before)
    for i in range(1, steps + 1):
        browser.touch("touchMove", *[[a + (b - a) * i / steps for a, b in zip(*places)]
                                     for places in zip(before, after)])
    browser.touch("touchEnd")


def check(is_right, text):
    print("ok" if is_right else "failed", text)
    if not is_right:
        sys.exit(1)


def check_touch(browser):
    browser.call("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=2)
    reset = "document.getElementById('reset').click()"
    browser.evaluate(reset)
    eye, target = view(browser)
    drag(browser, [(300, 200)], [(380, 200)])
    turned, same_target = view(browser)
    check(angle(eye, turned) > 0.1 and math.dist(target, same_target) < 1e-6 * math.hypot(*eye),
          f"one finger turns by {math.degrees(angle(eye, turned)):.0f} degrees")
    check(abs(math.hypot(*turned) / math.hypot(*eye) - 1) < 1e-6, "and comes no nearer")
    browser.evaluate(reset)
    drag(browser, [(280, 200), (320, 200)], [(220, 200), (380, 200)])
    pinched, _ = view(browser)
    check(math.hypot(*pinched) < 0.8 * math.hypot(*eye),
          f"two fingers that part come nearer: {math.hypot(*pinched) / math.hypot(*eye):.2f} of the distance")
    browser.evaluate(reset)
    drag(browser, [(280, 200), (320, 200)], [(280, 260), (320, 260)])
    moved, other_target = view(browser)
    check(math.dist(target, other_target) > 0.05 * math.hypot(*eye) and angle(eye, moved) < 0.01,
          "two fingers side by side move the picture")
    browser.evaluate(reset)
    x, y = browser.evaluate("""(() => {
      for (let y = 20; y < innerHeight; y += 10)
        for (let x = 20; x < innerWidth; x += 10) {
          const move = new MouseEvent('mousemove', {clientX: x, clientY: y});
          document.getElementById('view').dispatchEvent(move);
          const is_free = document.elementFromPoint(x, y).tagName === 'CANVAS'; // not below the panel
          if (is_free && !document.getElementById('tip').hidden) return [x, y];
        }
    })()""")  # of some node
    browser.touch("touchStart", (x, y))
    browser.touch("touchEnd")
    browser.wait_for("!document.getElementById('row').hidden")
    row = browser.evaluate("document.getElementById('row').textContent")
    check(re.match(r"node \d+, degree", row), f"a tap chooses {row.splitlines()[0]}")


def check_downloads(browser):
    browser.evaluate(f"document.getElementById('width').value = {WIDTH}; document.getElementById('png').click()")
    png = browser.downloaded("mesh.off.png")
    check(png[:8] == b"\x89PNG\r\n\x1a\n" and struct.unpack(">I", png[16:20])[0] == WIDTH,
          f"PNG of {WIDTH} pixels, {len(png)} bytes on disk")
    browser.evaluate("document.getElementById('svg').click()")
    svg = xml.etree.ElementTree.fromstring(browser.downloaded("mesh.off.svg"))
    lines = len(svg.findall("{http://www.w3.org/2000/svg}line"))
    edges = browser.evaluate("cscd.panel.detail.counts.edges")
    check(lines == edges, f"SVG on disk with {lines} lines of {edges} edges")


def main():
    program, mesh, folder = sys.argv[1:]
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    copy = folder / "mesh.off"
    copy.write_bytes(pathlib.Path(mesh).read_bytes())
    page = folder / "page.html"
    written = subprocess.run([program, "skeletonize", str(copy), "-o", str(page), "-q"], check=False, timeout=120,
                             capture_output=True, text=True)
    if "three.js" in written.stderr or not chromium.is_installed():
        print("skipped: Chromium or three.js is not there")
        sys.exit(SKIPPED)
    with chromium.Chromium(folder, 480, 400) as browser:
        browser.open(page)
        browser.wait_for("cscd.is_ready")
        check_downloads(browser)
        check_touch(browser)
        errors = browser.evaluate("cscd.errors")
        check(not errors, f"errors in the page: {errors}")


main()
