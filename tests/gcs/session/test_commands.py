"""What clients of the socket ask for and are answered, over a scripted session."""

import json
from typing import Any

import pytest

from gcs.processes.pace import Pace
from gcs.session.commands import Clients
from gcs.session.server import ClientRequest, Publisher


class Socket(Publisher):
    """A publisher whose clients are numbers, and which keeps its replies."""

    def __init__(self) -> None:
        self.asked: list[ClientRequest] = []
        self.here = {1, 2}
        self.replies: list[tuple[int, bool, str]] = []

    @property
    def clients(self) -> frozenset[int]:
        return frozenset(self.here)

    def poll(self) -> list[ClientRequest]:
        asked, self.asked = self.asked, []
        return asked

    def reply(self, request: ClientRequest, ok: bool, text: str) -> None:
        self.replies.append((request.client, ok, text))


class Table:
    def __init__(self, session: Any) -> None:
        self.session = session
        self.socket = Socket()
        self.pace = Pace(1.0, lambda: 0.0)
        self.clients = Clients(self.socket, session.supervisor, self.pace)

    def ask(self, command: str, client: int = 1, **keys: Any) -> tuple[bool, str]:
        """Whether it was taken, and the words; nothing else is answered."""
        self.socket.asked.append(ClientRequest(client, {"command": command, **keys}))
        self.stops = self.clients.serve()
        ((to, ok, text),) = self.socket.replies
        self.socket.replies.clear()
        assert to == client
        return ok, text


@pytest.fixture
def table(scripted: Any) -> Table:
    session = scripted()
    session.fly(3)
    return Table(session)


def test_the_clock_is_stopped_and_started_and_both_are_recorded(table: Table) -> None:
    assert table.ask("pause")[0]
    assert table.pace.paused
    assert table.ask("resume")[0]
    assert not table.pace.paused
    assert table.ask("stop")[0]
    assert table.stops
    table.session.supervisor.stop()
    table.session.recorder.close()
    lines = (table.session.folder / "decisions.jsonl").read_text().splitlines()
    orders = [d["command"] for d in map(json.loads, lines) if d["kind"] == "operator"]
    assert orders == ["pause", "resume", "stop"]


def test_an_order_reaches_the_operator(table: Table) -> None:
    ok, text = table.ask("hold", sysid=1)
    assert (ok, text) == (True, "Pursuer 1 holds where it is until it rejoins.")
    assert table.session.supervisor.arming[1].ordered == "hold"


@pytest.mark.parametrize(
    ("command", "words"), [("lnad", "did you mean 'land'?"), ("", "there are pause"), ("seek", "is for a replay")]
)
def test_what_is_no_command_here_is_said_in_words(table: Table, command: str, words: str) -> None:
    ok, text = table.ask(command)
    assert not ok
    assert words in text


def test_each_client_inspects_one_vehicle_until_it_changes_its_mind_or_leaves(table: Table) -> None:
    inspection = table.session.supervisor.inspection
    assert table.ask("inspect", sysid=1)[0]
    assert table.ask("inspect", client=2, sysid=201)[0]
    assert inspection.wanted == {1, 201}
    table.session.fly(2)
    told = inspection.latest(table.session.supervisor.time_s)
    assert told["1"]["HEARTBEAT"]["count"] == 2
    assert table.ask("inspect", sysid=101)[0]
    assert inspection.wanted == {101, 201}
    assert table.ask("inspect", sysid=None)[0]
    table.socket.here.discard(2)
    table.clients.serve()
    assert inspection.wanted == frozenset()


@pytest.mark.parametrize("sysid", [77, "1", 1.0, True, [1], {"a": 1}])
def test_nobody_is_inspected_who_is_not_there(table: Table, sysid: Any) -> None:
    assert not table.ask("inspect", sysid=sysid)[0]
    assert table.session.supervisor.inspection.wanted == frozenset()
