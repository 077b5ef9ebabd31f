"""Time series of a session, out of what was recorded: per vehicle motion, attitude, battery, competition and link.

Session seconds, SI, the common NED frame. A series is times (k,) and values (k,); NaN in the values is a gap.
"""

from __future__ import annotations

import math
from collections import namedtuple
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import chain, repeat
from operator import itemgetter
from typing import Any, NamedTuple

import numpy as np
import pymap3d
from numpy.typing import NDArray

from gcs.mavlink import statustext
from gcs.mavlink.autopilots import GENERIC, PROFILES, STEERABLE, FlightMode, Profile, profile_of
from gcs.mavlink.battery import BatteryReports, battery_statuses, sys_statuses
from gcs.mavlink.common_frame import FramePlace, frame_place, turned
from gcs.mavlink.ids import AUTOPILOT
from gcs.mavlink.statustext import TextChunk
from gcs.recording.session_folder import Recorded, rows_of
from gcs.telemetry.batteries import together
from gcs.telemetry.battery_account import BATTERY_PARAMETERS, GIVEN, RECEIVED, BatteryAccount
from gcs.telemetry.plausibility import FARTHEST_M, FASTEST_M_S
from gcs.telemetry.state import STALE_S
from skytender import mavlink as mav

Floats = NDArray[np.float64]
PARALLEL_M = 1.0
"""A frame whose zero is less than this away was launched there: degE7 are rounded."""
GAP_S = 2.0
"""Silence longer than this is drawn as a gap."""
LATE_S = 5.0
"""A vehicle's own time is believed where it is at most this much before the arrival: else its clock is another one."""
ARMED, ON_GROUND, UNDEFINED_STATE = 0x80, 1, 0
CUT_OFF_S, BLAMED_S = 2.0, 3.0
"""Places missing for longer than the former excuse what a vehicle does until the latter after it (its arming sequence
in gcs/supervisor/arming.py)."""
_LED = STEERABLE | {FlightMode.MISSION}
_TimedContent = tuple[float, float, str, Any]
"""(session time in s, place in the file, message, its content), which so stand in the order in which they came"""


class Series(NamedTuple):
    """Times (k,) in s, ascending, and values (k,)."""

    t_s: Floats
    values: Floats


@dataclass(frozen=True)
class VehicleInfo:
    """Vehicles that flew."""

    sysid: int
    role: str
    label: str


@dataclass(frozen=True)
class Track:
    """One vehicle's positions (k, 3) m and velocities (k, 3) m/s, common NED frame, at the times when they were so."""

    t_s: Floats
    p_ned: Floats
    v_ned: Floats
    came_s: Floats
    """(k,) when each was received"""
    armed: Series
    in_air: Series

    def flying(self, t_s: Floats) -> NDArray[np.bool_]:
        """(k,) whether it was armed and in the air at each time, and had reported its place lately."""
        last = np.searchsorted(self.t_s, t_s, side="right") - 1
        age_s = np.where(last >= 0, t_s - self.t_s[np.maximum(last, 0)], np.inf) if len(self.t_s) else t_s + np.inf
        return (age_s <= STALE_S) & (held(self.armed, t_s) > 0.0) & (held(self.in_air, t_s) > 0.0)

    def at(self, t_s: Floats) -> Floats:
        """(k, 3) places as the ground station knew them: the last one reported, carried forward by its age; NaN where
        the vehicle did not fly or had not reported its place lately."""
        if not len(self.t_s):
            return np.full((len(t_s), 3), np.nan)
        last = np.maximum(np.searchsorted(self.t_s, t_s, side="right") - 1, 0)
        carried = self.p_ned[last] + self.v_ned[last] * (t_s - self.t_s[last])[:, np.newaxis]
        return np.where(self.flying(t_s)[:, np.newaxis], carried, np.nan)


def held(series: Series, t_s: Floats) -> Floats:
    """(k,) the latest value at each time, as of a state that holds until it changes; 0 before the first."""
    if not len(series.t_s):
        return np.zeros(len(t_s))
    last = np.searchsorted(series.t_s, t_s, side="right") - 1
    return np.where(last >= 0, series.values[np.maximum(last, 0)], 0.0)


def vehicles(recorded: Recorded) -> list[VehicleInfo]:
    """Every vehicle that flew, in order of system id, as the scenario, else the summary, else the recording names
    them."""
    if recorded.scenario is not None:
        return [VehicleInfo(v.sysid, v.role, v.label) for v in recorded.scenario.vehicles.all]
    if recorded.summary is not None:
        return [VehicleInfo(v.sysid, v.role, f"{v.role} {v.sysid}") for v in recorded.summary.vehicles]
    return [VehicleInfo(sysid, "vehicle", f"vehicle {sysid}") for sysid in senders(recorded)]


def senders(recorded: Recorded) -> list[int]:
    """The system ids that reported a position."""
    return sorted({*by_vehicle(recorded, "LOCAL_POSITION_NED"), *by_vehicle(recorded, "GLOBAL_POSITION_INT")})


def tracks(recorded: Recorded) -> dict[int, Track]:
    """Each vehicle's track: by its own frame where it reported where that frame's zero lies, else by its places on the
    globe, of a recording that holds them."""
    origins = by_vehicle(recorded, "GPS_GLOBAL_ORIGIN")
    zero = _zero(recorded)
    armed = by_vehicle(recorded, "HEARTBEAT")
    landed = by_vehicle(recorded, "EXTENDED_SYS_STATE")
    if zero is None:
        return {}
    known = {sysid: _by_global(rows, zero) for sysid, rows in by_vehicle(recorded, "GLOBAL_POSITION_INT").items()}
    for sysid, rows in by_vehicle(recorded, "LOCAL_POSITION_NED").items():
        if sysid in origins:
            known[sysid] = _by_local(rows, _frame(_place(origins[sysid][0]), zero))
    found = {}
    for sysid, (t_s, p_ned, v_ned, came_s) in sorted(known.items()):
        # In the order in which they were true; what came late and out of order changes nothing that is known.
        with np.errstate(invalid="ignore", over="ignore"):  # a vehicle may tell anything; so much of it is believed
            good = (np.abs(p_ned) <= FARTHEST_M).all(axis=1) & (np.abs(v_ned) <= FASTEST_M_S).all(axis=1)
        good &= t_s >= np.maximum.accumulate(np.where(good, t_s, -np.inf))
        beats, states = armed.get(sysid), landed.get(sysid)
        found[sysid] = Track(
            t_s[good],
            p_ned[good],
            v_ned[good],
            came_s[good],
            _state(beats, None if beats is None else beats["base_mode"] & ARMED > 0),
            _state(states, None if states is None else ~np.isin(states["landed_state"], (ON_GROUND, UNDEFINED_STATE))),
        )
    return found


def _by_local(rows: NDArray[Any], place: FramePlace) -> tuple[Floats, Floats, Floats, Floats]:
    """Times, places and velocities (k, 3) in the common frame, and times of reception, by LOCAL_POSITION_NED."""
    p_ned = _turned(np.column_stack([rows[axis] for axis in "xyz"]), place.turn_rad) + place.offset_ned
    v_ned = _turned(np.column_stack([rows[f"v{axis}"] for axis in "xyz"]), place.turn_rad)
    return _times_s(rows), p_ned, v_ned, rows["t_s"]


def _by_global(rows: NDArray[Any], zero: tuple[float, float, float]) -> tuple[Floats, Floats, Floats, Floats]:
    """The same by GLOBAL_POSITION_INT; autopilots without a fix report 0, 0."""
    rows = rows[(rows["lat"] != 0) | (rows["lon"] != 0)]
    p_ned = pymap3d.geodetic2ned(1e-7 * rows["lat"], 1e-7 * rows["lon"], 1e-3 * rows["alt"], *zero)
    v_ned = np.column_stack([1e-2 * rows[f"v{axis}"].astype(np.float64) for axis in "xyz"])
    return _times_s(rows), np.column_stack(p_ned), v_ned, rows["t_s"]


def _frame(own: tuple[float, float, float], zero: tuple[float, float, float]) -> FramePlace:
    """Where a frame lies in the common one; one with its zero, but for rounding, is parallel to it."""
    place = frame_place(*own, *zero)
    if math.hypot(*place.offset_ned[:2]) >= PARALLEL_M:
        return place
    north, east, down = (float(x) for x in pymap3d.geodetic2ned(*own, *zero))
    return FramePlace((north, east, down), 0.0)


def _turned(rows: NDArray[Any], turn_rad: float) -> Floats:
    """Vectors (k, 3) of a frame that is turned by so much, in the other's axes."""
    vectors = rows.astype(np.float64)
    with np.errstate(invalid="ignore", over="ignore"):  # a vehicle may tell anything
        return np.column_stack(turned((vectors[:, 0], vectors[:, 1], vectors[:, 2]), turn_rad))


def traffic(recorded: Recorded) -> dict[str, Track]:
    """The tracks of other aircraft, by callsign; each report holds until the next."""
    table = recorded.tables.get("ADSB_VEHICLE")
    zero = _zero(recorded)
    if table is None or not len(table) or zero is None:
        return {}
    found = {}
    for address in np.unique(table["ICAO_address"]):
        rows = table[table["ICAO_address"] == address]
        _, first = np.unique(rows["t_s"], return_index=True)  # each vehicle's relay receives the same
        rows = rows[first]
        places = pymap3d.geodetic2ned(1e-7 * rows["lat"], 1e-7 * rows["lon"], 1e-3 * rows["altitude"], *zero)
        heading_rad, speed_m_s = np.radians(1e-2 * rows["heading"]), 1e-2 * rows["hor_velocity"]
        v_ned = (speed_m_s * np.cos(heading_rad), speed_m_s * np.sin(heading_rad), -1e-2 * rows["ver_velocity"])
        always = Series(np.array([-math.inf]), np.ones(1))
        name = rows["callsign"][0].decode("ascii", "replace") or f"{address:06X}"
        found[name] = Track(
            rows["t_s"], np.column_stack(places), np.column_stack(v_ned).astype(np.float64), rows["t_s"], always, always
        )
    return found


def attitudes(recorded: Recorded) -> dict[int, tuple[Series, Series, Series]]:
    """Roll, pitch and yaw in rad of each vehicle, NED."""
    found = {}
    for sysid, rows in by_vehicle(recorded, "ATTITUDE").items():
        t_s = _times_s(rows)
        order = np.argsort(t_s, kind="stable")
        roll, pitch, yaw = (
            Series(t_s[order], rows[name][order].astype(np.float64)) for name in ("roll", "pitch", "yaw")
        )
        found[sysid] = (roll, pitch, yaw)
    return found


def with_gaps(series: Series, gap_s: float = GAP_S, end_s: float | None = None) -> Series:
    """The series with a NaN `gap_s` after each value that no other follows by then, up to `end_s` behind the last."""
    follow_s = series.t_s[1:] if end_s is None else np.append(series.t_s[1:], end_s)
    last = np.flatnonzero(follow_s - series.t_s[: len(follow_s)] > gap_s)
    return Series(np.insert(series.t_s, last + 1, series.t_s[last] + gap_s), np.insert(series.values, last + 1, np.nan))


@dataclass(frozen=True)
class BatterySeries:
    """Energy in a battery, in J, at each report of it, and its capacity."""

    capacity_j: float
    remaining: Series

    def is_empty(self, t_s: Floats) -> NDArray[np.bool_]:
        """(k,) whether it was known to be empty at each time."""
        return held(Series(self.remaining.t_s, np.where(self.remaining.values <= 0.0, 1.0, 0.0)), t_s) > 0.0


def batteries(recorded: Recorded) -> dict[int, BatterySeries]:
    """Each vehicle's battery after each report of it, and at the end: the account that the session kept, kept again."""
    statuses, second_hand = by_vehicle(recorded, "BATTERY_STATUS"), by_vehicle(recorded, "SYS_STATUS")
    others = {name: by_vehicle(recorded, name) for name in ("HEARTBEAT", "PARAM_VALUE", "NAMED_VALUE_INT")}
    vehicles = {v.sysid: v for v in recorded.scenario.vehicles.all} if recorded.scenario else {}
    booked, found = _booked(recorded), {}
    for sysid in sorted(statuses.keys() | second_hand.keys()):
        vehicle = vehicles.get(sysid)
        capacity_j = vehicle.battery.capacity_j if vehicle else 0.0
        initial_j = 0.01 * vehicle.battery.initial_percent * capacity_j if vehicle else 0.0
        rules = vehicle.foreign if vehicle else None
        account = BatteryAccount(
            capacity_j, initial_j, from_now=bool(vehicle and vehicle.external), started=bool(vehicle and not rules)
        )
        profile = PROFILES.get(rules.autopilot) if rules else None
        messages = (_messages(kind, rows[sysid]) for kind, rows in others.items() if sysid in rows)
        reports, places, anew = _battery_reports(statuses.get(sysid), second_hand.get(sysid))
        between = sorted(chain(*messages, booked.get(sysid, ()), anew), key=itemgetter(0, 1, 2))
        known = _kept(account, reports, places, between, profile)
        if vehicle is None and account.capacity_j:  # that it said in flight, and its shares before that are of it
            account = BatteryAccount(account.capacity_j, initial_j)
            known = _kept(account, reports, places, between, profile)
        if account.capacity_j and len(known.t_s):
            if known.values[-1] != account.remaining_j:
                known = Series(
                    np.append(known.t_s, max(recorded.end_s, known.t_s[-1])),
                    np.append(known.values, account.remaining_j),
                )
            found[sysid] = BatterySeries(account.capacity_j, known)
    return found


def _battery_reports(
    statuses: NDArray[Any] | None, second_hand: NDArray[Any] | None
) -> tuple[BatteryReports, NDArray[Any], list[_TimedContent]]:
    """One vehicle's reports (n,) of its battery in the order in which they came, each one's place in the file, and when
    others of several batteries than before are meant."""
    read, places, anew = [], [], list[_TimedContent]()
    if statuses is not None:
        several = (statuses["id"] != 0) | (statuses["battery_function"] > mav.MAV_BATTERY_FUNCTION_PROPULSION)
        first = int(np.argmax(several)) if several.any() else len(several)
        alone = min(first, 1)  # the last of battery 0 before the first of another goes with those after it
        rest = statuses[first - alone :]
        reports, others = together(AUTOPILOT, zip(rest["t_s"].tolist(), _contents(rest), strict=True))
        read += [battery_statuses(statuses[:first]), reports.take(slice(alone, None))]
        others = [at for at in others if at >= alone]
        anew = [(float(t_s), float(place), "anew", None) for t_s, place in rest[["t_s", "place"]][others].tolist()]
        places.append(statuses["place"])
    if second_hand is not None:
        read.append(sys_statuses(second_hand))
        places.append(second_hand["place"])
    place = np.concatenate(places)
    reports = BatteryReports(*map(np.concatenate, zip(*read, strict=True)))
    order = np.lexsort((place, reports.t_s))
    return reports.take(order), place[order], anew


def _messages(kind: str, rows: NDArray[Any]) -> Iterator[_TimedContent]:
    """One vehicle's messages of a kind, in the file's order, without those that only repeat what an account keeps."""
    if kind == "HEARTBEAT":
        states = rows[["base_mode", "autopilot"]]
        rows = rows[np.append(True, states[1:] != states[:-1])]
    elif kind == "NAMED_VALUE_INT":
        counters = (rows[rows["name"] == name.encode()] for name in (RECEIVED, GIVEN))
        rows = np.concatenate([_at_changes(counter) for counter in counters])
    elif kind == "PARAM_VALUE":
        rows = rows[np.isin(rows["param_id"], [name.encode() for name in BATTERY_PARAMETERS])]
    return zip(rows["t_s"].tolist(), rows["place"].tolist(), repeat(kind), _contents(rows))


def _at_changes(rows: NDArray[Any]) -> NDArray[Any]:
    """A counter's rows at both ends of each run of equal values: how fast it grows is what is judged."""
    changes = rows["value"][1:] != rows["value"][:-1]
    return rows[np.append(True, changes) | np.append(changes, True)] if len(rows) else rows


def _contents(rows: NDArray[Any]) -> Iterator[Any]:
    """Rows of a table as messages' contents, fields by name."""
    return map(_content(rows.dtype.names or ())._make, rows.tolist())


@cache
def _content(names: tuple[str, ...]) -> Any:
    return namedtuple("content", names)


def _kept(
    account: BatteryAccount,
    reports: BatteryReports,
    places: NDArray[Any],
    between: Sequence[_TimedContent],
    profile: Profile | None,
) -> Series:
    """Energy in the battery in J after each report that counts, other messages taken between them as they came."""
    armed, speaks = False, profile or GENERIC
    left_j, done = [], 0
    every = *between, (math.inf, math.inf, "end", None)
    at = np.array([(t_s, place) for t_s, place, *_ in every])
    order = np.lexsort((np.append(at[:, 1], places), np.append(at[:, 0], reports.t_s)))
    ends = np.flatnonzero(order < len(every)) - np.arange(len(every))
    """number of reports before each of the others"""
    for (t_s, _, kind, content), end in zip(every, ends.tolist(), strict=True):
        if end > done:
            left_j.append(account.reports(reports.take(slice(done, end)), armed=armed))
            done = end
        if kind == "HEARTBEAT":
            armed, speaks = bool(content.base_mode & ARMED), profile or profile_of(content.autopilot)
        elif kind == "NAMED_VALUE_INT":
            account.counter(content.name.decode("ascii"), content.value, t_s)
        elif kind == "PARAM_VALUE":
            value = speaks.parameter_number(content.param_value, content.param_type)
            account.parameter(content.param_id.decode("ascii"), value)
        elif kind == "anew":
            account.begin_anew()
        elif kind == "served" and not account.reported:
            account.book(content)
    after_j = np.concatenate(left_j) if left_j else np.empty(0)
    counts = ~np.isnan(after_j)
    return Series(reports.t_s[counts], after_j[counts])


def _booked(recorded: Recorded) -> dict[int, list[_TimedContent]]:
    """Energy that bases gave to each vehicle, each service at its end."""
    booked: dict[int, list[_TimedContent]] = {}
    for d in recorded.decisions:
        if d["kind"] == "served" and d.get("base"):
            booked.setdefault(d["receiver"], []).append((d["t_s"], math.inf, "served", round(d["energy_j"])))
    return booked


@dataclass(frozen=True)
class CompetitionSeries:
    """The competition for the next refuelling: each one's state v, and the leader's share."""

    v: dict[int, Series]
    share: Series


def competition(recorded: Recorded, *, for_bases: bool = False) -> CompetitionSeries:
    """The competition for the tankers, or for the places at bases, as it was decided tick by tick; gaps where no
    vehicle competed."""
    every = (decision for decision in recorded.decisions if decision["kind"] == "competition")
    lines = [decision for decision in every if (decision.get("giver") == "base") == for_bases]
    t_s = np.array([line["t_s"] for line in lines], dtype=np.float64)
    reported = [line["v"] for line in lines]
    sysid_of = {name: int(name) for name in set().union(*reported)}
    sysids = np.fromiter((sysid_of[name] for v in reported for name in v), dtype=np.int64)
    values = np.fromiter(chain.from_iterable(v.values() for v in reported), dtype=np.float64)
    times_s = np.repeat(t_s, [len(v) for v in reported])
    gap_s = 2.5 * (recorded.scenario.clock.period_s if recorded.scenario else 0.1)
    v_of = {}
    for sysid, rows in rows_of(sysids).items():
        v_of[sysid] = with_gaps(Series(times_s[rows], values[rows]), gap_s, recorded.end_s)
    share = Series(t_s, np.array([line["share"] for line in lines], dtype=np.float64))
    return CompetitionSeries(v_of, with_gaps(share, gap_s, recorded.end_s))


@dataclass(frozen=True)
class LinkSeries:
    """Frames received from a vehicle, in bins of time: seconds, or longer ones for a long recording."""

    rate_hz: Series
    lost: Series
    """frames missing so far, by the gaps in its numbers"""
    longest_silence_s: float
    """between two positions"""


def links(recorded: Recorded, flown: dict[int, Track]) -> dict[int, LinkSeries]:
    """The link of each vehicle that was received, since the recording begins."""
    found = {}
    longest = max(map(len, recorded.traffic_count.values()), default=0)
    bin_s = recorded.traffic_bin_s
    begun = int(recorded.begin_s / bin_s + 1e-6)
    first = math.ceil(recorded.begin_s / bin_s - 1e-6)
    # The last bin is seldom whole; its rate would be a drop that never was. Its gaps count.
    whole = max(min(longest, int((recorded.end_s + 1e-6) / bin_s)), 1)
    t_s: Floats = np.minimum(bin_s * (np.arange(longest).astype(np.float64) + 0.5), recorded.end_s)
    for sysid in sorted(sysid for sysid, counts in recorded.traffic_count.items() if counts.any()):
        counts, lost = (
            np.pad(table[sysid], (0, longest - len(table[sysid])))
            for table in (recorded.traffic_count, recorded.traffic_lost)
        )
        silence_s = np.diff(flown[sysid].t_s).max(initial=0.0) if sysid in flown else math.nan
        found[sysid] = LinkSeries(
            Series(t_s[first:whole], counts[first:whole] / bin_s),
            Series(t_s[begun:], np.cumsum(lost)[begun:].astype(np.float64)),
            float(silence_s),
        )
    return found


def landings(recorded: Recorded) -> list[tuple[float, int, bool]]:
    """(time in s, system id, whether it came down) of the scenario's vehicles with an autopilot of ours: when each
    began to fly by what the session ordered, and when its motors stopped after that.

    Left out is one whose places were missing until just before: its failsafe may have landed it, and it rejoins.
    """
    if recorded.scenario is None:
        return []
    beats, states = by_vehicle(recorded, "HEARTBEAT"), by_vehicle(recorded, "EXTENDED_SYS_STATE")
    places = by_vehicle(recorded, "LOCAL_POSITION_NED")
    ours = {vehicle.sysid for vehicle in recorded.scenario.vehicles.all if not vehicle.is_foreign}
    found = []
    for sysid in sorted(ours & beats.keys() & states.keys()):
        rows, state = beats[sysid], states[sysid]
        in_air = held(_state(state, ~np.isin(state["landed_state"], (ON_GROUND, UNDEFINED_STATE))), rows["t_s"]) > 0.0
        placed_s = _times_s(places[sysid]) if sysid in places else np.empty(0)
        flew = False
        for row, flies in zip(rows, in_air.tolist(), strict=True):
            armed = row["base_mode"] & ARMED > 0
            mode = profile_of(int(row["autopilot"]), int(row["type"])).mode(int(row["custom_mode"]))
            if armed and flies and mode in _LED and not flew:
                flew = True
                found.append((float(row["t_s"]), sysid, False))
            elif flew and not armed:
                flew = False
                if not _was_cut_off(placed_s, float(row["t_s"])):
                    found.append((float(row["t_s"]), sysid, True))
    return sorted(found)


def _was_cut_off(placed_s: Floats, t_s: float) -> bool:
    """Whether places of these times (k,) were missing for long enough up to a time, or to just before it."""
    known = placed_s[(placed_s >= t_s - BLAMED_S - CUT_OFF_S) & (placed_s <= t_s)]
    return bool((np.diff(known, prepend=t_s - BLAMED_S - CUT_OFF_S, append=t_s) > CUT_OFF_S).any())


def texts(recorded: Recorded, worst: int = 4) -> list[tuple[float, int, int, str]]:
    """(time in s, system id, severity, text) of the texts at least as severe as this, MAV_SEVERITY, put together."""
    found = []
    for sysid, rows in by_vehicle(recorded, "STATUSTEXT").items():
        chunks = zip(*(rows[name].tolist() for name in TextChunk._fields), strict=True)
        timed = zip(rows["t_s"].tolist(), map(TextChunk._make, chunks), strict=True)
        found += [(t_s, sysid, severity, text) for t_s, severity, text in statustext.recorded(timed)]
    return sorted(one for one in found if one[2] <= worst)


def by_vehicle(recorded: Recorded, message: str) -> dict[int, NDArray[Any]]:
    """The rows of a message that each vehicle's autopilot sent, in their order; none without a recording."""
    table = recorded.tables.get(message)
    if table is None:
        return {}
    own = np.flatnonzero((table["compid"] == AUTOPILOT) & (table["sysid"] < 255))
    return {sysid: table[own[rows]] for sysid, rows in rows_of(table["sysid"][own]).items()}


def _times_s(rows: NDArray[Any]) -> Floats:
    """When each row was true: by the vehicle's own clock where that is the session's."""
    own_s = 1e-3 * rows["time_boot_ms"].astype(np.float64)
    late_s = rows["t_s"] - own_s
    return np.where((late_s >= 0.0) & (late_s <= LATE_S), own_s, rows["t_s"])


def _state(rows: NDArray[Any] | None, values: NDArray[Any] | None) -> Series:
    if rows is None or values is None:
        return Series(np.empty(0), np.empty(0))
    return Series(rows["t_s"].copy(), values.astype(np.float64))


def _place(row: Any) -> tuple[float, float, float]:
    return 1e-7 * float(row["latitude"]), 1e-7 * float(row["longitude"]), 1e-3 * float(row["altitude"])


def _zero(recorded: Recorded) -> tuple[float, float, float] | None:
    """The common frame's zero (° ° m): the scenario's, else the first vehicle's, else under where one was first, at
    its home's height as it said last."""
    if recorded.scenario is not None:
        origin = recorded.scenario.origin
        return origin.lat_deg, origin.lon_deg, origin.alt_m
    if origins := by_vehicle(recorded, "GPS_GLOBAL_ORIGIN"):
        return _place(origins[min(origins)][0])
    for rows in by_vehicle(recorded, "GLOBAL_POSITION_INT").values():
        if len(known := rows[(rows["lat"] != 0) | (rows["lon"] != 0)]):
            home_m = 1e-3 * (float(known["alt"][-1]) - float(known["relative_alt"][-1]))
            return 1e-7 * float(known["lat"][0]), 1e-7 * float(known["lon"][0]), home_m
    return None
