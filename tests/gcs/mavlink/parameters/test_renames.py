"""Old names of parameters: facts that ArduPilot's and PX4's own conversions state."""

from __future__ import annotations

import pytest

from gcs.mavlink.autopilots import ARDUCOPTER, GENERIC, PX4
from gcs.mavlink.parameters import renames
from gcs.mavlink.parameters.renames import unknown_name


@pytest.mark.parametrize(
    ("old", "now", "scale"),
    [
        ("WPNAV_ACCEL_C", "WP_ACC_CNR", 0.01),
        ("PSC_ACCZ_P", "PSC_D_ACC_P", 0.1),
        ("PSC_ACCZ_IMAX", "PSC_D_ACC_IMAX", 0.001),
        ("SYSID_THISMAV", "MAV_SYSID", 1.0),
        ("SR0_EXT_STAT", "MAV1_EXT_STAT", 1.0),
    ],
)
def test_arducopters_updates(old: str, now: str, scale: float) -> None:
    row = renames.ARDUPILOT[old]
    assert (row.now, row.scale) == (now, scale)


def test_a_sentence_names_the_new_name_or_the_old_one() -> None:
    assert unknown_name("WPNAV_SPEED", renames.ARDUPILOT) == (
        "ArduPilot 4.7 calls it WP_SPD, 0.01 times the old number, metres for centimetres"
    )
    assert "ARMING_SKIPCHK, whose bits are checks to skip" in unknown_name("ARMING_CHECK", renames.ARDUPILOT)
    assert unknown_name("WP_SPD", renames.ARDUPILOT) == "ArduPilot before 4.7 calls it WPNAV_SPEED"
    assert unknown_name("EKF2_GPS_DELAY", renames.PX4) == (
        "PX4 since March 2026 calls it SENS_GPS0_DELAY, and SENS_GPS1_DELAY"
    )
    assert unknown_name("SENS_GPS0_DELAY", renames.PX4) == "PX4 before March 2026 calls it EKF2_GPS_DELAY"
    assert not unknown_name("NO_SUCH_PARAM", renames.ARDUPILOT)


@pytest.mark.parametrize("table", [renames.ARDUPILOT, renames.PX4])
def test_no_name_is_too_long_for_the_wire_or_both_old_and_new(table: renames.Table) -> None:
    news = {row.now for row in table.values()}
    assert not news & table.keys()
    assert all(0 < len(name) <= 16 and name.isascii() and name.isupper() for name in news | table.keys())


def test_each_autopilot_has_its_table() -> None:
    assert ARDUCOPTER.renamed_parameters is renames.ARDUPILOT
    assert PX4.renamed_parameters is renames.PX4
    assert not GENERIC.renamed_parameters
