"""What an operator's orders change of services: sides taken out, and who is asked for."""

import pytest

from gcs.mavlink.autopilots import FlightMode
from gcs.refuelling.service import Phase, TransferRole
from tests.support.services import play, view


@pytest.mark.parametrize("side", [1, 201])
@pytest.mark.parametrize(
    ("phase", "orders"),
    [
        (Phase.JOIN, []),
        (Phase.START_RECEIVER, [(1, TransferRole.RECEIVE), (1, TransferRole.STOP)]),
        (
            Phase.START_GIVER,
            [(1, TransferRole.RECEIVE), (201, TransferRole.GIVE), (201, TransferRole.STOP), (1, TransferRole.STOP)],
        ),
        (
            Phase.TRANSFER,
            [(1, TransferRole.RECEIVE), (201, TransferRole.GIVE), (201, TransferRole.STOP), (1, TransferRole.STOP)],
        ),
    ],
)
def test_a_side_that_is_taken_out_ends_the_service_in_order_from_any_phase(
    phase: Phase, orders: list[tuple[int, int]], side: int
) -> None:
    game = play()
    if phase is Phase.START_RECEIVER:
        game.fleet.unheard = {(1, TransferRole.RECEIVE)}
    if phase is Phase.START_GIVER:
        game.fleet.unheard = {(201, TransferRole.GIVE)}
    game.until(phase)
    game.schedule.participation.change("hold", side)
    service = game.until(Phase.DONE)
    assert [(who, role) for who, _, role, *_ in game.fleet.orders] == orders
    assert service.ended_by.endswith("taken by the operator")
    assert game.fleet.views[1].received_j == game.fleet.views[201].given_j
    for _ in range(50):
        game.tick()
    assert len(game.schedule.services) == 1
    game.schedule.participation.change("rejoin", side)
    game.until(Phase.JOIN, service=1)


def test_each_side_is_bound_until_it_is_needed_no_more() -> None:
    game = play()
    bound: dict[Phase, tuple[bool, bool]] = {}
    while not game.schedule.services or game.schedule.services[0].phase is not Phase.DONE:
        game.tick()
        for service in game.schedule.services:
            bound[service.phase] = (game.schedule.bound(1), game.schedule.bound(201))
    assert [phase for phase, (receiver, _) in bound.items() if not receiver] == [Phase.JOIN, Phase.DONE]
    giver_bound = {phase for phase, (_, giver) in bound.items() if giver}
    assert giver_bound == {Phase.START_GIVER, Phase.TRANSFER, Phase.STOP_GIVER}


def test_who_is_asked_for_is_served_before_anybody_who_competes() -> None:
    game = play()
    game.fleet.views[2] = view(2, "pursuer", (5.0, 0.0, -4.8), 8_000.0, 10_000.0)
    game.schedule.participation.change("refuel", 2)
    service = game.until(Phase.JOIN)
    assert (service.receiver, service.by) == (2, "operator")
    assert service.need == pytest.approx(0.2)
    assert game.schedule.participation.asked == []
    assert service.record()["by"] == "operator"


def test_who_is_asked_for_waits_for_a_tanker_and_until_it_can_be_served() -> None:
    game = play()
    first = game.until(Phase.TRANSFER)
    game.fleet.views[2] = view(2, "pursuer", (0.0, 3.0, -4.8), 4_000.0, 10_000.0)
    game.fleet.set(2, mode=FlightMode.HOLD)
    game.schedule.participation.change("refuel", 2)
    game.until(Phase.DONE)
    for _ in range(20):
        game.tick()
    assert game.schedule.services == [first]
    game.fleet.set(2, mode=FlightMode.OFFBOARD)
    assert game.until(Phase.JOIN, service=1).receiver == 2


def test_who_is_asked_for_is_served_without_any_competition() -> None:
    game = play(enabled=False)
    for _ in range(100):
        game.tick()
    assert game.schedule.services == []
    game.schedule.participation.change("refuel", 1)
    assert game.until(Phase.DONE).by == "operator"


@pytest.mark.parametrize("gone", ["dead", "out"])
def test_who_is_gone_is_asked_for_no_more(gone: str) -> None:
    game = play(need_from=1.0)
    game.schedule.participation.change("refuel", 1)
    if gone == "dead":
        game.fleet.set(1, alive=False)
    else:
        game.schedule.participation.change("skip", 1)
    game.tick()
    assert game.schedule.participation.asked == []
    assert game.schedule.services == []


def test_who_is_out_does_not_compete() -> None:
    game = play()
    game.fleet.views[2] = view(2, "pursuer", (5.0, 0.0, -4.8), 1_000.0, 10_000.0)
    game.schedule.participation.change("skip", 2)
    game.until(Phase.JOIN)
    assert [(service.receiver, set(service.bids)) for service in game.schedule.services] == [(1, {1})]
