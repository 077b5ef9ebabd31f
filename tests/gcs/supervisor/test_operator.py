"""Which orders make sense when, and what they change for pilots and schedule."""

from collections.abc import Iterator
from typing import Any

import pytest

from gcs.supervisor.arming import Stage
from gcs.supervisor.operator import COMMANDS

HOLD = 4 << 16 | 3 << 24
BATTERY = {"capacity_j": 20_000.0}


@pytest.fixture
def session(scripted: Any) -> Any:
    made = scripted(competition={"need_from": 0.9})
    made.link.vehicles[1, 1].energy_hj = 50
    made.fly(3)
    return made


def taken(session: Any, command: str, **keys: Any) -> bool:
    answer = session.supervisor.obey({"command": command, **keys})
    assert answer.text.endswith(".")
    assert session.supervisor.events[-1].kind == "operator"
    refused = "" if answer.taken else f"{command} refused: "
    assert session.supervisor.events[-1].text == f"Operator: {refused}{answer.text}"
    return bool(answer.taken)


def commands(session: Any, sysid: int) -> list[int]:
    return [content.command for _, content in session.link.sent("COMMAND_LONG", (sysid, 1))]


@pytest.mark.parametrize(("order", "command"), [("hold", 176), ("return", 20), ("land", 21)])
def test_who_is_taken_gets_the_command_and_no_set_points(session: Any, order: str, command: int) -> None:
    assert taken(session, order, sysid=1)
    session.fly(1)
    assert commands(session, 1) == [command]
    points = len(session.link.sent("SET_POSITION_TARGET_LOCAL_NED", (1, 1)))
    session.fly(20)
    assert commands(session, 1) == [command]
    assert len(session.link.sent("SET_POSITION_TARGET_LOCAL_NED", (1, 1))) == points
    assert session.supervisor.arming[1].stage is Stage.TAKEN
    assert (1, f"{order.capitalize()} accepted", "ack") in [
        (event.sysid, event.text, event.kind) for event in session.supervisor.events
    ]


def test_who_was_released_is_the_operators_by_an_order_and_may_be_released_again(session: Any) -> None:
    arming = session.supervisor.arming[1]
    assert taken(session, "release", sysid=1)
    assert not taken(session, "release", sysid=1)
    session.fly(2)
    assert taken(session, "hold", sysid=1)
    session.fly(2)
    assert commands(session, 1) == [176]
    assert (arming.ordered, arming.released) == ("hold", False)
    assert taken(session, "release", sysid=1)
    assert (arming.ordered, arming.released) == (None, True)
    assert session.supervisor.schedule.participation.out == {1: "taken by another ground station"}


def test_who_rejoins_gets_set_points_again(session: Any) -> None:
    assert taken(session, "hold", sysid=1)
    session.link.vehicles[1, 1].custom_mode = HOLD
    session.fly(5)
    assert taken(session, "rejoin", sysid=1)
    before = len(session.link.sent("SET_POSITION_TARGET_LOCAL_NED", (1, 1)))
    session.fly(5)
    assert len(session.link.sent("SET_POSITION_TARGET_LOCAL_NED", (1, 1))) > before
    assert 1 not in session.supervisor.schedule.participation.out


def test_who_is_taken_is_neither_served_nor_competes_until_it_rejoins(scripted: Any) -> None:
    session = scripted(competition={"need_from": 0.1})
    session.link.vehicles[1, 1].energy_hj = 80
    session.fly(3)
    assert session.supervisor.schedule.competition_state.v
    assert taken(session, "hold", sysid=1)
    session.fly(100)
    assert not session.supervisor.schedule.competition_state.v
    assert session.supervisor.schedule.services == []
    assert not taken(session, "refuel", sysid=1)


def test_refuel_makes_it_the_next_and_only_where_that_makes_sense(session: Any) -> None:
    assert taken(session, "refuel", sysid=1)
    session.fly(1)
    (service,) = session.supervisor.schedule.services
    assert (service.receiver, service.by) == (1, "operator")
    assert not taken(session, "refuel", sysid=1)


def test_none_is_refuelled_where_no_tanker_lives(session: Any) -> None:
    session.supervisor.fleet.lost(201)
    session.fly(1)
    assert not taken(session, "refuel", sysid=1)


def test_none_is_refuelled_while_no_tanker_is_in_order(session: Any) -> None:
    participation = session.supervisor.schedule.participation
    participation.change("tanker_out begins", 201)
    answer = session.supervisor.obey({"command": "refuel", "sysid": 1})
    assert (answer.taken, answer.text) == (False, "No tanker is in order that could refuel it.")
    participation.change("tanker_out ends", 201)
    assert taken(session, "refuel", sysid=1)


def test_a_full_one_is_not_refuelled(scripted: Any) -> None:
    session = scripted()
    session.fly(3)
    assert not taken(session, "refuel", sysid=1)


def test_skip_is_out_and_the_same_again_is_in(scripted: Any) -> None:
    session = scripted(competition={"need_from": 0.1})
    session.link.vehicles[1, 1].energy_hj = 80
    session.fly(3)
    assert taken(session, "skip", sysid=1)
    session.fly(60)
    assert session.supervisor.schedule.services == []
    assert not taken(session, "refuel", sysid=1)
    assert taken(session, "skip", sysid=1)
    session.fly(60)
    assert [service.receiver for service in session.supervisor.schedule.services] == [1]


def test_skip_outlasts_being_taken(session: Any) -> None:
    schedule = session.supervisor.schedule
    assert taken(session, "skip", sysid=1)
    assert taken(session, "hold", sysid=1)
    assert taken(session, "rejoin", sysid=1)
    assert schedule.participation.out == {1: "skipped by the operator"}
    assert taken(session, "hold", sysid=1)
    assert taken(session, "skip", sysid=1)
    assert schedule.participation.out == {1: "taken by the operator"}


@pytest.fixture
def two_targets(scripted: Any) -> Iterator[Any]:
    def target(sysid: int, north_m: float) -> dict[str, Any]:
        return {"sysid": sysid, "start_m": (north_m, 0.0, -4.0), "airborne": True, "battery": BATTERY,
                "path_m": [(north_m, 0.0, -4.0)], "speed_m_s": 0.8}  # fmt: skip

    # The scripted link has the vehicles 1, 101 and 201: the second target is played by 201.
    pursuer = {"sysid": 1, "start_m": (3.0, 0.0, -4.0), "airborne": True, "battery": BATTERY}
    made = scripted(
        vehicles={"pursuers": [pursuer], "targets": [target(101, 0.0), target(201, -6.0)]},
        goal={"duration_s": 60.0},
    )
    made.fly(30)
    return made


def test_who_is_sent_after_another_target_goes_there(two_targets: Any) -> None:
    supervisor = two_targets.supervisor
    place = supervisor.snapshot.vehicle(1).p_ned
    assert place[0] > 0.0
    assert taken(two_targets, "retarget", sysid=1, target=201)
    assert not taken(two_targets, "retarget", sysid=1, target=201)
    two_targets.fly(60)
    assert supervisor.snapshot.vehicle(1).p_ned[0] < -2.0
    assert supervisor.metrics.target_of == {1: 201}


@pytest.mark.parametrize(
    ("command", "keys"),
    [
        *((command, {"sysid": 77}) for command in COMMANDS),
        ("hold", {"sysid": "1"}),
        ("land", {"sysid": True}),
        ("skip", {}),
        ("rejoin", {"sysid": 1}),
        ("retarget", {"sysid": 1}),
        ("retarget", {"sysid": 1, "target": 1}),
        ("retarget", {"sysid": 1, "target": 101}),
        ("retarget", {"sysid": 201, "target": 101}),
        ("refuel", {"sysid": 101}),
        ("skip", {"sysid": 201}),
    ],
)
def test_orders_that_make_no_sense_are_refused_and_recorded(session: Any, command: str, keys: dict[str, Any]) -> None:
    digest = session.supervisor.digest.hexdigest()
    assert not taken(session, command, **keys)
    session.supervisor.stop()
    assert session.supervisor.digest.hexdigest() != digest
    (record,) = [line for line in decisions(session) if '"kind":"operator"' in line]
    assert '"taken":false' in record


def decisions(session: Any) -> list[str]:
    session.recorder.close()
    return list((session.folder / "decisions.jsonl").read_text().splitlines())


def test_before_a_vehicle_has_spoken_and_after_it_died_nobody_commands_it(scripted: Any) -> None:
    session = scripted()
    assert not taken(session, "hold", sysid=1)
    session.fly(3)
    session.supervisor.lose((1, 1), "gone")
    assert not taken(session, "hold", sysid=1)
    assert not taken(session, "rejoin", sysid=1)


def test_an_old_order_is_not_repeated_after_a_newer_one(session: Any) -> None:
    deaf = session.link.vehicles[1, 1]
    deaf.hear = lambda _: None
    assert taken(session, "hold", sysid=1)
    session.fly(2)
    assert taken(session, "land", sysid=1)
    session.fly(30)
    sent = commands(session, 1)
    first_land = sent.index(21)
    assert sent[:first_land].count(176) >= 1
    assert 176 not in sent[first_land:]
    assert sent.count(21) == 4  # once, and three times more without an answer
