"""Fences and rally points put into a scripted vehicle that pymavlink speaks for, over a link that loses."""

import random
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.mavlink.plan_client import WRITES, PlanClient, PlanItem

FENCE = mav.MAV_MISSION_TYPE_FENCE
CIRCLE = int(mav.MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION)
PLAN = [PlanItem(CIRCLE, 0, 40.0 + i, 473977420 + 31 * i, -85455940 - 17 * i, 0.0) for i in range(7)]


class Vehicle:
    """One plan. It asks for items one by one, again after a second, as autopilots do."""

    def __init__(self, lose: float = 0.0, plan: list[PlanItem] | None = None) -> None:
        self.plan = list(plan or [])
        self.lose = lose
        self.answer_with: int | None = None
        """a MAV_MISSION_RESULT with which everything is answered"""
        self.rounds = 0
        """added to degrees that are read back"""
        self.radius: float | None = None
        """what every radius becomes"""
        self.asked: list[str] = []
        self.random = random.Random(11)
        self.out = mav.MAVLink(None, srcSystem=3, srcComponent=1)
        self._expected = 0
        self._coming: list[PlanItem] | None = None
        self._again_s = 0.0

    def hear(self, message: codec.Message, now_s: float) -> list[Any]:
        (m,) = self.out.parse_buffer(codec.frame(message, 0, 255, 190)) or []
        assert m.mission_type == FENCE
        assert (m.target_system, m.target_component) == (3, 1)
        self.asked.append(m.get_type())
        if self.answer_with is not None:
            return [mav.MAVLink_mission_ack_message(255, 190, self.answer_with, FENCE)]
        match m.get_type():
            case "MISSION_REQUEST_LIST":
                return [mav.MAVLink_mission_count_message(255, 190, len(self.plan), FENCE)]
            case "MISSION_REQUEST_INT":
                i = self.plan[m.seq]
                size = i.param1 if self.radius is None else self.radius
                place = (i.x + self.rounds, i.y - self.rounds, i.z)
                return [
                    mav.MAVLink_mission_item_int_message(
                        255, 190, m.seq, 5, i.command, 0, 1, size, 0, 0, 0, *place, FENCE
                    )
                ]
            case "MISSION_COUNT":
                self._expected, self._coming = m.count, []
                return self._ask(now_s)
            case "MISSION_ITEM_INT" if self._coming is not None and m.seq == len(self._coming):
                self._coming.append(PlanItem(m.command, m.frame, m.param1, m.x, m.y, m.z))
                if len(self._coming) < self._expected:
                    return self._ask(now_s)
                self.plan, self._coming = self._coming, None
                return [mav.MAVLink_mission_ack_message(255, 190, mav.MAV_MISSION_ACCEPTED, FENCE)]
        return []

    def tick(self, now_s: float) -> list[Any]:
        return self._ask(now_s) if self._coming is not None and now_s >= self._again_s else []

    def _ask(self, now_s: float) -> list[Any]:
        assert self._coming is not None
        self._again_s = now_s + 1.0
        return [mav.MAVLink_mission_request_message(255, 190, len(self._coming), FENCE)]


def converse(client: PlanClient, vehicle: Vehicle, within_s: float = 200.0) -> float:
    now_s = 0.0
    while not client.done:
        assert now_s < within_s
        answers = vehicle.tick(now_s)
        for message in client.poll(now_s):
            if vehicle.random.random() >= vehicle.lose:
                answers += vehicle.hear(message, now_s)
        for answer in answers:
            if vehicle.random.random() >= vehicle.lose:
                (frame,) = codec.split(bytes(answer.pack(vehicle.out))).frames
                client.receive(answer.get_type(), codec.fields(frame), now_s)
        now_s += 0.1
    return now_s


@pytest.mark.parametrize("lose", [0.0, 0.1, 0.25])
@pytest.mark.parametrize("before", [[], PLAN[:3], [*PLAN[:6], PLAN[0]], [*PLAN, *PLAN]])
def test_a_plan_is_written_and_read_back_whatever_the_link_loses(lose: float, before: list[PlanItem]) -> None:
    client, vehicle = PlanClient(3, 1, FENCE, PLAN), Vehicle(lose, before)
    took_s = converse(client, vehicle)
    assert (client.outcome, vehicle.plan) == ("uploaded", PLAN)
    if not lose:
        assert took_s < 5.0
        assert vehicle.asked.count("MISSION_COUNT") == 1
        assert vehicle.asked[-1] == "MISSION_ACK"


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
    assert (client.outcome, client.why) == ("differs", "read back, item 1 is another")
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
    assert took_s < (15.0 if result == mav.MAV_MISSION_ERROR else 0.5)


def test_silence_is_no_answer() -> None:
    client = PlanClient(3, 1, FENCE, PLAN)
    assert converse(client, Vehicle(lose=1.0)) < 12.0
    assert (client.outcome, client.why) == ("silent", "no answer, though it was asked 6 times")
