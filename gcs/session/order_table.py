"""Orders of a person to a session or a monitor: key, confirmation question, and the command that is then sent."""

from __future__ import annotations

from dataclasses import dataclass, replace


@dataclass(frozen=True)
class OperatorCommand:
    """`what` is for the help page, `question` for the confirmation; `{}` in it is the vehicle's name."""

    key: str
    command: str
    name: str
    what: str
    question: str
    of_vehicle: bool = True
    means: str = ""
    """what follows from it that one might not think of"""
    of_many: bool = False
    """whether it may be given to several vehicles at once"""
    in_monitor: bool = False
    """whether a monitor takes it, too, which has no planner and refuels nothing"""


ORDERS = (
    OperatorCommand("p", "pause", "pause", "pause everything, or go on", "Pause the whole session?", of_vehicle=False),
    OperatorCommand(
        "h",
        "hold",
        "hold",
        "hold its position, out of the planner's hands",
        "Let {} hold its position?",
        means="It will not be refuelled until you return it to the planner",
        of_many=True,
        in_monitor=True,
    ),
    OperatorCommand("r", "return", "return", "return to its home", "Send {} home?", of_many=True, in_monitor=True),
    OperatorCommand("l", "land", "land", "land where it is", "Land {} where it is?", of_many=True, in_monitor=True),
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
MONITOR_ORDERS = tuple(replace(order, means="") for order in ORDERS if order.in_monitor)


def orders(*, monitor: bool) -> tuple[OperatorCommand, ...]:
    """The orders that a monitor takes, or a session."""
    return MONITOR_ORDERS if monitor else ORDERS
