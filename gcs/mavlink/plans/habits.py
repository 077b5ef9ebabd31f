"""Autopilots' habits with a mission, a fence and rally points that they are given: home before it, roundings, and
parameters that they do not keep. gcs/mavlink/autopilots.py says whose these are.

[lineage] ArduPilot, AP_Mission.cpp (mavlink_int_to_mission_cmd, mission_cmd_to_mavlink_int), MissionItemProtocol_Rally;
PX4, mavlink_mission.cpp (parse_mavlink_mission_item, format_mavlink_mission_item)
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from skytender import mavlink as mav

Lost = Mapping[int, str]
"""By MAV_CMD: the numbers of the parameters, 1 to 7, that read 0, or only their sign, whatever they were."""
_NOTHING: Lost = {}
NO_PLACE = "567"
"""Parameters that are a place, of a command that has none."""


class PlanHabits(NamedTuple):
    """Habits of one autopilot."""

    begin_with_home: bool = False
    """whether item 0 of its mission is home, which it sets itself"""
    whole_rally_m: bool = False
    """whether it cuts a rally point's height down to whole metres"""
    keeps_autocontinue: bool = True
    lost: Lost = _NOTHING
    not_sent: Lost = _NOTHING
    """parameters that it may refuse because it has no use for them, and is not given"""
    keeps_placeless: bool = True
    """whether it keeps parameters 5 to 7 of a command that has no place"""

    def loses(self, command: int, parameter: int) -> bool:
        """Whether it has no use for a parameter of a mission's item, and may not keep it."""
        known = mav.COMMANDS.get(command)
        placeless = "" if self.keeps_placeless or known is None or known.has_place else NO_PLACE
        return str(parameter) in self.lost.get(command, "") + placeless


def _lost(text: str) -> Lost:
    words = text.split()
    return {getattr(mav, f"MAV_CMD_{name}"): numbers for name, numbers in zip(words[::2], words[1::2], strict=True)}


_ARDUPILOT = _lost("""
    NAV_WAYPOINT 234      NAV_LOITER_UNLIM 124  NAV_LOITER_TURNS 2   NAV_LOITER_TIME 23  NAV_RETURN_TO_LAUNCH 1234
    NAV_LAND 234          NAV_TAKEOFF 234       NAV_SPLINE_WAYPOINT 234                  NAV_LOITER_TO_ALT 13
    DO_CHANGE_SPEED 4     DO_SET_ROI 234        DO_SET_ROI_LOCATION 234                  DO_LAND_START 1234
""")
_PX4 = _lost("""
    NAV_WAYPOINT 3        NAV_LOITER_UNLIM 12   NAV_LOITER_TIME 24   NAV_LAND 13         NAV_TAKEOFF 123
    NAV_LOITER_TO_ALT 3   DO_SET_ROI 234        DO_SET_ROI_LOCATION 1234                 DO_GRIPPER 34567
    NAV_VTOL_TAKEOFF 123  NAV_VTOL_LAND 123
""")
ARDUPILOT = PlanHabits(
    begin_with_home=True, whole_rally_m=True, keeps_autocontinue=False, lost=_ARDUPILOT, keeps_placeless=False
)
ARDUPLANE = ARDUPILOT._replace(lost={**_ARDUPILOT, mav.MAV_CMD_NAV_WAYPOINT: "14"})
_PX4_REFUSES = _lost("""
    NAV_WAYPOINT 3        NAV_LOITER_UNLIM 12   NAV_LAND 3           NAV_TAKEOFF 123     NAV_LOITER_TO_ALT 3
""")
"""From 1.18 on (mavlink_command_params.hpp), a take-off's pitch until it knows what kind of vehicle it is."""
PX4 = PlanHabits(lost=_PX4, not_sent=_PX4_REFUSES)
