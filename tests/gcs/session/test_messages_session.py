"""The first line of the socket: what a client needs in order to draw."""

import itertools
import json
import math

import pytest

from gcs.scenario.file import find, load
from gcs.scenario.model import Obstacle
from gcs.session.messages import obstacle_of, session_message


def area_m2(outline: list[tuple[float, float]]) -> float:
    """By the shoelace formula."""
    pairs = itertools.pairwise(outline)
    return abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in pairs)) / 2.0


def test_the_demo_is_told_whole_as_json() -> None:
    scenario = load(find("demo"))
    line = json.loads(json.dumps(session_message(scenario, "/somewhere"), allow_nan=False))
    assert (line["type"], line["name"], line["folder"], line["control"]) == ("session", "demo", "/somewhere", True)
    assert [v["sysid"] for v in line["vehicles"]] == [v.sysid for v in scenario.vehicles.all]
    assert len(line["obstacles"]) == len(scenario.obstacles)
    target = next(v for v in line["vehicles"] if v["role"] == "target")
    assert len(target["path_ned"]) >= len(scenario.vehicles.targets[0].path_m)
    assert (line["clock"], line["speed"]) == ("real", scenario.clock.speed)
    assert line["origin"] == [scenario.origin.lat_deg, scenario.origin.lon_deg, scenario.origin.alt_m]
    assert line["wind"] is None


def test_lockstep_has_no_speed() -> None:
    line = session_message(load(find("demo")).flown(lockstep=True), None)
    assert (line["clock"], line["speed"]) == ("lockstep", None)


@pytest.mark.parametrize(
    ("shape", "area", "bottom_top"),
    [
        (Obstacle(box_m=((1.0, 2.0, -3.0), (4.0, 6.0, 0.0))), 12.0, (0.0, -3.0)),
        (Obstacle(cylinder_m=(5.0, 5.0), radius_m=2.0, bottom_m=0.0, top_m=-9.0), math.pi * 4.0, (0.0, -9.0)),
        (Obstacle(sphere_m=(0.0, 1.0, -5.0), radius_m=3.0), math.pi * 9.0, (-2.0, -8.0)),
    ],
)
def test_an_outline_is_closed_and_as_large_as_the_solid(
    shape: Obstacle, area: float, bottom_top: tuple[float, float]
) -> None:
    told = obstacle_of(shape, "solid 1")
    assert told.outline_ne[0] == told.outline_ne[-1]
    # A circle of 32 corners has 0.6 % less than the round one.
    assert area_m2(told.outline_ne) == pytest.approx(area, rel=0.007)
    assert (told.bottom_d, told.top_d) == bottom_top
    assert told.label == "solid 1"


def test_a_point_has_no_outline() -> None:
    told = obstacle_of(Obstacle(name="mast", point_m=(1.0, 2.0, -3.0)), "point 1")
    assert (told.outline_ne, told.centre_ned, told.label) == ([], (1.0, 2.0, -3.0), "mast")
