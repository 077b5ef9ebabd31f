"""The two sockets to an ArduPilot that this process has started: its simulation's, and its serial port; and its end,
as one sentence."""

from __future__ import annotations

import contextlib
import socket
import struct
import subprocess
import time
from typing import Any, Self

from pymavlink.dialects.v20 import common as mav

from simvehicle.mavlink import json_backend
from simvehicle.mavlink.codec import CHECKSUM_BYTES, HEADER_BYTES, MAGIC, ReceivedFrame, split
from simvehicle.sitl.autopilot_process import (
    APART,
    HOST,
    SERIAL_PORT,
    AutopilotError,
    AutopilotWanted,
    end,
    simulation_port,
    start,
)

READY_WITHIN_S = 20.0
LOOK_EVERY_S = 0.5
SERIAL_BYTES = 65536
SERVO_BYTES = 2048
LAST_LINES = 5


class AutopilotLink:
    """An autopilot's process with its sockets. Everything raises AutopilotError once it is gone."""

    def __init__(self, wanted: AutopilotWanted) -> None:
        """Start it, and wait for its first servo packet."""
        self._wanted = wanted
        self._serial_pending = b""
        self._peer: Any = None
        with contextlib.ExitStack() as opened:
            self._udp, instance = simulation_port()
            opened.callback(self._udp.close)
            self._udp.setsockopt(socket.SOL_SOCKET, socket.SO_RCVTIMEO, _time_of(LOOK_EVERY_S))
            self._process = start(wanted, instance)
            opened.callback(end, self._process)
            self._serial = self._connect(SERIAL_PORT + APART * instance)
            opened.callback(self._serial.close)
            self.servo = self._next_servo(-1)
            self._closing = opened.pop_all()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._closing.close()

    @property
    def name(self) -> str:
        """The autopilot, for a sentence."""
        return f"the autopilot {self._wanted.program}"

    def say(self, raw: bytes) -> None:
        """Say bytes into its serial port: it reads them right after the next answer."""
        try:
            self._serial.sendall(raw)
        except OSError as error:
            raise self._gone() from error

    def answer(self, line: bytes) -> None:
        """Answer its servo packet and wait for the next, `servo`."""
        try:
            self._udp.sendto(line, self._peer)
        except OSError as error:
            raise self._gone() from error
        self.servo = self._next_servo(self.servo.frame)

    def received(self) -> list[ReceivedFrame]:
        """Frames that have come through its serial port: all that it said before its servo packet."""
        try:
            while True:
                chunk = self._serial.recv(SERIAL_BYTES)
                if not chunk:
                    raise self._gone()
                self._serial_pending += chunk
        except BlockingIOError:
            pass
        except ConnectionError as error:
            raise self._gone() from error
        if not self._serial_pending:
            return []
        whole, self._serial_pending = _whole(self._serial_pending)
        mine = (self._wanted.sysid, mav.MAV_COMP_ID_AUTOPILOT1)
        return [frame for frame in split(whole) if frame[:2] == mine]

    def last_lines(self) -> str:
        """Last lines of its log, each once, to end a sentence."""
        try:
            lines = (self._wanted.folder / "autopilot.log").read_text(encoding="utf-8", errors="replace").splitlines()
        except OSError:
            lines = []
        last = list(dict.fromkeys(line.strip() for line in lines if line.strip()))[-LAST_LINES:]
        return f"; its last lines: {' | '.join(last)}" if last else ", and said nothing"

    def _next_servo(self, last_frame: int) -> json_backend.ServoPacket:
        """The next servo packet; what it repeats is passed over. A session may stand still: it waits while it lives."""
        deadline_s = time.monotonic() + READY_WITHIN_S if last_frame < 0 else None
        while True:
            try:
                datagram, self._peer = self._udp.recvfrom(SERVO_BYTES)
            except BlockingIOError:  # the socket's own time-out, which costs no call of its own
                self._look()
                if deadline_s is not None and time.monotonic() > deadline_s:
                    late = f"{self.name} said nothing to its simulation within {READY_WITHIN_S:.0f} s"
                    raise AutopilotError(late + self.last_lines()) from None
                continue
            packet = json_backend.parse(datagram)
            if packet is not None and packet.frame != last_frame:
                return packet

    def _connect(self, port: int) -> socket.socket:
        """Its serial port, which listens soon after its start."""
        deadline_s = time.monotonic() + READY_WITHIN_S
        while True:
            self._look()
            try:
                made = socket.create_connection((HOST, port), timeout=LOOK_EVERY_S)
                made.setblocking(False)
                made.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                return made
            except OSError as error:
                if time.monotonic() > deadline_s:
                    late = f"{self.name} opened no port {port} in {READY_WITHIN_S:.0f} s"
                    raise AutopilotError(late + self.last_lines()) from error
                time.sleep(0.01)

    def _look(self) -> None:
        if self._process.poll() is not None:
            raise self._gone()

    def _gone(self) -> AutopilotError:
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(LOOK_EVERY_S)
        status = self._process.poll()
        how = "has closed its connection" if status is None else f"ended with status {status}"
        if status is not None and status < 0:
            how = f"was killed by signal {-status}"
        return AutopilotError(f"{self.name} {how}{self.last_lines()}")


def _time_of(seconds: float) -> bytes:
    """A `struct timeval`."""
    whole = int(seconds)
    return struct.pack("ll", whole, round(1e6 * (seconds - whole)))


def _whole(content: bytes) -> tuple[bytes, bytes]:
    """Bytes up to the end of the last whole frame, and the rest."""
    at = 0
    while (start := content.find(bytes((MAGIC,)), at)) >= 0:
        if len(content) < start + HEADER_BYTES:
            return content[:start], content[start:]
        end = start + HEADER_BYTES + content[start + 1] + CHECKSUM_BYTES
        if len(content) < end:
            return content[:start], content[start:]
        at = end
    return content, b""
