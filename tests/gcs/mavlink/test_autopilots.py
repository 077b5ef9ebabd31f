"""Mode numbers against pymavlink's own tables, and what autopilots want of a command."""

import math
import struct
import warnings

import pytest

from gcs.mavlink.autopilots import ARDUCOPTER, GENERIC, PX4, STEERABLE, FlightMode, Profile, profile_of

with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # mavutil's own imports warn
    from pymavlink import mavutil

MODES = [
    ("TAKEOFF", FlightMode.TAKEOFF), ("LOITER", FlightMode.HOLD), ("RTL", FlightMode.RETURN),
    ("LAND", FlightMode.LAND), ("OFFBOARD", FlightMode.OFFBOARD),
    ("MANUAL", FlightMode.MANUAL), ("POSCTL", FlightMode.MANUAL), ("MISSION", FlightMode.MISSION),
]  # fmt: skip


@pytest.mark.parametrize(("name", "mode"), MODES)
def test_px4_modes_are_mavutils(name: str, mode: FlightMode) -> None:
    _, main, sub = mavutil.px4_map[name]
    assert PX4.mode(main << 16 | sub << 24) is mode


@pytest.mark.parametrize(
    ("name", "mode"),
    [
        ("GUIDED", FlightMode.OFFBOARD), ("LOITER", FlightMode.HOLD), ("BRAKE", FlightMode.HOLD),
        ("RTL", FlightMode.RETURN), ("LAND", FlightMode.LAND),
        ("STABILIZE", FlightMode.MANUAL), ("POSHOLD", FlightMode.MANUAL), ("AUTO", FlightMode.MISSION),
    ],
)  # fmt: skip
def test_arducopter_modes_are_mavutils(name: str, mode: FlightMode) -> None:
    numbers = {name: number for number, name in mavutil.mode_mapping_acm.items()}
    assert ARDUCOPTER.mode(numbers[name]) is mode


WORDS = {
    FlightMode.OFFBOARD: {"GUIDED"},
    FlightMode.HOLD: {"LOITER", "QLOITER", "BRAKE", "HOLD", "POSHOLD"},
    FlightMode.RETURN: {"RTL", "QRTL"},
    FlightMode.LAND: {"LAND", "QLAND", "AUTOLAND"},
    FlightMode.TAKEOFF: {"TAKEOFF"},
}
KINDS = [
    (1, mavutil.mode_mapping_apm), (21, mavutil.mode_mapping_apm), (10, mavutil.mode_mapping_rover),
    (11, mavutil.mode_mapping_rover), (12, mavutil.mode_mapping_sub), (7, mavutil.mode_mapping_blimp),
    (2, mavutil.mode_mapping_acm), (4, mavutil.mode_mapping_acm), (13, mavutil.mode_mapping_acm),
]  # fmt: skip


@pytest.mark.parametrize(("vehicle_type", "table"), KINDS)
def test_ardupilot_numbers_its_modes_by_the_kind_of_vehicle(vehicle_type: int, table: dict[int, str]) -> None:
    profile = profile_of(3, vehicle_type)
    assert profile.name == "ardupilot"
    for number, name in table.items():
        mode = profile.mode(number)
        if mode in WORDS:
            assert name in WORDS[mode], name
        elif table is not mavutil.mode_mapping_acm:  # its POSHOLD is flown by hand, and it has no more POSITION
            assert not any(name in names for names in WORDS.values()), name
            assert not profile.mode_name(number).startswith("mode "), name
    for params, wanted in ((profile.hold, FlightMode.HOLD), (profile.arming, *profile.arms_in)):
        assert profile.mode(int(params[1])) is wanted
    if "GUIDED" in table.values():
        assert table[int(profile.offboard[1])] == "GUIDED"


def test_an_ardupilots_mode_is_named_as_its_kind_of_vehicle_names_it() -> None:
    names = [profile_of(3, kind).mode_name(11) for kind in (1, 2, 10)]
    assert names == ["RTL", "DRIFT", "RTL"]
    assert [profile_of(3, kind).mode_name(19) for kind in (12, 2, 20)] == ["MANUAL", "AVOID_ADSB", "QLOITER"]
    assert profile_of(3, 12).mode_name(21) == "SURFTRAK"  # of SUB_MODE, which MAVProxy's table is older than


PX4_STATES = {
    "Manual": (1, 0), "Altitude": (2, 0), "Position": (3, 0), "Mission": (4, 4), "Hold": (4, 3), "Return": (4, 5),
    "Position Slow": (3, 2), "Guided Course": (4, 19), "Altitude Cruise": (11, 0), "Acro": (5, 0),
    "Termination": (10, 0), "Offboard": (6, 0), "Stabilized": (7, 0), "Takeoff": (4, 2), "Land": (4, 6),
    "Follow Target": (4, 8), "Precision Landing": (4, 9), "Orbit": (3, 1), "VTOL Takeoff": (4, 10),
    "External 1": (4, 11), "External 8": (4, 18),
}  # fmt: skip
"""`nav_state_names` of PX4 1.18's src/lib/modes/ui.hpp, and the main and sub mode that its
src/modules/commander/px4_custom_mode.h gives each; Descend is sent as Land."""


def test_px4s_modes_are_named_as_px4_names_them() -> None:
    assert {name: PX4.mode_name(main << 16 | sub << 24) for name, (main, sub) in PX4_STATES.items()} == {
        name: name for name in PX4_STATES
    }


ALL = [PX4, GENERIC, *(profile_of(3, kind) for kind in (2, 1, 10, 12, 7))]


@pytest.mark.parametrize("profile", ALL)
def test_no_mode_of_the_table_is_a_mere_number(profile: Profile) -> None:
    assert profile.modes.keys() <= profile.names.keys()


def test_offboard_is_named_as_the_autopilots_people_do() -> None:
    assert mavutil.mode_mapping_acm[int(ARDUCOPTER.offboard[1])] == ARDUCOPTER.offboard_name
    assert PX4_STATES[PX4.offboard_name] == (6, 0)
    _, main, sub = mavutil.px4_map[PX4.offboard_name.upper()]
    assert (float(main), float(sub)) == PX4.offboard[1:]


@pytest.mark.parametrize("profile", [PX4, GENERIC, ARDUCOPTER])
def test_the_command_for_offboard_asks_for_the_mode_that_reads_as_offboard(profile: Profile) -> None:
    flag, main, sub = profile.offboard
    assert flag == 1  # MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
    custom = int(main) if profile is ARDUCOPTER else int(main) << 16 | int(sub) << 24
    assert profile.mode(custom) is FlightMode.OFFBOARD


@pytest.mark.parametrize("profile", [PX4, GENERIC, ARDUCOPTER])
def test_the_modes_that_are_asked_for_read_as_what_they_are_asked_for(profile: Profile) -> None:
    def read(params: tuple[float, ...]) -> FlightMode:
        _, main, sub = map(int, params)
        return profile.mode(main if profile is ARDUCOPTER else main << 16 | sub << 24)

    assert read(profile.hold) is FlightMode.HOLD
    assert read(profile.arming) in profile.arms_in


@pytest.mark.parametrize("profile", [PX4, ARDUCOPTER])
def test_an_integer_parameter_reads_by_its_bytes_from_px4_and_by_its_value_from_ardupilot(profile: Profile) -> None:
    bytewise = struct.unpack("<f", struct.pack("<i", -70_000))[0]
    sent = bytewise if profile is PX4 else -70_000.0
    int32, real32, real64 = (
        getattr(mavutil.mavlink, f"MAV_PARAM_TYPE_{name}") for name in ("INT32", "REAL32", "REAL64")
    )
    assert profile.parameter(sent, int32) == (-70_000, int32)
    assert profile.parameter(0.25, real32) == (0.25, real32)
    assert math.isnan(profile.parameter_number(0.25, real64)) is (profile is PX4)


def test_a_vehicle_can_be_told_to_stand_to_go_home_and_to_land() -> None:
    for profile in (PX4, ARDUCOPTER, GENERIC):
        assert profile.ending("hold") == (mavutil.mavlink.MAV_CMD_DO_SET_MODE, profile.hold)
        assert profile.ending("return")[0] == mavutil.mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH
        command, params = profile.ending("land")
        assert command == mavutil.mavlink.MAV_CMD_NAV_LAND
        assert len(params) == 7


@pytest.mark.parametrize(("autopilot", "profile"), [(12, PX4), (3, ARDUCOPTER), (0, GENERIC), (8, GENERIC)])
def test_an_autopilot_is_known_by_its_heartbeat(autopilot: int, profile: Profile) -> None:
    assert profile_of(autopilot) is profile


def test_take_off_is_above_the_sea_for_px4_and_above_the_ground_for_the_others() -> None:
    heights = [profile.takeoff_param7(2.5, 488.0) for profile in (PX4, ARDUCOPTER, GENERIC)]
    assert heights == [490.5, 2.5, 2.5]


def test_set_points_steer_in_offboard_and_while_refuelling() -> None:
    assert {FlightMode.OFFBOARD, FlightMode.REFUEL} == STEERABLE
    assert PX4.mode(6 << 16 | 1 << 24) is FlightMode.REFUEL
