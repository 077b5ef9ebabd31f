"""The two sockets to an ArduPilot that this process has started: its simulation's, and its serial port."""

from __future__ import annotations

import contextlib
import socket
import time

import cython
import cython.cimports.simvehicle.mavlink.real_autopilots.json_backend as json_backend
from cython.cimports.cpython.bytes import PyBytes_AS_STRING
from cython.cimports.simvehicle.mavlink.real_autopilots.json_backend import Servo
from cython.cimports.simvehicle.sitl.ardupilot_link import SERVO_BYTES
from cython.cimports.skytender.system_calls import recv, send

from simvehicle.mavlink.codec import ReceivedFrame, split
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


class ArduPilotLink(AutopilotLink):
    """An ArduPilot's process with its sockets. Everything raises AutopilotError once it is gone."""

    def __init__(self, wanted: AutopilotWanted) -> None:
        """Start it, and wait for its first servo packet."""
        self._serial_pending = b""
        self._frame = 0
        self.throttles = (0.0, 0.0, 0.0, 0.0)
        with contextlib.ExitStack() as opened:
            self._udp, instance = simulation_port()
            self._fd = self._udp.fileno()
            opened.callback(self._udp.close)
            self._udp.setsockopt(socket.SOL_SOCKET, socket.SO_RCVTIMEO, time_of(LOOK_EVERY_S))
            self.process = opened.enter_context(start_ardupilot(wanted, instance))
            self._serial = self._connect(SERIAL_PORT + APART * instance)
            opened.callback(self._serial.close)
            self._first_servo()
            self._closing = opened.pop_all()

    def say(self, raw: bytes) -> None:
        """Say bytes into its serial port: it reads them right after the next answer."""
        try:
            self._serial.sendall(raw)
        except OSError as error:
            raise self.process.gone() from error

    def answer(self, line: bytes) -> None:
        """Answer its servo packet and wait for the next one's `throttles`."""
        if send(self._fd, PyBytes_AS_STRING(line), len(line), 0) < 0:
            raise self.process.gone()
        self._await_servo()

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

    def _await_servo(self) -> None:
        """Wait for the next servo packet; what it repeats is passed over. A session may stand still: it waits while it
        lives."""
        servo = cython.declare(Servo)
        room = cython.declare(cython.char[SERVO_BYTES])
        fd, last = cython.declare(cython.int, self._fd), cython.declare(cython.uint, self._frame)
        while True:
            have = recv(fd, room, SERVO_BYTES, 0)
            if have < 0:  # the socket's own time-out, a signal; or it may have gone
                self.process.look()
            elif json_backend.read(room, have, cython.address(servo)) and servo.frame != last:
                self._frame, self.throttles = servo.frame, json_backend.throttles_of(cython.address(servo))
                return

    def _first_servo(self) -> None:
        """Wait for its first servo packet, and answer where that came from."""
        deadline_s = time.monotonic() + READY_WITHIN_S
        while True:
            try:
                datagram, peer = self._udp.recvfrom(SERVO_BYTES)
            except BlockingIOError:  # the socket's own time-out
                self.process.look()
                if time.monotonic() > deadline_s:
                    late = f"said nothing to its simulation within {READY_WITHIN_S:.0f} s"
                    raise self.process.late(late) from None
                continue
            packet = json_backend.parse(datagram)
            if packet is not None:
                self._frame, self.throttles = packet
                self._udp.connect(peer)
                return

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
