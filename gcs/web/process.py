"""The page's server beside a session that is flown: a process of its own, so that the flight owes it nothing."""

from __future__ import annotations

import contextlib
import json
import os
import select
import subprocess
import sys
from pathlib import Path
from typing import Self

from gcs.processes.forked import await_end

STARTS_WITHIN_S = 30.0
ENDS_WITHIN_S = 3.0


class PageServer:
    """Serves the session of `folder`, which need not fly yet; ends with its context. `links` is empty if it failed."""

    def __init__(self, folder: Path, tiles: str | None = None) -> None:
        self._words = [str(folder), str(os.getpid()), *([] if tiles is None else [tiles])]
        self.links: dict[str, str] = {}

    def __enter__(self) -> Self:
        self._process = subprocess.Popen(
            [sys.executable, "-m", "gcs.web", *self._words],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            start_new_session=True,  # Ctrl-C is for the session, whose last lines the page still shows
        )
        out = self._process.stdout
        assert out is not None
        if select.select([out], [], [], STARTS_WITHIN_S)[0]:
            with contextlib.suppress(ValueError):
                self.links = dict(json.loads(out.readline()))
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        if kind is None:  # its pages are told how the session ended, and it ends by itself
            with contextlib.suppress(subprocess.TimeoutExpired):
                self._process.wait(ENDS_WITHIN_S)
        self._process.terminate()
        await_end(self._process, ENDS_WITHIN_S)
        if self._process.stdout is not None:
            self._process.stdout.close()
