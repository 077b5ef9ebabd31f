"""The fleet at one instant, immutable: what everything that decides, shows or records reads."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from gcs.mavlink.autopilots import STEERABLE, End, FlightMode, Params, Profile
from gcs.mavlink.services import standard_modes
from gcs.telemetry.columns import FIGURES, FLAGS, NO_NUMBER, PLACES, FleetColumns
from skytender.safety.traffic import TrafficView

Vec3 = tuple[float, float, float]
ZERO: Vec3 = (0.0, 0.0, 0.0)
EMPTY: standard_modes.Listed = {}
GRAVITY_M_S2 = 9.8
STALE_S = 1.5
"""A position older than this is not believed any more."""
MODE_STALE_S = 6.0
"""[choice] A mode whose last HEARTBEAT is older than this is not believed any more: after 5 s (COM_DL_LOSS_T) vehicles
take the station for lost and change it by themselves, and they report it once a second."""


class VehicleView(NamedTuple):
    """One vehicle as its messages show it at the snapshot's time. None: not reported yet.

    Positions and velocities are in the common NED frame; `age_s` is how old the position is. Energies are in J.
    """

    sysid: int
    role: str
    label: str
    alive: bool
    profile: Profile
    mode: FlightMode
    armed: bool
    landed: bool
    last_received_s: float
    p_ned: Vec3 | None
    v_ned: Vec3
    age_s: float
    heading_rad: float | None
    origin_offset_ned: Vec3 | None
    ground_amsl_m: float
    capacity_j: float
    initial_j: float
    battery_reported: bool
    drawn_j: float
    received_j: int
    given_j: int
    given_reported_s: float
    power_w: float
    energy_source: str
    control_effort: float
    ground_down_m: float | None = None
    """the ground under its home, or else under its origin, in the common frame; None while that is unknown"""
    custom_mode: int = 0
    """HEARTBEAT's, as shown to people"""
    turn_rad: float = 0.0
    """by how much its own frame is turned about the vertical against the common one"""
    failsafe: bool = False
    """whether its autopilot says that it flies by a failsafe of its own"""
    p_local_ned: Vec3 | None = None
    """in its own frame; where that lies it may not have reported yet"""
    doubt: str = ""
    """why it is not believed; nothing while it is"""
    roll_rad: float | None = None
    pitch_rad: float | None = None
    received_reported_s: float = -math.inf
    """as of when it reported the energy received"""
    effort_age_s: float = 0.0
    """how old `control_effort` is"""
    battery_apart: bool = False
    """whether its battery takes energy whatever its autopilot does, and no mode of its says so"""
    last_message_s: float = -math.inf
    """when anything came from its autopilot; `last_received_s` is of its HEARTBEAT alone"""
    uncertain: str = ""
    """why its place may be wrong, by what it has said so far; nothing where that is certain"""
    mode_known: bool = True
    """whether its mode can be believed, by the age of its HEARTBEAT"""
    listed_modes: standard_modes.Listed = EMPTY
    """its modes as it lists them itself"""
    fix_lost_s: float = math.inf
    """session time at which its GPS lost its fix; infinity while it has one, or never had"""
    worse_m: float = 0.0
    """standard deviation of its place that has come on top of the usual one"""
    battery_empty: bool = False
    """whether nothing is left by its account, or by its last report, which is in whole per cent"""
    way_m: float = 0.0
    """the way from each place that it has reported to the next, on the ground too"""
    has_climbed: bool = False
    """whether it takes off, or holds since it has done so: as a rule on its way to what it is sent to"""
    unhealthy: int = 0
    """MAV_SYS_STATUS_SENSOR of what it has, uses, and says is out of order; 0 before it has said any"""

    @property
    def mode_name(self) -> str:
        """Its mode for a person, as its autopilot's own people call it; before its first HEARTBEAT that is none."""
        if self.last_received_s < 0.0:
            return str(self.mode)
        return standard_modes.mode_name(self.profile, self.custom_mode, self.listed_modes)

    def ending(self, end: End) -> tuple[int, Params]:
        """The command, with its parameters, that takes it out of offboard."""
        return standard_modes.ending(self.profile, end, self.listed_modes)

    @property
    def height_m(self) -> float | None:
        """Height above its ground."""
        if self.p_ned is None or self.ground_down_m is None:
            return None
        return self.ground_down_m - self.p_ned[2]

    @property
    def remaining_j(self) -> float:
        """Energy in the battery, J, by the vehicle's messages alone (docs/protocol/energy.md#energy-accounting)."""
        return self.initial_j + self.received_j - self.drawn_j - self.given_j

    @property
    def need(self) -> float:
        """The share of the battery that is gone."""
        return 1.0 - self.remaining_j / self.capacity_j

    @property
    def endurance_s(self) -> float:
        """Time that the battery lasts at the present draw; infinite without one, as of a dead vehicle."""
        return self.remaining_j / self.power_w if self.alive and self.power_w > 0.0 else math.inf

    @property
    def placed(self) -> bool:
        """Whether it has reported a place, and with it a velocity."""
        return self.age_s < math.inf

    @property
    def metered(self) -> bool:
        """Whether it draws what it has reported: not before its first report, nor once it is dead."""
        return self.alive and self.energy_source != "none"

    @property
    def effort_now(self) -> float:
        """Control effort, m/s, carried forward by its age in flight: the weight alone takes g each second, more than
        vehicles differ by, and reports may be lost."""
        return self.control_effort + (GRAVITY_M_S2 * self.effort_age_s if self.flying else 0.0)

    @property
    def flying(self) -> bool:
        """In the air, armed, and its place known."""
        return self.alive and self.armed and not self.landed and self.p_ned is not None

    @property
    def fresh(self) -> bool:
        """Lives, has reported its place and mode lately, and is believed: only then is it led, followed, refuelled,
        measured."""
        return self.alive and self.age_s <= STALE_S and self.mode_known and not self.doubt

    def silent_s(self, now_s: float) -> float:
        """For how long nothing has come from its autopilot; not how old its position is, which is `age_s`."""
        return max(now_s - max(self.last_message_s, self.last_received_s), 0.0)

    def p_now_ned(self) -> Vec3:
        """Position carried forward by its age while that is fresh; call only where `p_ned` is known."""
        assert self.p_ned is not None
        (n, e, d), (v_n, v_e, v_d), age_s = self.p_ned, self.v_ned, self.age_s
        age_s = STALE_S if age_s > STALE_S else age_s  # half the time of min
        return (n + v_n * age_s, e + v_e * age_s, d + v_d * age_s)


@dataclass(frozen=True)
class FleetSnapshot:
    """The fleet at one instant of the session; vehicles in order of system id.

    Views, and columns, are made on first use.
    """

    time_s: float
    vehicles: tuple[VehicleView, ...]
    traffic: tuple[TrafficView, ...]

    @classmethod
    def of_columns(
        cls,
        time_s: float,
        columns: FleetColumns,
        views: Callable[[int, int], Sequence[VehicleView]],
        traffic: tuple[TrafficView, ...],
    ) -> FleetSnapshot:
        """A snapshot that has its columns; `views` makes the views of rows from one up to another."""
        snapshot = cls.__new__(cls)
        snapshot.__dict__.update(time_s=time_s, columns=columns, traffic=traffic, _made=views, _views={})
        return snapshot

    def __getattr__(self, name: str) -> tuple[VehicleView, ...]:
        """Makes `vehicles` where they are not there yet."""
        if name != "vehicles" or "columns" not in self.__dict__:
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
        views: tuple[VehicleView, ...] = tuple(self.__dict__["_made"](0, len(self.columns.sysids)))
        self.__dict__["vehicles"] = views
        self._views.update(zip(self.columns.sysids, views, strict=True))
        return views

    @cached_property
    def columns(self) -> FleetColumns:
        """The vehicles as arrays, a row for each in the same order."""
        return _columns_of(self.vehicles)

    @cached_property
    def _views(self) -> dict[int, VehicleView]:
        return {view.sysid: view for view in self.vehicles}

    def vehicle(self, sysid: int) -> VehicleView:
        """The vehicle with this id; KeyError where the scenario has none."""
        view = self._views.get(sysid)
        if view is None:
            row = self.columns.row[sysid]
            view = self._views[sysid] = self.__dict__["_made"](row, row + 1)[0]
        return view

    def of_role(self, role: str) -> tuple[VehicleView, ...]:
        """All vehicles of a role."""
        return tuple(view for view in self.vehicles if view.role == role)


_UNKNOWN: Vec3 = (math.nan, math.nan, math.nan)


def _columns_of(views: Sequence[VehicleView]) -> FleetColumns:
    """The same vehicles as columns, whose changes are not known."""
    sysids = [view.sysid for view in views]
    flags = [
        (v.alive, v.mode_known and v.mode in STEERABLE, v.flying, v.fresh, v.landed, v.battery_empty) for v in views
    ]
    places = [
        (_UNKNOWN, v.v_ned, _UNKNOWN) if v.p_ned is None else (v.p_ned, v.v_ned, v.p_now_ned()) for v in views
    ]  # fmt: skip
    figures = [
        (
            v.age_s,
            math.nan if v.ground_down_m is None else v.ground_down_m,
            v.remaining_j,
            v.drawn_j,
            v.initial_j,
            v.capacity_j,
            v.way_m,
        )
        for v in views
    ]
    return FleetColumns(
        sysids,
        {sysid: row for row, sysid in enumerate(sysids)},
        NO_NUMBER,
        np.zeros(len(views), np.int64),
        np.array(flags, np.bool_).reshape(-1, FLAGS).T.copy(),
        np.array(places, np.float64).reshape(-1, PLACES, 3).transpose(1, 0, 2).copy(),
        np.array(figures, np.float64).reshape(-1, FIGURES).T.copy(),
        np.array([(*(v.origin_offset_ned or _UNKNOWN), v.turn_rad) for v in views], np.float64).reshape(-1, 4),
    )
