"""A vehicle's battery by its messages alone: initial + received - drawn - given
(docs/protocol/energy.md#energy-accounting).

One account is kept of each vehicle while a session flies, in its replay and in its report, fed in the same order.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gcs.mavlink.battery import BatteryReport, BatteryReports
from gcs.telemetry import energy, plausibility
from gcs.telemetry.energy import SOURCES, EnergySource

CAPACITY, INITIAL = BATTERY_PARAMETERS = ("SIM_BAT_CAP_J", "SIM_BAT_INIT_J")
RECEIVED, GIVEN = COUNTERS = ("XferIn", "XferOut")


@dataclass(frozen=True, slots=True)
class Fact:
    """Something about a battery that the session's record should hold; `gained_j` came with a swapped battery."""

    text: str
    gained_j: float = 0.0


class BatteryAccount:
    """Energies in J; capacity and initial charge as the scenario has them until the vehicle reports them.

    What a vehicle tells and cannot be (gcs/telemetry/plausibility.py) is not taken in; the methods return why.
    """

    def __init__(self, capacity_j: float, initial_j: float, *, from_now: bool = False, started: bool = False) -> None:
        """from_now: the vehicle was switched on before the session, whose energies count from its first report.
        started: the session starts it with this charge, and it counts all that moves since."""
        self.capacity_j = capacity_j
        self.given_j = 0
        self.received_j = 0
        """by the vehicle's own counter, and by the book of bases that charged it without one"""
        self.facts: list[Fact] = []
        """found since they were last taken away"""
        self.account = energy.new_account(capacity_j, initial_j, from_now=from_now)
        """(1,) what compiled code knows of it"""
        self._started_j = initial_j if started else None
        self._initial_stated = False
        self._reported_in_j = self._booked_j = 0
        self._parameters: set[str] = set()

    @property
    def reported(self) -> bool:
        """Whether the vehicle has reported capacity and initial charge, as one does that can take a transfer."""
        return len(self._parameters) == len(BATTERY_PARAMETERS)

    @property
    def initial_j(self) -> float:
        """Energy at the start, J."""
        return float(self.account["initial_j"][0])

    @property
    def drawn_j(self) -> float:
        """Energy drawn so far, J."""
        return float(self.account["drawn_j"][0])

    @property
    def power_w(self) -> float:
        """Mean power of the last while."""
        return float(self.account["power_w"][0])

    @property
    def source(self) -> EnergySource:
        """The word that the power was read from."""
        return SOURCES[int(self.account["power_source"][0])]

    @property
    def remaining_j(self) -> float:
        """Energy in the battery, J."""
        return self.initial_j + self.received_j - self.drawn_j - self.given_j

    def report(self, report: BatteryReport, *, armed: bool) -> str:
        """Take what a message says of the battery."""
        t_s, *words, second_hand = report
        consumed_j, power_w, remaining = (math.nan if word is None else word for word in words)
        outcome = energy.take(self.account, t_s, consumed_j, power_w, remaining, second_hand, armed)
        return self.taken(consumed_j, power_w, *outcome)

    def taken(self, consumed_j: float, power_w: float, became: float, bridged_s: float, gained_j: float) -> str:
        """Go on from a report that compiled code has counted in `account`; why it cannot be. NaN: not reported."""
        if not math.isnan(bridged_s):
            self.facts.append(Fact(f"No current or voltage for {bridged_s:.1f} s: bridged by the mean of both ends"))
        if not math.isnan(gained_j):
            self.facts.append(Fact(f"Battery swapped: {gained_j:.0f} J more than before", gained_j))
        if became == energy.IMPOSSIBLE_POWER:
            return plausibility.impossible_power(power_w)
        return plausibility.impossible_count(consumed_j, "drawn") if became == energy.IMPOSSIBLE_TOTAL else ""

    def reports(self, reports: BatteryReports, *, armed: bool) -> NDArray[np.float64]:
        """Take reports (n,) in their order: (n,) the energy in the battery after each, NaN where one does not count.

        Neither facts nor the power are kept.
        """
        left_j = np.empty(len(reports.t_s))
        t_s, consumed_j, power_w, remaining, second_hand = reports
        second = second_hand.view(np.uint8)
        energy.take_all(self.account, t_s, consumed_j, power_w, remaining, second, armed, left_j)
        return left_j

    def counter(self, name: str, value: int, time_s: float) -> str:
        """Take a NAMED_VALUE_INT: what has been received or given so far."""
        what = "received" if name == RECEIVED else "given"
        one, at = self.account[0], COUNTERS.index(name)
        if doubt := plausibility.counted(value, float(one["told_j"][at]), time_s - float(one["told_s"][at]), what):
            return doubt
        if math.isinf(one["told_j"][at]) and one["initial_known"] and not self._initial_stated:
            # What has moved so far was in the share already by which the charge at the start is known.
            moved_j = -value if name == GIVEN else value
            self.account["initial_j"] -= moved_j
            self.account["moved_j"] += moved_j
        one["told_j"][at], one["told_s"][at] = value, time_s
        if self._started_j is not None and not self._initial_stated and not np.isinf(one["told_j"]).any():
            self._begin_with(self._started_j)  # which the share said in whole per cent
        if name == GIVEN:
            self.account["given_j"] = self.given_j = max(self.given_j, value)
        else:
            self._reported_in_j = max(self._reported_in_j, value)
            self._receive()
        self.account["swappable"] = False
        return ""

    def parameter(self, name: str, value: float) -> str:
        """Take one of BATTERY_PARAMETERS."""
        least_j = 1.0 if name == CAPACITY else 0.0
        if doubt := plausibility.capacity(value, least_j):
            return doubt
        self._parameters.add(name)
        if name == INITIAL:
            self._begin_with(value)
        else:
            self.account["capacity_j"] = self.capacity_j = value
        return ""

    def _begin_with(self, initial_j: float) -> None:
        self.account["initial_j"] = initial_j - float(self.account["before_j"][0])
        self.account["initial_known"] = self._initial_stated = True

    def begin_anew(self) -> None:
        """Let the next share say what is in the batteries, for it is of others than the one before; what has been
        drawn stays."""
        self.account["initial_known"] = False
        self.account["expected_j"] = math.nan
        self.account["spoke_s"] = -math.inf

    def book(self, joules: int) -> None:
        """Count energy that a base gave to a vehicle which cannot report it itself."""
        self._booked_j += joules
        self.account["booked_j"] = self._booked_j
        self._receive()

    def _receive(self) -> None:
        self.account["received_j"] = self.received_j = self._reported_in_j + self._booked_j
