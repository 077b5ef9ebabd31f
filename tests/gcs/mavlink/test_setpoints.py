"""A tick's set points: columns that are a sequence of `SetPoint` to who asks."""

from __future__ import annotations

import numpy as np

from gcs.mavlink.setpoints import SetPoint, SetPoints

POINTS = [
    SetPoint(sysid, (1.0 * sysid, -0.1 * sysid, -4.0), (0.3, 0.7 / sysid, -0.0)) for sysid in (3, 7, 101)
]  # fmt: skip


def columns() -> SetPoints:
    return SetPoints(
        tuple(point.sysid for point in POINTS),
        np.array([(*point.p_ned, *point.v_ned) for point in POINTS]),
    )


def test_columns_are_a_list_of_set_points_to_who_asks() -> None:
    points = columns()
    assert list(points) == POINTS
    assert (len(points), points[1], points[-1], points[1:]) == (3, POINTS[1], POINTS[2], POINTS[1:])
    assert points == POINTS
    assert points == columns()
    assert points != POINTS[:2]
    assert POINTS[0] in points
    assert [*reversed(points)] == POINTS[::-1]
    assert type(points[0].p_ned) is tuple
    assert {type(x) for point in points for x in (*point.p_ned, *point.v_ned)} == {float}
    assert not SetPoints.of([])
    assert SetPoints.of([]) == []


def test_a_list_gets_the_same_columns_and_columns_stay_themselves() -> None:
    points = SetPoints.of(POINTS)
    assert points.sysids == (3, 7, 101)
    assert points.p_ned.tobytes() == columns().p_ned.tobytes()
    assert points.v_ned.tobytes() == columns().v_ned.tobytes()
    assert SetPoints.of(points) is points
