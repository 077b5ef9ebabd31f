"""Set points in their vehicles' own frames."""

import math

import pytest
from views import snapshot, view

from gcs.mavlink import codec
from gcs.mavlink.ids import STATION
from gcs.mavlink.setpoints import SetPoint, SetPoints
from gcs.supervisor.grants import OwnFrames


def test_set_points_are_placed_in_their_vehicles_frames() -> None:
    """A frame a quarter turn to the right of ours has its north in our east."""
    p_ned, v_ned = (10.0, 20.0, -5.0), (1.0, 2.0, 3.0)
    points = [SetPoint(sysid, p_ned, v_ned) for sysid in (1, 2, 3)]
    columns = snapshot(
        view(1), view(2, origin_offset_ned=(1.0, -2.0, 0.5)),
        view(3, origin_offset_ned=(1.0, -2.0, 0.5), turn_rad=math.pi / 2), view(4, origin_offset_ned=None),
    ).columns  # fmt: skip
    frames = OwnFrames()
    for _ in range(2):
        placed = frames.placed(SetPoints.of(points), columns, 100)
        assert placed.sysids == (1, 2, 3)
        assert placed.values.tolist()[:2] == [[10.0, 20.0, -5.0, 1.0, 2.0, 3.0], [9.0, 22.0, -5.5, 1.0, 2.0, 3.0]]
        assert placed.values[2] == pytest.approx([22.0, -9.0, -5.5, 2.0, -1.0, 3.0])
        assert codec.fields(codec.split(codec.frame(placed.message(2), 0, *STATION)).frames[0]).time_boot_ms == 100
    assert points == [SetPoint(sysid, p_ned, v_ned) for sysid in (1, 2, 3)]
    moved = snapshot(view(1, origin_offset_ned=(5.0, 0.0, 0.0)), view(2)).columns
    assert frames.placed(SetPoints.of(points[:1]), moved, 200).values.tolist() == [[5.0, 20.0, -5.0, 1.0, 2.0, 3.0]]
    assert frames.placed(SetPoints.of([]), moved, 300).values.shape == (0, 6)
