"""Files that forks of this process do not keep: at their other end they say when this process ends."""

from __future__ import annotations

import os
import socket
import weakref
from typing import IO

_files: weakref.WeakSet[socket.socket | IO[bytes]] = weakref.WeakSet()


def close_in_forks(*files: socket.socket | IO[bytes]) -> None:
    """Close these in each process that is forked from now on, as multiprocessing does, for as long as they exist."""
    _files.update(files)


def _close() -> None:
    for file in list(_files):
        file.close()


os.register_at_fork(after_in_child=_close)
