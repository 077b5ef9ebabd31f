"""The paper's examples as they ship (docs/model/examples.md#paper-examples), and the keys of a scenario that they
need."""

from pathlib import Path

import numpy as np
import pytest
import yaml
from scenarios import PAPER_OBSTACLES, SMALL, changed, loaded, refusal

from gcs.scenario import file
from gcs.scenario.file import dump, load
from gcs.scenario.model import Scenario

PAPER_SPEEDS = [(0, 0, 0), (1, 3, 2), (2, 2, 2), (1, 3, 6), (1, 2, 4)]
PAPER_STARTS = [(0, 5, 0), (0, 0, 0), (0, -5, 0)]
PAPER_CASES = {  # docs/model/examples.md#paper-examples
    "example1": [((0, 0, 0), v) for v in PAPER_SPEEDS],
    "example2": [(p, (1, 1, 1)) for p in PAPER_STARTS],
    "example3": [(p, v) for p in PAPER_STARTS for v in PAPER_SPEEDS],
    "example4": [((0, 0, 0), v) for v in PAPER_SPEEDS],
}


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "s.yaml"


@pytest.mark.parametrize("name", PAPER_CASES)
def test_the_papers_examples_are_what_the_paper_says(name: str) -> None:
    made = load(file.find(f"paper/{name}"))
    assert [obstacle.point_m for obstacle in made.obstacles] == [(x, -y, -z) for x, y, z in PAPER_OBSTACLES]
    flown = made.vehicles.pursuers
    assert [(p.start_m, p.velocity_m_s) for p in flown] == [
        ((x, -y, -z), (u, -v, -w)) for (x, y, z), (u, v, w) in PAPER_CASES[name]
    ]
    for pursuer in flown:
        assert np.radians(pursuer.attitude_deg) == pytest.approx([1.0, -1.0, -1.0], abs=1e-15)
        assert pursuer.waypoints_m == ((5.0, -5.0, -1.5), (10.0, -10.0, -3.0))
        assert pursuer.params == {"SIM_GAIN_SET": 1}
        assert pursuer.airborne
    rules = made.planner
    assert (rules.k0, rules.k1, rules.a, rules.b, rules.step_m) == (15.0, 2.0, 0.5, 0.5, 0.1)
    assert (rules.attraction_range_m, rules.repulsion_range_m, rules.vehicles_repel) == (1.0, 1.0, False)
    assert loaded_again(made) == made


@pytest.mark.parametrize(("name", "like", "gain_set"), [("energy", "example4", 1), ("literal", "example1", 2)])
def test_the_kin_of_an_example_fly_its_cases(name: str, like: str, gain_set: int) -> None:
    kin, example = (load(file.find(f"paper/{each}")) for each in (f"{like}-{name}", like))
    assert kin.obstacles == example.obstacles
    for a, b in zip(kin.vehicles.pursuers, example.vehicles.pursuers, strict=True):
        assert (a.start_m, a.velocity_m_s, a.attitude_deg, a.waypoints_m) == (
            b.start_m,
            b.velocity_m_s,
            b.attitude_deg,
            b.waypoints_m,
        )
        assert a.params == {"SIM_GAIN_SET": gain_set}
    assert (kin.competition.bids, kin.competition.p, kin.competition.rate) == ("effort", 2.0, 1.0) or name == "literal"
    assert kin.planner.full_steps == (name == "literal")


def test_whole_steps_need_planned_points_as_they_are(path: Path) -> None:
    text = SMALL + "planner: {full_steps: true}\n"
    assert "full_steps needs 'safety: false'" in refusal(path, text)
    assert loaded(path, changed(text, "full_steps: true", "full_steps: true, safety: false")).planner.full_steps


def loaded_again(made: Scenario) -> Scenario:
    return Scenario.model_validate(yaml.safe_load(dump(made)))


def test_way_points_take_the_place_of_a_target(path: Path) -> None:
    text = changed(SMALL, "{sysid: 1,", "{sysid: 1, waypoints_m: [[1, 2, -3]],")
    made = loaded(path, text)
    assert [made.vehicles.target_of(p) for p in made.vehicles.pursuers] == [None, 3]
    assert "has waypoints_m and a target" in refusal(path, changed(text, "{sysid: 1,", "{sysid: 1, target: 3,"))


def test_one_start_for_two_is_refused_unless_each_is_as_if_alone(path: Path) -> None:
    text = changed(SMALL, "start_m: [5, 0, 0]", "start_m: [0, 0, 0]")
    assert "below planner.separation_m" in refusal(path, text)
    assert not loaded(path, text + "planner: {vehicles_repel: false}\n").planner.vehicles_repel


def test_a_competition_for_targets_needs_some(path: Path) -> None:
    assert loaded(path, SMALL + "pursuit: {by: competition}\n").pursuit.by == "competition"
    without = SMALL[: SMALL.index("  targets:")]
    assert "needs a pursuer and a target" in refusal(path, without + "pursuit: {by: competition}\n")


def test_attractors_are_turned_from_the_papers_axes(path: Path) -> None:
    text = changed(SMALL, "axes: ned", "axes: paper")
    text = changed(text, "path_m: [[1, 2, -3], [4, 5, -6]]", "path_m: [[1, 2, 3], [4, 5, 6]]")
    made = loaded(path, text + "attractors:\n  - {point_m: [1, 2, 3], range_m: 2}\n")
    assert made.attractors[0].point_m == (1.0, -2.0, -3.0)
    assert made.attractors[0].range_m == 2.0
