"""From the ground into offboard control and back into it, as snapshots tell it."""

import math
from typing import Any

import pytest
import views as base
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.mavlink.autopilots import ARDUCOPTER, PX4, FlightMode
from gcs.mavlink.command_protocol import CommandRequest
from gcs.supervisor.arming import SELDOM_S, ArmingSequence, Stage
from gcs.telemetry.state import VehicleView

ARM, TAKEOFF, SET_MODE, LAND = 400, 22, 176, 21
Step = tuple[float, VehicleView, list[int], Stage | None]


def view(**changed: Any) -> VehicleView:
    """On the ground, in hold, its battery full."""
    ground: dict[str, Any] = {"mode": FlightMode.HOLD, "armed": False, "landed": True, "drawn_j": 0.0}
    return base.view(3, **(ground | {"energy_source": "none", "p_ned": (0.0, 0.0, 0.0)} | changed))


ARMED = view(armed=True)
CLIMBING = view(armed=True, landed=False, mode=FlightMode.TAKEOFF, p_ned=(0.0, 0.0, -1.0))
UP = CLIMBING._replace(mode=FlightMode.HOLD, p_ned=(0.0, 0.0, -2.4))
FLYING = UP._replace(mode=FlightMode.OFFBOARD)
LANDING, LANDED = UP._replace(mode=FlightMode.LAND), view(mode=FlightMode.LAND)


def commands(arming: ArmingSequence, seen: VehicleView, now_s: float) -> list[CommandRequest]:
    return arming.decide(seen, now_s)[0]


def asked(arming: ArmingSequence, seen: VehicleView, from_s: float, ticks: int) -> list[int]:
    """The commands of so many ticks of 0.1 s in which nothing changes."""
    return [wish.command for k in range(ticks) for wish in commands(arming, seen, from_s + 0.1 * k)]


def play(arming: ArmingSequence, *steps: Step) -> None:
    """What is commanded at each time, and the stage after it where one is given."""
    for now_s, seen, wanted, stage in steps:
        assert asked(arming, seen, now_s, 1) == wanted, now_s
        assert stage in (None, arming.stage), now_s


def brought_up(**options: Any) -> ArmingSequence:
    arming = ArmingSequence(3, 2.5, **options)
    for k, seen in enumerate((view(), ARMED, CLIMBING, UP, FLYING)):
        arming.decide(seen, 0.1 * k)
    assert arming.stage is Stage.FLY
    return arming


def test_the_way_up_when_everything_is_granted() -> None:
    arming = ArmingSequence(3, 2.5)
    unknown = view(p_ned=None, origin_offset_ned=None, last_received_s=-math.inf)
    play(arming, (0.0, unknown, [], Stage.IDENTIFY))
    (arm,) = commands(arming, view(), 0.1)
    assert (arm.sysid, arm.command, arm.params[:2]) == (3, ARM, (1.0, 0.0))
    (takeoff,) = commands(arming, ARMED, 0.2)
    assert (takeoff.command, takeoff.params[6]) == (TAKEOFF, 490.5)
    assert all(math.isnan(param) for param in takeoff.params[3:6])
    play(arming, (5.0, CLIMBING, [], None))
    assert not arming.sends_set_points
    play(arming, (6.0, UP, [], None))  # set points come first
    assert arming.sends_set_points
    play(arming, (6.1, UP, [], None))
    (offboard,) = commands(arming, UP, 6.2)
    assert (offboard.command, offboard.params[:3]) == (SET_MODE, PX4.offboard)
    play(arming, (6.3, FLYING, [], Stage.FLY))
    assert arming.sends_set_points


def test_take_off_height_goes_by_the_profile() -> None:
    arming = ArmingSequence(3, 2.5)
    arming.decide(view(profile=ARDUCOPTER), 0.0)
    (takeoff,) = commands(arming, view(profile=ARDUCOPTER, armed=True), 0.1)
    assert takeoff.params[6] == 2.5


@pytest.mark.parametrize("down_m", [-12.0, 30.0])
def test_height_is_above_the_own_ground_wherever_the_common_origin_lies(down_m: float) -> None:
    """A vehicle whose home is 12 m above the common origin is not up before it has left its ground."""
    arming, offset = ArmingSequence(3, 2.5), (0.0, 0.0, down_m)
    for k, seen in enumerate((view(), ARMED, CLIMBING, UP)):
        assert seen.p_ned is not None
        assert not arming.sends_set_points
        arming.decide(seen._replace(origin_offset_ned=offset, p_ned=(0.0, 0.0, seen.p_ned[2] + down_m)), 0.1 * k)
    assert arming.sends_set_points


def test_who_refuses_is_asked_again_one_of_ours_ever_more_seldom_and_its_refusal_told_once() -> None:
    stranger, ours = ArmingSequence(3, 2.5), ArmingSequence(3, 2.5, seldom_s=SELDOM_S)
    assert [k for k in range(400) if commands(stranger, view(), k / 10)] == list(range(0, 400, 10))
    times, told = [], []
    for k in range(2000):
        if commands(ours, view(), k / 10):
            times.append(k // 10)
            told.append(not ours.repeats("Arming refused: battery low"))
    assert times == [0, 1, 3, 7, 15, 31, 63, 95, 127, 159, 191]
    assert told == [True] + [False] * 10
    assert ours.asks_again.endswith("up to 32 s")
    assert not ours.repeats("Arming refused: GPS failed")


def test_one_whose_battery_has_been_charged_is_asked_at_once() -> None:
    arming, counts = ArmingSequence(3, 2.5, seldom_s=SELDOM_S), view(energy_source="energy_consumed")
    asked(arming, counts, 0.0, 1000)
    # 1 % of 10 kJ, and that again; the last time it was asked was at 95 s
    play(
        arming,
        (100.0, counts._replace(received_j=99), [], None),
        (100.1, counts._replace(received_j=100), [ARM], None),
        (110.0, counts._replace(received_j=150), [], None),
        (110.1, counts._replace(received_j=200), [ARM], None),
    )


def test_one_that_was_armed_meanwhile_begins_anew() -> None:
    arming = ArmingSequence(3, 2.5, seldom_s=SELDOM_S)
    asked(arming, view(), 0.0, 1000)
    assert arming.repeats("no") is False
    commands(arming, ARMED, 100.0)
    play(arming, (100.1, view(), [ARM], Stage.ARM), (101.1, view(), [ARM], Stage.ARM))
    assert arming.repeats("no") is False


def test_a_take_off_that_stops_too_low_is_asked_for_again() -> None:
    arming = ArmingSequence(3, 2.5)
    for k, seen in enumerate((view(), ARMED, CLIMBING)):
        arming.decide(seen, 0.1 * k)
    play(arming, (3.0, CLIMBING._replace(mode=FlightMode.HOLD), [TAKEOFF], None))


@pytest.mark.parametrize("mode", [FlightMode.HOLD, FlightMode.RETURN, FlightMode.OTHER, FlightMode.TAKEOFF])
def test_from_any_other_mode_it_is_brought_back(mode: FlightMode) -> None:
    arming, other = brought_up(), FLYING._replace(mode=mode)
    play(arming, (10.0, other, [], Stage.OFFBOARD))
    assert arming.sends_set_points
    play(arming, (10.2, other, [SET_MODE], None), (10.3, FLYING, [], Stage.FLY))


def test_refuelling_is_flying_and_so_is_a_start_in_the_air() -> None:
    play(brought_up(), (10.0, FLYING._replace(mode=FlightMode.REFUEL), [], Stage.FLY))
    play(ArmingSequence(3, 2.5), (0.0, FLYING, [], Stage.FLY))


@pytest.mark.parametrize("end", [{"mode": FlightMode.LAND}, {"armed": False}, {"alive": False}])
def test_one_that_lands_disarms_or_dies_is_down_for_good(end: dict[str, Any]) -> None:
    arming, ordered = brought_up(), brought_up()
    play(arming, (10.0, FLYING._replace(**end), [], Stage.DOWN))
    assert not arming.sends_set_points
    play(arming, (20.0, FLYING, [], Stage.DOWN))
    ordered.order("hold")
    play(ordered, (10.0, FLYING._replace(alive=False), [], Stage.DOWN))


def test_battery_parameters_are_read_until_told() -> None:
    arming, untold = ArmingSequence(3, 2.5), FLYING._replace(battery_reported=False)
    assert arming.decide(view(battery_reported=False, last_received_s=-math.inf), 0.0) == ([], [])
    _, requests = arming.decide(untold, 0.1)
    read = [codec.fields(codec.split(codec.frame(request, 0, 255, 190)).frames[0]) for request in requests]
    assert [(r.target_system, r.target_component, r.param_index, r.param_id) for r in read] == [
        (3, mav.MAV_COMP_ID_AUTOPILOT1, -1, "SIM_BAT_CAP_J"),
        (3, mav.MAV_COMP_ID_AUTOPILOT1, -1, "SIM_BAT_INIT_J"),
    ]
    assert arming.decide(untold, 1.0) == ([], [])
    assert len(arming.decide(untold, 1.1)[1]) == 2
    assert arming.decide(FLYING, 2.1) == ([], [])


@pytest.mark.parametrize(
    ("order", "profile", "command", "params"),
    [
        ("hold", PX4, SET_MODE, (1.0, 4.0, 3.0)),
        ("hold", ARDUCOPTER, SET_MODE, (1.0, 17.0, 0.0)),
        ("return", PX4, 20, ()),
        ("land", ARDUCOPTER, LAND, ()),
    ],
)
def test_one_that_is_taken_is_told_so_once_and_left_alone(order: Any, profile: Any, command: int, params: Any) -> None:
    arming, seen = brought_up(), FLYING._replace(profile=profile)
    arming.order(order)
    (told,) = commands(arming, seen, 10.0)
    assert (told.command, told.params[: len(params)], told.token) == (command, params, f"operator {order}")
    assert (arming.stage, arming.sends_set_points, arming.down) == (Stage.TAKEN, False, False)
    for k, mode in enumerate((FlightMode.OFFBOARD, FlightMode.HOLD, FlightMode.LAND)):
        play(arming, (20.0 + k, seen._replace(mode=mode), [], Stage.TAKEN))


def test_while_it_is_bound_an_order_waits_and_another_order_replaces_the_one_before() -> None:
    arming = brought_up()
    arming.order("hold")
    assert arming.decide(FLYING, 10.0, bound=True) == ([], [])
    assert arming.sends_set_points
    play(arming, (10.1, FLYING, [SET_MODE], None))
    arming.order("land")
    assert [wish.token for wish in commands(arming, FLYING, 11.0)] == ["operator land"]


def test_one_with_its_motors_off_stays_there_without_a_word() -> None:
    arming = ArmingSequence(3, 2.5)
    arming.order("hold")
    play(arming, (0.1, view(), [], None), (5.0, view(), [], Stage.TAKEN))


def test_one_that_rejoins_in_the_air_gets_set_points_and_no_take_off() -> None:
    arming = brought_up()
    arming.order("hold")
    commands(arming, FLYING, 10.0)
    arming.rejoin()
    assert arming.ordered is None
    assert asked(arming, UP, 20.0, 10) == [SET_MODE]
    play(arming, (21.0, FLYING, [], Stage.FLY))


def test_one_that_rejoins_while_it_lands_is_caught_and_one_that_is_low_climbs() -> None:
    arming = brought_up()
    arming.order("land")
    commands(arming, FLYING, 10.0)
    arming.rejoin()
    assert asked(arming, LANDING, 11.0, 4) == [SET_MODE]
    assert arming.stage is Stage.OFFBOARD
    arming.rejoin()
    play(arming, (12.0, LANDING._replace(p_ned=(0.0, 0.0, -0.5)), [TAKEOFF], None))


@pytest.mark.parametrize("by", ["order", "failsafe"])
def test_one_that_has_landed_takes_off_again_when_it_rejoins(by: str) -> None:
    arming = brought_up()
    if by == "order":
        arming.order("land")
    play(arming, (10.0, LANDED, [], Stage.TAKEN if by == "order" else Stage.DOWN))
    arming.rejoin()
    play(arming, (20.0, LANDED, [ARM], None), (21.0, ARMED, [TAKEOFF], None), (22.0, CLIMBING, [], None))
    assert asked(arming, UP, 23.0, 5) == [SET_MODE]
    play(arming, (25.0, FLYING, [], Stage.FLY), (26.0, FLYING._replace(mode=FlightMode.LAND), [], Stage.DOWN))


def test_a_vehicle_that_is_to_be_grounded_lands_waits_and_comes_back_up() -> None:
    arming = brought_up()
    arming.grounded = True
    play(arming, (10.0, FLYING, [LAND], Stage.BASE))
    assert arming.sends_set_points  # until it takes the command, or it would fly its failsafe
    play(arming, (10.1, LANDING, [], None))
    assert not arming.sends_set_points
    assert asked(arming, LANDED, 14.0, 1000) == []
    assert (arming.stage, arming.down) == (Stage.BASE, False)
    arming.grounded = False
    (arm,) = commands(arming, LANDED, 200.0)
    assert (arm.command, arm.params[0], arming.stage) == (ARM, 1.0, Stage.ARM)
    play(arming, (200.1, ARMED, [TAKEOFF], None), (201.0, CLIMBING, [], None), (202.0, UP, [], None))
    play(arming, (203.0, FLYING, [], Stage.FLY))


def test_landing_at_a_base_is_asked_for_until_it_is_flown_and_one_that_does_not_disarm_is_disarmed() -> None:
    arming = brought_up()
    arming.grounded = True
    assert asked(arming, FLYING, 10.0, 31) == [LAND] * 4
    play(arming, (14.0, UP, [LAND], None))
    landed = ARMED._replace(mode=FlightMode.LAND)
    disarms = [(k, wish) for k in range(80) for wish in commands(arming, landed, 14.1 + 0.1 * k)]
    assert [(wish.command, wish.params[0]) for _, wish in disarms] == [(ARM, 0.0)] * 2
    assert disarms[0][0] >= 29


@pytest.mark.parametrize(
    ("itself", "charge_j", "stage"), [(True, 5e3, Stage.ARM), (True, 1.9e3, Stage.DOWN), (False, 5e3, Stage.DOWN)]
)
def test_a_vehicle_whose_link_was_out_rejoins_by_itself_where_its_battery_allows(
    itself: bool, charge_j: float, stage: Stage
) -> None:
    """Flown by its failsafe while 30 s of its link were out, and landed when it is received again."""
    pilot = brought_up(rejoins_itself=itself)
    for k in range(30):
        pilot.decide(FLYING._replace(age_s=float(k)), 1.0 + k)
    play(pilot, (31.0, FLYING, [], Stage.FLY))  # the first position comes before the first HEARTBEAT
    pilot.decide(view(drawn_j=1e4 - charge_j), 31.4)
    assert pilot.stage is stage


def test_it_is_asked_back_from_the_middle_of_its_landing_and_a_landing_much_later_is_no_outage() -> None:
    pilot = brought_up(rejoins_itself=True)
    pilot.decide(FLYING._replace(age_s=2.5), 0.5)
    play(pilot, (2.0, LANDING, [], None), (2.2, LANDING, [SET_MODE], Stage.OFFBOARD))  # set points come first
    assert pilot.rejoining
    play(pilot, (2.5, FLYING, [], Stage.FLY))
    assert not pilot.rejoining
    play(pilot, (6.0, LANDING, [], Stage.DOWN))
