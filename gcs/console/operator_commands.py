"""Table of operator commands: key, confirmation question, and the command that is then sent."""

from __future__ import annotations

from dataclasses import dataclass

from gcs.console.model import SessionModel
from gcs.session.client import Message


@dataclass(frozen=True)
class OperatorCommand:
    """`what` is for the help page, `question` for the confirmation; `{}` in it is the vehicle's name."""

    key: str
    command: str
    name: str
    what: str
    question: str
    of_vehicle: bool = True


ORDERS = (
    OperatorCommand("p", "pause", "pause", "pause everything, or go on", "Pause the whole session?", of_vehicle=False),
    OperatorCommand("h", "hold", "hold", "hold its position, out of the planner's hands", "Let {} hold its position?"),
    OperatorCommand("r", "return", "return", "return to its home", "Send {} home?"),
    OperatorCommand("l", "land", "land", "land where it is", "Land {} where it is?"),
    OperatorCommand("j", "rejoin", "rejoin", "back into the planner's hands", "Give {} back to the planner?"),
    OperatorCommand("f", "refuel", "refuel", "serve it next, whatever the competition says", "Refuel {} next?"),
    OperatorCommand(
        "s", "skip", "skip", "out of the competition, or back in", "Take {} out of the competition, or back in?"
    ),
    OperatorCommand("t", "retarget", "retarget", "pursue another target", "Which target shall {} pursue?"),
    OperatorCommand(
        "x", "stop", "stop", "end the session and save it", "Stop the session? It ends for all, and is saved.", False
    ),
)


def ready(order: OperatorCommand, watch: SessionModel) -> OperatorCommand:
    """The order as it stands now: a paused session resumes."""
    if order.command == "pause" and watch.phase == "paused":
        return OperatorCommand(order.key, "resume", "resume", order.what, "Go on with the session?", of_vehicle=False)
    return order


def question(order: OperatorCommand, watch: SessionModel, sysid: int | None) -> str:
    """Question to the operator before the command is sent."""
    return order.question.format(watch.name(sysid))


def command(order: OperatorCommand, sysid: int | None, target: int | None, number: int) -> Message:
    """The command as it is sent; its reply carries the same id."""
    content: dict[str, object] = {"command": order.command, "id": f"console-{number}"}
    if order.of_vehicle:
        content["sysid"] = sysid
    if target is not None:
        content["target"] = target
    return content


def targets(watch: SessionModel) -> list[int]:
    """The vehicles that can be pursued."""
    return sorted(sysid for sysid, vehicle in watch.vehicles.items() if vehicle.get("role") == "target")
