"""Set points in the frames that travel or turn with the vehicle, flown; and yaw rates."""

import math
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

LOCAL, OFFSET, BODY = mav.MAV_FRAME_LOCAL_NED, mav.MAV_FRAME_LOCAL_OFFSET_NED, mav.MAV_FRAME_BODY_NED
BODY_OFFSET, FORWARD_RIGHT_DOWN = mav.MAV_FRAME_BODY_OFFSET_NED, mav.MAV_FRAME_BODY_FRD
POSITION, VELOCITY, POSITION_AND_YAW, VELOCITY_AND_TURN = 3576, 3527, 2552, 1479
EAST = math.pi / 2
HERE = (1.0, 2.0, -2.5)


def facing_east(bench: Any) -> Any:
    """In offboard at a place, turned to the east, where forward is east and right is south."""
    bench.offboard()
    bench.fly(8.0, p_ned=HERE, yaw=EAST, mask=POSITION_AND_YAW)
    assert bench.vehicle.attitude_ned[2] == pytest.approx(EAST, abs=0.02)
    assert bench.vehicle.p_ned == pytest.approx(HERE, abs=0.05)
    return bench


@pytest.mark.parametrize(
    ("frame", "v", "moves_ned"),
    [
        (LOCAL, (1.0, 0.0, 0.0), (1.0, 0.0, 0.0)),
        (OFFSET, (1.0, 0.0, 0.0), (1.0, 0.0, 0.0)),
        (BODY, (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
        (BODY, (0.0, 1.0, 0.0), (-1.0, 0.0, 0.0)),
        (BODY, (0.0, 0.0, -0.5), (0.0, 0.0, -0.5)),
        (BODY_OFFSET, (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
        (FORWARD_RIGHT_DOWN, (0.0, -1.0, 0.0), (1.0, 0.0, 0.0)),
    ],
)
def test_velocity_points_where_its_frame_does(vehicle_bench: Any, frame: int, v: Any, moves_ned: Any) -> None:
    bench = facing_east(vehicle_bench())
    bench.fly(4.0, v_ned=v, mask=VELOCITY, frame=frame)
    assert bench.vehicle.v_ned == pytest.approx(moves_ned, abs=0.05)
    assert bench.vehicle.attitude_ned[2] == pytest.approx(EAST, abs=0.02)


@pytest.mark.parametrize(
    ("frame", "p", "goal_ned"),
    [
        (LOCAL, (3.0, 0.0, -3.0), (3.0, 0.0, -3.0)),
        (BODY, (3.0, 0.0, -3.0), (3.0, 0.0, -3.0)),
        (OFFSET, (2.0, 0.0, -1.0), (3.0, 2.0, -3.5)),
        (BODY_OFFSET, (2.0, 0.0, -1.0), (1.0, 4.0, -3.5)),
        (FORWARD_RIGHT_DOWN, (0.0, 2.0, 0.0), (-1.0, 2.0, -2.5)),
    ],
)
def test_place_counts_from_where_its_frame_does_when_it_comes(
    vehicle_bench: Any, frame: int, p: Any, goal_ned: Any
) -> None:
    bench = facing_east(vehicle_bench(params={"COM_OF_LOSS_T": 10.0}))
    bench.set_point(p, mask=POSITION, frame=frame)
    bench.fly(8.0)
    assert bench.vehicle.p_ned == pytest.approx(goal_ned, abs=0.1)


def test_yaw_rate_turns_the_vehicle_as_long_as_it_is_asked_for(vehicle_bench: Any) -> None:
    """Nose and right hand turn with it: forward with a turn is flown in circles of radius speed by rate."""
    bench = facing_east(vehicle_bench())
    spin = {"v_ned": (0.0, 0.0, 0.0), "mask": VELOCITY_AND_TURN, "frame": BODY}
    bench.fly(4.0, yaw_rate=0.5, **spin)
    before = bench.vehicle.attitude_ned[2]
    bench.fly(2.0, yaw_rate=0.5, **spin)
    assert math.remainder(bench.vehicle.attitude_ned[2] - before, math.tau) == pytest.approx(1.0, abs=0.03)
    bench.fly(6.0, yaw_rate=-0.5, v_ned=(1.0, 0.0, 0.0), mask=VELOCITY_AND_TURN, frame=BODY)
    circle = []
    for _ in range(round(10 * math.tau / 0.5)):
        bench.fly(0.1, yaw_rate=-0.5, v_ned=(1.0, 0.0, 0.0), mask=VELOCITY_AND_TURN, frame=BODY)
        circle.append(bench.vehicle.p_ned)
    widths = [max(p[axis] for p in circle) - min(p[axis] for p in circle) for axis in (0, 1)]
    assert widths == pytest.approx([4.0, 4.0], abs=0.5)
    yaw = bench.vehicle.attitude_ned[2]
    bench.fly(3.0, v_ned=(0.0, 0.0, 0.0), mask=VELOCITY)
    assert abs(math.remainder(bench.vehicle.attitude_ned[2] - yaw, math.tau)) < 0.8
    assert bench.vehicle.true_motion_ned[11] == pytest.approx(0.0, abs=0.01)


def test_yaw_rate_is_no_faster_than_the_guidance_turns(vehicle_bench: Any) -> None:
    bench = facing_east(vehicle_bench())
    for rate in (50.0, -3e38):
        bench.fly(5.0, mask=VELOCITY_AND_TURN, yaw_rate=rate)
        assert abs(bench.vehicle.true_motion_ned[11]) == pytest.approx(bench.vehicle.fastest_turn_rad_s, rel=0.05)
    bench.fly(3.0, mask=VELOCITY_AND_TURN, yaw_rate=0.0)
    assert bench.vehicle.true_motion_ned[11] == pytest.approx(0.0, abs=0.02)
