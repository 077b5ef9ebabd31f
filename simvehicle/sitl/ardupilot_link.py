"""The two sockets to an ArduPilot that this process has started: its simulation's, and its serial port."""

from __future__ import annotations

import contextlib
import socket
import time

from simvehicle.mavlink.codec import ReceivedFrame, split
from simvehicle.mavlink.real_autopilots import json_backend
from simvehicle.sitl.ardupilot_process import APART, SERIAL_PORT, simulation_port, start_ardupilot
from simvehicle.sitl.autopilot_process import (
    HOST,
    LOOK_EVERY_S,
    READY_WITHIN_S,
    AutopilotLink,
    AutopilotWanted,
    whole_frames,
)
from simvehicle.sitl.link import time_of

SERIAL_BYTES = 65536
SERVO_BYTES = 2048


class ArduPilotLink(AutopilotLink):
    """An ArduPilot's process with its sockets. Everything raises AutopilotError once it is gone."""

    def __init__(self, wanted: AutopilotWanted) -> None:
        """Start it, and wait for its first servo packet."""
        self._serial_pending = b""
        self._peer = (HOST, 0)
        with contextlib.ExitStack() as opened:
            self._udp, instance = simulation_port()
            opened.callback(self._udp.close)
            self._udp.setsockopt(socket.SOL_SOCKET, socket.SO_RCVTIMEO, time_of(LOOK_EVERY_S))
            self.process = opened.enter_context(start_ardupilot(wanted, instance))
            self._serial = self._connect(SERIAL_PORT + APART * instance)
            opened.callback(self._serial.close)
            self.servo = self._next_servo(-1)
            self._udp.connect(self._peer)
            self._closing = opened.pop_all()

    def say(self, raw: bytes) -> None:
        """Say bytes into its serial port: it reads them right after the next answer."""
        try:
            self._serial.sendall(raw)
        except OSError as error:
            raise self.process.gone() from error

    def answer(self, line: bytes) -> None:
        """Answer its servo packet and wait for the next, `servo`."""
        try:
            self._udp.send(line)
        except OSError as error:
            raise self.process.gone() from error
        self.servo = self._next_servo(self.servo.frame)

    def received(self) -> list[ReceivedFrame]:
        """Frames that have come through its serial port: all that it said before its servo packet."""
        try:
            while True:
                chunk = self._serial.recv(SERIAL_BYTES)
                if not chunk:
                    raise self.process.gone()
                self._serial_pending += chunk
        except BlockingIOError:
            pass
        except ConnectionError as error:
            raise self.process.gone() from error
        if not self._serial_pending:
            return []
        whole, self._serial_pending = whole_frames(self._serial_pending)
        return split(bytes(whole))

    def _next_servo(self, last_frame: int) -> json_backend.ServoPacket:
        """The next servo packet; what it repeats is passed over. A session may stand still: it waits while it lives."""
        deadline_s = time.monotonic() + READY_WITHIN_S if last_frame < 0 else None
        while True:
            try:
                datagram, self._peer = self._udp.recvfrom(SERVO_BYTES)
            except (BlockingIOError, ConnectionRefusedError):  # the socket's own time-out; or it may have gone
                self.process.look()
                if deadline_s is not None and time.monotonic() > deadline_s:
                    late = f"said nothing to its simulation within {READY_WITHIN_S:.0f} s"
                    raise self.process.late(late) from None
                continue
            packet = json_backend.parse(datagram)
            if packet is not None and packet.frame != last_frame:
                return packet

    def _connect(self, port: int) -> socket.socket:
        """Its serial port, which listens soon after its start."""
        deadline_s = time.monotonic() + READY_WITHIN_S
        while True:
            self.process.look()
            try:
                made = socket.create_connection((HOST, port), timeout=LOOK_EVERY_S)
                made.setblocking(False)
                made.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                return made
            except OSError as error:
                if time.monotonic() > deadline_s:
                    late = f"opened no port {port} in {READY_WITHIN_S:.0f} s"
                    raise self.process.late(late) from error
                time.sleep(0.01)
