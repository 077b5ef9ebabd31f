"""Modes as a vehicle itself lists them (AVAILABLE_MODES): names and standard modes of modes that no table of
autopilots has (https://mavlink.io/en/services/standard_modes.html)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from gcs.mavlink.autopilots import End, FlightMode, Params, Profile
from skytender import mavlink as mav


class ListedMode(NamedTuple):
    """One of a vehicle's modes as it says: MAV_STANDARD_MODE, the name of one that is none, mode_index and
    number_modes."""

    standard: int
    name: str
    place: int
    of: int


Listed = Mapping[int, ListedMode]
"""A vehicle's modes by HEARTBEAT's custom_mode; empty where it has listed none."""
ENDS: Mapping[End, int] = {"return": mav.MAV_STANDARD_MODE_SAFE_RECOVERY, "land": mav.MAV_STANDARD_MODE_LAND}
_FLOWN = {
    mav.MAV_STANDARD_MODE_SAFE_RECOVERY: FlightMode.RETURN,
    mav.MAV_STANDARD_MODE_LAND: FlightMode.LAND,
    mav.MAV_STANDARD_MODE_TAKEOFF: FlightMode.TAKEOFF,
}
_NAMES = {
    value: name.removeprefix("MAV_STANDARD_MODE_").replace("_", " ").capitalize()
    for value, name in mav.ENUMS["MAV_STANDARD_MODE"].items()
}
ASK_EVERY_S, ASK_TIMES = 2.0, 3
EACH_WITHIN_S = 0.25
"""So long after one question about modes the next missing one is asked for."""


def named(profile: Profile, custom_mode: int) -> bool:
    """Whether the table of autopilots knows a mode."""
    return custom_mode in profile.modes or custom_mode in profile.names


def mode(profile: Profile, custom_mode: int, listed: Listed) -> FlightMode:
    """The mode in a HEARTBEAT: by the table, else by the standard mode that the vehicle says it is."""
    if named(profile, custom_mode) or custom_mode not in listed:
        return profile.mode(custom_mode)
    return _FLOWN.get(listed[custom_mode].standard, FlightMode.OTHER)


def mode_name(profile: Profile, custom_mode: int, listed: Listed) -> str:
    """The same for a person: as the table names it, else as the vehicle does, else as its standard mode is called."""
    said = listed.get(custom_mode)
    if named(profile, custom_mode) or said is None:
        return profile.mode_name(custom_mode)
    flown = _FLOWN.get(said.standard)
    standard = str(flown).capitalize() if flown else _NAMES.get(said.standard, "") if said.standard else ""
    return said.name or standard or profile.mode_name(custom_mode)


def ending(profile: Profile, end: End, listed: Listed) -> tuple[int, Params]:
    """As `Profile.ending`; by the standard mode where the vehicle has that under a number that the table lacks."""
    standard = ENDS.get(end)
    if any(one.standard == standard and not named(profile, number) for number, one in listed.items()):
        assert standard is not None
        return int(mav.MAV_CMD_DO_SET_STANDARD_MODE), (float(standard),)
    return profile.ending(end)


def missing(listed: Iterable[tuple[int, int]]) -> list[int]:
    """Indices of the modes that a vehicle has not listed yet.

    listed: (index, number of modes) of each AVAILABLE_MODES that was received; indices begin at 1. ArduPilot answers a
    request for all modes with the first one only; the others are requested one by one, as QGroundControl does.
    """
    came = dict(listed)
    return [place for place in range(1, max(came.values(), default=0) + 1) if place not in came]


def asked(place: int) -> tuple[int, Params]:
    """The command that asks a vehicle for the mode at that place, or with 0 for all."""
    return int(mav.MAV_CMD_REQUEST_MESSAGE), (float(mav.MAVLINK_MSG_ID_AVAILABLE_MODES), float(place))


class _ModeQuestion(NamedTuple):
    """The last one to a vehicle: the mode that nothing named, the furthest place, how often that, and when."""

    nameless: int
    place: int
    times: int
    at_s: float


class ModeRequests:
    """When vehicles are asked for their modes: while one flies a mode that nothing names, a few times, and then for
    each that has not come, as often."""

    def __init__(self) -> None:
        self._asked: dict[int, _ModeQuestion] = {}

    def due(self, sysid: int, profile: Profile, custom_mode: int, listed: Listed, now_s: float) -> int | None:
        """The place to ask for now, 0 for all; it counts as asked then. None: nothing is to be asked."""
        last = self._asked.get(sysid)
        nameless = not named(profile, custom_mode) and custom_mode not in listed
        if not nameless and last is None:
            return None
        place = next(iter(missing((one.place, one.of) for one in listed.values())), 0)
        if not nameless and place == 0:
            return None
        if last is None or (nameless and last.nameless != custom_mode):
            last = _ModeQuestion(custom_mode, place, 0, -math.inf)
        further = place > last.place
        times = 0 if further else last.times
        if times >= ASK_TIMES or now_s < last.at_s + (EACH_WITHIN_S if further else ASK_EVERY_S):
            return None
        self._asked[sysid] = _ModeQuestion(last.nameless, max(place, last.place), times + 1, now_s)
        return place
