"""Operator commands in the console: confirmation, sending, notices of replies; and the keys of a replay."""

from __future__ import annotations

from collections.abc import Callable

from gcs.console.dialogs import Choose, Confirm
from gcs.console.model import SessionModel, Vehicle
from gcs.console.pages import fleet
from gcs.console.shell import Shell
from gcs.console.text import number
from gcs.session.client import Message
from gcs.session.order_table import OperatorCommand, orders
from gcs.session.plain_text import clean

SEEK_S = 10.0
SPEEDS = (0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0)


class OperatorControls:
    """Sends what a person has confirmed; `say` shows a notice."""

    def __init__(self, app: Shell, say: Callable[[str], object]) -> None:
        self._app, self._say = app, say
        self._sent = 0
        self._names: dict[str, str] = {}

    def ask(self, name: str, chosen: int | None, *, insist: bool = False) -> None:
        """Ask about the order `name` for the chosen vehicle, then send it; `insist`: a second Ctrl-C is a yes."""
        seen = self._app.seen
        if seen.replay is not None and name == "pause":
            self.play()
        elif not seen.control:
            self._say(_why_none(seen))
        elif (given := _order(name, seen)) is None:
            self._say(f"a monitor takes no {name}: it knows hold, return and land")
        else:
            order = _ready(given, seen)
            sysid = chosen if order.of_vehicle else None
            if order.of_vehicle and sysid is None:
                self._say("no vehicle is chosen")
            elif order.command == "retarget":
                self._ask_target(order, sysid)
            else:
                self._confirm(order, sysid, insist=insist)

    def _confirm(self, order: OperatorCommand, sysid: int | None, *, insist: bool) -> None:
        def answer(yes: bool | None) -> None:
            if yes:
                self._send(order, sysid)

        seen, glyphs = self._app.seen, self._app.glyphs

        def detail() -> str:
            vehicle = seen.vehicles.get(-1 if sysid is None else sysid)
            now = [] if vehicle is None else [_state(vehicle)]
            return ". ".join([*now, *([order.means] if order.means else [])])

        self._app.push_screen(Confirm(order.question.format(seen.name(sysid)), detail, glyphs, insist=insist), answer)

    def _ask_target(self, order: OperatorCommand, sysid: int | None) -> None:
        seen, glyphs = self._app.seen, self._app.glyphs
        targets = sorted(sysid for sysid, vehicle in seen.vehicles.items() if vehicle.get("role") == "target")
        options = [(target, seen.name(target)) for target in targets]
        if not options:
            self._say("there is no target")
            return

        def answer(target: int | None) -> None:
            if target is not None:
                self._send(order, sysid, target)

        self._app.push_screen(Choose(order.question.format(seen.name(sysid)), options, glyphs), answer)

    def _send(self, order: OperatorCommand, sysid: int | None, target: int | None = None) -> None:
        self._sent += 1
        content: dict[str, object] = {"command": order.command, "id": f"console-{self._sent}"}
        content |= {"sysid": sysid} if order.of_vehicle else {}
        content |= {} if target is None else {"target": target}
        what = f"{order.name} {self._app.seen.name(sysid)}" if sysid is not None else order.name
        self._names[str(content["id"])] = what
        self._app.source.send(content)
        self._say(f"{what}: sent")

    def concerns(self, reply: Message) -> bool:
        """Whether a reply is worth a notice: to an order, or a refusal; that a page may be filled shows by itself."""
        return not reply.get("ok") or str(reply.get("id")) in self._names

    def answered(self, reply: Message) -> tuple[str, str]:
        """(a notice, its style) of a reply."""
        what = self._names.pop(str(reply.get("id")), "")
        text = clean(reply.get("text") or ("taken" if reply.get("ok") else "not taken"))
        return f"{what}: {text}" if what else text, "well" if reply.get("ok") else "act"

    # replay

    def play(self) -> None:
        """Pause the replay, or go on."""
        if (replay := self._app.seen.replay) is not None:
            stands = replay.get("paused") or self._app.seen.phase == "ended"
            self._app.source.send({"command": "resume" if stands else "pause"})

    def hurry(self, step: int) -> None:
        """The next speed, up or down."""
        speed = float((self._app.seen.replay or {}).get("speed") or 1.0)
        nearest = min(range(len(SPEEDS)), key=lambda i: abs(SPEEDS[i] - speed))
        wanted = SPEEDS[min(max(nearest + step, 0), len(SPEEDS) - 1)]
        self._app.source.send({"command": "speed", "speed": wanted})

    def seek(self, steps: int) -> None:
        """Ten seconds on or back per step."""
        self._app.source.send({"command": "seek", "t_s": self._app.seen.t_s + SEEK_S * steps})


def _why_none(seen: SessionModel) -> str:
    """Why a source takes no commands and, where something helps, what."""
    if seen.monitors:
        return "this monitor only watches; start it with --control to give orders"
    return f"{'a recording' if seen.replay is not None else 'this source'} takes no commands"


def _order(name: str, seen: SessionModel) -> OperatorCommand | None:
    """An order that the other end takes."""
    return next((order for order in orders(monitor=seen.monitors) if order.command == name), None)


def _ready(order: OperatorCommand, seen: SessionModel) -> OperatorCommand:
    """The order as it stands now: a paused session resumes."""
    if order.command == "pause" and seen.phase == "paused":
        return OperatorCommand(order.key, "resume", "resume", order.what, "Go on with the session?", of_vehicle=False)
    return order


def _state(vehicle: Vehicle) -> str:
    """Page that the operator should see while deciding."""
    mode, _ = fleet.mode(vehicle)
    share = vehicle.get("battery")
    battery = "" if share is None else f", battery {100.0 * float(share):.0f} %"
    return f"{mode}, {number(vehicle.get('height_m'), 6)} m high{battery}"
