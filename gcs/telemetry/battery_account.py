"""A vehicle's battery by its messages alone: initial + received - drawn - given (docs/protocol.md#energy-accounting).

One account is kept of each vehicle while a session flies, in its replay and in its report, fed in the same order.
"""

from __future__ import annotations

import math

from gcs.mavlink.battery import BatteryReport
from gcs.telemetry.energy import EnergyEstimator, Fact

CAPACITY, INITIAL = BATTERY_PARAMETERS = ("SIM_BAT_CAP_J", "SIM_BAT_INIT_J")
RECEIVED, GIVEN = "XferIn", "XferOut"


class BatteryAccount:
    """Energies in J; capacity and initial charge as the scenario has them until the vehicle reports them."""

    def __init__(self, capacity_j: float, initial_j: float, *, from_now: bool = False) -> None:
        """from_now: the vehicle was switched on before the session, whose energies count from its first report."""
        self.capacity_j = capacity_j
        self.initial_j = initial_j
        self.meter = EnergyEstimator(from_now=from_now)
        self.given_j = 0
        self._reported_in_j = self._booked_j = 0
        self._counts = self._initial_reported = False
        self._parameters: set[str] = set()

    @property
    def reported(self) -> bool:
        """Whether the vehicle has reported capacity and initial charge, as one does that can take a transfer."""
        return len(self._parameters) == len(BATTERY_PARAMETERS)

    @property
    def received_j(self) -> int:
        """By the vehicle's own counter, and by the book of bases that charged it without one."""
        return self._reported_in_j + self._booked_j

    @property
    def remaining_j(self) -> float:
        """Energy in the battery, J."""
        return self.initial_j + self.received_j - self.meter.drawn_j - self.given_j

    def report(self, report: BatteryReport, *, armed: bool) -> list[Fact] | None:
        """Take what a message says of the battery; None where it does not count, as with `EnergyEstimator.update`."""
        before_j = self.meter.before_j
        facts = self.meter.update(
            report,
            capacity_j=self.capacity_j,
            moved_j=self._reported_in_j - self.given_j,
            booked_j=self._booked_j,
            initial_j=self.initial_j if self._initial_reported else None,
            armed=armed,
            swappable=not self._counts,
        )
        if facts is None:
            return None
        if self._initial_reported:
            self.initial_j -= self.meter.before_j - before_j  # SIM_BAT_INIT_J is of when it was switched on
        if not self._initial_reported and report.remaining is not None:
            left_j = report.remaining * self.capacity_j
            self.initial_j = left_j + self.meter.drawn_j + self.given_j - self.received_j
            self._initial_reported = True
        for fact in facts:
            self.initial_j += fact.gained_j
        return facts

    def counter(self, name: str, value: int) -> None:
        """Take a NAMED_VALUE_INT: what has been received or given so far."""
        if name == GIVEN:
            self.given_j = max(self.given_j, value)
        elif name == RECEIVED:
            self._reported_in_j = max(self._reported_in_j, value)
        self._counts |= name in (RECEIVED, GIVEN)

    def parameter(self, name: str, value: float) -> None:
        """Take a parameter."""
        if name not in BATTERY_PARAMETERS or not (math.isfinite(value) and value >= 0.0):
            return
        self._parameters.add(name)
        if name == INITIAL:
            self.initial_j = value - self.meter.before_j
            self._initial_reported = True
        elif value > 0.0:
            self.capacity_j = value

    def book(self, joules: int) -> None:
        """Count energy that a base gave to a vehicle which cannot report it itself."""
        self._booked_j += joules
