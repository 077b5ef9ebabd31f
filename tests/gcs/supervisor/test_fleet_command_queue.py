"""What waits for each vehicle's next grant, and which commands are under way; no clock but the test's."""

from typing import Any

from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.mavlink.command_protocol import ARMING, CommandRequest
from gcs.supervisor.fleet_command_queue import FleetCommandQueue

ARM = CommandRequest(3, mav.MAV_CMD_COMPONENT_ARM_DISARM, (), f"{ARMING} arm")
SERVE = CommandRequest(3, mav.MAV_CMD_USER_1, (), "5 receive")


def commands(queue: FleetCommandQueue, sysid: int = 3) -> list[int]:
    """The ids of the commands that leave for a vehicle now."""
    return [codec.fields(codec.split(codec.frame(m, 0, 255, 190)).frames[0]).command for m in queue.pop(sysid)]


def ack(wish: CommandRequest) -> Any:
    raw = codec.encode(
        "COMMAND_ACK", 0, wish.sysid, 1, command=wish.command, result=0, target_system=255, target_component=190
    )
    return codec.fields(codec.split(raw).frames[0])


def test_what_is_put_leaves_once_in_order_and_for_its_vehicle_alone() -> None:
    queue = FleetCommandQueue([3, 4])
    ping, pong = (codec.message("PING", time_usec=t, seq=t, target_system=0, target_component=0) for t in (1, 2))
    queue.put(3, [ping])
    queue.put(3, [pong])
    assert queue.pop(4) == []
    assert queue.pop(3) == [ping, pong]
    assert queue.pop(3) == []


def test_a_command_is_sent_again_until_it_is_acknowledged_and_then_told() -> None:
    queue = FleetCommandQueue([3])
    queue.ask([ARM], 0.0)
    assert commands(queue) == [ARM.command]
    assert queue.poll(3, 0.6) == []
    assert commands(queue) == [ARM.command]
    assert (queue.resent, queue.awaits(ARM.token)) == (1, True)
    (result,) = queue.on_ack(3, ack(ARM), 0.7)
    assert (result.outcome, result.token) == ("accepted", ARM.token)
    assert not queue.awaits(ARM.token)


def test_what_is_asked_once_is_not_lined_up_behind_itself() -> None:
    queue = FleetCommandQueue([3])
    for now_s in (0.0, 0.1):
        queue.ask_once([ARM], now_s)
    assert commands(queue) == [ARM.command]
    queue.on_ack(3, ack(ARM), 0.2)
    assert commands(queue) == []
    queue.ask_once([ARM], 0.3)
    assert commands(queue) == [ARM.command]


def test_a_withdrawn_command_that_waited_its_turn_may_be_asked_again_at_once() -> None:
    queue = FleetCommandQueue([3])
    waits = CommandRequest(3, SERVE.command, (), f"{ARMING} arm")
    queue.ask([SERVE, waits], 0.0)
    assert commands(queue) == [SERVE.command]
    queue.withdraw(3)
    assert not queue.awaits(waits.token)


def test_what_waits_is_forgotten_and_its_commands_are_not() -> None:
    queue = FleetCommandQueue([3])
    queue.ask([ARM], 0.0)
    queue.clear()
    assert commands(queue) == []
    queue.poll(3, 0.6)
    assert commands(queue) == [ARM.command]
