"""Ability to take energy in the air (docs/protocol/energy.md#transfer-capability): as the scenario says, or found out
by asking.

MAV_CMD_USER_1 may mean anything to an unknown autopilot. So only a vehicle that has the parameter SIM_BAT_CAP_J is
asked, and by a command that does nothing: to stop a transfer that it has not begun.
"""

from __future__ import annotations

from collections.abc import Mapping

from gcs.mavlink.command_protocol import CommandRequest
from gcs.refuelling.service import ServiceRequests
from gcs.telemetry.state import FleetSnapshot
from skytender import mavlink as mav

ASK_WITHIN_S = 10.0
"""Time after its first message within which a vehicle must send its parameters."""
BY_SCENARIO = "the scenario says so"
NO_BATTERY_MODEL = "it takes no energy in flight: it has not SIM_BAT_CAP_J, as simulated vehicles that do have"
REFUSED = "it does not know MAV_CMD_USER_1"


class ReceiverCapability:
    """Ability of each vehicle that may be refuelled, as far as it is known."""

    def __init__(self, said: Mapping[int, bool | None]) -> None:
        """`said` by system id: whether it can, None where it is to be asked."""
        self.unable: dict[int, str] = {}
        """vehicles that cannot, and how that is known"""
        self.unknown = {sysid for sysid, can in said.items() if can is None}
        self._unrecorded = [sysid for sysid, can in sorted(said.items()) if can is False]
        for sysid in self._unrecorded:
            self.unable[sysid] = BY_SCENARIO
        self._first_received_s: dict[int, float] = {}
        self._asked: set[int] = set()

    @property
    def open(self) -> bool:
        """Whether there is a vehicle to ask, or something to record."""
        return bool(self.unknown or self._unrecorded)

    def decide(self, snapshot: FleetSnapshot, requests: ServiceRequests) -> None:
        """Ask vehicles with unknown capability, and record those found unable."""
        for sysid in sorted(self.unknown):
            view = snapshot.vehicle(sysid)
            if view.last_received_s < 0.0:
                continue
            first_s = self._first_received_s.setdefault(sysid, snapshot.time_s)
            mark = f"refuel? {sysid}"
            if sysid in self._asked:
                if (accepted := requests.accepted(mark)) is not None:
                    self._learn(sysid, None if accepted else REFUSED)
            elif view.battery_reported:
                self._asked.add(sysid)
                requests.request(CommandRequest(sysid, mav.MAV_CMD_USER_1, (), mark))
            elif snapshot.time_s - first_s > ASK_WITHIN_S:
                self._learn(sysid, NO_BATTERY_MODEL)
        requests.records += [
            {"kind": "unable", "receiver": sysid, "reason": self.unable[sysid]} for sysid in self._unrecorded
        ]
        self._unrecorded = []

    def _learn(self, sysid: int, why_not: str | None) -> None:
        self.unknown.discard(sysid)
        if why_not is not None:
            self.unable[sysid] = why_not
            self._unrecorded.append(sysid)
