"""Flight modes and failsafes as one table.

The rules of the table:
1. A rule applies when its event happens, the vehicle's mode is among `when` and its arming matches `armed` (None:
   both).
2. The first rule that applies decides; an event without one is refused and changes nothing.
3. Failsafes are events too. They are listed in FAILSAFES in the order in which they are looked at, worst first.
4. Every change is announced, with the rule's words.
"""

from __future__ import annotations

from enum import StrEnum
from typing import NamedTuple


class Mode(StrEnum):
    """Flight mode."""

    TAKEOFF = "takeoff"
    OFFBOARD = "offboard"
    HOLD = "hold"
    LAND = "land"
    RETURN = "return"
    REFUEL = "refuel"
    MISSION = "mission"
    FOLLOW = "follow"
    GUIDED = "guided"


class Trigger(StrEnum):
    """Triggers that can change the mode or the arming."""

    ARM = "arm"
    DISARM = "disarm"
    TAKEOFF = "takeoff"
    TAKEOFF_DONE = "takeoff done"
    OFFBOARD = "offboard"
    HOLD = "hold"
    LAND = "land"
    RETURN = "return"
    HOME_REACHED = "home reached"
    TOUCHDOWN = "touchdown"
    REFUEL = "refuel"
    REFUEL_END = "refuel end"
    MISSION = "mission"
    MISSION_DONE = "mission done"
    FOLLOW = "follow"
    GUIDED = "guided"
    GUIDED_HOLD = "guided hold"
    CRASHED = "crashed"
    BATTERY_EMPTY = "battery empty"
    GCS_LOST = "ground station lost"
    SETPOINTS_LOST = "set points lost"
    GPS_LOST = "GPS lost"
    FENCE_HOLD = "fence breached, hold"
    FENCE_RETURN = "fence breached, return"


class Severity(StrEnum):
    """Severity with which a change is announced."""

    INFO = "info"
    WARNING = "warning"
    CRITICAL = "critical"


class Rule(NamedTuple):
    """One row: on `event` in one of `when`, go to `mode` (None: stay) and set `arming` (None: leave it)."""

    event: Trigger
    when: frozenset[Mode]
    armed: bool | None
    mode: Mode | None
    arming: bool | None
    severity: Severity
    text: str


ANY = frozenset(Mode)
STEERED = frozenset({Mode.OFFBOARD, Mode.REFUEL})
"""Modes that fly set points."""
RESTING = frozenset({Mode.HOLD, Mode.LAND, Mode.GUIDED})
"""Modes in which a vehicle on the ground stays there, motors off."""
_NOT_LANDING = ANY - {Mode.LAND}
_NOT_GOING_HOME = ANY - {Mode.LAND, Mode.RETURN}
_NOT_TO_ARM_IN = frozenset({Mode.LAND, Mode.RETURN, Mode.FOLLOW})
_STEERABLE = STEERED | {Mode.TAKEOFF, Mode.GUIDED}
_I, _W, _C = Severity.INFO, Severity.WARNING, Severity.CRITICAL

RULES: tuple[Rule, ...] = (
    Rule(Trigger.ARM, ANY - _NOT_TO_ARM_IN, False, None, True, _I, "Armed"),
    Rule(Trigger.ARM, _NOT_TO_ARM_IN, False, Mode.HOLD, True, _I, "Armed, hold"),
    Rule(Trigger.ARM, ANY, True, None, None, _I, ""),
    Rule(Trigger.DISARM, ANY, None, Mode.HOLD, False, _I, "Disarmed"),
    Rule(Trigger.TAKEOFF, ANY, True, Mode.TAKEOFF, None, _I, "Take-off"),
    Rule(Trigger.TAKEOFF_DONE, frozenset({Mode.TAKEOFF}), True, Mode.HOLD, None, _I, "Take-off done, hold"),
    Rule(Trigger.OFFBOARD, frozenset({Mode.REFUEL}), None, None, None, _I, ""),
    Rule(Trigger.OFFBOARD, ANY, None, Mode.OFFBOARD, None, _I, "Offboard"),
    Rule(Trigger.HOLD, ANY, None, Mode.HOLD, None, _I, "Hold"),
    Rule(Trigger.LAND, ANY, None, Mode.LAND, None, _I, "Land"),
    Rule(Trigger.RETURN, ANY, None, Mode.RETURN, None, _I, "Return to home"),
    Rule(Trigger.HOME_REACHED, frozenset({Mode.RETURN}), True, Mode.LAND, None, _I, "Home reached, land"),
    Rule(Trigger.TOUCHDOWN, frozenset({Mode.LAND}), True, None, False, _I, "Landed, disarmed"),
    Rule(Trigger.REFUEL, STEERED, True, Mode.REFUEL, None, _I, "Refuel"),
    Rule(Trigger.REFUEL_END, frozenset({Mode.REFUEL}), None, Mode.OFFBOARD, None, _I, "Refuel ended, offboard"),
    Rule(Trigger.TOUCHDOWN, frozenset({Mode.MISSION}), True, Mode.HOLD, False, _I, "Landed, disarmed"),
    Rule(Trigger.MISSION, ANY, None, Mode.MISSION, None, _I, "Mission"),
    Rule(Trigger.MISSION_DONE, frozenset({Mode.MISSION}), None, Mode.HOLD, None, _I, "Mission done, hold"),
    Rule(Trigger.FOLLOW, ANY, True, Mode.FOLLOW, None, _I, "Follow"),
    Rule(Trigger.GUIDED, _STEERABLE, None, None, None, _I, ""),
    Rule(Trigger.GUIDED, ANY, None, Mode.GUIDED, None, _I, "Guided"),
    Rule(Trigger.GUIDED_HOLD, ANY, None, Mode.GUIDED, None, _I, "Guided, hold"),
    Rule(Trigger.CRASHED, ANY, True, Mode.HOLD, False, _C, "Crashed, disarmed"),
    Rule(Trigger.BATTERY_EMPTY, _NOT_LANDING, True, Mode.LAND, None, _C, "Failsafe: battery empty, land"),
    Rule(Trigger.GCS_LOST, _NOT_GOING_HOME, True, Mode.RETURN, None, _W, "Failsafe: ground station lost, return"),
    Rule(Trigger.SETPOINTS_LOST, STEERED, True, Mode.HOLD, None, _W, "Failsafe: set points lost, hold"),
    Rule(Trigger.GPS_LOST, _NOT_LANDING, True, Mode.LAND, None, _C, "Failsafe: GPS lost, land"),
    Rule(Trigger.FENCE_RETURN, _NOT_GOING_HOME, True, Mode.RETURN, None, _W, "Failsafe: geofence breached, return"),
    Rule(Trigger.FENCE_HOLD, _NOT_GOING_HOME, True, Mode.HOLD, None, _W, "Failsafe: geofence breached, hold"),
)

STAND_DOWN = Rule(Trigger.DISARM, ANY, True, Mode.HOLD, False, _W, "Failsafe on the ground, disarmed")
"""Mode to which every failsafe puts a vehicle that stands on the ground."""

PROGRESS = frozenset(
    {
        Trigger.TAKEOFF_DONE,
        Trigger.HOME_REACHED,
        Trigger.TOUCHDOWN,
        Trigger.MISSION_DONE,
        Trigger.REFUEL_END,
        Trigger.CRASHED,
    }
)
"""Events that the vehicle finds out by itself, without a failsafe."""

FAILSAFES: tuple[Trigger, ...] = (
    Trigger.BATTERY_EMPTY,
    Trigger.GPS_LOST,
    Trigger.GCS_LOST,
    Trigger.FENCE_RETURN,
    Trigger.FENCE_HOLD,
    Trigger.SETPOINTS_LOST,
)

COPTER_FAILSAFES = frozenset({Trigger.BATTERY_EMPTY, Trigger.GPS_LOST, Trigger.GCS_LOST})
"""Failsafes that ArduCopter counts as such (any_failsafe_triggered); PX4 counts all."""


def rule_for(event: Trigger, mode: Mode, armed: bool) -> Rule | None:
    """The first rule of the table that applies; None where the event is refused."""
    for rule in RULES:
        if rule.event is event and mode in rule.when and rule.armed in (None, armed):
            return rule
    return None
