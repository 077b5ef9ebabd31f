"""Reports by which the vehicles of a fleet know each other, and what one of them has received so far.

A report is a row of 32-bit floats (docs/protocol/onboard.md#peer-reports). What a vehicle knows of itself goes through
the same rounding, so that all compete with the same numbers.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from enum import IntEnum
from itertools import islice
from typing import Any, NamedTuple

from simvehicle.autopilot.vectors import Vec3
from skytender.vehicle.parameters import float32

STALE_S = 1.5
"""A peer that has been silent for so long takes no part any more."""
FARTHEST_M = 1e6


class PeerStage(IntEnum):
    """Part that a vehicle takes in the fleet's refuelling."""

    APART = 0
    COMPETES = 1
    CALLS = 2
    MEETS = 3
    TRANSFERS = 4
    FREE = 5


class DecidedBy(IntEnum):
    """Rule by which a winner called its tanker."""

    NONE = 0
    COMPETITION = 1
    UNOPPOSED = 2
    URGENCY = 3
    TIMEOUT = 4


class PeerReport(NamedTuple):
    """One vehicle at `time_s` of the session; NED in the fleet's frame, SI.

    A tanker's `remaining_j` is what it can spare. `bid_s`, `slack_s`, `way_s` and `ln_v` mean something only for a
    vehicle that competes or calls: its bid, the time left beyond that until it can be served, the way to it, and the
    logarithm of its state over the leader's. `since_s`: when it called, or was called. `meet_ned`: where a receiver
    waits.
    """

    time_s: float
    stage: PeerStage = PeerStage.APART
    partner: int = 0
    up: bool = False
    p_ned: Vec3 = (0.0, 0.0, 0.0)
    v_ned: Vec3 = (0.0, 0.0, 0.0)
    remaining_j: float = 0.0
    capacity_j: float = 0.0
    power_w: float = 0.0
    bid_s: float = 0.0
    slack_s: float = 0.0
    way_s: float = 0.0
    ln_v: float = 0.0
    given_j: int = 0
    since_s: float = 0.0
    by: DecidedBy = DecidedBy.NONE
    meet_ned: Vec3 = (0.0, 0.0, 0.0)

    @property
    def need(self) -> float:
        """Share of the battery that is gone."""
        return 1.0 - self.remaining_j / self.capacity_j if self.capacity_j > 0.0 else 0.0

    def p_at(self, now_s: float) -> Vec3:
        """Its place at a time, if it flies straight on."""
        age_s = min(max(now_s - self.time_s, 0.0), STALE_S)
        north, east, down = (p + v * age_s for p, v in zip(self.p_ned, self.v_ned, strict=True))
        return north, east, down

    def remaining_at_j(self, now_s: float) -> float:
        """Its energy at a time, at the present draw."""
        return self.remaining_j - self.power_w * max(now_s - self.time_s, 0.0)


class ServiceReport(NamedTuple):
    """One service of a tanker, so far; times in s of the session, negative while they are not known."""

    number: int
    receiver: int
    by: DecidedBy
    decided_s: float
    start_s: float = -1.0
    end_s: float = -1.0
    energy_j: int = 0
    ending: int = 0


def row_of(report: PeerReport) -> tuple[float, ...]:
    """A report as it travels, without its time: its numbers in the order of its fields."""
    return tuple(float(x) for value in report[1:] for x in (value if isinstance(value, tuple) else (value,)))


ROW = len(row_of(PeerReport(0.0)))
_KINDS: tuple[Any, ...] = tuple(map(type, PeerReport._field_defaults.values()))  # of all fields but the time
BY = ROW - 4
"""Place in a row of the rule; a vector is behind it."""
_STAGES, _RULES = frozenset(PeerStage), frozenset(DecidedBy)


def report_of(time_s: float, row: Sequence[float]) -> PeerReport | None:
    """A report from the numbers that came; None where they are none."""
    if len(row) < ROW or not all(map(math.isfinite, row[:ROW])) or max(map(abs, row[3:9])) > FARTHEST_M:
        return None
    if row[0] not in _STAGES or row[BY] not in _RULES or not 0.0 <= row[1] <= 255.0:
        return None
    numbers = iter(row)
    values: Any = (tuple(islice(numbers, 3)) if kind is tuple else kind(next(numbers)) for kind in _KINDS)
    return PeerReport(time_s, *values)


def as_sent(report: PeerReport) -> PeerReport:
    """A report as the others receive it."""
    same = report_of(report.time_s, tuple(map(float32, row_of(report))))
    assert same is not None, "a vehicle's own numbers are finite"
    return same


class Peers:
    """Newest report of each other vehicle."""

    def __init__(self) -> None:
        self._reports: dict[int, PeerReport] = {}

    def receive(self, sysid: int, report: PeerReport) -> None:
        """Take one in; one that was overtaken counts no more."""
        known = self._reports.get(sysid)
        if known is None or report.time_s >= known.time_s:
            self._reports[sysid] = report

    def fresh(self, now_s: float) -> dict[int, PeerReport]:
        """All fresh reports, in order of system id."""
        return {sysid: report for sysid, report in sorted(self._reports.items()) if now_s - report.time_s <= STALE_S}
