"""Whole fleets that refuel themselves, in one process and without a ground station: what each vehicle knows, gives,
takes and keeps from the others, over a radio that loses and delays."""

from __future__ import annotations

import math
from statistics import median
from typing import Any

import pytest
from fleets import FleetInProcess, agreement, on_board, random_fleet

LOSSY = {"loss": 0.2, "delay_s": 0.2}
SIX = {sysid: ((3.0 * sysid - 10.0, 2.0 * (sysid % 2), -3.0), 30.0 + 3.0 * sysid) for sysid in range(1, 7)}
TWO = {201: (-8.0, 5.0, -8.0), 202: (8.0, 5.0, -9.0)}


@pytest.mark.parametrize("bids", ["time", "losses"])
def test_ten_vehicles_agree_within_two_seconds_of_the_central_competition(bids: str) -> None:
    """Both over 20 % loss and 0.2 s of delay, in the same flights; the median, and everyone before long."""
    late_s, same = [], 0
    for seed in range(5):
        content = random_fleet(seed, pursuers=10, tankers=1, half_m=12.0, percent=(25.0, 49.0), radio=LOSSY)
        content["competition"] |= {"bids": bids}
        one = agreement(content)
        late_s.append(one.agreed_s - one.central_s)
        same += one.on_board == one.central
    assert median(late_s) <= 2.0
    assert max(late_s) <= 4.0
    # Bids by time that differ by less than the tie may win alike. With bids by losses each plans from what it has
    # received, and one tanker cannot keep all ten: orders that lose as many are as good.
    assert same >= 4 or bids == "losses"


class Watch:
    """What must hold in every tick."""

    def __init__(self, fleet: FleetInProcess) -> None:
        self.fleet = fleet
        self.least_m = math.inf
        self.moving: dict[int, set[int]] = {}

    def __call__(self) -> bool:
        self.least_m = min(self.least_m, *(distance for *_, distance in self.fleet.distances_m()))
        receivers = [receiver for _, receiver in self.fleet.transferring()]
        assert len(receivers) == len(set(receivers)), "two tankers serve one vehicle"
        for tanker, receiver in self.fleet.transferring():
            self.moving.setdefault(receiver, set()).add(tanker)
        return False


def flown(content: dict[str, Any], seconds: float) -> tuple[FleetInProcess, Watch]:
    fleet = FleetInProcess(content)
    watch = Watch(fleet)
    fleet.fly(seconds, watch)
    return fleet, watch


def test_everyone_is_served_once_and_apart_and_no_joule_is_lost() -> None:
    radio = {"loss": 0.3, "jitter_s": 0.2, "duplicate": 0.2, "reorder": 0.2}
    fleet, watch = flown(on_board(SIX, TWO, radio=radio, seed=3), 48.0)
    duties = [duty for sysid in TWO if (duty := fleet.member(sysid).tanker) is not None]
    served = [service.receiver for duty in duties for service in duty.services]
    first = sorted((service.decided_s, service.receiver) for duty in duties for service in duty.services)[:6]
    assert sorted(receiver for _, receiver in first) == [1, 2, 3, 4, 5, 6], served
    assert watch.least_m >= 0.6
    assert all(service.energy_j > 0 for duty in duties for service in duty.services if service.end_s > 0.0)
    assert {vehicle.mode for vehicle in fleet.vehicles.values()} <= {"offboard", "refuel"}
    for sysid in SIX:
        given = sum(s.energy_j for duty in duties for s in duty.services if s.receiver == sysid and s.end_s > 0.0)
        under_way = any(duty.receiver == sysid for duty in duties)
        turned_away = given - fleet.vehicles[sysid].received_j  # full while its stop was on the way
        assert under_way or 0 <= turned_away <= 0.02 * given, sysid


def test_a_fleet_in_two_parts_serves_itself_in_both_and_goes_on_together() -> None:
    """Each part has a tanker; nobody is served by the other part's while they are apart."""
    split = [{"sysids": [1, 2, 3, 201], "from_s": 0.0, "to_s": 36.0}]
    fleet, watch = flown(on_board(SIX, TWO, radio={**LOSSY, "splits": split}, seed=5), 36.0)
    assert set(fleet.served()[201]) == {1, 2, 3}
    assert set(fleet.served()[202]) == {4, 5, 6}
    assert {receiver: tankers for receiver, tankers in watch.moving.items() if len(tankers) > 1} == {}
    fleet.fly(3.0, watch)
    assert {fleet.believed(sysid).keys() == TWO.keys() for sysid in fleet.vehicles} == {True}


def test_a_part_without_a_tanker_waits_and_is_served_when_the_parts_meet() -> None:
    pursuers = {sysid: SIX[sysid] for sysid in (1, 2, 3)}
    split = [{"sysids": [3], "from_s": 0.0, "to_s": 15.0}]
    fleet, _ = flown(on_board(pursuers, {201: (0.0, 5.0, -8.0)}, radio={"splits": split}), 15.0)
    assert 3 not in fleet.served()[201]
    assert fleet.member(3).receiver.stage.name == "APART"  # type: ignore[union-attr]
    fleet.fly(28.0)
    assert 3 in fleet.served()[201]


def test_a_receiver_that_falls_silent_frees_its_tanker() -> None:
    pursuers = {sysid: SIX[sysid] for sysid in (1, 2)}
    dark = {"blackouts": [{"sysid": 1, "from_s": 4.0, "to_s": 60.0}]}
    fleet, _ = flown(on_board(pursuers, {201: (0.0, 9.0, -8.0)}, radio=dark), 30.0)
    assert fleet.served()[201][:2] == [1, 2]
    assert fleet.vehicles[1].received_j < fleet.vehicles[2].received_j


def test_who_hears_nobody_returns_and_who_hears_a_peer_stays() -> None:
    """The failsafe for a lost link is that of nobody heard at all."""
    pursuers = {1: ((6.0, 0.0, -3.0), 95.0), 2: ((0.0, 0.0, -3.0), 95.0), 3: ((0.0, 4.0, -3.0), 95.0)}
    dark = {"blackouts": [{"sysid": 1, "from_s": 2.0, "to_s": 60.0}]}
    fleet, _ = flown(on_board(pursuers, {201: (0.0, 9.0, -8.0)}, radio=dark), 12.0)
    assert fleet.vehicles[1].mode in ("return", "land")
    assert {fleet.vehicles[sysid].mode for sysid in (2, 3)} == {"offboard"}


def test_the_ground_station_learns_all_of_it_afterwards() -> None:
    """Its own radio is dead while two are served; each tanker reports all of its services again."""
    pursuers = {sysid: SIX[sysid] for sysid in (1, 2)}
    radio = {**LOSSY, "ground_blackouts": [{"from_s": 1.0, "to_s": 36.0}]}
    fleet = FleetInProcess(on_board(pursuers, {201: (0.0, 5.0, -8.0)}, radio=radio))
    fleet.fly(36.0)
    assert fleet.watched.services == []
    fleet.fly(4.0)
    known = [(s.receiver, s.energy_j) for s in fleet.watched.services]
    assert known == [(s.receiver, s.energy_j) for s in fleet.member(201).tanker.services]  # type: ignore[union-attr]
    assert len(known) == 2
    assert all(s.decided_at_s < s.start_s < s.end_s < 36.0 for s in fleet.watched.services)  # type: ignore[operator]


def test_the_same_seed_flies_the_same_to_the_last_bit() -> None:
    content = on_board(SIX, TWO, radio=LOSSY, seed=9)
    states = [b"".join(v.state.tobytes() for v in flown(content, 4.0)[0].vehicles.values()) for _ in range(2)]
    assert states[0] == states[1]
    assert states[0] != b"".join(v.state.tobytes() for v in flown({**content, "seed": 10}, 4.0)[0].vehicles.values())
