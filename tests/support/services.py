"""Scripted vehicles that answer a schedule's commands as docs/protocol/energy.md#energy-transfer has them do, and a
play of one with them."""

import math
from dataclasses import dataclass, field
from typing import Any

from gcs.mavlink.autopilots import PX4, FlightMode
from gcs.mavlink.command_protocol import CommandRequest
from gcs.refuelling.scheduler import Scheduler
from gcs.refuelling.service import Decision, Phase, Service, TransferRole
from gcs.scenario.model import Battery, CompetitionRules, RefuellingRules, Tanker
from gcs.telemetry.state import FleetSnapshot, VehicleView

RATE_W = 2000.0
ORDER, INTERVAL, FOLLOW_TARGET = 31010, 511, 144


def view(sysid: int, role: str, at: tuple[float, float, float], remaining_j: float, capacity_j: float) -> VehicleView:
    return VehicleView(
        sysid=sysid, role=role, label=f"{role} {sysid}", alive=True, profile=PX4, mode=FlightMode.OFFBOARD, armed=True,
        landed=False, last_received_s=0.0, p_ned=at, v_ned=(0.0, 0.0, 0.0), age_s=0.0, heading_rad=0.0,
        origin_offset_ned=(0.0, 0.0, 0.0), ground_amsl_m=0.0, capacity_j=capacity_j, initial_j=remaining_j,
        battery_reported=True, drawn_j=0.0, received_j=0, given_j=0, given_reported_s=0.0, power_w=0.0,
        energy_source="energy_consumed", control_effort=0.0,
    )  # fmt: skip


def tanker(sysid: int = 201, **changed: Any) -> Tanker:
    content: dict[str, Any] = {"sysid": sysid, "start_m": (0.0, 0.0, -6.0), "airborne": True, "reserve_j": 10_000.0}
    return Tanker(**(content | {"battery": Battery(capacity_j=150_000.0)} | changed))


@dataclass
class Fleet:
    """Vehicles in their places; orders are accepted at once and joules flow with every tick, unless told otherwise."""

    views: dict[int, VehicleView]
    refused: set[tuple[int, int]] = field(default_factory=set)
    """(system id, role) of orders that are refused"""
    unheard: set[tuple[int, int]] = field(default_factory=set)
    """orders that are carried out but never acknowledged"""
    orders: list[tuple[int, ...]] = field(default_factory=list)
    active: dict[int, tuple[float, ...]] = field(default_factory=dict)
    on_the_way_j: int = 0
    """given, and not credited"""

    def set(self, sysid: int, **changed: Any) -> None:
        self.views[sysid] = self.views[sysid]._replace(**changed)

    def obey(self, schedule: Scheduler, wishes: tuple[CommandRequest, ...]) -> None:
        for wish in wishes:
            if wish.command != ORDER:
                continue
            role = int(wish.params[1])
            self.orders.append((wish.sysid, *map(int, wish.params[:6])))
            refused = (wish.sysid, role) in self.refused
            if (wish.sysid, role) not in self.unheard:
                schedule.result(wish.token, not refused)
            if refused:
                continue
            if role == TransferRole.STOP:
                self.end(wish.sysid)
            elif role == TransferRole.SETTLE:
                self.set(wish.sysid, received_j=self.views[wish.sysid].received_j + self.on_the_way_j)
                self.on_the_way_j = 0
            else:
                self.active[wish.sysid] = wish.params
                self.set(wish.sysid, mode=FlightMode.REFUEL)

    def end(self, sysid: int) -> None:
        self.active.pop(sysid, None)
        if self.views[sysid].mode is FlightMode.REFUEL:
            self.set(sysid, mode=FlightMode.OFFBOARD)

    def flow(self, dt_s: float) -> None:
        for sysid, params in list(self.active.items()):
            partner = int(params[0])
            if int(params[1]) == TransferRole.GIVE and int(self.active.get(partner, (0, 0))[1]) == TransferRole.RECEIVE:
                given_j = round(RATE_W * dt_s)
                self.set(sysid, given_j=self.views[sysid].given_j + given_j)
                self.set(partner, received_j=self.views[partner].received_j + given_j)


@dataclass
class Play:
    schedule: Scheduler
    fleet: Fleet
    now_s: float = 0.0
    decisions: list[Decision] = field(default_factory=list)

    def tick(self) -> Decision:
        return self.tick_with({})

    def tick_with(self, unreported: dict[int, dict[str, Any]]) -> Decision:
        """A tick in which some vehicles keep these values, by system id."""
        for sysid, seen in self.fleet.views.items():
            if seen.alive:
                self.fleet.set(sysid, given_reported_s=self.now_s)
                self.fleet.set(sysid, received_reported_s=self.now_s)
        for sysid, kept in unreported.items():
            self.fleet.set(sysid, **kept)
        snapshot = FleetSnapshot(self.now_s, tuple(self.fleet.views[key] for key in sorted(self.fleet.views)), ())
        decision = self.schedule.decide(snapshot)
        self.decisions.append(decision)
        self.fleet.obey(self.schedule, decision.requests)
        self.fleet.flow(0.1)
        self.now_s = round(self.now_s + 0.1, 6)
        return decision

    def until(self, phase: Phase, service: int = 0, within_s: float = 90.0) -> Service:
        end_s = self.now_s + within_s
        while not (len(self.schedule.services) > service and self.schedule.services[service].phase is phase):
            assert self.now_s < end_s, [s.phase for s in self.schedule.services]
            self.tick()
        return self.schedule.services[service]

    @property
    def kinds(self) -> list[str]:
        return [record["kind"] for decision in self.decisions for record in decision.records]


def play(
    rules: RefuellingRules | None = None,
    tankers: tuple[Tanker, ...] = (),
    transfers_until_s: float = math.inf,
    **competition: Any,
) -> Play:
    """One receiver, 1, of 10 kJ with 4 kJ left, and a tanker, 201, above it."""
    fleet = Fleet({
        1: view(1, "pursuer", (0.0, 0.0, -4.8), 4_000.0, 10_000.0),
        201: view(201, "tanker", (0.0, 0.0, -6.0), 150_000.0, 150_000.0),
    })  # fmt: skip
    rules = rules or RefuellingRules(rate_w=RATE_W, hold_s=1.0)
    return Play(
        Scheduler(CompetitionRules(**competition), rules, tankers or (tanker(),), transfers_until_s=transfers_until_s),
        fleet,
    )
