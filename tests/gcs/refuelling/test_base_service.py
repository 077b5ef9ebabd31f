"""Services at a base, from the decision to the end, against a scripted vehicle; joules are added up by hand."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import pytest
import views as base

from gcs.mavlink.autopilots import FlightMode
from gcs.mavlink.command_protocol import CommandRequest
from gcs.refuelling.explain import sentence
from gcs.refuelling.scheduler import Scheduler
from gcs.refuelling.service import Decision, Phase, Service, TransferRole
from gcs.scenario.model import Base, Battery, CompetitionRules, RefuellingRules, Tanker
from gcs.telemetry.state import FleetSnapshot, VehicleView

ORDER = 31010
PAD = Base(name="pad", position_m=(10.0, 0.0, 0.0), rate_w=2000.0, stock_j=50_000.0)
CAPACITY_J = 10_000.0


def view(sysid: int, role: str = "pursuer", **changed: Any) -> VehicleView:
    poor = {"p_ned": (0.0, 0.0, -4.8), "capacity_j": CAPACITY_J, "initial_j": 4_000.0, "drawn_j": 0.0, "power_w": 0.0}
    return base.view(sysid, role, **(poor | changed))


@dataclass
class World:
    """Vehicles that go where they are led at once, land when they are to, and count what bases tell them of."""

    schedule: Scheduler
    views: dict[int, VehicleView]
    hears: bool = True
    """whether receivers credit what the base's XferOut tells"""
    accepts: bool = True
    stays_away: bool = False
    climbs_m: float = 2.5
    now_s: float = 0.0
    told: int = 0
    starts: dict[int, int] = field(default_factory=dict)
    credited: dict[int, int] = field(default_factory=dict)
    orders: list[tuple[int, ...]] = field(default_factory=list)
    decisions: list[Decision] = field(default_factory=list)

    def set(self, sysid: int, **changed: Any) -> None:
        self.views[sysid] = self.views[sysid]._replace(**changed)

    def tick(self) -> Decision:
        decision = self.schedule.decide(
            FleetSnapshot(self.now_s, tuple(self.views[key] for key in sorted(self.views)), ())
        )
        self.decisions.append(decision)
        for wish in decision.requests:
            self._obey(wish)
        for sysid, place in decision.stations.items():
            if not self.stays_away:
                self.set(sysid, p_ned=place)
        for sysid, seen in list(self.views.items()):
            on_ground = sysid in decision.grounded
            if on_ground and not seen.landed:
                n, e, _ = seen.p_ned or (0.0, 0.0, 0.0)
                self.set(sysid, landed=True, armed=False, mode=FlightMode.LAND, p_ned=(n, e, 0.0))
            elif not on_ground and seen.landed:
                n, e, _ = seen.p_ned or (0.0, 0.0, 0.0)
                self.set(sysid, landed=False, armed=True, mode=FlightMode.OFFBOARD, p_ned=(n, e, -self.climbs_m))
        for report in decision.giver_reports:
            if self.hears and report.sysid in self.starts:
                gained = report.given_j - self.starts[report.sysid] - self.credited.get(report.sysid, 0)
                self.credited[report.sysid] = self.credited.get(report.sysid, 0) + gained
                self.set(report.sysid, received_j=self.views[report.sysid].received_j + gained)
        for sysid, joules in decision.booked.items():
            self.set(sysid, received_j=self.views[sysid].received_j + joules)
        self.now_s = round(self.now_s + 0.1, 6)
        return decision

    def _obey(self, wish: CommandRequest) -> None:
        assert wish.command == ORDER
        self.orders.append((wish.sysid, *map(int, wish.params[:6])))
        role = int(wish.params[1])
        self.schedule.result(wish.token, self.accepts or role == TransferRole.STOP)
        if role == TransferRole.RECEIVE and self.accepts:
            self.starts[wish.sysid], self.credited[wish.sysid] = int(wish.params[5]), 0
        elif role == TransferRole.STOP:
            self.starts.pop(wish.sysid, None)

    def until(self, phase: Phase, service: int = 0, within_s: float = 120.0) -> Service:
        end_s = self.now_s + within_s
        while not (len(self.schedule.services) > service and self.schedule.services[service].phase is phase):
            assert self.now_s < end_s, [s.phase for s in self.schedule.services]
            self.tick()
        return self.schedule.services[service]

    @property
    def records(self) -> list[dict[str, Any]]:
        return [record for decision in self.decisions for record in decision.records]


def world(
    *views: VehicleView,
    bases: tuple[Base, ...] = (PAD,),
    rules: RefuellingRules | None = None,
    competition: CompetitionRules | None = None,
    transfers_until_s: float = math.inf,
    **changed: Any,
) -> World:
    seen = views or (view(1),)
    unable = {one.sysid: False for one in seen if one.role == "pursuer"}
    schedule = Scheduler(
        competition or CompetitionRules(),
        rules or RefuellingRules(hold_s=1.0),
        (),
        bases=bases,
        transfer_capable=unable,
        cruise_m_s=1.5,
        transfers_until_s=transfers_until_s,
    )
    return World(schedule, {one.sysid: one for one in seen}, **changed)


def test_a_whole_service_in_its_order() -> None:
    game = world()
    service = game.until(Phase.DONE)
    assert [record["kind"] for record in game.records] == ["unable", "decided", "transfer", "served"]
    assert service.ended_by == "full"
    # 90 % of 10 kJ, 4 kJ on board
    assert service.energy_j == 5_000
    (stock,) = game.schedule.stocks
    assert (stock.given_j, stock.remaining_j) == (5_000, 45_000.0)
    assert (service.tanker, service.base) == (None, "pad")
    assert service.joined_at_s is not None
    assert service.start_s is not None
    assert service.end_s is not None
    assert service.end_s - service.start_s >= 5_000 / 2000.0
    assert game.schedule.refuelled == [service]


def test_the_schedule_says_that_a_base_serves_it_and_why() -> None:
    game = world()
    game.until(Phase.DONE)
    unable, decided, begun, served = game.records
    assert unable == {"kind": "unable", "receiver": 1, "reason": "the scenario says so"}
    assert (decided["base"], decided["tanker"], decided["by"]) == ("pad", None, "unopposed")
    assert decided["reason"] == "cannot take a transfer: the scenario says so"
    assert "at base pad" in sentence(decided)
    assert "cannot take a transfer" in sentence(decided)
    assert [sentence(record) for record in (begun, served)] == [
        "Charging of 1 at base pad begun", "Refuelling of 1 at base pad ended: full, 5000 J",
    ]  # fmt: skip


def test_the_ground_station_is_the_partner_on_the_wire() -> None:
    """MAV_CMD_USER_1: partner 255, role, limit in J, rate in W, transfer id, the base's XferOut at the start."""
    game = world()
    game.until(Phase.DONE)
    assert game.orders == [
        (1, 255, TransferRole.RECEIVE, 5000, 2000, 1, 0),
        (1, 255, TransferRole.STOP, 5000, 2000, 1, 0),
    ]
    game.set(1, drawn_j=5_000.0)
    game.until(Phase.DONE, 1)
    assert game.orders[2] == (1, 255, TransferRole.RECEIVE, 5000, 2000, 2, 5000)


def test_it_is_led_above_the_base_before_it_is_to_land() -> None:
    game = world(stays_away=True)
    decisions = [game.tick() for _ in range(200)]
    assert {d.stations[1] for d in decisions if d.stations} == {(10.0, 0.0, -2.5)}
    assert not any(d.grounded for d in decisions)
    game.stays_away = False
    game.until(Phase.LAND)
    assert game.tick().grounded == {1}


def test_what_never_arrives_is_given_up_and_competes_again() -> None:
    game = world(stays_away=True)
    assert game.until(Phase.DONE).ended_by == "did not reach the base in time"
    game.stays_away = False
    assert game.until(Phase.DONE, 1).energy_j == 5_000


def test_a_base_serves_one_at_a_time_and_the_needier_first() -> None:
    game = world(view(1, initial_j=4_500.0), view(2, initial_j=2_500.0, p_ned=(0.0, 4.0, -4.8)))
    game.until(Phase.DONE, 1)
    for decision in game.decisions:
        assert len(decision.stations.keys() | decision.grounded) <= 1
    assert [service.receiver for service in game.schedule.services] == [2, 1]
    first, second = game.schedule.services
    assert first.end_s is not None
    assert first.end_s <= second.decided_at_s


def test_two_bases_serve_two_at_once_each_the_nearer_one() -> None:
    other = Base(name="other", position_m=(-10.0, 0.0, 0.0), stock_j=50_000.0)
    game = world(
        view(1, p_ned=(-8.0, 0.0, -4.8)), view(2, initial_j=3_000.0, p_ned=(8.0, 0.0, -4.8)), bases=(other, PAD)
    )  # fmt: skip
    game.until(Phase.DONE, 1)
    assert {service.receiver: service.base for service in game.schedule.services} == {1: "other", 2: "pad"}
    assert any(len(decision.grounded) == 2 for decision in game.decisions)


def test_tankers_serve_those_who_can_and_bases_those_who_cannot() -> None:
    tanker = Tanker(sysid=201, start_m=(0.0, 0.0, -6.0), airborne=True, battery=Battery(capacity_j=150_000.0))
    views = (view(1), view(2), view(201, "tanker", p_ned=(0.0, 0.0, -6.0), capacity_j=15e4, initial_j=15e4))
    schedule = Scheduler(
        CompetitionRules(), RefuellingRules(), (tanker,), bases=(PAD,), transfer_capable={1: True, 2: False}
    )
    for k in range(40):
        schedule.decide(FleetSnapshot(0.1 * k, views, ()))
    assert {service.receiver: service.giver for service in schedule.services} == {1: "201", 2: "base pad"}
    tanked, based = schedule.competition_states
    assert (2 in tanked.tau, 1 in based.tau) == (False, False)


def test_without_a_base_who_cannot_take_a_transfer_is_served_by_nobody() -> None:
    tanker = Tanker(sysid=201, start_m=(0.0, 0.0, -6.0), airborne=True, battery=Battery(capacity_j=150_000.0))
    views = (view(2), view(201, "tanker", capacity_j=15e4, initial_j=15e4))
    schedule = Scheduler(CompetitionRules(), RefuellingRules(), (tanker,), transfer_capable={2: False})
    records = [record for k in range(600) for record in schedule.decide(FleetSnapshot(0.1 * k, views, ())).records]
    assert [record["kind"] for record in records] == ["unable"]


def test_one_that_would_not_last_goes_first() -> None:
    lasts, hungry = view(1, initial_j=2_000.0), view(2, initial_j=5_000.0, power_w=200.0)
    service = world(lasts, hungry, competition=CompetitionRules(bids="time")).until(Phase.DONE)
    assert (service.receiver, service.by) == (2, "competition")  # 1 is emptier, but lasts longer


def test_what_never_arrives_comes_back_to_the_base_and_its_counter_never_falls() -> None:
    """The receiver hears nothing for the transfer's last 0.6 s at 2000 W, and takes off with what it has."""
    game = world()
    game.until(Phase.TRANSFER)
    for _ in range(10):
        game.tick()
    game.hears = False
    for _ in range(6):
        game.tick()
    game.set(1, landed=False, armed=True)
    game.until(Phase.STOP_RECEIVER)
    reported = {"received_reported_s": game.now_s}
    (stock,) = game.schedule.stocks
    given_j, credited_j = stock.given_j, game.views[1].received_j
    game.until(Phase.TAKE_OFF)
    game.set(1, **reported)
    for _ in range(10):
        game.tick()
    assert stock.remaining_j == PAD.stock_j - given_j, "not before it has said again what it credited"
    game.set(1, received_reported_s=game.now_s)
    for _ in range(10):
        game.tick()
    assert stock.remaining_j == PAD.stock_j - credited_j
    assert stock.given_j == given_j
    (settled,) = [record for record in game.records if record["kind"] == "settled"]
    missing_j = given_j - credited_j
    assert missing_j > 0
    assert settled == {"kind": "settled", "receiver": 1, "tanker": None, "base": "pad", "energy_j": missing_j}
    assert sentence(settled) == f"Base pad took back {missing_j} J that had not arrived at 1"


def test_over_a_radio_charging_ends_in_time_to_be_settled() -> None:
    whole = world().until(Phase.DONE)
    assert whole.start_s is not None
    game = world(transfers_until_s=whole.start_s + 1.0)
    service = game.until(Phase.DONE)
    assert service.ended_by == "the session ends"
    assert 0 < service.energy_j < 5_000
    late = world(transfers_until_s=1.0).until(Phase.DONE)
    assert (late.ended_by, late.energy_j) == ("the session ends", 0)


def test_a_vehicle_that_knows_no_transfers_is_charged_by_the_book() -> None:
    game = world(view(1, battery_reported=False))
    service = game.until(Phase.DONE)
    assert game.orders == []
    assert not any(decision.giver_reports for decision in game.decisions)
    booked = sum(sum(decision.booked.values()) for decision in game.decisions)
    assert booked == service.energy_j == game.schedule.stocks[0].given_j == 5_000
    assert all(0 <= joules <= 201 for decision in game.decisions for joules in decision.booked.values())


def test_the_book_stands_still_while_a_vehicle_is_not_heard() -> None:
    game = world(view(1, battery_reported=False))
    game.until(Phase.TRANSFER)
    for _ in range(5):
        game.tick()
    game.set(1, age_s=9.0)
    game.tick()
    given_j = game.schedule.stocks[0].given_j
    for _ in range(20):
        game.tick()
    assert game.schedule.stocks[0].given_j == given_j
    game.set(1, age_s=0.0)
    assert game.until(Phase.DONE).energy_j == 5_000


def test_a_base_gives_no_more_than_it_has_and_keeps_on_the_ground_who_could_only_come_back() -> None:
    poor = PAD.model_copy(update={"stock_j": 700.5})
    game = world(bases=(poor,))
    service = game.until(Phase.DONE)
    assert service.energy_j == 700
    assert service.ended_by == "the base is empty, and pursuer 1 stays on the ground"
    assert game.schedule.stocks[0].remaining_j == 0.5
    assert all(game.tick().grounded == {1} for _ in range(50))


def test_a_base_that_runs_out_lets_go_who_has_enough_to_fly_on() -> None:
    game = world(view(1, initial_j=4_900.0), bases=(PAD.model_copy(update={"stock_j": 3_000.0}),))
    assert game.until(Phase.DONE).ended_by == "the base is empty"
    assert game.tick().grounded == frozenset()


def test_a_receiver_that_hears_nothing_costs_no_more_than_a_second() -> None:
    game = world(hears=False)
    service = game.until(Phase.DONE)
    assert service.ended_by == "the receiver takes no more"
    assert service.energy_j == 0
    assert 0 < game.schedule.stocks[0].given_j <= 2000 * (1.0 + 0.1)


def test_a_receiver_that_refuses_takes_off_again() -> None:
    game = world(accepts=False)
    service = game.until(Phase.DONE)
    assert service.ended_by == "the receiver refused"
    assert [role for _, _, role, *_ in game.orders] == [TransferRole.RECEIVE] * 5 + [TransferRole.STOP]
    assert game.schedule.stocks[0].given_j == 0


def test_a_limit_is_kept() -> None:
    game = world(rules=RefuellingRules(hold_s=1.0, limit_j=1_234.0))
    service = game.until(Phase.DONE)
    assert (service.energy_j, service.ended_by) == (1_234, "limit")


def test_one_that_lands_beside_the_base_is_not_charged() -> None:
    game = world()
    game.until(Phase.LAND)
    game.set(1, landed=True, armed=False, mode=FlightMode.LAND, p_ned=(11.5, 0.0, 0.0))
    service = game.until(Phase.DONE)
    assert (service.ended_by, service.energy_j) == ("landed 1.5 m from the base", 0)


@pytest.mark.parametrize("phase", [Phase.JOIN, Phase.LAND, Phase.TRANSFER, Phase.TAKE_OFF])
def test_a_death_ends_the_service_and_frees_the_base(phase: Phase) -> None:
    game = world(view(1), view(2, initial_j=4_900.0))
    game.until(phase)
    game.set(1, alive=False)
    assert game.until(Phase.DONE).ended_by == "the receiver died"
    assert game.until(Phase.DONE, 1).receiver == 2


def test_one_that_leaves_formation_flight_on_its_way_is_given_up() -> None:
    game = world(stays_away=True)
    game.until(Phase.JOIN)
    game.set(1, mode=FlightMode.RETURN)
    assert game.until(Phase.DONE).ended_by == "pursuer 1 left formation flight"


def test_one_that_an_operator_asks_for_goes_to_the_base_next_whatever_its_need() -> None:
    game = world(view(1), view(2, initial_j=8_000.0, p_ned=(0.0, 4.0, -4.8)))
    game.schedule.participation.change("refuel", 2)
    service = game.until(Phase.DONE)
    assert (service.receiver, service.by, service.energy_j) == (2, "operator", 1_000)


@pytest.mark.parametrize("phase", [Phase.JOIN, Phase.LAND, Phase.TRANSFER])
def test_one_that_is_taken_out_leaves_its_service_in_order(phase: Phase) -> None:
    game = world()
    game.until(phase)
    for _ in range(3 * (phase is Phase.TRANSFER)):
        game.tick()
    game.schedule.participation.out[1] = "is out"
    service = game.until(Phase.DONE)
    assert service.ended_by == "pursuer 1 is out"
    assert game.schedule.stocks[0].given_j == service.energy_j == (600 if phase is Phase.TRANSFER else 0)
    assert [role for _, _, role, *_ in game.orders] == (
        [TransferRole.RECEIVE, TransferRole.STOP] if phase is Phase.TRANSFER else []
    )


def test_only_a_charge_binds_a_vehicle() -> None:
    game = world()
    bound = {}
    while not game.schedule.services or game.schedule.services[0].phase is not Phase.DONE:
        game.tick()
        if game.schedule.services:
            bound[game.schedule.services[0].phase] = game.schedule.bound(1)
    free = {Phase.JOIN, Phase.LAND, Phase.TAKE_OFF, Phase.DONE}
    assert {phase for phase, is_bound in bound.items() if not is_bound} <= free
    assert bound[Phase.TRANSFER]


def test_a_base_is_taken_until_its_vehicle_is_off_it() -> None:
    """Some autopilots follow set points as soon as they are armed, and say late that they stand on the ground."""
    game = world(climbs_m=0.5)
    game.until(Phase.TAKE_OFF)
    for _ in range(20):
        game.tick()
    assert game.schedule.services[0].phase is Phase.TAKE_OFF
    game.set(1, p_ned=(10.0, 0.0, -2.5))
    assert game.until(Phase.DONE).ended_by == "full"
