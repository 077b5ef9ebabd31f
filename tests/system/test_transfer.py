"""Energy in the air: every joule is accounted for, whatever happens to the vehicles and to the radio."""

from __future__ import annotations

import signal
from pathlib import Path

import numpy as np
import pytest
from sessions import Outcome, Running, all_gone, demo, fly, merged, small

EVERYONE = (1, 101, 201)


@pytest.fixture(scope="module")
def clear(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    """The small session, undisturbed."""
    return fly(small(), tmp_path_factory.mktemp("clear"), "--plain")


def assert_ledgers_close(outcome: Outcome, sysids: tuple[int, ...]) -> None:
    for sysid in sysids:
        truth = outcome.truth(sysid)
        assert truth.ledger_error_j() <= 1e-6 * truth.head["capacity_j"], sysid
    given = sum(outcome.truth(sysid).energy[-1, 2] for sysid in sysids)
    received = sum(outcome.truth(sysid).energy[-1, 1] for sysid in sysids)
    assert received <= given


def test_a_needy_vehicle_is_refuelled_up_to_the_level(clear: Outcome) -> None:
    assert clear.status == 0, clear.stderr
    truth = clear.truth(1)
    assert truth.energy[:, 3].max() == pytest.approx(0.9 * 24000, abs=400)  # 2 kW, told twice a second
    assert_ledgers_close(clear, EVERYONE)
    (service,) = clear.summary["refuelling"]
    assert service["energy_j"] == truth.energy[-1, 1] == clear.truth(201).energy[-1, 2]
    assert clear.vehicle(201)["energy"]["lost_j"] == 0


def test_joules_flow_only_while_the_tanker_is_there(clear: Outcome) -> None:
    receiver, tanker = clear.truth(1), clear.truth(201)
    flowing = np.diff(receiver.energy[:, 1]) > 0
    gap = np.linalg.norm(receiver.p_ned - tanker.p_ned, axis=1)[1:]
    relative = np.linalg.norm(receiver.state[:, 3:6] - tanker.state[:, 3:6], axis=1)[1:]
    assert flowing.any()
    assert gap[flowing].max() <= 1.5 + 0.05
    assert relative[flowing].max() <= 0.5 + 0.1


def test_it_closes_when_the_tanker_is_pushed_out_of_the_capture_radius(tmp_path: Path) -> None:
    """Traffic comes for the tanker, whose planner gives way; the receiver itself ends the transfer."""
    pushed = small(
        goal={"duration_s": 45.0, "refuelled_at_least": 0},
        refuelling={"capture_m": 1.3, "rate_w": 500.0},
        traffic=[
            {"callsign": "PUSHER", "path_m": [[2.0, -9.0, -3.9], [2.0, 9.0, -3.9]], "speed_m_s": 0.8, "start_s": 8.0}
        ],
    )
    outcome = fly(pushed, tmp_path, "--plain")
    assert any(d["kind"] == "broken off" for d in outcome.decisions)
    assert any("m away" in line or "moves at" in line for line in outcome.stdout.splitlines()), outcome.stdout
    assert_ledgers_close(outcome, EVERYONE)
    receiver = outcome.vehicle(1)["energy"]
    tanker = outcome.vehicle(201)["energy"]
    taken_back_j = tanker["received_j"]
    assert tanker["given_j"] == receiver["received_j"] + taken_back_j + tanker["lost_j"]


def test_it_closes_when_the_tanker_is_killed_in_mid_transfer(tmp_path: Path) -> None:
    running = Running(small(clock={"mode": "real", "speed": 5.0}, goal={"duration_s": 40.0}), tmp_path, "--json")
    try:
        running.wait_for(lambda s: any(v["phase"] == "transfer" and v["energy_j"] > 1000 for v in s["services"]))
        tanker = running.vehicle(201)
        tanker.send_signal(signal.SIGKILL)
        assert not all_gone([tanker])
        outcome = running.finish()
    finally:
        running.stop()
    assert outcome.status == 1
    assert outcome.summary["outcome"] == "lost"
    assert outcome.vehicle(201)["final_mode"] == "dead"
    assert_ledgers_close(outcome, EVERYONE)
    (service,) = outcome.summary["refuelling"]
    assert service["end_s"] is not None
    assert service["energy_j"] == outcome.truth(1).energy[-1, 1]
    lost_j = outcome.vehicle(201)["energy"]["lost_j"]
    assert outcome.vehicle(201)["energy"]["given_j"] == service["energy_j"] + lost_j


def test_what_was_on_the_way_to_one_that_is_killed_is_lost_by_its_giver(tmp_path: Path) -> None:
    """In the air and at a base. The truth is what each giver gave, without what the dead had received by their own
    account; of that, what they said in the last 0.2 s, and in the tick at which they die, never arrives."""
    content = small(
        goal={"duration_s": 24.0, "refuelled_at_least": 0},
        radio={"delay_s": 0.2},
        bases=[{"name": "pad", "position_m": [0.0, 6.0, 0.0], "stock_j": 50_000.0}],
        competition={"bids": "need"},
        faults=[{"fault": "kill", "sysid": 1, "at_s": 14.0}, {"fault": "kill", "sysid": 2, "at_s": 18.0}],
    )
    battery = {"capacity_j": 24000, "initial_percent": 45}
    content["vehicles"]["pursuers"].append({"sysid": 2, "start_m": [0, 3, 0], "battery": battery, "transfer": False})
    outcome = fly(content, tmp_path, "--plain")
    (base,), tanker = outcome.summary["bases"], outcome.vehicle(201)["energy"]
    assert tanker["given_j"] == outcome.truth(201).energy[-1, 2]
    for receiver, giver in ((1, tanker), (2, base)):
        on_the_way_j = giver["given_j"] - outcome.truth(receiver).energy[-1, 1]
        assert 0 < on_the_way_j <= giver["lost_j"] <= on_the_way_j + 2000.0 * (0.2 + 0.1)


@pytest.mark.slow
@pytest.mark.parametrize("lost", ["first", "last"])
def test_it_closes_when_the_first_or_last_counter_is_lost(clear: Outcome, tmp_path: Path, lost: str) -> None:
    """The tanker's frames are dark around the transfer's start or end, as the undisturbed session shows them."""
    given = clear.truth(201)
    moving = given.time_s[1:][np.diff(given.energy[:, 2]) > 0]
    at_s = float(moving[0] if lost == "first" else moving[-1])
    dark = {"sysid": 201, "from_s": at_s - 0.05, "to_s": at_s + 0.35}
    outcome = fly(small(radio={"blackouts": [dark]}, goal={"duration_s": at_s + 12.0}), tmp_path, "--plain")
    assert_ledgers_close(outcome, EVERYONE)
    receiver, tanker = outcome.truth(1).energy[-1], outcome.truth(201).energy[-1]
    assert receiver[1] > 0
    assert tanker[2] == receiver[1] + outcome.vehicle(201)["energy"]["lost_j"]


@pytest.mark.slow
def test_what_was_on_the_way_when_a_transfer_broke_off_comes_back(tmp_path: Path) -> None:
    """Over a slow radio transfers break off again and again, each with up to a second's energy on the way."""
    quick = {"goal": {"duration_s": 46.0, "refuelled_at_least": 0, "pursue": None}, "vehicles_per_process": 8}
    outcome = fly(merged(demo(), {"radio": {"delay_s": 0.2}, **quick}), tmp_path, "--plain")
    sysids = (1, 2, 3, 4, 5, 101, 201)
    assert_ledgers_close(outcome, sysids)
    settled = [d for d in outcome.decisions if d["kind"] == "settled"]
    _, returned_j, given_j, _ = outcome.truth(201).energy[-1]
    assert returned_j == sum(d["energy_j"] for d in settled) > 4000
    received_j = sum(outcome.truth(sysid).energy[-1, 1] for sysid in sysids[:5])
    ended = [one for one in outcome.summary["refuelling"] if one["end_s"] is not None]
    assert outcome.vehicle(201)["energy"]["lost_j"] == given_j - received_j - returned_j
    if len(ended) == len(outcome.summary["refuelling"]):  # nothing is on the way at the end
        assert given_j == received_j + returned_j
    assert "Took back" in outcome.stdout
