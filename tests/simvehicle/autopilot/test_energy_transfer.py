"""Energy from one vehicle to another: the law alone."""

import math
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

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


@settings(max_examples=200)
@given(
    st.lists(st.floats(0.004, 0.4), min_size=1, max_size=200),
    st.floats(0.1, 5000.0),
    st.floats(1.0, 1e4),
    st.floats(0.0, 1e4),
)
def test_giver_gives_whole_joules_at_its_rate_within_limit_and_stock(
    spans_s: list[float], rate_w: float, limit_j: float, stock_j: float
) -> None:
    transfer = Transfer(order(limit_j=limit_j, rate_w=rate_w), 0.0, start_in_j=7)
    given_j, elapsed_s = 0, 0.0
    for span_s in spans_s:
        step_j = transfer.give(span_s, stock_j - given_j)
        assert isinstance(step_j, int)
        given_j, elapsed_s = given_j + step_j, elapsed_s + span_s
        assert 0 <= given_j <= min(rate_w * elapsed_s + 1e-6, limit_j, stock_j)
        transfer.receive_in(7 + given_j, elapsed_s)
    assert transfer.moved_j == given_j
    if given_j < math.floor(min(limit_j, stock_j)):
        assert given_j >= math.floor(rate_w * elapsed_s * (1.0 - 1e-12) - 1e-9)  # the fraction was carried over


@settings(max_examples=200)
@given(st.lists(st.integers(-50, 400)), st.integers(0, 300), st.floats(0.0, 200.0))
def test_receiver_credits_the_greatest_counter_heard_once_and_no_more_than_it_has_room_for(
    heard: list[int], start_j: int, room_j: float
) -> None:
    transfer = Transfer(order(TransferSide.RECEIVE, start_j=start_j), 0.0)
    credited = 0
    for value in heard:
        transfer.receive_out(value)
        credited += transfer.credit(room_j - credited)
    assert credited == min(max([value - start_j for value in heard] + [0]), math.floor(room_j))


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
    assert refusal(giver, (0.0, 0.0, 0.0), 10.0 + age_s, Envelope(1.5, 0.5)) == said


def test_giver_never_heard_of_is_silent() -> None:
    assert refusal(None, (0.0, 0.0, 0.0), 0.0, Envelope(1.5, 0.5)) == "the giver is silent"


@settings(max_examples=200)
@given(
    st.floats(1.0, 5000.0),
    st.one_of(st.none(), st.integers(0, 10**6)),
    st.lists(st.tuples(st.floats(0.004, 0.4), st.booleans(), st.integers(0, 20)), min_size=1, max_size=100),
)
def test_giver_is_never_farther_ahead_of_what_is_acknowledged_than_it_may_be(
    rate_w: float, known_j: int | None, steps: list[tuple[float, bool, int]]
) -> None:
    """Whatever acknowledgements come, late and in any order, each of what had arrived at its time."""
    transfer = Transfer(order(rate_w=rate_w), 0.0, known_j)
    start_j = known_j or 0
    arrived_j, told, now_s = 0, [start_j], 0.0
    seen = None if known_j is None else known_j
    for span_s, arrives, late in steps:
        now_s += span_s
        transfer.give(span_s, 1e9)
        acknowledged_j = (start_j if seen is None else seen) - start_j
        assert transfer.moved_j - acknowledged_j <= max(rate_w, 1.0)
        assert seen is not None or transfer.moved_j == 0
        arrived_j = transfer.moved_j if arrives else arrived_j
        told.append(start_j + arrived_j)
        said = told[max(len(told) - 1 - late, 0)]
        seen = said if seen is None else max(seen, said)
        transfer.receive_in(said, now_s)


def test_giver_stops_without_acknowledgements_and_resumes_at_its_rate() -> None:
    transfer = Transfer(order(rate_w=100.0), 0.0, start_in_j=0)
    given = [transfer.give(0.1, 1e9) for _ in range(20)]
    assert sum(given) == 100  # a second's worth, then it waits
    transfer.receive_in(20, 2.0)
    assert [transfer.give(0.1, 1e9) for _ in range(3)] == [11, 9, 0]  # a joule was begun; nothing is made up for
    transfer.receive_in(120, 2.3)
    assert sum(transfer.give(0.1, 1e9) for _ in range(10)) == 100


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


@settings(max_examples=40)
@given(st.integers(0, 3000), st.integers(0, 3500))
def test_settling_returns_what_is_missing_and_never_more_than_was_given(moved_j: int, credited_j: int) -> None:
    exchange = Exchange()
    given = order(limit_j=1e6, rate_w=float(max(moved_j, 1)))
    exchange.current = Transfer(given, 0.0, start_in_j=0)
    if moved_j:
        exchange.given_j += exchange.current.give(1.0, 1e6)
    exchange.end(1.0)
    back_j, refused = exchange.settle(replace(given, role=TransferSide.SETTLE, limit_j=float(credited_j)), 1e6)
    assert (refused is None) == (moved_j > 0)
    assert back_j == exchange.received_j == max(moved_j - credited_j, 0) * (moved_j > 0)
