"""The table of a vehicle's parameters, which both programs read."""

import subprocess
import sys

import pytest

from skytender.vehicle.parameters import ALONE, ROWS, TABLE, UNITS, ParameterRow, float32


def test_each_name_stands_once_and_fits_a_frame() -> None:
    names = [row.name for row in (*TABLE, *ALONE)]
    assert list(ROWS) == names == [*dict.fromkeys(names)]
    assert all(0 < len(name.encode("ascii")) <= 16 and name == name.upper() for name in names)


@pytest.mark.parametrize("row", ROWS.values(), ids=lambda row: row.name)
def test_a_default_is_a_value_that_may_be_set(row: ParameterRow) -> None:
    assert row.least <= row.default <= row.most
    assert row.least <= float32(row.default) <= row.most
    assert not row.whole or all(number == int(number) for number in (row.least, row.default, row.most))
    assert row.units in UNITS | {""}


def test_the_table_is_plain_data_that_costs_no_other_module() -> None:
    code = "import sys; import skytender.vehicle.parameters; print(*sys.modules)"
    heavy = {"numpy", "pydantic", "dataclasses", "skytender.mavlink"}
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert "skytender.vehicle.parameters" in found
    assert not heavy & {*found}
