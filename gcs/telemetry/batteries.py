"""All batteries of one vehicle, by BATTERY_STATUS: which of them it flies on, and what they say together.

A vehicle flies on the batteries whose function is propulsion, everything, or not said. The emptiest of them is the one
that counts: it ends the flight. A battery is known by the component that reports it and by its number there.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

from gcs.mavlink.battery import BatteryReport, BatteryReports, battery_status, voltage_v
from skytender import mavlink as mav

FUNCTIONS = {
    mav.MAV_BATTERY_FUNCTION_UNKNOWN: "",
    mav.MAV_BATTERY_FUNCTION_ALL: "all",
    mav.MAV_BATTERY_FUNCTION_PROPULSION: "propulsion",
    mav.MAV_BATTERY_FUNCTION_AVIONICS: "avionics",
    mav.MAV_BATTERY_FUNCTION_PAYLOAD: "payload",
}
GONE_S = 60.0
"""A battery that has been silent for so long counts no more: it may have been taken out."""
MOST_BATTERIES = 32
"""Batteries of one vehicle that are kept; further ones are passed over."""


class VehicleBattery(NamedTuple):
    """The latest of one battery."""

    compid: int
    id: int
    function: int
    """MAV_BATTERY_FUNCTION"""
    report: BatteryReport
    voltage_v: float | None

    @property
    def flown_on(self) -> bool:
        """Whether the vehicle flies on it and it says anything."""
        says = any(word is not None for word in self.report[1:4])
        return says and self.function <= mav.MAV_BATTERY_FUNCTION_PROPULSION


class Batteries:
    """The batteries that one vehicle has reported. Times are of the session, in s."""

    def __init__(self) -> None:
        self._known: dict[tuple[int, int], VehicleBattery] = {}

    def add(self, compid: int, content: Any, time_s: float) -> bool:
        """Take BATTERY_STATUS's fields from a component; whether another battery counts now than before."""
        key = (compid, content.id)
        if key not in self._known and len(self._known) >= MOST_BATTERIES:
            return False
        before = {(one.compid, one.id) for one in self._flown_on(time_s)}
        volts = voltage_v(content.voltages, content.voltages_ext)
        report = battery_status(content, time_s)
        self._known[key] = VehicleBattery(compid, content.id, content.battery_function, report, volts)
        return {(one.compid, one.id) for one in self._flown_on(time_s)} != before

    def begin_with(self, compid: int, first: Sequence[float]) -> None:
        """Take over battery 0 of a component, which was the only one so far, by FIRST_BATTERY's readings of it."""
        time_s, *words, volts, function = first
        consumed_j, power_w, share, voltage = (None if math.isnan(word) else word for word in (*words, volts))
        report = BatteryReport(time_s, consumed_j, power_w, share)
        self._known[compid, 0] = VehicleBattery(compid, 0, int(function), report, voltage)

    @property
    def all(self) -> list[VehicleBattery]:
        """Every one, in order of component and number."""
        return [self._known[key] for key in sorted(self._known)]

    def report(self, now_s: float) -> BatteryReport:
        """Report of those that the vehicle flies on, together.

        One says all that it knows. Of several the share is that of the emptiest, without an energy beside it: what is
        left of the vehicle's capacity follows the emptiest, not the sum of all. Without any share it is the sums.
        """
        reports = [one.report for one in self._flown_on(now_s)]
        if len(reports) == 1:
            return reports[0]._replace(time_s=now_s)
        share = self.share(now_s)
        if share is not None:
            return BatteryReport(now_s, None, None, share)
        consumed_j = [report.consumed_j for report in reports if report.consumed_j is not None]
        return BatteryReport(now_s, sum(consumed_j) if consumed_j else None, self.power_w(now_s), None)

    def share(self, now_s: float) -> float | None:
        """Charge of the emptiest, 0..1; None where none is known."""
        shares = (one.report.remaining for one in self._flown_on(now_s))
        return min((share for share in shares if share is not None), default=None)

    def power_w(self, now_s: float) -> float | None:
        """Power drawn from all together; None where none is known."""
        powers = [one.report.power_w for one in self._flown_on(now_s) if one.report.power_w is not None]
        return sum(powers) if powers else None

    def _flown_on(self, now_s: float) -> list[VehicleBattery]:
        return [one for one in self._known.values() if one.flown_on and now_s - one.report.time_s < GONE_S]


def together(compid: int, statuses: Iterable[tuple[float, Any]]) -> tuple[BatteryReports, list[int]]:
    """(session time, fields) of one component's BATTERY_STATUS: what all its batteries say together at each, and at
    which of them others count than before."""
    batteries, reports, anew = Batteries(), [], []
    for at, (t_s, content) in enumerate(statuses):
        if batteries.add(compid, content, t_s):
            anew.append(at)
        reports.append(batteries.report(t_s))
    return BatteryReports.of(reports), anew
