"""Services from the decision to the end, against scripted vehicles that obey
docs/protocol/energy.md#energy-transfer."""

from typing import Any

import pytest

from gcs.mavlink.autopilots import FlightMode
from gcs.refuelling.scheduler import Scheduler
from gcs.refuelling.service import Decision, Phase, TransferRole
from gcs.scenario.model import CompetitionRules, RefuellingRules
from gcs.telemetry.state import FleetSnapshot
from tests.support.services import FOLLOW_TARGET, INTERVAL, RATE_W, Fleet, Play, play, tanker, view


def test_a_whole_service_in_its_order() -> None:
    game = play()
    service = game.until(Phase.DONE)
    assert service.ended_by == "full"
    assert game.kinds == ["decided", "transfer", "served"]
    assert [(who, role) for who, _, role, *_ in game.fleet.orders] == [
        (1, TransferRole.RECEIVE),
        (201, TransferRole.GIVE),
        (201, TransferRole.STOP),
        (1, TransferRole.STOP),
    ]
    # 90 % of 10 kJ, 200 J a tick, 4 kJ at the start; the giver stops a tick after the level was seen.
    assert 5_000 <= service.energy_j <= 5_400
    assert game.fleet.views[201].given_j == service.energy_j
    assert game.schedule.refuelled == [service]
    assert None not in (service.decided_at_s, service.joined_at_s, service.start_s, service.end_s)
    assert service.decided_at_s <= service.joined_at_s <= service.start_s < service.end_s  # type: ignore[operator]


def test_a_transfer_is_stopped_in_time_to_be_settled_and_none_begins_after_that() -> None:
    game = play(transfers_until_s=4.0)
    service = game.until(Phase.DONE)
    assert service.ended_by == "the session ends"
    assert service.start_s is not None
    assert service.start_s < 4.0 <= game.now_s < 6.0
    late = play(transfers_until_s=1.5)
    while late.now_s < 16.5:
        late.tick()
    assert [one.phase for one in late.schedule.services] == [Phase.JOIN]
    assert late.fleet.orders == []


def test_the_command_on_the_wire_is_the_contracts() -> None:
    """param1 partner, 2 role, 3 limit in J, 4 rate in W, 5 transfer id, 6 the giver's XferOut at the start."""
    game = play()
    game.fleet.set(201, given_j=777)
    game.until(Phase.TRANSFER)
    # room: 10 000 - 4 000
    assert game.fleet.orders == [
        (1, 201, TransferRole.RECEIVE, 6000, 2000, 1, 777),
        (201, 1, TransferRole.GIVE, 6000, 2000, 1, 777),
    ]
    requests = [wish for decision in game.decisions for wish in decision.requests]
    assert requests[0].params[:2] == (FOLLOW_TARGET, 100_000.0)
    assert (requests[0].sysid, requests[0].command) == (201, INTERVAL)
    game.until(Phase.DONE)
    last = game.decisions[-1].requests[-1]
    assert (last.sysid, last.command, last.params[:2]) == (201, INTERVAL, (FOLLOW_TARGET, 0.0))


def test_partners_rendezvous_and_relays_while_it_lasts() -> None:
    game = play()
    game.fleet.set(201, p_ned=(20.0, 0.0, -6.0))
    game.until(Phase.JOIN)
    decision = game.tick()
    assert (decision.rendezvous, decision.relays) == ({201: 1}, ())
    game.fleet.set(201, p_ned=(14.0, 0.0, -6.0))
    assert game.tick().relays == ((201, 1),)
    game.fleet.set(201, p_ned=(0.0, 0.0, -6.0))
    game.until(Phase.CATCH_UP)
    assert game.tick().relays == ((201, 1),)
    game.until(Phase.DONE)
    assert game.tick() == Decision()


@pytest.mark.parametrize(
    "changed", [{"p_ned": (1.0, 0.0, -6.0)}, {"v_ned": (0.6, 0.0, 0.0)}, {"p_ned": (0.0, 0.0, -6.31)}]
)
def test_joining_waits_until_near_and_slow_for_the_hold_time(changed: dict[str, Any]) -> None:
    game = play()
    there = {key: getattr(game.fleet.views[201], key) for key in changed}
    game.fleet.set(201, **changed)
    game.until(Phase.JOIN)
    for _ in range(100):
        game.tick()
    assert game.schedule.services[0].phase is Phase.JOIN
    game.fleet.set(201, **there)
    begin_s = game.now_s
    assert game.until(Phase.START_RECEIVER).joined_at_s == pytest.approx(begin_s + 1.0, abs=0.11)


def test_no_start_before_the_givers_counter_is_known() -> None:
    game = play()
    original = game.fleet.set

    def deaf(sysid: int, **changed: Any) -> None:
        if changed.keys() == {"given_reported_s"}:
            changed = {"given_reported_s": 0.0}
        original(sysid, **changed)

    game.fleet.set = deaf  # type: ignore[method-assign]
    game.until(Phase.JOIN)
    for _ in range(60):
        game.tick()
    assert game.schedule.services[0].phase is Phase.JOIN
    game.fleet.set = original  # type: ignore[method-assign]
    game.until(Phase.START_RECEIVER, within_s=0.5)


def test_a_rendezvous_that_does_not_come_about_is_given_up_and_the_tanker_is_free_again() -> None:
    game = play()
    game.fleet.set(201, p_ned=(9.0, 0.0, -6.0))
    service = game.until(Phase.DONE)
    assert service.ended_by == "no rendezvous in time"
    assert game.fleet.orders == []
    assert game.schedule.refuelled == []
    game.until(Phase.JOIN, service=1)


def test_a_receiver_that_refuses_is_asked_again_from_the_formation_and_given_up_in_the_end() -> None:
    game = play()
    game.fleet.refused = {(1, TransferRole.RECEIVE)}
    service = game.until(Phase.DONE)
    assert service.ended_by == "the receiver refused"
    assert [role for _, _, role, *_ in game.fleet.orders].count(TransferRole.RECEIVE) == 5
    assert TransferRole.GIVE not in [role for _, _, role, *_ in game.fleet.orders]


def test_a_receiver_that_refuses_once_is_served_in_the_end() -> None:
    game = play()
    game.fleet.refused = {(1, TransferRole.RECEIVE)}
    game.until(Phase.START_RECEIVER)
    game.tick()
    game.fleet.refused.clear()
    assert game.until(Phase.DONE).ended_by == "full"


def test_a_giver_that_refuses_ends_the_service_and_the_receiver_is_released() -> None:
    game = play()
    game.fleet.refused = {(201, TransferRole.GIVE)}
    assert game.until(Phase.DONE).ended_by == "the giver refused"
    assert game.fleet.views[1].mode is FlightMode.OFFBOARD
    assert game.fleet.orders[-1][:3] == (1, 201, TransferRole.STOP)


@pytest.mark.parametrize("order", [(1, TransferRole.RECEIVE), (201, TransferRole.GIVE)])
def test_whoever_began_but_was_never_heard_to_is_told_to_stop(order: tuple[int, int]) -> None:
    game = play()
    game.fleet.unheard = {order}
    game.until(Phase.START_RECEIVER if order[1] == TransferRole.RECEIVE else Phase.START_GIVER)
    for _ in range(90):
        game.tick()
    stopped = {who for who, _, role, *_ in game.fleet.orders if role == TransferRole.STOP}
    assert order[0] in stopped
    game.fleet.unheard.clear()
    game.until(Phase.DONE)
    assert not game.fleet.active


@pytest.mark.parametrize("order", [(201, TransferRole.STOP), (1, TransferRole.STOP)])
def test_a_stop_that_is_never_acknowledged_holds_nothing_up_for_long(order: tuple[int, int]) -> None:
    game = play()
    game.fleet.unheard = {order}
    game.until(Phase.STOP_GIVER)
    assert game.until(Phase.DONE, within_s=8.0).ended_by == "full"


@pytest.mark.parametrize("side", [1, 201])
def test_a_transfer_that_one_side_breaks_off_is_joined_again(side: int) -> None:
    game = play()
    service = game.until(Phase.TRANSFER)
    for _ in range(5):
        game.tick()
    before_j = game.fleet.views[201].given_j
    game.fleet.end(side)
    game.until(Phase.JOIN)
    assert "broken off" in game.kinds
    assert game.until(Phase.DONE) is service
    assert service.ended_by == "full"
    second = [order for order in game.fleet.orders if order[2] == TransferRole.GIVE][1]
    assert second[6] == before_j  # the giver's XferOut at the new start
    assert service.energy_j == game.fleet.views[1].received_j  # both parts


@pytest.mark.parametrize("reports", [True, False])
def test_a_receiver_with_a_battery_apart_has_ended_when_its_counter_stands_while_the_tanker_gives(
    reports: bool,
) -> None:
    """Its mode stays; a tanker by itself gives for 3 s more. Without reports there is nothing to conclude from."""
    game = play()
    game.fleet.set(1, battery_apart=True)
    service = game.until(Phase.TRANSFER)
    for _ in range(5):
        game.tick()
    game.fleet.active.pop(1)
    ended_s = game.now_s
    while service.phase is Phase.TRANSFER and game.now_s < ended_s + 2.5:
        game.fleet.set(1, mode=FlightMode.OFFBOARD)
        game.fleet.set(201, given_j=game.fleet.views[201].given_j + 200)
        game.tick_with({} if reports else {1: {"received_reported_s": ended_s}})
    assert (service.phase is Phase.TRANSFER) is not reports
    if reports:
        assert game.now_s - ended_s == pytest.approx(1.0, abs=0.21)
        game.until(Phase.JOIN, within_s=0.5)  # nothing is left to catch up
        assert "broken off" in game.kinds


def test_a_transfer_broken_off_before_it_was_seen_is_noticed_at_once() -> None:
    game = play()
    game.until(Phase.START_GIVER)
    game.fleet.end(1)
    game.until(Phase.STOP_GIVER, within_s=0.4)


def test_a_giver_that_has_given_all_that_was_ordered_ends_the_service() -> None:
    """Asked to fill up to 100 %, the receiver draws meanwhile: the joules ordered at the start never fill it."""
    game = play(RefuellingRules(rate_w=RATE_W, until=1.0))
    service = game.until(Phase.TRANSFER)
    while game.fleet.views[201].given_j < 6000:
        game.fleet.set(1, drawn_j=game.fleet.views[1].drawn_j + 21.0)
        game.tick()
    game.fleet.end(201)
    game.until(Phase.DONE, within_s=4.0)
    assert (service.ended_by, service.energy_j) == ("limit", 6000)


def test_the_limit_of_a_service_ends_it() -> None:
    game = play(RefuellingRules(rate_w=RATE_W, limit_j=1500.0))
    service = game.until(Phase.DONE)
    assert service.ended_by == "limit"
    assert game.fleet.orders[1][3] == 1500
    assert 1500 <= service.energy_j <= 1900


def test_what_is_left_of_the_limit_is_ordered_after_a_break() -> None:
    game = play(RefuellingRules(rate_w=RATE_W, limit_j=3000.0))
    game.until(Phase.TRANSFER)
    for _ in range(4):
        game.tick()
    game.fleet.end(1)
    received_j = game.until(Phase.JOIN).energy_j
    game.until(Phase.TRANSFER)
    second = [order for order in game.fleet.orders if order[2] == TransferRole.GIVE][1]
    assert second[3] == 3000 - received_j < 3000


def test_a_tanker_gives_no_more_than_its_reserve_and_its_way_home_leave() -> None:
    """At home, so the way is nothing but 1.2 m: 14 000 - 10 000 J, and no more."""
    game = play()
    game.fleet.set(201, initial_j=14_000.0)
    service = game.until(Phase.TRANSFER)
    assert game.fleet.orders[1][3] == 4000
    game.until(Phase.DONE)
    assert service.ended_by == "tanker at its reserve"
    assert game.fleet.views[201].remaining_j >= 10_000.0 - 200.0
    for _ in range(300):
        game.tick()
    assert len(game.schedule.services) == 1  # it is not asked again


def test_the_way_home_costs() -> None:
    """50 m at 5 m/s and 300 W are 3000 J."""
    game = play(tankers=(tanker(home_m=(50.0, 0.0, -6.0)),))
    game.fleet.set(201, initial_j=16_000.0, power_w=300.0)
    game.until(Phase.TRANSFER)
    assert game.fleet.orders[1][3] == 3000


PHASES = [Phase.JOIN, Phase.START_RECEIVER, Phase.START_GIVER, Phase.TRANSFER, Phase.STOP_GIVER, Phase.CATCH_UP,
          Phase.STOP_RECEIVER]  # fmt: skip


@pytest.mark.parametrize("phase", PHASES)
@pytest.mark.parametrize("side", [1, 201])
def test_the_death_of_either_side_ends_it_and_frees_the_other(phase: Phase, side: int) -> None:
    game = play()
    service = game.until(phase)
    game.fleet.set(side, alive=False)
    game.fleet.active.pop(side, None)
    game.tick()
    assert (service.phase, service.ended_by) == (Phase.DONE, "a side died")
    other = 201 if side == 1 else 1
    assert game.fleet.views[other].mode is FlightMode.OFFBOARD
    assert not [wish for wish in game.decisions[-1].requests if wish.sysid == side]
    assert game.tick() == Decision()


@pytest.mark.parametrize("side", [1, 201])
@pytest.mark.parametrize("phase", [Phase.JOIN, Phase.TRANSFER])
def test_a_side_that_leaves_formation_flight_ends_it(phase: Phase, side: int) -> None:
    game = play()
    service = game.until(phase)
    game.fleet.active.pop(side, None)
    game.fleet.set(side, mode=FlightMode.RETURN)
    game.until(Phase.DONE, within_s=5.0)
    assert service.ended_by.endswith(f"{side} left formation flight")


def test_in_radio_silence_every_phase_ends() -> None:
    """Nothing is acknowledged and no counter moves any more: the tanker is free within the time-outs' sum."""
    game = play()
    service = game.until(Phase.TRANSFER)
    game.fleet.unheard = {
        (who, role) for who in (1, 201) for role in (TransferRole.STOP, TransferRole.GIVE, TransferRole.RECEIVE)
    }
    game.fleet.active.clear()
    game.fleet.set(1, mode=FlightMode.OFFBOARD)
    game.fleet.set(201, mode=FlightMode.OFFBOARD, p_ned=(9.0, 0.0, -6.0))
    game.until(Phase.DONE, within_s=75.0)
    assert service.ended_by == "no rendezvous in time"


def test_joules_that_are_told_late_are_booked_on_their_service() -> None:
    game = play()
    first = game.until(Phase.DONE)
    before_j = first.energy_j
    game.fleet.set(1, received_j=game.fleet.views[1].received_j + 150, drawn_j=8_000.0)
    second = game.until(Phase.DONE, service=1)
    assert first.energy_j == before_j + 150
    assert first.energy_j + second.energy_j == game.fleet.views[1].received_j
    game.fleet.set(1, received_j=game.fleet.views[1].received_j + 30)
    game.schedule.settle(FleetSnapshot(game.now_s, tuple(game.fleet.views.values()), ()))
    assert first.energy_j + second.energy_j == game.fleet.views[1].received_j


def test_a_tanker_is_no_partner_of_the_vehicle_that_leads_before_it_has_won() -> None:
    fleet = Fleet({k: view(k, "pursuer", (6.0 * k, 0.0, -4.8), 4_000.0 - 400.0 * k, 10_000.0) for k in (1, 2)})
    for sysid in (1, 2):
        fleet.set(sysid, power_w=100.0)
    fleet.views[201] = view(201, "tanker", (0.0, 0.0, -6.0), 150_000.0, 150_000.0)
    game = Play(Scheduler(CompetitionRules(), RefuellingRules(rate_w=RATE_W), (tanker(201),)), fleet)
    approached = 0
    while not game.schedule.open_services:
        decision = game.tick()
        if decision.rendezvous and not game.schedule.open_services:
            approached += 1
            assert (set(decision.approaches), decision.partners) == ({201}, [])
    assert approached > 1
    decision = game.tick()
    assert (set(decision.approaches), decision.partners) == (set(), list(decision.rendezvous.items()))


def test_several_tankers_never_share_a_receiver_and_serve_by_need() -> None:
    fleet = Fleet({k: view(k, "pursuer", (6.0 * k, 0.0, -4.8), 4_500.0 - 500.0 * k, 10_000.0) for k in range(1, 6)})
    for sysid in (201, 202):
        fleet.views[sysid] = view(sysid, "tanker", (0.0, 0.0, -6.0), 150_000.0, 150_000.0)
    schedule = Scheduler(CompetitionRules(), RefuellingRules(rate_w=RATE_W), (tanker(201), tanker(202)))
    game = Play(schedule, fleet)
    at_once = 0
    while len(schedule.refuelled) < 5:
        assert game.now_s < 120
        decision = game.tick()
        receivers = list(decision.rendezvous.values())
        assert len(receivers) == len(set(receivers))
        at_once = max(at_once, len(receivers))
        for tanker_id, receiver in decision.rendezvous.items():
            fleet.set(tanker_id, p_ned=(6.0 * receiver, 0.0, -6.0))
    assert at_once == 2
    receivers = [service.receiver for service in schedule.services]
    assert [set(receivers[:2]), *receivers[2:]] == [{4, 5}, 3, 2, 1]  # two at once, each matched to its tanker
    assert {service.tanker for service in schedule.services} == {201, 202}
    ids = {order[5] for order in fleet.orders}
    assert ids == {1, 2, 3, 4, 5}


@pytest.mark.parametrize("off", ["competition", "refuelling"])
def test_switched_off_nothing_is_decided(off: str) -> None:
    game = play(RefuellingRules(enabled=off != "refuelling"), enabled=off != "competition")
    assert all(game.tick() == Decision() for _ in range(100))
    assert game.schedule.competition_state.v == {}


def test_the_record_of_a_service_is_the_summarys() -> None:
    record = play().until(Phase.DONE).record()
    assert list(record) == ["receiver", "tanker", "by", "decided_at_s", "joined_at_s", "start_s", "end_s", "energy_j",
                            "bids"]  # fmt: skip
    assert (record["receiver"], record["tanker"], record["by"], record["bids"]) == (1, 201, "unopposed", {"1": 1.0})


def test_when_a_tanker_fails_in_the_middle_another_goes_on_with_its_receiver() -> None:
    """Two tankers of different speeds, stocks and reserves; the one that serves dies, and no joule is counted twice."""
    fleet = Fleet({k: view(k, "pursuer", (0.0, 4.0 * k, -4.8), 2_000.0, 10_000.0) for k in (1, 2)})
    fleet.views[201] = view(201, "tanker", (0.0, 4.0, -6.0), 150_000.0, 150_000.0)
    fleet.views[202] = view(202, "tanker", (0.0, 8.0, -6.0), 40_000.0, 60_000.0)
    rules = (tanker(201, speed_m_s=6.0), tanker(202, speed_m_s=3.0, reserve_j=5_000.0))
    game = Play(Scheduler(CompetitionRules(), RefuellingRules(rate_w=RATE_W), rules), fleet)
    game.until(Phase.TRANSFER)
    for _ in range(8):
        game.tick()
    first = next(service for service in game.schedule.services if service.tanker == 201)
    fleet.set(201, alive=False)
    fleet.active.pop(201, None)
    while len(game.schedule.services) < 3 or game.schedule.services[2].phase is not Phase.DONE:
        assert game.now_s < 60.0
        for tanker_id, receiver in game.tick().rendezvous.items():
            fleet.set(tanker_id, p_ned=(0.0, 4.0 * receiver, -6.0))
    assert (first.receiver, first.ended_by, 0 < first.energy_j < 5_000) == (1, "a side died", True)
    again = game.schedule.services[2]
    assert (again.receiver, again.tanker, again.ended_by) == (1, 202, "full")
    assert first.energy_j + again.energy_j == fleet.views[1].received_j
    assert fleet.views[202].remaining_j >= 5_000.0


def test_a_tanker_with_too_little_to_spare_takes_no_part_in_the_matching() -> None:
    fleet = Fleet({k: view(k, "pursuer", (0.0, 4.0 * k, -4.8), 4_000.0, 10_000.0) for k in (1, 2)})
    fleet.views[201] = view(201, "tanker", (0.0, 4.0, -6.0), 10_400.0, 150_000.0)
    fleet.views[202] = view(202, "tanker", (0.0, 8.0, -6.0), 40_000.0, 60_000.0)
    schedule = Scheduler(CompetitionRules(), RefuellingRules(rate_w=RATE_W), (tanker(201), tanker(202)))
    game = Play(schedule, fleet)
    game.until(Phase.DONE)
    assert {service.tanker for service in schedule.services} == {202}


def test_the_time_that_tankers_stand_free_while_somebody_waits_is_counted() -> None:
    """Nobody competes with the one that waits, and the tanker sets off at once after the settling second."""
    game = play()
    game.until(Phase.DONE)
    assert game.schedule.tanker_idle_s <= 1.1
    waits = play(enabled=False)
    for _ in range(50):
        waits.tick()
    assert waits.schedule.tanker_idle_s == 0.0  # nothing is to be decided


def test_what_a_receiver_draws_meanwhile_is_ordered_too_so_that_services_end_full() -> None:
    """To 100 % at 2 kW: 6000 J are missing, and at 200 W 667 J more are drawn while they flow, 400 J before."""
    game = play(RefuellingRules(rate_w=RATE_W, until=1.0))
    game.fleet.set(1, power_w=200.0)
    service = game.until(Phase.TRANSFER)
    assert game.fleet.orders[1][3] == 7066
    while service.phase is Phase.TRANSFER:
        game.fleet.set(1, drawn_j=game.fleet.views[1].drawn_j + 20.0)
        game.tick()
    game.until(Phase.DONE)
    assert service.ended_by == "full"
    as_before = play(RefuellingRules(rate_w=RATE_W, until=1.0, tops_up=False))
    as_before.fleet.set(1, power_w=200.0)
    as_before.until(Phase.TRANSFER)
    assert as_before.fleet.orders[1][3] == 6000


def lose_on_the_way(game: Any, joules: int) -> None:
    """So much that the tanker has given will never be credited."""
    fleet = game.fleet
    fleet.on_the_way_j += joules
    fleet.set(1, received_j=fleet.views[1].received_j - joules)


@pytest.mark.parametrize("unheard", [0, 3])
def test_what_never_arrived_is_taken_back_once_both_sides_have_ended(unheard: int) -> None:
    """Also where the tanker's answers to the order are lost: it is asked again, with the same figures."""
    game = play()
    service = game.until(Phase.TRANSFER)
    game.tick()
    lose_on_the_way(game, 150)
    game.fleet.unheard = {(201, TransferRole.SETTLE)} if unheard else set()
    game.fleet.end(1)
    game.until(Phase.JOIN)
    for _ in range(10 + 50 * unheard):
        game.tick()
    game.fleet.unheard.clear()
    game.until(Phase.DONE)
    for _ in range(60):
        game.tick()
    settled = [record for decision in game.decisions for record in decision.records if record["kind"] == "settled"]
    assert settled == [{"kind": "settled", "receiver": 1, "tanker": 201, "energy_j": 150}]
    orders = [order for order in game.fleet.orders if order[2] == TransferRole.SETTLE]
    first = next(order for order in game.fleet.orders if order[2] == TransferRole.GIVE)
    assert {(who, partner, number, start_j) for who, partner, _, _, _, number, start_j in orders} == {
        (201, 1, service.number, first[6])
    }
    assert {order[3] for order in orders} == {orders[0][3]}  # what had been credited of this transfer
    assert (len(orders) > 1) == bool(unheard)
    assert game.fleet.views[201].given_j == game.fleet.views[1].received_j + game.fleet.views[201].received_j


def test_neither_side_begins_again_before_what_was_on_the_way_is_known() -> None:
    game = play()
    game.until(Phase.TRANSFER)
    game.tick()
    lose_on_the_way(game, 150)
    game.fleet.end(1)
    game.until(Phase.STOP_RECEIVER)
    told = {"received_reported_s": game.now_s}
    while game.schedule.services[0].phase is Phase.STOP_RECEIVER:
        game.tick()
    begun = len(game.fleet.orders)
    for _ in range(40):  # 4 s together, and nothing is heard of its counter
        game.tick_with({1: told})
    assert [order for order in game.fleet.orders[begun:] if order[2] == TransferRole.RECEIVE] == []
    game.until(Phase.TRANSFER)
    assert "settled" in game.kinds


def test_a_clear_transfer_needs_no_settling() -> None:
    game = play()
    game.until(Phase.DONE)
    for _ in range(30):
        game.tick()
    assert TransferRole.SETTLE not in {order[2] for order in game.fleet.orders}
