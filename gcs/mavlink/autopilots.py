"""Every difference between autopilots, in one table: nowhere else does the ground station ask which one it is, or has a
mode a number (tests/gcs/mavlink/test_one_table.py)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Literal

from gcs.mavlink.parameters import renames
from gcs.mavlink.parameters.value import ParameterValue, from_wire
from gcs.mavlink.plans import habits
from skytender import mavlink as mav


class FlightMode(StrEnum):
    """Flight mode of a vehicle, whatever its autopilot calls it."""

    TAKEOFF = "takeoff"
    OFFBOARD = "offboard"
    HOLD = "hold"
    LAND = "land"
    RETURN = "return"
    REFUEL = "refuel"
    MISSION = "mission"
    MANUAL = "manual"
    OTHER = "other"


STEERABLE = frozenset({FlightMode.OFFBOARD, FlightMode.REFUEL})
"""Modes in which a vehicle follows set points."""
End = Literal["hold", "return", "land"]
Params = tuple[float, ...]


@dataclass(frozen=True)
class Profile:
    """One autopilot's habits.

    `modes` reads HEARTBEAT.custom_mode; `offboard`, `hold` and `arming` hold params 1..3 of the MAV_CMD_DO_SET_MODE
    that starts offboard, that lets it stand where it is, and that it wants before it is armed unless its mode is among
    `arms_in`. `not_given` is what an unset command parameter is. `integers_bytewise`: an integer parameter's bytes
    stand in PARAM_VALUE's float, else its value does. `home_is_local`: HOME_POSITION's x, y, z are home's place in the
    local frame, else they say nothing.
    """

    name: str
    offboard_name: str
    """of the mode in which it follows set points"""
    modes: Mapping[int, FlightMode]
    offboard: Params
    hold: Params
    arming: Params
    arms_in: frozenset[FlightMode]
    mission: tuple[int, Params]
    """command, with its parameters, that lets one in flight begin its mission, or go on with the item it was at"""
    takeoff_is_amsl: bool
    not_given: float
    integers_bytewise: bool
    home_is_local: bool
    streams_on_request: bool
    """it sends little but HEARTBEAT until REQUEST_DATA_STREAM"""
    logs_while_armed: bool
    """whether it answers LOG_REQUEST_LIST while it is armed"""
    pinged: bool
    """whether MAVSDK sends it PING"""
    unknown_parameters_refused: bool
    """whether it answers the request for a parameter that it does not have"""
    renamed_parameters: renames.Table
    """its parameters that have changed their names"""
    parameter_file: str
    """file of all its parameters, packed, that it gives by MAVFTP; empty where it has none"""
    log_folders: tuple[str, ...] | None
    """where it may keep its logs for MAVFTP to read; None where LOG_* brings them faster"""
    plans: habits.PlanHabits
    """what it makes of a mission, a fence and rally points"""
    parameter_encoding_said: bool
    """whether its capabilities say how integers stand in PARAM_VALUE"""
    fence_in_status: bool
    """whether SYS_STATUS has its fence's health"""
    setup_checked: bool
    """whether QGroundControl wants its parameters of setup and calibration"""
    oldest_version: tuple[int, int, int] | None
    """that QGroundControl speaks to; None: any"""
    commanded_by_peers: bool
    """whether QGroundControl knows how to let it take off, land and return"""
    mode_table: Literal["main and sub", "copter", "plane", "rover", "sub", "blimp"]
    """which of pymavlink's tables MAVProxy reads its modes by"""
    speed_setting: str
    """which setting of its simulator says how much faster than real time it runs"""
    estimator_parameter: str
    """parameter that says on what it flies; empty where it flies on its estimate always"""
    estimators: Mapping[int, str]
    """its values, but `estimator_truth`"""
    estimator_truth: int
    """its value for one that flies on what its simulation says"""
    names: Mapping[int, str]
    """what its people call its modes: PX4 by `nav_state_names` of its src/lib/modes/ui.hpp, ArduPilots by MAVProxy"""

    def mode_name(self, custom_mode: int) -> str:
        """The mode in a HEARTBEAT, for a person: as the autopilot's own people name it, else its number."""
        return self.names.get(custom_mode, f"mode {custom_mode}")

    def mode(self, custom_mode: int) -> FlightMode:
        """The mode in a HEARTBEAT."""
        return self.modes.get(custom_mode, FlightMode.OTHER)

    def takeoff_param7(self, height_m: float, ground_amsl_m: float) -> float:
        """MAV_CMD_NAV_TAKEOFF's altitude for a climb to `height_m` above a ground at `ground_amsl_m`."""
        return height_m + ground_amsl_m if self.takeoff_is_amsl else height_m

    def parameter(self, wire: float, param_type: int) -> ParameterValue:
        """PARAM_VALUE's value. Raises ValueError where its encoding cannot carry the type."""
        return from_wire(wire, param_type, bytewise=self.integers_bytewise)

    def parameter_number(self, wire: float, param_type: int) -> float:
        """PARAM_VALUE's number, nan where its encoding cannot carry the type."""
        try:
            return float(self.parameter(wire, param_type).number)
        except ValueError:
            return math.nan

    def ending(self, end: End) -> tuple[int, Params]:
        """The command, with its parameters, that takes a vehicle out of offboard: stand there, go home, or land."""
        if end == "hold":
            return int(mav.MAV_CMD_DO_SET_MODE), self.hold
        if end == "return":
            return int(mav.MAV_CMD_NAV_RETURN_TO_LAUNCH), ()
        return int(mav.MAV_CMD_NAV_LAND), (0.0, 0.0, 0.0, *[self.not_given] * 3, 0.0)


def _px4(main: int, sub: int = 0) -> int:
    return main << 16 | sub << 24


_CUSTOM = float(mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED)
_PX4_MODES = {
    **dict.fromkeys((*map(_px4, (1, 2, 3, 5, 7, 11)), _px4(3, 1), _px4(3, 2)), FlightMode.MANUAL),
    _px4(4, 2): FlightMode.TAKEOFF,
    _px4(4, 3): FlightMode.HOLD,
    _px4(4, 4): FlightMode.MISSION,
    _px4(4, 5): FlightMode.RETURN,
    _px4(4, 6): FlightMode.LAND,
    _px4(6): FlightMode.OFFBOARD,
    _px4(6, 1): FlightMode.REFUEL,
}
PX4 = Profile(
    name="px4",
    offboard_name="Offboard",
    modes=_PX4_MODES,
    offboard=(_CUSTOM, 6.0, 0.0),
    hold=(_CUSTOM, 4.0, 3.0),
    arming=(_CUSTOM, 4.0, 3.0),
    arms_in=frozenset({FlightMode.HOLD, FlightMode.TAKEOFF, FlightMode.OTHER}),
    mission=(int(mav.MAV_CMD_DO_SET_MODE), (_CUSTOM, 4.0, 4.0)),  # MISSION_START would begin it anew
    takeoff_is_amsl=True,
    not_given=math.nan,
    integers_bytewise=True,
    home_is_local=True,
    plans=habits.PX4,
    streams_on_request=False,
    logs_while_armed=True,
    pinged=True,
    unknown_parameters_refused=False,
    renamed_parameters=renames.PX4,
    parameter_file="",
    log_folders=("@MAV_LOG", "/fs/microsd/log", "log"),
    parameter_encoding_said=True,
    fence_in_status=False,
    setup_checked=True,
    oldest_version=(1, 4, 1),
    commanded_by_peers=True,
    mode_table="main and sub",
    speed_setting="PX4_SIM_SPEED_FACTOR",
    estimator_parameter="",
    estimators={},
    estimator_truth=-1,
    names={
        **{number: str(mode).capitalize() for number, mode in _PX4_MODES.items()},  # FlightMode's words are PX4's
        _px4(1): "Manual",
        _px4(2): "Altitude",
        _px4(3): "Position",
        _px4(3, 1): "Orbit",
        _px4(3, 2): "Position Slow",
        _px4(4, 1): "Ready",
        _px4(4, 8): "Follow Target",
        _px4(4, 9): "Precision Landing",
        _px4(4, 10): "VTOL Takeoff",
        _px4(5): "Acro",
        _px4(7): "Stabilized",
        _px4(8): "Rattitude",
        _px4(10): "Termination",
        _px4(11): "Altitude Cruise",
        **{_px4(4, 10 + k): f"External {k}" for k in range(1, 9)},
        _px4(4, 19): "Guided Course",
    },
)


def _ardupilot(kind: str) -> dict[int, str]:
    """Modes' names as in MAVProxy. Modes that MAVProxy lacks are named as in MAVLink's definitions."""
    prefix = f"{kind.upper()}_MODE"
    defined = {number: name.removeprefix(f"{prefix}_") for number, name in mav.ENUMS.get(prefix, {}).items()}
    return defined | {number: name for name, number in mav.MODES[kind].items()}


ARDUCOPTER = Profile(
    name="ardupilot",
    offboard_name="GUIDED",
    modes={
        **dict.fromkeys((0, 1, 2, 13, 16), FlightMode.MANUAL),
        3: FlightMode.MISSION,
        4: FlightMode.OFFBOARD,
        5: FlightMode.HOLD,
        6: FlightMode.RETURN,
        9: FlightMode.LAND,
        17: FlightMode.HOLD,
    },
    offboard=(_CUSTOM, 4.0, 0.0),
    hold=(_CUSTOM, 17.0, 0.0),
    arming=(_CUSTOM, 4.0, 0.0),
    arms_in=frozenset({FlightMode.OFFBOARD}),
    mission=(int(mav.MAV_CMD_MISSION_START), (0.0, 0.0)),
    takeoff_is_amsl=False,
    not_given=0.0,
    integers_bytewise=False,
    home_is_local=False,
    plans=habits.ARDUPILOT,
    streams_on_request=True,
    logs_while_armed=False,
    pinged=False,
    unknown_parameters_refused=False,
    renamed_parameters=renames.ARDUPILOT,
    parameter_file="@PARAM/param.pck",
    log_folders=None,
    parameter_encoding_said=False,
    fence_in_status=True,
    setup_checked=False,
    oldest_version=None,
    commanded_by_peers=True,
    mode_table="copter",
    speed_setting="SIM_SPEEDUP",
    estimator_parameter="AHRS_EKF_TYPE",
    estimators={0: "DCM", 2: "EKF2", 3: "EKF3", 11: "an estimator outside it"},
    estimator_truth=10,
    names=_ardupilot("copter"),
)
ARDUPLANE = replace(
    ARDUCOPTER,
    modes={
        **dict.fromkeys((0, 2, 3, 4, 5, 6, 7, 17, 18, 23), FlightMode.MANUAL),
        10: FlightMode.MISSION,
        **dict.fromkeys((11, 21), FlightMode.RETURN),
        **dict.fromkeys((12, 19), FlightMode.HOLD),
        13: FlightMode.TAKEOFF,
        15: FlightMode.OFFBOARD,
        **dict.fromkeys((20, 26), FlightMode.LAND),
    },
    offboard=(_CUSTOM, 15.0, 0.0),
    hold=(_CUSTOM, 12.0, 0.0),
    arming=(_CUSTOM, 15.0, 0.0),
    plans=habits.ARDUPLANE,
    mode_table="plane",
    names=_ardupilot("plane"),
)
ARDUROVER = replace(
    ARDUCOPTER,
    modes={
        **dict.fromkeys((0, 1, 3, 7), FlightMode.MANUAL),
        4: FlightMode.HOLD,
        5: FlightMode.HOLD,
        10: FlightMode.MISSION,
        11: FlightMode.RETURN,
        15: FlightMode.OFFBOARD,
    },
    offboard=(_CUSTOM, 15.0, 0.0),
    hold=(_CUSTOM, 4.0, 0.0),
    arming=(_CUSTOM, 15.0, 0.0),
    mode_table="rover",
    names=_ardupilot("rover"),
)
ARDUSUB = replace(
    ARDUCOPTER,
    modes={
        **dict.fromkeys((0, 1, 2, 19), FlightMode.MANUAL),
        3: FlightMode.MISSION,
        4: FlightMode.OFFBOARD,
        16: FlightMode.HOLD,
    },
    hold=(_CUSTOM, 16.0, 0.0),
    mode_table="sub",
    names=_ardupilot("sub"),
)
BLIMP = replace(
    ARDUCOPTER,
    modes={
        0: FlightMode.LAND,
        1: FlightMode.MANUAL,
        2: FlightMode.MANUAL,
        3: FlightMode.HOLD,
        4: FlightMode.RETURN,
        5: FlightMode.MISSION,
        6: FlightMode.HOLD,
    },
    offboard=(_CUSTOM, 3.0, 0.0),  # it has no mode in which it is guided
    hold=(_CUSTOM, 3.0, 0.0),
    arming=(_CUSTOM, 3.0, 0.0),
    arms_in=frozenset({FlightMode.HOLD}),
    mode_table="blimp",
    names=_ardupilot("blimp"),
)
GENERIC = replace(
    PX4,
    name="generic",
    takeoff_is_amsl=False,
    renamed_parameters={},
    unknown_parameters_refused=True,
    fence_in_status=True,
    setup_checked=False,
    oldest_version=None,
    commanded_by_peers=False,
)

_BY_AUTOPILOT = {mav.MAV_AUTOPILOT_PX4: PX4, mav.MAV_AUTOPILOT_ARDUPILOTMEGA: ARDUCOPTER}
_ARDUPILOTS = {
    **dict.fromkeys(
        (mav.MAV_TYPE_FIXED_WING, *range(mav.MAV_TYPE_VTOL_DUOROTOR, mav.MAV_TYPE_VTOL_RESERVED5 + 1)), ARDUPLANE
    ),
    **dict.fromkeys((mav.MAV_TYPE_GROUND_ROVER, mav.MAV_TYPE_SURFACE_BOAT), ARDUROVER),
    mav.MAV_TYPE_SUBMARINE: ARDUSUB,
    mav.MAV_TYPE_AIRSHIP: BLIMP,
}
"""ArduPilot's programs by the kind of vehicle that each is for; all others are ArduCopter's."""
PROFILES = {profile.name: profile for profile in (PX4, ARDUCOPTER, GENERIC)}
SPEED_SETTINGS = " or ".join(dict.fromkeys(profile.speed_setting for profile in PROFILES.values()))


def in_table(autopilot: int) -> bool:
    """Whether HEARTBEAT.autopilot has a profile of its own."""
    return autopilot in _BY_AUTOPILOT


def profile_of(autopilot: int, vehicle_type: int = mav.MAV_TYPE_QUADROTOR) -> Profile:
    """The profile for HEARTBEAT.autopilot and type: ArduPilot numbers its modes by the kind of vehicle."""
    profile = _BY_AUTOPILOT.get(autopilot, GENERIC)
    return _ARDUPILOTS.get(vehicle_type, profile) if profile is ARDUCOPTER else profile
