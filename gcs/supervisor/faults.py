"""Injects a scenario's faults when their time has come, and says what came of each (docs/protocol/radio.md#faults).

The radio's faults stand in the radio from the start. A vehicle is commanded by MAV_CMD_INJECT_FAILURE to have one of
its own: a launched one past the radio, which would lose the order, an external one as any command. Processes are the
session's.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from typing import Any

from gcs.link.impairment import Burst
from gcs.mavlink import codec
from gcs.mavlink.codec import Message
from gcs.mavlink.command_protocol import CommandLong, CommandRequest, CommandTarget
from gcs.mavlink.ids import AUTOPILOT
from gcs.mavlink.parameters.value import ParameterValue, to_wire
from gcs.scenario.faults import COMMANDED, ROUNDING_S, Fault, Injection
from gcs.scenario.goal import NAMED, Loss
from gcs.scenario.model import Scenario
from skytender import elementary
from skytender import mavlink as mav

INJECTED = "(injected)"
BLAMED_S = 30.0
"""[choice] A vehicle that is lost so long after a fault has ended is not lost by it."""
_UNITS = {
    "motor": mav.FAILURE_UNIT_SYSTEM_MOTOR,
    "gps_off": mav.FAILURE_UNIT_SENSOR_GPS,
    "gps_jump": mav.FAILURE_UNIT_SENSOR_GPS,
    "battery": mav.FAILURE_UNIT_SYSTEM_BATTERY,
}
_WRONG = ("gps_jump", "battery")


def _enabling(sysid: int) -> Message:
    """PARAM_SET of what a vehicle of ours needs to take MAV_CMD_INJECT_FAILURE; its integers are sent bytewise."""
    to = {"target_system": sysid, "target_component": AUTOPILOT}
    one = ParameterValue(1, mav.MAV_PARAM_TYPE_INT32)
    sent = to_wire(one, bytewise=True)
    return codec.message("PARAM_SET", **to, param_id="SYS_FAILURE_EN", param_value=sent, param_type=one.kind)


def radio_faults(
    injections: Iterable[Injection], scenario: Scenario, *, own: bool = True
) -> tuple[list[Burst], list[Burst]]:
    """Blackouts of single vehicles, the scenario's own too unless `own` is false, and other bursts, of the vehicles
    that they befall."""
    blackouts = [Burst(b.sysid, b.from_s, b.to_s, loss=1.0) for b in scenario.radio.blackouts if own]
    bursts = []
    for one in injections:
        for sysid in filter(one.befalls, sorted(vehicle.sysid for vehicle in scenario.vehicles.all)):
            if one.fault.fault == "blackout":
                blackouts.append(Burst(sysid, one.begin_s, one.end_s, loss=1.0))
            elif one.fault.fault == "loss":
                bursts.append(Burst(sysid, one.begin_s, one.end_s, loss=one.fault.share or 0.0))
            elif one.fault.fault == "delay":
                bursts.append(Burst(sysid, one.begin_s, one.end_s, delay_s=one.fault.delay_s or 0.0))
            elif one.fault.fault == "gcs_silent":
                bursts.append(Burst(sysid, one.begin_s, one.end_s, loss=1.0, only="out"))
    return blackouts, bursts


class FaultInjector:
    """The faults of one session, in order of time."""

    def __init__(self, scenario: Scenario, injections: Iterable[Injection]) -> None:
        self._vehicles = {vehicle.sysid: vehicle for vehicle in scenario.vehicles.all}
        self._pending = list(injections)
        self._count = len(scenario.faults)
        self._enabled = {fault.sysid for fault in scenario.faults if fault.fault in COMMANDED}
        """vehicles that were started so that they take such an order"""
        self.running: list[Injection] = []
        self.begun: list[Injection] = []
        """all that have happened so far"""
        self._orders: dict[int, list[Message]] = {}
        self.records: list[dict[str, Any]] = []
        self.signal_process: Callable[[int, str], object] = lambda _sysid, _fault: None
        """`kill` or `hang` a vehicle's process; set by the owner of processes"""

    @property
    def any(self) -> bool:
        """Whether there are any, so far."""
        return self._count > 0

    def add(self, fault: Fault) -> Injection:
        """Let a fault that has its time happen too; it is numbered on."""
        assert fault.at_s is not None
        self._count += 1
        one = Injection(self._count, fault, fault.at_s, fault.at_s + (fault.for_s or math.inf))
        self._pending = sorted([*self._pending, one], key=lambda one: (one.begin_s, one.number))
        return one

    def step(self, now_s: float, dead: Collection[int] = ()) -> tuple[list[Injection], list[Injection]]:
        """Faults that begin, and faults that end, by a session time; they are recorded. A fault of a vehicle that is
        dead by then does not happen."""
        due = [one for one in self._pending if one.begin_s <= now_s + ROUNDING_S]
        self._pending = self._pending[len(due) :]
        begin = [one for one in due if one.fault.sysid not in dead]
        self.running += begin
        self.begun += begin
        end = [one for one in self.running if one.end_s <= now_s + ROUNDING_S]
        self.running = [one for one in self.running if one not in end]
        for state, some in (("begins", begin), ("ends", end)):
            self.records += [self._record(one, state, now_s) for one in some]
        return begin, end

    def requests(self, one: Injection, *, ends: bool) -> list[CommandRequest]:
        """Commands to an external vehicle; a launched one's order waits for its next grant."""
        sysid = one.fault.sysid
        if one.fault.fault not in COMMANDED or sysid is None or (ends and one.fault.fault == "battery"):
            return []
        params = self._params(one, ends=ends)
        if self._vehicles[sysid].is_foreign:
            return [CommandRequest(sysid, mav.MAV_CMD_INJECT_FAILURE, params, f"fault {one.number}")]
        order = CommandLong(CommandTarget(sysid, AUTOPILOT), mav.MAV_CMD_INJECT_FAILURE, params)
        orders = self._orders.setdefault(sysid, [])
        if sysid not in self._enabled:
            self._enabled.add(sysid)
            orders.append(_enabling(sysid))
        orders.append(order.message(0))
        return []

    @property
    def ordered(self) -> Collection[int]:
        """System ids of launched vehicles for which there are orders."""
        return self._orders.keys()

    def pop_orders(self, sysid: int) -> list[Message]:
        """Orders for a launched vehicle since the last call."""
        return self._orders.pop(sysid, []) if self._orders else []

    def pop_records(self) -> list[dict[str, Any]]:
        """Decisions since the last call: which faults have begun and ended."""
        taken, self.records = self.records, []
        return taken

    def unheard(self, sysid: int) -> bool:
        """Whether a vehicle hears nothing because the ground station is silent."""
        return any(one.fault.fault == "gcs_silent" and one.befalls(sysid) for one in self.running)

    def outcomes(self, losses: Iterable[Loss]) -> list[dict[str, Any]]:
        """Each fault that has happened, and whether it was survived: no loss of a vehicle is put down to it."""
        blamed: dict[int, list[Loss]] = {}
        for loss in losses:
            if (number := self._blamed(loss)) is not None:
                blamed.setdefault(number, []).append(loss)
        found = []
        for one in self.begun:
            gone = blamed.get(one.number, [])
            after = "; ".join(f"{self._label(loss.sysid)}: {loss.why} at {loss.t_s:.1f} s" for loss in gone)
            found.append(
                {
                    "fault": one.fault.fault,
                    "sysid": one.fault.sysid,
                    "begin_s": one.begin_s,
                    "end_s": one.end_s if math.isfinite(one.end_s) else None,
                    "survived": not gone,
                    "text": f"{self._what(one)} at {one.begin_s:.1f} s" + (f" ({after})" if after else ""),
                }
            )
        return found

    def _blamed(self, loss: Loss) -> int | None:
        """The fault that a loss is put down to: of those that befell the vehicle before, the last that began."""
        before = [
            one
            for one in self.begun
            if one.befalls(loss.sysid) and one.begin_s <= loss.t_s + ROUNDING_S and loss.t_s <= one.end_s + BLAMED_S
        ]
        last = max(before, key=lambda one: (one.begin_s, one.fault.sysid is not None), default=None)
        return None if last is None else last.number

    def _params(self, one: Injection, *, ends: bool) -> tuple[float, ...]:
        """Of MAV_CMD_INJECT_FAILURE: unit, type, instance; then J that are gone, or m by which the place is off."""
        kind = mav.FAILURE_TYPE_OFF if one.fault.fault not in _WRONG else mav.FAILURE_TYPE_WRONG
        numbers = [0.0, 0.0, 0.0, 0.0]
        if one.fault.fault == "battery":
            assert one.fault.sysid is not None
            numbers[0] = round((one.fault.share or 0.0) * self._vehicles[one.fault.sysid].battery.capacity_j)
        elif one.fault.jump_m is not None:
            numbers[1:3] = one.fault.jump_m
        return (_UNITS[one.fault.fault], mav.FAILURE_TYPE_OK if ends else kind, 0.0, *numbers)

    def _label(self, sysid: int | None) -> str:
        return "all vehicles" if sysid is None else self._vehicles[sysid].label

    def _what(self, one: Injection) -> str:
        fault, who = one.fault, self._label(one.fault.sysid)
        return {
            "kill": f"the process of {who} is killed",
            "hang": f"the process of {who} hangs",
            "blackout": f"nothing from or to {who} arrives",
            "loss": f"{100.0 * (fault.share or 0.0):.0f} % of the frames of {who} are lost",
            "delay": f"the frames of {who} come {fault.delay_s or 0.0:g} s later",
            "gcs_silent": f"the ground station says nothing to {who}",
            "battery": f"{100.0 * (fault.share or 0.0):.0f} % of the battery of {who} is gone",
            "tanker_out": f"{who} can give no energy",
            "motor": f"the motors of {who} stop",
            "gps_off": f"{who} has no GPS",
            "gps_jump": f"the place of {who} is off by {elementary.norm(fault.jump_m or (0.0, 0.0)):.1f} m",
        }[fault.fault]

    def _record(self, one: Injection, state: str, now_s: float) -> dict[str, Any]:
        what = self._what(one)
        text = f"Fault: {what}" if state == "begins" else f"Fault over ({what})"
        if state == "begins" and math.isfinite(one.end_s):
            text += f", for {one.end_s - one.begin_s:g} s"
        about = {"fault": one.fault.fault, "number": one.number, "state": state}
        return {"t_s": now_s, "kind": "fault", "sysid": one.fault.sysid or 0, **about, "text": text}


def survival_text(outcomes: Sequence[Mapping[str, Any]]) -> str:
    """End of the outcome's sentence: how many of the faults, as `FaultInjector.outcomes` gives them, were survived, and
    which were not; empty without faults."""
    if not outcomes:
        return ""
    cost = [one["text"] for one in outcomes if not one["survived"]]
    survived = f"{len(outcomes) - len(cost)} of {len(outcomes)} faults survived"
    more = f"; {len(cost) - NAMED} more" if len(cost) > NAMED else ""
    return f"; {survived}" + (f", not: {'; '.join(cost[:NAMED])}{more}" if cost else "")
