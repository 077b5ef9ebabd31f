"""Operators' commands: vehicles taken over and given back, services asked for and skipped, targets changed.

    hold, return, land   the vehicle is the operator's; it flies that, and takes no part in anything, until `rejoin`
    release              another ground station's: it is commanded nothing, until `rejoin`
    rejoin               back to the planner, from wherever it is; also one that a failsafe has landed
    refuel               served next, as soon as a tanker is free
    skip                 out of the competition; the same again: back in it
    retarget             follows another target from now on

An order that makes no sense is not taken, and a sentence says why. Taken or not, it is an event and a decision. This
module only orders: the arming sequences and the scheduler it is given carry it out, tick by tick.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from gcs.mavlink.autopilots import End
from gcs.recording.tick_record import event_of
from gcs.refuelling.participation import ON_MISSION, OUT_OF_ORDER, RELEASED, SKIPPED, TAKEN
from gcs.refuelling.scheduler import Scheduler
from gcs.scenario.model import Scenario
from gcs.supervisor.arming import CUT_OFF_S, ArmingSequence, Stage
from gcs.telemetry.events import Event
from gcs.telemetry.state import FleetSnapshot, VehicleView

ENDS: dict[str, tuple[End, str]] = {
    "hold": ("hold", "holds where it is"),
    "return": ("return", "returns to its home and lands there"),
    "land": ("land", "lands where it is"),
}
_BACK = {
    TAKEN: "rejoin it first", RELEASED: "rejoin it first", SKIPPED: "skip it again first",
    ON_MISSION: "it is refuelled when it has flown it",
}  # fmt: skip
"""How a vehicle comes to take part in refuelling again, by why it does not."""


class OperatorReply(NamedTuple):
    """Whether an order is taken, and a sentence about it."""

    taken: bool
    text: str


class Operator:
    """The orders so far, and what follows from them."""

    def __init__(self, scenario: Scenario, arming: Mapping[int, ArmingSequence], schedule: Scheduler) -> None:
        vehicles = scenario.vehicles
        self._arming = arming
        self._schedule, self._participation = schedule, schedule.participation
        self._refuels = bool(scenario.refuelling.enabled and (vehicles.tankers or scenario.bases))
        self._tankers_alone = bool(scenario.vehicles.tankers) and not scenario.bases
        self._on_board = scenario.competition.where == "vehicles"
        self._until = scenario.refuelling.until
        self._targets = {target.sysid for target in vehicles.targets}
        self._races = scenario.pursuit.by == "competition"
        self._follows = {p.sysid: on for p in vehicles.pursuers if (on := vehicles.target_of(p)) is not None}
        self._records: list[dict[str, Any]] = []
        self.pursuing: dict[int, int] | None = None
        """the target of each pursuer once an operator has changed one; None: as the scenario says"""

    def obey(self, content: Mapping[str, Any], snapshot: FleetSnapshot) -> tuple[OperatorReply, Event]:
        """Take an order, an object of the session's socket, or refuse it; never raises.

        `snapshot` is what is known at present; its time is the order's.
        """
        command, sysid, target = content["command"], _number(content.get("sysid")), _number(content.get("target"))
        answer = self._judge(command, sysid, target, snapshot)
        return answer, self.note(snapshot.time_s, command, answer, sysid, target)

    def note(
        self, t_s: float, command: str, answer: OperatorReply, sysid: int | None = None, target: int | None = None
    ) -> Event:
        """Record an operator's command, also one that another part carries out; the event of it."""
        named = {"sysid": sysid, "target": target}
        record = {
            "t_s": t_s,
            "kind": "operator",
            "command": command,
            **{key: value for key, value in named.items() if value is not None},
            "taken": answer.taken,
            "text": answer.text,
        }
        self._records.append(record)
        return event_of(record if sysid in self._arming else {**record, "sysid": 0})

    def pop_records(self) -> list[dict[str, Any]]:
        """The commands since the last call, as decisions."""
        taken, self._records = self._records, []
        return taken

    def _judge(self, command: str, sysid: int | None, target: int | None, snapshot: FleetSnapshot) -> OperatorReply:
        if sysid is None:
            return OperatorReply(False, f"The command {command} needs a sysid, the system id of a vehicle.")
        if (refusal := self.unreachable(sysid, snapshot)) is not None:
            return OperatorReply(False, refusal)
        view = snapshot.vehicle(sysid)
        if command == "retarget":
            return self._retarget(view, target, snapshot)
        if command == "refuel" and self._tankers_alone:
            living = [tanker.sysid for tanker in snapshot.of_role("tanker") if tanker.alive]
            if not living:
                return OperatorReply(False, "No tanker lives that could refuel it.")
            if all(OUT_OF_ORDER in self._participation.reasons.get(tanker, ()) for tanker in living):
                return OperatorReply(False, "No tanker is in order that could refuel it.")
        return _COMMANDS[command](self, view, command)

    def unreachable(self, sysid: int, snapshot: FleetSnapshot) -> str | None:
        """Why nothing can be commanded of a vehicle, as a sentence; None where something can."""
        if sysid not in self._arming:
            return f"There is no vehicle {sysid} in this session."
        view = snapshot.vehicle(sysid)
        if not view.alive:
            return f"{_name(view)} is dead."
        return f"{_name(view)} has not said anything yet." if view.last_received_s < 0.0 else None

    def _take_over(self, view: VehicleView, command: str) -> OperatorReply:
        mode, does = ENDS[command]
        self._arming[view.sysid].order(mode)
        self._participation.change(command, view.sysid)
        if not view.armed:
            does = "stays on the ground"
        elif view.age_s > CUT_OFF_S:
            does += ", once it is received again,"
        elif self._schedule.bound(view.sysid):
            does += ", once its transfer is broken off,"
        return OperatorReply(True, f"{_name(view)} {does} until it rejoins.")

    def _release(self, view: VehicleView, command: str) -> OperatorReply:
        if self._arming[view.sysid].released:
            return OperatorReply(False, f"{_name(view)} is another ground station's already.")
        self._arming[view.sysid].release()
        self._participation.change(command, view.sysid)
        return OperatorReply(True, f"{_name(view)} is another ground station's until it rejoins.")

    def _rejoin(self, view: VehicleView, command: str) -> OperatorReply:
        arming = self._arming[view.sysid]
        taken = arming.ordered is not None or arming.released
        if not taken and not arming.down and arming.stage is not Stage.YIELDED:
            return OperatorReply(False, f"{_name(view)} flies by the plan already.")
        if view.energy_source != "none" and view.remaining_j <= 0.0:
            return OperatorReply(False, f"{_name(view)} has no energy left to fly with.")
        arming.rejoin()
        self._participation.change(command, view.sysid)
        how = "flies by the plan again" if view.flying else "takes off and flies by the plan again"
        return OperatorReply(True, f"{_name(view)} {how}.")

    def _refuel(self, view: VehicleView, command: str) -> OperatorReply:
        name, out = _name(view), self._participation.out
        refusal = self._no_receiver(view)
        if refusal is None and any(view.sysid == service.receiver for service in self._schedule.open_services):
            refusal = f"{name} is being refuelled already."
        if refusal is None and view.sysid in self._participation.asked:
            refusal = f"{name} is refuelled next already."
        if refusal is None and view.sysid in out:
            refusal = f"{name} is {out[view.sysid]}: {_BACK[out[view.sysid]]}."
        if refusal is None and not view.flying:
            refusal = f"{name} is not flying."
        if refusal is None and view.remaining_j >= self._until * view.capacity_j:
            share = f"{100.0 * view.remaining_j / view.capacity_j:.0f} %"
            refusal = f"{name} has {share}, and is filled up to {100.0 * self._until:.0f} %."
        if refusal is not None:
            return OperatorReply(False, refusal)
        self._participation.change(command, view.sysid)
        return OperatorReply(True, f"{name} is refuelled next, as soon as a {self._giver(view)} is free.")

    def _skip(self, view: VehicleView, command: str) -> OperatorReply:
        if (refusal := self._no_receiver(view)) is not None:
            return OperatorReply(False, refusal)
        self._participation.change(command, view.sysid)
        if not self._participation.skips(view.sysid):
            return OperatorReply(True, f"{_name(view)} competes for the {self._giver(view)} again.")
        served = any(view.sysid == service.receiver for service in self._schedule.open_services)
        after = "; its refuelling is broken off" if served else ""
        return OperatorReply(True, f"{_name(view)} is not refuelled until it is let back in{after}.")

    def _giver(self, view: VehicleView) -> str:
        return "base" if view.sysid in self._schedule.unable else "tanker"

    def _no_receiver(self, view: VehicleView) -> str | None:
        if not self._refuels:
            return "No vehicle is refuelled in this session."
        if self._on_board:
            return "In this session the vehicles decide the refuelling among themselves."
        return None if view.role == "pursuer" else f"{_name(view)} is no pursuer: only these are refuelled."

    def _retarget(self, view: VehicleView, target: int | None, snapshot: FleetSnapshot) -> OperatorReply:
        if self._races:
            return OperatorReply(False, "In this session a competition decides which vehicle pursues which target.")
        if view.sysid not in self._follows:
            return OperatorReply(False, f"{_name(view)} follows no target.")
        if target not in self._targets:
            there = ", ".join(map(str, sorted(self._targets)))
            return OperatorReply(False, f"The command retarget needs a target, one of {there}.")
        lead = snapshot.vehicle(target)
        if not lead.alive:
            return OperatorReply(False, f"{_name(lead)} is dead.")
        follows = self.pursuing or self._follows
        if follows[view.sysid] == target:
            return OperatorReply(False, f"{_name(view)} follows {lead.label} already.")
        self.pursuing = {**follows, view.sysid: target}
        return OperatorReply(True, f"{_name(view)} follows {lead.label} from now on.")


_COMMANDS: dict[str, Callable[[Operator, VehicleView, str], OperatorReply]] = {
    **dict.fromkeys(ENDS, Operator._take_over),
    "release": Operator._release,
    "rejoin": Operator._rejoin,
    "refuel": Operator._refuel,
    "skip": Operator._skip,
}
COMMANDS = (*_COMMANDS, "retarget")


def _number(value: Any) -> int | None:
    """A system id as the schema of decisions takes it."""
    return value if isinstance(value, int) and not isinstance(value, bool) and 1 <= value <= 254 else None


def _name(view: VehicleView) -> str:
    return view.label[:1].upper() + view.label[1:]
