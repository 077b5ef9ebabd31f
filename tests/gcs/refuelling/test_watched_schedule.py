"""The schedule of vehicles that decide for themselves, as their reports show it; rows made by hand."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import pytest
from views import snapshot, view

from gcs.refuelling.service import Phase
from gcs.refuelling.watched_schedule import WatchedSchedule
from gcs.scenario.model import Battery, CompetitionRules, RefuellingRules, Tanker

TANKER = Tanker(sysid=201, start_m=(0.0, 0.0, 0.0), battery=Battery(capacity_j=1e5))
FLEET = (view(1), view(2), view(3), view(201, "tanker"))


class Array(NamedTuple):
    """The fields of a DEBUG_FLOAT_ARRAY that are read."""

    name: str
    array_id: int
    data: tuple[float, ...]


def peer(stage: float, *, partner: float = 0.0, bid_s: float = 0.0, ln_v: float = 0.0, left_j: float = 6000.0) -> Array:
    row = [0.0] * 58
    row[0], row[1], row[9], row[10], row[12], row[15] = stage, partner, left_j, 24000.0, bid_s, ln_v
    return Array("Peer", 1, tuple(row))


def service(number: int, receiver: float, *times_s: float, energy_j: float = 0.0, ending: float = 0.0) -> Array:
    row = (receiver, 1.0, *times_s, *(-1.0,) * (3 - len(times_s)), energy_j, ending)
    return Array("Service", number, (*row, *(0.0,) * (58 - len(row))))


@pytest.fixture
def watched() -> WatchedSchedule:
    made = WatchedSchedule(CompetitionRules(where="vehicles"), RefuellingRules(), [TANKER])
    made.watch(CompetitionRules(where="vehicles"), frozenset({1, 2, 3}))
    return made


def decide(watched: WatchedSchedule, t_s: float) -> Any:
    return watched.decide(snapshot(*FLEET, time_s=t_s))


def test_a_service_is_followed_from_the_call_to_its_end_and_nothing_is_commanded(watched: WatchedSchedule) -> None:
    watched.receive(201, service(1, 2.0, 99.0), 100.0)
    begun = decide(watched, 100.0)
    assert (begun.rendezvous, begun.requests, begun.relays) == ({201: 2}, (), ())
    assert [(r["kind"], r["receiver"], r["tanker"], r["by"]) for r in begun.records] == [
        ("decided", 2, 201, "competition")
    ]
    watched.receive(201, service(1, 2.0, 99.0, 103.5, energy_j=2000.0), 104.0)
    assert [r["kind"] for r in decide(watched, 104.0).records] == ["transfer"]
    assert watched.services[0].phase is Phase.TRANSFER
    watched.receive(201, service(1, 2.0, 99.0, 103.5, 110.25, energy_j=9000.0, ending=1.0), 111.0)
    ended = decide(watched, 111.0)
    assert ended.rendezvous == {}
    (record,) = ended.records
    wanted = {"decided_at_s": 99.0, "joined_at_s": 103.5, "start_s": 103.5, "end_s": 110.25, "energy_j": 9000}
    assert {key: record[key] for key in wanted} == wanted
    watched.receive(201, service(1, 2.0, 99.0, 103.5, 110.25, energy_j=9000.0, ending=1.0), 112.0)
    assert decide(watched, 112.0).records == ()
    assert [s.receiver for s in watched.refuelled] == [2]


@pytest.mark.parametrize(("received_j", "booked_j"), [(10_600, 1600), (9600, 600), (9000, 0)])
def test_at_the_end_services_have_what_receivers_have_counted(
    watched: WatchedSchedule, received_j: int, booked_j: int
) -> None:
    """The tanker reports 1200 J of the service under way, before the receiver's last joules or after what it lost."""
    watched.receive(201, service(1, 2.0, 10.0, 12.0, 20.0, energy_j=9000.0, ending=1.0), 21.0)
    watched.receive(201, service(2, 2.0, 30.0, 33.0, energy_j=1200.0), 34.0)
    decide(watched, 34.0)
    watched.settle(snapshot(view(2, received_j=received_j), view(201, "tanker"), time_s=34.5))
    assert [one.energy_j for one in watched.services] == [9000, booked_j]


def test_services_that_are_learnt_late_stand_in_the_order_of_their_decisions(watched: WatchedSchedule) -> None:
    watched.receive(201, service(2, 3.0, 60.0, 64.0), 100.0)
    decide(watched, 100.0)
    watched.receive(201, service(1, 1.0, 40.0, 44.0, 50.0, energy_j=500.0, ending=1.0), 101.0)
    decide(watched, 101.0)
    assert [s.receiver for s in watched.services] == [1, 3]
    assert watched.open_services[0].receiver == 3


def test_the_competition_is_that_of_the_vehicles_own_states(watched: WatchedSchedule) -> None:
    watched.receive(1, peer(1.0, bid_s=30.0, ln_v=-2.0), 100.0)
    watched.receive(2, peer(1.0, bid_s=15.0), 100.0)
    watched.receive(3, peer(2.0, partner=201.0), 100.0)
    decide(watched, 100.0)
    state = watched.competition_state
    assert state.leader == 2
    assert state.v == pytest.approx({1: math.exp(-2.0), 2: 1.0})
    assert state.tau == pytest.approx({1: 0.505, 2: 0.7525})  # floor 0.01, horizon 60 s
    assert state.need == pytest.approx({1: 0.75, 2: 0.75})
    assert state.share == pytest.approx(1.0 / (1.0 + math.exp(-4.0)))
    decide(watched, 102.0)
    assert watched.competition_state.v == {}


def test_tankers_stand_idle_where_somebody_waits_and_nobody_calls(watched: WatchedSchedule) -> None:
    decide(watched, 100.0)
    for t_s, caller in ((101.0, 0.0), (102.0, 201.0)):
        watched.receive(201, peer(5.0, left_j=50000.0), t_s)
        watched.receive(1, peer(1.0), t_s)
        watched.receive(2, peer(2.0 if caller else 0.0, partner=caller), t_s)
        decide(watched, t_s)
    assert watched.tanker_idle_s == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("sysid", "content"),
    [
        (201, service(1, 77.0, 1.0)),
        (1, service(1, 2.0, 1.0)),
        (201, service(0, 2.0, 1.0)),
        (201, service(1, 2.0, math.nan)),
        (201, service(1, 2.0, 1.0)._replace(name="Other")),
        (9, peer(1.0)),
    ],
)
def test_what_cannot_be_is_passed_over(watched: WatchedSchedule, sysid: int, content: Array) -> None:
    watched.receive(sysid, content, 100.0)
    assert decide(watched, 100.0).records == ()
    assert watched.competition_state.v == {}
