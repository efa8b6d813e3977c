# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Headless Chromium, driven as a user would: files chosen, buttons clicked, fingers moved, downloads read from disk.
# Commands go through a pipe, so that Chromium is the only required package.

import fcntl
import json
import os
import select
import shutil
import subprocess
import time

NAMES = ["chromium", "chromium-browser", "google-chrome"]


def is_installed():
    return any(map(shutil.which, NAMES))


class Chromium:
    """A browser with one page. Downloads go to the folder `downloads`."""

    def __init__(self, folder, width=900, height=600):
        self.downloads = folder / "downloads"
        shutil.rmtree(self.downloads, ignore_errors=True)
        self.downloads.mkdir(parents=True)
        to_read, self._commands = os.pipe()
        self._answers, to_write = os.pipe()
        ends = [fcntl.fcntl(file, fcntl.F_DUPFD, 10) for file in (to_read, to_write)]  # clear of 3 and 4
        os.close(to_read)
        os.close(to_write)
        browser = next(filter(None, map(shutil.which, NAMES)))
        # Graphics in software, so that it runs without display and graphics card; network services are off. The
        # browser reads commands from file 3 and writes answers to file 4.
        options = ["--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                   "--ignore-gpu-blocklist", "--no-first-run", "--disable-background-networking",
                   "--disable-component-update", "--disable-sync", "--disable-quic", "--disable-dev-shm-usage",
                   f"--window-size={width},{height}", f"--user-data-dir={folder / 'profile'}",
                   "--remote-debugging-pipe", "about:blank"]
        self._process = subprocess.Popen(
            ["bash", "-c", f'exec "$@" 3<&{ends[0]} 4>&{ends[1]} {ends[0]}<&- {ends[1]}>&-', "bash", browser, *options],
            pass_fds=ends, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for end in ends:
            os.close(end)
        self._buffer = b""
        self._number = 0
        self._session = None
        targets = self.call("Target.getTargets")["targetInfos"]
        page = next(target["targetId"] for target in targets if target["type"] == "page")
        self.call("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(self.downloads.resolve()))
        self._session = self.call("Target.attachToTarget", targetId=page, flatten=True)["sessionId"]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self._commands)  # the browser ends
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        os.close(self._answers)

    def _next_message(self, deadline):
        while b"\0" not in self._buffer:
            is_ready, _, _ = select.select([self._answers], [], [], max(0, deadline - time.monotonic()))
            block = os.read(self._answers, 1 << 20) if is_ready else b""
            if not block:
                raise TimeoutError("the browser gives no answer")
            self._buffer += block
        message, self._buffer = self._buffer.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, timeout=60, **parameters):
        """The answer to a command of the DevTools protocol. Events are passed over."""
        self._number += 1
        command = {"id": self._number, "method": method, "params": parameters}
        if self._session:
            command["sessionId"] = self._session
        os.write(self._commands, json.dumps(command).encode() + b"\0")
        deadline = time.monotonic() + timeout
        while True:
            message = self._next_message(deadline)
            if message.get("id") == self._number:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']['message']}")
                return message["result"]

    def open(self, page):
        self.call("Page.navigate", url=page.resolve().as_uri())
        self.wait_for("document.readyState === 'complete'")

    def evaluate(self, expression):
        answer = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def wait_for(self, expression, timeout=60):
        deadline = time.monotonic() + timeout
        while not self.evaluate(expression):
            if time.monotonic() > deadline:
                raise TimeoutError(expression)
            time.sleep(0.05)

    def choose_file(self, selector, file):
        """Chooses `file` in an input element for files."""
        root = self.call("DOM.getDocument")["root"]["nodeId"]
        node = self.call("DOM.querySelector", nodeId=root, selector=selector)["nodeId"]
        self.call("DOM.setFileInputFiles", files=[str(file.resolve())], nodeId=node)

    def touch(self, kind, *fingers):
        """`kind` is touchStart, touchMove or touchEnd; `fingers` are where they are, in pixels."""
        self.call("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": y} for x, y in fingers])

    def downloaded(self, name, timeout=60):
        """The content of the download `name`, which must not be empty. The file is removed."""
        file = self.downloads / name
        deadline = time.monotonic() + timeout
        # The browser makes an empty file of this name, and then renames the complete download to it.
        while not file.exists() or file.stat().st_size == 0:
            if time.monotonic() > deadline:
                raise TimeoutError(f"{name} was not downloaded; there is {os.listdir(self.downloads)}")
            time.sleep(0.05)
        content = file.read_bytes()
        file.unlink()
        return content
