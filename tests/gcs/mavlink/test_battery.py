"""Reports of a battery, message by message and of a recording's rows at once: the same numbers, to the last bit."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from numpy.typing import NDArray

from gcs.mavlink.battery import (
    BatteryReport,
    BatteryReports,
    battery_status,
    battery_statuses,
    sys_status,
    sys_statuses,
)

CELLS = st.sampled_from([0, 1, 3700, 4200, 65534, 65535])
CURRENTS = st.sampled_from([-32768, -100, -2, -1, 0, 1, 1234, 32767])
PERCENT = st.sampled_from([-128, -1, 0, 1, 57, 100, 101, 127])
ROW = np.dtype(
    [
        ("t_s", "f8"), ("energy_consumed", "i4"), ("current_battery", "i2"), ("battery_remaining", "i1"),
        ("voltages", "u2", 10), ("voltages_ext", "u2", 4), ("voltage_battery", "u2"),
    ]
)  # fmt: skip
ROWS = arrays(
    ROW,
    st.integers(1, 5),
    elements=st.tuples(
        st.floats(0.0, 1e6), st.sampled_from([-(2**31), -1, 0, 7, 2**31 - 1]), CURRENTS, PERCENT,
        st.tuples(*[CELLS] * 10), st.tuples(*[CELLS] * 4), CELLS,
    ),
)  # fmt: skip


def at_once(reports: BatteryReports) -> list[BatteryReport]:
    rows = zip(*(column.tolist() for column in reports), strict=True)
    return [BatteryReport(*(None if word != word else word for word in row)) for row in rows]  # noqa: PLR0124


def one_by_one(rows: NDArray[Any], kind: Any) -> list[BatteryReport]:
    return [kind(Plain(row), float(row["t_s"])) for row in rows]


@given(ROWS)
def test_rows_of_battery_status_are_read_as_each_message_is(rows: NDArray[Any]) -> None:
    assert at_once(battery_statuses(rows)) == one_by_one(rows, battery_status)


@given(ROWS)
def test_rows_of_sys_status_are_read_as_each_message_is(rows: NDArray[Any]) -> None:
    assert at_once(sys_statuses(rows)) == one_by_one(rows, sys_status)


class Plain:
    """A row's fields as a decoded message has them: Python's own numbers."""

    def __init__(self, row: Any) -> None:
        for name in ROW.names or ():
            setattr(self, name, row[name].tolist())
