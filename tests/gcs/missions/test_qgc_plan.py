"""QGroundControl's .plan, by its published format (docs.qgroundcontrol.com, dev guide, Plan File Format)."""

from __future__ import annotations

import contextlib
import copy
import json
import math
import re
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gcs.missions import qgc_plan
from gcs.missions.errors import MissionFileError
from gcs.missions.files import read
from gcs.missions.items import FenceArea, GlobalPlace, MissionItem, MissionPlan

SURVEY_ITEMS = [
    {"command": 16, "doJumpId": 3, "frame": 3, "params": [0, 0, 0, None, 47.31, 8.51, 60], "type": "SimpleItem"},
    {"command": 206, "doJumpId": 4, "frame": 2, "params": [25, 0, 1, 0, 0, 0, 0], "type": "SimpleItem"},
]
SITE: dict[str, Any] = {
    "fileType": "Plan",
    "geoFence": {
        "circles": [{"circle": {"center": [47.3, 8.5], "radius": 319.85}, "inclusion": True, "version": 1}],
        "polygons": [{"inclusion": False, "polygon": [[47.31, 8.5], [47.32, 8.52], [47.3, 8.51]], "version": 1}],
        "version": 2,
    },
    "groundStation": "QGroundControl",
    "mission": {
        "cruiseSpeed": 15,
        "firmwareType": 12,
        "globalPlanAltitudeMode": 1,
        "hoverSpeed": 5,
        "items": [
            {
                "AMSLAltAboveTerrain": None,
                "Altitude": 50,
                "AltitudeMode": 0,
                "autoContinue": True,
                "command": 22,
                "doJumpId": 1,
                "frame": 3,
                "params": [15, 0, 0, None, 47.3985099, 8.5451002, 50],
                "type": "SimpleItem",
            },
            {
                "TransectStyleComplexItem": {
                    "CameraCalc": {"CameraName": "Manual (no camera specs)", "version": 1},
                    "Items": SURVEY_ITEMS,
                    "TurnAroundDistance": 10,
                    "VisualTransectPoints": [[47.31, 8.51]],
                    "version": 1,
                },
                "angle": 0,
                "complexItemType": "survey",
                "entryLocation": 0,
                "polygon": [[47.3, 8.5], [47.32, 8.5], [47.32, 8.52]],
                "type": "ComplexItem",
                "version": 5,
            },
            {
                "complexItemType": "StructureScan",
                "Layers": 1,
                "polygon": [[47.3, 8.5]],
                "type": "ComplexItem",
                "version": 2,
            },
            {
                "autoContinue": False,
                "command": 20,
                "doJumpId": 9,
                "frame": 2,
                "params": [0, 0, 0, 0, 0, 0, 0],
                "type": "SimpleItem",
            },
        ],
        "plannedHomePosition": [47.3977419, 8.545594, 487.989],
        "vehicleType": 2,
        "version": 2,
    },
    "rallyPoints": {"points": [[47.39760401, 8.5509154, 50], [47.39902017, 8.54263274, 25.5]], "version": 2},
    "version": 1,
}


def test_a_plan_gives_its_parts_with_their_frames() -> None:
    plan = read(json.dumps(SITE).encode(), "site.plan")
    assert [item.name for item in plan.mission] == [
        "NAV_TAKEOFF", "NAV_WAYPOINT", "DO_SET_CAM_TRIGG_DIST", "NAV_RETURN_TO_LAUNCH",
    ]  # fmt: skip
    takeoff, waypoint, trigger, back = plan.mission
    assert takeoff.place == (47.3985099, 8.5451002, 50.0, "home")
    assert math.isnan(takeoff.params[3])
    assert waypoint.place == (47.31, 8.51, 60.0, "home")
    assert trigger.place is None
    assert trigger.about == "Distance 25, Trigger 1"
    assert (back.place, back.autocontinue) == (None, False)
    assert plan.home == (47.3977419, 8.545594, 487.989, "sea")
    assert plan.fence == (
        FenceArea(inclusion=False, corners_deg=((47.31, 8.5), (47.32, 8.52), (47.3, 8.51))),
        FenceArea(inclusion=True, corners_deg=((47.3, 8.5),), radius_m=319.85),
    )
    assert plan.rally == (
        GlobalPlace(47.39760401, 8.5509154, 50.0, "home"), GlobalPlace(47.39902017, 8.54263274, 25.5, "home"),
    )  # fmt: skip
    assert plan.left_out == (
        "mission.items[2]: a StructureScan, whose items QGroundControl makes when it opens the file",
    )


@pytest.mark.parametrize("first", [0, 1])
def test_jumps_of_a_vehicle_that_counts_from_0_lead_to_the_same_item_in_a_file(first: int) -> None:
    way, jump = MissionItem(16, 3, (0.0,) * 7), MissionItem(177, 2, (1.0 + first, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    written = json.loads(qgc_plan.write(MissionPlan(mission=(way, way, jump), first=first)))["mission"]["items"]
    assert written[2]["params"][0] == written[1]["doJumpId"] == 2


def test_a_byte_order_mark_and_missing_parts_are_taken() -> None:
    assert read(b'\xef\xbb\xbf {"fileType": "Plan", "version": 1, "geoFence": {}}', "a") == MissionPlan()


def test_the_first_published_forms_are_taken() -> None:
    """Four parameters beside a coordinate, and the fence as one polygon, as QGroundControl 3.1 wrote them."""
    item = {"command": 16, "frame": 3, "params": [1, 2, 3, 4], "coordinate": [47.3, 8.5, 20], "type": "SimpleItem"}
    fence = {"breachReturn": [47.0, 8.0], "polygon": [[47.1, 8.1], [47.2, 8.1], [47.2, 8.2]], "version": 1}
    whole = {"fileType": "Plan", "version": 1, "mission": {"items": [item], "version": 2}, "geoFence": fence}
    plan = read(json.dumps(whole).encode(), "old.plan")
    assert plan.mission == (MissionItem(16, 3, (1.0, 2.0, 3.0, 4.0, 47.3, 8.5, 20.0)),)
    assert plan.fence_return == (47.0, 8.0)
    assert plan.fence[0].corners_deg == ((47.1, 8.1), (47.2, 8.1), (47.2, 8.2))


numbers = st.floats(-1e6, 1e6)
places = st.tuples(st.floats(-90, 90), st.floats(-180, 180))
plans = st.builds(
    MissionPlan,
    mission=st.lists(
        st.builds(
            MissionItem,
            st.integers(0, 4999),
            st.integers(0, 255),
            st.tuples(*[numbers] * 4, st.floats(-90, 90), st.floats(-180, 180), numbers),
            st.booleans(),
            st.just(False),
        ),
        max_size=5,
    ).map(tuple),
    fence=st.tuples(
        st.builds(FenceArea, st.booleans(), st.tuples(places, places, places), st.none()),
        st.builds(FenceArea, st.booleans(), st.tuples(places), st.floats(0.5, 1e5)),
    ),
    rally=st.lists(places.map(lambda at: GlobalPlace(*at, 30.0, "home")), max_size=3).map(tuple),
    home=places.map(lambda at: GlobalPlace(*at, 400.0, "sea")),
    fence_return=st.none() | places,
    first=st.just(1),
    left_out=st.just(()),
)


@given(plans)
@settings(deadline=None, max_examples=40)
def test_what_is_written_is_read_back(plan: MissionPlan) -> None:
    written = json.loads(qgc_plan.write(plan))
    assert written["fileType"] == "Plan"
    assert [item["doJumpId"] for item in written["mission"]["items"]] == list(range(1, len(plan.mission) + 1))
    assert read(json.dumps(written).encode(), "a.plan") == plan


def changed(path: list[str | int], value: object) -> bytes:
    content = copy.deepcopy(SITE)
    at: Any = content
    for key in path[:-1]:
        at = at[key]
    at[path[-1]] = value
    return json.dumps(content).encode()


@pytest.mark.parametrize(("content", "words"), [
    (b'{"fileType": "Plan",\n "version": }', "site.plan: line 2, column 13: "),
    (json.dumps(SITE).encode()[:-40], "the JSON ends too early"),
    (b"{" * 100_000, "line 1, column 2: "),
    (b'{"a":' * 100_000, "the JSON cannot be read: "),
    (b'{"fileType": "\xff", "version": 1}', "the JSON cannot be read: |line 1, column"),
    (changed(["fileType"], "Mission"), "fileType is 'Mission', not 'Plan'"),
    (changed(["version"], 2), "version is 2, and only 1 is read"),
    (changed(["mission", "version"], 7), "mission.version is 7, and only 2 is read"),
    (changed(["mission", "items"], {}), "mission.items: expected array, got object"),
    (changed(["mission", "items", 0, "type"], "Item"), "mission.items\\[0\\].type: invalid value 'Item'"),
    (changed(["mission", "items", 0, "params", 4], "north"), "mission.items\\[0\\].params\\[4\\]: expected float"),
    (changed(["mission", "items", 0, "params"], [1, 2]), "mission.items\\[0\\].params: expected array of length"),
    (changed(["mission", "items", 0, "command"], -3), "mission.items\\[0\\].command: expected int >= 0"),
    (changed(["mission", "items", 0, "params", 4], 473.9), "mission.items\\[0\\]: 473.9, 8.5451002 are no latitude"),
    (changed(["mission", "items", 0, "command"], 5001), "NAV_FENCE_POLYGON_VERTEX_INCLUSION stands in the mission"),
    (changed(["mission", "items", 1, "TransectStyleComplexItem", "Items", 0, "frame"], None),
     "mission.items\\[1\\].TransectStyleComplexItem.Items\\[0\\].frame: expected int, got null"),
    (changed(["mission", "plannedHomePosition"], [None, 8.0, 1.0]), "mission.plannedHomePosition: nan, 8 are no lat"),
    (changed(["geoFence", "circles", 0, "circle", "radius"], 0), "geoFence.circles\\[0\\].circle.radius: .* 0 m"),
    (changed(["geoFence", "circles", 0, "circle"], {"radius": 5}), "geoFence.circles\\[0\\].circle: .*field center"),
    (changed(["geoFence", "polygons", 0, "polygon"], [[1, 2], [3, 4]]), "polygons\\[0\\].polygon: expected array"),
    (changed(["geoFence", "polygons", 0, "polygon", 1], [91, 4]), "geoFence.polygons\\[0\\].polygon\\[1\\]: 91, 4 are"),
    (changed(["geoFence", "polygon"], [[1, 2], [3, 4]]), "geoFence.polygon: a polygon has 2 corners"),
    (changed(["rallyPoints", "points", 1], [47.0]), "rallyPoints.points\\[1\\]: expected array of length"),
    (changed(["rallyPoints", "points", 1], [47.0, 190.0, 3]), "rallyPoints.points\\[1\\]: 47, 190 are no latitude"),
])  # fmt: skip
def test_a_broken_plan_is_one_sentence_with_its_place(content: bytes, words: str) -> None:
    with pytest.raises(MissionFileError) as raised:
        read(content, "site.plan")
    assert re.search(words, str(raised.value)), str(raised.value)
    assert str(raised.value).startswith("site.plan: ")
    assert "\n" not in str(raised.value)


@given(st.data())
@settings(max_examples=100, deadline=None)
def test_any_value_anywhere_is_read_or_refused_by_a_sentence(data: st.DataObject) -> None:
    content = copy.deepcopy(SITE)
    at: Any = content
    while True:
        key = data.draw(st.sampled_from(sorted(at) if isinstance(at, dict) else range(len(at))))
        if not isinstance(at[key], dict | list) or not at[key] or data.draw(st.integers(0, 4)) == 0:
            break
        at = at[key]
    at[key] = data.draw(
        st.none() | st.booleans() | st.integers(-(2**70), 2**70) | st.floats(-1e308, 1e308) | st.text() | st.just([])
    )
    with contextlib.suppress(MissionFileError):
        assert isinstance(read(json.dumps(content).encode(), "site.plan"), MissionPlan)


@given(st.binary(max_size=60), st.integers(0, 2000), st.integers(0, 40))
@settings(max_examples=100, deadline=None)
def test_any_bytes_are_read_or_refused_by_a_sentence(noise: bytes, at: int, cut: int) -> None:
    content = json.dumps(SITE).encode()
    with contextlib.suppress(MissionFileError):
        assert isinstance(read(content[:at] + noise + content[at + cut :], "site.plan"), MissionPlan)


def test_zeros_stand_for_a_home_that_is_not_known() -> None:
    written = json.loads(qgc_plan.write(MissionPlan()))
    assert written["mission"]["plannedHomePosition"] == [0.0, 0.0, 0.0]  # QGroundControl opens no file without it
    assert read(json.dumps(written).encode(), "a.plan").home is None
