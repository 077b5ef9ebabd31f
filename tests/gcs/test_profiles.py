"""Mode numbers against pymavlink's own tables, and what autopilots want of a command."""

import warnings

import pytest

from gcs.profiles import ARDUCOPTER, GENERIC, PX4, STEERABLE, FlightMode, Profile, profile_of

with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # mavutil's own imports warn
    from pymavlink import mavutil

MODES = [
    ("TAKEOFF", FlightMode.TAKEOFF), ("LOITER", FlightMode.HOLD), ("RTL", FlightMode.RETURN),
    ("LAND", FlightMode.LAND), ("OFFBOARD", FlightMode.OFFBOARD), ("MANUAL", FlightMode.OTHER),
    ("MISSION", FlightMode.OTHER),
]  # fmt: skip


@pytest.mark.parametrize(("name", "mode"), MODES)
def test_px4_modes_are_mavutils(name: str, mode: FlightMode) -> None:
    _, main, sub = mavutil.px4_map[name]
    assert PX4.mode(main << 16 | sub << 24) is mode


@pytest.mark.parametrize(
    ("name", "mode"),
    [
        ("GUIDED", FlightMode.OFFBOARD), ("LOITER", FlightMode.HOLD), ("BRAKE", FlightMode.HOLD),
        ("RTL", FlightMode.RETURN), ("LAND", FlightMode.LAND), ("STABILIZE", FlightMode.OTHER),
    ],
)  # fmt: skip
def test_arducopter_modes_are_mavutils(name: str, mode: FlightMode) -> None:
    numbers = {name: number for number, name in mavutil.mode_mapping_acm.items()}
    assert ARDUCOPTER.mode(numbers[name]) is mode


@pytest.mark.parametrize("profile", [PX4, GENERIC, ARDUCOPTER])
def test_the_command_for_offboard_asks_for_the_mode_that_reads_as_offboard(profile: Profile) -> None:
    flag, main, sub = profile.offboard
    assert flag == 1  # MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
    custom = int(main) if profile is ARDUCOPTER else int(main) << 16 | int(sub) << 24
    assert profile.mode(custom) is FlightMode.OFFBOARD


@pytest.mark.parametrize(("autopilot", "profile"), [(12, PX4), (3, ARDUCOPTER), (0, GENERIC), (8, GENERIC)])
def test_an_autopilot_is_known_by_its_heartbeat(autopilot: int, profile: Profile) -> None:
    assert profile_of(autopilot) is profile


def test_take_off_is_above_the_sea_for_px4_and_above_the_ground_for_the_others() -> None:
    heights = [profile.takeoff_param7(2.5, 488.0) for profile in (PX4, ARDUCOPTER, GENERIC)]
    assert heights == [490.5, 2.5, 2.5]


def test_set_points_steer_in_offboard_and_while_refuelling() -> None:
    assert {FlightMode.OFFBOARD, FlightMode.REFUEL} == STEERABLE
    assert PX4.mode(6 << 16 | 1 << 24) is FlightMode.REFUEL
