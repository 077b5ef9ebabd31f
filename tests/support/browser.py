"""Headless Chromium for measurements, spoken to in its DevTools protocol over a pair of pipes.

https://chromedevtools.github.io/devtools-protocol; `--remote-debugging-pipe` reads commands on descriptor 3 and writes
answers and events on 4, JSON ended by a NUL.
"""

from __future__ import annotations

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
    """One browser with one page that tells of no errors: V8 would work out the places of each in its source."""

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
        self._read = b""
        self._number = 0
        self._session: str | None = None
        try:
            target = self.call("Target.createTarget", url="about:blank")["targetId"]
            self._session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
            self.call("Page.enable")
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
            if wanted(told):
                return told

    def open(self, page: Path) -> None:
        """Open a file and wait until it is loaded."""
        self.call("Emulation.setDeviceMetricsOverride", width=1280, height=900, deviceScaleFactor=1, mobile=False)
        self.call("Page.navigate", url=page.resolve().as_uri())
        self._take(lambda told: told.get("method") == "Page.loadEventFired")

    def drawn(self) -> dict[str, float]:
        """Waits until a report's figures are drawn; when each stage was there, in ms since the page was asked for."""
        told = self.call("Runtime.evaluate", expression=DRAWN, awaitPromise=True, returnByValue=True)
        assert "exceptionDetails" not in told, told["exceptionDetails"]
        return {stage: float(ms) for stage, ms in told["result"]["value"].items()}
