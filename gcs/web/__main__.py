"""The page's server as a process of its own: `python -m gcs.web FOLDER PARENT [TILES]`, started by `gcs run --web`.

It tells its links on standard output, as one line of JSON, and ends with the session, or with who started it.
"""

from __future__ import annotations

import contextlib
import ctypes
import json
import os
import signal
import sys
from pathlib import Path

from gcs.session.client import SessionSource
from gcs.web.serve import serve

PR_SET_PDEATHSIG = 1


def main(words: list[str]) -> int:
    """Serve the session in the folder that the first word names; the second is our parent, the third the tiles'."""
    folder, parent, *tiles = words
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM)
    if os.getppid() != int(parent):
        return 0
    with contextlib.suppress(KeyboardInterrupt):
        serve(SessionSource(Path(folder)), lambda links: print(json.dumps(links), flush=True), *tiles)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
