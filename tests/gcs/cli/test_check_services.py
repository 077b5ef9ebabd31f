"""`gcs check` of what a vehicle may have or not: listed modes, Remote ID, operator control, a twin of its system id."""

from __future__ import annotations

from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav
from scripted_vehicle import PX4_LOITER, Scripted, examine, obeying

from gcs.cli.check.dialogue import Dialogue
from gcs.cli.check.questions import questions


def mode(index: int, custom_mode: int, standard: int = 0, name: bytes = b"", count: int = 3) -> Any:
    return mav.mavlink_map[435](count, index, standard, custom_mode, 0, name)


@pytest.mark.parametrize(
    ("modes", "outcome", "words"),
    [
        ([mode(1, 7, 6), mode(2, PX4_LOITER, 0, b"Hold"), mode(3, 9, 0, b"Soar")], "ok", ""),
        ([mode(1, 7, 6), mode(3, PX4_LOITER, 0, b"Hold")], "wrong", "these of its modes never came: 2"),
        (
            [mode(1, 7, 6), mode(2, 8, 5), mode(3, 9, 0, b"Soar")],
            "wrong",
            f"custom_mode {PX4_LOITER}, which its HEARTBEAT",
        ),
        ([mode(1, 7), mode(2, PX4_LOITER, 0, b"Hold"), mode(3, 9, 7)], "wrong", "mode 7 has neither"),
    ],
)
def test_every_mode_is_to_be_listed_and_named(modes: list[Any], outcome: str, words: str) -> None:
    vehicle = Scripted()
    vehicle.answers["COMMAND_LONG"] = lambda asked: [
        vehicle.ack(asked.command), *(modes if (asked.param1, asked.param2) == (435.0, 0.0) else ()),
    ]  # fmt: skip
    finding = examine(vehicle, "available-modes")["available-modes"]
    assert (finding.outcome, words in finding.text) == (outcome, True)


def test_modes_that_come_one_by_one_are_late() -> None:
    """An ArduCopter 4.8.0-dev answers a request for all with the first, and one for an index with that."""
    vehicle, modes = Scripted(), [mode(1, 7, 6), mode(2, PX4_LOITER, 0, b"Hold"), mode(3, 9, 0, b"Soar")]
    vehicle.answers["COMMAND_LONG"] = lambda asked: [
        vehicle.ack(asked.command), *([modes[max(int(asked.param2), 1) - 1]] if asked.param1 == 435.0 else ()),
    ]  # fmt: skip
    finding = examine(vehicle, "available-modes")["available-modes"]
    assert (finding.outcome, finding.text) == ("late", "came only after it was asked 3 times")


TO_ALL = (0, 0, [0] * 20)
BASIC_ID = mav.MAVLink_open_drone_id_basic_id_message(*TO_ALL, 1, 2, [65] * 20)
WHERE = (
    mav.MAVLink_open_drone_id_location_message(*TO_ALL, *[1] * 16),
    mav.MAVLink_open_drone_id_system_message(*TO_ALL, *[1] * 12),
)
OPERATOR_ID = mav.MAVLink_open_drone_id_operator_id_message(*TO_ALL, 0, b"A1")


@pytest.mark.parametrize(
    ("sent", "outcome", "text"),
    [
        ((), "skipped", "it sends none of it"),
        (WHERE, "skipped", "it has no id, and says where it is to a transmitter that has one"),
        ((BASIC_ID, *WHERE), "missing", "OPERATOR_ID: not heard"),
        ((BASIC_ID, *WHERE, OPERATOR_ID), "ok", ""),
    ],
)
def test_remote_id_is_asked_of_a_vehicle_that_has_an_id(sent: tuple[Any, ...], outcome: str, text: str) -> None:
    vehicle = Scripted()
    vehicle.streams += [(0.5, lambda _, message=message: message) for message in sent]
    vehicle.answers["PING"] = lambda _: []  # a while in which all of it is heard
    finding = examine(vehicle, "ping", "remote-id")["remote-id"]
    assert (finding.outcome, text in finding.text) == (outcome, True)


@pytest.mark.parametrize(("flown", "outcome"), [(PX4_LOITER, "ok"), (6 << 16, "wrong")])
def test_the_current_mode_is_to_be_the_heartbeats(flown: int, outcome: str) -> None:
    assert examine(obeying(mav.mavlink_map[436](0, flown, 0)), "current-mode")["current-mode"].outcome == outcome


@pytest.mark.parametrize(("standard", "outcome"), [(7, "ok"), (5, "skipped")])
def test_a_standard_mode_is_set_where_one_is_listed(standard: int, outcome: str) -> None:
    vehicle = Scripted()
    modes = [mode(1, PX4_LOITER, 0, b"Hold", 2), mode(2, 9, standard, b"", 2)]
    vehicle.answers["COMMAND_LONG"] = lambda asked: [
        vehicle.ack(asked.command), *(modes if asked.param1 == 435.0 else ()),
    ]  # fmt: skip
    found = examine(vehicle, "available-modes", "standard-mode", arm=True)
    assert found["standard-mode"].outcome == outcome
    asked = [(one.command, one.param1) for one in vehicle.asked if type(one).__name__ == "COMMAND_LONG"]
    assert ((mav.MAV_CMD_DO_SET_STANDARD_MODE, 7.0) in asked) is (outcome == "ok")


@pytest.mark.parametrize(
    ("flags", "owner", "outcome"), [(3, 0, "ok"), (1, 255, "ok"), (0, 255, "wrong"), (None, 0, "ok")]
)
def test_operator_control_is_asked_of_a_vehicle_that_reports_its_owner(
    flags: int | None, owner: int, outcome: str
) -> None:
    vehicle = Scripted()
    status = mav.mavlink_map[512](flags or 0, owner, [0] * 10)

    def answer(asked: Any) -> list[Any]:
        if asked.command == mav.MAV_CMD_REQUEST_MESSAGE:
            return [vehicle.ack(asked.command, 3)] if flags is None else [vehicle.ack(asked.command), status]
        return [vehicle.ack(asked.command)]

    vehicle.answers["COMMAND_LONG"] = answer
    found = examine(vehicle, "control-status", "operator-control", "operator-control-released", arm=True)
    assert found["control-status"].outcome == outcome
    asked = [(one.param1, one.param4) for one in vehicle.asked if getattr(one, "command", 0) == 32100]
    assert asked == ([] if flags is None else [(1.0, 255.0), (0.0, 255.0)])
    assert (found["operator-control"].outcome == "skipped") is (flags is None)


@pytest.mark.parametrize(
    ("seen", "text"),
    [
        ({"a": 0xA1}, ""),
        ({"a": None}, ""),
        ({"a": 0xA1, "b": 0xB2}, "its system id comes from a (uid a1) and from b (uid b2)"),
        ({"a": 0xA1, "b": None}, "its system id comes from a (uid a1) and from b (uid not said)"),
    ],
)
def test_a_system_id_from_two_addresses_is_named_with_both_and_their_uids(
    seen: dict[str, int | None], text: str
) -> None:
    vehicle = Scripted()
    dialogue = Dialogue([q for q in questions() if q.key == "twin"])
    for at, uid in seen.items():
        dialogue.receive(vehicle.frame(vehicle.heartbeat()), 0.0, at)
        if uid is not None:
            version = mav.MAVLink_autopilot_version_message(0, 0, 0, 0, 0, [0] * 8, [0] * 8, [0] * 8, 0, 0, uid)
            dialogue.receive(vehicle.frame(version), 0.0, at)
    for k in range(3):
        dialogue.poll(0.1 * k)
    (finding,) = dialogue.findings
    assert (finding.outcome, finding.text) == ("wrong" if text else "ok", text)
