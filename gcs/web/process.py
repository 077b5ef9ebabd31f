"""The page's server beside a session that is flown: a process of its own, so that the flight owes it nothing."""

from __future__ import annotations

import contextlib
import json
import os
import select
import subprocess
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from gcs.processes.forked import end
from gcs.processes.python import start_python

STARTS_WITHIN_S = 30.0
ENDS_WITHIN_S = 3.0


class PageServer:
    """The process and its links; none where it could not be started."""

    def __init__(self, process: subprocess.Popen[bytes], links: Mapping[str, str]) -> None:
        self.links = links
        self._process = process

    def stay(self, staying: Callable[[], object]) -> None:
        """After the session's end: until Ctrl-C where a page was opened, after a call of `staying`; else not at all."""
        process = self._process
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.close()  # so it learns of the end
        with contextlib.suppress(KeyboardInterrupt):
            if process.stdout.readline():  # nothing where it ends because no page was opened
                staying()
                process.wait()
        process.terminate()


@contextlib.contextmanager
def page_server(folder: Path, tiles: str | None = None) -> Iterator[PageServer]:
    """Serve the session of `folder`, which need not fly yet, in this context."""
    process = start_python(
        "gcs.web",
        *(str(folder), str(os.getpid()), *([] if tiles is None else [tiles])),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        start_new_session=True,  # Ctrl-C is for the session, whose last lines the page still shows
    )
    out, links = process.stdout, {}
    assert out is not None
    assert process.stdin is not None
    try:
        if select.select([out], [], [], STARTS_WITHIN_S)[0]:
            with contextlib.suppress(ValueError):
                links = dict(json.loads(out.readline()))
        yield PageServer(process, links)
        process.stdin.close()
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(ENDS_WITHIN_S)  # its pages learn how the session ended
    finally:
        process.terminate()
        process.stdin.close()
        end(process, ENDS_WITHIN_S)
        out.close()
