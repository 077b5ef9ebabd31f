"""A serial device as a link: a cable to an autopilot, or a telemetry radio with a fleet behind it."""

from __future__ import annotations

import contextlib
import errno
import glob
import select
import time

import serial

from gcs.link.connection import RETRY_S, ByteStream, StreamConnection
from gcs.link.socket import AddressRefused
from gcs.scenario.endpoint import Endpoint

_USUAL = ("/dev/ttyUSB*", "/dev/ttyACM*", "/dev/ttyAMA*", "/dev/ttyTHS*")
_BUSY = frozenset({errno.EBUSY, errno.EAGAIN, errno.EWOULDBLOCK})


class SerialConnection(StreamConnection):
    """One device, opened again when it has gone and come back. See `Channel` for the methods."""

    def __init__(self, at: Endpoint) -> None:
        """A device that is not there may be plugged in later; raises AddressRefused where trying again is no use."""
        super().__init__(at)
        self.to = (at.host, at.port)
        self._retry_s = 0.0
        refusal = self._open(time.monotonic())
        if refusal is not None and refusal != errno.ENOENT:
            self.close()
            raise AddressRefused(f"{at.text} cannot be opened: {self.problem}")

    def tend(self, now_s: float) -> None:
        super().tend(now_s)
        if not self._streams and now_s >= self._retry_s:
            self._open(now_s)

    def _open(self, now_s: float) -> int | None:
        """Open the device; the system's number of what went wrong, -1 without one, None where nothing did."""
        self._retry_s = now_s + RETRY_S
        try:
            device = serial.Serial(self.at.host, self.at.port, timeout=0, write_timeout=0, exclusive=True)
            device.reset_input_buffer()  # bytes from before the device was opened are old
        except (OSError, ValueError, NotImplementedError) as error:
            number = getattr(error, "errno", None)
            self.problem = _advice(self.at, number, error)
            return -1 if number is None else number
        self.problem = ""
        assert self.to is not None
        self._add(self.to, ByteStream(device.fileno(), device.close, lambda: _is_there(device.fileno())))
        return None

    def _ended(self, why: str) -> None:
        self.problem = "the device is gone: is the radio still plugged in, and has it power?"
        self._retry_s = time.monotonic() + RETRY_S


def _is_there(descriptor: int) -> bool:
    """Whether a device that has nothing to read is there still."""
    poll = select.poll()
    poll.register(descriptor, 0)
    return not poll.poll(0)


def _advice(at: Endpoint, number: int | None, error: Exception) -> str:
    """Why a device cannot be opened, and what to do."""
    if number == errno.ENOENT:
        there = sorted(name for pattern in _USUAL for name in glob.glob(pattern))
        others = f"there are {', '.join(there)}" if there else "no radio or autopilot is plugged in"
        return f"there is no device {at.host}; {others}"
    if number == errno.EACCES:
        return "you may not use it: join its group, mostly by `sudo usermod -aG dialout $USER`, and log in again"
    if number in _BUSY:
        return "another program has it open: end that, or let it forward to a UDP port"
    if "baud" in str(error).lower() or isinstance(error, ValueError):
        return f"it has no rate of {at.port} baud; common rates are 57600 (radios) and 115200 (USB)"
    with contextlib.suppress(IndexError):
        return f"it is no serial device ({str(error).splitlines()[0]})"
    return "it is no serial device"
