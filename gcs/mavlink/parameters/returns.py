"""Parameters by which an autopilot comes home when the ground station is lost, by versions [choice].

Each says what it wants of a return's numbers. What an autopilot does by a parameter is its own documentation's:

    RTL_ALT, RTL_ALT_M          ArduCopter, least height of a return above home: cm before 4.7, m since
    RTL_CONE_SLOPE              near home it returns lower than that: 0 ends it; so does RTL_CONE_ANG of PX4
    RTL_CLIMB_MIN               it climbs at least so far, past its height: 0
    RTL_LOIT_TIME               ms over home before it comes down; RTL_LAND_DELAY of PX4, s, in the height
                                RTL_DESCEND_ALT, no lower than the return
    FS_GCS_ENABLE, NAV_DLL_ACT  whether it returns when no HEARTBEAT of the station comes: 1, and 2
    FS_GCS_TIMEOUT, COM_DL_LOSS_T   s after which; before 4.2 ArduCopter has no such parameter
    GUID_TIMEOUT, COM_OF_LOSS_T s for which it flies on by its last set point
    COM_OBL_RC_ACT              then it holds: 5

[lineage] https://ardupilot.org/copter/docs/parameters.html, https://docs.px4.io/main/en/advanced_config/parameter_reference
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import NamedTuple


class Homecoming(NamedTuple):
    """How one vehicle comes home without the station."""

    height_m: float
    """above its home"""
    begins_after_s: float
    """of the station's last HEARTBEAT"""
    waits_s: float
    """over home, as high as it returned"""
    holds_after_s: float
    """of its last set point"""


class ReturnParameter(NamedTuple):
    """One thing that is set; the vehicle has it by one of these names, or not at all."""

    names: tuple[str, ...]
    wanted: tuple[Callable[[Homecoming], int | float], ...]
    """its number by each name"""
    is_height: bool = False
    """whether nothing else keeps ways apart: a vehicle without it fails its check list"""

    def numbers(self, home: Homecoming) -> dict[str, int | float]:
        """Number by each name."""
        return {name: number(home) for name, number in zip(self.names, self.wanted, strict=True)}


def _named(*names: str, wanted: Callable[[Homecoming], int | float]) -> ReturnParameter:
    """One number by whichever name."""
    return ReturnParameter(names, (wanted,) * len(names))


def _metres(home: Homecoming) -> float:
    """Height to the next centimetre above, as all keep it."""
    return math.ceil(round(100.0 * home.height_m, 6)) / 100.0


def _centimetres(home: Homecoming) -> int:
    return round(100.0 * _metres(home))


def _waits_s(home: Homecoming) -> int:
    return math.ceil(home.waits_s)


def _waits_ms(home: Homecoming) -> int:
    return 1000 * _waits_s(home)


def _begins_s(home: Homecoming) -> int:
    return math.ceil(home.begins_after_s)


def _holds_s(home: Homecoming) -> float:
    return home.holds_after_s


_COPTER = (
    ReturnParameter(("RTL_ALT_M", "RTL_ALT", "RTL_RETURN_ALT"), (_metres, _centimetres, _metres), is_height=True),
    _named("RTL_CONE_SLOPE", wanted=lambda _: 0),
    _named("RTL_CLIMB_MIN_M", "RTL_CLIMB_MIN", wanted=lambda _: 0),
    ReturnParameter(("RTL_LOIT_TIME", "RTL_LAND_DELAY"), (_waits_ms, _waits_s)),
    _named("FS_GCS_ENABLE", wanted=lambda _: 1),
    _named("FS_GCS_TIMEOUT", "COM_DL_LOSS_T", wanted=_begins_s),
    _named("GUID_TIMEOUT", "COM_OF_LOSS_T", wanted=_holds_s),
)
"""`simvehicle`, where it says that it is an ArduCopter, still has PX4's names."""
_PX4 = (
    ReturnParameter(("RTL_RETURN_ALT",), (_metres,), is_height=True),
    _named("RTL_CONE_ANG", wanted=lambda _: 0),
    _named("RTL_DESCEND_ALT", wanted=_metres),
    _named("RTL_LAND_DELAY", wanted=_waits_s),
    _named("NAV_DLL_ACT", wanted=lambda _: 2),
    _named("COM_DL_LOSS_T", wanted=_begins_s),
    _named("COM_OF_LOSS_T", wanted=_holds_s),
    _named("COM_OBL_RC_ACT", wanted=lambda _: 5),
)
TABLES: Mapping[str, tuple[ReturnParameter, ...]] = {"copter": _COPTER, "main and sub": _PX4}
"""By whose modes an autopilot numbers (Profile.mode_table); others have none."""
