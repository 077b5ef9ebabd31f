"""Any fleet as the messages of a session's socket: frames and their times in, `session` and `snapshot` out.

Nothing need be configured: a vehicle is what sends a vehicle's HEARTBEAT, and the first one's origin is the common
frame's. A scenario, where there is one, says more: roles, capacities, obstacles, and the origin. An observer says
nothing to anyone.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Any, Literal

import msgspec
import numpy as np
from msgspec import UNSET
from numpy.typing import NDArray

from gcs.link.quality import LinkQuality
from gcs.mavlink import codec
from gcs.mavlink.autopilots import End, profile_of
from gcs.mavlink.codec import Frame
from gcs.mavlink.command_protocol import result_in_words
from gcs.mavlink.common_frame import FramePlace, turned
from gcs.mavlink.gaps import GapCounter
from gcs.mavlink.ids import AUTOPILOT
from gcs.mavlink.services.vehicle_events import EVENT, aged
from gcs.mavlink.vehicle_kinds import KINDS
from gcs.scenario.model import Scenario
from gcs.session import message_types as types
from gcs.session.messages import (
    battery_rows,
    event_row,
    goal_of,
    goal_state,
    known_of,
    session_message,
    traffic_row,
    vehicle_row,
)
from gcs.telemetry.adapter import TelemetryAdapter
from gcs.telemetry.changes import ChangeDetector
from gcs.telemetry.common_zero import CommonZero
from gcs.telemetry.events import Event, level_of
from gcs.telemetry.fleet import Fleet, GlobalOrigin
from gcs.telemetry.health import WATCHED, Health, Known, health, health_issues
from gcs.telemetry.message_inspector import MessageInspector
from gcs.telemetry.place_claims import HEIGHT_UNKNOWN
from gcs.telemetry.proximity import too_near
from gcs.telemetry.state import FleetSnapshot, Vec3, VehicleView
from gcs.telemetry.track import Member
from skytender import mavlink as mav

Kind = Literal["monitor", "replay"]
UNKNOWN_CAPACITY_J = math.nan
NAMELESS = (
    "A vehicle sends with system id 0, which MAVLink keeps for all vehicles, and is not shown: give it one of its own "
    "(SYSID_THISMAV or MAV_SYSID of an ArduPilot, MAV_SYS_ID of a PX4)"
)
MOST_EVENTS = 200
"""Events of one snapshot."""
_ADSB = codec.msgid("ADSB_VEHICLE")
_BATTERY = codec.msgid("BATTERY_STATUS")
_HEARTBEAT = codec.msgid("HEARTBEAT")
_TEXT = codec.msgid("STATUSTEXT")
_SYSTEM_TIME = codec.msgid("SYSTEM_TIME")
_ACK = codec.msgid("COMMAND_ACK")
_CURRENT = codec.msgid("MISSION_CURRENT")
_TARGET = codec.msgid("POSITION_TARGET_LOCAL_NED")
_SET_POINT = codec.msgid("SET_POSITION_TARGET_LOCAL_NED")
_NO_POSITION = mav.POSITION_TARGET_TYPEMASK_X_IGNORE


class Observer:
    """Watches a fleet. Times are in s since the zero that `receive` is given them from, and do not fall.

    scenario: of a recorded session, whose vehicles need not be discovered and whose local clock is the session's.
    """

    def __init__(self, source: Kind, name: str, *, scenario: Scenario | None = None, folder: str | None = None) -> None:
        self._source: Kind = source
        self._name = name
        self._folder = folder
        self.scenario = scenario
        self.control = False
        """whether the source of this observer takes commands for vehicles"""
        self.duration_s: float | None = None
        self.ordered: dict[int, End] = {}
        """what an operator wants vehicles of a scenario to fly: that is no failsafe"""
        self.lost: set[int] = set()
        """vehicles of a scenario that were lost; one that flies again is not"""
        self.kept_out: Mapping[int, Collection[str]] = {}
        """what keeps vehicles of a scenario out of the refuelling"""
        self.breaches: Sequence[Mapping[str, Any]] = ()
        """of a scenario's goal: by what vehicles have been too near to something"""
        members = [] if scenario is None else [_member(vehicle) for vehicle in scenario.vehicles.all]
        given = None if scenario is None else GlobalOrigin(*scenario.origin.model_dump().values())
        self._zero = CommonZero(given)
        self.fleet = Fleet(members, given or GlobalOrigin(0.0, 0.0, 0.0))
        self._adapters: dict[int, TelemetryAdapter] = {}
        # A session's own vehicles send all that the fleet reads, on its clock; external ones are unknown here too.
        self._known = set() if scenario is None else {vehicle.sysid for vehicle in scenario.vehicles.launched}
        self._expected = {member.sysid for member in members} - self._known
        self._gaps = GapCounter()
        self.quality = LinkQuality(self._gaps)
        self.inspection = MessageInspector()
        self._watch = ChangeDetector()
        self._wordless: set[int] = set()
        """vehicles whose events nothing here can put into words, of which it was reported"""
        self._nameless = False
        """whether a vehicle of system id 0 has been received"""
        self._events: list[Event] = []
        self._texts: deque[tuple[int, str]] = deque(maxlen=MOST_EVENTS)
        """the last STATUSTEXTs, that an EVENT may repeat"""
        self._aims: dict[int, Vec3] = {}
        self._mission_items: dict[int, int] = {}
        self.plans: Sequence[types.PlanRow] = ()
        """missions, fences and rally points to show beside the scenario's own"""
        self.changed = True
        """whether `session` has changed since it was last sent; the sender resets it"""

    @property
    def sysids(self) -> list[int]:
        """The vehicles known so far."""
        return sorted(self._known | self._expected | self._adapters.keys())

    def component(self, sysid: int) -> int:
        """The component of a known vehicle that is its autopilot."""
        adapter = self._adapters.get(sysid)
        return AUTOPILOT if adapter is None else adapter.compid

    def receive(self, frame: Frame, t_s: float, *, counted: bool = True) -> None:
        """Take a frame that came at `t_s`; frames of other senders are passed over, but for ADS-B.

        Not `counted`: it is one of many, the others of which are not passed in, and says nothing of the link.
        """
        if frame.msgid == _ADSB:
            if self._zero.origin is not None:
                self.fleet.ingest(frame, t_s)
            return
        adapter = self._adapters.get(frame.sysid)
        if adapter is None:
            adapter = self._discover(frame, t_s)
        if counted and (adapter is not None or frame.sysid in self._known or frame.sysid in self._expected):
            self._gaps.feed(frame.sysid, frame.compid, frame.seq)
            exempt = frame.msgid == _SYSTEM_TIME and frame.sysid in self._known  # as for the session (reception.py)
            self.quality.count(frame.sysid, 0 if exempt else 1, t_s)
        if adapter is not None and frame.msgid == _BATTERY and frame.compid != adapter.compid:
            adapter.receive_battery(frame, t_s)
        if adapter is None or frame.compid != adapter.compid:
            return
        if frame.sysid in self.inspection.wanted:
            self.inspection.add((frame,), t_s)
        if frame.sysid in self._known:
            self.fleet.ingest(frame, t_s)
        else:
            adapter.receive(frame, t_s)
            self._events += [Event(t_s, frame.sysid, "warning", note, "link") for note in adapter.notes]
            adapter.notes.clear()
            self._place_common_frame(adapter, frame.msgid, t_s)
            adapter.feed(self.fleet, frame, t_s, framed=self._zero.origin is not None)
        if frame.msgid == _TARGET:
            self._aim(frame.sysid, codec.fields(frame))
        elif frame.msgid in (_TEXT, _ACK):
            self._said(t_s)
        elif frame.msgid == EVENT:
            self._report_events(frame.sysid, t_s)
        elif frame.msgid == _CURRENT:
            self._mission_items[frame.sysid] = codec.fields(frame).seq

    def receive_dated(
        self, data: bytes, heads: NDArray[np.int64], times_s: NDArray[np.float64], frame: Callable[[int], Frame]
    ) -> None:
        """As `receive` with n frames of a recording that are not counted; the session's own vehicles' are read at once.

        Args:
            heads: (n, 2) where in `data` each frame begins, and its sender's system id.
            times_s: (n,) when each came.
            frame: makes that of a number.
        """
        places, sysids = np.ascontiguousarray(heads.T)
        self.fleet.ingest_dated(
            data, places, sysids, times_s, self._known,
            lambda k: self.receive(frame(k), float(times_s[k]), counted=False),
        )  # fmt: skip

    def _report_events(self, sysid: int, t_s: float) -> None:
        """Say once that a vehicle sends events; a session's recording has them as decisions."""
        if self.control or self.scenario is not None or sysid in self._wordless:
            return
        self._wordless.add(sysid)
        what = "--control reads them" if self._source == "monitor" else "a recording does not hold them"
        text = f"Sends events (EVENT), whose words are in its metadata: {what}"
        self._events.append(Event(t_s, sysid, "info", text, "link"))

    def receive_sent(self, frame: Frame) -> None:
        """Take a frame that was sent to a vehicle: where it is to be."""
        if frame.msgid == _SET_POINT:
            content = codec.fields(frame)
            self._aim(content.target_system, content)

    def add_event(self, event: Event) -> None:
        """Add to the next snapshot an event that no vehicle reported."""
        self._events.append(event)

    def add_text(self, sysid: int, severity: int, text: str, t_s: float, came_s: float) -> None:
        """Add a vehicle's EVENT in words, unless a STATUSTEXT of the same words has come with it, at `came_s`."""
        if (sysid, text) in self._texts:
            self._texts.remove((sysid, text))
        else:
            self._events.append(Event(t_s, sysid, level_of(severity), aged(text, came_s, t_s), "text"))

    def resume(self, gaps: GapCounter, t_s: float) -> None:
        """Count lost frames from `t_s` on where those before are counted already."""
        self._gaps = gaps
        self.quality = LinkQuality(gaps)
        self.quality.begin(t_s)

    def look(self, t_s: float) -> None:
        """Look at what vehicles have said and how they have changed: an event of `t_s` in the next snapshot."""
        self._said(t_s)
        self._events += self._watch.look(self.view(t_s), None if self.scenario is None else self.ordered)

    def pop_events(self) -> list[Event]:
        """The events that the next snapshot would report, which it then does not."""
        events, self._events = self._events, []
        return events

    def health(self, t_s: float) -> dict[int, Health]:
        """Health of each vehicle as a snapshot at `t_s` would report it."""
        found, snapshot = {}, self.view(t_s)
        near = self._near(snapshot)
        for view in map(self._seen, snapshot.vehicles):
            share = self.quality.lost_share(view.sysid)
            found[view.sysid] = health(health_issues(view, t_s, self._known_of(view, near), lost_share=share))
        return found

    def session(self) -> dict[str, Any]:
        """The message of type "session" as things stand."""
        self.changed = False
        if self.scenario is not None:
            line = session_message(
                self.scenario, self._folder, source=self._source, clock=self._clock, control=self.control
            )
            known = {vehicle["sysid"] for vehicle in line["vehicles"]}
            if self.plans:
                line["plans"] = line.get("plans", []) + msgspec.to_builtins(list(self.plans))
            line["vehicles"] += [msgspec.to_builtins(self._found(s)) for s in self.sysids if s not in known]
            return line | {"speed": None}
        return types.plain(
            types.SessionLine(
                name=self._name,
                folder=self._folder,
                source=self._source,
                duration_s=self.duration_s,
                clock=self._clock,
                speed=None,
                control=self.control,
                separation_m=None,
                ring_m=None,
                vehicles=[self._found(sysid) for sysid in self.sysids],
                obstacles=[],
                bases=[],
                goal=goal_of(None),
                origin=self.origin,
                plans=list(self.plans) or UNSET,
            )
        )

    @property
    def origin(self) -> tuple[float, float, float] | None:
        """Latitude and longitude, degrees, and altitude, m, of the common frame; None until it is known."""
        zero = self._zero.origin
        return None if zero is None else (zero.lat_deg, zero.lon_deg, zero.alt_m)

    def view(self, t_s: float) -> FleetSnapshot:
        """The fleet at `t_s`, with more than a snapshot's line holds."""
        return self.fleet.snapshot(t_s)

    def snapshot(
        self,
        t_s: float,
        *,
        speed: float | None,
        phase: str,
        amend: Callable[[types.SnapshotMessage, FleetSnapshot], object] = lambda *_: None,
    ) -> dict[str, Any]:
        """The message of type "snapshot" at `t_s`, with the events since the last one in the order of their times.

        `amend`: by which a caller that knows the session's decisions writes them into it.
        """
        view = self.view(t_s)
        self._events.sort(key=lambda event: event.t_s)
        events, self._events = self._events[:MOST_EVENTS], self._events[MOST_EVENTS:]
        if self._events:
            further = f"{len(self._events)} further events are left out"
            events.append(Event(t_s, 0, "warning", further, "session"))
            self._events = []
        line = types.SnapshotMessage(
            t_s=t_s,
            duration_s=self.duration_s,
            speed=speed,
            phase=phase,
            vehicles=self._rows(view),
            traffic=[traffic_row(aircraft) for aircraft in view.traffic],
            competition=types.CompetitionRow({}, {}, None, None, None, threshold=0.9),  # the default share
            services=[],
            history=[],
            refuelled=0,
            goal=goal_state(None, None, []),
            inspected=self.inspection.latest(t_s),
            events=[event_row(event) for event in events],
        )
        amend(line, view)
        return types.plain(line)

    # vehicles

    @property
    def _clock(self) -> Literal["real", "replay"]:
        return "real" if self._source == "monitor" else "replay"

    def _discover(self, frame: Frame, t_s: float) -> TelemetryAdapter | None:
        """A vehicle's first HEARTBEAT makes it known; a scenario's vehicles are so already."""
        if frame.sysid in self._known or frame.sysid in self._expected:
            if frame.compid != AUTOPILOT:
                return None
            adapter = self._adapters[frame.sysid] = TelemetryAdapter(frame.sysid, frame.compid)
            return adapter
        if frame.msgid != _HEARTBEAT:
            return None
        content = codec.fields(frame)
        role = KINDS.get(content.type)
        if role is None or content.autopilot == mav.MAV_AUTOPILOT_INVALID:
            return None
        if frame.sysid == 0:
            if not self._nameless:
                self._events.append(Event(t_s, 0, "warning", NAMELESS, "link"))
            self._nameless = True
            return None
        adapter = self._adapters[frame.sysid] = TelemetryAdapter(frame.sysid, frame.compid)
        label, unknown_j = f"{role} {frame.sysid}", UNKNOWN_CAPACITY_J
        self.fleet.join(Member(frame.sysid, role, label, unknown_j, unknown_j, vehicle_type=content.type))
        kind = profile_of(content.autopilot).name
        self._events.append(Event(t_s, frame.sysid, "info", f"First heard of: {kind} autopilot", "link"))
        self.changed = True
        return adapter

    def _place_common_frame(self, adapter: TelemetryAdapter, msgid: int, t_s: float) -> None:
        first = self._zero.origin is None
        moved = self._zero.learn(adapter.sysid, adapter.claims, msgid, t_s)
        if moved is None:
            return
        if first:
            self.fleet.origin = moved.origin
        else:
            unknown = {one.sysid for one in self.fleet.snapshot(t_s).vehicles if one.uncertain == HEIGHT_UNKNOWN}
            self.fleet.move_zero(moved.origin, unknown)
        if moved.why is not None:
            self._events.append(Event(t_s, adapter.sysid, "info", moved.why, "link"))
        self.changed = True

    def _found(self, sysid: int) -> types.MemberRow:
        view = self.fleet.snapshot(0.0).vehicle(sysid)
        capacity_j = view.capacity_j if math.isfinite(view.capacity_j) else None
        return types.MemberRow(sysid, view.role, view.label, capacity_j, [], sysid - 1)

    # rows of the snapshot

    def _aim(self, sysid: int, content: Any) -> None:
        place = (content.x, content.y, content.z)
        known = content.coordinate_frame == mav.MAV_FRAME_LOCAL_NED and not content.type_mask & _NO_POSITION
        if known and all(map(math.isfinite, place)):
            self._aims[sysid] = place
        else:
            self._aims.pop(sysid, None)

    def _said(self, t_s: float) -> None:
        for sysid, severity, text in self.fleet.pop_statustexts(t_s):
            self._events.append(Event(t_s, sysid, level_of(severity), text, "text"))
            self._texts.append((sysid, text))
        for sysid, ack in self.fleet.pop_acks():
            self._acknowledged(t_s, sysid, ack)

    def _acknowledged(self, t_s: float, sysid: int, ack: Any) -> None:
        accepted = ack.result in (mav.MAV_RESULT_ACCEPTED, mav.MAV_RESULT_IN_PROGRESS)
        if accepted and self._source == "replay":
            return
        said = f"{mav.command_name(ack.command)}: {result_in_words(ack.result)}"
        self._events.append(Event(t_s, sysid, "info" if accepted else "warning", said, "ack"))

    def _rows(self, snapshot: FleetSnapshot) -> list[types.VehicleRow]:
        rows, near = [], self._near(snapshot)
        for reported in snapshot.vehicles:
            adapter, view = self._adapter(reported.sysid), self._seen(reported)
            row = vehicle_row(view, snapshot.time_s, self.quality, self._known_of(view, near))
            batteries = self.fleet.batteries(view.sysid) if adapter is None else adapter.batteries.all
            row.batteries = battery_rows(batteries, snapshot.time_s)
            row.mission_item = self._mission_items.get(view.sysid, UNSET)
            row.remote_id = self.fleet.remote_id(view.sysid) or UNSET
            aim, frame = self._aims.get(view.sysid), self._frame(view)
            if aim is not None and frame is not None:
                row.aim_ned = _sum(turned(aim, frame.turn_rad), frame.offset_ned)
            if adapter is not None and not math.isfinite(reported.remaining_j):
                row.battery, row.remaining_j, row.endurance_s = adapter.share, None, None
                row.power_w = adapter.power_w if view.alive else None
            rows.append(row)
        return rows

    def _near(self, snapshot: FleetSnapshot) -> dict[int, str]:
        return {} if self.scenario is None else too_near(self.breaches, snapshot, self.scenario)

    def _known_of(self, view: VehicleView, near: Mapping[int, str]) -> Known:
        if self.scenario is None:
            return WATCHED
        sysid, down = view.sysid, view.sysid in self.lost and not view.flying
        return known_of(self.ordered.get(sysid), down, self.kept_out.get(sysid, ()), near.get(sysid, ""))

    def _adapter(self, sysid: int) -> TelemetryAdapter | None:
        """Reader of a vehicle that is not a session's own."""
        return None if sysid in self._known else self._adapters.get(sysid)

    def _seen(self, view: VehicleView) -> VehicleView:
        """The fleet's view with what it could not know."""
        adapter = self._adapter(view.sysid)
        return view if adapter is None else adapter.seen(view)[0]

    def _frame(self, view: VehicleView) -> FramePlace | None:
        """Where a vehicle's own frame lies in the common one."""
        adapter = self._adapter(view.sysid)
        if adapter is not None:
            return None if self._zero.origin is None else adapter.claims.frame(self._zero.origin)
        return None if view.origin_offset_ned is None else FramePlace(view.origin_offset_ned, view.turn_rad)


def _member(vehicle: Any) -> Member:
    battery = vehicle.battery
    initial_j = battery.capacity_j * battery.initial_percent / 100.0
    return Member(vehicle.sysid, vehicle.role, vehicle.label, battery.capacity_j, initial_j, airborne=vehicle.airborne)


def _sum(a: Sequence[float], b: Sequence[float]) -> Vec3:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])
