"""One instance flown by a rule that sends free tankers, as a session does, on the instance's own kinematics.

What is the same for all rules: a receiver is waiting from WANTS_FROM of its capacity on, as `competition.need_from`
has it; a service gives until FULL, or what lasts until the horizon; a tanker with too little left loads at the base
that it is soonest done at; a free base takes the waiting receiver that lands first of those that can come in time; no
tanker is sent where it would come too late. A rule is asked every TICK_S while a tanker is free. Times in s, indices of
arrays.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np

from gcs.benchmark.arrays import MEETS_LATER_S, Arrays, Floats, Ints, net_w
from gcs.benchmark.format import SCHEDULE, Schedule, ScheduledService
from skytender import elementary

TICK_S = 0.2
WANTS_FROM = 0.5
FULL = 0.9
LOADS_BELOW = 0.3
"""[choice] Of the mean receiver's capacity."""
LOADS_S = 10.0
"""[choice] Longest flow of a load, as the others wait for the base: best of 10, 20 and 40 s in ten instances."""
MARGIN_J = 1.0


class DispatchRule(Protocol):
    """Sends free tankers to waiting receivers."""

    def assign(self, flight: DispatchedFlight) -> dict[int, int]:
        """Receiver by tanker, both of the flight's `free` and `waiting`."""


class DispatchedFlight:
    """The state at `now_s`, and the services so far."""

    def __init__(self, arrays: Arrays) -> None:
        self.arrays, self.now_s = arrays, 0.0
        self.lands_s, self.busy_s = arrays.lands_s.copy(), np.zeros(arrays.n)
        self.free_s, self.place_ned, self.spare_j = np.zeros(arrays.m), arrays.start_ned.copy(), arrays.spare_j.copy()
        self.base_free_s, self.stock_j = np.zeros(arrays.k), arrays.stock_j.copy()
        self._little_j = LOADS_BELOW * float(arrays.capacity_j.sum()) / max(arrays.n, 1)
        self.services: list[ScheduledService] = []
        self.free: list[int] = []
        self.waiting: list[int] = []

    def flown(self, rule: DispatchRule) -> Schedule:
        """The schedule that the rule makes from the start to the horizon."""
        while self.now_s < self.arrays.horizon_s - self.arrays.setup_s:
            self._load()
            self._look()
            self._serve_at_bases()
            self._look()
            if self.free and self.waiting:
                for tanker, receiver in rule.assign(self).items():
                    if tanker in self.free and receiver in self.waiting:
                        self._serve(tanker, receiver)
            self.now_s += TICK_S
        return Schedule(SCHEDULE, self.arrays.instance.name, self.services)

    def _look(self) -> None:
        """Which tankers are free, and which receivers wait and can be reached by one in time."""
        arrays = self.arrays
        self.free = [int(t) for t in np.flatnonzero((self.free_s <= self.now_s) & (self.spare_j > 10.0 * MARGIN_J))]
        held_j = arrays.capacity_j - arrays.holds_j + arrays.power_w * (self.lands_s - self.now_s)
        waits = (self.busy_s <= self.now_s) & (self.lands_s > self.now_s) & (self.lands_s < arrays.horizon_s - 1e-6)
        self.waiting = [int(i) for i in np.flatnonzero(waits & (held_j <= WANTS_FROM * arrays.capacity_j))]
        if self.free and self.waiting:
            begins_s = self.now_s + self.ways_s() + arrays.setup_s
            in_time = begins_s.min(axis=0) < self.lands_s[self.waiting] - 0.05
            self.waiting = [i for i, may in zip(self.waiting, in_time, strict=True) if may]

    def flying(self) -> list[int]:
        """Receivers in the air that no giver serves and that would land before the horizon."""
        arrays = self.arrays
        may = (self.busy_s <= self.now_s) & (self.lands_s > self.now_s) & (self.lands_s < arrays.horizon_s - 1e-6)
        return [int(i) for i in np.flatnonzero(may)]

    def holds_in_s(self, receivers: list[int], share: float) -> Floats:
        """(receivers,) until each holds a share of its capacity if it gets no more; below 0 where it holds less."""
        arrays, at = self.arrays, np.array(receivers)
        above_j = (share * arrays.capacity_j - arrays.capacity_j + arrays.holds_j)[at]
        return np.asarray(self.lands_s[at] - above_j / arrays.power_w[at] - self.now_s)

    def ways_s(self, receivers: list[int] | None = None) -> Floats:
        """(free, waiting or other receivers) the time of each way to a meeting, from now on."""
        at = np.array(self.waiting if receivers is None else receivers)
        here = self.place_ned[self.free][:, None]
        speed_m_s = self.arrays.speed_m_s[self.free][:, None]
        from_s = np.full((len(self.free), len(at)), self.now_s)
        return self.arrays.meets_s(at, from_s, here, speed_m_s) - self.now_s

    def slack_s(self) -> Floats:
        """(waiting,) until energy must flow at the latest."""
        return np.asarray(self.lands_s[self.waiting] - self.now_s)

    def takes_s(self, receivers: list[int], flows_from_s: Floats) -> Floats:
        """(receivers,) how long energy flows in services of a tanker that has enough."""
        return self._energy_j(np.array(receivers), flows_from_s, self.arrays.rate_w, 0.0) / self.arrays.rate_w

    def _energy_j(self, i: Ints | int, flows_from_s: Floats | float, rate_w: float, stood_s: float) -> Floats:
        """Until FULL or the horizon, whichever is less; at a base, where it stands since `stood_s` before, without a
        draw."""
        arrays = self.arrays
        power_w = arrays.power_w[i]
        draws_w = 0.0 if stood_s else power_w
        above_j = FULL * arrays.capacity_j[i] - (arrays.capacity_j[i] - arrays.holds_j[i])
        room_j = above_j - power_w * (self.lands_s[i] + stood_s - flows_from_s)
        lacks_j = power_w * (arrays.horizon_s - self.lands_s[i] - stood_s) + MARGIN_J
        horizon_j = rate_w * (arrays.horizon_s - flows_from_s)
        most_j = np.minimum(np.minimum(room_j * rate_w / net_w(rate_w, draws_w), lacks_j), horizon_j)
        return np.asarray(np.maximum(most_j, 0.0))

    def _serve(self, t: int, i: int) -> None:
        """Tanker t serves receiver i, if it comes in time."""
        arrays = self.arrays
        start_s = float(
            arrays.meets_s(np.array(i), self.now_s, self.place_ned[t], float(arrays.speed_m_s[t]))
        )  # fmt: skip
        flows_s = start_s + arrays.setup_s
        if flows_s >= self.lands_s[i] - 0.02 or flows_s >= arrays.horizon_s:
            return
        energy_j = min(float(self._energy_j(i, flows_s, arrays.rate_w, 0.0)), float(self.spare_j[t]) - MARGIN_J)
        if energy_j <= 0.0:
            return
        end_s = flows_s + energy_j / arrays.rate_w
        self.lands_s[i] += energy_j / arrays.power_w[i]
        self.busy_s[i] = self.free_s[t] = end_s
        self.place_ned[t], self.spare_j[t] = arrays.at(i, end_s), self.spare_j[t] - energy_j
        one = arrays.instance
        self.services.append(ScheduledService(start_s, end_s, energy_j, one.receivers[i].id, one.tankers[t].id))

    def _load(self) -> None:
        """Free tankers with little left load at the base that they are soonest done at."""
        arrays = self.arrays
        for t in np.flatnonzero((self.free_s <= self.now_s) & (self.spare_j < self._little_j)):
            best: tuple[float, int, float, float] | None = None
            for b in range(arrays.k):
                way_s = elementary.distance(arrays.base_ned[b], self.place_ned[t]) / arrays.speed_m_s[t] + 1e-3
                start_s = max(self.now_s + float(way_s), float(self.base_free_s[b]))
                held_j = self.spare_j[t] + arrays.tanker_power_w[t] * (arrays.horizon_s - start_s)
                most_j = min(arrays.tanker_holds_j[t] - held_j, self.stock_j[b], LOADS_S * arrays.base_rate_w[b])
                energy_j = float(most_j) - MARGIN_J
                end_s = start_s + arrays.setup_s + energy_j / float(arrays.base_rate_w[b])
                useful = energy_j > self._little_j and end_s < arrays.horizon_s
                if useful and (best is None or end_s < best[0]):
                    best = (end_s, b, start_s, energy_j)
            if best is None:
                continue
            end_s, b, start_s, energy_j = best
            self.spare_j[t] += energy_j + arrays.tanker_power_w[t] * (end_s - start_s)
            self.free_s[t] = self.base_free_s[b] = end_s
            self.place_ned[t], self.stock_j[b] = arrays.base_ned[b], self.stock_j[b] - energy_j
            one = arrays.instance
            self.services.append(
                ScheduledService(start_s, end_s, energy_j, tanker=one.tankers[int(t)].id, base=one.bases[b].name)
            )

    def _serve_at_bases(self) -> None:
        """Free bases take the receivers that land first."""
        arrays = self.arrays
        for b in np.flatnonzero(self.base_free_s <= self.now_s):
            for i in sorted(self.waiting, key=lambda one: float(self.lands_s[one])):
                place, speed_m_s = arrays.base_ned[b], float(arrays.off_path_m_s[i])
                way_s = float(elementary.distance(arrays.at(i, self.now_s), place)) / speed_m_s + MEETS_LATER_S
                start_s = self.now_s + way_s
                rate_w = float(arrays.base_rate_w[b])
                if start_s > self.lands_s[i] - 0.05 or start_s + arrays.setup_s >= arrays.horizon_s:
                    continue
                flows_s = start_s + arrays.setup_s
                energy_j = float(self._energy_j(i, flows_s, rate_w, arrays.setup_s))
                energy_j = min(energy_j, float(self.stock_j[b]) - MARGIN_J)
                if energy_j <= 0.1 * arrays.holds_j[i]:
                    continue
                end_s = flows_s + energy_j / rate_w
                back_s = float(arrays.meets_s(np.array(i), end_s, place, speed_m_s))
                self.lands_s[i] += energy_j / arrays.power_w[i] + end_s - start_s
                self.busy_s[i], self.base_free_s[b], self.stock_j[b] = back_s, end_s, self.stock_j[b] - energy_j
                self.waiting.remove(i)
                one = arrays.instance
                self.services.append(
                    ScheduledService(
                        start_s, end_s, energy_j, one.receivers[i].id, base=one.bases[b].name, leave_s=self.now_s,
                        back_s=back_s,
                    )
                )  # fmt: skip
                break
