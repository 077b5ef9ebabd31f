"""The page's server as a process of its own: `python -m gcs.web FOLDER PARENT [TILES]`, started by `gcs run --web`.

It tells its links on standard output, as one line of JSON. It ends with its parent, and with the session, whose end it
learns from the session or by the end of standard input, where no page was opened; else it stays, says so by a second
line, and shows the session's report.
"""

from __future__ import annotations

import contextlib
import json
import signal
import sys
from pathlib import Path

from gcs.session.client import SessionSource
from gcs.web.document import REPORT_FILE
from gcs.web.serve import serve
from skytender.processes import end_with


def main(words: list[str]) -> int:
    """Serve the session in the folder that the first word names; the second is our parent, the third the tiles'."""
    folder, parent, *tiles = words
    end_with(int(parent), signal.SIGTERM)
    with contextlib.suppress(KeyboardInterrupt):
        serve(
            SessionSource(Path(folder)),
            lambda links: print(json.dumps(links), flush=True),
            tiles[0] if tiles else None,
            Path(folder) / REPORT_FILE,
            over=0,
            stays=lambda: print(json.dumps({"stays": True}), flush=True),
        )
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
