"""Energy from one vehicle to another: the law alone."""

from typing import Any

import pytest

from simvehicle.autopilot.energy_transfer import (
    Envelope,
    Exchange,
    Neighbour,
    Transfer,
    TransferOrder,
    TransferSide,
    refusal,
)


def order(
    role: TransferSide = TransferSide.GIVE, *, limit_j: float = 1e6, rate_w: float = 100.0, start_j: int = 0
) -> TransferOrder:
    return TransferOrder(2, role, limit_j, rate_w, 1, start_j)


@pytest.mark.parametrize(
    ("p", "v", "age_s", "said"),
    [
        ((1.4, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0, None),
        ((1.6, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0, "the giver is 1.6 m away"),
        ((0.0, 0.0, -1.0), (0.0, 0.6, 0.0), 0.0, "the giver moves at 0.6 m/s"),
        ((0.0, 0.0, -1.0), (0.0, 0.4, 0.0), 1.0, None),
        ((0.0, 0.0, -1.0), (0.0, 0.0, 0.0), 1.01, "the giver is silent"),
        ((1.4, 0.0, 0.0), (0.4, 0.0, 0.0), 0.5, "the giver is 1.6 m away"),  # where it is by now
    ],
)
def test_receiver_refuses_what_lies_outside_its_envelope(p: Any, v: Any, age_s: float, said: str | None) -> None:
    giver = Neighbour(p, v, (0.0, 0.0, 0.0), 10.0)
    assert refusal(None, (0.0, 0.0, 0.0), 0.0, Envelope(1.5, 0.5)) == "the giver is silent"
    assert refusal(giver, (0.0, 0.0, 0.0), 10.0 + age_s, Envelope(1.5, 0.5)) == said


def test_giver_ends_when_the_receivers_counter_has_stood_still_for_too_long() -> None:
    transfer = Transfer(order(rate_w=100.0), 5.0, start_in_j=0)
    assert transfer.finished(8.0) is None
    assert transfer.finished(8.01) == "the receiver takes no more"
    for k in range(1, 20):
        transfer.give(0.4, 1e9)
        transfer.receive_in(k, 5.0 + 2.9 * k)
        assert transfer.finished(5.0 + 2.9 * k + 2.9) is None
    transfer.receive_in(19, 62.0)
    transfer.receive_in(3, 62.0)
    assert transfer.finished(5.0 + 2.9 * 19 + 3.01) == "the receiver takes no more"


@pytest.mark.parametrize(
    ("reported", "gives_at_once"),
    [([], False), ([(2, 400, 9.0)], True), ([(2, 400, 8.0)], False), ([(3, 400, 9.9)], False)],
)
def test_giver_begins_with_what_it_has_heard_of_its_receiver_lately_or_waits_for_it(
    reported: list[tuple[int, int, float]], gives_at_once: bool
) -> None:
    exchange = Exchange()
    for partner, value_j, at_s in reported:
        exchange.receive_counter(partner, "XferIn", value_j, at_s)
    exchange.begin(order(rate_w=100.0), 10.0)
    assert exchange.current is not None
    assert (exchange.current.give(0.1, 1e9) == 10) == gives_at_once
    exchange.receive_counter(2, "XferIn", 400, 10.2)
    assert exchange.current.give(0.1, 1e9) >= 10
