"""What a receiver lets its tanker take back, by hand: 900 J given since the start, 650 J credited."""

from __future__ import annotations

import pytest

from simvehicle.autopilot.energy_transfer import TransferOrder, TransferSide
from simvehicle.fleet.peers import PeerReport, PeerStage
from simvehicle.fleet.settlement import ReceiverSettlement

ORDER = TransferOrder(1, TransferSide.RECEIVE, 5000.0, 2000.0, 1001, 100)


def ended(credited_j: int = 650) -> ReceiverSettlement:
    settlement = ReceiverSettlement()
    settlement.add(201, ORDER, credited_j, 10.0)
    return settlement


def report(time_s: float, stage: PeerStage = PeerStage.FREE, given_j: int = 1000) -> dict[int, PeerReport]:
    return {201: PeerReport(time_s, stage, given_j=given_j)}


def test_it_tells_the_tanker_what_it_has_credited_until_it_has_answered_twice() -> None:
    settlement = ended()
    ((tanker, order),) = settlement.due(10.1, report(10.1))
    assert (tanker, order) == (201, TransferOrder(1, TransferSide.SETTLE, 650.0, 0.0, 1001, 100))
    assert settlement.due(10.4, report(10.4)) == []
    settlement.receive_answer(201, True)
    settlement.receive_answer(202, True)
    settlement.receive_answer(201, False)
    assert settlement.due(10.6, report(10.6)) == [(201, order)]
    settlement.receive_answer(201, True)
    assert settlement.due(11.2, report(11.2)) == settlement.due(20.0, report(20.0)) == []


@pytest.mark.parametrize(
    "peers",
    [{}, report(10.0), report(10.1, PeerStage.TRANSFERS), report(10.1, given_j=750)],
    ids=["not heard", "heard before", "still gives", "all has arrived"],
)
def test_it_asks_for_nothing_before_what_was_given_is_known_and_more_than_credited(
    peers: dict[int, PeerReport],
) -> None:
    settlement = ended()
    assert settlement.due(10.1, peers) == []
    assert bool(settlement.due(10.2, report(10.2))) == (not peers or peers[201].given_j != 750)


def test_a_tanker_that_never_answers_is_asked_twenty_times() -> None:
    settlement = ended()
    asks = [ask for k in range(100) for ask in settlement.due(10.0 + 0.5 * k, report(10.1 + 0.5 * k))]
    assert len(asks) == 20
