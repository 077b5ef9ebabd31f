"""Energy that a vehicle has drawn, from whatever its autopilot reports of its battery
(docs/protocol.md#energy-accounting).

Three meters, the best first; a vehicle's `source` is the best one that has spoken within GAP_S:

1. energy_consumed: the autopilot's own total;
2. current_voltage: its power V I, integrated by trapezoids over its samples in session time;
3. battery_remaining: the sum of all falls of the share that is left, times the capacity. Its steps are whole per cent.

Rules:
- Energy drawn never falls. When the source changes it goes on from where it was, with the new meter's progress since.
- Samples of power more than GAP_S apart are bridged by the mean of both ends, which is a trapezoid too: a per cent of
  most batteries is more than what a short gap can be wrong by. Each bridge is a fact.
- A total that falls back while the vehicle is disarmed is an autopilot that was restarted: it goes on from the old one.
- A share that rises is no energy drawn back. Energy that the vehicle itself says it received raises what is expected of
  it. On the ground, disarmed, a rise is first explained by energy that was booked for it elsewhere (a base), and what
  is left, from SWAP_SHARE of the capacity on, is a battery that was swapped: a fact, with the energy that it brought.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import StrEnum

from gcs.mavlink.battery import BatteryReport

GAP_S = 5.0
POWER_WINDOW_S = 5.0
STEPS_WINDOW_S = 120.0
"""Power by battery_remaining is estimated from the steps of so long a time: they are few."""
SWAP_SHARE = 0.2
RESTART_J = 1000.0
"""A total that falls by less has been overtaken on the air."""


class EnergySource(StrEnum):
    """Which of an autopilot's words the energy drawn is read from."""

    NONE = "none"
    ENERGY_CONSUMED = "energy_consumed"
    CURRENT_VOLTAGE = "current_voltage"
    BATTERY_REMAINING = "battery_remaining"


BEST_FIRST = (EnergySource.ENERGY_CONSUMED, EnergySource.CURRENT_VOLTAGE, EnergySource.BATTERY_REMAINING)
AND_LESSER = {source: BEST_FIRST[i:] for i, source in enumerate(BEST_FIRST)}


@dataclass(frozen=True, slots=True)
class Fact:
    """Something about a battery that the session's record should hold; `gained_j` came with a swapped battery."""

    text: str
    gained_j: float = 0.0


class EnergyEstimator:
    """One vehicle's energy drawn; reports come in the order in which they are received."""

    def __init__(self, *, from_now: bool = False) -> None:
        """from_now: drawn since the first report, not since the vehicle was switched on."""
        self._from_now = from_now
        self.before_j = 0.0
        """drawn before that, where it is not counted"""
        self.drawn_j = 0.0
        self.power_w = 0.0
        self.source = EnergySource.NONE
        self._meters: dict[EnergySource, float] = {}
        self._anchors: dict[EnergySource, tuple[float, float]] = {}
        self._spoke_s: dict[EnergySource, float] = {}
        self._first_hand_s: float | None = None
        self._consumed_j = self._before_restart_j = 0.0
        self._sample: tuple[float, float] | None = None
        self._expected_j: float | None = None
        self._moved_j = self._booked_j = self._unseen_j = 0.0
        self._history: list[tuple[float, float]] = []

    def update(
        self,
        report: BatteryReport,
        *,
        capacity_j: float,
        moved_j: float = 0.0,
        booked_j: float = 0.0,
        initial_j: float | None = None,
        armed: bool = True,
        swappable: bool = True,
    ) -> list[Fact] | None:
        """Count one report; None where it does not count: SYS_STATUS while BATTERY_STATUS may still come, or does.

        `moved_j`: received less given so far, by the vehicle's own words. `booked_j`: what was booked for it by others
        so far. `initial_j`: what it started with, None where the first share says it. `swappable`: whether a great rise
        on the ground may be a swapped battery.
        """
        if self._first_hand_s is None:
            self._first_hand_s = report.time_s
        if report.second_hand and report.time_s - self._first_hand_s <= GAP_S:
            return None
        facts: list[Fact] = []
        spoke = []
        if report.consumed_j is not None:
            self._total(report.consumed_j, armed)
            spoke.append(EnergySource.ENERGY_CONSUMED)
        if report.power_w is not None:
            facts += self._integrate(report.time_s, max(report.power_w, 0.0))
            spoke.append(EnergySource.CURRENT_VOLTAGE)
        if report.remaining is not None:
            left_j = report.remaining * capacity_j
            if self._expected_j is None:
                self._expected_j = left_j if initial_j is None else initial_j + moved_j
                self._moved_j, self._booked_j = moved_j, booked_j
            facts += self._fall(left_j, capacity_j, moved_j, booked_j, armed=armed, swappable=swappable)
            spoke.append(EnergySource.BATTERY_REMAINING)
        for source in spoke:
            self._spoke_s[source] = report.time_s
        if spoke and not report.second_hand:
            self._first_hand_s = report.time_s
        self._count(report.time_s, spoke)
        return facts

    def _count(self, now_s: float, spoke: list[EnergySource]) -> None:
        """Let the energy drawn go on by what the best meter went on since its anchor.

        An anchor holds a meter's reading and the energy drawn at that time. Lesser meters' move along, so that they
        would go on from here; a better one that is silent keeps its own, for it will know what was drawn meanwhile.
        """
        for best in BEST_FIRST:
            if now_s - self._spoke_s.get(best, -math.inf) <= GAP_S:
                break
        if best not in spoke:
            return
        if best is not self.source:
            if self.source is EnergySource.NONE:
                self.before_j = self._meters[best] if self._from_now else 0.0
                self._anchors[best] = (self.before_j, 0.0)
            self.source = best
            self._history.clear()
        reading_j = self._meters[best]
        at_j, drawn_j = self._anchors.get(best, (reading_j, self.drawn_j))
        self.drawn_j = max(self.drawn_j, drawn_j + reading_j - at_j)
        for source in AND_LESSER[best]:
            if source in self._meters:
                self._anchors[source] = (self._meters[source], self.drawn_j)
        self._update_power(now_s)

    def _total(self, consumed_j: float, armed: bool) -> None:
        if not armed and consumed_j < min(self._consumed_j - RESTART_J, 0.5 * self._consumed_j):
            self._before_restart_j += self._consumed_j
            self._consumed_j = 0.0
        self._consumed_j = max(self._consumed_j, consumed_j)
        self._meters[EnergySource.ENERGY_CONSUMED] = self._before_restart_j + self._consumed_j

    def _integrate(self, now_s: float, power_w: float) -> list[Fact]:
        facts = []
        integral_j = self._meters.get(EnergySource.CURRENT_VOLTAGE, 0.0)
        if self._sample is not None:
            since_s, before_w = self._sample
            span_s = now_s - since_s
            if span_s <= 0.0:
                return []
            if span_s > GAP_S:
                facts.append(Fact(f"No current or voltage for {span_s:.1f} s: bridged by the mean of both ends"))
            integral_j += 0.5 * (before_w + power_w) * span_s
        self._sample = (now_s, power_w)
        self._meters[EnergySource.CURRENT_VOLTAGE] = integral_j
        return facts

    def _fall(
        self, left_j: float, capacity_j: float, moved_j: float, booked_j: float, *, armed: bool, swappable: bool
    ) -> list[Fact]:
        assert self._expected_j is not None
        fallen_j = self._meters.setdefault(EnergySource.BATTERY_REMAINING, 0.0)
        self._expected_j += moved_j - self._moved_j
        self._unseen_j += booked_j - self._booked_j
        self._moved_j, self._booked_j = moved_j, booked_j
        rise_j = left_j - self._expected_j
        if rise_j <= 0.0:
            self._meters[EnergySource.BATTERY_REMAINING] = fallen_j - rise_j
            self._expected_j = left_j
            return []
        if armed:
            return []
        gained_j = rise_j - self._unseen_j
        if swappable and gained_j >= SWAP_SHARE * capacity_j:
            self._expected_j, self._unseen_j = left_j, 0.0
            return [Fact(f"Battery swapped: {gained_j:.0f} J more than before", gained_j)]
        if self._unseen_j > 0.0:
            self._expected_j, self._unseen_j = left_j, max(self._unseen_j - rise_j, 0.0)
        return []

    def _update_power(self, now_s: float) -> None:
        """Mean power of the last while, over steps of the energy drawn where it moves in steps."""
        history = self._history
        in_steps = self.source is EnergySource.BATTERY_REMAINING
        if in_steps and history and history[-1][1] == self.drawn_j:
            return
        history.append((now_s, self.drawn_j))
        window_s = STEPS_WINDOW_S if in_steps else POWER_WINDOW_S
        while len(history) > 2 and now_s - history[1][0] >= window_s:
            history.pop(0)
        (from_s, from_j), (to_s, to_j) = history[0], history[-1]
        if to_s > from_s:
            self.power_w = (to_j - from_j) / (to_s - from_s)
