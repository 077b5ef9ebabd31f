"""pytest plugin: the mark `campaign`, and the `fleet` fixture, real vehicle processes for tests of your MAVLink code.

    def test_it_answers(fleet):
        connection = mavutil.mavlink_connection(fleet[1].address)

    @pytest.mark.fleet(3)              # system ids 1 to 3, in a row of 3 m to the east
    @pytest.mark.fleet("demo")         # or the vehicles of a scenario: a file, or the name of a shipped one
    @pytest.mark.fleet("x.yaml", trust=True)    # which may use the programs and addresses that it names

    @pytest.mark.campaign("policies", sessions=20)    # fails with the rows that are not as expected
    def test_policies(campaign):                      # the campaign's table; the argument may be left out

`trust=True` goes with `campaign` too. One vehicle without a mark. Addresses are of the system's choosing, so that tests
may run in parallel; vehicles are ready when the test begins, and gone after it, also where pytest itself is killed.
"""

from __future__ import annotations

import contextlib
import json
import os
import select
import subprocess
import tempfile
import time
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import NoneType
from typing import Any

import pytest

from gcs.processes.forked import end
from gcs.processes.python import start_python

Kinds = dict[str, tuple[tuple[type, ...], str]]
"""Arguments of a mark in order: what each may be, also in words."""
READY_WITHIN_S = 120.0
GONE_WITHIN_S = 20.0
CAMPAIGN_MARK = (
    "campaign(what, sessions=None, workers=None, trust=False, seed=None, scheduler=None): fly a campaign (a file, a "
    "shipped name or plain data) before the test"
)
MOST_LISTED = 20
MARK = (
    "fleet(what=1, trust=False): vehicles for the `fleet` fixture: how many (1 to 254), or a scenario's file or "
    "shipped name; trust: it may use what it names beyond its vehicles"
)
_YES_OR_NO = ((bool,), "True or False")
_COUNT = ((int, NoneType), "a whole number")
_FLEET: Kinds = {
    "what": ((int, str, os.PathLike), "a number of vehicles, a scenario's file or a shipped name"),
    "trust": _YES_OR_NO,
}
_CAMPAIGN: Kinds = {
    "what": ((str, os.PathLike, Mapping), "a campaign's file, a shipped name or plain data"),
    "sessions": _COUNT,
    "workers": _COUNT,
    "trust": _YES_OR_NO,
    "seed": _COUNT,
    "scheduler": ((str, NoneType), "an address"),
}


@dataclass(frozen=True)
class FleetVehicle:
    """One vehicle process that listens for MAVLink."""

    sysid: int
    role: str
    label: str
    host: str
    port: int
    log: Path

    @property
    def address(self) -> str:
        """For pymavlink and MAVProxy: `udpout:HOST:PORT`."""
        return f"udpout:{self.host}:{self.port}"

    @property
    def url(self) -> str:
        """For MAVSDK: `udpout://HOST:PORT`."""
        return f"udpout://{self.host}:{self.port}"


class FlyingFleet:
    """The vehicles of one test, by system id."""

    def __init__(self, vehicles: list[FleetVehicle]) -> None:
        self._vehicles = {vehicle.sysid: vehicle for vehicle in vehicles}

    def __getitem__(self, sysid: int) -> FleetVehicle:
        if sysid not in self._vehicles:
            raise KeyError(f"there is no vehicle {sysid} in this fleet; it has {', '.join(map(str, self._vehicles))}")
        return self._vehicles[sysid]

    def __iter__(self) -> Iterator[FleetVehicle]:
        return iter(self._vehicles.values())

    def __len__(self) -> int:
        return len(self._vehicles)


def pytest_configure(config: pytest.Config) -> None:
    """Make the mark known."""
    config.addinivalue_line("markers", MARK)
    config.addinivalue_line("markers", CAMPAIGN_MARK)


def pytest_itemcollected(item: pytest.Item) -> None:
    """A test with the mark `campaign` has the fixture of that name."""
    names = getattr(item, "fixturenames", None)
    if names is not None and item.get_closest_marker("campaign") is not None and "campaign" not in names:
        names.append("campaign")


@pytest.fixture
def campaign(request: pytest.FixtureRequest, tmp_path: Path) -> Any:
    """The table of the campaign that the mark `campaign` names; fails with the rows that are not as expected."""
    from gcs.campaign.cluster import EngineError  # noqa: PLC0415 - what takes long
    from gcs.campaign.python import Campaign  # noqa: PLC0415 - the same
    from gcs.scenario.document import ScenarioError  # noqa: PLC0415 - the same
    from gcs.scenario.parts.trust import TrustError  # noqa: PLC0415 - the same

    given = _arguments(request.node.get_closest_marker("campaign"), _CAMPAIGN)
    if "what" not in given:
        pytest.fail("the fixture campaign needs @pytest.mark.campaign(FILE, sessions=N)", pytrace=False)
    try:
        flown = Campaign(given.pop("what"), out=tmp_path / "campaign", **given)
        table = flown.fly()
    except TrustError as error:
        pytest.fail(f"the campaign does not fly: {error} in its mark", pytrace=False)
    except (ScenarioError, EngineError) as error:
        pytest.fail(f"the campaign does not fly: {error}", pytrace=False)
    if failures := flown.failures:
        listed = [
            *failures[:MOST_LISTED],
            *([f"... and {len(failures) - MOST_LISTED} more"] * (len(failures) > MOST_LISTED)),
        ]
        again = f"gcs campaign fly {flown.folder} ROW flies one again"
        pytest.fail("\n".join([f"{len(failures)} of {table.num_rows} sessions failed:", *listed, again]), pytrace=False)
    return table


@pytest.fixture
def fleet(request: pytest.FixtureRequest) -> Iterator[FlyingFleet]:
    """Real vehicle processes that answer at addresses of their own; see the mark `fleet`."""
    given = _arguments(request.node.get_closest_marker("fleet"), _FLEET)
    with _started(given.get("what", 1), trust=given.get("trust", False)) as flying:
        yield flying


def _arguments(mark: pytest.Mark | None, kinds: Kinds) -> dict[str, Any]:
    """Arguments of a mark by name, given in the order of its signature or by keyword; the test fails where they are
    wrong."""
    if mark is None:
        return {}
    given: dict[str, Any] = {**dict(zip(kinds, mark.args, strict=False)), **mark.kwargs}
    wrong = ""
    if unknown := [name for name in mark.kwargs if name not in kinds]:
        wrong = f"has no argument {unknown[0]!r}: it takes {', '.join(kinds)}"
    elif len(given) < len(mark.args) + len(mark.kwargs):
        wrong = f"is given too many arguments: it takes {', '.join(kinds)}, each once"
    for name, value in given.items():
        allowed, words = kinds.get(name, ((object,), ""))
        if not wrong and (not isinstance(value, allowed) or (isinstance(value, bool) and bool not in allowed)):
            wrong = f"has {value!r} for {name}, which is to be {words}"
    if wrong:
        pytest.fail(f"the mark {mark.name} {wrong}", pytrace=False)
    return given


@contextlib.contextmanager
def _started(what: int | str | os.PathLike[str], *, trust: bool) -> Iterator[FlyingFleet]:
    """`gcs launch` as a process that ends with its standard input."""
    with tempfile.TemporaryDirectory(prefix="gcs-fleet-") as folder:
        scenario = os.fspath(what) if not isinstance(what, int) else _row(what, Path(folder))
        with (Path(folder) / "launch.log").open("w+", encoding="utf-8") as errors:
            process = start_python(
                *("gcs", "launch", scenario, "--json", "--until-eof", *(["--trust"] if trust else [])),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=errors,
                start_new_session=True,
            )
            assert process.stdin is not None
            assert process.stdout is not None
            try:
                line = _line(process)
                if line is None:
                    errors.seek(0)
                    why = errors.read().strip().replace("with --trust", "with trust=True in its mark")
                    pytest.fail(f"the fleet {what!r} did not start: {why}", pytrace=False)
                yield FlyingFleet([_vehicle(entry) for entry in json.loads(line)["vehicles"]])
            finally:
                process.stdin.close()
                end(process, GONE_WITHIN_S)
                process.stdout.close()


def _line(process: subprocess.Popen[bytes]) -> bytes | None:
    """The line that holds the addresses; None where there is none in time."""
    assert process.stdout is not None
    os.set_blocking(process.stdout.fileno(), False)
    said, deadline_s = b"", time.monotonic() + READY_WITHIN_S
    while b"\n" not in said and time.monotonic() < deadline_s:
        if select.select([process.stdout], [], [], max(deadline_s - time.monotonic(), 0.0))[0]:
            chunk = os.read(process.stdout.fileno(), 65536)
            if not chunk:
                return None
            said += chunk
    return said if b"\n" in said else None


def _vehicle(entry: dict[str, str | int]) -> FleetVehicle:
    _, host, port = str(entry["address"]).rsplit(":", 2)
    return FleetVehicle(
        int(entry["sysid"]), str(entry["role"]), str(entry["label"]), host, int(port), Path(str(entry["log"]))
    )


def _row(count: int, folder: Path) -> str:
    """A scenario of so many vehicles on the ground."""
    if not 1 <= count <= 254:
        pytest.fail(f"a fleet has 1 to 254 vehicles, not {count}", pytrace=False)
    vehicles = [
        {"sysid": i + 1, "start_m": [0.0, 3.0 * i, 0.0], "battery": {"capacity_j": 200_000}} for i in range(count)
    ]
    scenario = {
        "schema": 1,
        "name": "fleet-fixture",
        "axes": "ned",
        "origin": {"lat_deg": 47.397742, "lon_deg": 8.545594, "alt_m": 488.0},
        "goal": {"duration_s": 86_400},
        "vehicles": {"pursuers": vehicles},
    }
    path = folder / "fleet.yaml"
    path.write_text(json.dumps(scenario), encoding="utf-8")
    return str(path)
