"""Modes as a vehicle itself lists them (AVAILABLE_MODES): names and standard modes of modes that no table of
autopilots has (https://mavlink.io/en/services/standard_modes.html)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from gcs.mavlink.autopilots import End, FlightMode, Params, Profile
from skytender import mavlink as mav


class ListedMode(NamedTuple):
    """One of a vehicle's modes as it says: MAV_STANDARD_MODE, and the name of one that is none."""

    standard: int
    name: str


Listed = Mapping[int, ListedMode]
"""A vehicle's modes by HEARTBEAT's custom_mode; empty where it has listed none."""
ENDS: Mapping[End, int] = {"return": mav.MAV_STANDARD_MODE_SAFE_RECOVERY, "land": mav.MAV_STANDARD_MODE_LAND}
_FLOWN = {
    mav.MAV_STANDARD_MODE_SAFE_RECOVERY: FlightMode.RETURN,
    mav.MAV_STANDARD_MODE_LAND: FlightMode.LAND,
    mav.MAV_STANDARD_MODE_TAKEOFF: FlightMode.TAKEOFF,
}
_NAMES = {
    value: name.removeprefix("MAV_STANDARD_MODE_").lower().replace("_", " ")
    for value, name in mav.ENUMS["MAV_STANDARD_MODE"].items()
}
ASK_EVERY_S, ASK_TIMES = 2.0, 3


def named(profile: Profile, custom_mode: int) -> bool:
    """Whether the table of autopilots knows a mode."""
    return custom_mode in profile.modes or custom_mode in profile.names


def mode(profile: Profile, custom_mode: int, listed: Listed) -> FlightMode:
    """The mode in a HEARTBEAT: by the table, else by the standard mode that the vehicle says it is."""
    if named(profile, custom_mode) or custom_mode not in listed:
        return profile.mode(custom_mode)
    return _FLOWN.get(listed[custom_mode].standard, FlightMode.OTHER)


def mode_name(profile: Profile, custom_mode: int, listed: Listed) -> str:
    """The same for a person: as the table names it, else as the vehicle does."""
    said = listed.get(custom_mode)
    if named(profile, custom_mode) or said is None:
        return profile.mode_name(custom_mode)
    flown = _FLOWN.get(said.standard)
    standard = _NAMES.get(said.standard, "") if said.standard else ""
    return (str(flown) if flown else standard or said.name.lower()) or profile.mode_name(custom_mode)


def ending(profile: Profile, end: End, listed: Listed) -> tuple[int, Params]:
    """As `Profile.ending`; by the standard mode where the vehicle has that under a number that the table lacks."""
    standard = ENDS.get(end)
    if any(one.standard == standard and not named(profile, number) for number, one in listed.items()):
        assert standard is not None
        return int(mav.MAV_CMD_DO_SET_STANDARD_MODE), (float(standard),)
    return profile.ending(end)


class ModeRequests:
    """When vehicles are asked for their modes: while one flies a mode that nothing names, a few times."""

    def __init__(self) -> None:
        self._asked: dict[int, tuple[int, int, float]] = {}
        """by system id the nameless mode, how often it was asked for, and when again"""

    def due(self, sysid: int, profile: Profile, custom_mode: int, listed: Listed, now_s: float) -> bool:
        """Whether to ask now; it counts as asked then."""
        if named(profile, custom_mode) or custom_mode in listed:
            return False
        nameless, times, due_s = self._asked.get(sysid, (custom_mode, 0, now_s))
        if nameless != custom_mode:
            times, due_s = 0, now_s
        if times >= ASK_TIMES or now_s < due_s:
            return False
        self._asked[sysid] = custom_mode, times + 1, now_s + ASK_EVERY_S
        return True


ASKED: tuple[int, Params] = int(mav.MAV_CMD_REQUEST_MESSAGE), (float(mav.MAVLINK_MSG_ID_AVAILABLE_MODES), 0.0)
"""The command that asks for all modes of a vehicle."""
