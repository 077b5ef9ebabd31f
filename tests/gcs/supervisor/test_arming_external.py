"""A stranger's vehicle into the air, as snapshots tell it: what is asked, when, and when nothing is."""

from typing import Any

import pytest
import views as base
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.mavlink.autopilots import ARDUCOPTER, PX4, FlightMode, Profile
from gcs.scenario.external import External
from gcs.supervisor.arming import Stage
from gcs.supervisor.arming_external import BLAMED_S, FAR_M, LATE_S, PARAMETER_TRIES, STALE_S, ExternalArmingSequence
from gcs.telemetry.state import VehicleView

ARM, TAKEOFF, SET_MODE = mav.MAV_CMD_COMPONENT_ARM_DISARM, mav.MAV_CMD_NAV_TAKEOFF, mav.MAV_CMD_DO_SET_MODE
Step = tuple[float, VehicleView, list[int], Stage | None]


def view(**changed: Any) -> VehicleView:
    """On the ground, 2 m above the scenario's origin and 10 m north of it."""
    ground: dict[str, Any] = {"mode": FlightMode.HOLD, "armed": False, "landed": True, "p_ned": (10.0, 0.0, -2.0)}
    ground |= {"origin_offset_ned": (10.0, 0.0, -2.0), "ground_amsl_m": 490.0, "ground_down_m": -2.0, "drawn_j": 0.0}
    return base.view(3, **(ground | {"energy_source": "none"} | changed))


ARMED = view(armed=True)
UP = view(armed=True, landed=False, p_ned=(10.0, 0.0, -4.2))
FLYING = UP._replace(mode=FlightMode.OFFBOARD)
ON_MISSION = UP._replace(mode=FlightMode.MISSION)
LANDING, LANDED = UP._replace(mode=FlightMode.LAND), view(mode=FlightMode.LAND)


def arming(**rules: Any) -> ExternalArmingSequence:
    block = External(connect="udpin:127.0.0.1:14550", capacity_j=1e4, **{"arm_within_s": 20.0, **rules})
    return ExternalArmingSequence(3, 2.5, block)


def told(made: ExternalArmingSequence, seen: VehicleView, now_s: float) -> list[int]:
    return [wish.command for wish in made.decide(seen, now_s)[0]]


def play(made: ExternalArmingSequence, *steps: Step) -> None:
    """What is commanded at each time, and the stage after it where one is given."""
    for now_s, seen, wanted, stage in steps:
        assert told(made, seen, now_s) == wanted, now_s
        assert stage in (None, made.stage), now_s


def flying(**rules: Any) -> ExternalArmingSequence:
    made = arming(**rules)
    for k, seen in enumerate((view(), ARMED, UP, FLYING)):
        made.decide(seen, float(k))
    assert made.stage is Stage.FLY
    return made


def steered(made: ExternalArmingSequence, from_s: float, until_s: float, seen: VehicleView = FLYING) -> list[int]:
    """Ten ticks a second of the same; what is asked in them."""
    ticks = range(round(10 * from_s), round(10 * until_s))
    return [command for k in ticks for command in told(made, seen, k / 10.0)]


def flown(**rules: Any) -> ExternalArmingSequence:
    """In offboard for 7 s."""
    made = flying(**rules)
    steered(made, 3.1, 10.0)
    return made


def test_px4_is_armed_in_hold_takes_off_to_a_height_above_the_sea_and_hears_set_points_first() -> None:
    made = arming()
    play(made, (0.0, view(mode=FlightMode.MANUAL), [SET_MODE], None), (1.0, view(), [ARM], None))
    (takeoff,) = made.decide(ARMED, 2.0)[0]
    assert (takeoff.command, takeoff.params[6]) == (TAKEOFF, 492.5)
    play(made, (5.0, UP, [], None))
    assert made.sends_set_points
    play(made, (5.9, UP, [], None))
    (offboard,) = made.decide(UP, 6.0)[0]
    assert (offboard.command, offboard.params[:3]) == (SET_MODE, (1.0, 6.0, 0.0))
    play(made, (7.0, FLYING, [], Stage.FLY))


def test_arducopter_goes_to_guided_first_and_takes_off_to_a_height_above_the_ground_once() -> None:
    made = arming()
    stabilize = view(profile=ARDUCOPTER, mode=FlightMode.MANUAL)
    guided = stabilize._replace(mode=FlightMode.OFFBOARD)
    (mode,) = made.decide(stabilize, 0.0)[0]
    assert (mode.command, mode.params[:2]) == (SET_MODE, (1.0, 4.0))
    play(made, (1.0, guided, [ARM], None))
    (takeoff,) = made.decide(guided._replace(armed=True), 2.0)[0]
    assert (takeoff.command, takeoff.params[3:]) == (TAKEOFF, (0.0, 0.0, 0.0, 2.5))
    climbing = guided._replace(armed=True, landed=False, p_ned=(10.0, 0.0, -3.0))
    play(made, (4.0, climbing, [], None))
    for now_s in (6.0, 6.1):
        told(made, climbing._replace(p_ned=(10.0, 0.0, -4.3)), now_s)
    assert made.stage is Stage.FLY


def test_a_take_off_that_was_accepted_has_time_to_leave_the_ground() -> None:
    """ArduCopter 4.6 says 3 s after it was armed that it is in the air, and refuses to take off from there."""
    made = arming()
    guided = view(profile=ARDUCOPTER, mode=FlightMode.OFFBOARD)
    told(made, guided, 0.0)
    asked = [told(made, guided._replace(armed=True), 1.0 + 0.1 * k) for k in range(70)]
    assert [(k, commands) for k, commands in enumerate(asked) if commands] == [(0, [TAKEOFF]), (40, [TAKEOFF])]


def test_one_that_is_handed_back_on_the_ground_is_taken_off_again() -> None:
    """ArduCopter in GUIDED stays on the ground, armed, whatever set points say; it has all its time to do so."""
    made = flying()
    landed = FLYING._replace(profile=ARDUCOPTER, landed=True, p_ned=(10.0, 0.0, -2.0))
    told(made, landed._replace(mode=FlightMode.MANUAL), 30.0)
    assert made.stage is Stage.YIELDED
    assert steered(made, 40.0, 41.2, landed) == [TAKEOFF]
    assert made.stage is Stage.TAKEOFF
    for k in range(3):
        told(made, landed._replace(landed=False, p_ned=(10.0, 0.0, -4.4)), 44.0 + k)
    assert (made.stage, made.left_out) == (Stage.FLY, "")


def test_arming_is_asked_for_again_until_the_time_is_up_and_then_left() -> None:
    made = arming()
    asked = [told(made, view(), 0.5 * k) for k in range(40)]
    assert asked[::2] == [[ARM]] * 20
    assert not made.left_out
    play(made, (20.5, view(), [], Stage.DOWN))
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
    play(made, (0.0, view(origin_offset_ned=(0.0, FAR_M + 1.0, 0.0)), [], Stage.DOWN))
    assert made.left_out == "Its origin is over 100 km from the scenario's: is one of them wrong? Left out"


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
    play(made, (15.0, UP, [], Stage.YIELDED), (16.0, FLYING, [], Stage.FLY))


def test_a_heartbeat_that_is_older_than_the_take_off_is_no_takeover() -> None:
    """EXTENDED_SYS_STATE may tell of the air before HEARTBEAT, once a second, tells of the mode."""
    made = arming()
    other = ARMED._replace(mode=FlightMode.OTHER)
    told(made, view(mode=FlightMode.OTHER), 0.0)
    told(made, other, 1.0)
    play(made, (1.5, other._replace(landed=False), [], Stage.TAKEOFF))
    told(made, UP._replace(mode=FlightMode.OTHER), 3.0)
    play(made, (4.0, UP._replace(mode=FlightMode.OTHER), [SET_MODE], None))


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


@pytest.mark.parametrize("profile", [PX4, ARDUCOPTER])
def test_a_hold_while_set_points_reach_it_is_somebody_elses_wish_until_he_gives_it_back(profile: Profile) -> None:
    made = flying()
    steered(made, 3.1, 10.0, FLYING._replace(profile=profile))
    assert steered(made, 10.0, 30.0, UP._replace(profile=profile)) == []
    assert (made.stage, made.sends_set_points) == (Stage.YIELDED, True)
    play(made, (30.0, FLYING._replace(profile=profile), [], Stage.FLY))


def test_our_operator_may_ask_for_one_back_that_somebody_else_took() -> None:
    made = flown()
    assert steered(made, 10.0, 12.0, UP) == []
    made.rejoin()
    assert SET_MODE in steered(made, 12.0, 16.0, UP)
    play(made, (16.0, FLYING, [], Stage.FLY))


LATE_TICK = (10.0 + 2 * LATE_S, 11.0 + 2 * LATE_S, FLYING)  # a HEARTBEAT may take a second


@pytest.mark.parametrize(
    ("before", "held_s"),
    [
        (LATE_TICK, 12.0),
        ((10.0, 11.0, FLYING._replace(age_s=2 * STALE_S)), 11.0),
        ((10.0, 25.0, FLYING._replace(alive=False)), 25.0),
    ],
    ids=["the session stood still", "the link was quiet", "with its first words after silence"],
)
def test_after_a_hold_that_is_our_doing_offboard_is_asked_for_again(before: Any, held_s: float) -> None:
    made = flown()
    assert steered(made, *before) == []
    assert steered(made, held_s, held_s + 1.5, UP) == [SET_MODE]
    play(made, (held_s + 1.5, FLYING, [], Stage.FLY))


def test_a_hold_that_a_late_tick_reads_at_once_is_our_doing_too() -> None:
    """What came while the session stood still is heard at its next tick, whose time is that of the one before."""
    made = flown()
    made.decide(UP, 10.0, late_s=2.0)
    assert made.stage is Stage.OFFBOARD
    assert steered(made, 12.0, 12.9, UP) == [SET_MODE]


@pytest.mark.parametrize("late_s", [0.0, 2.0])
def test_a_return_is_left_alone_also_where_set_points_may_have_failed_to_reach_it(late_s: float) -> None:
    """A PX4 by its defaults returns without set points, and is in offboard again when they flow."""
    made = flown()
    returns = FLYING._replace(mode=FlightMode.RETURN)
    made.decide(returns, 10.0, late_s=late_s)
    assert steered(made, 12.0, 14.0, returns) == []
    assert (made.stage, made.sends_set_points) == (Stage.YIELDED, True)
    play(made, (14.0, FLYING, [], Stage.FLY))


def test_a_hold_long_after_the_session_stood_still_is_not_put_down_to_that() -> None:
    made = flown()
    steered(made, 11.0, 11.5 + BLAMED_S)
    assert steered(made, 11.5 + BLAMED_S, 20.0, UP) == []
    assert made.stage is Stage.YIELDED


def test_a_silent_vehicle_is_told_nothing_and_goes_on_when_it_is_heard() -> None:
    made = flying()
    play(made, (10.0, FLYING._replace(alive=False), [], Stage.FLY))
    assert not made.sends_set_points
    play(made, (30.0, FLYING, [], Stage.FLY))
    assert made.sends_set_points


def test_one_that_lands_and_disarms_takes_no_more_part() -> None:
    made = flying()
    play(made, (10.0, LANDING, [], None), (20.0, LANDED, [], Stage.DOWN))
    assert made.left_out == ""


@pytest.mark.parametrize(
    ("mode", "stage"),
    [(FlightMode.OFFBOARD, Stage.FLY), (FlightMode.HOLD, Stage.OFFBOARD), (FlightMode.MANUAL, Stage.YIELDED)],
)
def test_one_that_flies_already_is_taken_as_it_is(mode: FlightMode, stage: Stage) -> None:
    play(arming(), (0.0, UP._replace(mode=mode), [], stage))


@pytest.mark.parametrize("profile", [PX4, ARDUCOPTER])
def test_a_stranger_that_knows_no_parameter_of_ours_is_not_asked_for_ever(profile: Profile) -> None:
    made, unknown = arming(), view(profile=profile, battery_reported=False)
    requests = [made.decide(unknown, float(k))[1] for k in range(10)]
    assert [len(asked) for asked in requests] == [2] * PARAMETER_TRIES + [0] * (10 - PARAMETER_TRIES)


def test_at_a_base_it_lands_and_has_its_whole_time_again_to_be_armed() -> None:
    made = flying()
    made.grounded = True
    play(made, (100.0, FLYING, [mav.MAV_CMD_NAV_LAND], Stage.BASE))
    assert made.sends_set_points
    made.decide(LANDING, 101.0)
    assert not made.sends_set_points
    for k in range(60):
        play(made, (110.0 + k, LANDED, [], Stage.BASE))
    made.grounded = False
    play(made, (200.0, LANDED, [SET_MODE], None), (210.0, view(), [ARM], None), (211.0, ARMED, [TAKEOFF], None))
    play(made, (215.0, UP, [], Stage.OFFBOARD))


def test_one_that_someone_holds_is_not_landed_at_a_base() -> None:
    made, held = flying(), FLYING._replace(mode=FlightMode.MANUAL)
    made.decide(held, 10.0)
    made.grounded = True
    play(made, (11.0, held, [], Stage.YIELDED))


def silenced(**rules: Any) -> ExternalArmingSequence:
    """In offboard, and from 5 s on not heard: at first its place grows old, then it counts as lost."""
    made = flying(**rules)
    for k in range(5, 20):
        made.decide(FLYING._replace(age_s=k - 5.0, alive=k < 15), float(k))
    return made


@pytest.mark.parametrize("mode", [FlightMode.RETURN, FlightMode.LAND])
def test_what_its_failsafe_did_while_it_was_not_heard_is_left_alone_unless_the_scenario_says_rejoins(
    mode: FlightMode,
) -> None:
    made, again, falls = silenced(), silenced(rejoins=True), UP._replace(mode=mode)
    play(made, (21.0, falls, [], Stage.YIELDED))
    assert made.unheard_lately(21.0)
    play(again, (21.0, falls, [], Stage.OFFBOARD), (22.1, falls, [SET_MODE], None), (23.0, FLYING, [], Stage.FLY))
    play(again, (60.0, falls, [], Stage.YIELDED))  # now it is somebody's wish


@pytest.mark.parametrize(("rejoins", "stage"), [(False, Stage.DOWN), (True, Stage.ARM)])
def test_one_that_has_landed_meanwhile_is_armed_again_where_the_scenario_says_rejoins(
    rejoins: bool, stage: Stage
) -> None:
    made = silenced(rejoins=rejoins)
    made.decide(view(), 21.0)
    assert made.stage is stage


GUIDED = FLYING._replace(profile=ARDUCOPTER)
FALLEN = GUIDED._replace(mode=FlightMode.MANUAL, armed=False)


def booted(made: ExternalArmingSequence, flew: VehicleView = GUIDED) -> ExternalArmingSequence:
    """Killed in flight at 10 s; the order and the times of the frames are an ArduCopter's: HEARTBEAT at 12.1 s, the
    first time of the new boot at 15.6 s, that it has landed a tick later, and no place for 37 s more."""
    steered(made, 10.0, 12.1, flew._replace(age_s=2.0, last_received_s=9.5))
    fallen = flew._replace(age_s=3.0, last_received_s=15.1, armed=False, mode=FlightMode.MANUAL)
    steered(made, 12.1, 15.6, fallen)
    made.boot(fallen)
    steered(made, 15.6, 15.7, fallen)
    return made


def test_one_that_boots_in_flight_is_down_and_waits_for_its_place_when_it_is_to_rejoin() -> None:
    made = booted(flown(arm_within_s=90.0))
    assert (made.stage, made.booted) == (Stage.DOWN, True)
    landed = FALLEN._replace(landed=True, age_s=20.0, last_received_s=29.0)
    assert steered(made, 15.7, 30.0, landed) == []
    made.rejoin()
    assert steered(made, 30.0, 52.6, landed._replace(last_received_s=52.0)) == []
    assert made.stage is Stage.IDENTIFY
    assert steered(made, 52.6, 52.7, landed._replace(age_s=0.1, last_received_s=52.0)) == [SET_MODE]


def test_one_that_boots_in_flight_is_armed_again_with_its_place_where_the_scenario_says_rejoins() -> None:
    made = booted(flown(rejoins=True, arm_within_s=90.0))
    landed = FALLEN._replace(landed=True, age_s=20.0, last_received_s=52.0)
    assert steered(made, 15.7, 52.6, landed) == []
    assert made.stage is Stage.IDENTIFY
    placed = landed._replace(age_s=0.1)
    play(
        made,
        (52.6, placed, [SET_MODE], Stage.ARM),
        (53.6, placed._replace(mode=FlightMode.OFFBOARD), [ARM], Stage.ARM),
        (54.6, placed._replace(mode=FlightMode.OFFBOARD, armed=True), [TAKEOFF], Stage.TAKEOFF),
    )
    steered(made, 58.0, 59.0, GUIDED._replace(last_received_s=58.0))
    assert (made.stage, made.booted) == (Stage.FLY, False)


def test_one_that_boots_on_the_ground_under_a_pilot_or_as_its_battery_ends_is_not_brought_back() -> None:
    theirs = flown(rejoins=True)
    theirs.decide(FALLEN._replace(armed=True), 10.0)
    booted(theirs, FALLEN._replace(armed=True))
    assert (theirs.stage, theirs.booted) == (Stage.YIELDED, False)
    empty = booted(flown(rejoins=True), GUIDED._replace(energy_source="energy_consumed", drawn_j=9e9))
    assert (empty.stage, empty.booted) == (Stage.DOWN, True)
    ground = arming(rejoins=True)
    ground.decide(view(), 0.0)
    ground.boot(view())
    assert (ground.stage, ground.booted) == (Stage.ARM, False)


@pytest.mark.parametrize("rejoins", [False, True])
def test_one_that_flies_on_after_its_boot_is_flown_on(rejoins: bool) -> None:
    """A watchdog's boot takes no second, and what was armed stays armed."""
    made = flown(rejoins=rejoins)
    made.boot(GUIDED._replace(last_received_s=9.0))
    steered(made, 10.0, 10.5, GUIDED._replace(last_received_s=9.0))
    steered(made, 10.5, 11.0, GUIDED._replace(last_received_s=10.5))
    assert (made.stage, made.booted) == (Stage.FLY, False)


@pytest.mark.parametrize("rejoins", [False, True])
@pytest.mark.parametrize("late", [False, True])
def test_one_that_landed_without_its_gps_flies_again_with_it_where_the_scenario_says_rejoins(
    late: bool, rejoins: bool
) -> None:
    made, seen = flying(rejoins=rejoins), FLYING if late else LANDING
    made.decide(seen, 5.0)
    made.mend(seen)
    play(
        made,
        (6.0, LANDING, [], Stage.OFFBOARD if rejoins else Stage.YIELDED),
        (7.1, LANDING, [SET_MODE] if rejoins else [], None),
        (8.2, FLYING, [], Stage.FLY),
    )


def test_one_that_still_lands_by_an_earlier_sessions_order_is_waited_for_and_armed() -> None:
    made = arming()
    for k in range(40):  # longer than arm_within_s
        play(made, (float(k), LANDING, [], Stage.IDENTIFY))
    assert not made.sends_set_points
    play(made, (41.0, view(), [ARM], None))


MISSION = {"px4": (SET_MODE, (1.0, 4.0, 4.0)), "ardupilot": (mav.MAV_CMD_MISSION_START, (0.0, 0.0))}
HOLD = {"px4": (1.0, 4.0, 3.0), "ardupilot": (1.0, 17.0, 0.0)}


def on_mission(profile: Profile = PX4) -> ExternalArmingSequence:
    made = flying()
    made.go_on_mission("fly")
    wishes = made.decide(FLYING._replace(profile=profile), 3.1)[0]
    assert [(wish.command, wish.params[:3]) for wish in wishes] == [MISSION[profile.name]]
    assert made.sends_set_points  # until its mode says that it flies the mission
    play(made, (3.5, ON_MISSION._replace(profile=profile), [], Stage.MISSION))
    assert not made.sends_set_points
    return made


@pytest.mark.parametrize("profile", [PX4, ARDUCOPTER])
def test_a_mission_is_begun_held_and_gone_on_with_by_the_autopilots_own_commands(profile: Profile) -> None:
    made, held = on_mission(profile), UP._replace(profile=profile)
    made.go_on_mission("hold")
    (wish,) = made.decide(ON_MISSION._replace(profile=profile), 4.0)[0]
    assert (wish.command, wish.params[:3]) == (SET_MODE, HOLD[profile.name])
    play(made, (4.5, held, [], None))
    made.go_on_mission("fly")
    (wish,) = made.decide(held, 5.0)[0]
    assert (wish.command, wish.params[:3]) == MISSION[profile.name]
    assert made.stage is Stage.MISSION


def test_one_that_goes_on_before_it_has_said_that_it_holds_flies_its_mission() -> None:
    made = on_mission()
    for k in range(25):  # no late tick may be the reason
        made.decide(ON_MISSION, 4.0 + 0.2 * k)
    made.go_on_mission("hold")
    assert [wish.params[:3] for wish in made.decide(ON_MISSION, 9.0)[0]] == [HOLD["px4"]]
    made.go_on_mission("fly")
    play(made, *((9.2 + 0.2 * k, ON_MISSION, [], Stage.MISSION) for k in range(4)))
    (wish,) = made.decide(UP, 10.0)[0]
    assert (made.stage, wish.command, wish.params[:3]) == (Stage.MISSION, *MISSION["px4"])


def test_one_that_is_to_step_aside_is_brought_back_to_set_points() -> None:
    made = on_mission()
    made.go_on_mission("hold")
    made.decide(UP, 4.0)
    made.go_on_mission("")
    made.decide(UP, 5.0)
    assert (made.stage, made.sends_set_points) == (Stage.OFFBOARD, True)
    play(made, (6.1, UP, [SET_MODE], None), (7.0, FLYING, [], Stage.FLY))


def test_one_whose_mission_ends_as_it_goes_on_is_led_again_and_is_no_pilots() -> None:
    """The last item was reached 0.1 s after it went on, before a HEARTBEAT said that it was no more led."""
    made = flown()
    made.go_on_mission("fly")
    assert steered(made, 10.0, 10.1) == [PX4.mission[0]]
    made.go_on_mission("")
    steered(made, 10.1, 10.2)
    assert steered(made, 10.2, 12.0, UP) == [SET_MODE]
    assert made.stage is Stage.OFFBOARD
    steered(made, 12.0, 14.0)
    assert made.stage is Stage.FLY
    made.decide(UP, 14.0)
    assert made.stage is Stage.YIELDED


@pytest.mark.parametrize("mode", [FlightMode.HOLD, FlightMode.MANUAL, FlightMode.RETURN])
def test_a_pilot_who_takes_it_from_its_mission_has_it(mode: FlightMode) -> None:
    made = on_mission()
    for k in range(25):  # no late tick may be the reason
        made.decide(ON_MISSION, 4.0 + 0.2 * k)
    play(made, (9.0, UP._replace(mode=mode), [], Stage.YIELDED), (10.0, ON_MISSION, [], Stage.MISSION))
