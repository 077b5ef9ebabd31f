"""Whom a tick asks, against a fleet of which everybody is asked in every tick."""

from collections import Counter
from typing import Any

import pytest
from changing import ChangingFleet

from gcs.scenario.external import External
from gcs.supervisor.arming import SELDOM_S, ArmingSequence, Stage
from gcs.supervisor.arming_external import ExternalArmingSequence
from gcs.supervisor.fleet_arming import FleetArming, Groups

SYSIDS = (1, 2, 3, 7, 101, 201)
TICKS = 2500
RESTING = (Stage.FLY, Stage.DOWN, Stage.TAKEN)


def sequences() -> dict[int, ArmingSequence]:
    ours = {sysid: ArmingSequence(sysid, 2.5, seldom_s=SELDOM_S, rejoins_itself=sysid != 3) for sysid in SYSIDS[:-1]}
    rules = External(connect="udpin:127.0.0.1:14550", capacity_j=1e4, arm_within_s=20.0)
    return {**ours, SYSIDS[-1]: ExternalArmingSequence(SYSIDS[-1], 2.5, rules)}


def wants(fleet: ChangingFleet, *several: dict[int, ArmingSequence]) -> None:
    """Somebody wants something of one of them, or a fault befalls it."""
    sysid = fleet.chance.choice(SYSIDS)
    seen = next(each for each in fleet.views if each.sysid == sysid)
    what = fleet.chance.choice(["order", "order", "release", "rejoin", "rejoin", "rejoin", "excuse", "mend", "mend"])
    arguments: dict[str, tuple[Any, ...]] = {
        "order": (fleet.chance.choice(["hold", "return", "land"]),), "excuse": (fleet.time_s,), "mend": (seen,),
    }  # fmt: skip
    for one in several:
        getattr(one[sysid], what)(*arguments.get(what, ()))


@pytest.mark.parametrize("seed", range(2))
def test_who_is_not_asked_would_not_have_answered_nor_changed(seed: int) -> None:
    fleet, everybody = ChangingFleet(SYSIDS, seed), sequences()
    some = FleetArming(sequences())
    grounded, asked = frozenset[int](), 0
    before = {s: (one.stage, one.ordered, one.grounded, one.left_out) for s, one in everybody.items()}
    told = 0
    for tick in range(TICKS):
        if fleet.chance.random() < 0.03:
            wants(fleet, everybody, some.sequences)
        if fleet.chance.random() < 0.02:
            grounded = frozenset(fleet.chance.sample(SYSIDS, fleet.chance.choice([0, 0, 1, 2])))
        some.ground(grounded)
        for sysid, sequence in everybody.items():
            sequence.grounded = sysid in grounded
        snapshot, _ = fleet.tick()
        bound = tick % 100 < 20
        answers = {s: one.decide(snapshot.vehicle(s), fleet.time_s, bound=bound) for s, one in everybody.items()}
        due = some.due(snapshot.columns)
        asked += len(due)
        for sysid in due:
            seen = snapshot.vehicle(sysid)
            assert some.sequences[sysid].decide(seen, fleet.time_s, bound=bound) == answers.pop(sysid)
            some.asked(sysid, seen)
        assert all(answer == ([], []) for answer in answers.values())
        assert {s: one.stage for s, one in some.sequences.items()} == {s: one.stage for s, one in everybody.items()}
        assert some.groups == Groups.of(everybody)
        assert some.groups.steered == {s for s, one in everybody.items() if one.sends_set_points}
        now = {s: (one.stage, one.ordered, one.grounded, one.left_out) for s, one in everybody.items()}
        assert {s for s in SYSIDS if now[s] != before[s]} <= some.moved
        before, told = now, told + len(some.moved)
    assert len(SYSIDS) * TICKS / 5 < asked < len(SYSIDS) * TICKS * 0.7
    assert told < len(SYSIDS) * TICKS * 0.7


def test_all_that_a_resting_sequence_is_has_stayed_as_it_was() -> None:
    """Not only what it answers: its whole memory but for the time at which it reads parameters that are there."""
    rested = Counter[Stage]()
    for seed in range(2):
        fleet, everybody = ChangingFleet(SYSIDS, seed), sequences()
        for _ in range(TICKS):
            if fleet.chance.random() < 0.03:
                wants(fleet, everybody)
            if fleet.chance.random() < 0.05:  # one that is met as it is
                sysid = fleet.chance.choice(SYSIDS)
                everybody[sysid] = sequences()[sysid]
            snapshot, _ = fleet.tick()
            for sysid, one in everybody.items():
                seen, one.grounded = snapshot.vehicle(sysid), fleet.chance.random() < 0.1
                one.decide(seen, fleet.time_s)
                if (
                    one.rests(seen)
                    and one.stage in RESTING
                    and (rested[one.stage] < 500 or fleet.chance.random() < 0.2)
                ):
                    memory = dict(vars(one))
                    for later_s in (0.1, 1.5, 100.0):
                        assert one.decide(seen._replace(drawn_j=9e3), fleet.time_s + later_s) == ([], [])
                        assert vars(one) == memory
                    rested[one.stage] += 1
    assert all(rested[stage] > 200 for stage in RESTING)
