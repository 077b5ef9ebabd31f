"""Watch of an autopilot's two voltages of its battery: SYS_STATUS's, and the sum of BATTERY_STATUS's cells.

They disagree where a message cannot hold what it is to tell: PX4 cut twelve cells to the ten that BATTERY_STATUS had
(PX4-Autopilot issue 18535). BATTERY_STATUS is what is shown; that the other says another voltage is said once.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import repeat
from operator import itemgetter
from typing import Any

from numpy.typing import NDArray

from gcs.mavlink.battery import cells_volts, status_volts

DISAGREE = 0.05
"""[choice] Share of the greater one by which they may differ: they are measured at other times, under other loads."""
LASTING_S = 10.0
"""[choice] They must have disagreed for so long, in each report."""
FRESH_S = 10.0
"""[choice] A battery's voltage is compared for so long."""
MOST_BATTERIES = 32


class VoltageWatch:
    """One autopilot's two voltages; times in s, voltages in V, 0 where not known."""

    def __init__(self) -> None:
        self._batteries: dict[int, tuple[float, float]] = {}
        self._since_s: float | None = None
        self._said = False

    def take_battery(self, number: int, voltage_v: float, t_s: float) -> None:
        """Take the sum of a battery's cells, by BATTERY_STATUS."""
        if number in self._batteries or len(self._batteries) < MOST_BATTERIES:
            self._batteries[number] = t_s, voltage_v

    def take_status(self, voltage_v: float, t_s: float) -> str | None:
        """Take SYS_STATUS's voltage; a sentence without the vehicle's name once the two have disagreed for long.

        SYS_STATUS does not say which battery it is of: it disagrees where it is like none.
        """
        fresh = [
            (number, volts)
            for number, (at_s, volts) in self._batteries.items()
            if abs(t_s - at_s) <= FRESH_S and volts > 0.0
        ]
        if self._said or not fresh or not voltage_v > 0.0:
            return None
        number, volts = min(fresh, key=lambda one: abs(one[1] - voltage_v))
        if abs(volts - voltage_v) <= DISAGREE * max(volts, voltage_v):
            self._since_s = None
            return None
        self._since_s = t_s if self._since_s is None else self._since_s
        if t_s - self._since_s < LASTING_S:
            return None
        self._said = True
        return (
            f"SYS_STATUS says {voltage_v:.1f} V and BATTERY_STATUS {volts:.1f} V of battery {number}: "
            "what BATTERY_STATUS says is shown, for it tells of each battery by itself"
        )


class VoltageWatches:
    """The voltages of many autopilots, by system and component, out of a recording's rows."""

    def __init__(self) -> None:
        self._each: dict[tuple[int, int], VoltageWatch] = {}

    def take(
        self, statuses: NDArray[Any], statuses_s: NDArray[Any], batteries: NDArray[Any], batteries_s: NDArray[Any]
    ) -> Iterator[tuple[int, float, str]]:
        """(system id, time, sentence) of those that disagree.

        Args:
            statuses: (n,) of SYS_STATUS, of which sysid, compid and voltage_battery are read; of a stretch of the
                recording that follows the one before.
            statuses_s: (n,) when they came.
            batteries, batteries_s: the same of BATTERY_STATUS, of which id, voltages and voltages_ext are read.
        """
        cells_v, numbers = cells_volts(batteries).tolist(), batteries["id"].tolist()
        told: list[tuple[float, tuple[int, int], int | None, float]] = [
            *zip(batteries_s.tolist(), _senders(batteries), numbers, cells_v, strict=True),
            *zip(statuses_s.tolist(), _senders(statuses), repeat(None), status_volts(statuses).tolist(), strict=False),
        ]
        for t_s, sender, number, volts in sorted(told, key=itemgetter(0)):
            watch = self._each.setdefault(sender, VoltageWatch())
            if number is not None:
                watch.take_battery(number, volts, t_s)
            elif (said := watch.take_status(volts, t_s)) is not None:
                yield sender[0], t_s, said


def _senders(rows: NDArray[Any]) -> Iterator[tuple[int, int]]:
    return zip(rows["sysid"].tolist(), rows["compid"].tolist(), strict=True)
