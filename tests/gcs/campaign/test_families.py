"""Scenarios of every family load, allow what is wanted of them, and depend on name and seed alone."""

import json
import math
from pathlib import Path

import numpy as np
import pytest
import yaml

from gcs.campaign.families.accuracy import MOST_S
from gcs.campaign.families.dense import DENSE_S
from gcs.campaign.families.makers import FAMILIES, family
from gcs.campaign.families.parts import LONGEST_S, MARGIN_M, OBSTACLE_M, TAKEOFF_M, Document, table_of
from gcs.campaign.families.silence import COMES_DOWN_S, SILENT_BEFORE_S
from gcs.campaign.families.tight import DURATION_S
from gcs.scenario.file import load
from gcs.scenario.warnings import warnings
from skytender import geometry as shapes

SEEDS = range(4)
DENSE = ("cube", "forest", "streets", "big_circle")


def faults(document: Document) -> list[str]:
    """Sentences on what a document's starts and last way points do not allow; none if all is well."""
    separation_m = document["planner"]["separation_m"] + MARGIN_M - 2e-3  # places are rounded to 1 mm
    vehicles = [v for group in ("pursuers", "targets", "tankers") for v in document["vehicles"].get(group, [])]
    starts = [(v["sysid"], v["start_m"]) for v in vehicles]
    ends = [(v["sysid"], v["waypoints_m"][-1]) for v in vehicles if v.get("waypoints_m")]
    found = []
    for what, places in (("start", starts), ("end", ends)):
        for i, (one, p) in enumerate(places):
            for other, q in places[:i]:
                if math.dist(p, q) < separation_m:
                    found.append(f"{one} and {other} {what} {math.dist(p, q):.3f} m apart")
    table = table_of(document)
    for v in vehicles:
        up = 0.0 if v.get("airborne") else v.get("takeoff_m", TAKEOFF_M)
        n, e, d = v["start_m"]
        places = [[n, e, d - h] for h in np.linspace(0.0, up, 9)] + v.get("waypoints_m", [])
        least_m = shapes.clearance(table, np.array(places)).min()
        if least_m < OBSTACLE_M - 2e-3:
            found.append(f"{v['sysid']} starts or ends {least_m:.3f} m from an obstacle")
    return found


@pytest.mark.parametrize("name", FAMILIES)
def test_every_scenario_loads_and_its_starts_allow_what_is_wanted(name: str, tmp_path: Path) -> None:
    for seed in SEEDS:
        document = family(name, seed)
        assert faults(document) == []
        path = tmp_path / f"{seed}.yaml"
        path.write_text(yaml.safe_dump(document, sort_keys=False))
        scenario = load(path)
        assert (scenario.name, scenario.seed) == (f"{name}-{seed}", seed)
        longest_s = {"tight": DURATION_S, "tight_gusts": DURATION_S,
                         "delay": 2.0 * LONGEST_S, "silence": SILENT_BEFORE_S + COMES_DOWN_S,
                     "accuracy": MOST_S,
                     **dict.fromkeys(DENSE, DENSE_S)}.get(name, LONGEST_S)  # fmt: skip
        assert 20 <= scenario.goal.duration_s <= longest_s
        assert scenario.clock.mode == "lockstep"
        assert 1.5 <= scenario.planner.cruise_m_s <= 5.0


def test_fleets_that_do_not_know_their_places_exactly_have_room_for_that(tmp_path: Path) -> None:
    for seed in range(15):
        path = tmp_path / f"{seed}.yaml"
        path.write_text(yaml.safe_dump(family("accuracy", seed), sort_keys=False))
        assert [warning.text for warning in warnings(load(path)) if warning.about == "accuracy"] == []


def test_where_an_obstacle_stands_on_the_pad_there_is_no_base(tmp_path: Path) -> None:
    path = tmp_path / "scenario.yaml"
    path.write_text(yaml.safe_dump(family("silence", 4012201166), sort_keys=False))
    assert load(path).bases == ()


@pytest.mark.parametrize("name", FAMILIES)
def test_a_scenario_is_plain_data_and_the_same_again(name: str) -> None:
    one, again, other = family(name, 3), family(name, 3), family(name, 4)
    assert json.loads(json.dumps(one)) == again
    assert one != {**other, "name": one["name"], "seed": 3}


def test_unknown_families_and_seeds_are_refused() -> None:
    with pytest.raises(ValueError, match="one of tracking"):
        family("squares", 1)
    with pytest.raises(ValueError, match="at least 0"):
        family("circles", -1)
