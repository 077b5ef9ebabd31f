"""Where a fence lets vehicles be, by matplotlib's polygons; what `gcs validate` says of it, and draws."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml
from matplotlib.path import Path as Polygon
from sessions import small

from gcs.cli.main import run_argv
from gcs.scenario.fence import Area, FenceRules


def square(half_m: float) -> dict[str, Any]:
    return {"polygon_m": [[half_m, half_m], [half_m, -half_m], [-half_m, -half_m], [-half_m, half_m]]}


def test_a_place_lies_in_a_polygon_or_not() -> None:
    random = np.random.default_rng(5)
    for corners in (3, 5, 12):
        turns = np.sort(random.uniform(0.0, 2.0 * math.pi, corners))
        reach = random.uniform(2.0, 20.0, corners)  # a star: bays and spikes
        points = np.column_stack([reach * np.cos(turns), reach * np.sin(turns)])
        area = Area(polygon_m=tuple(map(tuple, points.tolist())))
        places = random.uniform(-22.0, 22.0, (2000, 2))
        assert [area.covers(n, e) for n, e in places.tolist()] == Polygon(points).contains_points(places).tolist()


@pytest.mark.parametrize(
    ("place", "allowed"), [((0.0, 3.0), True), ((0.0, 1.0), False), ((9.0, 0.0), True), ((30.0, 0.0), False)]
)
def test_it_keeps_in_one_of_some_areas_and_out_of_all_others(place: tuple[float, float], allowed: bool) -> None:
    near, far, well = (
        Area(**square(5.0)),
        Area(circle_m=(9.0, 0.0), radius_m=2.0),
        Area(circle_m=(0.0, 0.0), radius_m=2.0),
    )
    assert FenceRules(inside=(near, far), outside=(well,)).allows(*place) is allowed
    assert FenceRules().allows(*place)


def test_validate_draws_it_and_names_a_place_beyond_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    content = small(rally_m=[[1.0, 1.0]])
    content["fence"] = {"inside": [square(8.0)], "outside": [{"circle_m": [-4.5, 4.0], "radius_m": 1.5}]}
    content["vehicles"]["pursuers"][0] |= {"waypoints_m": [[9.0, 0.0, -2.5], [6.0, 0.0, -2.5]]}
    path = tmp_path / "fenced.yaml"
    path.write_text(yaml.safe_dump(content), encoding="utf-8")
    assert run_argv(["validate", str(path), "--image", str(tmp_path / "plan.png")]) == 0
    assert run_argv(["validate", str(path)]) == 0
    out, err = capsys.readouterr()
    assert "= fence to stay in, x fence to stay out of, R rally point" in out
    said = "way point 1 of pursuer 1 lies beyond the fence: a vehicle sent there stops at it"
    assert said in (out + err).replace("\n", " ")
    assert (tmp_path / "plan.png").stat().st_size > 10_000
