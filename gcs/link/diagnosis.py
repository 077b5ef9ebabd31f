"""Why no vehicle is received at an address: the end of a sentence with what to do, from what came there."""

from __future__ import annotations

from gcs.mavlink.codec import Split
from gcs.scenario.endpoint import Endpoint

NOISE_BYTES = 200
"""So much without a frame is no MAVLink at this rate: no vehicle's console says so much before its first HEARTBEAT
without one in between."""


class Diagnosis:
    """Counts of what came at one address."""

    def __init__(self, at: Endpoint) -> None:
        self._at = at
        self._bytes = 0
        self._frames = 0
        self._old: set[int] = set()
        """system ids of vehicles that speak MAVLink 1"""

    def count(self, data: bytes, split: Split) -> bool:
        """Take bytes from an unknown sender, and what was found in them; whether that is MAVLink 1."""
        self._bytes += len(data)
        self._frames += len(split.frames)
        self._old |= {frame.sysid for frame in split.older}
        return bool(split.older)

    def text(self, problem: str, sysid: int | None = None) -> str:
        """Reason why this vehicle, or any, is not received; empty where no reason can be seen here."""
        if problem:
            return problem
        if sysid in self._old or (self._old and not self._frames):
            return "only MAVLink 1 comes: let it speak MAVLink 2 (ArduPilot: SERIALn_PROTOCOL 2; PX4: MAV_PROTO_VER 2)"
        if self._frames:
            return ""
        if self._at.way == "serial":
            if self._bytes >= NOISE_BYTES:
                return f"what comes is no MAVLink: has the other end another rate than {self._at.port} baud?"
            return "" if self._bytes else "nothing comes: is the other end on, and are both radios of one network?"
        return "what comes there is no MAVLink" if self._bytes >= NOISE_BYTES else ""
