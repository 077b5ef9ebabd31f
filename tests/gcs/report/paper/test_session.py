"""A session written by hand: what it says is read back, and the reference follows from it by mental arithmetic."""

import json
import struct
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from gcs.mavlink import codec
from gcs.recording.recorder import Recorder
from gcs.report.paper import races, tracking
from gcs.report.paper.session import RecordedFlight, read

PERIOD_S = 0.1


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """One vehicle: set points from 0.1 s on, two steps of speed and then rest; efforts of 10 and 30."""
    (tmp_path / "vehicles").mkdir()
    with Recorder(tmp_path) as recorder:
        for t_s, north, speed in ((0.1, 0.0, 1.0), (0.2, 0.1, 2.0), (0.3, 0.3, 0.0), (0.4, 0.3, 0.0)):
            point = {"sysid": 1, "p_ned": [north, 2.0, -3.0], "v_ned": [speed, 0.0, -speed]}
            recorder.decisions([{"t_s": t_s, "kind": "set_point", **point}])
        recorder.decisions([{"t_s": 0.1, "kind": "set_point", "sysid": 2, "p_ned": [9, 9, 9], "v_ned": [9, 9, 9]}])
        effort = {"name": "CtlEffort"}
        for t_ms, value in ((1000, 10.0), (2000, 30.0)):
            fields = {"time_boot_ms": t_ms, "value": value, **effort}
            recorder.frames(
                t_ms * 1000,
                [codec.encode("HEARTBEAT", 0, 1, 1, type=2, autopilot=12, base_mode=0, custom_mode=0, system_status=4)],
            )
            recorder.frames(t_ms * 1000, [codec.encode("NAMED_VALUE_FLOAT", 1, 1, 1, **fields)])
            recorder.frames(t_ms * 1000, [codec.encode("NAMED_VALUE_FLOAT", 1, 2, 1, **(fields | {"value": 99.0}))])
            recorder.frames(t_ms * 1000, [codec.encode("NAMED_VALUE_FLOAT", 1, 1, 1, **(fields | {"name": "Other"}))])
    names = {"state": ["n", "e", "d", "vn", "ve", "vd", "roll", "pitch", "yaw", "p", "q", "r"], "energy": list("abcd")}
    truth = json.dumps({"schema": 1, **names}).encode() + b"\n"
    for k in range(6):
        row = [k / 10, 2.0, 1.0, 2.0, -3.0, 0.5, -0.25, -1.0, 0.1, 0.2, 0.3, *[0.0] * 7, 9.8, 9.8]
        truth += struct.pack(f"<{len(row)}d", *row)
    (tmp_path / "vehicles" / "1.truth").write_bytes(truth + b"\0" * 20)  # a record that a killed process left
    return tmp_path


def flight(folder: Path) -> RecordedFlight:
    (found,) = read(folder, [1], PERIOD_S)
    return found


def test_everything_is_read_in_the_papers_axes(folder: Path) -> None:
    f = flight(folder)
    assert f.time_s == pytest.approx([0.0, 0.1, 0.2, 0.3, 0.4, 0.5])
    assert f.p[0] == pytest.approx([1.0, -2.0, 3.0])
    assert f.v[0] == pytest.approx([0.5, 0.25, 1.0])
    assert f.attitude[0] == pytest.approx([0.1, -0.2, -0.3])
    assert f.plan_time_s == pytest.approx([0.1, 0.2, 0.3, 0.4])
    assert f.plan_p[1] == pytest.approx([0.1, -2.0, 3.0])
    assert f.plan_v[1] == pytest.approx([2.0, 0.0, 2.0])
    assert f.effort == pytest.approx([10.0, 30.0])


def test_the_reference_reaches_each_velocity_one_period_after_it_was_sent(folder: Path) -> None:
    v_d, a_d = flight(folder).reference()
    assert v_d[:, 0] == pytest.approx([0.5, 0.5, 1.0, 2.0, 0.0, 0.0])
    assert a_d[:, 0] == pytest.approx([0.0, 0.0, 5.0, 10.0, -20.0, 0.0])


def test_the_reference_is_constant_one_period_after_the_plan_came_to_rest(folder: Path) -> None:
    f = flight(folder)
    assert f.arrived_s == pytest.approx(0.3)
    assert f.constant_from_s == pytest.approx(0.4)


def test_effort_is_linear_between_its_reports_and_from_zero(folder: Path) -> None:
    assert flight(folder).effort_at(np.array([0.0, 0.3, 1.5])) == pytest.approx([0.0, 3.0, 20.0])


def test_a_vehicle_that_left_no_trace_is_named(folder: Path) -> None:
    with pytest.raises(ValueError, match="vehicle 3 received or reported nothing"):
        read(folder, [3], PERIOD_S)


def test_a_session_that_ends_too_early_cannot_be_judged(folder: Path) -> None:
    with pytest.raises(ValueError, match="not constant for 8 s; fly longer"):
        tracking.speed_errors([flight(folder)])


def test_the_desired_attitude_points_the_thrust_where_it_is_wanted() -> None:
    """Turned by φ_d, θ_d, ψ, the body's up axis lies along W; the rotation is scipy's."""
    rng = np.random.default_rng(3)
    v, v_d, a_d = rng.normal(size=(3, 50, 3))
    yaw = rng.uniform(-3.0, 3.0, 50)
    roll, pitch = tracking.desired_attitude(v, v_d, a_d.copy(), yaw)
    up = Rotation.from_euler("ZYX", np.column_stack((yaw, pitch, roll))).apply([0.0, 0.0, 1.0])
    wanted = a_d + 0.05 * v - 3.0 * (v - v_d) + [0.0, 0.0, 9.8]
    free = wanted[:, 2] > 0.3 * 9.8
    assert free.sum() > 40
    assert up[free] == pytest.approx((wanted / np.linalg.norm(wanted, axis=1)[:, None])[free])


def test_clearance_counts_the_legs_between_the_planned_points(folder: Path) -> None:
    # The plan runs from x = 0 to 0.3 at y = -2, z = 3; the obstacle stands 0.4 m above the middle of its second leg.
    assert tracking.clearances([flight(folder)], np.array([[0.2, -2.0, 3.4]])) == pytest.approx([0.4])


def test_arrival_takes_the_worse_of_way_point_and_end(folder: Path) -> None:
    way, end = np.array([0.1, -2.0, 3.05]), np.array([0.3, -2.0, 3.2])
    assert tracking.arrival_errors([flight(folder)], way, end) == pytest.approx([0.2])


def test_the_race_is_fed_with_the_effort_up_to_arrival_and_the_initial_speed(folder: Path) -> None:
    f = flight(folder)
    assert races.efforts([f]) == pytest.approx([3.0])
    assert races.initial_states([f]) == pytest.approx([1.0])
