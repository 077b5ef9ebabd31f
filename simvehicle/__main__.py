"""The program `simvehicle` from its first line: nothing is loaded before a Ctrl-C can end it without a traceback."""

from __future__ import annotations

import os
import signal

from skytender.exit import INTERRUPTED
from skytender.loading import uncollected


def main() -> None:
    """Entry point. While modules are loaded there is nothing to clean up: a Ctrl-C ends the process at once."""
    handler = signal.getsignal(signal.SIGINT)
    if handler is signal.default_int_handler:  # else the caller ignores it, as nohup does
        signal.signal(signal.SIGINT, lambda *_: os._exit(INTERRUPTED))
    with uncollected(for_good=True):
        from simvehicle import cli  # noqa: PLC0415 - what takes long

    signal.signal(signal.SIGINT, handler)
    cli.main()


if __name__ == "__main__":
    main()
