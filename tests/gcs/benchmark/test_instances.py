"""The 300 instances, and the way from a session to an instance and back."""

from __future__ import annotations

import hashlib
import itertools
import json
import math
from collections import Counter
from importlib import resources
from pathlib import Path

import pytest
import yaml

import gcs
from gcs.benchmark import format, verifier
from gcs.benchmark.format import SCHEDULE, Schedule, ScheduledService
from gcs.benchmark.generator import KINDS, instance, instances
from gcs.benchmark.sessions import Scheduled, document_of, instance_of
from gcs.cli.main import run_argv
from gcs.scenario.file import find, load

DIGEST = "da713f16dc29ce4328d6d4b872c9bba85559805b6f018357379f523e3b569b48"


def test_they_are_the_same_on_every_machine() -> None:
    assert hashlib.sha256(b"".join(map(format.raw, instances()))).hexdigest() == DIGEST


def test_there_are_100_of_each_kind_with_what_the_format_has() -> None:
    every = list(instances())
    assert Counter(one.kind for one in every) == dict.fromkeys(KINDS, 100)
    assert {len(one.receivers) for one in every} == set(range(4, 41))
    assert {len(one.tankers) for one in every} == set(range(1, 9))
    for one in every:
        assert bool(one.bases) == (one.kind != "tankers")
        assert all(r.path[0][0] == 0.0 and r.path[-1][0] >= one.horizon_s for r in one.receivers)
        found = verifier.verify(format.plain(one), {"services": []})
        assert found["feasible"]
        assert found["lost"]


def test_instances_for_tuning_are_others_of_the_same_kinds(tmp_path: Path) -> None:
    of_the_300 = {one.name: one for one in instances()}
    others = list(instances(tuning=True))
    assert Counter(one.kind for one in others) == dict.fromkeys(KINDS, 100)
    assert not {one.name for one in others} & of_the_300.keys()
    assert not {one.seed for one in others} & {one.seed for one in of_the_300.values()}
    first = of_the_300["tankers-000"]
    assert (others[0].name, others[0].tightness) == ("tuning-tankers-000", first.tightness)
    assert others[0].receivers != first.receivers
    assert run_argv(["benchmark", "make", str(tmp_path), "--tuning", "--kind", "bases"]) == 0
    assert format.read(tmp_path / "tuning-bases-099.json", format.Instance) == others[-1]


def test_the_shipped_schema_is_that_of_the_types() -> None:
    text = resources.files("gcs").joinpath("schemas", "refuelling.schema.json").read_text(encoding="utf-8")
    assert json.loads(text) == format.schema()


def test_a_file_is_read_back_equal_and_a_wrong_one_is_refused(tmp_path: Path) -> None:
    one = instance("bases", 7)
    (tmp_path / "one.json").write_bytes(format.raw(one))
    assert format.read(tmp_path / "one.json", format.Instance) == one
    with pytest.raises(format.FormatError, match=r"one.json is no schedule .*format"):
        format.read(tmp_path / "one.json", Schedule)
    with pytest.raises(format.FormatError, match="No such file"):
        format.read(tmp_path / "none.json", Schedule)


def test_the_command_judges(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run_argv(["benchmark", "make", str(tmp_path / "all"), "--kind", "tankers"]) == 0
    assert len(list((tmp_path / "all").iterdir())) == 100
    path = tmp_path / "all" / "tankers-000.json"
    mine = tmp_path / "mine.json"
    mine.write_bytes(format.raw(Schedule(SCHEDULE, "tankers-000", [])))
    capsys.readouterr()
    assert run_argv(["benchmark", "verify", str(path), str(mine)]) == 0
    assert "feasible: lost 4 of 4 (" in capsys.readouterr().out
    mine.write_bytes(format.raw(Schedule(SCHEDULE, "tankers-000", [ScheduledService(0.0, 9.0, 1.0, 1, 201)])))
    assert run_argv(["benchmark", "verify", str(path), str(mine), "--json"]) == 1
    assert "cannot fly" in json.loads(capsys.readouterr().out)["problems"][0]
    assert run_argv(["benchmark", "verify", str(tmp_path / "all" / "tankers-001.json"), str(mine)]) == 2
    assert "is a schedule of 'tankers-000'" in capsys.readouterr().err


def test_a_session_becomes_an_instance() -> None:
    made = instance_of(load(find("demo")))
    assert [one.id for one in made.receivers] == [1, 2, 3, 4, 5]
    assert (made.horizon_s, made.rate_w, len(made.tankers)) == (120.0, 2000.0, 1)
    one = made.receivers[0]
    assert one.energy_j == pytest.approx(0.66 * 24_000)
    assert one.power_w == 210.0
    (t0, *a), (t1, *b) = one.path[:2]
    assert sum((y - x) ** 2 for x, y in zip(a, b, strict=True)) ** 0.5 / (t1 - t0) == pytest.approx(0.8)


def test_an_instance_is_flown_by_a_schedule(tmp_path: Path) -> None:
    """The vehicle that would be lost is refuelled because the schedule says so, and the way back is the same again."""
    one = instance("tankers", 0)
    one.receivers, one.horizon_s = one.receivers[:2], 60.0
    one.receivers[0].path = [(0.0, 0.0, 0.0, -8.0)]
    one.receivers[1].path = [(0.0, 6.0, 0.0, -8.0)]
    one.tankers[0].position_m = (3.0, 0.0, -15.0)
    for receiver, left_s in zip(one.receivers, (45.0, 50.0), strict=True):
        receiver.energy_j = receiver.lands_at_j + left_s * receiver.power_w
    path = tmp_path / "scenario.yaml"
    path.write_text(yaml.safe_dump(document_of(one)))
    back = instance_of(load(path))
    assert [r.path[0] for r in back.receivers] == [r.path[0] for r in one.receivers]
    assert [r.energy_j for r in back.receivers] == pytest.approx([r.energy_j for r in one.receivers])
    assert (back.setup_s, back.rate_w, back.tankers) == (one.setup_s, one.rate_w, one.tankers)
    schedule = Schedule(
        SCHEDULE, one.name, [ScheduledService(10.0, 22.0, 5e3, 2, 201), ScheduledService(30.0, 42.0, 5e3, 1, 201)]
    )
    with gcs.Session(path, lockstep=True, out=tmp_path / "flown", policy=Scheduled(schedule)) as session:
        summary = session.finish()
    services = [(one.receiver, one.tanker) for one in summary.refuelling]
    assert services[:2] == [(2, 201), (1, 201)]
    assert summary.refuelling[0].decided_at_s == pytest.approx(8.0, abs=2.5)


def test_bases_come_with_an_instance_and_vehicles_start_on_the_ground(tmp_path: Path) -> None:
    one = instance("bases", 0)
    path = tmp_path / "scenario.yaml"
    path.write_text(yaml.safe_dump(document_of(one)))
    back = instance_of(load(path))
    assert [(base.name, base.stock_j, base.rate_w) for base in back.bases] == [
        (base.name, base.stock_j, base.rate_w) for base in one.bases
    ]
    assert [base.position_m[:2] for base in back.bases] == [base.position_m[:2] for base in one.bases]
    assert [r.path[0] for r in back.receivers] == [r.path[0] for r in one.receivers]
    assert back.tankers == one.tankers
    assert not any(vehicle.airborne for vehicle in load(path).vehicles.all)


@pytest.mark.parametrize("kind", ["tankers", "reloads", "bases"])
def test_every_instance_of_a_kind_can_be_flown(kind: str, tmp_path: Path) -> None:
    """Some have two vehicles so near to each other that no session would let them start."""
    path = tmp_path / "scenario.yaml"
    for number in (40, 70, 90):
        path.write_text(yaml.safe_dump(document_of(instance(kind, number))))
        starts = [one.start_m for one in load(path).vehicles.all]
        assert min(math.dist(a, b) for a, b in itertools.combinations(starts, 2)) >= 0.6


def test_receivers_that_are_lost_at_different_shares_make_no_scenario() -> None:
    one = instance("tankers", 0)
    one.receivers[1].lands_at_j *= 2.0
    with pytest.raises(format.FormatError, match=r"tankers-000: receivers are lost at 5\.0 to 10\.0 % of their"):
        document_of(one)


def test_what_has_no_receiver_becomes_a_scenario_of_tankers_and_what_has_no_vehicle_none(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    one = instance("tankers", 0)
    one.receivers = []
    path, scenario = tmp_path / "one.json", tmp_path / "scenario.yaml"
    path.write_bytes(format.raw(one))
    assert run_argv(["benchmark", "scenario", str(path)]) == 0
    scenario.write_text(capsys.readouterr().out)
    assert instance_of(load(scenario)).tankers == one.tankers
    one.tankers = []
    path.write_bytes(format.raw(one))
    assert run_argv(["benchmark", "scenario", str(path)]) == 2
    assert capsys.readouterr().err == "gcs: tankers-000 has no receiver and no tanker; a session needs a vehicle\n"
