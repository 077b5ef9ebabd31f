"""State of the fleet by its telemetry: MAVLink messages in, a snapshot in SI units and the common NED frame out.

The common frame is the scenario's origin. A vehicle's own local frame is moved there by its GPS_GLOBAL_ORIGIN, or by
HOME_POSITION where that says where home lies in it; until one has come its position is unknown, and nothing is planned
for it. An external vehicle's, whose origin may be far away, is turned by the convergence of the meridians too
(gcs/mavlink/common_frame.py).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import astuple, dataclass
from functools import lru_cache
from operator import itemgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.mavlink.codec import Frame, fields
from gcs.mavlink.common_frame import FramePlace, frame_place, origin_under, turned
from gcs.mavlink.datagram import AnswerRuns, FrameRun, frame_at
from gcs.mavlink.frame_runs import LAST, NUMBERS, SYSID
from gcs.mavlink.ids import AUTOPILOT
from gcs.mavlink.services.standard_modes import ListedMode
from gcs.mavlink.statustext import chunk_of
from gcs.telemetry import energy, plausibility
from gcs.telemetry.batteries import VehicleBattery
from gcs.telemetry.battery_account import BATTERY_PARAMETERS, GIVEN, RECEIVED, Fact
from gcs.telemetry.columns import FIGURES, FLAGS, PLACES, FleetColumns
from gcs.telemetry.fleet_columns import FACTS, OFFSET_N, TURN, ColumnFiller
from gcs.telemetry.readings import (
    CLOCK_S,
    DOWN,
    EAST,
    ELSEWHERE,
    END,
    FIRST_BATTERY,
    FIX_ARMED,
    FIX_H,
    FIX_TYPE,
    FIX_V,
    FOUND,
    GIVEN_REPORTED_S,
    MESSAGE_S,
    MESSAGES,
    MODE,
    NORTH,
    ORIGIN_ALT,
    ORIGIN_LAT,
    ORIGIN_LON,
    PLACE,
    POSITION_S,
    POWER_W,
    READINGS,
    RECEIVED_REPORTED_S,
    SEVERAL_BATTERIES,
    UNKNOWN,
    V_DOWN,
    V_EAST,
    V_NORTH,
    TelemetryReader,
    kept_elsewhere,
)
from gcs.telemetry.state import EMPTY, ZERO, FleetSnapshot, Vec3
from gcs.telemetry.track import Instant, Member, VehicleTrack
from skytender import elementary, geodesy
from skytender import mavlink as mav
from skytender.safety.traffic import KnownTraffic

MOST_MODES = 255
"""AVAILABLE_MODES counts no more."""
ORIGIN_JUMP_M = 50.0
"""By more than that the origin of an armed vehicle's frame does not move."""


@dataclass(frozen=True)
class GlobalOrigin:
    """The common frame's origin."""

    lat_deg: float
    lon_deg: float
    alt_m: float


class Fleet:
    """Collects telemetry; `snapshot` is what everything else reads."""

    def __init__(self, members: Iterable[Member], origin: GlobalOrigin) -> None:
        self._tracks = {member.sysid: VehicleTrack(member) for member in members}
        self.origin = origin
        for track in self._tracks.values():
            if track.member.airborne:  # it holds unless it soon gets set points, which need its place
                track.offset, track.origin_alt_m = ZERO, origin.alt_m
        self._traffic = KnownTraffic()
        self.statustexts: list[tuple[int, int, str]] = []
        self.acks: list[tuple[int, Any]] = []
        self.facts: list[tuple[int, Fact]] = []
        self._talking: set[int] = set()
        """senders that may have more to say of a text"""
        self._found = np.zeros(FOUND)
        self._number = 0
        """of the last snapshot"""
        self._lay_out()

    def _lay_out(self) -> None:
        """Let the vehicles live in tables with a row each, in order of system id; all count as changed."""
        self._tracks = dict(sorted(self._tracks.items()))
        count = len(self._tracks)
        self._sysids = tuple(self._tracks)
        self._rows = {sysid: row for row, sysid in enumerate(self._tracks)}
        self._readings, self._facts = np.zeros((count, READINGS)), np.zeros((count, FACTS))
        self._accounts = np.zeros(count, energy.ACCOUNT)
        seen, self._changed = np.full(count, -1), np.full(count, self._number + 1)
        self._filler = ColumnFiller(self._readings, self._facts, self._accounts, seen, self._changed)
        row_by_sysid = np.full(NUMBERS, -1)
        row_by_sysid[list(self._rows)] = list(self._rows.values())
        self._reader = TelemetryReader(row_by_sysid, self._readings, self._accounts, _ELSEWHERE, self._found)
        for row, track in enumerate(self._tracks.values()):
            track.live_in(self._readings[row], self._facts[row], self._accounts[row : row + 1])
        self._statuses = [track.status() for track in self._tracks.values()]

    def _settle(self, track: VehicleTrack) -> None:
        """After something else than figures may have changed."""
        row, status = self._rows[track.member.sysid], track.status()
        if status != self._statuses[row]:
            self._statuses[row] = status
            self._changed[row] = self._number + 1

    def ingest(self, frame: Frame, time_s: float) -> None:
        """Take one frame that was delivered at a session time."""
        row = self._rows.get(frame.sysid)
        if row is not None:
            self._read(frame.sysid, row, frame.raw, 0, len(frame.raw), time_s)
        elif frame.msgid == mav.MAVLINK_MSG_ID_ADSB_VEHICLE:
            self._receive_traffic(fields(frame), time_s)

    def ingest_all(self, frames: Iterable[Frame], time_s: float) -> None:
        """Take frames that were delivered at a session time, in their order."""
        if isinstance(frames, FrameRun) and (row := self._rows.get(frames.sender[0])) is not None:
            self._read(frames.sender[0], row, frames.data, *frames.span, time_s)
            return
        for frame in frames:
            self.ingest(frame, time_s)

    def ingest_runs(self, runs: AnswerRuns, time_s: float) -> None:
        """As `ingest_all` with each of them."""
        data, spans, rows = runs.frames.data, runs.frames.spans, runs.rows
        run = at = end = row = 0
        while True:
            run, at, why = self._reader.read_runs(data, at, end, row, run, spans, rows, time_s)
            if why == END:
                return
            one = rows[run - 1]
            end, sysid = int(spans[one[LAST] - 1, 1]), int(one[SYSID])
            if why == UNKNOWN:
                self.ingest_all(list(runs[run - 1]), time_s)
                at = end
            else:
                at = self._go_on(self._tracks[sysid], data, at, why, time_s)
                row = self._rows[sysid]

    def ingest_dated(
        self,
        data: bytes,
        places: NDArray[np.int64],
        sysids: NDArray[np.int64],
        times_s: NDArray[np.float64],
        of: Collection[int],
        other: Callable[[int], object],
    ) -> None:
        """As `ingest` with n frames, each at its own session time, of these vehicles; `other` is called with the
        number of each further frame, in its turn.

        Args:
            places, sysids, times_s: (n,) where in `data` each frame begins, its sender, and its time.
        """
        k, row_by_sysid = 0, self._rows_of(of)
        while True:
            k, at, why = self._reader.read_dated(data, places, sysids, times_s, row_by_sysid, k, len(places))
            if why == END:
                return
            if why == UNKNOWN:
                other(k)
                row_by_sysid = self._rows_of(of)  # another vehicle may have joined
            else:
                sysid, time_s = int(sysids[k]), float(times_s[k])
                at = self._go_on(self._tracks[sysid], data, at, why, time_s)
                end = int(places[k]) + len(frame_at(data, int(places[k])).raw)
                self._read(sysid, self._rows[sysid], data, at, end, time_s)
            k += 1

    def _rows_of(self, sysids: Collection[int]) -> NDArray[np.int64]:
        """(256,) rows of these vehicles by system id, -1 of others."""
        row_by_sysid = np.full(NUMBERS, -1)
        for sysid in sysids:
            row_by_sysid[sysid] = self._rows[sysid]
        return row_by_sysid

    def _read(self, sysid: int, row: int, data: bytes, at: int, end: int, time_s: float) -> None:
        """Read the frames of one vehicle, which lie there whole and one after the other."""
        at, why = self._reader.read(data, at, end, row, time_s)
        while why != END:
            at = self._go_on(self._tracks[sysid], data, at, why, time_s)
            at, why = self._reader.read(data, at, end, row, time_s)

    def _go_on(self, track: VehicleTrack, data: bytes, at: int, why: int, time_s: float) -> int:
        """Do what compiled code stopped for; where the next frame begins."""
        battery, found = track.battery, self._found
        if why == ELSEWHERE:
            frame = frame_at(data, at)
            at += len(frame.raw)
            content = chunk_of(frame) if frame.msgid == mav.MAVLINK_MSG_ID_STATUSTEXT else fields(frame)
            _HANDLERS[frame.msgid](self, track, content, time_s)
        elif why == MODE:
            track.take_mode()
        elif why == PLACE:
            fault, moved_m = found[:2].tolist()
            track.doubts(plausibility.impossible_place(int(fault), moved_m), time_s)
        else:
            track.doubts(battery.taken(*found.tolist()), time_s)
        self.facts += [(track.member.sysid, fact) for fact in battery.facts]
        battery.facts.clear()
        self._settle(track)
        return at

    def join(self, member: Member) -> None:
        """Add a vehicle that was unknown before; the snapshot keeps its order of system ids."""
        self._tracks[member.sysid] = VehicleTrack(member)
        self._lay_out()

    def take_place(self, sysid: int, at_ned: Vec3, v_ned: Vec3, uncertain: str, time_s: float) -> None:
        """Take a vehicle's place and velocity (m, m/s, common frame) as of a session time, which another reader has
        worked out; and why it is uncertain, if it is."""
        track = self._tracks[sysid]
        row = track.readings
        # What has become certain, or is so no more, has not moved there.
        known = track.offset is not None and uncertain == track.uncertain
        moved_m = elementary.distance(at_ned, row[[NORTH, EAST, DOWN]].tolist()) if known else math.nan
        fault = plausibility.place_fault(0.0, 0.0, at_ned[2], *v_ned, moved_m, time_s - float(row[POSITION_S]))
        if fault == plausibility.POSSIBLE:
            row[[NORTH, EAST, DOWN]], row[[V_NORTH, V_EAST, V_DOWN]] = at_ned, v_ned
            row[POSITION_S] = time_s
        else:
            track.doubts(plausibility.impossible_place(fault, moved_m), time_s)
        if fault != plausibility.POSSIBLE or not known:
            track.offset, track.uncertain = ZERO, uncertain
            self._settle(track)

    def move_zero(self, origin: GlobalOrigin, keep: Collection[int]) -> None:
        """Let the common frame begin elsewhere; places of vehicles that `keep` names are not known to be above the sea,
        and keep their heights."""
        place = frame_place(*astuple(self.origin), *astuple(origin))
        self.origin = origin
        for sysid, track in self._tracks.items():
            row = track.readings
            down_m = row[DOWN]
            row[[NORTH, EAST, DOWN]] = place.moved(tuple(row[[NORTH, EAST, DOWN]].tolist()))
            row[[V_NORTH, V_EAST, V_DOWN]] = turned(tuple(row[[V_NORTH, V_EAST, V_DOWN]].tolist()), place.turn_rad)
            if sysid in keep:
                row[DOWN] = down_m
        self._traffic.move(lambda at_ned, v_ned: (place.moved(at_ned), turned(v_ned, place.turn_rad)))

    def note_message(self, sysid: int, time_s: float) -> None:
        """A message of a vehicle's autopilot came that is not for `ingest`."""
        self._tracks[sysid].readings[MESSAGE_S] = time_s

    def lost(self, sysid: int) -> None:
        """A vehicle's process has died."""
        self._tracks[sysid].alive = False
        self._settle(self._tracks[sysid])

    def found(self, sysid: int) -> None:
        """A vehicle that was lost reports again."""
        self._tracks[sysid].alive = True
        self._settle(self._tracks[sysid])

    def set_clock(self, sysid: int, offset_s: float) -> None:
        """Offset from this vehicle's own time to the session's, s."""
        self._tracks[sysid].readings[CLOCK_S] = offset_s

    def pop_statustexts(self, now_s: float) -> list[tuple[int, int, str]]:
        """(system id, severity, text) of each STATUSTEXT since the last call."""
        if not (self.statustexts or self._talking):
            return []
        taken, self.statustexts = self.statustexts, []
        for sysid in sorted(self._talking):
            texts = self._tracks[sysid].texts
            taken += [(sysid, *text) for text in texts.overdue(now_s)]
            if not texts.open:
                self._talking.remove(sysid)
        return sorted(taken, key=itemgetter(0))

    def pop_acks(self) -> list[tuple[int, Any]]:
        """(system id, COMMAND_ACK) of each acknowledgement since the last call."""
        if not self.acks:
            return []
        taken, self.acks = self.acks, []
        return sorted(taken, key=itemgetter(0))

    def pop_facts(self) -> list[tuple[int, Fact]]:
        """(system id, fact) of what batteries showed since the last call."""
        taken, self.facts = self.facts, []
        return sorted(taken, key=itemgetter(0))

    def batteries(self, sysid: int) -> list[VehicleBattery]:
        """All of a vehicle that has several; none of one that has but number 0."""
        return self._tracks[sysid].batteries.all

    def remote_id(self, sysid: int) -> str:
        """A vehicle's Remote ID and its status, for a person; empty where it sends none."""
        return self._tracks[sysid].remote_id.text

    def book(self, sysid: int, joules: int) -> None:
        """Energy that a vehicle was given by a base and cannot report itself."""
        self._tracks[sysid].battery.book(joules)
        self._settle(self._tracks[sysid])

    def snapshot(self, time_s: float) -> FleetSnapshot:
        """Everything known at a session time."""
        count = len(self._statuses)
        flags, places = np.empty((FLAGS, count), np.bool_), np.empty((PLACES, count, 3))
        figures = np.empty((FIGURES, count))
        self._number += self._filler.fill(time_s, self._number + 1, flags.view(np.uint8), places, figures)
        facts, changed = self._facts.copy(), self._changed.copy()
        frames = facts[:, OFFSET_N : TURN + 1]
        columns = FleetColumns(self._sysids, self._rows, self._number, changed, flags, places, figures, frames)
        instant = Instant(time_s, tuple(self._statuses), self._readings.copy(), facts, columns)
        return FleetSnapshot.of_columns(time_s, columns, instant.views, self._traffic.at(time_s))

    def _global_origin(self, track: VehicleTrack, content: Any, time_s: float) -> None:
        if track.doubts(plausibility.globe(content.latitude, content.longitude), time_s):
            return
        told = (1e-7 * content.latitude, 1e-7 * content.longitude, 1e-3 * content.altitude)
        place = _origin_place(told, track.member.external, self.origin)
        offset = place.offset_ned
        known = track.offset if track.origin_reported and track.armed else None
        if known is not None and elementary.distance(offset, known) > ORIGIN_JUMP_M:
            track.doubts("its origin moves while it is armed", time_s)
            track.origin_refused = True
            track.readings[[ORIGIN_LAT, ORIGIN_LON, ORIGIN_ALT]] = math.nan
            return
        track.origin_refused = False
        track.offset, track.turn_rad = place
        track.origin_alt_m = 1e-3 * content.altitude
        track.origin_reported = True
        track.readings[[ORIGIN_LAT, ORIGIN_LON, ORIGIN_ALT]] = content.latitude, content.longitude, content.altitude

    def _home(self, track: VehicleTrack, content: Any, time_s: float) -> None:
        """An external vehicle's ground; and where its frame lies, if it says so by no other message."""
        if not track.member.external or track.doubts(plausibility.globe(content.latitude, content.longitude), time_s):
            return
        track.home_amsl_m = 1e-3 * content.altitude
        track.home_down_m = self.origin.alt_m - track.home_amsl_m
        local = (content.x, content.y, content.z)
        says_frame = track.profile.home_is_local and not track.origin_reported
        if not says_frame or not all(abs(axis) <= plausibility.FARTHEST_M for axis in local):
            return
        home = (1e-7 * content.latitude, 1e-7 * content.longitude, track.home_amsl_m)
        track.offset, track.turn_rad = frame_place(*origin_under(*home, local), *astuple(self.origin))
        track.origin_alt_m = track.home_amsl_m + content.z

    def _fix(self, track: VehicleTrack, content: Any, time_s: float) -> None:
        track.accuracy.satellites(content, time_s)
        fix = content.fix_type, content.h_acc, content.v_acc, track.armed
        track.readings[[FIX_TYPE, FIX_H, FIX_V, FIX_ARMED]] = fix

    def _named_int(self, track: VehicleTrack, content: Any, time_s: float) -> None:
        known = content.name in (RECEIVED, GIVEN)
        if not known or track.doubts(track.battery.counter(content.name, content.value, time_s), time_s):
            return
        reported_s = track.session_s(content.time_boot_ms, time_s)
        when = GIVEN_REPORTED_S if content.name == GIVEN else RECEIVED_REPORTED_S
        track.readings[when] = max(track.readings[when], reported_s)

    def _parameter(self, track: VehicleTrack, content: Any, time_s: float) -> None:
        if content.param_id in BATTERY_PARAMETERS:
            value = track.profile.parameter_number(content.param_value, content.param_type)
            track.doubts(track.battery.parameter(content.param_id, value), time_s)

    def _battery(self, track: VehicleTrack, content: Any, time_s: float) -> None:
        """One battery of several: what counts is what they say together."""
        if not track.readings[SEVERAL_BATTERIES]:
            track.readings[SEVERAL_BATTERIES] = 1.0
            first = track.readings[FIRST_BATTERY].tolist()
            if first[0] > -math.inf:
                track.batteries.begin_with(AUTOPILOT, first)
        if track.batteries.add(AUTOPILOT, content, time_s):
            track.battery.begin_anew()
        track.doubts(track.battery.report(track.batteries.report(time_s), armed=track.armed), time_s)
        track.readings[POWER_W] = track.battery.power_w

    def _statustext(self, track: VehicleTrack, content: Any, time_s: float) -> None:
        self.statustexts += [(track.member.sysid, *text) for text in track.texts.add(content, time_s)]
        if track.texts.open:
            self._talking.add(track.member.sysid)

    def _available_mode(self, track: VehicleTrack, content: Any, time_s: float) -> None:
        listed = ListedMode(content.standard_mode, content.mode_name, content.mode_index, content.number_modes)
        if track.listed_modes.get(content.custom_mode) != listed and len(track.listed_modes) < MOST_MODES:
            track.listed_modes = {**track.listed_modes, content.custom_mode: listed}
            track.take_mode()

    def _remote_id(self, track: VehicleTrack, content: Any, time_s: float) -> None:
        self.statustexts += [(track.member.sysid, *text) for text in track.remote_id.take(content)]

    def _modes_changed(self, track: VehicleTrack, content: Any, time_s: float) -> None:
        if content.seq != track.modes_seq:
            track.listed_modes, track.modes_seq = EMPTY, content.seq

    def _ack(self, track: VehicleTrack, content: Any, time_s: float) -> None:
        self.acks.append((track.member.sysid, content))

    def _receive_traffic(self, content: Any, time_s: float) -> None:
        if plausibility.globe(content.lat, content.lon):
            return
        place = 1e-7 * content.lat, 1e-7 * content.lon, 1e-3 * content.altitude
        p_ned = geodesy.ned_of(*place, astuple(self.origin))
        self._traffic.receive(content, p_ned, time_s)


@lru_cache(maxsize=1024)  # each vehicle tells its own again and again
def _origin_place(told: Vec3, external: bool, origin: GlobalOrigin) -> FramePlace:
    """Where the frame of a vehicle lies that tells its origin (deg, deg, m); that of one of ours is parallel."""
    ours = astuple(origin)
    return frame_place(*told, *ours) if external else FramePlace(geodesy.ned_of(*told, ours), 0.0)


_HANDLERS: Mapping[int, Callable[[Fleet, VehicleTrack, Any, float], None]] = {
    mav.MAVLINK_MSG_ID_GPS_GLOBAL_ORIGIN: Fleet._global_origin,
    mav.MAVLINK_MSG_ID_HOME_POSITION: Fleet._home,
    mav.MAVLINK_MSG_ID_NAMED_VALUE_INT: Fleet._named_int,
    mav.MAVLINK_MSG_ID_PARAM_VALUE: Fleet._parameter,
    mav.MAVLINK_MSG_ID_BATTERY_STATUS: Fleet._battery,
    mav.MAVLINK_MSG_ID_STATUSTEXT: Fleet._statustext,
    mav.MAVLINK_MSG_ID_COMMAND_ACK: Fleet._ack,
    mav.MAVLINK_MSG_ID_ADSB_VEHICLE: lambda fleet, _, content, time_s: fleet._receive_traffic(content, time_s),
    mav.MAVLINK_MSG_ID_AVAILABLE_MODES: Fleet._available_mode,
    mav.MAVLINK_MSG_ID_AVAILABLE_MODES_MONITOR: Fleet._modes_changed,
    mav.MAVLINK_MSG_ID_GPS_RAW_INT: Fleet._fix,
    mav.MAVLINK_MSG_ID_ESTIMATOR_STATUS: lambda _, track, content, _s: track.accuracy.estimator(content),
    mav.MAVLINK_MSG_ID_OPEN_DRONE_ID_BASIC_ID: Fleet._remote_id,
    mav.MAVLINK_MSG_ID_OPEN_DRONE_ID_LOCATION: Fleet._remote_id,
}
"""Of messages that are not among the readings, or not always: BATTERY_STATUS of a vehicle with several."""
_FROM_ANYBODY = (mav.MAVLINK_MSG_ID_ADSB_VEHICLE,)
_ELSEWHERE = kept_elsewhere(_HANDLERS.keys() - MESSAGES, _FROM_ANYBODY)
