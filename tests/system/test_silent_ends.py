"""Vehicles of which nothing comes any more when a session ends: they are judged by their own truth."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sessions import Outcome, fly, merged, small

ALL = (1, 2, 3)
BLIND = {"radio": {"ground_blackouts": [{"from_s": 12.0, "to_s": 500.0}]}}
SILENT_STATION = {"faults": [{"fault": "gcs_silent", "at_s": 12.0, "for_s": 500.0}]}


def rows(**changes: Any) -> dict[str, Any]:
    """Three vehicles side by side that fly 16 m out, and back to above their starts."""
    content: dict[str, Any] = {
        "schema": 1,
        "name": "rows",
        "axes": "ned",
        "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 0.0},
        "clock": {"mode": "lockstep"},
        "goal": {"duration_s": 60.0},
        "planner": {"cruise_m_s": 2.0, "separation_m": 0.8},
        "refuelling": {"enabled": False},
        "vehicles": {
            "defaults": {"battery": {"capacity_j": 60000}},
            "pursuers": [
                {
                    "sysid": sysid,
                    "start_m": [-8, 2 * sysid, 0],
                    "waypoints_m": [[8, 2 * sysid, -3], [-8, 2 * sysid, -3]],
                }
                for sysid in ALL
            ],
        },
    }
    return merged(content, changes)


def dark(from_s: float, to_s: float, **changes: Any) -> dict[str, Any]:
    """The same, with the radio of vehicle 2 dead for a time."""
    return rows(radio={"blackouts": [{"sysid": 2, "from_s": from_s, "to_s": to_s}]}, **changes)


def flown(content: dict[str, Any], folder: Path) -> tuple[str, Outcome]:
    outcome = fly(content, folder, "--plain", "--no-report")
    return outcome.summary["outcome_text"], outcome


def part(outcome: Outcome, name: str) -> dict[str, Any]:
    return next(each for each in outcome.summary["goal"] if each["part"] == name)


def landed_s(outcome: Outcome, sysid: int) -> float:
    truth = outcome.truth(sysid)
    return float(truth.time_s[np.flatnonzero(truth.p_ned[:, 2] < -0.05)[-1] + 1])


@pytest.mark.parametrize(("content", "who"), [(rows(**BLIND), ALL), (dark(12.0, 500.0), (2,))], ids=["all", "one"])
def test_vehicles_that_came_home_in_silence_are_lost_when_they_landed(
    content: dict[str, Any], who: tuple[int, ...], tmp_path: Path
) -> None:
    """They had passed the first of two way points; the other one lies on their failsafe's way down."""
    _, outcome = flown(content, tmp_path)
    lost = part(outcome, "lost")
    assert (outcome.status, lost["sysids"]) == (1, list(who))
    for sysid in who:
        at_s = landed_s(outcome, sysid)
        assert 30.0 < at_s < 45.0
        assert f"{sysid} at {at_s:.1f} s: no telemetry since 11.9 s, landed by itself" in lost["reached"]
    assert lost["t_s"] == min(landed_s(outcome, sysid) for sysid in who)
    missed = part(outcome, "waypoints")
    assert (missed["met"], missed["value"], missed["sysids"]) == (False, len(who), list(who))


@pytest.mark.parametrize("truth", [True, False])
def test_where_the_station_alone_is_not_received_they_are_lost_when_they_landed(truth: bool, tmp_path: Path) -> None:
    """Without truth that is when they said so."""
    _, outcome = flown(rows(**SILENT_STATION, truth=truth), tmp_path)
    said = [(t_s, m.get_srcSystem()) for t_s, m in outcome.messages("STATUSTEXT") if m.text.startswith("Landed")]
    assert sorted(sysid for _, sysid in said) == list(ALL)
    for said_s, sysid in said:
        at_s = landed_s(outcome, sysid) if truth else said_s
        assert said_s - 0.5 < at_s <= said_s
        assert f"{sysid} at {at_s:.1f} s: landed by itself" in part(outcome, "lost")["reached"]
    assert part(outcome, "waypoints")["sysids"] == list(ALL)
    assert not outcome.summary["faults"][0]["survived"]


def test_what_its_failsafe_still_flies_at_the_end_is_lost_then_and_not_before_its_delay(tmp_path: Path) -> None:
    text, _ = flown(dark(56.0, 500.0), tmp_path / "short")
    assert text == "met"
    text, _ = flown(dark(52.0, 500.0), tmp_path / "long")
    assert text == "not met: lost 1 (2 at 60.0 s: no telemetry since 51.9 s, its failsafe flies it)"
    slow = {"vehicles": {"defaults": {"battery": {"capacity_j": 60000}, "params": {"COM_DL_LOSS_T": 10.0}}}}
    text, _ = flown(dark(52.0, 500.0, **slow), tmp_path / "slow")
    assert text == "met"


def test_without_truth_a_vehicle_that_is_silent_for_its_failsafes_delay_is_lost_at_the_end(tmp_path: Path) -> None:
    text, _ = flown(dark(12.0, 500.0, truth=False), tmp_path)
    assert text.startswith("not met: lost 1 (2 at 60.0 s: no telemetry since 11.9 s);")


def test_a_session_in_which_the_silence_ends_and_they_fly_on_is_met(tmp_path: Path) -> None:
    text, outcome = flown(
        rows(radio={"ground_blackouts": [{"from_s": 12.0, "to_s": 45.0}]}, goal={"duration_s": 90.0}), tmp_path
    )
    assert text == "met"
    truth = outcome.truth(1)
    assert np.allclose(truth.p_ned[(truth.time_s > 40.0) & (truth.time_s < 45.0), 2], 0.0)


def test_one_that_is_received_again_on_the_ground_just_before_the_end_was_lost_when_it_landed(tmp_path: Path) -> None:
    _, outcome = flown(dark(12.0, 59.8), tmp_path)
    assert f"2 at {landed_s(outcome, 2):.1f} s: landed by itself" in part(outcome, "lost")["reached"]


def test_those_that_compete_on_board_fly_on_without_the_station_and_are_not_lost(tmp_path: Path) -> None:
    silent = {"radio": BLIND["radio"], "competition": {"where": "vehicles"}, "goal": {"refuelled_at_least": 0}}
    text, outcome = flown(small(**silent), tmp_path)
    assert text == "met"
    assert max(float(outcome.truth(sysid).p_ned[-1, 2]) for sysid in (1, 101, 201)) < -1.0
