# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Usage: test_page_that_computes.py PROGRAM PAGE DATA FOLDER
# Opens meshes and points of the folder DATA, of CGAL's, in the page that examples/web/build.sh makes, and compares the
# files saved there with those of the program. Leaves with status 77 without Chromium, and without the page.

import base64
import pathlib
import re
import subprocess
import sys

import chromium

SKIPPED = 77
MAX_MODULE_SIZE = 1_500_000  # bytes
MESHES = ["elephant", "knot1", "homer", "camel", "refined_elephant"]
# Endings of texts and the option of the program for them; numbers may differ in their last digits.
TEXTS = {".graph": "-o", ".json": "-o", ".obj": "-o", ".polylines.txt": "-o", ".ply": "-o", ".swc": "-o", ".vtp": "-o",
         "_branches.csv": "--branches", "_nodes.csv": "--nodes",
         "_vertices.csv": "--correspondence"}
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
# The C libraries and the order of sums differ.
TOLERANCE = 1e-9  # relative to the greatest number with a fraction


def check(is_right, text):
    print("ok" if is_right else "failed", text, flush=True)
    if not is_right:
        sys.exit(1)


def difference(first, second):
    """The greatest difference of the numbers of two texts, relative to the greatest; infinite if integers or anything
    else differ."""
    if NUMBER.sub("#", first) != NUMBER.sub("#", second):
        return float("inf")
    pairs = [pair for pair in zip(NUMBER.findall(first), NUMBER.findall(second)) if pair[0] != pair[1]]
    if any(a.lstrip("-").isdigit() and b.lstrip("-").isdigit() for a, b in pairs):
        return float("inf")
    numbers = [abs(float(text)) for text in NUMBER.findall(first) if "." in text and "e+308" not in text]
    return max((abs(float(a) - float(b)) for a, b in pairs), default=0) / max(numbers, default=1)


def open_file(browser, file, by_drop=False):
    """The message of the page when it is done."""
    browser.evaluate("cscd.state = 'waiting'")
    if by_drop:
        content = base64.b64encode(file.read_bytes()).decode()
        browser.evaluate(f"""(() => {{
          const dataTransfer = new DataTransfer(), bytes = Uint8Array.from(atob('{content}'), c => c.charCodeAt(0));
          dataTransfer.items.add(new File([bytes], '{file.name}'));
          window.dispatchEvent(new DragEvent('drop', {{dataTransfer, cancelable: true}}));
        }})()""")
    else:
        browser.choose_file("#file", file)
    browser.wait_for("['done', 'failed'].includes(cscd.state)", 300)
    return browser.evaluate("document.getElementById('status').textContent")


def saved(browser, file, ending):
    browser.evaluate(f"document.getElementById('format').value = '{ending}'; document.getElementById('save').click()")
    return browser.downloaded(file.stem + ending)


def written(program, folder, file, ending, option, *options):
    output = folder / ("program_" + file.stem + ending)
    subprocess.run([program, "skeletonize", str(file), option, str(output), "-q", *options], check=True, timeout=120)
    return output.read_bytes()


def check_skeleton(browser, program, folder, file, *options):
    of_page = saved(browser, file, ".graph").decode()
    of_program = written(program, folder, file, ".graph", "-o", *options).decode()
    nodes = of_page.count("n ")
    worst = difference(of_page, of_program)
    check(worst <= TOLERANCE, f"{file.name} {' '.join(options)}: {nodes} nodes, {browser.evaluate('cscd.seconds'):.2f} "
                              f"s; coordinates differ by {worst:.0e}")
    browser.wait_for("document.getElementById('viewer').contentWindow.cscd.is_ready")
    shown = browser.evaluate("""(({panel, errors}) => ({nodes: panel.detail.counts.nodes, errors}))(
      document.getElementById('viewer').contentWindow.cscd)""")
    check(shown["nodes"] == nodes and not shown["errors"], f"shown with {shown['nodes']} nodes")


def check_formats(browser, program, folder, file):
    for ending, option in TEXTS.items():
        of_page = saved(browser, file, ending)
        of_program = written(program, folder, file, ending, option)
        worst = 0 if of_page == of_program else difference(of_page.decode(), of_program.decode())
        check(worst <= TOLERANCE, f"{ending}: {'the same bytes' if of_page == of_program else f'numbers by {worst:.0e}'}")
    for ending, option, begin in [(".glb", "-o", b"glTF")]:
        of_page = saved(browser, file, ending)
        of_program = written(program, folder, file, ending, option)
        check(of_page.startswith(begin) and len(of_page) == len(of_program), f"{ending}: {len(of_page)} bytes as there")
    report = saved(browser, file, "_report.json")
    check(b'"seconds"' in report, "_report.json")
    without_data = [re.sub(rb'\["[fud]", ?"[^"]*"\]', b"", page)
                    for page in (saved(browser, file, ".html"), written(program, folder, file, ".html", "-o"))]
    check(without_data[0] == without_data[1], ".html: the same bytes, arrays of numbers left out")


def check_messages(browser, folder, good):
    bad = folder / "bad.off"
    bad.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 nonsense 0\n3 0 1 2\n", encoding="utf-8")
    text = open_file(browser, bad)
    check(browser.evaluate("cscd.state") == "failed" and text.startswith("bad.off"), f"refused: {text}")
    open_file(browser, good, by_drop=True)
    check(browser.evaluate("cscd.state") == "done", "the next file is dropped, and computed")
    flat = folder / "curve.xyz"
    flat.write_text("".join(f"{i} {i % 7 / 100} 0\n" for i in range(300)), encoding="utf-8")
    open_file(browser, flat)
    browser.evaluate("document.getElementById('format').value = '.glb'; document.getElementById('save').click()")
    browser.wait_for("document.getElementById('status').classList.contains('error')")
    text = browser.evaluate("document.getElementById('status').textContent")
    check("surface" in text and len(saved(browser, flat, ".graph")) > 0, f"no rig, but a graph of a curve: {text}")
    refused = browser.evaluate("fetch('data:,text').then(() => false, () => true)")
    check(refused, "access to the network is refused")


def main():
    program, page, data, folder = sys.argv[1:]
    if not chromium.is_installed():
        print("skipped: Chromium was not found")
        sys.exit(SKIPPED)
    if not pathlib.Path(page).is_file():
        print("skipped: examples/web/build.sh has not made the page")
        sys.exit(SKIPPED)
    page, data, folder = map(pathlib.Path, (page, data, folder))
    folder.mkdir(parents=True, exist_ok=True)
    module = base64.b64decode(re.search(r'id="wasm">([^<]*)<', page.read_text(encoding="utf-8")).group(1))
    check(len(module) <= MAX_MODULE_SIZE, f"WebAssembly of {len(module):,} bytes")
    with chromium.Chromium(folder, 640, 420) as browser:
        browser.open(page)
        for name in MESHES:
            mesh = data / "meshes" / (name + ".off")
            open_file(browser, mesh)
            check_skeleton(browser, program, folder, mesh)
        points = data / "points_3/kitten.xyz"
        open_file(browser, points)
        check_skeleton(browser, program, folder, points)
        mesh = data / "meshes/elephant.off"
        open_file(browser, mesh)
        check_formats(browser, program, folder, mesh)
        browser.evaluate("""cscd.state = 'waiting';
          document.getElementById('detail').value = 0.1;
          document.getElementById('detail').dispatchEvent(new Event('change'))""")
        browser.wait_for("cscd.state === 'done'", 300)
        check_skeleton(browser, program, folder, mesh, "--detail", "0.1")
        errors = browser.evaluate("cscd.errors")
        check(not errors, f"errors in the page: {errors}")
        check_messages(browser, folder, mesh)


main()
