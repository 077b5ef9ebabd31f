"""Room on the disk for a session's last words: what it amounts to must be written also where the disk is full."""

from __future__ import annotations

import contextlib
import errno
import os
from pathlib import Path

FULL = (errno.ENOSPC, errno.EDQUOT)
PER_SESSION_BYTES = 1 << 16
PER_VEHICLE_BYTES = 1 << 11
"""A vehicle takes about 500 bytes of summary.json, each refuelling 250."""


class Reserve:
    """Reserved disk space of `folder`, in a file without a name: it is free again when this process ends, however.

    Raises OSError where the disk is too full for even that. A file system that cannot reserve is done without.
    """

    def __init__(self, folder: Path, vehicles: int) -> None:
        self._fd = -1
        path = folder / f".reserve.{os.getpid()}"
        try:
            self._fd = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o600)
            path.unlink()
            os.posix_fallocate(self._fd, 0, PER_SESSION_BYTES + vehicles * PER_VEHICLE_BYTES)
        except OSError as error:
            self.release()
            if error.errno in FULL:
                raise OSError(error.errno, error.strerror, str(folder)) from None

    def release(self) -> None:
        """Let it be written on; a second call does nothing."""
        if self._fd >= 0:
            with contextlib.suppress(OSError):
                os.close(self._fd)
            self._fd = -1
