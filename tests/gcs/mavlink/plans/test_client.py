"""Missions, fences and rally points put into a scripted vehicle that pymavlink speaks for, over a link that loses."""

import random
from typing import Any

import pytest
from dialogue import converse, deliver, exchange
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink.plans.client import WRITES, PlanClient
from gcs.mavlink.plans.habits import PlanHabits
from gcs.mavlink.plans.items import PlanItem

FENCE, MISSION = mav.MAV_MISSION_TYPE_FENCE, mav.MAV_MISSION_TYPE_MISSION
CIRCLE = int(mav.MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION)
PLAN = [PlanItem(CIRCLE, 0, 40.0 + i, 473977420 + 31 * i, -85455940 - 17 * i, 0.0) for i in range(7)]
ROUTE = [
    PlanItem(mav.MAV_CMD_NAV_WAYPOINT, 3, float(i), 473977420 + 31 * i, -85455940, 10.0 + i, 2.0, 0.0, -90.0, i % 2)
    for i in range(9)
]
OTHER_STATION = (250, 1)


class Vehicle:
    """One plan. It asks for items one by one, again after a second, as autopilots do."""

    def __init__(self, lose: float = 0.0, plan: list[PlanItem] | None = None, kind: int = FENCE) -> None:
        self.plan = list(plan or [])
        self.kind = kind
        self.strays: list[PlanItem] = []
        """items that another station reads from it meanwhile"""
        self.lose = lose
        self.answer_with: int | None = None
        """a MAV_MISSION_RESULT with which everything is answered"""
        self.rounds = 0
        """added to degrees that are read back"""
        self.radius: float | None = None
        """what every radius becomes"""
        self.asked: list[str] = []
        self.random = random.Random(11)
        self._expected = 0
        self._coming: list[PlanItem] | None = None
        self._again_s = self._now_s = 0.0

    def hear(self, m: Any) -> list[Any]:
        assert m.mission_type == self.kind
        assert (m.target_system, m.target_component) == (3, 1)
        self.asked.append(m.get_type())
        if self.answer_with is not None:
            return [mav.MAVLink_mission_ack_message(255, 190, self.answer_with, self.kind)]
        match m.get_type():
            case "MISSION_REQUEST_LIST":
                return [mav.MAVLink_mission_count_message(255, 190, len(self.plan), self.kind)]
            case "MISSION_REQUEST_INT":
                i = self.plan[m.seq]
                size = i.param1 if self.radius is None else self.radius
                rest = (i.param2, i.param3, i.param4, i.x + self.rounds, i.y - self.rounds, i.z, self.kind)
                frame = 5 if self.kind == FENCE else i.frame
                strays = self.strays[m.seq : m.seq + 1]
                return [
                    mav.MAVLink_mission_item_int_message(
                        *OTHER_STATION, m.seq, frame, one.command, 0, 1, 0, 0, 0, 0, one.x, one.y, one.z, self.kind
                    )
                    for one in strays
                ] + [
                    mav.MAVLink_mission_item_int_message(
                        255, 190, m.seq, frame, i.command, 0, i.autocontinue, size, *rest
                    )
                ]
            case "MISSION_CLEAR_ALL":
                self.plan = []
                return [mav.MAVLink_mission_ack_message(255, 190, mav.MAV_MISSION_ACCEPTED, self.kind)]
            case "MISSION_COUNT":
                self._expected, self._coming = m.count, []
                return self._ask()
            case "MISSION_ITEM_INT" if self._coming is not None and m.seq == len(self._coming):
                self._coming.append(PlanItem(**{field: getattr(m, field) for field in PlanItem._fields}))
                if len(self._coming) < self._expected:
                    return self._ask()
                self.plan, self._coming = self._coming, None
                return [mav.MAVLink_mission_ack_message(255, 190, mav.MAV_MISSION_ACCEPTED, self.kind)]
        return []

    def tick(self, now_s: float) -> list[Any]:
        self._now_s = now_s
        return self._ask() if self._coming is not None and now_s >= self._again_s else []

    def _ask(self) -> list[Any]:
        assert self._coming is not None
        self._again_s = self._now_s + 1.0
        return [mav.MAVLink_mission_request_message(255, 190, len(self._coming), self.kind)]


@pytest.mark.parametrize("lose", [0.0, 0.25])
@pytest.mark.parametrize(
    ("kind", "plan", "before"),
    [
        (FENCE, PLAN, []),
        (FENCE, PLAN, [*PLAN[:6], PLAN[0]]),
        (FENCE, PLAN, [*PLAN, *PLAN]),
        (MISSION, ROUTE, ROUTE[:3]),
        (MISSION, ROUTE, PLAN),
    ],
)
def test_a_plan_is_written_and_read_back_whatever_the_link_loses(
    lose: float, kind: int, plan: list[PlanItem], before: list[PlanItem]
) -> None:
    client, vehicle = PlanClient(3, 1, kind, plan), Vehicle(lose, before, kind)
    took_s = converse(client, vehicle)
    assert (client.outcome, client.lost, vehicle.plan) == ("uploaded", [], plan)
    if not lose:
        assert took_s < 5.0
        assert vehicle.asked.count("MISSION_COUNT") == 1
        assert vehicle.asked[-1] == "MISSION_ACK"
    again = PlanClient(3, 1, kind, None)
    converse(again, vehicle)
    assert (again.outcome, again.compare(plan)) == ("read", [])


@pytest.mark.parametrize("before", [[], PLAN[:2], [*PLAN[:6], PLAN[0]], [*PLAN, *PLAN]])
def test_a_plan_that_is_replaced_is_read_whole_where_it_is_to_be_kept(before: list[PlanItem]) -> None:
    client, vehicle = PlanClient(3, 1, FENCE, PLAN, keeps=True), Vehicle(plan=before)
    converse(client, vehicle)
    assert [item._replace(frame=0) for item in client.replaced] == before
    assert (client.outcome, vehicle.plan) == ("uploaded", PLAN)
    again = PlanClient(3, 1, FENCE, PLAN, keeps=True)
    converse(again, vehicle)
    assert (again.outcome, again.replaced) == ("kept", ())


def test_a_plan_that_is_there_is_not_written_and_rounding_is_no_difference() -> None:
    for rounds in (0, 1, -1):
        client, vehicle = PlanClient(3, 1, FENCE, PLAN), Vehicle(plan=PLAN)
        vehicle.rounds = rounds
        converse(client, vehicle)
        assert client.outcome == "kept"
        assert "MISSION_COUNT" not in vehicle.asked


def test_what_reads_otherwise_is_named_after_some_writes() -> None:
    client, vehicle = PlanClient(3, 1, FENCE, PLAN), Vehicle()
    vehicle.radius = 40.0
    converse(client, vehicle)
    assert (client.outcome, client.why) == ("differs", "read back, item 1 NAV_FENCE_CIRCLE_INCLUSION: Radius 41 is 40")
    assert vehicle.asked.count("MISSION_COUNT") == WRITES
    client, vehicle = PlanClient(3, 1, FENCE, PLAN), Vehicle(plan=PLAN)
    vehicle.rounds = 2
    converse(client, vehicle)
    assert client.outcome == "differs"


@pytest.mark.parametrize(
    ("result", "outcome"),
    [
        (mav.MAV_MISSION_UNSUPPORTED, "unsupported"),
        (mav.MAV_MISSION_NO_SPACE, "refused"),
        (mav.MAV_MISSION_DENIED, "refused"),
        (mav.MAV_MISSION_ERROR, "refused"),
        (99, "refused"),
    ],
)
def test_a_refusal_ends_it_at_once_or_where_it_may_pass_after_some_tries(result: int, outcome: str) -> None:
    client, vehicle = PlanClient(3, 1, FENCE, PLAN), Vehicle()
    vehicle.answer_with = result
    took_s = converse(client, vehicle)
    assert client.outcome == outcome
    assert took_s < (15.0 if result in (mav.MAV_MISSION_ERROR, mav.MAV_MISSION_DENIED) else 0.5)


def test_silence_is_no_answer() -> None:
    client = PlanClient(3, 1, FENCE, PLAN)
    assert converse(client, Vehicle(lose=1.0)) < 12.0
    assert (client.outcome, client.why) == ("silent", "no answer, though it was asked 6 times")


@pytest.mark.parametrize("field", PlanItem._fields[2:-1])
def test_each_number_of_an_item_that_reads_otherwise_is_named(field: str) -> None:
    other = [item._replace(**{field: 1 - getattr(item, field)}) if i == 4 else item for i, item in enumerate(ROUTE)]
    client = PlanClient(3, 1, MISSION, None, first=1)
    converse(client, Vehicle(plan=other, kind=MISSION))
    names = {"param1": "Hold 4 is -3", "z": "Altitude 14 is -13", "x": "Latitude 47.3977544 is -47.3977543"}
    (difference,) = client.compare(ROUTE)
    assert difference.number == 5
    assert difference.text.startswith("item 5 NAV_WAYPOINT: ")
    assert names.get(field, "") in difference.text


def test_a_plan_without_items_is_cleared() -> None:
    vehicle = Vehicle(0.25, ROUTE, MISSION)
    for outcome in ("uploaded", "kept"):
        client = PlanClient(3, 1, MISSION, [])
        converse(client, vehicle)
        assert (client.outcome, vehicle.plan) == (outcome, [])
    assert "MISSION_COUNT" not in vehicle.asked


def test_home_before_a_mission_is_the_vehicles_own() -> None:
    home = PlanItem(mav.MAV_CMD_NAV_WAYPOINT, 0, 0.0, 1, 2, 3.0)
    for there, outcome in (([home, *ROUTE], "kept"), ([home, *ROUTE[1:]], "uploaded"), ([home], "uploaded")):
        client = PlanClient(3, 1, MISSION, [home._replace(x=99), *ROUTE], PlanHabits(begin_with_home=True))
        vehicle = Vehicle(plan=there, kind=MISSION)
        converse(client, vehicle)
        assert client.outcome == outcome
    for empty in ([], [home]):
        client = PlanClient(3, 1, MISSION, [], PlanHabits(begin_with_home=True))
        converse(client, Vehicle(plan=empty, kind=MISSION))
        assert client.outcome == "kept"


def test_what_an_autopilot_has_no_use_for_is_told_and_is_no_difference() -> None:
    kept = [item._replace(param2=0.0) for item in ROUTE]
    lost = PlanHabits(lost={mav.MAV_CMD_NAV_WAYPOINT: "2"})
    client = PlanClient(3, 1, MISSION, ROUTE, lost, first=1)
    converse(client, Vehicle(plan=kept, kind=MISSION))
    assert client.outcome == "kept"
    assert [one.text for one in client.lost][:1] == ["item 1 NAV_WAYPOINT: Accept Radius 2 is 0"]
    strict = PlanClient(3, 1, MISSION, ROUTE)
    vehicle = Vehicle(plan=kept, kind=MISSION)
    converse(strict, vehicle)
    assert (strict.outcome, vehicle.plan) == ("uploaded", ROUTE)


def test_what_is_said_to_another_station_is_not_taken_for_an_answer() -> None:
    vehicle = Vehicle(plan=ROUTE, kind=MISSION)
    vehicle.strays = [item._replace(x=-item.x, z=99.0) for item in ROUTE]
    client = PlanClient(3, 1, MISSION, None)
    converse(client, vehicle)
    assert client.found == tuple(ROUTE)
    theirs = PlanClient(3, 1, MISSION, None, station=OTHER_STATION)
    converse(theirs, vehicle, 20.0)
    assert (theirs.outcome, theirs.why.split(";")[0]) == ("silent", "no answer, though it was asked 6 times")
    assert theirs.why.endswith("it spoke with another ground station, 255/190, about its plan meanwhile")


def test_a_plan_that_another_station_puts_in_meanwhile_is_read_from_its_beginning() -> None:
    vehicle, client = Vehicle(plan=ROUTE, kind=MISSION), PlanClient(3, 1, MISSION, None)
    newer = [item._replace(z=50.0) for item in ROUTE[:7]]

    for step in range(60):
        exchange(client, vehicle, step / 10.0)
        if step == 5:
            vehicle.plan = newer
            ack = mav.MAVLink_mission_ack_message(*OTHER_STATION, mav.MAV_MISSION_ACCEPTED, MISSION)
            deliver(client, ack, now_s=step / 10.0)
    assert client.found == tuple(newer)


def test_a_refused_item_is_named() -> None:
    client, vehicle = PlanClient(3, 1, MISSION, ROUTE, first=1), Vehicle(kind=MISSION)
    now_s = 0.0
    while not client.done:
        if vehicle.asked.count("MISSION_ITEM_INT") == 3:
            vehicle.answer_with = mav.MAV_MISSION_INVALID_PARAM4
        exchange(client, vehicle, now_s)
        now_s += 0.1
    assert (client.outcome, client.why) == ("refused", "it answered MAV_MISSION_INVALID_PARAM4 to item 4, NAV_WAYPOINT")


def test_a_refusal_after_the_last_item_may_be_of_the_whole_plan() -> None:
    client, vehicle = PlanClient(3, 1, MISSION, ROUTE[:3], first=1), Vehicle(kind=MISSION)
    now_s = 0.0
    while not client.done:
        if vehicle.asked.count("MISSION_ITEM_INT") == 2:
            vehicle.answer_with = mav.MAV_MISSION_UNSUPPORTED
        exchange(client, vehicle, now_s)
        now_s += 0.1
    assert client.why == "it answered MAV_MISSION_UNSUPPORTED to item 3, NAV_WAYPOINT, or to the plan as a whole"


def test_an_item_out_of_turn_is_no_reason_for_a_silence_that_comes_later() -> None:
    client, vehicle = PlanClient(3, 1, MISSION, ROUTE), Vehicle(kind=MISSION)
    now_s = 0.0
    while not client.done:
        if vehicle.asked.count("MISSION_ITEM_INT") == 3:
            deliver(client, mav.MAVLink_mission_ack_message(255, 190, mav.MAV_MISSION_INVALID_SEQUENCE, MISSION))
        vehicle.lose = float(vehicle.asked.count("MISSION_ITEM_INT") >= 5)
        exchange(client, vehicle, now_s)
        now_s += 0.1
    assert (client.outcome, client.why) == ("silent", "no answer, though it was asked 6 times")
