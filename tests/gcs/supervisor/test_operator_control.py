"""What a session does about the ownership of vehicles that report it; vehicles' messages are pymavlink's, the rules
those of MAVLink's development.xml."""

from __future__ import annotations

from typing import Any

import newer
import pytest
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.mavlink.command_protocol import CommandRequest
from gcs.scenario.station import Station
from gcs.supervisor.services.operator_control import ASK_EVERY_S, OperatorControl

REQUEST = newer.dialect.MAV_CMD_REQUEST_OPERATOR_CONTROL
MANAGER, ALLOWED = 1, 2
OURS, OTHER = 245, 42


class Desk:
    """A session's side of one vehicle, 3."""

    def __init__(self, **station: Any) -> None:
        self.control = OperatorControl([3], Station(sysid=OURS, **station))
        self._vehicle = mav.MAVLink(None, srcSystem=3, srcComponent=1)

    def hear(self, now_s: float, *messages: Any) -> list[str]:
        frames = codec.split(b"".join(bytes(one.pack(self._vehicle)) for one in messages)).frames
        return [event.text for event in self.control.receive(3, frames, now_s)]

    def asks(self, now_s: float, *, released: bool = False) -> list[tuple[float, ...]]:
        commands, _ = self.control.decide(3, now_s, released=released)
        return [_params(one) for one in commands]


def _params(request: CommandRequest) -> tuple[float, ...]:
    assert request.command == REQUEST
    return request.params


def owned(by: int, flags: int = MANAGER) -> Any:
    return newer.MESSAGES[512](flags, by, [0] * 10)


def request_of(station: int) -> Any:
    return mav.MAVLink_command_long_message(OURS, 0, REQUEST, 0, 1.0, 0.0, 10.0, float(station), 0.0, 0.0, 0.0)


def test_a_vehicle_that_reports_no_owner_is_asked_nothing() -> None:
    desk = Desk()
    assert desk.hear(0.0, mav.MAVLink_heartbeat_message(2, 12, 1, 0, 4, 3)) == []
    assert desk.asks(0.0) == []
    assert desk.control.give_back() == []


def test_control_is_asked_for_until_it_is_ours_and_given_back() -> None:
    desk = Desk()
    assert desk.hear(0.0, owned(0, MANAGER | ALLOWED)) == []
    assert desk.asks(0.0) == [(1.0, 0.0, 10.0, float(OURS))]
    assert desk.asks(ASK_EVERY_S - 0.1) == []
    assert desk.asks(ASK_EVERY_S) == [(1.0, 0.0, 10.0, float(OURS))]
    assert desk.hear(11.0, owned(OURS), owned(OURS)) == ["This station has control of it"]
    assert desk.asks(30.0) == []
    assert [_params(one) for one in desk.control.give_back()] == [(0.0, 0.0, 10.0, float(OURS))]


@pytest.mark.parametrize(("takeover", "allow"), [("ask", 0.0), ("allow", 1.0)])
def test_the_scenario_says_whether_the_vehicle_lets_others_have_it(takeover: str, allow: float) -> None:
    desk = Desk(takeover=takeover)
    desk.hear(0.0, owned(0))
    assert desk.asks(0.0)[0][1] == allow


def test_a_foreign_request_is_acknowledged_and_said_and_the_operator_lets_it_have_the_vehicle() -> None:
    desk = Desk()
    desk.hear(0.0, owned(OURS))
    said = desk.hear(1.0, request_of(OTHER), request_of(OTHER))
    assert said == [f"Ground station {OTHER} asks for control of it: `release` lets it have it"]
    commands, answers = desk.control.decide(3, 1.0, released=False)
    assert commands == []
    heard = [codec.fields(codec.split(codec.frame(one, 0, OURS, 190)).frames[0]) for one in answers]
    assert {(one.command, one.result, one.target_system, one.target_component) for one in heard} == {(REQUEST, 0, 3, 1)}
    assert desk.asks(2.0, released=True) == [(0.0, 0.0, 10.0, float(OURS))]
    desk.hear(3.0, owned(OTHER))
    assert desk.control.pop_taken() == set()
    assert desk.asks(60.0, released=True) == []
    assert desk.asks(60.0) == [(1.0, 0.0, 10.0, float(OURS))]  # rejoin
    assert desk.control.give_back() == []


def test_a_request_that_the_vehicle_sends_to_another_station_is_none_of_ours() -> None:
    desk = Desk()
    foreign = request_of(OTHER)
    foreign.target_system = OTHER
    assert desk.hear(0.0, owned(OURS), foreign) == ["This station has control of it"]
    assert desk.control.decide(3, 0.0, released=False) == ([], [])


def test_a_vehicle_that_another_station_takes_is_left_to_it() -> None:
    desk = Desk(takeover="allow")
    desk.hear(0.0, owned(OURS))
    assert desk.hear(1.0, owned(OTHER)) == [f"Ground station {OTHER} has control of it"]
    assert desk.asks(20.0) == []
    assert desk.control.pop_taken() == {3}
    assert desk.asks(20.0, released=True) == []


def test_one_that_was_anothers_from_the_beginning_is_asked_for_and_not_taken_from_us() -> None:
    desk = Desk()
    assert desk.hear(0.0, owned(OTHER)) == [f"Ground station {OTHER} has control of it"]
    assert desk.control.pop_taken() == set()
    assert desk.asks(0.0) == [(1.0, 0.0, 10.0, float(OURS))]
