"""A stranger's vehicle into the air, as snapshots tell it: what is asked, when, and when nothing is."""

import math
from typing import Any

import pytest
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.mavlink.autopilots import ARDUCOPTER, PX4, FlightMode, Profile
from gcs.scenario.external import External
from gcs.supervisor.arming import Stage
from gcs.supervisor.arming_external import BLAMED_S, FAR_M, LATE_S, PARAMETER_TRIES, STALE_S, ExternalArmingSequence
from gcs.telemetry.state import VehicleView

ARM, TAKEOFF, SET_MODE = mav.MAV_CMD_COMPONENT_ARM_DISARM, mav.MAV_CMD_NAV_TAKEOFF, mav.MAV_CMD_DO_SET_MODE


def view(**changed: Any) -> VehicleView:
    ground = VehicleView(
        sysid=3, role="pursuer", label="pursuer 3", alive=True, profile=PX4, mode=FlightMode.HOLD, armed=False,
        landed=True, last_received_s=0.0, p_ned=(10.0, 0.0, -2.0), v_ned=(0.0, 0.0, 0.0), age_s=0.0, heading_rad=0.0,
        origin_offset_ned=(10.0, 0.0, -2.0), ground_amsl_m=490.0, ground_down_m=-2.0, capacity_j=1e4, initial_j=1e4,
        battery_reported=True, drawn_j=0.0, received_j=0, given_j=0, given_reported_s=0.0, power_w=0.0,
        energy_source="none",
        control_effort=0.0,
    )  # fmt: skip
    return ground._replace(**changed)


ARMED = view(armed=True)
UP = view(armed=True, landed=False, p_ned=(10.0, 0.0, -4.2))
FLYING = UP._replace(mode=FlightMode.OFFBOARD)


def arming(**rules: Any) -> ExternalArmingSequence:
    block = External(connect="udpin:127.0.0.1:14550", capacity_j=1e4, **{"arm_within_s": 20.0, **rules})
    return ExternalArmingSequence(3, 2.5, block)


def told(made: ExternalArmingSequence, seen: VehicleView, now_s: float) -> list[int]:
    return [wish.command for wish in made.decide(seen, now_s)[0]]


def flying() -> ExternalArmingSequence:
    made = arming()
    for k, seen in enumerate((view(), ARMED, UP, FLYING)):
        made.decide(seen, float(k))
    assert made.stage is Stage.FLY
    return made


def test_px4_is_armed_in_hold_takes_off_to_a_height_above_the_sea_and_hears_set_points_first() -> None:
    made = arming()
    assert told(made, view(mode=FlightMode.MANUAL), 0.0) == [SET_MODE]
    assert told(made, view(), 1.0) == [ARM]
    (takeoff,) = made.decide(ARMED, 2.0)[0]
    assert (takeoff.command, takeoff.params[6]) == (TAKEOFF, 492.5)
    assert told(made, UP, 5.0) == []
    assert made.sends_set_points
    assert told(made, UP, 5.9) == []
    (offboard,) = made.decide(UP, 6.0)[0]
    assert (offboard.command, offboard.params[:3]) == (SET_MODE, (1.0, 6.0, 0.0))
    assert told(made, FLYING, 7.0) == []
    assert made.stage is Stage.FLY


def test_arducopter_goes_to_guided_first_and_takes_off_to_a_height_above_the_ground_once() -> None:
    made = arming()
    stabilize = view(profile=ARDUCOPTER, mode=FlightMode.MANUAL)
    guided = stabilize._replace(mode=FlightMode.OFFBOARD)
    (mode,) = made.decide(stabilize, 0.0)[0]
    assert (mode.command, mode.params[:2]) == (SET_MODE, (1.0, 4.0))
    assert told(made, guided, 1.0) == [ARM]
    (takeoff,) = made.decide(guided._replace(armed=True), 2.0)[0]
    assert (takeoff.command, takeoff.params[3:]) == (TAKEOFF, (0.0, 0.0, 0.0, 2.5))
    climbing = guided._replace(armed=True, landed=False, p_ned=(10.0, 0.0, -3.0))
    assert told(made, climbing, 4.0) == []
    told(made, climbing._replace(p_ned=(10.0, 0.0, -4.3)), 6.0)
    told(made, climbing._replace(p_ned=(10.0, 0.0, -4.3)), 6.1)
    assert made.stage is Stage.FLY


def test_a_take_off_that_was_accepted_has_time_to_leave_the_ground() -> None:
    """ArduCopter 4.6 says 3 s after it was armed that it is in the air, and refuses to take off from there."""
    made = arming()
    guided = view(profile=ARDUCOPTER, mode=FlightMode.OFFBOARD)
    told(made, guided, 0.0)
    asked = [told(made, guided._replace(armed=True), 1.0 + 0.1 * k) for k in range(70)]
    assert [k for k, commands in enumerate(asked) if commands] == [0, 40]
    assert asked[40] == [TAKEOFF]


def test_one_that_is_handed_back_on_the_ground_is_taken_off_again() -> None:
    """ArduCopter in GUIDED stays on the ground, armed, whatever set points say; it has all its time to do so."""
    made = flying()
    landed = FLYING._replace(profile=ARDUCOPTER, landed=True, p_ned=(10.0, 0.0, -2.0))
    told(made, landed._replace(mode=FlightMode.MANUAL), 30.0)
    assert made.stage is Stage.YIELDED
    asked = [told(made, landed, 40.0 + 0.1 * k) for k in range(12)]
    assert [commands for commands in asked if commands] == [[TAKEOFF]]
    assert made.stage is Stage.TAKEOFF
    for k in range(3):
        told(made, landed._replace(landed=False, p_ned=(10.0, 0.0, -4.4)), 44.0 + k)
    assert (made.stage, made.left_out) == (Stage.FLY, "")


def test_arming_is_asked_for_again_until_the_time_is_up_and_then_left() -> None:
    made = arming()
    asked = [told(made, view(), 0.5 * k) for k in range(40)]
    assert asked[::2] == [[ARM]] * 20
    assert not made.left_out
    assert told(made, view(), 20.5) == []
    assert made.stage is Stage.DOWN
    assert made.left_out == "Has not let itself be armed within 20 s: left out"


@pytest.mark.parametrize(
    ("missing", "why"),
    [
        ({"origin_offset_ned": None, "p_ned": None}, "Has not reported its frame's origin within 20 s: left out"),
        ({"p_ned": None}, "Has not reported its position within 20 s: left out"),
    ],
)
def test_nothing_is_asked_of_a_vehicle_whose_place_is_unknown(missing: dict[str, None], why: str) -> None:
    made = arming()
    assert [told(made, view(**missing), float(k)) for k in range(21)] == [[]] * 21
    assert (made.stage, made.sends_set_points) == (Stage.IDENTIFY, False)
    made.decide(view(**missing), 21.0)
    assert (made.stage, made.left_out) == (Stage.DOWN, why)


def test_an_origin_beyond_what_parallel_frames_allow_is_refused_at_once() -> None:
    made = arming()
    made.decide(view(origin_offset_ned=(0.0, FAR_M + 1.0, 0.0)), 0.0)
    assert (made.stage, made.left_out) == (
        Stage.DOWN, "Its origin is over 100 km from the scenario's: is one of them wrong? Left out",
    )  # fmt: skip


def test_one_that_was_armed_and_never_left_the_ground_is_disarmed_when_it_is_left_out() -> None:
    made = arming()
    made.decide(ARMED, 0.0)
    (disarm,) = made.decide(ARMED, 21.0)[0]
    assert (disarm.command, disarm.params[0]) == (ARM, 0.0)
    assert made.left_out == "Has not taken off within 20 s: left out"


@pytest.mark.parametrize(
    "mode", [FlightMode.MANUAL, FlightMode.RETURN, FlightMode.LAND, FlightMode.TAKEOFF, FlightMode.OTHER]
)
def test_one_that_somebody_else_takes_is_his_until_he_puts_it_back_into_offboard(mode: FlightMode) -> None:
    made = flying()
    assert [told(made, FLYING._replace(mode=mode), 10.0 + k) for k in range(5)] == [[]] * 5
    assert (made.stage, made.sends_set_points) == (Stage.YIELDED, True)
    assert told(made, FLYING._replace(mode=FlightMode.HOLD), 15.0) == []
    assert made.stage is Stage.YIELDED
    made.decide(FLYING, 16.0)
    assert made.stage is Stage.FLY


def test_a_heartbeat_that_is_older_than_the_take_off_is_no_takeover() -> None:
    """EXTENDED_SYS_STATE may tell of the air before HEARTBEAT, once a second, tells of the mode."""
    made = arming()
    told(made, view(mode=FlightMode.OTHER), 0.0)
    told(made, ARMED._replace(mode=FlightMode.OTHER), 1.0)
    assert told(made, ARMED._replace(mode=FlightMode.OTHER, landed=False), 1.5) == []
    assert made.stage is Stage.TAKEOFF
    told(made, UP._replace(mode=FlightMode.OTHER), 3.0)
    assert told(made, UP._replace(mode=FlightMode.OTHER), 4.0) == [SET_MODE]


def test_one_that_is_taken_while_it_climbs_is_let_go() -> None:
    made = arming()
    for k, seen in enumerate((view(), ARMED, UP._replace(mode=FlightMode.MANUAL))):
        made.decide(seen, float(k))
    assert made.stage is Stage.YIELDED


def test_a_take_off_is_over_when_the_autopilot_holds_after_it_however_high_it_says_it_is() -> None:
    """A PX4 1.17 moved its home up by a metre while it climbed from it, and ended its take-off at 1.4 m of 2.5 m."""
    made = arming()
    low = UP._replace(p_ned=(10.0, 0.0, -3.4))
    for k, seen in enumerate((view(), ARMED, low, low._replace(mode=FlightMode.TAKEOFF))):
        made.decide(seen, float(k))
        assert made.stage is not Stage.OFFBOARD
    made.decide(low, 4.0)
    assert made.stage is Stage.OFFBOARD


HELD = FLYING._replace(mode=FlightMode.HOLD)


def steered(made: ExternalArmingSequence, from_s: float, until_s: float, seen: VehicleView = FLYING) -> list[int]:
    """Ten ticks a second of the same; what is asked in them."""
    ticks = range(round(10 * from_s), round(10 * until_s))
    return [command for k in ticks for command in told(made, seen, k / 10.0)]


def test_our_operator_may_ask_for_one_back_that_somebody_else_took() -> None:
    made = flying()
    steered(made, 3.1, 10.0)
    assert steered(made, 10.0, 12.0, HELD) == []
    made.rejoin()
    assert SET_MODE in steered(made, 12.0, 16.0, HELD)
    made.decide(FLYING, 16.0)
    assert made.stage is Stage.FLY


@pytest.mark.parametrize("profile", [PX4, ARDUCOPTER])
def test_a_hold_while_set_points_reach_it_is_somebody_elses_wish_until_he_gives_it_back(profile: Profile) -> None:
    made = flying()
    steered(made, 3.1, 10.0, FLYING._replace(profile=profile))
    assert steered(made, 10.0, 30.0, HELD._replace(profile=profile)) == []
    assert (made.stage, made.sends_set_points) == (Stage.YIELDED, True)
    made.decide(FLYING._replace(profile=profile), 30.0)
    assert made.stage is Stage.FLY


def test_after_a_hold_because_the_session_stood_still_offboard_is_asked_for_again() -> None:
    made = flying()
    steered(made, 3.1, 10.0)
    assert steered(made, 10.0 + 2 * LATE_S, 11.0 + 2 * LATE_S) == []  # a HEARTBEAT may take a second
    assert steered(made, 12.0, 13.5, HELD) == [SET_MODE]
    made.decide(FLYING, 13.5)
    assert made.stage is Stage.FLY


def test_after_a_hold_because_the_link_was_quiet_offboard_is_asked_for_again() -> None:
    made = flying()
    steered(made, 3.1, 10.0)
    steered(made, 10.0, 11.0, FLYING._replace(age_s=2 * STALE_S))
    assert steered(made, 11.0, 12.5, HELD) == [SET_MODE]


def test_a_hold_that_a_late_tick_reads_at_once_is_our_doing_too() -> None:
    """What came while the session stood still is heard at its next tick, whose time is that of the one before."""
    made = flying()
    steered(made, 3.1, 10.0)
    made.decide(HELD, 10.0, late_s=2.0)
    assert made.stage is Stage.OFFBOARD
    assert steered(made, 12.0, 12.9, HELD) == [SET_MODE]


@pytest.mark.parametrize("late_s", [0.0, 2.0])
def test_a_return_is_left_alone_also_where_set_points_may_have_failed_to_reach_it(late_s: float) -> None:
    """A PX4 by its defaults returns without set points, and is in offboard again when they flow."""
    made = flying()
    steered(made, 3.1, 10.0)
    returns = FLYING._replace(mode=FlightMode.RETURN)
    made.decide(returns, 10.0, late_s=late_s)
    assert steered(made, 12.0, 14.0, returns) == []
    assert (made.stage, made.sends_set_points) == (Stage.YIELDED, True)
    made.decide(FLYING, 14.0)
    assert made.stage is Stage.FLY


def test_a_hold_long_after_the_session_stood_still_is_not_put_down_to_that() -> None:
    made = flying()
    steered(made, 3.1, 10.0)
    steered(made, 11.0, 11.5 + BLAMED_S)
    assert steered(made, 11.5 + BLAMED_S, 20.0, HELD) == []
    assert made.stage is Stage.YIELDED


def test_a_hold_that_comes_with_its_first_words_after_silence_is_our_doing() -> None:
    made = flying()
    steered(made, 3.1, 10.0)
    steered(made, 10.0, 25.0, FLYING._replace(alive=False))
    assert steered(made, 25.0, 26.5, HELD) == [SET_MODE]


def test_a_silent_vehicle_is_told_nothing_and_goes_on_when_it_is_heard() -> None:
    made = flying()
    assert told(made, FLYING._replace(alive=False), 10.0) == []
    assert (made.stage, made.sends_set_points) == (Stage.FLY, False)
    made.decide(FLYING, 30.0)
    assert (made.stage, made.sends_set_points) == (Stage.FLY, True)


def test_one_that_lands_and_disarms_takes_no_more_part() -> None:
    made = flying()
    made.decide(FLYING._replace(mode=FlightMode.LAND), 10.0)
    made.decide(view(mode=FlightMode.LAND), 20.0)
    assert (made.stage, made.left_out) == (Stage.DOWN, "")


@pytest.mark.parametrize(
    ("mode", "stage"),
    [
        (FlightMode.OFFBOARD, Stage.FLY), (FlightMode.HOLD, Stage.OFFBOARD), (FlightMode.MANUAL, Stage.YIELDED),
    ],
)  # fmt: skip
def test_one_that_flies_already_is_taken_as_it_is(mode: FlightMode, stage: Stage) -> None:
    made = arming()
    made.decide(UP._replace(mode=mode), 0.0)
    assert made.stage is stage


@pytest.mark.parametrize("profile", [PX4, ARDUCOPTER])
def test_a_stranger_that_knows_no_parameter_of_ours_is_not_asked_for_ever(profile: Profile) -> None:
    made = arming()
    unknown = view(profile=profile, battery_reported=False)
    requests = [made.decide(unknown, float(k))[1] for k in range(10)]
    assert [len(asked) for asked in requests] == [2] * PARAMETER_TRIES + [0] * (10 - PARAMETER_TRIES)
    assert math.isfinite(unknown.capacity_j)


def test_at_a_base_it_lands_and_has_its_whole_time_again_to_be_armed() -> None:
    made = flying()
    made.grounded = True
    assert told(made, FLYING, 100.0) == [mav.MAV_CMD_NAV_LAND]
    assert (made.stage, made.sends_set_points) == (Stage.BASE, True)
    made.decide(FLYING._replace(mode=FlightMode.LAND), 101.0)
    assert not made.sends_set_points
    for k in range(60):
        assert told(made, view(mode=FlightMode.LAND), 110.0 + k) == []
    made.grounded = False
    assert told(made, view(mode=FlightMode.LAND), 200.0) == [SET_MODE]
    assert told(made, view(), 210.0) == [ARM]
    assert told(made, ARMED, 211.0) == [TAKEOFF]
    made.decide(UP, 215.0)
    assert made.stage is Stage.OFFBOARD


def test_one_that_someone_holds_is_not_landed_at_a_base() -> None:
    made = flying()
    made.decide(FLYING._replace(mode=FlightMode.MANUAL), 10.0)
    made.grounded = True
    assert told(made, FLYING._replace(mode=FlightMode.MANUAL), 11.0) == []
    assert made.stage is Stage.YIELDED


def silent(made: ExternalArmingSequence, since_s: float, until_s: float) -> None:
    """Not heard: at first its place grows old, then it counts as lost."""
    for k in range(int(since_s), int(until_s)):
        age_s = k - since_s
        made.decide(FLYING._replace(age_s=age_s, alive=age_s < 10.0), float(k))


@pytest.mark.parametrize("mode", [FlightMode.RETURN, FlightMode.LAND])
def test_what_its_failsafe_did_while_it_was_not_heard_is_left_alone_unless_the_scenario_says_rejoins(
    mode: FlightMode,
) -> None:
    made = flying()
    silent(made, 5.0, 20.0)
    assert told(made, UP._replace(mode=mode), 21.0) == []
    assert made.stage is Stage.YIELDED
    assert made.unheard_lately(21.0)
    again = arming(rejoins=True)
    for k, seen in enumerate((view(), ARMED, UP, FLYING)):
        again.decide(seen, float(k))
    silent(again, 5.0, 20.0)
    again.decide(UP._replace(mode=mode), 21.0)
    assert again.stage is Stage.OFFBOARD
    assert told(again, UP._replace(mode=mode), 22.1) == [SET_MODE]
    again.decide(FLYING, 23.0)
    assert again.stage is Stage.FLY
    assert told(again, UP._replace(mode=mode), 60.0) == []  # now it is somebody's wish
    assert again.stage is Stage.YIELDED


def test_one_that_has_booted_or_landed_meanwhile_is_armed_again_where_the_scenario_says_rejoins() -> None:
    for rejoins, stage in ((False, Stage.DOWN), (True, Stage.ARM)):
        made = arming(rejoins=rejoins)
        for k, seen in enumerate((view(), ARMED, UP, FLYING)):
            made.decide(seen, float(k))
        silent(made, 5.0, 20.0)
        made.decide(view(), 21.0)
        assert made.stage is stage


@pytest.mark.parametrize("rejoins", [False, True])
@pytest.mark.parametrize("late", [False, True])
def test_one_that_landed_without_its_gps_flies_again_with_it_where_the_scenario_says_rejoins(
    late: bool, rejoins: bool
) -> None:
    made = arming(rejoins=rejoins)
    for k, seen in enumerate((view(), ARMED, UP, FLYING)):
        made.decide(seen, float(k))
    landing = UP._replace(mode=FlightMode.LAND)
    made.decide(FLYING if late else landing, 5.0)
    made.mend(FLYING if late else landing)
    assert told(made, landing, 6.0) == []
    assert made.stage is (Stage.OFFBOARD if rejoins else Stage.YIELDED)
    assert told(made, landing, 7.1) == ([SET_MODE] if rejoins else [])
    assert told(made, FLYING, 8.2) == []
    assert made.stage is Stage.FLY


def test_one_that_still_lands_by_an_earlier_sessions_order_is_waited_for_and_armed() -> None:
    made = arming()
    coming = UP._replace(mode=FlightMode.LAND)
    for k in range(40):  # longer than arm_within_s
        assert told(made, coming, float(k)) == []
    assert made.stage is Stage.IDENTIFY
    assert not made.sends_set_points
    assert told(made, view(), 41.0) == [ARM]


ON_MISSION = UP._replace(mode=FlightMode.MISSION)
HELD = UP._replace(mode=FlightMode.HOLD)


def on_mission(profile: Profile = PX4) -> ExternalArmingSequence:
    made = flying()
    made.go_on_mission("fly")
    wishes = made.decide(FLYING._replace(profile=profile), 3.1)[0]
    assert [(wish.command, wish.params[:3]) for wish in wishes] == [MISSION[profile.name]]
    assert made.sends_set_points  # until its mode says that it flies the mission
    made.decide(ON_MISSION._replace(profile=profile), 3.5)
    assert made.stage is Stage.MISSION
    assert not made.sends_set_points
    return made


MISSION = {"px4": (SET_MODE, (1.0, 4.0, 4.0)), "ardupilot": (mav.MAV_CMD_MISSION_START, (0.0, 0.0))}
HOLD = {"px4": (1.0, 4.0, 3.0), "ardupilot": (1.0, 17.0, 0.0)}


@pytest.mark.parametrize("profile", [PX4, ARDUCOPTER])
def test_a_mission_is_begun_held_and_gone_on_with_by_the_autopilots_own_commands(profile: Profile) -> None:
    made = on_mission(profile)
    made.go_on_mission("hold")
    (wish,) = made.decide(ON_MISSION._replace(profile=profile), 4.0)[0]
    assert (wish.command, wish.params[:3]) == (SET_MODE, HOLD[profile.name])
    assert told(made, HELD._replace(profile=profile), 4.5) == []
    made.go_on_mission("fly")
    (wish,) = made.decide(HELD._replace(profile=profile), 5.0)[0]
    assert (wish.command, wish.params[:3]) == MISSION[profile.name]
    assert made.stage is Stage.MISSION


def test_one_that_is_to_step_aside_is_brought_back_to_set_points() -> None:
    made = on_mission()
    made.go_on_mission("hold")
    made.decide(HELD, 4.0)
    made.go_on_mission("")
    made.decide(HELD, 5.0)
    assert made.stage is Stage.OFFBOARD
    assert made.sends_set_points
    assert told(made, HELD, 6.1) == [SET_MODE]
    made.decide(FLYING, 7.0)
    assert made.stage is Stage.FLY


@pytest.mark.parametrize("mode", [FlightMode.HOLD, FlightMode.MANUAL, FlightMode.RETURN])
def test_a_pilot_who_takes_it_from_its_mission_has_it(mode: FlightMode) -> None:
    made = on_mission()
    for k in range(5):  # no late tick may be the reason
        made.decide(ON_MISSION, 4.0 + 0.2 * k)
    for k in range(20):
        made.decide(ON_MISSION, 5.0 + 0.2 * k)
    assert told(made, UP._replace(mode=mode), 9.0) == []
    assert made.stage is Stage.YIELDED
    made.decide(ON_MISSION, 10.0)
    assert made.stage is Stage.MISSION
