"""The paper's loop closed: control energy that was measured competes, for a target and for a tanker, as shipped."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from sessions import Outcome, fly

from gcs.scenario.file import find

LOCKSTEP = ("--lockstep", "--plain", "--no-report", "--set")


def reported(outcome: Outcome, pursuers: range) -> dict[int, tuple[np.ndarray, np.ndarray]]:
    """Times and control efforts of each vehicle's reports."""
    rows: dict[int, list[tuple[float, float]]] = {sysid: [] for sysid in pursuers}
    for _, message in outcome.messages("NAMED_VALUE_FLOAT"):
        if message.name == "CtlEffort" and message.get_srcSystem() in rows:
            rows[message.get_srcSystem()].append((message.time_boot_ms / 1e3, message.value))
    return {sysid: tuple(np.array(each).T) for sysid, each in rows.items()}  # type: ignore[misc]


def efforts_at(outcome: Outcome, t_s: float) -> dict[int, float]:
    found = reported(outcome, range(1, 6))
    return {sysid: float(np.interp(t_s, times, efforts)) for sysid, (times, efforts) in found.items()}


@pytest.fixture(scope="module")
def pursuit(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    folder = tmp_path_factory.mktemp("pursuit")
    return fly(str(find("pursuit")), folder, *LOCKSTEP, "goal.duration_s=50", "--set", "goal.pursue.for_s=5")


def test_who_has_used_least_pursues_and_another_takes_over(pursuit: Outcome) -> None:
    assert pursuit.status == 0, pursuit.stdout
    changes = [d for d in pursuit.decisions if d["kind"] == "pursuit"]
    assert [d["before"] for d in changes] == [None, changes[0]["pursuer"]]
    for change in changes:
        efforts = efforts_at(pursuit, change["t_s"])
        assert min(efforts, key=lambda sysid: efforts[sysid]) == change["pursuer"]
        assert change["efforts"] == pytest.approx({str(k): e for k, e in efforts.items()}, abs=2.0)


def test_the_others_hold_and_nobody_moves_before_it_is_decided(pursuit: Outcome) -> None:
    changes = [d for d in pursuit.decisions if d["kind"] == "pursuit"]
    (first_s, first), (second_s, second) = ((d["t_s"], d["pursuer"]) for d in changes)

    def speeds(sysid: int, from_s: float, to_s: float) -> Iterator[float]:
        for d in pursuit.decisions:
            if d["kind"] == "set_point" and d["sysid"] == sysid and from_s <= d["t_s"] < to_s:
                yield math.hypot(*d["v_ned"])

    given_way = {d["sysid"] for d in pursuit.decisions if d["kind"] == "safety"}
    settled_s = 5.0  # they begin with the paper's speeds
    for sysid in {1, 2, 3, 4, 5} - given_way:
        until_s = {first: first_s, second: second_s}.get(sysid, math.inf)
        assert max(speeds(sysid, settled_s, until_s)) < 0.01
    assert max(speeds(first, first_s, second_s)) > 0.5
    target = pursuit.truth(101)
    chaser = pursuit.truth(second)
    late = target.time_s > second_s + 10.0
    assert np.linalg.norm(target.p_ned[late] - chaser.p_ned[late], axis=1).max() < 3.0


def test_the_tanker_goes_to_who_has_used_most_control_energy(tmp_path: Path) -> None:
    options = (*LOCKSTEP, "goal.duration_s=52", "--set", "goal.refuelled_at_least=1")
    flown = fly(str(find("paper/example4-energy")), tmp_path, *options)
    assert flown.status == 0, flown.stdout
    decided = [d for d in flown.decisions if d["kind"] == "decided"]
    assert [d["by"] for d in decided] == ["competition"] * 2
    served: set[int] = set()
    for decision in decided:
        efforts = {k: e for k, e in efforts_at(flown, decision["t_s"]).items() if k not in served}
        assert max(efforts, key=lambda sysid: efforts[sysid]) == decision["receiver"]
        share = np.array(list(efforts.values()))
        tau = 0.01 + 0.99 * (share - share.min()) / (share.max() - share.min())
        assert list(decision["bids"].values()) == pytest.approx(tau, abs=0.05)
        losers = [v for sysid, v in decision["v"].items() if sysid != str(decision["receiver"])]
        assert max(losers) < 0.015 * decision["v"][str(decision["receiver"])]
        served.add(decision["receiver"])
    (service,) = (r for r in flown.summary["refuelling"] if r["end_s"])
    assert service["energy_j"] > 10_000
