"""The program `gcs` from its first line: nothing is loaded before a Ctrl-C can end it without a traceback."""

from __future__ import annotations

import os
import signal
import sys

from skytender.exit import INTERRUPTED, Terminated
from skytender.loading import uncollected

AGAIN_S = 0.02
TYPE_CHECKING = False

if TYPE_CHECKING:
    from sys import UnraisableHookArgs


def main() -> None:
    """Entry point. While modules are loaded there is nothing to clean up: a Ctrl-C ends the process at once."""
    handler = signal.getsignal(signal.SIGINT)
    if handler is signal.default_int_handler:  # else the caller ignores it, as nohup does
        signal.signal(signal.SIGINT, lambda *_: os._exit(INTERRUPTED))
    with uncollected(for_good=True):
        from gcs.cli.main import main as command_line  # noqa: PLC0415 - what takes long

    sys.unraisablehook = raise_again
    signal.signal(signal.SIGINT, handler)
    command_line()


def raise_again(lost: UnraisableHookArgs) -> None:
    """A hook: a Ctrl-C or the like in a callback of compiled code, which nothing can be raised through, comes again
    after it."""
    if isinstance(lost.exc_value, Terminated):
        number = lost.exc_value.number
    elif lost.exc_type is KeyboardInterrupt:
        number = signal.SIGINT
    else:
        sys.__unraisablehook__(lost)
        return
    import threading  # noqa: PLC0415 - what takes long

    later = threading.Timer(AGAIN_S, signal.pthread_kill, (threading.main_thread().ident, number))
    later.daemon = True
    later.start()


if __name__ == "__main__":
    main()
