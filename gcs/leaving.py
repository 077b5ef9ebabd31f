"""How a program of ours ends once all is done: at once, and undisturbed.

Python takes up to a second to tear down what the compiled code and the report have loaded. A Ctrl-C in that second
would end the process by the signal, or with a traceback, though everything is written.
"""

from __future__ import annotations

import errno
import os
import signal
import sys
from typing import NoReturn

from gcs.exit import NOT_DONE


def leave(status: int) -> NoReturn:
    """End the process with this status, its streams flushed.

    A reader that has gone is no error; what cannot be written for another reason turns success into NOT_DONE.
    """
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)
    for stream in (sys.stdout, sys.stderr):
        if stream is None:  # closed before the program began
            continue
        try:
            stream.flush()
        except OSError as error:
            if error.errno != errno.EPIPE:
                status = status or NOT_DONE
                os.write(2, f"{stream.name} cannot be written: {error.strerror}\n".encode())
        except (ValueError, RuntimeError):  # closed, or a signal's handler has broken into a write that waits
            pass
    os._exit(status)
