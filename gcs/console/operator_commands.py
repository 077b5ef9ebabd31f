"""Operator commands in the console: as they stand now, and as they are sent."""

from __future__ import annotations

from gcs.console.model import SessionModel
from gcs.session.client import Message
from gcs.session.order_table import OperatorCommand


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
