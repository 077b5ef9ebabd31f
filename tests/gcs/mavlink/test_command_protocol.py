"""The command protocol: one table of acknowledgements in, events and messages out; no clock but the test's."""

import math
from typing import Any

import pytest
from pymavlink.dialects.v20 import common

from gcs.mavlink import codec
from gcs.mavlink.codec import Message
from gcs.mavlink.command_protocol import PROGRESS_S, CommandLong, CommandQueue, CommandResult, CommandTarget

ARM, TAKEOFF = common.MAV_CMD_COMPONENT_ARM_DISARM, common.MAV_CMD_NAV_TAKEOFF
ACCEPTED, DENIED, IN_PROGRESS = (
    common.MAV_RESULT_ACCEPTED,
    common.MAV_RESULT_DENIED,
    common.MAV_RESULT_IN_PROGRESS,
)
VEHICLE = CommandTarget(3, 1)


def ack(command: int, result: int = ACCEPTED, target: tuple[int, int] = (255, 190)) -> Any:
    raw = codec.encode(
        "COMMAND_ACK", 0, 3, 1, command=command, result=result, target_system=target[0], target_component=target[1]
    )
    return codec.fields(codec.split(raw).frames[0])


def decoded(message: Message) -> Any:
    """The message as pymavlink reads it."""
    (read,) = common.MAVLink(None).parse_buffer(codec.frame(message, 0, 255, 190))
    return read


@pytest.fixture
def queue() -> CommandQueue:
    return CommandQueue(255, 190)


def test_command_long_reaches_pymavlink_whole(queue: CommandQueue) -> None:
    (message,) = queue.send(CommandLong(VEHICLE, TAKEOFF, (1, 2, 3, math.nan, 5, 6, 7)), 0.0)
    read = decoded(message)
    assert (read.get_type(), read.command, read.confirmation) == ("COMMAND_LONG", TAKEOFF, 0)
    assert (read.target_system, read.target_component) == VEHICLE
    assert [read.param1, read.param2, read.param3, read.param5, read.param6, read.param7] == [1, 2, 3, 5, 6, 7]
    assert math.isnan(read.param4)


def test_acceptance_ends_the_command(queue: CommandQueue) -> None:
    queue.send(CommandLong(VEHICLE, ARM, (1,)), 0.0, token="arm 3")
    step = queue.on_ack(3, 1, ack(ARM), 0.1)
    assert step == ([], [CommandResult(ARM, VEHICLE, "accepted", ACCEPTED, 1, "arm 3")])
    assert not queue._waiting
    assert queue.poll(99.0) == ([], [])
    assert queue.resent == 0


@pytest.mark.parametrize("result", [1, 2, 3, 4, 6])
def test_any_other_final_result_is_a_rejection_with_its_code(queue: CommandQueue, result: int) -> None:
    queue.send(CommandLong(VEHICLE, ARM, (1,)), 0.0)
    assert queue.on_ack(3, 1, ack(ARM, result), 0.1).results == [
        CommandResult(ARM, VEHICLE, "rejected", result, 1, None)
    ]


def test_silence_brings_three_repetitions_half_a_second_apart_then_a_time_out(queue: CommandQueue) -> None:
    queue.send(CommandLong(VEHICLE, ARM, (1,)), 10.0)
    seen = []
    for tick in range(1, 40):
        now_s = 10.0 + tick * 0.1
        step = queue.poll(now_s)
        seen += [(round(now_s, 6), decoded(message).confirmation) for message in step.messages]
        seen += [(round(now_s, 6), result) for result in step.results]
    assert seen == [
        (10.5, 1),
        (11.0, 2),
        (11.5, 3),
        (12.0, CommandResult(ARM, VEHICLE, "timeout", None, 4, None)),
    ]
    assert queue.resent == 3
    assert not queue._waiting


def test_progress_extends_and_a_lost_final_acknowledgement_is_asked_for_again(queue: CommandQueue) -> None:
    queue.send(CommandLong(VEHICLE, TAKEOFF), 0.0)
    assert queue.on_ack(3, 1, ack(TAKEOFF, IN_PROGRESS), 0.4) == ([], [])
    assert queue.on_ack(3, 1, ack(TAKEOFF, IN_PROGRESS), 4.0) == ([], [])
    assert queue.poll(4.0 + PROGRESS_S - 0.01) == ([], [])
    (message,) = queue.poll(4.0 + PROGRESS_S).messages
    assert decoded(message).confirmation == 1
    assert queue.on_ack(3, 1, ack(TAKEOFF), 9.1).results[0].outcome == "accepted"


def test_same_id_waits_its_turn_and_others_do_not(queue: CommandQueue) -> None:
    first = CommandLong(VEHICLE, common.MAV_CMD_SET_MESSAGE_INTERVAL, (30,))
    second = CommandLong(VEHICLE, common.MAV_CMD_SET_MESSAGE_INTERVAL, (32,))
    assert len(queue.send(first, 0.0, token=1)) == 1
    assert queue.send(second, 0.0, token=2) == []
    assert len(queue.send(CommandLong(VEHICLE, ARM), 0.0)) == 1
    assert len(queue.send(CommandLong(CommandTarget(3, 100), first.command, (30,)), 0.0)) == 1
    step = queue.on_ack(3, 1, ack(first.command, DENIED), 0.1)
    assert [result.token for result in step.results] == [1]
    assert [decoded(message).param1 for message in step.messages] == [32]
    assert queue.on_ack(3, 1, ack(first.command), 0.2).results[0].token == 2


def test_acknowledgements_for_others_from_others_or_of_nothing_are_ignored(queue: CommandQueue) -> None:
    queue.send(CommandLong(VEHICLE, ARM, (1,)), 0.0)
    for sysid, compid, stray in (
        (3, 1, ack(ARM, target=(254, 190))),
        (3, 1, ack(ARM, target=(255, 191))),
        (3, 1, ack(TAKEOFF)),
        (4, 1, ack(ARM)),
        (3, 100, ack(ARM)),
    ):
        assert queue.on_ack(sysid, compid, stray, 0.1) == ([], [])
    assert queue._waiting


def test_unaddressed_acknowledgement_and_any_component_of_a_broadcast_count(queue: CommandQueue) -> None:
    queue.send(CommandLong(VEHICLE, ARM, (1,)), 0.0)
    assert len(queue.on_ack(3, 1, ack(ARM, target=(0, 0)), 0.1).results) == 1
    queue.send(CommandLong(CommandTarget(3, 0), ARM, (1,)), 1.0)
    assert queue.on_ack(3, 1, ack(ARM), 1.1).results[0].target == (3, 0)


def test_command_that_does_not_fit_is_refused_and_leaves_no_trace(queue: CommandQueue) -> None:
    with pytest.raises(ValueError, match="holds 7"):
        queue.send(CommandLong(VEHICLE, ARM, (0.0,) * 8), 0.0)
    with pytest.raises(ValueError, match=r"COMMAND_LONG.target_system cannot be 256"):
        queue.send(CommandLong(CommandTarget(256, 1), ARM), 0.0)
    assert not queue._waiting


def test_what_is_withdrawn_is_sent_no_more_and_what_waits_behind_it_goes(queue: CommandQueue) -> None:
    queue.send(CommandLong(VEHICLE, ARM), 0.0, token="old")
    queue.send(CommandLong(VEHICLE, ARM), 0.0, token="older")
    queue.send(CommandLong(VEHICLE, TAKEOFF), 0.0, token="kept")
    assert queue.withdraw(lambda token: token.startswith("old")) == ["older"]
    assert queue.send(CommandLong(VEHICLE, ARM), 0.1, token="new") == []
    step = queue.poll(0.5)
    assert [decoded(message).command for message in step.messages] == [ARM, TAKEOFF]
    assert [(result.token, result.outcome) for result in step.results] == [("old", "timeout")]
    (ended,) = queue.on_ack(3, 1, ack(ARM), 0.6).results
    assert (ended.token, ended.outcome) == ("new", "accepted")


def test_a_withdrawn_command_may_still_be_acknowledged(queue: CommandQueue) -> None:
    queue.send(CommandLong(VEHICLE, ARM), 0.0, token="old")
    assert queue.withdraw(lambda _: True) == []
    assert [result.outcome for result in queue.on_ack(3, 1, ack(ARM), 0.1).results] == ["accepted"]
    assert not queue._waiting
