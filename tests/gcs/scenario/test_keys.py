"""Key paths: what they set, and what is said of those that name nothing."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml

import gcs
from gcs.scenario import keys
from gcs.scenario.file import find, load
from gcs.scenario.model import ScenarioError

DEMO = find("demo")


def told(**settings: Any) -> str:
    with pytest.raises(ScenarioError) as refused:
        load(DEMO, set=settings)
    return str(refused.value)


def test_a_path_sets_one_value_and_nothing_else() -> None:
    changed = gcs.load(DEMO, set={"planner.cruise_m_s": 2.5})
    before = load(DEMO)
    assert changed.planner.cruise_m_s == 2.5
    assert changed.model_copy(update={"planner": before.planner}) == before


def test_a_set_value_is_as_if_it_stood_in_the_file(tmp_path: Path) -> None:
    content = yaml.safe_load(DEMO.read_text(encoding="utf-8"))
    content["vehicles"]["pursuers"][1]["start_m"] = [0.7, -1.2, 0.0]
    content["radio"] = {"loss": 0.2}
    path = tmp_path / "changed.yaml"
    path.write_text(yaml.safe_dump(content), encoding="utf-8")
    assert load(DEMO, set={"vehicles.pursuers[1].start_m": [0.7, -1.2, 0.0], "radio.loss": 0.2}) == load(path)


def test_a_star_means_each_and_inherited_keys_stay() -> None:
    pursuers = load(DEMO, set={"vehicles.pursuers.*.battery.initial_percent": 60}).vehicles.pursuers
    assert [(p.battery.initial_percent, p.battery.capacity_j) for p in pursuers] == [(60, 24000)] * 5


def test_positions_count_from_zero_and_later_settings_win() -> None:
    both = {"vehicles.pursuers.*.battery.initial_percent": 60, "vehicles.pursuers.4.battery.initial_percent": 50}
    pursuers = load(DEMO, set=both).vehicles.pursuers
    assert [p.battery.initial_percent for p in pursuers] == [60, 60, 60, 60, 50]


def test_a_number_within_a_place_can_be_set_and_is_in_the_axes_of_the_file() -> None:
    start = load(DEMO, set={"vehicles.tankers[0].start_m[1]": 2.0}).vehicles.tankers[0].start_m
    assert start == (-4.0, -2.0, 0.0)  # the demo is in paper axes: y is west


def test_vehicles_of_a_grid_are_addressed_one_by_one() -> None:
    fleet = load(find("fleet"), set={"vehicles.pursuers.7.battery.initial_percent": 33})
    percents = [p.battery.initial_percent for p in fleet.vehicles.pursuers]
    assert percents[7] == 33
    assert percents.count(33) == 1


def test_null_takes_a_key_out_and_defaults_hold_again() -> None:
    assert load(DEMO, set={"goal.pursue": None}).goal.pursue is None


def test_defaults_of_vehicles_can_be_set() -> None:
    pursuers = load(DEMO, set={"vehicles.defaults.battery.hover_w": 150}).vehicles.pursuers
    assert {p.battery.hover_w for p in pursuers} == {150}


def test_a_block_given_in_short_can_be_set_into(tmp_path: Path) -> None:
    content = yaml.safe_load(DEMO.read_text(encoding="utf-8")) | {"competition": "optimal"}
    path = tmp_path / "short.yaml"
    path.write_text(yaml.safe_dump(content), encoding="utf-8")
    rules = load(path, set={"competition.need_from": 0.4}).competition
    assert (rules.policy, rules.need_from) == ("optimal", 0.4)


@pytest.mark.parametrize(
    ("key", "value", "sentence"),
    [
        ("planner.crise_m_s", 1, "unknown key 'crise_m_s' in planner; did you mean 'cruise_m_s'?"),
        ("cruise_m_s", 1, "unknown key 'cruise_m_s' at the top level; did you mean 'planner.cruise_m_s'?"),
        ("vehicles.bases.*.name", "a", "unknown key 'bases' in vehicles; did you mean 'bases.*.name'?"),
        ("vehicles.pursuers.9.sysid", 3, "there is no vehicles.pursuers[9]: vehicles.pursuers has 5, counted from 0"),
        ("bases.*.stock_j", 1, "bases has nothing in it that could be set"),
        ("planner.*", 1, "planner is no list"),
        ("planner..k0", 1, "is no key path"),
        ("", 1, "a key path is empty"),
        ("planner.cruise_m_s", 200, "planner.cruise_m_s must be less than or equal to 100, not 200"),
        ("planner.cruise_m_s", "fast", "planner.cruise_m_s must be a number, not the text 'fast'"),
        ("vehicles.pursuers.1.sysid", 1, "the sysid 1 is given twice"),
        ("planner.method", dict, "planner.method must be text, in quotes if need be, not the class dict"),
        ("planner.cruise_m_s", object(), "planner.cruise_m_s must be a number, not a Python object"),
    ],
)
def test_mistakes_are_one_sentence_that_names_the_setting(key: str, value: Any, sentence: str) -> None:
    text = told(**{key: value})
    assert text.startswith(f"set {key}=")
    assert sentence in text
    assert len(text.splitlines()) == 1


def test_every_known_path_passes_the_check() -> None:
    assert {"planner.cruise_m_s", "vehicles.pursuers.*.battery.initial_percent", "obstacles.*.radius_m"} <= set(
        keys.known_paths()
    )
    for path in keys.known_paths():
        keys.check(path)


def test_settings_are_read_as_a_file_reads_values() -> None:
    texts = ["a=1", "b.c=true", "d=[1, 2.5]", "e=null", "f=MODULE:CLASS", "g="]
    assert keys.read_settings(texts) == {"a": 1, "b.c": True, "d": [1, 2.5], "e": None, "f": "MODULE:CLASS", "g": None}
    for wrong in ("planner", "=3", "a=["):
        with pytest.raises(ScenarioError):
            keys.read_settings([wrong])
