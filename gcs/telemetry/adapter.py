"""Adapter from any autopilot's telemetry to what `Fleet` reads: landed state, battery, and the vehicle's place.

Autopilots report their positions in several ways, count time since their own start, and some leave out what others say:

- where it is, in the common frame, follows from all that it says of it (gcs/telemetry/place_claims.py), and is reported
  as of the time at which it came;
- whether it has landed, where EXTENDED_SYS_STATE does not say, follows from HEARTBEAT's system status;
- what its battery holds, where its capacity is unknown, is the share that it reports, of no number of joules.
"""

from __future__ import annotations

import math
from typing import Any

from gcs.mavlink import codec
from gcs.mavlink.autopilots import profile_of
from gcs.mavlink.battery import sys_status, voltage_v
from gcs.mavlink.codec import Frame
from gcs.mavlink.ids import AUTOPILOT
from gcs.telemetry import place_claims
from gcs.telemetry.batteries import Batteries
from gcs.telemetry.fleet import Fleet
from gcs.telemetry.place_claims import PlaceClaims
from gcs.telemetry.state import VehicleView
from gcs.telemetry.voltage_watch import VoltageWatch
from skytender import mavlink as mav

_HEARTBEAT = codec.msgid("HEARTBEAT")
_STATE = codec.msgid("EXTENDED_SYS_STATE")
_BATTERY = codec.msgid("BATTERY_STATUS")
_STATUS = codec.msgid("SYS_STATUS")
_BOOT_MS = slice(4)
"""Where in the payload its own time stands, in all that have it here; zeros at the end are cut."""


class TelemetryAdapter:
    """Adapts one vehicle's telemetry."""

    def __init__(self, sysid: int, compid: int) -> None:
        self.sysid = sysid
        self.compid = compid
        self.share: float | None = None
        """what the battery holds of its capacity, 0..1; None: not reported"""
        self.power_w: float | None = None
        """what is drawn; None: not measured"""
        self.batteries = Batteries()
        """also those that other components report"""
        self.claims = PlaceClaims()
        self.notes: list[str] = []
        """sentences on the vehicle that a person should see, without its name; taken by the reader"""
        self._voltages = VoltageWatch()
        self._system_status = mav.MAV_STATE_UNINIT
        self._state_reported = False
        self._names_place = False
        """whether the last frame names a place"""

    def receive(self, frame: Frame, t_s: float) -> None:
        """Take in a frame that came at `t_s`; `feed` gives the fleet what it reads of it."""
        msgid = frame.msgid
        self._names_place = False
        if msgid in (place_claims.ATTITUDE, place_claims.LOCAL, place_claims.GLOBAL):
            self.claims.booted(msgid, int.from_bytes(frame.payload[_BOOT_MS], "little"), t_s)
        if msgid in place_claims.CLAIMS:
            self._names_place = self.claims.receive(msgid, codec.fields(frame), t_s)
        elif msgid == place_claims.SATELLITES:
            self.claims.judge_by_satellites(codec.fields(frame), t_s)
        elif msgid == _HEARTBEAT:
            content = codec.fields(frame)
            self.claims.identify(home_is_local=profile_of(content.autopilot).home_is_local)
            self._system_status = content.system_status
        elif msgid == _STATE:
            self._state_reported = codec.fields(frame).landed_state != mav.MAV_LANDED_STATE_UNDEFINED
        elif msgid == _STATUS:
            self._receive_status(codec.fields(frame), t_s)
        elif msgid == _BATTERY:
            self.receive_battery(frame, t_s)

    def receive_battery(self, frame: Frame, t_s: float) -> None:
        """Take in BATTERY_STATUS, from any component of the vehicle."""
        content = codec.fields(frame)
        self.batteries.add(frame.compid, content, t_s)
        if frame.compid == self.compid:
            self._voltages.take_battery(content.id, voltage_v(content.voltages, content.voltages_ext) or 0.0, t_s)
        share, power_w = self.batteries.share(t_s), self.batteries.power_w(t_s)
        self.share = self.share if share is None else share
        self.power_w = self.power_w if power_w is None else power_w

    def feed(self, fleet: Fleet, frame: Frame, t_s: float, *, framed: bool) -> None:
        """Give the fleet what it reads of the frame that was received last; places if it is `framed`, that is, if it is
        known where the common frame begins."""
        if frame.msgid not in place_claims.CLAIMS:
            fleet.ingest(frame if frame.compid == AUTOPILOT else codec.sent_by(frame, AUTOPILOT), t_s)
            return
        fleet.note_message(self.sysid, t_s)
        if framed and self._names_place and (place := self.claims.place(fleet.origin, t_s)) is not None:
            fleet.take_place(self.sysid, *place, t_s)

    def seen(self, view: VehicleView) -> tuple[VehicleView, float | None]:
        """The fleet's view with what it could not know, and the share that the battery holds; None: not reported.

        A battery of unknown capacity holds that share of 100, its draw 0.
        """
        if not self._state_reported:
            flying = (mav.MAV_STATE_ACTIVE, mav.MAV_STATE_CRITICAL, mav.MAV_STATE_EMERGENCY)
            view = view._replace(landed=not (view.armed and self._system_status in flying))
        if math.isfinite(view.remaining_j) and view.capacity_j > 0.0:
            return view, view.remaining_j / view.capacity_j
        share = self.share
        view = view._replace(
            capacity_j=100.0,
            initial_j=100.0 * (1.0 if share is None else share),
            drawn_j=0.0,
            received_j=0,
            given_j=0,
            power_w=0.0,
            energy_source="none" if share is None else "battery_remaining",
        )
        return view, share

    def _receive_status(self, content: Any, t_s: float) -> None:
        """SYS_STATUS, which speaks of one battery, counts where no battery speaks for itself."""
        if (note := self._voltages.take_status(voltage_v((content.voltage_battery,)) or 0.0, t_s)) is not None:
            self.notes.append(note)
        report = sys_status(content, t_s)
        if report.remaining is not None and self.batteries.share(t_s) is None:
            self.share = report.remaining
        if report.power_w is not None and self.batteries.power_w(t_s) is None:
            self.power_w = report.power_w
