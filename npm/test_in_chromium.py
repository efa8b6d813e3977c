# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Usage: test_in_chromium.py FOLDER
# Runs the example with three.js in headless Chromium. FOLDER holds node_modules with the packages cscd and three.

import base64
import functools
import http.server
import pathlib
import sys
import threading

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "test/page"))
import chromium  # noqa: E402


class Handler(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        """Says nothing."""


def main():
    folder = pathlib.Path(sys.argv[1])
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Handler, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with chromium.Chromium(folder) as browser:
        url = f"http://127.0.0.1:{server.server_port}/node_modules/cscd/examples/three.html"
        browser.call("Page.navigate", url=url)
        browser.wait_for("Boolean(window.skeleton)", 120)
        text = browser.evaluate("document.getElementById('status').textContent")
        assert text.endswith(" nodes, 1 cycle"), f"three.js: {text}"
        browser.wait_for("Boolean(document.querySelector('canvas'))")
        assert browser.evaluate("skeleton.nodes instanceof Float64Array"), "typed arrays"
        refused = browser.evaluate("import('cscd').then(m => m.skeletonize([], null, {detail: 2})).catch(e => e.message)")
        assert refused == "detail: must be a number from 0 to 1, not 2", f"refused: {refused}"
        aborted = browser.evaluate("""import('cscd').then(m => {
            const control = new AbortController();
            return m.skeletonize(skeleton.nodes, null, {signal: control.signal, onProgress: () => control.abort()});
        }).catch(e => e.name)""")
        assert aborted == "AbortError", f"aborted: {aborted}"
        picture = base64.b64decode(browser.call("Page.captureScreenshot")["data"])
        (folder / "three.png").write_bytes(picture)


main()
