"""`gcs mission set` without a link: what a vehicle has after a refusal or Ctrl-C, and what it has not kept."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from dialogue import converse, exchange
from pymavlink.dialects.v20 import common as mav

from gcs.cli.mission.writing import PlanWriting, read_after_refusals, say_interrupted
from gcs.mavlink.plans.client import PlanClients
from gcs.mavlink.plans.items import PlanItem

MISSION = mav.MAV_MISSION_TYPE_MISSION
STATION = (255, 190)
UNKNOWN_COMMAND = 16999


def waypoint(number: int, hold_s: float = 0.0) -> PlanItem:
    return PlanItem(mav.MAV_CMD_NAV_WAYPOINT, 3, hold_s, 473977420 + 31 * number, 85455940, 10.0 + number)


OLD = [waypoint(number) for number in range(20, 25)]
NEW = [waypoint(number) for number in range(5)]
BAD = [*NEW[:3], NEW[3]._replace(command=UNKNOWN_COMMAND), NEW[4]]


class Vehicle:
    """One mission, with holds of whole seconds. An ArduPilot puts items in the place of old ones as they come
    (`in_place`); it takes no item of an unknown command."""

    def __init__(self, plan: list[PlanItem], *, in_place: bool = False, answers_after: bool = True) -> None:
        self.plan, self.in_place, self.answers_after = list(plan), in_place, answers_after
        self.coming: list[PlanItem] | None = None
        self.count = 0
        self.refused = False

    def hear(self, m: Any) -> list[Any]:
        if self.refused and not self.answers_after:
            return []
        match m.get_type():
            case "MISSION_REQUEST_LIST":
                return [mav.MAVLink_mission_count_message(*STATION, len(self.plan), MISSION)]
            case "MISSION_REQUEST_INT":
                i = self.plan[m.seq]
                place = (i.param2, i.param3, i.param4, i.x, i.y, i.z, MISSION)
                head = (m.seq, i.frame, i.command, 0, i.autocontinue, float(int(i.param1)))
                return [mav.MAVLink_mission_item_int_message(*STATION, *head, *place)]
            case "MISSION_COUNT":
                self.coming, self.count = [], m.count
                if self.in_place:
                    del self.plan[m.count :]
                return self.ask()
            case "MISSION_ITEM_INT":
                return self.take(PlanItem(**{field: getattr(m, field) for field in PlanItem._fields}))
        return []

    def take(self, item: PlanItem) -> list[Any]:
        assert self.coming is not None
        if item.command == UNKNOWN_COMMAND:
            self.refused = True
            return 2 * [mav.MAVLink_mission_ack_message(*STATION, mav.MAV_MISSION_UNSUPPORTED, MISSION)]
        if self.in_place:
            self.plan[len(self.coming) : len(self.coming) + 1] = [item]
        self.coming.append(item)
        if len(self.coming) < self.count:
            return self.ask()
        self.plan = self.coming
        return [mav.MAVLink_mission_ack_message(*STATION, mav.MAV_MISSION_ACCEPTED, MISSION)]

    def ask(self) -> list[Any]:
        assert self.coming is not None
        return [mav.MAVLink_mission_request_message(*STATION, len(self.coming), MISSION)]


class Fleet(SimpleNamespace):
    """One vehicle, without a link."""

    def converse(self, clients: list[PlanClients], *, at_once: int) -> None:
        for client in clients[:at_once]:
            converse(client, self.vehicle)


def refused(vehicle: Vehicle, items: list[PlanItem]) -> PlanWriting:
    """Its end, with what it has after that."""
    writing = PlanWriting(3, 1, MISSION, items, first=1)
    converse(writing, vehicle)
    fleet: Any = Fleet(vehicle=vehicle, profiles={3: SimpleNamespace(plans=writing._habits)})
    read_after_refusals(fleet, {3: {"mission": writing}}, STATION, 1)
    assert (writing.outcome, writing.sent) == ("unsupported", items.index(next(i for i in items if i in BAD[3:])) + 1)
    return writing


@pytest.mark.parametrize(
    ("old", "in_place", "after"),
    [
        (OLD, False, "it still has its old plan, 5 items"),
        ([], False, "it has none, as before"),
        (OLD, True, "its plan is changed: it has 5 items now, 3 as in the file, and had 5 before"),
        ([], True, "it has 3 items now, 3 as in the file, and had 0 before"),
        (OLD * 2, True, "its plan is changed: it has 5 items now, 3 as in the file, and had 10 before"),
        (OLD[:4], False, "it has 4 items now, 0 as in the file, and had 4 before"),
        ([*NEW[:3], *OLD[3:]], True, "it still has its old plan, 5 items"),
    ],
)  # fmt: skip
def test_what_a_vehicle_has_after_it_refused_an_item_is_read(old: list[PlanItem], in_place: bool, after: str) -> None:
    assert refused(Vehicle(old, in_place=in_place), BAD).after == after


def test_what_is_not_known_after_a_refusal_is_said() -> None:
    assert refused(Vehicle(OLD, answers_after=False), BAD).after == (
        "what it has now could not be read: no answer, though it was asked 6 times"
    )


def test_a_hold_that_is_cut_down_is_not_kept_though_all_is_there() -> None:
    given = [NEW[0], waypoint(1, 2.5), NEW[2]]
    writing = PlanWriting(3, 1, MISSION, given, first=1)
    converse(writing, Vehicle(OLD))
    assert (writing.outcome, writing.all_there) == ("differs", True)
    assert [one.text for one in writing.not_kept] == ["item 2 NAV_WAYPOINT: Hold 2.5 is 2"]


def test_another_number_of_items_or_another_command_is_not_all_there() -> None:
    writing = PlanWriting(3, 1, MISSION, NEW)
    writing.outcome = "differs"
    for found in (NEW[:4], BAD):
        writing.found, writing._count = tuple(found), len(found)
        assert not writing.all_there


@pytest.mark.parametrize(
    ("items", "steps", "words"),
    [
        (NEW, 1, "vehicle 3 mission: as it was"),
        (NEW, 10, "vehicle 3 mission: 3 of 5 items were sent, and may be in the place of old ones"),
        (NEW, 12, "vehicle 3 mission: all 5 items were sent, and not read back"),
        (NEW, 99, "vehicle 3 mission: written and read back"),
        ([], 2, "vehicle 3 mission: it was asked to clear it, and not read back"),
    ],
)
def test_ctrl_c_says_what_the_vehicle_has(
    items: list[PlanItem], steps: int, words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    vehicle, writing = Vehicle(OLD), PlanWriting(3, 1, MISSION, items, first=1)
    for step in range(steps):
        exchange(writing, vehicle, 0.05 * step)
    say_interrupted({3: {"mission": writing}})
    assert capsys.readouterr().err == f"gcs: interrupted: {words}\n"


def test_ctrl_c_names_vehicles_of_one_end_together_and_says_nothing_of_a_reading(
    capsys: pytest.CaptureFixture[str],
) -> None:
    untouched = {sysid: {"mission": PlanWriting(sysid, 1, MISSION, NEW)} for sysid in (3, 4)}
    say_interrupted(untouched)
    assert capsys.readouterr().err == "gcs: interrupted: vehicle 3 mission, vehicle 4 mission: as it was\n"
    say_interrupted({3: {"mission": PlanWriting(3, 1, MISSION, None)}})
    assert capsys.readouterr().err == ""
