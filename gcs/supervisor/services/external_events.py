"""Events of a session's external vehicles, as the texts that their STATUSTEXTs are.

A vehicle's metadata is read once it has been received for ASK_AFTER_S and while it is not armed: its files may fill a
slow link for some seconds.
"""

from __future__ import annotations

from collections.abc import Iterable

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.command_protocol import CommandRequest
from gcs.mavlink.ids import AUTOPILOT
from gcs.mavlink.metadata.reported_events import NAMES, ReportedEvents
from gcs.scenario.model import Scenario
from gcs.telemetry.events import Event
from gcs.telemetry.state import VehicleView
from skytender import mavlink as mav

ASK_AFTER_S = 5.0
"""By then a session has asked for what it needs itself."""
SAY_EVERY_S = 10.0
METADATA = "metadata"
"""Token of the command."""
_IDS = frozenset(map(codec.msgid, NAMES))


class ExternalEvents:
    """Events of all of them."""

    def __init__(self, scenario: Scenario) -> None:
        self._reported = {sysid: ReportedEvents(sysid, AUTOPILOT) for sysid in scenario.vehicles.external}
        self._received_s: dict[int, float] = {}
        self._asked: set[int] = set()
        """which were asked for COMPONENT_METADATA"""
        self._lost = dict.fromkeys(self._reported, 0)
        self._said_s: dict[int, float] = {}

    def receive(self, sysid: int, frames: Iterable[Frame], now_s: float) -> list[tuple[int, int, str]]:
        """Take an autopilot's frames; (system id, MAV_SEVERITY, text) of each event."""
        if sysid not in self._reported:
            return []
        texts = []
        for frame in frames:
            self._received_s.setdefault(sysid, now_s)
            if frame.msgid in _IDS:
                read = self._reported[sysid].receive(codec.name(frame.msgid), codec.fields(frame), now_s)
                texts += [(sysid, *text) for text in read]
        return texts

    def commands(self, view: VehicleView, now_s: float) -> list[CommandRequest]:
        """The command that asks a vehicle for its metadata, once."""
        waited_s = now_s - self._received_s.get(view.sysid, now_s)
        if view.sysid in self._asked or view.armed or waited_s < ASK_AFTER_S:
            return []
        self._asked.add(view.sysid)
        number = float(mav.MAVLINK_MSG_ID_COMPONENT_METADATA)
        return [CommandRequest(view.sysid, mav.MAV_CMD_REQUEST_MESSAGE, (number,), METADATA)]

    def requests(self, sysid: int, now_s: float) -> list[Message]:
        """Messages that read a vehicle's metadata, and ask for events that it has sent in vain."""
        reported = self._reported.get(sysid)
        return [] if reported is None else reported.poll(now_s)

    def losses(self, sysid: int, now_s: float) -> list[Event]:
        """Event that says how many of a vehicle's were lost since the last call."""
        reported = self._reported.get(sysid)
        lost = 0 if reported is None else reported.lost - self._lost[sysid]
        if not lost or now_s < self._said_s.get(sysid, -SAY_EVERY_S) + SAY_EVERY_S:
            return []
        self._lost[sysid] += lost
        self._said_s[sysid] = now_s
        return [Event(now_s, sysid, "warning", f"{lost} of its events did not arrive, nor when asked for", "link")]
