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


def _one(name: str, number: Callable[[Homecoming], int | float]) -> ReturnParameter:
    return ReturnParameter((name,), (number,))


def _always(number: int) -> Callable[[Homecoming], int]:
    return lambda _: number


def _metres(home: Homecoming) -> float:
    """Height to the next centimetre above, as all keep it."""
    return math.ceil(round(100.0 * home.height_m, 6)) / 100.0


_COPTER = (
    ReturnParameter(("RTL_ALT_M", "RTL_ALT"), (_metres, lambda home: round(100.0 * _metres(home))), is_height=True),
    _one("RTL_CONE_SLOPE", _always(0)),
    ReturnParameter(("RTL_CLIMB_MIN_M", "RTL_CLIMB_MIN"), (_always(0), _always(0))),
    _one("RTL_LOIT_TIME", lambda home: 1000 * math.ceil(home.waits_s)),
    _one("FS_GCS_ENABLE", _always(1)),
    _one("FS_GCS_TIMEOUT", lambda home: math.ceil(home.begins_after_s)),
    _one("GUID_TIMEOUT", lambda home: home.holds_after_s),
)
_PX4 = (
    ReturnParameter(("RTL_RETURN_ALT",), (_metres,), is_height=True),
    _one("RTL_CONE_ANG", _always(0)),
    _one("RTL_DESCEND_ALT", _metres),
    _one("RTL_LAND_DELAY", lambda home: math.ceil(home.waits_s)),
    _one("NAV_DLL_ACT", _always(2)),
    _one("COM_DL_LOSS_T", lambda home: math.ceil(home.begins_after_s)),
    _one("COM_OF_LOSS_T", lambda home: home.holds_after_s),
    _one("COM_OBL_RC_ACT", _always(5)),
)
TABLES: Mapping[str, tuple[ReturnParameter, ...]] = {"copter": _COPTER, "main and sub": _PX4}
"""By whose modes an autopilot numbers (Profile.mode_table); others have none."""
