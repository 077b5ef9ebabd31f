"""The demo with its vehicles competing on board and the ground station's radio dead from 30 s to 90 s, by what the
vehicles themselves recorded. It has no aircraft: vehicles on board receive none, and one passed them in the dark."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest
from pymavlink.dialects.v20 import common as mavlink
from sessions import Outcome, demo, fly, merged, raw_frames, small
from ways import at_grants, nearest_m

PURSUERS, TARGET, TANKER = (1, 2, 3, 4, 5), 101, 201
FROM_S, TO_S = 30.0, 90.0
ON_BOARD: dict[str, Any] = {"competition": {"where": "vehicles"}}


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    silent = {
        "traffic": [],
        "radio": {"ground_blackouts": [{"from_s": FROM_S, "to_s": TO_S}]},
        "goal": {"duration_s": 115},
    }
    return fly(merged(demo(), {**ON_BOARD, **silent}), tmp_path_factory.mktemp("silent"), "--quiet")


@pytest.mark.slow
def test_the_ground_stations_radio_was_dead(flown: Outcome) -> None:
    raw = raw_frames(flown.folder / "session.tlog")
    frames = [t_s - flown.epoch_s for t_s, msgid, _ in raw if msgid != mavlink.MAVLINK_MSG_ID_SYSTEM_TIME]
    dark = [t_s for t_s in frames if FROM_S <= t_s < TO_S]
    assert dark == []
    assert max(frames) > TO_S


@pytest.mark.slow
def test_those_in_need_are_decided_met_and_served_all_the_same(flown: Outcome) -> None:
    """All whose charge would not have lasted, each by energy that it took in the dark."""
    for sysid in PURSUERS:
        truth = flown.truth(sysid)
        dark = (truth.time_s >= FROM_S) & (truth.time_s <= TO_S)
        drawn, received, _, remaining = truth.energy[dark].T
        would_last = remaining[0] - (drawn[-1] - drawn[0]) > 0.05 * truth.head["capacity_j"]
        assert would_last or received[-1] > received[0], sysid
    served = [r for r in flown.summary["refuelling"] if r["decided_at_s"] >= FROM_S and (r["start_s"] or TO_S) < TO_S]
    assert len(served) >= 4
    assert all(r["energy_j"] > 0 and r["decided_at_s"] < r["start_s"] for r in served)


@pytest.mark.slow
def test_nobody_is_served_twice_at_once_or_again_before_it_is_in_need(flown: Outcome) -> None:
    for sysid in PURSUERS:
        own = [r for r in flown.summary["refuelling"] if r["receiver"] == sysid]
        for earlier, later in itertools.pairwise(own):
            assert earlier["end_s"] <= later["decided_at_s"]
            truth = flown.truth(sysid)
            row = int(np.searchsorted(truth.time_s, later["decided_at_s"]))
            assert truth.energy[row, 3] <= 0.55 * truth.head["capacity_j"]


@pytest.mark.slow
def test_nobody_is_lost_and_the_plan_goes_on(flown: Outcome) -> None:
    assert (flown.status, flown.summary["outcome_text"]) == (0, "met")
    for sysid in (*PURSUERS, TARGET, TANKER):
        truth = flown.truth(sysid)
        assert truth.energy[:, 3].min() > 0.05 * truth.head["capacity_j"]
        assert flown.vehicle(sysid)["final_mode"] in {"offboard", "refuel"}
    target = flown.truth(TARGET)
    after = target.time_s > TO_S + 5.0
    assert np.linalg.norm(np.diff(target.p_ned[after], axis=0), axis=1).sum() > 0.8 * 0.5 * (115.0 - TO_S - 5.0)
    for sysid in PURSUERS:
        distance = np.linalg.norm(flown.truth(sysid).p_ned - target.p_ned, axis=1)[after]
        assert np.median(distance) == pytest.approx(2.0, abs=0.4)


@pytest.mark.slow
def test_everyone_keeps_apart_in_the_dark(flown: Outcome) -> None:
    assert nearest_m(at_grants(flown, (*PURSUERS, TARGET, TANKER))[:, 20:]) >= 0.6


def test_a_session_on_board_is_reproducible_whatever_the_datagrams(tmp_path: Any) -> None:
    content = small(**ON_BOARD, radio={"loss": 0.2, "delay_s": 0.2}, goal={"duration_s": 15.0, "refuelled_at_least": 0})
    outcomes = [fly(content, tmp_path / "a"), fly(content, tmp_path / "b", "--drop-datagrams", "0.05")]
    assert len({outcome.summary["digest"] for outcome in outcomes}) == 1
    assert outcomes[0].summary["refuelling"][0]["receiver"] == 1


def test_what_a_bad_radio_kept_from_arriving_comes_back_to_the_tanker(tmp_path: Any) -> None:
    """30 % loss and 0.2 s of delay: a transfer breaks off while 2 kJ are on the way."""
    radio, goal = {"loss": 0.3, "delay_s": 0.2}, {"duration_s": 30.0, "refuelled_at_least": 0}
    outcome = fly(small(**ON_BOARD, seed=15, radio=radio, goal=goal), tmp_path, "--quiet", "--no-report")
    _, credited_j, _, _ = outcome.truth(1).energy[-1]
    _, returned_j, given_j, _ = outcome.truth(TANKER).energy[-1]
    assert returned_j > 0
    assert given_j == credited_j + returned_j
    assert sum(service["energy_j"] for service in outcome.summary["refuelling"]) == credited_j
    assert outcome.vehicle(TANKER)["energy"]["lost_j"] == 0
