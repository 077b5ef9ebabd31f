"""The `fleet` fixture in somebody else's test suite, as pytest finds it by itself."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from importlib.metadata import entry_points
from pathlib import Path

import psutil
import yaml
from sessions import small

THEIRS = """
import pytest
from pymavlink import mavutil

PIDS = "{folder}/pids"

def beat(address):
    connection = mavutil.mavlink_connection(address, source_system=254)
    connection.mav.heartbeat_send(6, 8, 0, 0, 0)
    message = connection.recv_match(type="HEARTBEAT", blocking=True, timeout=20)
    connection.close()
    return message.get_srcSystem()

@pytest.mark.fleet(2)
def test_two_answer(fleet):
    assert [beat(vehicle.address) for vehicle in fleet] == [1, 2]
    assert fleet[1].port != fleet[2].port
    assert fleet[2].url == f"udpout://127.0.0.1:{{fleet[2].port}}"
    with pytest.raises(KeyError, match="there is no vehicle 9 in this fleet; it has 1, 2"):
        fleet[9]
    with open(PIDS, "w") as file:
        print(*[str(vehicle.log.parent) for vehicle in fleet], sep="\\n", file=file)

@pytest.mark.fleet("no-such-scenario")
def test_a_fleet_that_cannot_start_is_one_sentence(fleet):
    pass
"""


def test_real_vehicles_are_there_for_a_test_and_gone_after_it(tmp_path: Path) -> None:
    (tmp_path / "test_theirs.py").write_text(THEIRS.format(folder=tmp_path))
    words = [sys.executable, "-m", "pytest", "-q", "--strict-markers", "-p", "no:cacheprovider", "test_theirs.py"]
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, timeout=100, check=False)
    assert "1 passed, 1 error" in done.stdout, done.stdout + done.stderr
    assert re.search(r"the fleet 'no-such-scenario' did not start: .*no shipped scenario", done.stdout, re.DOTALL)
    folders = (tmp_path / "pids").read_text().split()
    assert not [folder for folder in folders if os.path.exists(folder)]
    assert not [p for p in psutil.process_iter(["cmdline"]) if folders[0] in " ".join(p.info["cmdline"] or ())]


MARKED = """
import pytest

@pytest.mark.fleet(what=3)
def test_three(fleet):
    assert len(fleet) == 3

{tests}
"""
MARKS = {
    "fleet(2.5)": "the mark fleet has 2.5 for what, which is to be a number of vehicles, a scenario's file or a "
    "shipped name",
    "fleet(True)": "the mark fleet has True for what, which",
    "fleet(what=0)": "a fleet has 1 to 254 vehicles, not 0",
    "fleet(2, trust='yes')": "the mark fleet has 'yes' for trust, which is to be True or False",
    "fleet(count=3)": "the mark fleet has no argument 'count': it takes what, trust",
    "fleet(3, what=3)": "the mark fleet is given too many arguments: it takes what, trust, each once",
    "fleet(3, False, 1)": "the mark fleet is given too many arguments",
    "campaign('policies', session=1)": "the mark campaign has no argument 'session': it takes what, sessions, workers, "
    "trust, seed, scheduler",
    "campaign(what='policies', sessions=1.5)": "the mark campaign has 1.5 for sessions, which is to be a whole number",
    "campaign(20)": "the mark campaign has 20 for what, which is to be a campaign's file, a shipped name or plain data",
    "campaign('policies', sessions=-1)": "the campaign does not fly: policies: sessions must be greater than or equal "
    "to 1, not -1",
    "campaign('policies', workers=0)": "the campaign does not fly: workers is 0, but a campaign needs at least 1",
    "campaign('policies', scheduler='nohost')": "the campaign does not fly: nohost is no address of a scheduler",
    "campaign(sessions=20)": "the fixture campaign needs @pytest.mark.campaign(FILE, sessions=N)",
}


def test_marks_take_what_their_signature_says(tmp_path: Path) -> None:
    tests = [
        f"@pytest.mark.{mark}\ndef test_{number}({mark.split('(', maxsplit=1)[0]}):\n    pass\n"
        for number, mark in enumerate(MARKS)
    ]
    (tmp_path / "test_theirs.py").write_text(MARKED.format(tests="\n".join(tests)))
    words = [sys.executable, "-m", "pytest", "-q", "--strict-markers", "-p", "no:cacheprovider", "test_theirs.py"]
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, timeout=100, check=False)
    assert f"1 passed, {len(MARKS)} errors" in done.stdout, done.stdout + done.stderr
    assert "Traceback" not in done.stdout
    for sentence in MARKS.values():
        assert sentence in done.stdout


UNASKED = """
import pytest

@pytest.mark.fleet("{folder}/theirs.yaml")
def test_refused(fleet):
    pass

@pytest.mark.fleet("{folder}/theirs.yaml", trust=True)
def test_flies(fleet):
    assert len(fleet) == 1

@pytest.mark.campaign("{folder}/many.yaml")
def test_refused_campaign():
    pass
"""


def test_a_scenario_that_names_more_than_its_vehicles_needs_the_marks_word(tmp_path: Path) -> None:
    scenario = {**small(), "forward": {"to": ["udpin:0.0.0.0:0"]}, "goal": {"duration_s": 1.0}}
    scenario["vehicles"] = {"pursuers": scenario["vehicles"]["pursuers"]}
    del scenario["formation"]
    (tmp_path / "theirs.yaml").write_text(yaml.safe_dump(scenario))
    campaign = {"schema": 1, "name": "many", "scenario": "theirs.yaml", "sessions": 1}
    (tmp_path / "many.yaml").write_text(yaml.safe_dump(campaign))
    (tmp_path / "test_theirs.py").write_text(UNASKED.format(folder=tmp_path))
    words = [sys.executable, "-m", "pytest", "-q", "--strict-markers", "-p", "no:cacheprovider", "test_theirs.py"]
    state = {**os.environ, "XDG_STATE_HOME": str(tmp_path / "state")}
    done = subprocess.run(words, cwd=tmp_path, env=state, capture_output=True, text=True, timeout=200, check=False)
    assert "1 passed, 2 errors" in done.stdout, done.stdout + done.stderr
    said = "names address udpin:0.0.0.0:0 (forward.to): read it, then let it use them with trust=True in its mark"
    assert " ".join(done.stdout.split()).count(said) >= 2, done.stdout


def test_pytest_finds_the_plugin_by_itself() -> None:
    (found,) = [point for point in entry_points(group="pytest11") if point.name == "skytender"]
    assert found.value == "gcs.pytest_plugin"


def test_loading_the_plugin_loads_nothing_heavy() -> None:
    program = (
        "import sys, gcs.pytest_plugin\n"
        "sys.exit(str({'numba', 'numpy', 'pydantic', 'scipy', 'pymavlink', 'yaml', 'click'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert done.stderr == "set()\n"
