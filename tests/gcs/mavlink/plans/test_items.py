"""Items of missions, fences and rally points on the wire, as MAVLink, ArduPilot and PX4 define them."""

from __future__ import annotations

import math

import pytest

from gcs.mavlink.autopilots import ARDUCOPTER, PX4
from gcs.mavlink.plans import habits
from gcs.mavlink.plans.habits import PlanHabits
from gcs.mavlink.plans.items import FENCE, MISSION, RALLY, PlanItem, as_sent, differences, wire_items
from gcs.missions.items import FenceArea, GlobalPlace, ItemError, MissionItem, MissionPlan
from gcs.missions.transfers import UNKNOWN, item_of
from skytender import mavlink as mav

NAN = math.nan
RELATIVE, FRAME_MISSION, LOCAL_NED = 3, 2, 1
PLAN = MissionPlan(
    mission=(
        MissionItem(mav.MAV_CMD_NAV_TAKEOFF, RELATIVE, (15.0, 0.0, 0.0, NAN, 47.5, 8.5, 20.0)),
        MissionItem(
            mav.MAV_CMD_DO_CHANGE_SPEED, FRAME_MISSION, (1.0, 5.0, -1.0, NAN, NAN, NAN, NAN), autocontinue=False
        ),
        MissionItem(mav.MAV_CMD_NAV_WAYPOINT, LOCAL_NED, (0.0, 0.0, 0.0, NAN, 12.5, -3.0, -20.0)),
        MissionItem(mav.MAV_CMD_DO_JUMP, FRAME_MISSION, (2.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0)),
    ),
    fence=(FenceArea(inclusion=True, corners_deg=((47.5, 8.5),), radius_m=80.0),),
    rally=(GlobalPlace(47.5, 8.5, 40.25, "home"),),
    home=GlobalPlace(47.4, 8.4, 500.0, "sea"),
)


def test_a_mission_goes_to_an_ardupilot_with_home_before_it_and_to_a_px4_without() -> None:
    ardupilot = wire_items(PLAN, MISSION, ARDUCOPTER.plans, ARDUCOPTER.not_given)
    px4 = wire_items(PLAN, MISSION, PX4.plans, PX4.not_given)
    assert [item.command for item in ardupilot] == [16, 22, 178, 16, 177]
    assert (ardupilot[0].x, ardupilot[0].y, ardupilot[0].z) == (474000000, 84000000, 500.0)
    assert [item.command for item in px4] == [22, 178, 16, 177]
    assert [item.current for item in ardupilot] == [1, 0, 0, 0, 0]
    assert [item.current for item in px4] == [1, 0, 0, 0]
    # the jump leads to DO_CHANGE_SPEED, whose number is 2 behind home and 1 without it
    assert (ardupilot[4].param1, px4[3].param1) == (2.0, 1.0)
    assert (ardupilot[2].autocontinue, px4[1].autocontinue) == (0, 0)


def test_numbers_that_are_not_given_are_what_the_autopilot_wants_for_them() -> None:
    ardupilot = wire_items(PLAN, MISSION, ARDUCOPTER.plans, ARDUCOPTER.not_given)
    px4 = wire_items(PLAN, MISSION, PX4.plans, PX4.not_given)
    assert ardupilot[1].param4 == 0.0  # ArduPilot's sanity_check_params takes NaN of few commands only
    assert (ardupilot[2].param4, ardupilot[2].x, ardupilot[2].z) == (0.0, 0, 0.0)
    assert math.isnan(px4[0].param4)
    assert math.isnan(px4[1].z)
    assert (px4[1].x, px4[1].y) == (UNKNOWN, UNKNOWN)


def test_places_are_in_the_units_of_their_frames() -> None:
    px4 = wire_items(PLAN, MISSION, PX4.plans)
    assert (px4[0].x, px4[0].y, px4[0].z) == (475000000, 85000000, 20.0)
    assert (px4[2].x, px4[2].y, px4[2].z) == (125000, -30000, -20.0)
    camera = MissionItem(mav.MAV_CMD_DO_DIGICAM_CONTROL, RELATIVE, (0.0, 0.0, 0.0, 0.0, 1.0, 7.0, 0.0))
    (item,) = wire_items(MissionPlan(mission=(camera,)), MISSION, PX4.plans)
    assert (item.x, item.y) == (1, 7)  # no place: AP_Mission.cpp, cmd_has_location
    for one, wired in zip((*PLAN.mission[:3], camera), [*px4[:3], item], strict=True):
        back = item_of("MISSION_ITEM_INT", wired)
        assert repr(back._replace(current=False)) == repr(one)
    speed = item_of("MISSION_ITEM_INT", px4[1]._replace(x=-(2**31)))  # as PX4 makes it of INT32_MAX in a float
    assert math.isnan(speed.params[4])


def test_a_fence_is_written_as_it_is_and_a_rally_point_no_lower_than_it_is() -> None:
    (circle,) = wire_items(PLAN, FENCE, ARDUCOPTER.plans, 0.0)
    assert (circle.command, circle.param1, circle.x) == (mav.MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION, 80.0, 475000000)
    (point,) = wire_items(PLAN, RALLY, ARDUCOPTER.plans)
    assert [as_sent(RALLY, point, whose).z for whose in (ARDUCOPTER.plans, PX4.plans)] == [41.0, 40.25]
    (rounded,) = differences(RALLY, point, point._replace(z=41.0), ARDUCOPTER.plans)
    assert (rounded.lost, rounded.text) == (True, "Altitude 40.25 is 41")
    for whose, z in ((ARDUCOPTER.plans, 40.0), (PX4.plans, 41.0)):
        assert [one.lost for one in differences(RALLY, point, point._replace(z=z), whose)] == [False]
    assert wire_items(MissionPlan(), MISSION, ARDUCOPTER.plans) == []


def test_a_number_beyond_the_wire_is_refused() -> None:
    for params in ((1e39, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0, 3e9, 0.0, 0.0)):
        with pytest.raises(ItemError, match="DO_JUMP has a number that is too large for MAVLink"):
            wire_items(
                MissionPlan(mission=(MissionItem(mav.MAV_CMD_DO_JUMP, FRAME_MISSION, params),)), MISSION, PX4.plans
            )


WAYPOINT = PlanItem(mav.MAV_CMD_NAV_WAYPOINT, 3, 5.0, 475000000, 85000000, 20.0, 2.0, 0.0, -90.0)


@pytest.mark.parametrize(
    ("other", "text"),
    [
        ({"frame": 6}, None),  # GLOBAL_RELATIVE_ALT_INT
        ({"param4": 270.0}, None),
        ({"param4": 269.9999}, None),  # PX4's radians of 32 bits
        ({"z": 20.01}, None),
        ({"x": 475000001}, None),
        ({"current": 1}, None),
        ({"frame": 0}, "frame GLOBAL_RELATIVE_ALT is GLOBAL"),
        ({"param4": 90.0}, "Yaw -90 is 90"),
        ({"param4": NAN}, "Yaw -90 is nan"),
        ({"param1": 5.01}, "Hold 5 is 5.01"),
        ({"z": 20.1}, "Altitude 20 is 20.1"),
        ({"x": 475000002}, "Latitude 47.5 is 47.5000002"),
        ({"autocontinue": 0}, "autocontinue 1 is 0"),
        ({"command": 17}, "command NAV_WAYPOINT is NAV_LOITER_UNLIM"),
    ],
)
def test_what_reads_otherwise(other: dict[str, float], text: str | None) -> None:
    found = [one.text for one in differences(MISSION, WAYPOINT, WAYPOINT._replace(**other))]  # type: ignore[arg-type]
    assert found == ([] if text is None else [text])


def test_what_is_not_given_is_no_difference() -> None:
    own = WAYPOINT._replace(param4=NAN, x=UNKNOWN)
    assert differences(MISSION, own, WAYPOINT._replace(param4=77.0)) == []


def test_only_a_parameter_without_use_that_reads_as_none_is_lost() -> None:
    own = WAYPOINT._replace(param4=0.0)
    for whose, parameter in ((habits.ARDUPILOT, "param2"), (habits.ARDUPLANE, "param1")):
        (lost,) = differences(MISSION, own, own._replace(**{parameter: 0.0}), whose)  # type: ignore[arg-type]
        (other,) = differences(MISSION, own, own._replace(**{parameter: 7.0}), whose)  # type: ignore[arg-type]
        assert (lost.lost, other.lost) == (True, False)
    (hold,) = differences(MISSION, own, own._replace(param1=0.0), habits.ARDUPILOT)
    assert not hold.lost
    landing = PlanItem(mav.MAV_CMD_NAV_LAND, 3, 0.0, 1, 2, 0.0)
    assert differences(MISSION, landing, landing._replace(param4=1.0), habits.ARDUPILOT) == []
    assert len(differences(MISSION, landing, landing._replace(param4=1.0), PlanHabits())) == 1


def test_a_px4_is_not_given_what_it_may_refuse() -> None:
    takeoff = PlanItem(mav.MAV_CMD_NAV_TAKEOFF, 3, 15.0, 1, 2, 20.0)
    assert math.isnan(as_sent(MISSION, takeoff, PX4.plans).param1)
    assert as_sent(MISSION, takeoff._replace(param1=0.0), PX4.plans) == takeoff._replace(param1=0.0)
    assert as_sent(MISSION, takeoff, ARDUCOPTER.plans) == takeoff
    assert as_sent(MISSION, WAYPOINT, PX4.plans) == WAYPOINT
    (lost,) = differences(MISSION, takeoff, takeoff._replace(param1=0.0), PX4.plans)
    assert (lost.text, lost.lost) == ("Pitch 15 is 0", True)
