"""Health issues of a vehicle, and its part in the refuelling: a few words each, from its messages alone.

Pure functions of a `VehicleView`: a session, a passive monitor and a replay all say the same.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable
from enum import StrEnum
from typing import NamedTuple

from gcs.mavlink.autopilots import FlightMode
from gcs.telemetry.state import STALE_S, VehicleView

WELL, LOOK, ACT = range(3)
"""Severities: nothing is wrong; look at it; do something."""

SILENT_S = 3.0
"""Of a vehicle that sends little else three HEARTBEATs in a row are missing."""
BATTERY_LOOK, BATTERY_ACT = 0.2, 0.1
HELD_LOOK = 0.5
"""[choice] Charge below which it matters that who is held by an operator is not refuelled."""
EMPTIES_LOOK_S, EMPTIES_ACT_S = 60.0, 30.0
LOSS_LOOK, LOSS_ACT = 0.2, 0.6


class HealthIssue(NamedTuple):
    """One thing that is wrong, in a word or a few."""

    text: str
    severity: int


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
    *,
    lost_share: float | None = None,
    down: bool = False,
    ordered: bool = False,
) -> list[HealthIssue]:
    """Everything that is wrong with a vehicle, worst first; [] when it is well.

    `down`: it has flown, or was to fly, and does no more. `ordered`: an operator has taken it, so that hold, return and
    land are no surprise.
    """
    if not view.alive:
        return [HealthIssue("dead", ACT)]
    silent_s = view.silent_s(now_s)
    if silent_s == math.inf:
        return [HealthIssue("no word yet", LOOK)] if now_s >= SILENT_S else []
    found = []
    if view.doubt:
        found.append(HealthIssue("not believed", ACT))
    beatless_s = min(now_s - view.last_received_s, now_s)
    if silent_s >= SILENT_S:
        found.append(HealthIssue(f"no word {silent_s:.0f} s", ACT))
    elif beatless_s >= SILENT_S:
        found.append(HealthIssue(f"no HEARTBEAT {beatless_s:.0f} s", ACT))
    if view.p_ned is None:
        found.append(HealthIssue("no position", LOOK))
    elif view.age_s > STALE_S:
        found.append(HealthIssue("position old", LOOK))
    if view.p_ned is not None and view.uncertain:
        found.append(HealthIssue("position uncertain", LOOK))
    found += _energy(view)
    if view.armed and view.mode in (FlightMode.RETURN, FlightMode.LAND):
        found.append(HealthIssue(str(view.mode), LOOK if ordered else ACT))
    elif down and not ordered:
        found.append(HealthIssue("not flying", ACT))
    elif ordered and view.mode == FlightMode.HOLD and view.remaining_j < HELD_LOOK * view.capacity_j:
        found.append(HealthIssue("held, not refuelled", LOOK))
    if lost_share is not None and lost_share >= LOSS_LOOK:
        found.append(HealthIssue(f"loses {100.0 * lost_share:.0f} %", ACT if lost_share >= LOSS_ACT else LOOK))
    return sorted(found, key=lambda issue: -issue.severity)


def _energy(view: VehicleView) -> list[HealthIssue]:
    if view.energy_source == "none":
        return []
    found = []
    share = view.remaining_j / view.capacity_j
    if share < BATTERY_LOOK:
        found.append(HealthIssue(f"battery {100.0 * max(share, 0.0):.0f} %", ACT if share < BATTERY_ACT else LOOK))
    if view.flying and view.endurance_s < EMPTIES_LOOK_S:
        left_s = max(view.endurance_s, 0.0)
        found.append(HealthIssue(f"empties in {left_s:.0f} s", ACT if left_s < EMPTIES_ACT_S else LOOK))
    return found


def severity(found: Iterable[HealthIssue]) -> int:
    """The worst of them."""
    return max((issue.severity for issue in found), default=WELL)


def state(
    view: VehicleView,
    *,
    competing: Collection[int] = (),
    leader: int | None = None,
    waiting: Collection[int] = (),
    served: Collection[int] = (),
    serving: Collection[int] = (),
) -> State:
    """Its part in the refuelling, by the system ids of those who have one."""
    if not view.alive:
        return State.LOST
    for part, ids in ((State.SERVES, serving), (State.SERVED, served), (State.WAITS, waiting)):
        if view.sysid in ids:
            return part
    if view.sysid == leader:
        return State.LEADS
    return State.COMPETING if view.sysid in competing else State.IDLE
