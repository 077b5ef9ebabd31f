"""Conversion of BATTERY_STATUS and SYS_STATUS to SI: J, W and share of charge from hJ, mV, cA and %."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain, takewhile
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

HECTOJOULE = 100.0
CELLS = 10
NO_CELL = 65535
MOST_OF_A_CELL = NO_CELL - 1
NO_CURRENT = frozenset({-1, -100})
"""Value of a current that is not measured: -1 by the protocol; PX4 sends its own -1 A of the same meaning in cA."""


def voltage_v(cells_mv: Sequence[int], more_mv: Sequence[int] = ()) -> float | None:
    """Sum of the cells up to the first that is 65535; `more_mv`, which follow `cells_mv`, are 0 where there is none."""
    total_mv = sum(takewhile(lambda cell_mv: cell_mv != NO_CELL, chain(cells_mv, more_mv)))
    return 1e-3 * total_mv if total_mv else None


def cells_mv(volts: float) -> list[int]:
    """The ten cells of BATTERY_STATUS for a battery of which only the whole voltage is known, by the message's
    definition: in cell 0, what it cannot hold in those after it, 65535 in all others."""
    left_mv = round(1e3 * volts) if 0.0 < volts < 1e-3 * CELLS * MOST_OF_A_CELL else 0
    cells = [NO_CELL] * CELLS
    for k in range(CELLS):
        if left_mv > 0:
            cells[k] = min(left_mv, MOST_OF_A_CELL)
            left_mv -= cells[k]
    return cells


def battery_status(content: Any, time_s: float) -> BatteryReport:
    """BATTERY_STATUS's fields, received at a session time in s."""
    return BatteryReport(
        time_s=time_s,
        consumed_j=None if content.energy_consumed < 0 else HECTOJOULE * content.energy_consumed,
        power_w=_power_w(voltage_v(content.voltages, content.voltages_ext), content.current_battery),
        remaining=_share(content.battery_remaining),
    )


def sys_status(content: Any, time_s: float) -> BatteryReport:
    """SYS_STATUS's fields on the battery, received at a session time in s."""
    return BatteryReport(
        time_s=time_s,
        consumed_j=None,
        power_w=_power_w(voltage_v((content.voltage_battery,)), content.current_battery),
        remaining=_share(content.battery_remaining),
        second_hand=True,
    )


def battery_statuses(rows: NDArray[Any]) -> BatteryReports:
    """As `battery_status` of each row, with its fields and `t_s`, the session time in s."""
    consumed_hj = rows["energy_consumed"]
    consumed_j = np.where(consumed_hj < 0, np.nan, HECTOJOULE * consumed_hj)
    return _reports(rows, consumed_j, _cells_total_mv(rows), second_hand=False)


def sys_statuses(rows: NDArray[Any]) -> BatteryReports:
    """As `sys_status` of each row, likewise."""
    return _reports(rows, np.full(len(rows), np.nan), _status_total_mv(rows), second_hand=True)


def cells_volts(rows: NDArray[Any]) -> NDArray[np.float64]:
    """(n,) V of each row of BATTERY_STATUS, as `voltage_v`; 0 where not known."""
    return 1e-3 * _cells_total_mv(rows).astype(np.float64)


def status_volts(rows: NDArray[Any]) -> NDArray[np.float64]:
    """(n,) V of each row of SYS_STATUS; 0 where not known."""
    return 1e-3 * _status_total_mv(rows).astype(np.float64)


def _cells_total_mv(rows: NDArray[Any]) -> NDArray[np.int64]:
    each_mv = np.hstack([rows["voltages"], rows["voltages_ext"]]).astype(np.int64)
    beyond = np.logical_or.accumulate(each_mv == NO_CELL, axis=1)
    return np.where(beyond, 0, each_mv).sum(axis=1)


def _status_total_mv(rows: NDArray[Any]) -> NDArray[np.int64]:
    total_mv = rows["voltage_battery"].astype(np.int64)
    return np.where(total_mv == NO_CELL, 0, total_mv)


def _reports(
    rows: NDArray[Any], consumed_j: NDArray[np.float64], total_mv: NDArray[np.int64], *, second_hand: bool
) -> BatteryReports:
    current_ca, percent = rows["current_battery"], rows["battery_remaining"]
    measured = (total_mv != 0) & ~np.isin(current_ca, list(NO_CURRENT))
    power_w = np.where(measured, 1e-2 * current_ca.astype(np.float64) * (1e-3 * total_mv), np.nan)
    remaining = np.where((percent >= 0) & (percent <= 100), 0.01 * percent.astype(np.float64), np.nan)
    return BatteryReports(
        rows["t_s"].astype(np.float64), consumed_j, power_w, remaining, np.full(len(rows), second_hand)
    )


def _power_w(volts: float | None, current_ca: int) -> float | None:
    return None if volts is None or current_ca in NO_CURRENT else 1e-2 * current_ca * volts


def _share(percent: int) -> float | None:
    return 0.01 * percent if 0 <= percent <= 100 else None


class BatteryReport(NamedTuple):
    """One message's report of a battery at a session time; None: not reported."""

    time_s: float
    consumed_j: float | None
    """since the autopilot's start"""
    power_w: float | None
    remaining: float | None
    """share of the capacity, 0..1"""
    second_hand: bool = False
    """by SYS_STATUS, which counts only where BATTERY_STATUS is silent"""


class BatteryReports(NamedTuple):
    """Reports as columns (n,), each a `BatteryReport`'s; NaN: not reported."""

    t_s: NDArray[np.float64]
    consumed_j: NDArray[np.float64]
    power_w: NDArray[np.float64]
    remaining: NDArray[np.float64]
    second_hand: NDArray[np.bool_]

    @classmethod
    def of(cls, reports: Sequence[BatteryReport]) -> BatteryReports:
        """These reports as columns."""
        rows = np.array([report[:4] for report in reports], dtype=np.float64).reshape(-1, 4)  # None becomes NaN
        second_hand = np.array([report.second_hand for report in reports], dtype=np.bool_)
        return cls(rows[:, 0], rows[:, 1], rows[:, 2], rows[:, 3], second_hand)

    def take(self, which: slice | NDArray[np.int64]) -> BatteryReports:
        """Some of the reports, in the order in which they are named."""
        t_s, consumed_j, power_w, remaining, second_hand = self
        return BatteryReports(t_s[which], consumed_j[which], power_w[which], remaining[which], second_hand[which])
