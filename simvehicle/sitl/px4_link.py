"""The two sockets to a PX4 that this process has started: its simulation's, and its MAVLink."""

from __future__ import annotations

import contextlib
import socket
import time

from simvehicle.mavlink.codec import ReceivedFrame, split
from simvehicle.mavlink.real_autopilots import hil
from simvehicle.sitl.autopilot_process import (
    HOST,
    LOOK_EVERY_S,
    READY_WITHIN_S,
    AutopilotError,
    AutopilotLink,
    AutopilotWanted,
    whole_frames,
)
from simvehicle.sitl.link import time_of
from simvehicle.sitl.px4_process import MAVLINK_PORT, simulation_port, start_px4

BYTES = 65536
BEFORE_FIRST_S = 0.01
"""How long each step waits for motor controls while none have come yet: its controllers start after its first
steps."""


class Px4Link(AutopilotLink):
    """A PX4's process with its sockets. Everything raises AutopilotError once it is gone."""

    def __init__(self, wanted: AutopilotWanted, *, hover_throttle: float) -> None:
        """Start it, and wait until it asks for its simulation."""
        self._pending = b""
        self.controls = hil.MotorControls(0, True, (0.0,) * hil.ROTORS)
        self._answers = False
        """whether motor controls have come"""
        with contextlib.ExitStack() as opened:
            listening, instance = simulation_port()
            opened.callback(listening.close)
            self._udp = opened.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
            self._udp.bind((HOST, 0))
            self._udp.setblocking(False)
            self._peer = (HOST, MAVLINK_PORT + instance)
            port = int(self._udp.getsockname()[1])
            process = start_px4(wanted, instance, hover_throttle=hover_throttle, port=port)
            self.process = opened.enter_context(process)
            self._tcp = self._accept(listening)
            opened.callback(self._tcp.close)
            self._began_s = time.monotonic()
            self._closing = opened.pop_all()

    def say(self, raw: bytes) -> None:
        """Say bytes to it over its MAVLink."""
        with contextlib.suppress(ConnectionRefusedError):  # its port is not open before its start script has come there
            self._udp.sendto(raw, self._peer)

    def received(self) -> list[ReceivedFrame]:
        """Frames that have come over its MAVLink."""
        frames: list[ReceivedFrame] = []
        while True:
            try:
                datagram = self._udp.recv(BYTES)
            except (BlockingIOError, ConnectionRefusedError):
                return frames
            frames.extend(split(bytes(datagram)))

    def step(self, time_us: int, messages: bytes) -> None:
        """Tell it a step of its simulation, whose HIL_SENSOR is of that time, and wait for its controls, `controls`."""
        try:
            self._tcp.sendall(messages)
        except OSError as error:
            raise self.process.gone() from error
        if self._answers:
            while self.controls.time_us < time_us:
                self._receive()
            return
        until_s = time.monotonic() + BEFORE_FIRST_S
        while not self._answers and time.monotonic() < until_s:
            self._receive()
        if self._answers:
            self._tcp.setsockopt(socket.SOL_SOCKET, socket.SO_RCVTIMEO, time_of(LOOK_EVERY_S))
        elif until_s > self._began_s + READY_WITHIN_S:
            raise self.process.late(f"sent no motor commands within {READY_WITHIN_S:.0f} s")

    def _receive(self) -> None:
        """Wait for what it says to its simulation, for a while. A session may stand still: it waits while it lives."""
        try:
            chunk = self._tcp.recv(BYTES)
        except BlockingIOError:  # the socket's own time-out, which costs no call of its own
            self.process.look()
            return
        except ConnectionError as error:
            raise self.process.gone() from error
        if not chunk:
            raise self.process.gone()
        whole, self._pending = whole_frames(self._pending + chunk)
        for frame in split(bytes(whole)):
            wanted = hil.controls(frame)
            if wanted is None:
                continue
            if not wanted.lockstep:
                said = "does not wait for its simulation: build px4_sitl_default, not px4_sitl_nolockstep"
                raise AutopilotError(f"{self.process.name} {said}")
            self.controls, self._answers = wanted, True

    def _accept(self, listening: socket.socket) -> socket.socket:
        """Its connection to its simulation."""
        listening.settimeout(LOOK_EVERY_S)
        deadline_s = time.monotonic() + READY_WITHIN_S
        while True:
            self.process.look()
            try:
                made, _ = listening.accept()
            except TimeoutError:
                if time.monotonic() > deadline_s:
                    raise self.process.late(f"asked for no simulation within {READY_WITHIN_S:.0f} s") from None
                continue
            listening.close()
            made.setblocking(True)
            made.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            made.setsockopt(socket.SOL_SOCKET, socket.SO_RCVTIMEO, time_of(BEFORE_FIRST_S))
            return made
