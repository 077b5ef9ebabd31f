"""Health issues of a vehicle, and its part in the refuelling: a few words each, from its messages alone.

Pure functions of a `VehicleView`, and of what a session or its recording knows beside it (`Known`): a session, a
passive monitor and a replay all say the same.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping
from enum import StrEnum
from typing import NamedTuple

from gcs.mavlink.autopilots import End, FlightMode
from gcs.telemetry.state import STALE_S, VehicleView
from skytender import mavlink as mav

WELL, LOOK, ACT = range(3)
"""Severities: nothing is wrong; look at it; do something."""

SILENT_S = 3.0
"""Of a vehicle that sends little else three HEARTBEATs in a row are missing."""
BATTERY_LOOK, BATTERY_ACT = 0.2, 0.1
HELD_LOOK = 0.5
"""[choice] Charge below which it matters that a vehicle held by an operator is not refuelled."""
EMPTIES_LOOK_S, EMPTIES_ACT_S = 60.0, 30.0
LOSS_LOOK, LOSS_ACT = 0.2, 0.6
LONG_S = 1e6
"""A time left that is longer than any that is known."""
CHECKED: Mapping[int, str] = {
    mav.MAV_SYS_STATUS_SENSOR_3D_GYRO: "gyroscope",
    mav.MAV_SYS_STATUS_SENSOR_3D_ACCEL: "accelerometer",
    mav.MAV_SYS_STATUS_SENSOR_3D_MAG: "compass",
    mav.MAV_SYS_STATUS_SENSOR_ABSOLUTE_PRESSURE: "barometer",
    mav.MAV_SYS_STATUS_SENSOR_GPS: "GPS",
    mav.MAV_SYS_STATUS_SENSOR_RC_RECEIVER: "remote control",
    mav.MAV_SYS_STATUS_SENSOR_MOTOR_OUTPUTS: "motors",
    mav.MAV_SYS_STATUS_SENSOR_BATTERY: "battery",
    mav.MAV_SYS_STATUS_GEOFENCE: "geofence",
    mav.MAV_SYS_STATUS_AHRS: "estimator",
}
"""Parts whose failure may keep a vehicle from being armed, by their bits in SYS_STATUS."""


class Condition(StrEnum):
    """Kind of trouble that a vehicle is in, the worst first."""

    DEAD = "dead"
    SILENT = "silent"
    FAILING = "failing"
    LOW = "low"
    WARNED = "warned"
    WELL = ""


class HealthIssue(NamedTuple):
    """One thing that is wrong, in a few words."""

    text: str
    severity: int
    kind: Condition = Condition.WELL
    """`WELL`: by its severity, failing or warned"""
    figure: str = ""
    """how badly, beside the condition's name; empty: the text says it"""
    urgency: float = 0.0
    """among issues of one condition the greatest is the worst"""

    @property
    def condition(self) -> Condition:
        """The condition that this issue alone puts a vehicle in."""
        return self.kind or (Condition.FAILING if self.severity == ACT else Condition.WARNED)


CONDITIONS = tuple(condition for condition in Condition if condition)
"""Those in which a vehicle needs an operator, the worst first."""


class Worst(NamedTuple):
    """Condition of a vehicle by its worst issue, the figure of that, and how urgent it is among vehicles alike."""

    condition: Condition = Condition.WELL
    figure: str = ""
    urgency: float = 0.0


class Health(NamedTuple):
    """Everything that is wrong with a vehicle, as it is shown."""

    texts: tuple[str, ...] = ()
    """the worst first"""
    severity: int = WELL
    condition: Condition = Condition.WELL
    figure: str = ""
    urgency: float = 0.0
    """these three as of `Worst`"""


NO_ISSUES = Health()


class Known(NamedTuple):
    """A session's wishes for a vehicle, and its knowledge of it beside its messages; a recording holds them too."""

    ours: bool = True
    """whether it is to follow our set points; not what another station flies, and nothing that is only watched"""
    ordered: End | None = None
    """what an operator or the schedule wants it to fly, which is no surprise"""
    on_mission: bool = False
    """whether it is to fly a mission of its own, and may hold on it"""
    down: bool = False
    """whether it was lost and does not fly, or flies no more without an order for it"""
    out_of_order: bool = False
    """whether it is a tanker that can give no energy"""
    too_near: str = ""
    """how near it is to what it must not be so near to, in words"""


AS_PLANNED = Known()
WATCHED = Known(ours=False)
"""Of a vehicle of which no session is known: what flies it may be wanted."""


class State(StrEnum):
    """A vehicle's part in the refuelling."""

    IDLE = "idle"
    COMPETING = "competing"
    LEADS = "leads"
    WAITS = "waits"
    """its turn has been decided, its tanker is on the way"""
    SERVED = "served"
    SERVES = "serves"
    LOST = "lost"


def health_issues(
    view: VehicleView,
    now_s: float,
    known: Known = AS_PLANNED,
    *,
    lost_share: float | None = None,
    unanswered_s: float = 0.0,
) -> list[HealthIssue]:
    """Everything that is wrong with a vehicle, worst first; [] when it is well.

    `unanswered_s`: wall time for which the session has stood still for its answer.
    """
    silent_s = view.silent_s(now_s)
    if not view.alive:
        return [_dead(silent_s)]
    if silent_s == math.inf or (view.last_received_s < 0.0 and now_s < SILENT_S):
        kind = Condition.WELL if now_s < SILENT_S else Condition.SILENT
        return [HealthIssue("no telemetry yet", LOOK, kind, "none yet", round(now_s))]
    found = []
    if view.doubt:
        found.append(HealthIssue("not believed", ACT))
    if unanswered_s >= SILENT_S:
        found.append(_silent("no answer for", unanswered_s, f"no answer {unanswered_s:.0f} s"))
    beatless_s = min(now_s - view.last_received_s, now_s)
    if silent_s >= SILENT_S:
        found.append(_silent("no telemetry for", silent_s, f"{silent_s:.0f} s"))
    elif beatless_s >= SILENT_S:
        found.append(_silent("no HEARTBEAT for", beatless_s, f"HEARTBEAT {beatless_s:.0f} s"))
    if view.p_ned is None:
        found.append(HealthIssue("no position", LOOK))
    elif view.age_s > STALE_S:
        found.append(HealthIssue("position out of date", LOOK))
    if view.p_ned is not None and view.uncertain:
        found.append(HealthIssue("position uncertain", LOOK))
    if view.armed and view.fix_lost_s < math.inf:
        found.append(HealthIssue("no GPS fix", ACT))
    elif view.worse_m:
        found.append(HealthIssue(f"place known to {view.worse_m:.1f} m less", LOOK))
    found += _energy(view)
    if (flown := _flown(view, known)) is not None:
        found.append(flown)
    if view.armed and view.unhealthy & mav.MAV_SYS_STATUS_GEOFENCE:
        found.append(HealthIssue("outside its geofence", ACT))
    if not view.armed and view.unhealthy & mav.MAV_SYS_STATUS_PREARM_CHECK:
        why = ", ".join(name for bit, name in CHECKED.items() if view.unhealthy & bit)
        found.append(HealthIssue(f"not ready: {why or 'its own checks fail'}", LOOK))
    if known.too_near:
        found.append(HealthIssue(known.too_near, ACT))
    if known.out_of_order:
        found.append(HealthIssue("out of order", LOOK))
    if lost_share is not None and lost_share >= LOSS_LOOK:
        found.append(HealthIssue(f"{100.0 * lost_share:.0f} % packet loss", ACT if lost_share >= LOSS_ACT else LOOK))
    return sorted(found, key=lambda issue: -issue.severity)


def _flown(view: VehicleView, known: Known) -> HealthIssue | None:
    """The mode that it flies, where that is not the plan's; or that it does not fly any more."""
    mode, name = view.mode, view.mode_name
    as_ordered = flies_as_ordered(mode, known.ordered)
    if view.armed and view.failsafe:
        return HealthIssue(f"failsafe: {name}", LOOK if as_ordered else ACT)
    if view.armed and mode in (FlightMode.RETURN, FlightMode.LAND):
        return HealthIssue(name, ACT if known.ours and not as_ordered else LOOK)
    if known.down:
        return HealthIssue("not flying", ACT)
    if view.flying and known.ours and not as_ordered:
        waits = known.ordered is not None or known.on_mission or view.has_climbed
        if mode is FlightMode.MANUAL or (mode is FlightMode.HOLD and not waits):
            return HealthIssue(f"{name} without an order", LOOK)
    if known.ordered is not None and mode is FlightMode.HOLD and view.remaining_j < HELD_LOOK * view.capacity_j:
        return HealthIssue("held, not refuelled", LOOK)
    return None


def flies_as_ordered(mode: FlightMode, ordered: str | None) -> bool:
    """Whether this mode is what was ordered; a return ends in a landing."""
    return mode == ordered or (ordered == "return" and mode is FlightMode.LAND)


def _dead(silent_s: float) -> HealthIssue:
    if silent_s == math.inf:
        return HealthIssue("dead", ACT, Condition.DEAD, "never heard")
    return HealthIssue("dead", ACT, Condition.DEAD, f"{silent_s:.0f} s", round(silent_s))


def _silent(what: str, for_s: float, figure: str) -> HealthIssue:
    return HealthIssue(f"{what} {for_s:.0f} s", ACT, Condition.SILENT, figure, round(for_s))


def _energy(view: VehicleView) -> list[HealthIssue]:
    if view.energy_source == "none":
        return []
    found = []
    left_j = max(view.remaining_j, 0.0)
    lasts_s = left_j / view.power_w if view.flying and view.power_w > 0.0 else math.inf
    percent = 100.0 * left_j / view.capacity_j
    if percent < 100.0 * BATTERY_LOOK:
        how = ACT if percent < 100.0 * BATTERY_ACT else LOOK
        # After those whose time left is known to be short; on the ground, or drawing nothing, by their charge.
        urgency = -round(lasts_s) - 0.5 if lasts_s < math.inf else -LONG_S - percent // 1
        found.append(HealthIssue(f"battery {percent:.0f} %", how, Condition.LOW, f"{percent:.0f} %", urgency))
    if lasts_s < EMPTIES_LOOK_S:
        how = ACT if lasts_s < EMPTIES_ACT_S else LOOK
        text = f"{lasts_s:.0f} s of flight left"
        found.append(HealthIssue(text, how, Condition.LOW, f"{lasts_s:.0f} s", -round(lasts_s)))
    return found


def severity(found: Iterable[HealthIssue]) -> int:
    """The worst of them."""
    return max((issue.severity for issue in found), default=WELL)


def worst(found: Iterable[HealthIssue]) -> Worst:
    """The condition that all issues of a vehicle together put it in."""
    first = min(found, key=lambda one: (CONDITIONS.index(one.condition), -one.severity, -one.urgency), default=None)
    if first is None:
        return Worst()
    return Worst(first.condition, first.figure or first.text, first.urgency)


def health(found: Collection[HealthIssue]) -> Health:
    """All issues of a vehicle together."""
    if not found:
        return NO_ISSUES
    return Health(tuple(issue.text for issue in found), severity(found), *worst(found))


def state(
    view: VehicleView,
    *,
    competing: Collection[int] = (),
    leader: int | None = None,
    waiting: Collection[int] = (),
    served: Collection[int] = (),
    serving: Collection[int] = (),
) -> State:
    """Its part in the refuelling, by the system ids of those that have one."""
    if not view.alive:
        return State.LOST
    for part, ids in ((State.SERVES, serving), (State.SERVED, served), (State.WAITS, waiting)):
        if view.sysid in ids:
            return part
    if view.sysid == leader:
        return State.LEADS
    return State.COMPETING if view.sysid in competing else State.IDLE
