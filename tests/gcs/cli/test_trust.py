"""Scenarios from elsewhere may name code, and lie beside files named like modules: neither runs unasked."""

from __future__ import annotations

import os
import pty
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any

import pytest
import yaml
from commands import gcs
from pydantic import BaseModel, TypeAdapter, ValidationError
from sessions import fly, small

import gcs as skytender
from gcs.campaign.file import from_data
from gcs.campaign.model import CampaignRules
from gcs.campaign.plan import NotAllowed, make
from gcs.scenario.file import find, load, shipped_names
from gcs.scenario.model import Scenario
from gcs.scenario.parts.reach import Asks, Shown, _marks, reached

CODE = """
from pathlib import Path
Path(__file__).with_name("ran").touch()

class Mine:
    def __init__(self, scenario):
        pass

    def plan(self, vehicle, situation):
        return vehicle.p_ned, (0.0, 0.0, 0.0)
"""


@pytest.fixture
def named(tmp_path: Path) -> Path:
    """A scenario that names code beside it; the code leaves a file `ran`."""
    module = re.sub(r"\W", "_", tmp_path.name)  # imported into this process, which remembers names
    (tmp_path / f"{module}.py").write_text(CODE)
    path = tmp_path / f"{module}.yaml"
    path.write_text(yaml.safe_dump(small(planner=f"{module}:Mine", goal={"duration_s": 1.0, "refuelled_at_least": 0})))
    return path


@pytest.fixture(autouse=True)
def forgotten(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """No answer was given before."""
    state = tmp_path / "state"
    monkeypatch.setenv("XDG_STATE_HOME", str(state))
    return state / "skytender" / "trusted"


def test_validate_names_code_and_runs_it_with_trust_alone(named: Path) -> None:
    listed = gcs("validate", str(named), "--quiet")
    assert listed.returncode == 0
    assert f"names code {named.stem}:Mine (planner.method)" in listed.stderr
    assert not named.with_name("ran").exists()
    assert gcs("validate", str(named), "--quiet", "--trust").returncode == 0
    assert named.with_name("ran").exists()


@pytest.mark.parametrize(("method", "why"), [
    ("my_planer:Ring", "there is no module 'my_planer'; put it beside the scenario or install its package"),
    ("{module}.sub:Ring", "there is no module '{module}.sub'; put it beside the scenario or install its package"),
    ("{module}:Mien", "has no 'Mien'; did you mean 'Mine'?"),
])  # fmt: skip
def test_validate_finds_by_its_source_code_that_is_not_there(named: Path, method: str, why: str) -> None:
    content = yaml.safe_load(named.read_text())
    content["planner"] = method.format(module=named.stem)
    named.write_text(yaml.safe_dump(content))
    told = gcs("validate", str(named), "--quiet")
    assert told.returncode == 2
    assert why.format(module=named.stem) in told.stderr
    assert f"{named}:" in told.stderr
    assert not named.with_name("ran").exists()


def test_run_and_decide_run_code_once_it_was_allowed(named: Path, tmp_path: Path, monkeypatch: Any) -> None:
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "flown"
    fly_it = ("run", str(named), "--lockstep", "--quiet", "--no-report", "--out", str(folder))
    refused = gcs(*fly_it)
    assert refused.returncode == 2
    assert refused.stderr == (
        f"gcs: {named} names code {named.stem}:Mine (planner.method): read it, then let it use them with --trust\n"
    )
    assert not folder.exists()
    assert not named.with_name("ran").exists()
    flown = fly(yaml.safe_load(named.read_text()), tmp_path, "--lockstep", "--plain")
    assert f"names code {named.stem}:Mine (planner.method)" in flown.stderr
    assert flown.status in (0, 1)
    assert named.with_name("ran").exists()
    named.with_name("ran").unlink()
    refused = gcs("replay", str(flown.folder), "--decide")
    assert refused.returncode == 2
    assert "names code" in refused.stderr
    assert not named.with_name("ran").exists()
    assert "names code" not in gcs("replay", str(flown.folder), "--decide", "--trust").stderr
    assert named.with_name("ran").exists()


EVIL = """#!/bin/sh
touch "$(dirname "$0")/ran"
"""


def reaching(folder: Path) -> list[tuple[dict[str, Any], str]]:
    """A scenario for each thing that one may reach beyond its session, and how that is said."""
    program = folder / "evil.sh"
    program.write_text(EVIL)
    program.chmod(0o755)
    one = {"sysid": 1, "start_m": [0.0, 0.0, 0.0], "battery": {"capacity_j": 60_000}}
    external = {"sysid": 1, "connect": "udpin:127.0.0.1:14999", "capacity_j": 60_000}

    def of(**keys: Any) -> dict[str, Any]:
        content = small(vehicles={"pursuers": [{**one, **keys}], "targets": [], "tankers": []}, goal=GOAL)
        return {key: value for key, value in content.items() if key != "formation"}

    def linked(**keys: Any) -> dict[str, Any]:
        return {**of(external={**external, **keys}), "clock": {"mode": "real"}}

    return [
        (of(autopilot={"ardupilot": "./evil.sh"}), f"program {program}"),
        (of(autopilot={"px4": "./evil.sh"}), f"program {program}"),
        (linked(connect="udpout:192.0.2.1:14550"), "address udpout:192.0.2.1:14550"),
        (linked(connect=["udpin:127.0.0.1:14999", "serial:/dev/ttyS9:57600"]), "address serial:/dev/ttyS9:57600"),
        (linked(signing={"key_file": "some.key"}), f"key file {folder / 'some.key'}"),
        ({**of(), "forward": {"to": ["udpin:0.0.0.0:0"]}}, "address udpin:0.0.0.0:0"),
        ({**of(), "forward": {"to": ["udpin:[::1]:0"], "control": True}}, "other ground stations may command"),
        (small(goal=GOAL, competition="theirs:Mine"), "code theirs:Mine"),
    ]


GOAL = {"duration_s": 1.0, "refuelled_at_least": 0, "waypoints": "none"}


@pytest.mark.parametrize("number", range(8))
def test_what_a_scenario_reaches_is_listed_by_validate_and_asked_for_by_python_and_each_command_that_uses_it(
    number: int, tmp_path: Path, forgotten: Path
) -> None:
    content, said = reaching(tmp_path)[number]
    path = tmp_path / "theirs.yaml"
    path.write_text(yaml.safe_dump(content))
    path.with_suffix(".py").write_text("class Mine:\n    pass\n")
    listed = gcs("validate", str(path), "--quiet")
    assert (listed.returncode, said in listed.stderr) == (0, True), listed.stderr
    commands = [("run", str(path), "--out", str(tmp_path / "out")), ("launch", str(path))]
    if "external" in content["vehicles"].get("pursuers", [{}])[0]:
        commands.append(("check", str(path)))
    for command in commands:
        refused = gcs(*command)
        assert refused.returncode == 2
        assert said in refused.stderr
        assert refused.stderr.endswith("with --trust\n")
        assert refused.stderr.count("\n") == 1
    for scenario in (str(path), load(path)):
        with pytest.raises(skytender.TrustError, match=re.escape(said)) as error:
            skytender.Session(scenario, out=tmp_path / "out")
        assert str(error.value).endswith(": read it, then let it use them with trust=True")
        assert any(one.text.startswith(said) for one in error.value.named)
    assert not (tmp_path / "ran").exists()
    assert not (tmp_path / "out").exists()
    assert not forgotten.exists()


def test_the_answer_holds_until_the_scenario_changes_and_is_this_users_own(tmp_path: Path, forgotten: Path) -> None:
    """By `launch`, which refuses for another reason once it was let to: there is nothing to launch."""
    content, _ = reaching(tmp_path)[2]
    path = tmp_path / "theirs.yaml"
    path.write_text(yaml.safe_dump(content))

    def asked() -> bool:
        ended = gcs("launch", str(path))
        assert ended.returncode == 2
        return "--trust" in ended.stderr

    assert asked()
    assert gcs("validate", str(path), "--trust", "--quiet").returncode == 0
    assert not asked()
    path.write_text(yaml.safe_dump({**content, "description": "another"}))
    assert asked()
    (kept,) = forgotten.iterdir()
    path.write_text(yaml.safe_dump(content))
    assert not asked()
    kept.rename(kept.with_name("elsewhere"))
    kept.symlink_to(kept.with_name("elsewhere"))
    assert asked()


def test_a_person_is_asked_and_may_refuse(tmp_path: Path) -> None:
    """At a terminal, by the program itself."""
    content, said = reaching(tmp_path)[0]
    (tmp_path / "theirs.yaml").write_text(yaml.safe_dump(content))
    ours, theirs = pty.openpty()
    try:
        with subprocess.Popen(
            [sys.executable, "-P", "-m", "gcs", "run", "theirs.yaml", "--out", "out"],
            cwd=tmp_path, stdin=theirs, stdout=subprocess.DEVNULL, stderr=theirs,
        ) as process:  # fmt: skip
            shown = b""
            while b"[y/N]" not in shown:
                shown += os.read(ours, 4096)
            os.write(ours, b"n\n")
        assert process.returncode == 2
        assert said in " ".join(shown.decode().split())
    finally:
        os.close(ours)
        os.close(theirs)
    assert not (tmp_path / "ran").exists()
    assert not (tmp_path / "out").exists()


def test_what_the_caller_sets_is_the_callers_own_word(tmp_path: Path) -> None:
    (tmp_path / "ours.yaml").write_text(yaml.safe_dump(small(goal=GOAL)))
    setting = ("--set", "forward.to=[udpin:0.0.0.0:0]")
    ended = gcs("validate", str(tmp_path / "ours.yaml"), "--quiet", *setting)
    assert (ended.returncode, ended.stderr) == (0, "")


def test_a_campaign_asks_too_and_refuses_rows_that_draw_what_was_not_asked_for(tmp_path: Path) -> None:
    content, said = reaching(tmp_path)[5]
    (tmp_path / "theirs.yaml").write_text(yaml.safe_dump(content))
    rules = {"schema": 1, "name": "many", "sessions": 1, "keep": "none"}
    for name, more in (("base", {"scenario": "theirs.yaml"}), ("made", {"generate": "theirs:make"})):
        path = tmp_path / f"{name}.yaml"
        path.write_text(yaml.safe_dump({**rules, **more}))
        refused = gcs("campaign", "run", str(path), "--out", str(tmp_path / "out"))
        assert refused.returncode == 2
        assert (said if name == "base" else "code theirs:make (generate)") in refused.stderr
    assert not (tmp_path / "out").exists()
    plan = make(from_data({**rules, "scenario": "demo", "set": {"planner.method": "theirs:Mine"}}), [tmp_path])
    with pytest.raises(NotAllowed, match=r"names code theirs:Mine \(planner.method\)"):
        plan.resolved(plan.row(0))


def test_python_flies_what_was_agreed_to_there_or_at_the_command(named: Path, tmp_path: Path) -> None:
    with pytest.raises(skytender.TrustError):
        skytender.Session(str(named))
    assert not named.with_name("ran").exists()
    skytender.Session(str(named), trust=True)
    skytender.Session(str(named))
    named.write_text(named.read_text() + "description: another\n")
    with pytest.raises(skytender.TrustError):
        skytender.Session(str(named))
    assert gcs("validate", str(named), "--trust", "--quiet").returncode == 0
    with skytender.Session(str(named), lockstep=True, out=tmp_path / "out") as session:
        assert session.finish().outcome == "met"


def test_a_campaign_in_python_refuses_too(named: Path) -> None:
    campaign = named.with_name("many.yaml")
    campaign.write_text(yaml.safe_dump({"schema": 1, "name": "many", "scenario": named.name, "sessions": 1}))
    for what in (str(campaign), {**yaml.safe_load(campaign.read_text()), "scenario": str(named)}):
        with pytest.raises(skytender.TrustError, match=rf"names code {named.stem}:Mine \(planner.method\)"):
            skytender.Campaign(what)
    assert not named.with_name("ran").exists()
    assert skytender.Campaign(str(campaign), trust=True).plan.trusted
    assert skytender.Campaign(str(campaign)).plan.trusted
    assert named.with_name("ran").exists()


def test_shipped_scenarios_reach_nothing() -> None:
    assert not [name for name in shipped_names() if reached(load(find(name)))]


def leaves(model: type[BaseModel], at: str = "") -> Iterator[tuple[str, Any, list[Any]]]:
    """Each key of a model and of those in it, with its type and what stands beside that."""
    for name, field in model.model_fields.items():
        marks = [*field.metadata, *_marks(field.annotation)]
        inner = [one for one in marks if isinstance(one, type)]
        yield f"{at}{name}", Annotated[field.annotation, None, *field.metadata], marks
        for one in inner:
            yield from leaves(one, f"{at}{name}.")


REACHING = ("./evil.sh", "/dev/ttyS9", "evil:Evil", "udpin:0.0.0.0:14550", "serial:/dev/ttyS9:57600", "https://a.b/c")


@pytest.mark.parametrize("model", [Scenario, CampaignRules])
def test_no_key_can_hold_a_path_an_address_or_code_without_saying_so(model: type[BaseModel]) -> None:
    """Each value of a model is tried, also in a list: what takes such a text asks for it, or only shows it."""
    silent = []
    for key, kind, marks in leaves(model):
        if any(isinstance(one, Asks | Shown) for one in marks):
            continue
        adapter = TypeAdapter(kind)
        for text in REACHING:
            for value in (text, (text,), (text, text), {"A": text}, {"A": (text,)}):
                try:
                    made = adapter.validate_python(value)
                except ValidationError:
                    continue
                if not (isinstance(made, BaseModel) and reached(made)):  # a block's short form
                    silent.append(key)
    assert sorted(set(silent)) == sorted(PLAIN_DATA if model is CampaignRules else [])


PLAIN_DATA = (
    "arguments",
    "draw.choice",
    "expect.equals",
    "measure",
    "scenario",
    "search.maximise",
    "search.minimise",
    "set",
    "vary",
)
"""Of a campaign: values that each row's scenario is made with, which asks for them itself, names of measures, and the
scenario's file, which is read."""
