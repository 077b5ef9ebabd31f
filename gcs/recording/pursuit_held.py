"""Pairs of pursuer and target in a recorded session, and for how long the goal's pursuit had been held by each time of
it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.recording.series import Floats, Series, Track, held, tracks
from gcs.recording.session_folder import Gathering, Recorded
from gcs.recording.tlog_walk import Chunk
from gcs.scenario.model import Scenario
from gcs.telemetry.pursuit import PursuitHeld

PLACES = ("LOCAL_POSITION_NED", "HEARTBEAT", "EXTENDED_SYS_STATE", "GPS_GLOBAL_ORIGIN")
ROUNDING_S = 1e-6
BLOCK_TICKS = 2000
MOST_PLACES = 1 << 26
"""Of all vehicles at all ticks of a recording that are looked at: 20 vehicles for four days at 10 Hz."""


class HeldTimesReader:
    """Reads the times held out of a recording that another reader walks: `add` each stretch of it, `finish` at its end,
    then ask.

    `decisions`: those of kinds "pursuit" and "operator". `recorded` has the tables PLACES then.
    """

    def __init__(self, scenario: Scenario, decisions: Iterable[Mapping[str, Any]]) -> None:
        self.recorded = Recorded(Path(), scenario=scenario, decisions=[dict(decision) for decision in decisions])
        self._scenario = scenario
        self._gathering = Gathering(self.recorded, PLACES, counted=False)

    def add(self, chunk: Chunk) -> None:
        """Take in the next stretch."""
        self._gathering.add(chunk)

    def finish(self) -> None:
        """The last stretch has been added."""
        self._gathering.finish()

    def held_times(self) -> Callable[[float], float] | None:
        """For how long, s, even the worst had held the goal's pursuit by a time; None where the goal asks for none, or
        no vehicle reported a position."""
        if self._scenario.goal.pursue is None:
            return None
        flown = tracks(self.recorded)
        if not flown:
            return None
        held_s = held_by(self.recorded, flown)[0]
        return lambda t_s: float(held(held_s, np.array([t_s + ROUNDING_S]))[0])


def ticks_of(recorded: Recorded, vehicles: int) -> Floats:
    """(k,) the times of the planner's ticks: none at the session's end, nor while external vehicles are handed back.

    Where so many vehicles would have more than MOST_PLACES, it is every second tick, or every third, and so on.
    """
    scenario = recorded.scenario
    period_s, last_s = (scenario.clock.period_s, scenario.goal.duration_s) if scenario else (0.1, math.inf)
    last_s = min(recorded.end_s, last_s - period_s)
    ticks = int(last_s / period_s + ROUNDING_S)
    every = max(-(-ticks * max(vehicles, 1) // MOST_PLACES), 1)
    return np.arange(every, ticks + 1, every).astype(np.float64) * period_s


def pursued(recorded: Recorded, t_s: Floats) -> dict[int, NDArray[np.int16]]:
    """(k,) system id of each pursuer's target at each tick, by scenario, competition and operators; 0 for none."""
    scenario = recorded.scenario
    if scenario is None:
        return {}
    chosen = scenario.pursuit.by == "competition"
    pursuers = scenario.vehicles.pursuers
    first = {p.sysid: 0 if chosen else scenario.vehicles.target_of(p) for p in pursuers}
    found = {s: np.full(len(t_s), target, dtype=np.int16) for s, target in first.items() if target is not None}
    for decision in recorded.decisions:
        if chosen and decision["kind"] == "pursuit":
            pursuer = decision["pursuer"]
        elif not chosen and decision["kind"] == "operator" and decision["command"] == "retarget" and decision["taken"]:
            pursuer = decision.get("sysid")
        else:
            pursuer = None
        if pursuer is None or "target" not in decision:
            continue
        since = np.searchsorted(t_s, decision["t_s"] - ROUNDING_S)
        for targets in found.values() if chosen else ():
            targets[since:][targets[since:] == decision["target"]] = 0
        if pursuer in found:
            found[pursuer][since:] = decision["target"]
    return found


def held_by(recorded: Recorded, flown: Mapping[int, Track]) -> tuple[Series, dict[int, float]]:
    """For how long the goal's pursuit had been held: at each tick by the worst, and at the end by each pursuer, or
    target where one pursuer is chosen for each; empty without a goal of pursuit."""
    scenario = recorded.scenario
    if scenario is None or scenario.goal.pursue is None:
        return Series(np.empty(0), np.empty(0)), {}
    t_s = ticks_of(recorded, max(len(flown), len(scenario.vehicles.pursuers)))
    of_targets = scenario.pursuit.by == "competition"
    whom = pursued(recorded, t_s)
    keys = [target.sysid for target in scenario.vehicles.targets] if of_targets else list(whom)
    pursuit = PursuitHeld(keys, scenario.goal.pursue.within_m)
    column = {key: i for i, key in enumerate(keys)}
    worst_s = np.empty(len(t_s))
    for begin in range(0, len(t_s), BLOCK_TICKS):
        some = slice(begin, min(begin + BLOCK_TICKS, len(t_s)))
        at = {sysid: track.at(t_s[some]) for sysid, track in flown.items()}
        near_m = np.full((len(t_s[some]), len(keys)), np.nan)
        for pursuer, targets in whom.items():
            for target in np.unique(targets[some]).tolist():
                key = column.get(target if of_targets else pursuer)
                if pursuer in at and target in at and key is not None:
                    apart_m = np.linalg.norm(at[pursuer] - at[target], axis=1)
                    near_m[:, key] = np.fmin(near_m[:, key], np.where(targets[some] == target, apart_m, np.nan))
        worst_s[some] = pursuit.update(t_s[some], near_m)
    return Series(t_s, worst_s), pursuit.held_s
