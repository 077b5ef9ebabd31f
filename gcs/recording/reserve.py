"""Room on the disk for a session's last words: what it amounts to must be written also where the disk is full."""

from __future__ import annotations

import contextlib
import errno
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol

FULL = (errno.ENOSPC, errno.EDQUOT)
PER_SESSION_BYTES = 1 << 16
PER_VEHICLE_BYTES = 1 << 11
"""A vehicle takes about 500 bytes of summary.json."""
PER_SERVICE_BYTES, PER_BID_BYTES = 512, 48
"""A refuelling takes up to 400 bytes of it, each of its bids 40."""
STEP_BYTES = 1 << 14
"""The room grows by so much at least."""


class Refuelling(Protocol):
    """As far as its length in the summary depends on it."""

    @property
    def bids(self) -> Mapping[int, Any]: ...


class Reserve:
    """Reserved disk space of `folder`, in a file without a name: it is free again when this process ends, however.

    Raises OSError where the disk is too full for even that. A file system that cannot reserve is done without.
    """

    def __init__(self, folder: Path, vehicles: int) -> None:
        self._fd = -1
        self._folder = folder
        self._services = 0
        self._fixed_bytes = self._bytes = PER_SESSION_BYTES + vehicles * PER_VEHICLE_BYTES
        path = folder / f".reserve.{os.getpid()}"
        try:
            self._fd = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o600)
            path.unlink()
            os.posix_fallocate(self._fd, 0, self._bytes)
        except OSError as error:
            self.release()
            self._refuse_if_full(error)

    def keep_for(self, services: Sequence[Refuelling]) -> None:
        """Keep room for these refuellings too, which are all until now; costs nothing where there is no new one.

        Raises OSError where the disk is too full for that; what was kept until then stays.
        """
        if len(services) == self._services or self._fd < 0:
            return
        self._services = len(services)
        services_bytes = sum(PER_SERVICE_BYTES + PER_BID_BYTES * len(service.bids) for service in services)
        if self._fixed_bytes + services_bytes > self._bytes:
            self._bytes = self._fixed_bytes + services_bytes + STEP_BYTES
            try:
                os.posix_fallocate(self._fd, 0, self._bytes)
            except OSError as error:
                self._refuse_if_full(error)

    def release(self) -> None:
        """Let it be written on; a second call does nothing."""
        if self._fd >= 0:
            with contextlib.suppress(OSError):
                os.close(self._fd)
            self._fd = -1

    def _refuse_if_full(self, error: OSError) -> None:
        if error.errno in FULL:
            raise OSError(error.errno, error.strerror, str(self._folder)) from None
