"""All that one vehicle has reported: figures in rows that compiled code reads and fills, and the rest.

The rest stays as it is for minutes. It is kept as one immutable `VehicleStatus`, so that a snapshot can hold it
without looking at it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from gcs.mavlink.autopilots import GENERIC, STEERABLE, FlightMode, Profile, profile_of
from gcs.mavlink.common_frame import turned
from gcs.mavlink.services import standard_modes
from gcs.mavlink.services.standard_modes import Listed
from gcs.mavlink.statustext import Texts
from gcs.telemetry import fleet_columns as of
from gcs.telemetry import plausibility
from gcs.telemetry.accuracy import ReportedAccuracy
from gcs.telemetry.batteries import Batteries
from gcs.telemetry.battery_account import BatteryAccount
from gcs.telemetry.columns import IS_EMPTY, IS_LANDED, P_NED, FleetColumns
from gcs.telemetry.readings import (
    AUTOPILOT,
    BASE_MODE,
    CLOCK_S,
    CUSTOM_MODE,
    EXTERNAL,
    HEADING,
    LANDED,
    LANDED_REPORTED,
    PITCH,
    ROLL,
    SYSTEM_STATUS,
    new_readings,
)
from gcs.telemetry.remote_id import RemoteId
from gcs.telemetry.state import EMPTY, MODE_STALE_S, Vec3, VehicleView
from skytender import elementary
from skytender import mavlink as mav

_FAILSAFE = frozenset({mav.MAV_STATE_CRITICAL, mav.MAV_STATE_EMERGENCY})
_UNKNOWN: Vec3 = (math.nan, math.nan, math.nan)


@dataclass(frozen=True)
class Member:
    """A vehicle's data from the scenario, before it reports anything itself."""

    sysid: int
    role: str
    label: str
    capacity_j: float
    initial_j: float
    external: bool = False
    """not launched by the session: its clock is its own, and it may lack any message"""
    profile: Profile | None = None
    """whose habits it has; None: as its HEARTBEAT says"""
    vehicle_type: int = mav.MAV_TYPE_QUADROTOR
    """MAV_TYPE, by which ArduPilot numbers its modes"""
    battery_apart: bool = False
    """its battery takes energy whatever its autopilot does"""
    airborne: bool = False
    """launched in the air, where it is until it reports that it has landed; its frame is the common one"""


class VehicleStatus(NamedTuple):
    """All that is known of a vehicle besides figures; each as the attribute of `VehicleView` with its name."""

    member: Member
    alive: bool
    profile: Profile
    mode: FlightMode
    armed: bool
    origin_offset_ned: Vec3 | None
    ground_amsl_m: float
    battery_reported: bool
    received_j: int
    given_j: int
    energy_source: str
    ground_down_m: float | None
    custom_mode: int
    turn_rad: float
    failsafe: bool
    doubt: str
    """the last one, however long ago"""
    uncertain: str
    listed_modes: Listed
    fix_lost_s: float
    worse_m: float
    has_climbed: bool


class VehicleTrack:
    """The latest of everything that one vehicle has reported."""

    def __init__(self, member: Member) -> None:
        self.member = member
        self.alive = True
        self.profile = member.profile or GENERIC
        self.readings = new_readings()
        self.readings[[LANDED, LANDED_REPORTED]] = not member.airborne, not member.external
        self.readings[[HEADING, ROLL, PITCH]] = math.nan
        self.readings[EXTERNAL] = member.external
        if not member.external:
            self.readings[CLOCK_S] = 0.0
        self.facts = np.zeros(of.FACTS)
        self.home_amsl_m: float | None = None
        self.home_down_m: float | None = None
        self.mode = FlightMode.OTHER
        self.custom_mode = 0
        self.system_status = 0
        self.armed = False
        self.has_climbed = False
        self.offset: Vec3 | None = None
        self.turn_rad = 0.0
        self.origin_alt_m = 0.0
        self.origin_reported = False
        started = not (member.external or member.battery_apart)
        self.battery = BatteryAccount(member.capacity_j, member.initial_j, from_now=member.external, started=started)
        self.batteries = Batteries()
        """since it has reported another than number 0"""
        self.texts = Texts()
        self.remote_id = RemoteId()
        self.doubt = ""
        self.doubted_s = -math.inf
        self.origin_refused = False
        """whether the last origin that it reported is not believed: its positions may be of that frame"""
        self.uncertain = ""
        self.accuracy = ReportedAccuracy()
        self.listed_modes: Listed = EMPTY
        self.modes_seq = 0
        """AVAILABLE_MODES_MONITOR's number of that list"""

    def live_in(self, readings: NDArray[np.float64], facts: NDArray[np.float64], account: NDArray[Any]) -> None:
        """Keep figures in these rows from now on: (READINGS,), (FACTS,) and (1,) of a table of the whole fleet."""
        readings[:], facts[:], account[:] = self.readings, self.facts, self.battery.account
        self.readings, self.facts, self.battery.account = readings, facts, account

    def doubts(self, why: str, time_s: float) -> bool:
        """Whether there is a reason not to believe a report of this time; it is remembered."""
        if why:
            self.doubt, self.doubted_s = why, time_s
        return bool(why)

    def take_mode(self) -> None:
        """Take over the last HEARTBEAT."""
        autopilot, *modes = map(int, self.readings[[AUTOPILOT, CUSTOM_MODE, BASE_MODE, SYSTEM_STATUS]])
        self.custom_mode, base_mode, self.system_status = modes
        self.profile = self.member.profile or profile_of(autopilot, self.member.vehicle_type)
        self.mode = standard_modes.mode(self.profile, self.custom_mode, self.listed_modes)
        self.armed = self.accuracy.armed = bool(base_mode & mav.MAV_MODE_FLAG_SAFETY_ARMED)
        self.has_climbed = self.mode is FlightMode.TAKEOFF or (self.has_climbed and self.mode is FlightMode.HOLD)

    def session_s(self, boot_ms: int, time_s: float) -> float:
        """When it said something, by its own clock if that is known; it was not later than now."""
        offset_s = float(self.readings[CLOCK_S])
        return time_s if math.isnan(offset_s) else min(boot_ms / 1e3 + offset_s, time_s)

    def status(self) -> VehicleStatus:
        """Its status now; the facts are brought up to it."""
        offset, battery, ground_down_m = self.offset, self.battery, self.home_down_m
        if ground_down_m is None and offset is not None:
            ground_down_m = offset[2]
        self.facts[:] = (
            self.alive, self.armed, self.mode in STEERABLE,
            *(_UNKNOWN if offset is None else offset),
            self.turn_rad, elementary.cos(self.turn_rad), elementary.sin(self.turn_rad),
            math.nan if ground_down_m is None else ground_down_m,
            math.inf if self.origin_refused else self.doubted_s,
        )  # fmt: skip
        return VehicleStatus(
            self.member, self.alive, self.profile, self.mode, self.armed, offset,
            self.origin_alt_m if self.home_amsl_m is None else self.home_amsl_m,
            battery.reported, battery.received_j, battery.given_j, str(battery.source),
            ground_down_m, self.custom_mode, self.turn_rad,
            self.armed and self.system_status in _FAILSAFE,
            self.doubt, self.uncertain, self.listed_modes,
            self.accuracy.fix_lost_s, self.accuracy.worse_m, self.has_climbed,
        )  # fmt: skip


class Instant(NamedTuple):
    """The fleet at one instant, from which a vehicle's view is made on demand."""

    time_s: float
    statuses: tuple[VehicleStatus, ...]
    readings: NDArray[np.float64]
    facts: NDArray[np.float64]
    columns: FleetColumns

    def views(self, begin: int, end: int) -> list[VehicleView]:
        """The vehicles of these rows."""
        columns, rows = self.columns, slice(begin, end)
        return [
            self._view(*row)
            for row in zip(
                self.statuses[rows],
                self.readings[rows].tolist(),
                self.facts[rows, of.DOUBTED].tolist(),
                columns.figures[:, rows].T.tolist(),
                map(tuple, columns.places[P_NED, rows].tolist()),
                columns.flags[IS_LANDED, rows].tolist(),
                columns.flags[IS_EMPTY, rows].tolist(),
                strict=True,
            )
        ]

    def _view(
        self,
        status: VehicleStatus,
        readings: list[float],
        doubted_s: float,
        figures: list[float],
        p_ned: Vec3,
        landed: bool,
        empty: bool,
    ) -> VehicleView:
        now_s = self.time_s
        (
            north, east, down, v_north, v_east, v_down, _, heading_rad, roll_rad, pitch_rad,
            _, _, effort, effort_s, _, _, _, _, received_s, _,
            power_w, received_reported_s, given_reported_s, _, _, _, _, _, message_s, unhealthy,
            *_,
        ) = readings  # fmt: skip
        age_s, _, remaining_j, drawn_j, initial_j, capacity_j, way_m = figures
        p_local: Vec3 | None = (north, east, down) if north == north else None  # noqa: PLR0124 - NaN is not
        v_ned: Vec3 = (v_north, v_east, v_down)
        offset, turn_rad, member = status.origin_offset_ned, status.turn_rad, status.member
        doubt = status.doubt if now_s - doubted_s < plausibility.DOUBTED_S else ""
        # By place: by name it takes three times as long.
        return VehicleView(
            member.sysid, member.role, member.label, status.alive, status.profile, status.mode, status.armed,
            landed,
            received_s,
            p_ned if p_local is not None and offset is not None else None,
            turned(v_ned, turn_rad) if turn_rad else v_ned,
            age_s,
            heading_rad + turn_rad if heading_rad == heading_rad else None,  # noqa: PLR0124 - NaN is not
            offset,
            status.ground_amsl_m,
            capacity_j, initial_j, status.battery_reported,
            drawn_j, status.received_j, status.given_j, given_reported_s,
            power_w, status.energy_source,
            effort,
            status.ground_down_m,
            status.custom_mode,
            turn_rad,
            status.failsafe,
            p_local,
            doubt or plausibility.charge(remaining_j, capacity_j),
            roll_rad if roll_rad == roll_rad else None,  # noqa: PLR0124 - NaN is not
            pitch_rad if pitch_rad == pitch_rad else None,  # noqa: PLR0124 - NaN is not
            received_reported_s,
            max(now_s - effort_s, 0.0) if effort_s == effort_s else 0.0,  # noqa: PLR0124 - NaN is not
            member.battery_apart,
            message_s, status.uncertain,
            not now_s - received_s > MODE_STALE_S or received_s < 0.0,
            status.listed_modes,
            status.fix_lost_s, status.worse_m, empty, way_m, status.has_climbed, int(unhealthy),
        )  # fmt: skip
