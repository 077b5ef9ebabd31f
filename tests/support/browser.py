"""Headless Chromium, spoken to in its DevTools protocol over a pair of pipes: nothing to install beside it.

https://chromedevtools.github.io/devtools-protocol; `--remote-debugging-pipe` reads commands on descriptor 3 and writes
answers and events on 4, JSON ended by a NUL.
"""

from __future__ import annotations

import base64
import io
import json
import os
import select
import shutil
import signal
import subprocess
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from patience import PATIENCE_S
from PIL import Image

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
MISSING = "Chromium is not installed (Debian: apt-get install chromium)"
FLAGS = (
    "--headless=new",
    "--no-sandbox",  # tests run as root in CI
    "--remote-debugging-pipe",
    "--no-first-run",
    "--disable-extensions",
    "--disable-background-networking",
    "--disable-dev-shm-usage",
    "--enable-unsafe-swiftshader",  # WebGL without a graphics card
    "--hide-scrollbars",
)


DRAWN = """new Promise((done) => {
  const stages = document.documentElement.dataset;
  const look = () => (stages.all ? done({...stages}) : setTimeout(look, 20));
  look();
})"""


class Browser:
    """One browser with one page; `events` are all that it has told of the page.

    A watched page tells of its requests, errors and logs, and is the slower for it: for every error that a script only
    makes, V8 then works out the places in its source.
    """

    def __init__(self, *, watched: bool = True) -> None:
        self._domains = ("Page", "Runtime", "Network", "Log") if watched else ("Page",)

    def __enter__(self) -> Self:
        assert CHROMIUM, MISSING
        self._profile = tempfile.TemporaryDirectory(prefix="skytender-chromium-", ignore_cleanup_errors=True)
        theirs_in, self._out = os.pipe()
        self._in, theirs_out = os.pipe()
        # By bash: other shells know no descriptors above 9.
        pipes = f"3<&{theirs_in} 4>&{theirs_out}"
        self._process = subprocess.Popen(
            ["bash", "-c", f'exec "$@" {pipes}', "bash", CHROMIUM, *FLAGS, f"--user-data-dir={self._profile.name}"],
            pass_fds=(theirs_in, theirs_out),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
        os.close(theirs_in)
        os.close(theirs_out)
        self.events: list[dict[str, Any]] = []
        self._read = b""
        self._number = 0
        self._session: str | None = None
        try:
            target = self.call("Target.createTarget", url="about:blank")["targetId"]
            self._session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
            for domain in self._domains:
                self.call(f"{domain}.enable")
        except BaseException:
            self.__exit__(None, None, None)
            raise
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        os.close(self._out)  # it ends with its pipe
        try:
            self._process.wait(timeout=5)
        except subprocess.TimeoutExpired:
            os.killpg(self._process.pid, signal.SIGKILL)
            self._process.wait()
        os.close(self._in)
        self._profile.cleanup()

    def call(self, method: str, **params: Any) -> dict[str, Any]:
        """A command's result."""
        self._number += 1
        message: dict[str, Any] = {"id": self._number, "method": method, "params": params}
        if self._session is not None:
            message["sessionId"] = self._session
        os.write(self._out, json.dumps(message).encode() + b"\0")
        number = self._number
        answer = self._take(lambda told: told.get("id") == number)
        assert "error" not in answer, f"{method}: {answer['error']}"
        result: dict[str, Any] = answer["result"]
        return result

    def wait_for(self, method: str) -> dict[str, Any]:
        """The next event of that name."""
        return self._take(lambda told: told.get("method") == method)

    def _take(self, wanted: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
        deadline_s = time.monotonic() + PATIENCE_S
        while True:
            line, end, rest = self._read.partition(b"\0")
            if not end:
                left_s = deadline_s - time.monotonic()
                assert left_s > 0.0, "the browser fell silent"
                if select.select([self._in], [], [], left_s)[0]:
                    more = os.read(self._in, 1 << 20)
                    assert more, "the browser has ended"
                    self._read += more
                continue
            self._read = rest
            told: dict[str, Any] = json.loads(line)
            if "method" in told:
                self.events.append(told)
            if wanted(told):
                return told

    def open(self, page: Path, width: int = 1280, height: int = 900, *, dark: bool = False) -> None:
        """Open a file and wait until it is loaded; `events` begins anew."""
        self.call(
            "Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 600
        )
        feature = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
        self.call("Emulation.setEmulatedMedia", features=[feature])
        self.events.clear()
        self.call("Page.navigate", url=page.resolve().as_uri())
        self.wait_for("Page.loadEventFired")

    def drawn(self) -> dict[str, float]:
        """Waits until a report's figures are drawn; when each stage was there, in ms since the page was asked for."""
        told: dict[str, str] = self.evaluate(DRAWN)
        return {stage: float(ms) for stage, ms in told.items()}

    def evaluate(self, expression: str) -> Any:
        """The value of a JavaScript expression, awaited where it is a promise."""
        told = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        assert "exceptionDetails" not in told, told["exceptionDetails"]
        return told["result"].get("value")

    def picture_of(self, box: dict[str, float]) -> Image.Image:
        """A part of the page, in CSS pixels from its top left corner."""
        told = self.call("Page.captureScreenshot", format="png", captureBeyondViewport=True, clip={**box, "scale": 1})
        return Image.open(io.BytesIO(base64.b64decode(told["data"])))

    def picture(self, to: Path, *, whole: bool = True) -> None:
        """A PNG of the page."""
        told = self.call("Page.captureScreenshot", format="png", captureBeyondViewport=whole, **self._clip(whole))
        to.write_bytes(base64.b64decode(told["data"]))

    def _clip(self, whole: bool) -> dict[str, Any]:
        if not whole:
            return {}
        size = self.call("Page.getLayoutMetrics")["cssContentSize"]
        return {"clip": {"x": 0, "y": 0, "width": size["width"], "height": size["height"], "scale": 1}}

    def pdf(self) -> bytes:
        """The page as it is printed."""
        return base64.b64decode(self.call("Page.printToPDF", preferCSSPageSize=True, printBackground=True)["data"])
