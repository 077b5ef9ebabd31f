"""A scenario's `plan`: a .plan or way point file as its fence and rally points."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pymap3d
import pytest
import yaml

from gcs.scenario.document import ScenarioError
from gcs.scenario.file import dump, load
from gcs.scenario.model import Scenario

LAT_DEG, LON_DEG, ALT_M = 47.3977, 8.5456, 488.0
CORNERS = [[47.396, 8.543], [47.399, 8.543], [47.399, 8.548]]
SITE: dict[str, Any] = {
    "fileType": "Plan",
    "version": 1,
    "geoFence": {
        "polygons": [{"inclusion": True, "polygon": CORNERS, "version": 1}],
        "circles": [{"circle": {"center": [47.398, 8.545], "radius": 20}, "inclusion": False, "version": 1}],
        "version": 2,
    },
    "mission": {
        "items": [{"type": "ComplexItem", "complexItemType": "StructureScan"}],
        "plannedHomePosition": [LAT_DEG, LON_DEG, ALT_M],
        "version": 2,
    },
    "rallyPoints": {"points": [[47.3971, 8.5441, 30]], "version": 2},
}


def scenario(folder: Path, *, axes: str = "ned", site: object = SITE, **more: Any) -> Path:
    (folder / "site.plan").write_text(site if isinstance(site, str) else json.dumps(site))
    content = {
        "schema": 1, "name": "fenced", "axes": axes, "origin": {"lat_deg": LAT_DEG, "lon_deg": LON_DEG, "alt_m": ALT_M},
        "goal": {"duration_s": 20}, "plan": "site.plan",
        "vehicles": {"pursuers": [{"sysid": 1, "start_m": [0, 0, 0], "battery": {"capacity_j": 50000}}]},
    }  # fmt: skip
    path = folder / "fenced.yaml"
    path.write_text(yaml.safe_dump(content | more, sort_keys=False))
    return path


def ned(lat_deg: float, lon_deg: float) -> tuple[float, float]:
    north_m, east_m, _ = pymap3d.geodetic2ned(lat_deg, lon_deg, ALT_M, LAT_DEG, LON_DEG, ALT_M)
    return float(north_m), float(east_m)


@pytest.mark.parametrize("axes", ["ned", "paper"])
def test_fence_and_rally_points_are_the_files(tmp_path: Path, axes: str) -> None:
    found = load(scenario(tmp_path, axes=axes))
    (inside,), (outside,) = found.fence.inside, found.fence.outside
    assert inside.polygon_m is not None
    for corner, (lat_deg, lon_deg) in zip(inside.polygon_m, CORNERS, strict=True):
        assert corner == pytest.approx(ned(lat_deg, lon_deg), abs=1e-6)
    assert outside.circle_m == pytest.approx(ned(47.398, 8.545), abs=1e-6)
    assert outside.radius_m == 20.0
    assert found.rally_m == (pytest.approx(ned(47.3971, 8.5441), abs=1e-6),)


def test_what_is_written_needs_the_file_no_more(tmp_path: Path) -> None:
    found = load(scenario(tmp_path))
    again = tmp_path / "elsewhere" / "scenario.yaml"
    again.parent.mkdir()
    again.write_text(dump(found))
    assert load(again) == found


def test_a_way_point_file_and_a_set_key_do_as_well(tmp_path: Path) -> None:
    path = scenario(tmp_path)
    (tmp_path / "fence.txt").write_text("QGC WPL 110\n0 0 0 5003 50 0 0 0 47.398 8.545 0 0\n")
    found = load(path, set={"plan": "fence.txt"})
    assert [(area.circle_m, area.radius_m) for area in found.fence.inside] == [
        (pytest.approx(ned(47.398, 8.545)), 50.0)
    ]
    assert found.rally_m == ()


@pytest.mark.parametrize(("site", "more", "words"), [
    ("{", {}, "site.plan: the JSON ends too early"),
    ("hello", {}, "site.plan is neither a QGroundControl plan nor"),
    ({"fileType": "Plan", "version": 1}, {}, "site.plan holds neither a geofence nor rally points"),
    ("QGC WPL 110\n0 0 0 5005 50 0 0 0 0 0 0 0\n", {}, "command 5005 is no fence item that is known here"),
    (SITE, {"plan": "none.plan"}, "none.plan cannot be read: No such file or directory"),
    (SITE, {"plan": "."}, "is no file"),
    (SITE, {"plan": 3}, "plan must be"),
    (SITE, {"fence": {}}, "fence stands in the file that plan names"),
    (SITE, {"rally_m": [[0, 0]]}, "rally_m stands in the file that plan names"),
    (SITE, {"origin": {"lat_deg": 10.0, "lon_deg": 8.0, "alt_m": 0.0}}, "lies more than 100 km from"),
])  # fmt: skip
def test_a_file_that_cannot_be_used_is_said_at_the_key(
    tmp_path: Path, site: object, more: dict[str, Any], words: str
) -> None:
    path = scenario(tmp_path, site=site, **more)
    with pytest.raises(ScenarioError, match=words) as raised:
        load(path)
    lines = path.read_text().splitlines()
    key = next(iter(more)) if set(more) & {"fence", "rally_m"} else "plan"
    assert lines[(raised.value.problems[0].line or 0) - 1].startswith(f"{key}:"), str(raised.value)


def test_the_model_by_itself_reads_no_file(tmp_path: Path) -> None:
    content = yaml.safe_load(scenario(tmp_path).read_text())
    with pytest.raises(ValueError, match="plan is read with a scenario's file"):
        Scenario.model_validate(content)
