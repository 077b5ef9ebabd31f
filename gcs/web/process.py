"""The page's server beside a session that is flown: a process of its own, so that the flight owes it nothing."""

from __future__ import annotations

import contextlib
import json
import os
import select
import subprocess
from collections.abc import Iterator
from pathlib import Path

from gcs.processes.forked import end
from gcs.processes.python import start_python

STARTS_WITHIN_S = 30.0
ENDS_WITHIN_S = 3.0


@contextlib.contextmanager
def page_server(folder: Path, tiles: str | None = None) -> Iterator[dict[str, str]]:
    """Serve the session of `folder`, which need not fly yet, in this context; its links, none if that failed."""
    process = start_python(
        "gcs.web",
        *(str(folder), str(os.getpid()), *([] if tiles is None else [tiles])),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        start_new_session=True,  # Ctrl-C is for the session, whose last lines the page still shows
    )
    out, links = process.stdout, {}
    assert out is not None
    try:
        if select.select([out], [], [], STARTS_WITHIN_S)[0]:
            with contextlib.suppress(ValueError):
                links = dict(json.loads(out.readline()))
        yield links
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(ENDS_WITHIN_S)  # its pages learn how the session ended, and it ends by itself
    finally:
        process.terminate()
        end(process, ENDS_WITHIN_S)
        out.close()
