"""Transfers that end early: cases made by hand, and a whole session's schedule."""

from __future__ import annotations

import pytest

from gcs.refuelling.early_ends import EarlyEnds
from gcs.refuelling.scheduler import Scheduler
from gcs.refuelling.service import Phase, Service
from gcs.scenario.model import CompetitionRules, RefuellingRules
from gcs.telemetry.state import VehicleView
from tests.support.competing import TIMES, giver, pursuer
from tests.support.services import RATE_W, Fleet, Play, tanker, view

RULES = RefuellingRules()
NEAR = (3.0, 0.0, -5.0)


def transfer(by: str = "competition") -> Service:
    return Service(1, 1, 201, by, {}, 0.0, phase=Phase.TRANSFER)


def ends(other: VehicleView, receiver_lasts_s: float = 45.0) -> bool:
    """Whether the transfer to 1 ends for another one; `full` needs 18 kJ, at 2000 W less what is drawn."""
    receiver = pursuer(1, receiver_lasts_s)
    missing_j = 18_000.0 - receiver.remaining_j
    busy = giver(201, free_in_s=missing_j / 1800.0 + TIMES.end_s)
    early = EarlyEnds(RULES, CompetitionRules().need_from, 300.0)
    return early.ends(transfer(), receiver, [other], {other.sysid}, [busy], TIMES, 10.0)


@pytest.mark.parametrize(
    ("lasts_s", "ended"),
    [
        pytest.param(7.0, True, id="kept only if the tanker sets off now: there in 4.6 s, after the transfer in 9"),
        pytest.param(25.0, False, id="kept in any case"),
        pytest.param(1.0, False, id="lost in any case"),
    ],
)
def test_a_transfer_ends_for_one_that_is_kept_only_by_that(lasts_s: float, ended: bool) -> None:
    assert ends(pursuer(2, lasts_s, NEAR)) is ended


def test_no_transfer_ends_where_its_receiver_would_be_lost_for_the_other() -> None:
    assert not ends(pursuer(2, 7.0, NEAR), receiver_lasts_s=6.0)


def test_it_is_planned_for_once_a_second_while_energy_flows_unless_an_operator_asked_for_it() -> None:
    early, service = EarlyEnds(RULES, 0.5, 300.0), transfer()
    assert early.due(service, 10.0)
    early.ends(service, pursuer(1, 40.0), [], (), [giver(201)], TIMES, 10.0)
    assert [early.due(service, now_s) for now_s in (10.5, 10.9, 11.0)] == [False, False, True]
    assert not early.due(transfer("operator"), 11.0)
    service.phase = Phase.STOP_GIVER
    assert not early.due(service, 12.0)


def test_of_two_that_share_a_tanker_both_are_kept_by_a_transfer_that_ends_early() -> None:
    """1 lands in 8 s, 2 in 15 s: full, 1 would take the tanker until 15 s, and 2 be reached 3.8 s later."""
    fleet = Fleet({
        1: view(1, "pursuer", (0.0, 0.0, -4.8), 2_600.0, 20_000.0),
        2: view(2, "pursuer", (0.0, 1.4, -6.0), 4_000.0, 20_000.0),
        201: view(201, "tanker", (0.0, 0.0, -6.0), 150_000.0, 150_000.0),
    })  # fmt: skip
    for sysid in (1, 2):
        fleet.set(sysid, power_w=200.0)
    rules = RefuellingRules(rate_w=RATE_W, hold_s=1.0)
    game = Play(Scheduler(CompetitionRules(), rules, (tanker(),)), fleet)
    while game.now_s < 30.0:
        for sysid in (1, 2):
            fleet.set(sysid, drawn_j=fleet.views[sysid].drawn_j + 20.0)
            assert fleet.views[sysid].remaining_j > 1_000.0, f"{sysid} is kept"
        game.tick()
    first, second = game.schedule.services[:2]
    assert (first.receiver, first.ended_by) == (1, "others need it more")
    assert 1_000 < first.energy_j < 12_000
    assert second.receiver == 2
