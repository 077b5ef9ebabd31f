"""A vehicle that a test scripts, frame by frame, and the check of it by `gcs check`'s dialogue without a wire."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from pymavlink.dialects.v20 import common as mav

from gcs.cli.check.dialogue import CheckFinding, Dialogue
from gcs.cli.check.questions import questions
from gcs.mavlink import codec

STEP_S = 0.01
PX4_LOITER = 4 << 16 | 3 << 24


class Scripted:
    """A vehicle that is nothing but what a test makes of it; pymavlink writes its frames."""

    def __init__(self, sysid: int = 7) -> None:
        self.link = mav.MAVLink(None, srcSystem=sysid, srcComponent=1)
        self.answers: dict[str, Callable[[Any], list[Any]]] = {}
        self.streams: list[tuple[float, Callable[[int], Any]]] = [(1.0, lambda _: self.heartbeat())]
        self.asked: list[Any] = []

    def heartbeat(self, **changes: Any) -> Any:
        values = {
            "type": mav.MAV_TYPE_QUADROTOR,
            "autopilot": mav.MAV_AUTOPILOT_PX4,
            "base_mode": mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED,
            "custom_mode": PX4_LOITER,
            "system_status": mav.MAV_STATE_STANDBY,
        }
        return mav.MAVLink_heartbeat_message(**values | changes, mavlink_version=3)

    def ack(self, command: int, result: int = mav.MAV_RESULT_ACCEPTED) -> Any:
        return mav.MAVLink_command_ack_message(command, result, 0, 0, 255, 190)

    def hear(self, message: codec.Message) -> list[Any]:
        asked = codec.fields(codec.split(codec.frame(message, 0, 255, 190)).frames[0])
        self.asked.append(asked)
        answer = self.answers.get(type(asked).__name__)
        return answer(asked) if answer else []

    def frame(self, message: Any) -> codec.Frame:
        return codec.split(message.pack(self.link)).frames[0]


def obeying(*more: Any, result: int = mav.MAV_RESULT_ACCEPTED) -> Scripted:
    """A vehicle that acknowledges each COMMAND_LONG so, and then says more."""
    vehicle = Scripted()
    vehicle.answers["COMMAND_LONG"] = lambda asked: [vehicle.ack(asked.command, result), *more]
    return vehicle


def examine(
    vehicle: Scripted, *keys: str, arm: bool = False, neighbour: Scripted | None = None, **more: Any
) -> dict[str, CheckFinding]:
    """The findings of some questions, by key, with the vehicle answering 10 ms after it was asked."""
    asked = [q for q in questions(arm=arm, **more) if q.key in ("heartbeat", *keys)]
    dialogue = Dialogue(asked)
    now_s, due_s = 0.0, [0.0] * len(vehicle.streams)
    pending: list[Any] = []
    while not dialogue.done:
        now_s += STEP_S
        for i, (period_s, made) in enumerate(vehicle.streams):
            if now_s >= due_s[i]:
                due_s[i] = now_s + period_s
                pending.append(made(round(1e3 * now_s)))
        for message in pending:
            dialogue.receive(vehicle.frame(message), now_s)
        messages = dialogue.poll(now_s)
        pending = [answer for message in messages for answer in vehicle.hear(message)]
        for answer in [answer for message in messages for answer in neighbour.hear(message)] if neighbour else ():
            dialogue.receive(neighbour.frame(answer), now_s)
        assert now_s < 120.0
    return {finding.question.key: finding for finding in dialogue.findings}
