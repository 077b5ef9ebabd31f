"""The console as a process of its own: `python -m gcs.console FOLDER`, started by `gcs run` in its terminal.

It ends by itself when the session does, when its person closes it, and when the process that started it is gone.
"""

# ruff: noqa: PLC0415 - the signals are to be settled before anything that takes time

from __future__ import annotations

import signal
import sys
from pathlib import Path

from skytender.processes import end_with


def main(words: list[str]) -> int:
    """Show the session in the folder that the first word names; the second one is its title, the third our parent."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is a key of the console
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
    folder, title, parent = words
    end_with(int(parent), signal.SIGTERM)
    from gcs.console.app import show
    from gcs.session.client import SessionSource

    return show(SessionSource(Path(folder)), title, owner=True)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
