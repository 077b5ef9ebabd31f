"""Changes of obstacles, attractors and targets' paths: what they make of a scenario, and what is refused."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

from gcs.scenario.model import Scenario
from gcs.scenario.parts import world
from gcs.scenario.parts.world import Worlds

SOLIDS: list[dict[str, Any]] = [
    {"point_m": [1, 2, -3]},
    {"name": "ball", "sphere_m": [4, 0, -5], "radius_m": 0.5},
    {"box_m": [[0, 8, 0], [2, 10, -4]]},
    {"cylinder_m": [-6, -6], "radius_m": 1.0, "bottom_m": 0, "top_m": -8},
]


def scenario(**changes: Any) -> Scenario:
    battery = {"capacity_j": 60000}
    target = {
        "sysid": 101,
        "battery": battery,
        "start_m": [0, 20, 0],
        "speed_m_s": 0.8,
        "path_m": [[0, 20, -3], [8, 20, -3]],
    }
    content: dict[str, Any] = {
        "schema": 1,
        "name": "changing",
        "axes": "ned",
        "origin": {"lat_deg": 47.4, "lon_deg": 8.5, "alt_m": 488},
        "goal": {"duration_s": 20},
        "vehicles": {"pursuers": [{"sysid": 1, "battery": battery, "start_m": [0, 30, 0]}], "targets": [target]},
        "obstacles": SOLIDS,
        **changes,
    }
    return Scenario.model_validate(content)


def test_a_body_that_is_moved_keeps_its_shape() -> None:
    before, at, points = scenario(), np.array([30.0, -20.0, -10.0]), np.random.default_rng(5).uniform(-9, 9, (50, 3))
    for which in range(len(SOLIDS)):
        after = world.changed(before, world.move(before, "obstacle", which, at))
        old, new = before.obstacles[which], after.obstacles[which]
        assert world.middle(new) == pytest.approx(at)
        by = at - world.middle(old)
        for point in points:
            assert new.clearance_m((*(point + by),)) == pytest.approx(old.clearance_m((*point,)))
        others = [one for place, one in enumerate(after.obstacles) if place != which]
        assert [world.middle(one) for one in others] == [
            world.middle(one) for place, one in enumerate(before.obstacles) if place != which
        ]
    level = world.changed(before, world.move(before, "obstacle", "ball", (0.0, 1.0)))
    assert level.obstacles[1].sphere_m == (0.0, 1.0, -5.0)


def test_names_stay_when_others_go() -> None:
    made = scenario()
    made = world.changed(made, world.removal(made, "obstacle", 0))
    made = world.changed(made, world.addition(made, "obstacle", {"sphere_m": np.array([0, 0, -9]), "radius_m": 1}))
    names = [one.name for one in made.obstacles]
    assert names == ["ball", "box 3", "cylinder 4", "sphere 4"]
    made = world.changed(made, world.addition(made, "attractor", {"point_m": (0, 0, -5)}))
    made = world.changed(made, world.move(made, "attractor", "attractor 1", (1, 1, -1)))
    assert made.attractors[0].point_m == (1.0, 1.0, -1.0)


def test_a_change_goes_through_json() -> None:
    made = scenario()
    for change in (
        world.move(made, "obstacle", "cylinder 4", (0.1, 0.2, -1.3)),
        world.addition(made, "obstacle", {"box_m": [(50, 50, -1), (51, 51, -2)]}),
        world.removal(made, "obstacle", -1),
        world.new_path(made, 101, np.eye(3), closed=True, laps=3, speed_m_s=None),
    ):
        assert world.changed(made, json.loads(json.dumps(change))) == world.changed(made, change)
    target = world.changed(made, change).vehicles.targets[0]
    assert (target.closed, target.laps, target.speed_m_s, len(target.path_m)) == (True, 3, 0.8, 3)


def test_what_makes_no_sense_is_one_sentence() -> None:
    made, still = scenario(), {"closed": False, "laps": 1, "speed_m_s": None}
    twice = scenario(obstacles=[{**SOLIDS[1]}, {**SOLIDS[1], "sphere_m": [0, 0, -9]}])
    for ask, sentence in (
        (lambda: world.move(made, "obstacle", "bal", (0, 0)), r"no obstacle 'bal' .* did you mean 'ball'"),
        (lambda: world.move(made, "obstacle", 4, (0, 0)), "there is no obstacle 4 in this session: it has point 1, "),
        (lambda: world.move(made, "obstacle", 1.5, (0, 0)), "1.5 is no obstacle: give its name or its index"),
        (lambda: world.move(made, "obstacle", 0, (0, np.nan)), "is no place: give"),
        (lambda: world.move(made, "obstacle", 0, 7.0), "is no place: give"),
        (lambda: world.move(made, "obstacle", 0, (0, 1e9)), "must be less than or equal to 100000"),
        (lambda: world.move(made, "attractor", 0, (0, 0)), "there is no attractor 0 in this session: it has none"),
        (lambda: world.removal(twice, "obstacle", "ball"), "2 obstacles are named 'ball': give one's index"),
        (lambda: world.addition(made, "obstacle", {"sphere_m": (0, 0, 0)}), "a sphere needs radius_m"),
        (lambda: world.addition(made, "obstacle", {"spere_m": (0, 0, 0)}), "did you mean 'sphere_m'"),
        (lambda: world.addition(made, "obstacle", (0, 0, 0)), "an obstacle is a block of keys"),
        (lambda: world.addition(made, "obstacle", SOLIDS[1]), "named 'ball' already"),
        (lambda: world.new_path(made, 1, [(0, 0, 0)], **still), "vehicle 1 is no target"),
        (lambda: world.new_path(made, 101, [(0, 0)], **still), "path_m is a list of places"),
        (lambda: world.new_path(made, 101, [(0, 0, 0), (0, 0, 0)], **still), "repeats a point"),
        (lambda: world.new_path(made, 101, [(0, 0, 0)], closed=True, laps=1, speed_m_s=None), "at least 2 points"),
        (lambda: world.changed(made, {"change": "moved"}), "is no change of the world"),
    ):
        with pytest.raises(ValueError, match=sentence):
            ask()


def test_an_obstacle_on_a_base_or_a_vehicle_is_refused() -> None:
    base = scenario(bases=[{"name": "pad", "position_m": [20, 20, 0], "stock_j": 1000}])
    on_base = world.move(base, "obstacle", "ball", (20.2, 20.0, 0.0))
    with pytest.raises(ValueError, match=r"the base pad lies inside or within 0\.3 m of the obstacle ball"):
        world.changed(base, on_base)
    made = scenario()
    change = world.move(made, "obstacle", "ball", (4.0, 3.0))
    assert world.meets(made, change, {"pursuer 1": (4.0, 3.79, -5.0)}).endswith("within 0.3 m of pursuer 1")
    assert world.meets(made, change, {"pursuer 1": (4.0, 3.81, -5.0)}) == ""
    assert world.meets(made, world.removal(made, "obstacle", "ball"), {"pursuer 1": (4.0, 0.0, -5.0)}) == ""


def test_worlds_hold_from_their_time_on() -> None:
    worlds = Worlds(scenario(obstacles=[]))
    first = worlds.now
    worlds.change(2.0, world.addition(first, "obstacle", SOLIDS[1]))
    worlds.change(2.0, world.move(worlds.now, "obstacle", 0, (9, 9)))
    worlds.change(5.0, world.removal(worlds.now, "obstacle", 0))
    counts = {t_s: len(worlds.at(t_s).obstacles) for t_s in (0.0, 1.9, 2.0, 4.9, 5.0, 9.0)}
    assert counts == {0.0: 0, 1.9: 0, 2.0: 1, 4.9: 1, 5.0: 0, 9.0: 0}
    assert worlds.at(2.0).obstacles[0].sphere_m == (9.0, 9.0, -5.0)
    assert worlds.judged.obstacles, "the goal's clearance is judged once there was an obstacle"
    records = [{"kind": "world", "t_s": 3.0, "change": "turned"}, {"kind": "death", "t_s": 3.0}]
    assert len(Worlds.recorded(first, records)) == 1
