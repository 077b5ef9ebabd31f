"""Conversion of BATTERY_STATUS and SYS_STATUS to SI: J, W and share of charge from hJ, mV, cA and %."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

HECTOJOULE = 100.0
NO_CELL = 65535
NO_CURRENT = frozenset({-1, -100})
"""Value of a current that is not measured: -1 by the protocol; PX4 sends its own -1 A of the same meaning in cA."""


def voltage_v(cells_mv: Sequence[int], more_mv: Sequence[int] = ()) -> float | None:
    """Sum of the cells: `cells_mv` up to the first that is 65535, and only if there is none `more_mv`, 0 where none."""
    total_mv = 0
    for cell_mv in cells_mv:
        if cell_mv == NO_CELL:
            break
        total_mv += cell_mv
    else:
        total_mv += sum(more_mv)
    return 1e-3 * total_mv if total_mv else None


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


def _power_w(volts: float | None, current_ca: int) -> float | None:
    return None if volts is None or current_ca in NO_CURRENT else 1e-2 * current_ca * volts


def _share(percent: int) -> float | None:
    return 0.01 * percent if 0 <= percent <= 100 else None


@dataclass(frozen=True, slots=True)
class BatteryReport:
    """One message's report of a battery at a session time; None: not reported."""

    time_s: float
    consumed_j: float | None
    """since the autopilot's start"""
    power_w: float | None
    remaining: float | None
    """share of the capacity, 0..1"""
    second_hand: bool = False
    """by SYS_STATUS, which counts only where BATTERY_STATUS is silent"""
