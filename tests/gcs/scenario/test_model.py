"""gcs.scenario.model: the demo as it ships, what is refused and with which sentence, and the round trip."""

import math
import re
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import ValidationError
from scenarios import PAPER_OBSTACLES, SMALL, changed, loaded, refusal

from gcs.scenario import file
from gcs.scenario.file import dump, load
from gcs.scenario.model import Obstacle, Scenario, ScenarioError
from gcs.scenario.types import Part
from skytender.vehicle.parameters import TABLE

DEMO = file.find("demo").read_text(encoding="utf-8")


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "s.yaml"


def test_the_demo_holds_what_it_promises() -> None:
    demo = load(file.find("demo"))
    assert [pursuer.sysid for pursuer in demo.vehicles.pursuers] == [1, 2, 3, 4, 5]
    assert [pursuer.battery.initial_percent for pursuer in demo.vehicles.pursuers] == [66, 62, 55, 57, 55]
    assert {pursuer.battery.capacity_j for pursuer in demo.vehicles.pursuers} == {24_000}
    assert [vehicle.sysid for vehicle in demo.vehicles.all] == [1, 2, 3, 4, 5, 101, 201]
    assert [obstacle.point_m for obstacle in demo.obstacles] == [(x, -y, -z) for x, y, z in PAPER_OBSTACLES]
    assert len(demo.traffic) == 2
    assert demo.goal.refuelled_at_least == 3
    assert (demo.clock.mode, demo.clock.speed) == ("real", 5)


def test_paper_axes_become_ned_by_half_a_turn_about_north(path: Path) -> None:
    text = changed(SMALL, "axes: ned", "axes: paper").replace("-3]", "3]").replace("-6]", "6]")
    text = changed(
        text, "sysid: 1, start_m: [0, 0, 0]",
        "sysid: 1, start_m: [0, 1, 2], airborne: true, velocity_m_s: [1, 2, 3], attitude_deg: [10, 20, 30]",
    )  # fmt: skip
    text += "  tankers: [{sysid: 4, start_m: [0, 50, 0], home_m: [1, 2, 9], battery: {capacity_j: 20000}}]\n"
    text += "traffic: [{callsign: T, path_m: [[1, 2, 3]], speed_m_s: 1}]\n"
    text += "obstacles:\n  - {cylinder_m: [30, 31], radius_m: 1, bottom_m: 0, top_m: 4}\n"
    text += "  - {box_m: [[30, 1, 2], [40, 5, 3]]}\n  - {sphere_m: [50, 1, 2], radius_m: 2}\n"
    scenario = loaded(path, text)
    first = scenario.vehicles.pursuers[0]
    assert scenario.axes == "ned"
    assert (first.start_m, first.velocity_m_s, first.attitude_deg) == ((0, -1, -2), (1, -2, -3), (10, -20, -30))
    assert scenario.vehicles.targets[0].path_m == ((1, -2, -3), (4, -5, -6))
    assert scenario.vehicles.tankers[0].home_m == (1, -2, -9)
    assert scenario.traffic[0].path_m == ((1, -2, -3),)
    cylinder, box, sphere = scenario.obstacles
    assert (cylinder.kind, (cylinder.low_m, cylinder.high_m), cylinder.radius_m) == (
        "cylinder",
        ((30, -31, -4), (30, -31, 0)),
        1,
    )
    assert (box.kind, (box.low_m, box.high_m), box.radius_m) == ("box", ((30, -5, -3), (40, -1, -2)), 0)
    assert (sphere.kind, (sphere.low_m, sphere.high_m), sphere.radius_m) == ("sphere", ((50, -1, -2), (50, -1, -2)), 2)
    assert loaded(path, dump(scenario)) == scenario


def test_ned_axes_stay_as_they_are_and_only_a_file_may_be_in_others(path: Path) -> None:
    assert loaded(path, SMALL).vehicles.targets[0].path_m == ((1, 2, -3), (4, 5, -6))
    with pytest.raises(ValidationError, match="only a file is converted"):
        Scenario.model_validate({**yaml.safe_load(SMALL), "axes": "paper"})


# Obstacles: distances worked out by hand


@pytest.mark.parametrize(
    ("obstacle", "point", "clearance_m"),
    [
        (Obstacle(point_m=(1, 2, 3)), (1, 5, 7), 5),
        (Obstacle(sphere_m=(0, 0, 0), radius_m=2), (3, 4, 0), 3),
        (Obstacle(sphere_m=(0, 0, 0), radius_m=2), (0.5, 0, 0), -1.5),
        (Obstacle(box_m=((1, 1, 1), (-1, -1, -1))), (4, 5, 0), 5),
        (Obstacle(box_m=((1, 1, 1), (-1, -1, -1))), (0.75, 0, 0), -0.25),
        (Obstacle(box_m=((1, 1, 1), (-1, -1, -1))), (1, 0, 0), 0),
        (Obstacle(cylinder_m=(0, 0), radius_m=1, bottom_m=0, top_m=-4), (3, 4, -2), 4),
        (Obstacle(cylinder_m=(0, 0), radius_m=1, bottom_m=0, top_m=-4), (0, 0, -6), 2),
        (Obstacle(cylinder_m=(0, 0), radius_m=1, bottom_m=0, top_m=-4), (4, 0, -8), 5),
        (Obstacle(cylinder_m=(0, 0), radius_m=1, bottom_m=0, top_m=-4), (0.75, 0, -2), -0.25),
        (Obstacle(cylinder_m=(0, 0), radius_m=1, bottom_m=0, top_m=-4), (0, 0, -3.5), -0.5),
    ],
)
def test_clearance_is_the_signed_distance_to_the_surface(
    obstacle: Obstacle, point: tuple[float, float, float], clearance_m: float
) -> None:
    assert obstacle.clearance_m(point) == pytest.approx(clearance_m, abs=1e-12)


# What is refused, with its place


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("capture_m:", "captre_m:", "unknown key 'captre_m' in refuelling; did you mean 'capture_m'?"),
        ("avionics_w: 10", "avionic_w: 10", "in vehicles.defaults.battery; did you mean 'avionics_w'?"),
        ("p: 2.0", "p: .nan", "competition.p must be a finite number, not .nan"),
        ("p: 2.0", "p: 1e999", "competition.p must be a finite number, not .inf"),
        ("p: 2.0", "p: two", "competition.p must be a number, not the text 'two'"),
        ("p: 2.0", "p: 1:30", "competition.p must be a number, not the text '1:30'"),
        ("p: 2.0", "p: true", "competition.p must be a number, not true"),
        ("p: 2.0", "p: 0.5", "competition.p must be greater than or equal to 1, not 0.5"),
        ("p: 2.0", "p:", "competition.p is left empty"),
        ("escape: true", "escape: on", "planner.escape must be true or false, not the text 'on'"),
        ("laps: 4", "laps: 4.5", "laps must be a whole number, not 4.5"),
        ("seed: 1", f"seed: {'9' * 5000}", "seed must be a whole number, not .inf"),
        ("name: demo", "name: a/b", "name must match pattern"),
        ("axes: paper", "axes: papper", "axes must be 'paper' or 'ned', not the text 'papper'; did you mean 'paper'?"),
        ("sysid: 3", "sysid: 255", "vehicles.pursuers[2].sysid must be less than or equal to 254, not 255"),
        ("[1.0, 2.0, 1.5]", "[1.0, 2.0]", "obstacles[0].point_m needs more numbers: it has 2"),
        ("[1.0, 2.0, 1.5]", "[1.0, high, 1.5]", "obstacles[0].point_m[1] must be a number, not the text 'high'"),
        ("\nvehicles:", "\nvehicels:", "unknown key 'vehicels' at the top level; did you mean 'vehicles'?"),
        ("point_m: [1.0", "pont_m: [1.0", "unknown key 'pont_m' in obstacles[0]; did you mean 'point_m'?"),
        ("mode: real", "epoch: 2026-01-01", "clock.epoch must state its time zone"),
        ("battery: {capacity_j: 60000}", "battery: [1]", "targets[0].battery must be a block of keys, not a list"),
        ("speed_m_s: 5", "params: {'A B': 1}", "tankers[0].params.A B is not named as it must be"),
    ],
)
def test_one_wrong_value_is_one_sentence_at_its_place(path: Path, old: str, new: str, sentence: str) -> None:
    text = changed(DEMO, old, new)
    said = refusal(path, text)
    assert sentence in said
    assert len(said.splitlines()) == 1
    line = int(re.match(r"s\.yaml:(\d+):\d+: ", said).group(1))  # type: ignore[union-attr]
    first = text[: DEMO.index(old)].count("\n") + 1
    assert first <= line <= first + new.count("\n")


@pytest.mark.parametrize(
    ("asked", "sentence"),
    [
        ({"speed": -1.0}, "clock.speed must be greater than 0, not -1.0"),
        ({"speed": math.nan}, "clock.speed must be a finite number, not .nan"),
        ({"seed": -3}, "seed must be greater than or equal to 0, not -3"),
        ({"seed": 1.5}, "seed must be a whole number, not 1.5"),
    ],
)
def test_a_clock_or_seed_that_cannot_be_had_is_one_sentence(path: Path, asked: dict[str, Any], sentence: str) -> None:
    path.write_text(SMALL)
    with pytest.raises(ValueError, match=f"^{re.escape(sentence)}$"):
        load(path).flown(**asked)


def test_every_problem_stands_at_its_own_line_and_column(path: Path) -> None:
    assert refusal(path, SMALL + "planner: {b: 1, k0: 0, kk: 0}\n").splitlines() == [
        "s.yaml:12:14: planner.b must be less than 1, not 1",
        "s.yaml:12:21: planner.k0 must be greater than 0, not 0",
        "s.yaml:12:24: unknown key 'kk' in planner",
    ]


def test_a_missing_key_is_named_with_its_choices(path: Path) -> None:
    assert refusal(path, changed(SMALL, "axes: ned\n", "")) == (
        "s.yaml:1:1: the scenario lacks the key 'axes' (paper or ned)"
    )
    assert refusal(path, changed(SMALL, "sysid: 2, ", "")) == "s.yaml:9:7: vehicles.pursuers[1] lacks the key 'sysid'"


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("sysid: 2", "sysid: 1", "s.yaml:9:15: the sysid 1 is given twice (see line 8)"),
        ("sysid: 3", "sysid: 1", "s.yaml:11:15: the sysid 1 is given twice (see line 8)"),
        ("sysid: 2", "sysid: 2, target: 7", "s.yaml:9:26: pursuer 2 follows 7, which is no target's sysid"),
        ("[5, 0, 0]", "[0.1, 0, 0]", "s.yaml:9:27: pursuer 2 starts 0.10 m from pursuer 1, below planner.separation_m"),
        ("[5, 0, 0]", "[5, 0, 1]", "pursuer 2 starts below the ground"),
        ("sysid: 2", "sysid: 2, velocity_m_s: [1, 0, 0]", "pursuer 2 moves on the ground"),
        ("sysid: 2", "sysid: 2, join_s: 10", "pursuer 2 would join after the end"),
        ("speed_m_s: 1", "speed_m_s: 1, laps: 2", "more than one lap needs 'closed: true'"),
        ("[[1, 2, -3], [4, 5, -6]]", "[[1, 2, -3]], closed: true", "a closed path needs at least 2 points"),
        ("[4, 5, -6]", "[1, 2, -3]", "path_m repeats a point"),
        ("[4, 5, -6]]", "[4, 5, -6], [1, 2, -3]], closed: true", "s.yaml:11:100: path_m repeats a point"),
        ("path_m: [[1, 2, -3], [4, 5, -6]]", "path_m: []", "path_m must have at least 1 item, not 0"),
        ("{duration_s: 10}", "{duration_s: 10, refuelled_at_least: 1}", "needs a pursuer, a tanker or a base"),
        ("name: small", "clock: {period_s: 0.03}\nname: small", "period_s must be a multiple of 0.004 s"),
        ("name: small", "competition: {floor: 1}\nname: small", "s.yaml:2:22: floor must be below high"),
        ("name: small", "refuelling: {height_m: 1.5}\nname: small", "height_m must be below capture_m"),
        ("name: small", "radio: {blackouts: [{sysid: 9, from_s: 1, to_s: 2}]}\nname: small", "there is no vehicle 9"),
        ("name: small", "obstacles: [{sphere_m: [5, 0, -2], radius_m: 1.8}]\nname: small",
         "s.yaml:10:27: pursuer 2 starts inside or within 0.3 m of the obstacle sphere 1 (see line 2)"),
        ("name: small", "obstacles: [{name: mast, point_m: [5, 0, 0.2]}]\nname: small",
         "pursuer 2 starts inside or within 0.3 m of the obstacle mast (see line 2)"),
        ("name: small", "obstacles: [{name: x}]\nname: small", "needs exactly one of point_m, box_m, sphere_m, cyl"),
        ("name: small", "obstacles: [{sphere_m: [50, 0, 0]}]\nname: small", "a sphere needs radius_m"),
        ("name: small", "obstacles: [{box_m: [[1, 2, 3], [4, 5, 3]]}]\nname: small", "corners that differ in each"),
        ("name: small", "obstacles: [{point_m: [50, 0, 0], top_m: 1}]\nname: small", "a point has no top_m"),
        ("name: small", "obstacles: [{cylinder_m: [50, 0], radius_m: 1, bottom_m: 0, top_m: 4}]\nname: small",
         "a cylinder's top_m must lie above its bottom_m"),
    ],
)  # fmt: skip
def test_values_that_do_not_go_together_are_refused_in_place(path: Path, old: str, new: str, said: str) -> None:
    assert said in refusal(path, changed(SMALL, old, new))


@pytest.mark.parametrize(
    ("radio", "said"),
    [
        ("{delay_s: 0.2}", ""),
        ("{jitter_s: 0.3}", ""),
        ("{delay_s: 0.2, jitter_s: 0.1}", "refuelling needs delay_s + jitter_s / 2 of at most 0.2 s, not 0.25: "),
        ("{delay_s: 3}", "transfers break off after 1 s of silence; or set 'refuelling: {enabled: false}'"),
    ],
)
def test_a_radio_too_slow_for_any_transfer_is_refused_where_somebody_is_refuelled(
    path: Path, radio: str, said: str
) -> None:
    with_radio = SMALL + f"radio: {radio}\n"
    loaded(path, with_radio)  # nobody is refuelled
    tanker = "  tankers: [{sysid: 9, start_m: [20, 0, 0], battery: {capacity_j: 90000}}]\n"
    refuelled = changed(with_radio, "radio:", f"{tanker}radio:")
    if said:
        assert said in refusal(path, refuelled)
        loaded(path, refuelled + "refuelling: {enabled: false}\n")
    else:
        loaded(path, refuelled)


def test_starts_may_lie_outside_the_margin_or_be_shared_one_after_the_other(path: Path) -> None:
    loaded(path, SMALL + "obstacles: [{point_m: [5, 0, -0.31]}]\n")
    loaded(path, changed(SMALL, "sysid: 2, start_m: [5, 0, 0]", "sysid: 2, join_s: 5, start_m: [0, 0, 0]"))


@pytest.mark.parametrize("without", ["pursuers", "targets"])
def test_goal_and_ring_need_the_vehicles_that_they_are_about(path: Path, without: str) -> None:
    content = yaml.safe_load(DEMO)
    del content["vehicles"][without]
    said = refusal(path, yaml.safe_dump(content))
    assert "pursue needs a pursuer and a target" in said
    assert ("a formation needs a target" in said) == (without == "targets")


def test_a_scenario_without_vehicles_is_refused(path: Path) -> None:
    assert "at least one vehicle" in refusal(path, SMALL[: SMALL.index("vehicles:")] + "vehicles: {}\n")


def test_defaults_fill_what_a_vehicle_does_not_say(path: Path) -> None:
    text = SMALL.replace(", battery: {capacity_j: 1000}", "").replace("sysid: 2,", "sysid: 2, battery: {hover_w: 99},")
    text = changed(text, "vehicles:\n", "vehicles:\n  defaults: {takeoff_m: 4, battery: {capacity_j: 7, hover_w: 8}}\n")
    vehicles = loaded(path, text).vehicles.all
    assert [(vehicle.battery.capacity_j, vehicle.battery.hover_w) for vehicle in vehicles] == [(7, 8), (7, 99), (7, 8)]
    assert {vehicle.takeoff_m for vehicle in vehicles} == {4}


def test_a_mistake_in_the_defaults_is_reported_once_and_there(path: Path) -> None:
    text = changed(SMALL, "vehicles:\n", "vehicles:\n  defaults: {takeof_m: 4}\n")
    assert refusal(path, text) == (
        "s.yaml:7:14: unknown key 'takeof_m' in vehicles.defaults; did you mean 'takeoff_m'?"
    )
    assert "must be a block of keys" in refusal(path, changed(SMALL, "vehicles:\n", "vehicles:\n  defaults: [1]\n"))


def test_a_small_scenario_has_the_documented_defaults_and_is_frozen(path: Path) -> None:
    scenario = loaded(path, SMALL)
    assert scenario.clock.epoch == datetime(2026, 1, 1, tzinfo=UTC)
    assert (scenario.clock.mode, scenario.clock.speed, scenario.clock.period_s) == ("real", 1, 0.1)
    assert (scenario.seed, scenario.truth, scenario.planner.escape, scenario.competition.rate) == (1, True, True, 20)
    assert scenario.vehicles.pursuers[0].label == "pursuer 1"
    assert isinstance(scenario.vehicles.pursuers[0].start_m[0], float), "written as a whole number"
    with pytest.raises(ValidationError, match="frozen"):
        scenario.seed = 2


def test_the_json_schema_knows_every_key_of_the_demo() -> None:
    schema = Scenario.model_json_schema()
    assert set(yaml.safe_load(DEMO)) <= set(schema["properties"])
    assert "defaults" in schema["$defs"]["Vehicles"]["properties"]
    assert {"axes", "schema", "name", "origin", "goal", "vehicles"} == set(schema["required"])


def test_the_demo_survives_a_round_trip(path: Path) -> None:
    demo = load(file.find("demo"))
    text = dump(demo)
    assert "axes: ned" in text
    assert loaded(path, text) == demo


coordinates = st.floats(-1e4, 1e4)
vectors = st.tuples(coordinates, coordinates, coordinates)
above, below, thin = st.floats(-9, -2), st.floats(-1, 0), st.floats(1e-6, 0.1)
obstacles = st.one_of(
    st.builds(Obstacle, name=st.sampled_from([None, "on", "1e5", "né"]), point_m=vectors),
    st.builds(Obstacle, sphere_m=vectors, radius_m=thin),
    st.builds(Obstacle, box_m=st.tuples(vectors, vectors.map(lambda v: (v[0] + 3e4, v[1] + 3e4, v[2] + 3e4)))),
    st.builds(Obstacle, cylinder_m=st.tuples(coordinates, coordinates), radius_m=thin, bottom_m=below, top_m=above),
)
parameters = st.sampled_from([row for row in TABLE if not row.name.startswith("SIM_BAT_")]).flatmap(
    lambda row: st.tuples(st.just(row.name), st.floats(row.least, row.most))
)
changes = st.fixed_dictionaries(
    {
        "obstacles": st.lists(obstacles, max_size=3),
        "description": st.text(st.characters(exclude_categories=["Cs"]), max_size=30),
        "clock": st.fixed_dictionaries({"speed": st.floats(1e-3, 1000), "epoch": st.datetimes(
            datetime(1971, 1, 1), datetime(2199, 1, 1), timezones=st.just(UTC))}),
        "vehicles": st.fixed_dictionaries({"pursuers": st.tuples(st.fixed_dictionaries({
            "sysid": st.integers(1, 254), "start_m": st.just([5e4, 0, 0]), "battery": st.just({"capacity_j": 1}),
            "params": st.lists(parameters, max_size=3).map(dict)}))}),
    }
)  # fmt: skip


@settings(max_examples=25)
@given(change=changes)
def test_what_is_dumped_is_loaded_equal(tmp_path_factory: pytest.TempPathFactory, change: dict[str, Any]) -> None:
    scenario = Scenario.model_validate({**yaml.safe_load(SMALL), **change})
    assert loaded(tmp_path_factory.getbasetemp() / "round.yaml", dump(scenario)) == scenario


@settings(max_examples=60)
@given(data=st.data())
def test_no_damage_to_the_demo_ends_in_anything_but_a_scenario_error(
    tmp_path_factory: pytest.TempPathFactory, data: st.DataObject
) -> None:
    lines = DEMO.splitlines()
    start = data.draw(st.integers(0, len(lines) - 1))
    line = lines[start]
    at = data.draw(st.integers(0, len(line)))
    graft = data.draw(
        st.sampled_from(["", " ", ":", "- ", "[", "}", "'", "#", ".nan", "-1", "null", "{a: 1}", "é", "\0"])
    )
    lines[start] = line[:at] + graft + line[at + data.draw(st.integers(0, 5)) :]
    path = tmp_path_factory.getbasetemp() / "damaged.yaml"
    path.write_text("\n".join(lines), encoding="utf-8")
    try:
        load(path)
    except ScenarioError as error:
        said = str(error)
        assert said.startswith(str(path)), said


def test_parts_that_a_scenario_leaves_out_are_what_their_validators_make_of_nothing() -> None:
    defaults = {name: field.default for name, field in Scenario.model_fields.items() if isinstance(field.default, Part)}
    assert len(defaults) >= 10
    for name, default in defaults.items():
        assert default == type(default)(), name
