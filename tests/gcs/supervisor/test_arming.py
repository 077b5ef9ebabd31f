"""From the ground into offboard control and back into it, as snapshots tell it."""

import math
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.mavlink.autopilots import ARDUCOPTER, PX4, FlightMode
from gcs.mavlink.command_protocol import CommandRequest
from gcs.supervisor.arming import SELDOM_S, ArmingSequence, Stage
from gcs.telemetry.state import VehicleView

ARM, TAKEOFF, SET_MODE = 400, 22, 176


def view(**changed: Any) -> VehicleView:
    ground = VehicleView(
        sysid=3, role="pursuer", label="pursuer 3", alive=True, profile=PX4, mode=FlightMode.HOLD, armed=False,
        landed=True, last_received_s=0.0, p_ned=(0.0, 0.0, 0.0), v_ned=(0.0, 0.0, 0.0), age_s=0.0, heading_rad=0.0,
        origin_offset_ned=(0.0, 0.0, 0.0), ground_amsl_m=488.0, capacity_j=1e4, initial_j=1e4, battery_reported=True,
        drawn_j=0.0, received_j=0, given_j=0, given_reported_s=0.0, power_w=0.0, energy_source="none",
        control_effort=0.0,
    )  # fmt: skip
    return ground._replace(**changed)


ARMED = view(armed=True)
CLIMBING = view(armed=True, landed=False, mode=FlightMode.TAKEOFF, p_ned=(0.0, 0.0, -1.0))
UP = CLIMBING._replace(mode=FlightMode.HOLD, p_ned=(0.0, 0.0, -2.4))
FLYING = UP._replace(mode=FlightMode.OFFBOARD)


def commands(arming: ArmingSequence, seen: VehicleView, now_s: float) -> list[CommandRequest]:
    return arming.decide(seen, now_s)[0]


def brought_up() -> ArmingSequence:
    arming = ArmingSequence(3, 2.5)
    for k, seen in enumerate((view(), ARMED, CLIMBING, UP, FLYING)):
        arming.decide(seen, 0.1 * k)
    assert arming.stage is Stage.FLY
    return arming


def test_the_way_up_when_everything_is_granted() -> None:
    arming = ArmingSequence(3, 2.5)
    unknown = view(p_ned=None, origin_offset_ned=None, last_received_s=-math.inf)
    assert (commands(arming, unknown, 0.0), arming.stage) == ([], Stage.IDENTIFY)
    (arm,) = commands(arming, view(), 0.1)
    assert (arm.sysid, arm.command, arm.params[:2]) == (3, ARM, (1.0, 0.0))
    (takeoff,) = commands(arming, ARMED, 0.2)
    assert (takeoff.command, takeoff.params[6]) == (TAKEOFF, 490.5)
    assert all(math.isnan(param) for param in takeoff.params[3:6])
    assert commands(arming, CLIMBING, 5.0) == []
    assert not arming.sends_set_points
    assert commands(arming, UP, 6.0) == []  # set points come first
    assert arming.sends_set_points
    assert commands(arming, UP, 6.1) == []
    (offboard,) = commands(arming, UP, 6.2)
    assert (offboard.command, offboard.params[:3]) == (SET_MODE, PX4.offboard)
    assert commands(arming, FLYING, 6.3) == []
    assert (arming.stage, arming.sends_set_points) == (Stage.FLY, True)


def test_take_off_height_goes_by_the_profile() -> None:
    arming = ArmingSequence(3, 2.5)
    arming.decide(view(profile=ARDUCOPTER), 0.0)
    (takeoff,) = commands(arming, view(profile=ARDUCOPTER, armed=True), 0.1)
    assert takeoff.params[6] == 2.5


@pytest.mark.parametrize("down_m", [-12.0, 30.0])
def test_height_is_above_the_own_ground_wherever_the_common_origin_lies(down_m: float) -> None:
    """A vehicle whose home is 12 m above the common origin is not up before it has left its ground."""
    arming, offset = ArmingSequence(3, 2.5), (0.0, 0.0, down_m)
    for k, seen in enumerate((view(), ARMED, CLIMBING)):
        assert seen.p_ned is not None
        arming.decide(seen._replace(origin_offset_ned=offset, p_ned=(0.0, 0.0, seen.p_ned[2] + down_m)), 0.1 * k)
    assert not arming.sends_set_points
    arming.decide(UP._replace(origin_offset_ned=offset, p_ned=(0.0, 0.0, -2.4 + down_m)), 1.0)
    assert arming.sends_set_points


def test_a_stranger_that_refuses_is_asked_again_every_second() -> None:
    arming = ArmingSequence(3, 2.5)
    asked = [k for k in range(400) if commands(arming, view(), k / 10)]
    assert asked == list(range(0, 400, 10))


def test_one_of_ours_that_refuses_is_asked_ever_more_seldom_and_its_refusal_told_once() -> None:
    arming = ArmingSequence(3, 2.5, seldom_s=SELDOM_S)
    asked, told = [], []
    for k in range(2000):
        if commands(arming, view(), k / 10):
            asked.append(k // 10)
            told.append(not arming.repeats("Arming refused: battery low"))
    assert asked == [0, 1, 3, 7, 15, 31, 63, 95, 127, 159, 191]
    assert told == [True] + [False] * 10
    assert arming.asks_again.endswith("up to 32 s")
    assert not arming.repeats("Arming refused: GPS failed")


def test_one_whose_battery_has_been_charged_is_asked_at_once() -> None:
    arming = ArmingSequence(3, 2.5, seldom_s=SELDOM_S)
    for k in range(1000):
        arming.decide(view(energy_source="energy_consumed"), k / 10)
    # 1 % of 10 kJ, and that again; the last time it was asked was at 95 s
    assert not commands(arming, view(energy_source="energy_consumed", received_j=99), 100.0)
    assert commands(arming, view(energy_source="energy_consumed", received_j=100), 100.1)
    assert not commands(arming, view(energy_source="energy_consumed", received_j=150), 110.0)
    assert commands(arming, view(energy_source="energy_consumed", received_j=200), 110.1)


def test_one_that_was_armed_meanwhile_begins_anew() -> None:
    arming = ArmingSequence(3, 2.5, seldom_s=SELDOM_S)
    for k in range(1000):
        arming.decide(view(), k / 10)
    assert arming.repeats("no") is False
    commands(arming, ARMED, 100.0)
    assert commands(arming, view(), 100.1)
    assert commands(arming, view(), 101.1)
    assert arming.repeats("no") is False


def test_a_vehicle_that_disarms_on_the_ground_is_armed_again() -> None:
    arming = ArmingSequence(3, 2.5)
    arming.decide(view(), 0.0)
    arming.decide(ARMED, 0.1)
    (again,) = commands(arming, view(), 0.2)
    assert (again.command, arming.stage) == (ARM, Stage.ARM)


def test_a_take_off_that_stops_too_low_is_asked_for_again() -> None:
    arming = ArmingSequence(3, 2.5)
    for k, seen in enumerate((view(), ARMED, CLIMBING)):
        arming.decide(seen, 0.1 * k)
    (again,) = commands(arming, CLIMBING._replace(mode=FlightMode.HOLD), 3.0)
    assert again.command == TAKEOFF


@pytest.mark.parametrize("mode", [FlightMode.HOLD, FlightMode.RETURN, FlightMode.OTHER, FlightMode.TAKEOFF])
def test_from_any_other_mode_it_is_brought_back(mode: FlightMode) -> None:
    arming = brought_up()
    assert commands(arming, FLYING._replace(mode=mode), 10.0) == []
    assert (arming.stage, arming.sends_set_points) == (Stage.OFFBOARD, True)
    (offboard,) = commands(arming, FLYING._replace(mode=mode), 10.2)
    assert offboard.command == SET_MODE
    arming.decide(FLYING, 10.3)
    assert arming.stage is Stage.FLY


def test_refuelling_is_flying() -> None:
    arming = brought_up()
    assert commands(arming, FLYING._replace(mode=FlightMode.REFUEL), 10.0) == []
    assert arming.stage is Stage.FLY


@pytest.mark.parametrize(
    "end", [FLYING._replace(mode=FlightMode.LAND), FLYING._replace(armed=False), FLYING._replace(alive=False)]
)
def test_one_that_lands_disarms_or_dies_is_down_for_good(end: VehicleView) -> None:
    arming = brought_up()
    arming.decide(end, 10.0)
    assert (arming.stage, arming.sends_set_points) == (Stage.DOWN, False)
    assert commands(arming, FLYING, 20.0) == []
    assert arming.stage is Stage.DOWN


def test_a_start_in_the_air_flies_at_once() -> None:
    arming = ArmingSequence(3, 2.5)
    assert commands(arming, FLYING, 0.0) == []
    assert arming.stage is Stage.FLY


def test_battery_parameters_are_read_until_told() -> None:
    arming = ArmingSequence(3, 2.5)
    assert arming.decide(view(battery_reported=False, last_received_s=-math.inf), 0.0) == ([], [])
    _, requests = arming.decide(FLYING._replace(battery_reported=False), 0.1)
    read = [codec.fields(codec.split(codec.frame(request, 0, 255, 190)).frames[0]) for request in requests]
    assert [(r.target_system, r.target_component, r.param_index, r.param_id) for r in read] == [
        (3, mav.MAV_COMP_ID_AUTOPILOT1, -1, "SIM_BAT_CAP_J"),
        (3, mav.MAV_COMP_ID_AUTOPILOT1, -1, "SIM_BAT_INIT_J"),
    ]
    assert arming.decide(FLYING._replace(battery_reported=False), 1.0) == ([], [])
    assert len(arming.decide(FLYING._replace(battery_reported=False), 1.1)[1]) == 2
    assert arming.decide(FLYING, 2.1) == ([], [])


@pytest.mark.parametrize(
    ("order", "profile", "command", "params"),
    [
        ("hold", PX4, SET_MODE, (1.0, 4.0, 3.0)),
        ("hold", ARDUCOPTER, SET_MODE, (1.0, 17.0, 0.0)),
        ("return", PX4, 20, ()),
        ("land", ARDUCOPTER, 21, ()),
    ],
)
def test_one_that_is_taken_is_told_so_once_and_left_alone(order: Any, profile: Any, command: int, params: Any) -> None:
    arming, seen = brought_up(), FLYING._replace(profile=profile)
    arming.order(order)
    (told,) = commands(arming, seen, 10.0)
    assert (told.command, told.params[: len(params)], told.token) == (command, params, f"operator {order}")
    assert (arming.stage, arming.sends_set_points, arming.down) == (Stage.TAKEN, False, False)
    for k, mode in enumerate((FlightMode.OFFBOARD, FlightMode.HOLD, FlightMode.LAND)):
        assert commands(arming, seen._replace(mode=mode), 20.0 + k) == []
        assert arming.stage is Stage.TAKEN


def test_while_it_is_bound_an_order_waits_and_set_points_go_on() -> None:
    arming = brought_up()
    arming.order("hold")
    assert arming.decide(FLYING, 10.0, bound=True) == ([], [])
    assert arming.sends_set_points
    assert len(arming.decide(FLYING, 10.1)[0]) == 1


def test_one_with_its_motors_off_stays_there_without_a_word() -> None:
    arming = ArmingSequence(3, 2.5)
    arming.order("hold")
    assert commands(arming, view(), 0.1) == []
    assert commands(arming, view(), 5.0) == []
    assert arming.stage is Stage.TAKEN


def test_another_order_replaces_the_one_before() -> None:
    arming = brought_up()
    arming.order("hold")
    commands(arming, FLYING, 10.0)
    arming.order("land")
    assert [wish.token for wish in commands(arming, FLYING, 11.0)] == ["operator land"]


def test_one_that_rejoins_in_the_air_gets_set_points_and_no_take_off() -> None:
    arming = brought_up()
    arming.order("hold")
    commands(arming, FLYING, 10.0)
    held = UP._replace(mode=FlightMode.HOLD)
    arming.rejoin()
    assert arming.ordered is None
    sent = [wish.command for k in range(10) for wish in commands(arming, held, 20.0 + 0.1 * k)]
    assert sent == [SET_MODE]
    arming.decide(FLYING, 21.0)
    assert arming.stage is Stage.FLY


def test_one_that_rejoins_while_it_lands_is_caught_and_one_that_is_low_climbs() -> None:
    arming = brought_up()
    arming.order("land")
    commands(arming, FLYING, 10.0)
    arming.rejoin()
    landing = UP._replace(mode=FlightMode.LAND)
    assert [wish.command for k in range(4) for wish in commands(arming, landing, 11.0 + 0.1 * k)] == [SET_MODE]
    assert arming.stage is Stage.OFFBOARD
    arming.rejoin()
    low = landing._replace(p_ned=(0.0, 0.0, -0.5))
    assert [wish.command for wish in commands(arming, low, 12.0)] == [TAKEOFF]


@pytest.mark.parametrize("by", ["order", "failsafe"])
def test_one_that_has_landed_takes_off_again_when_it_rejoins(by: str) -> None:
    arming = brought_up()
    if by == "order":
        arming.order("land")
    landed = view(mode=FlightMode.LAND)
    arming.decide(landed, 10.0)
    assert arming.stage is (Stage.TAKEN if by == "order" else Stage.DOWN)
    arming.rejoin()
    sent = [
        wish.command
        for k, seen in enumerate((landed, ARMED, CLIMBING, UP))
        for wish in commands(arming, seen, 20.0 + k)
    ]
    assert sent == [ARM, TAKEOFF]
    assert [wish.command for k in range(4) for wish in commands(arming, UP, 24.0 + 0.1 * k)] == [SET_MODE]
    arming.decide(FLYING, 25.0)
    assert arming.stage is Stage.FLY
    arming.decide(FLYING._replace(mode=FlightMode.LAND), 26.0)
    assert arming.stage is Stage.DOWN


def test_a_dead_vehicle_is_nobodys() -> None:
    arming = brought_up()
    arming.order("hold")
    assert commands(arming, FLYING._replace(alive=False), 10.0) == []
    assert arming.stage is Stage.DOWN


def test_a_vehicle_that_is_to_be_grounded_lands_waits_and_comes_back_up() -> None:
    arming = brought_up()
    arming.grounded = True
    (land,) = commands(arming, FLYING, 10.0)
    assert (land.command, arming.stage) == (mav.MAV_CMD_NAV_LAND, Stage.BASE)
    assert arming.sends_set_points  # until it takes the command, or it would fly its failsafe
    landing = FLYING._replace(mode=FlightMode.LAND)
    assert commands(arming, landing, 10.1) == []
    assert not arming.sends_set_points
    landed = view(mode=FlightMode.LAND)
    for k in range(100):
        assert commands(arming, landed, 14.0 + k) == []
    assert arming.stage is Stage.BASE
    assert not arming.down
    arming.grounded = False
    (arm,) = commands(arming, landed, 200.0)
    assert (arm.command, arm.params[0], arming.stage) == (ARM, 1.0, Stage.ARM)
    (takeoff,) = commands(arming, ARMED, 200.1)
    assert takeoff.command == TAKEOFF
    for k, seen in enumerate((CLIMBING, UP, FLYING)):
        arming.decide(seen, 201.0 + k)
    assert arming.stage is Stage.FLY


def test_landing_at_a_base_is_asked_for_until_it_is_flown() -> None:
    arming = brought_up()
    arming.grounded = True
    asked = [wish.command for k in range(31) for wish in commands(arming, FLYING, 10.0 + 0.1 * k)]
    assert asked == [mav.MAV_CMD_NAV_LAND] * 4
    held = FLYING._replace(mode=FlightMode.HOLD)
    assert [wish.command for wish in commands(arming, held, 14.0)] == [mav.MAV_CMD_NAV_LAND]


def test_an_autopilot_that_does_not_disarm_by_itself_is_disarmed_at_the_base() -> None:
    arming = brought_up()
    arming.grounded = True
    commands(arming, FLYING, 10.0)
    landed = ARMED._replace(mode=FlightMode.LAND)
    asked = [(k, wish) for k in range(80) for wish in commands(arming, landed, 10.1 + 0.1 * k)]
    assert [(wish.command, wish.params[0]) for _, wish in asked] == [(ARM, 0.0)] * 2
    assert asked[0][0] >= 29


def cut_off(*, rejoins_itself: bool, charge_j: float = 5e3) -> ArmingSequence:
    """Flown by its failsafe while 30 s of its link were out, and landed when it is received again."""
    pilot = ArmingSequence(3, 2.5, rejoins_itself=rejoins_itself)
    for k, seen in enumerate((view(), ARMED, CLIMBING, UP, FLYING)):
        pilot.decide(seen, 0.1 * k)
    for k in range(30):
        pilot.decide(FLYING._replace(age_s=float(k)), 1.0 + k)
    pilot.decide(FLYING, 31.0)  # the first position comes before the first HEARTBEAT
    assert pilot.stage is Stage.FLY
    pilot.decide(view(drawn_j=1e4 - charge_j), 31.4)
    return pilot


def test_a_vehicle_whose_link_was_out_rejoins_by_itself_where_its_battery_allows() -> None:
    assert cut_off(rejoins_itself=True).stage is Stage.ARM
    assert cut_off(rejoins_itself=True, charge_j=1.9e3).stage is Stage.DOWN
    assert cut_off(rejoins_itself=False).stage is Stage.DOWN


def test_it_is_asked_back_from_the_middle_of_its_landing_and_a_landing_much_later_is_no_outage() -> None:
    pilot = ArmingSequence(3, 2.5, rejoins_itself=True)
    for k, seen in enumerate((view(), ARMED, CLIMBING, UP, FLYING, FLYING._replace(age_s=2.5))):
        pilot.decide(seen, 0.1 * k)
    assert commands(pilot, UP._replace(mode=FlightMode.LAND), 2.0) == []  # set points come first
    (offboard,) = commands(pilot, UP._replace(mode=FlightMode.LAND), 2.2)
    assert (pilot.stage, pilot.rejoining, offboard.command) == (Stage.OFFBOARD, True, SET_MODE)
    pilot.decide(FLYING, 2.5)
    assert (pilot.stage, pilot.rejoining) == (Stage.FLY, False)
    pilot.decide(UP._replace(mode=FlightMode.LAND), 6.0)
    assert pilot.stage is Stage.DOWN
