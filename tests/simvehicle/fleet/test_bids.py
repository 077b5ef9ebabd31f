"""Bids made on board against those that the ground station makes of the same fleet, and by hand."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from fleets import on_board
from views import view

from gcs.processes.vehicles import fleet_rules
from gcs.refuelling.giver import Giver, ServiceTimes, served_if_passed_over_s
from gcs.refuelling.scheduler import TANKER_TIMES
from gcs.refuelling.target_assignment import meeting_s as ground_meeting_s
from gcs.scenario.model import Scenario
from simvehicle.fleet.bids import LONG_S, Offer, begins_s, meeting_s, offers, own_bid
from simvehicle.fleet.peers import PeerReport, PeerStage
from simvehicle.fleet.rules import FleetRules, FleetRulesError, read_rules

SCENARIO = Scenario.model_validate(on_board({1: ((0.0, 0.0, -3.0), 40.0)}, {201: (0.0, 5.0, -8.0)}))
RULES = read_rules(fleet_rules(SCENARIO))


def peer(place: tuple[float, float, float], share: float, **more: object) -> PeerReport:
    report = PeerReport(0.0, PeerStage.COMPETES, 0, True, place, (0.0, 0.0, 0.0), share * 24000.0, 24000.0, 200.0)
    return report._replace(**more)


def test_a_bid_is_the_ground_stations_for_the_same_fleet() -> None:
    rng = np.random.default_rng(4)
    for n in (2, 3, 10):
        places = [tuple(map(float, rng.uniform(-20, 20, 3))) for _ in range(n)]
        shares = [float(rng.uniform(0.2, 0.5)) for _ in range(n)]
        peers = {i + 1: peer(place, share) for i, (place, share) in enumerate(zip(places, shares, strict=True))}
        givers = [Offer(201, (0.0, 5.0, -8.0), 0.0, 5.0, 1e5), Offer(202, (9.0, 9.0, -9.0), 4.0, 5.0, 1e5)]
        views = [
            view(
                sysid,
                p_ned=report.p_ned,
                v_ned=(0.0, 0.0, 0.0),
                capacity_j=24000.0,
                initial_j=report.remaining_j,
                drawn_j=0.0,
                power_w=200.0,
            )
            for sysid, report in peers.items()
        ]
        theirs = [Giver(g.sysid, g.p_ned, g.free_in_s, g.speed_m_s, g.available_j, RULES.rate_w) for g in givers]
        passed_s = served_if_passed_over_s(theirs, views, ServiceTimes(*TANKER_TIMES), SCENARIO.refuelling)
        for i, (sysid, own) in enumerate(peers.items()):
            left_s = (own.remaining_j - RULES.lands_at * 24000.0) / 200.0
            way_s = math.dist(own.p_ned, givers[0].p_ned) / 5.0
            wanted_s = min(max(left_s + way_s - passed_s[i] + 15.0, 0.0), RULES.horizon_s)
            others = {other: report for other, report in peers.items() if other != sysid}
            assert own_bid(0.0, own, others, givers, RULES).bid_s == pytest.approx(wanted_s, abs=1e-9)


def test_who_is_hopeless_bids_the_least_and_who_has_enough_does_not_compete() -> None:
    far = [Offer(201, (500.0, 0.0, 0.0), 0.0, 5.0, 1e5)]
    assert own_bid(0.0, peer((0.0, 0.0, 0.0), 0.1), {}, far, RULES).bid_s == RULES.horizon_s
    near = [Offer(201, (5.0, 0.0, 0.0), 0.0, 5.0, 1e5)]
    assert not own_bid(0.0, peer((0.0, 0.0, 0.0), 0.9), {}, near, RULES).competes
    assert own_bid(0.0, peer((0.0, 0.0, 0.0), 0.4), {}, near, RULES).competes


def test_a_report_is_carried_forward_by_its_age() -> None:
    moving = peer((0.0, 0.0, 0.0), 0.5, v_ned=(1.0, 0.0, 0.0))
    assert moving.p_at(1.2) == (1.2, 0.0, 0.0)
    assert moving.remaining_at_j(1.2) == pytest.approx(12000.0 - 240.0)


def test_a_busy_tanker_is_offered_from_where_its_service_ends() -> None:
    """By hand: 9,600 J are missing, at 2,000 - 200 W they take 5.333 s; then the end, 0.6 s."""
    receiver = peer((3.0, 0.0, -3.0), 0.5, stage=PeerStage.TRANSFERS, partner=201)
    tanker = PeerReport(0.0, PeerStage.TRANSFERS, 1, True, (0.0, 0.0, -8.0), remaining_j=50000.0, capacity_j=2e5)
    (offer,) = offers(0.0, {1: receiver, 201: tanker}, RULES)
    assert offer.p_ned == (3.0, 0.0, -3.0)
    assert offer.free_in_s == pytest.approx(9600.0 / 1800.0 + 0.6)
    assert offer.available_j == pytest.approx(50000.0 - 9600.0)


def test_a_tanker_with_nothing_to_spare_is_no_offer() -> None:
    tanker = PeerReport(0.0, PeerStage.FREE, 0, True, remaining_j=499.0, capacity_j=2e5)
    assert offers(0.0, {201: tanker}, RULES) == []


def test_meetings_are_those_of_the_ground_station() -> None:
    rng = np.random.default_rng(2)
    for _ in range(100):
        offset, v = rng.uniform(-20, 20, 3), rng.uniform(-2, 2, 3)
        assert meeting_s(list(offset), list(v), 5.0) == pytest.approx(ground_meeting_s(offset, v, 5.0))
    assert begins_s(2.0) == pytest.approx(ServiceTimes(*TANKER_TIMES).begins_in_s(2.0), abs=1e-12)
    assert own_bid(0.0, peer((0.0, 0.0, 0.0), 0.4, power_w=0.0), {}, [], RULES).slack_s == LONG_S


def test_rules_survive_their_file_and_what_is_missing_is_named() -> None:
    assert replace(RULES) == read_rules(fleet_rules(SCENARIO))
    assert isinstance(RULES, FleetRules)
    content = fleet_rules(SCENARIO)
    del content["dwell_s"]
    with pytest.raises(FleetRulesError, match="dwell_s"):
        read_rules(content)
    with pytest.raises(FleetRulesError, match="cannot be read"):
        read_rules({**fleet_rules(SCENARIO), "tankers": [{"sysid": "x"}]})
