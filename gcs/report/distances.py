"""Time series of distances in a session: between vehicles, to obstacles, to targets, to planned paths.

Times are the planner's ticks, and places as the ground station knew them then, so that the extremes equal the
summary's `believed_` figures (gcs/telemetry/proximity.py measures with the same kernels).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gcs.recording.decisions_reader import P_NED, SYSID, T_S
from gcs.recording.pursuit_held import held_by, pursued, ticks_of
from gcs.recording.series import Floats, Series, Track, with_gaps
from gcs.recording.session_folder import Recorded, rows_of
from gcs.report.nearness import fill_errors, fill_separations
from gcs.scenario import goal
from gcs.telemetry.metrics import PAUSE_PERIODS, PLAN_MEMORY
from skytender import geometry

BLOCK_TICKS = 2000
ROUNDING_S = 1e-6


@dataclass(frozen=True)
class Nearness:
    """Series over the ticks; NaN where there was nothing to measure."""

    separation: Series
    """the least distance of any two vehicles in flight that were not partners of a refuelling"""
    pair: NDArray[np.int64]
    """(k, 2) which two those were, system ids"""
    clearance: Series
    """the least distance of any vehicle in flight to an obstacle's surface"""
    traffic: Series
    """the least distance of any vehicle in flight to traffic that is to be kept away from"""
    to_target: dict[int, Series]
    """each pursuer's distance to what it pursues"""
    held_s: dict[int, float]
    """by pursuer, or target where one is chosen for each, the longest time for which it was within the goal's distance;
    empty without such a goal"""


def measure(recorded: Recorded, flown: Mapping[int, Track], others: Mapping[str, Track]) -> Nearness:
    """All of it; empty series where no track is known."""
    scenario = recorded.scenario
    pursuers = len(scenario.vehicles.pursuers) if scenario else 0
    t_s = ticks_of(recorded, max(len(flown), pursuers)) if flown else np.empty(0)
    ticks = len(t_s)
    sysids = np.array(sorted(flown), dtype=np.int64)
    rows = {sysid: row for row, sysid in enumerate(sysids.tolist())}
    separation, clearance, traffic = np.full(ticks, np.nan), np.full(ticks, np.nan), np.full(ticks, np.nan)
    pair = np.zeros((ticks, 2), dtype=np.int64)
    draws = {mover.callsign for mover in scenario.traffic if mover.attracts} if scenario else set()
    aircraft = [track for name, track in others.items() if name not in draws]
    worlds = [] if recorded.worlds is None else list(recorded.worlds)
    tables = [(since_s, geometry.of_scenario(world.obstacles)) for since_s, world in worlds]
    partners = _partners(recorded, rows)
    whom = pursued(recorded, t_s)
    to_target = {sysid: np.full(ticks, np.nan) for sysid in whom if sysid in rows}
    for begin in range(0, ticks, BLOCK_TICKS):
        some = slice(begin, min(begin + BLOCK_TICKS, ticks))
        lead = min(begin, 1)  # the interval that ends with the block's first tick begins in the one before
        with_lead = slice(begin - lead, some.stop)
        ways = np.stack([flown[sysid].at(t_s[with_lead]) for sysid in sysids.tolist()], axis=1)
        at = ways[lead:]
        first = separation[with_lead].copy(), pair[with_lead].copy()
        fill_separations(ways, t_s[with_lead], partners, separation[with_lead], pair[with_lead])
        if lead:
            separation[begin - 1], pair[begin - 1] = first[0][0], first[1][0]
        _fill_clearances(tables, t_s[some], at, clearance[some])
        for other in aircraft:
            there = other.at(t_s[some])[:, np.newaxis]
            traffic[some] = np.fmin(traffic[some], _least(np.linalg.norm(at - there, axis=2)))
        for sysid in to_target:
            for target in np.unique(whom[sysid][some]).tolist():
                if target in rows:
                    distance = np.linalg.norm(at[:, rows[sysid]] - at[:, rows[target]], axis=1)
                    chosen = whom[sysid][some] == target
                    to_target[sysid][some][chosen] = distance[chosen]
    pairs = sysids[pair] if len(sysids) else pair
    return Nearness(
        Series(t_s, separation),
        pairs,
        Series(t_s, clearance),
        Series(t_s, traffic),
        {sysid: Series(t_s, values) for sysid, values in to_target.items()},
        held_by(recorded, flown)[1] if flown else {},
    )


def _fill_clearances(tables: Sequence[tuple[float, Floats]], t_s: Floats, at: Floats, least: Floats) -> None:
    """Write into least (k,) the least clearance at each of the times t_s (k,), of n vehicles at (k, n, 3); tables of
    obstacles, each from its time on. At the time of a change both count: the way to there was flown in the first."""
    for k, (since_s, shapes) in enumerate(tables):
        until_s = tables[k + 1][0] if k + 1 < len(tables) else math.inf
        first, end = np.searchsorted(t_s, since_s - ROUNDING_S), np.searchsorted(t_s, until_s + ROUNDING_S)
        if len(shapes) and first < end:
            there = at[first:end]
            near = geometry.clearance(shapes, np.nan_to_num(there.reshape(-1, 3))).reshape(there.shape[:2])
            found = _least(np.where(np.isnan(there[:, :, 0]), np.nan, near))
            least[first:end] = np.fmin(least[first:end], found)


def _least(distances: Floats) -> Floats:
    """(k,) the least of each row (k, n); NaN where nothing is known."""
    filled = np.where(np.isnan(distances), np.inf, distances).min(axis=1)
    return np.where(np.isfinite(filled), filled, np.nan)


def tracking_errors(recorded: Recorded, flown: Mapping[int, Track]) -> dict[int, Series]:
    """Each vehicle's distance in m from the path of its latest set points, at each report of its place that was the
    newest at a tick, by that report's own time: as the session measures it (gcs/telemetry/metrics.py)."""
    period_s = recorded.scenario.clock.period_s if recorded.scenario else 0.1
    points = recorded.set_points
    found = {}
    for sysid, rows in rows_of(points[:, SYSID].astype(np.int64)).items():
        if sysid in flown:
            own = points[rows]
            if (np.diff(own[:, T_S]) < 0.0).any():
                own = own[np.argsort(own[:, T_S], kind="stable")]
            t_s, plan, track = np.ascontiguousarray(own[:, T_S]), np.ascontiguousarray(own[:, P_NED]), flown[sysid]
            counts = track.flying(track.t_s) & np.append(np.diff(track.came_s) > 0.0, True)[: len(track.t_s)]
            reported_s, at = track.t_s[counts], np.ascontiguousarray(track.p_ned[counts])
            errors = np.full(len(reported_s), np.nan)
            fill_errors(t_s, plan, reported_s, at, period_s, PAUSE_PERIODS * period_s, PLAN_MEMORY, errors)
            found[sysid] = with_gaps(Series(reported_s, errors))
    return found


def _partners(recorded: Recorded, rows: Mapping[int, int]) -> Floats:
    """(k, 4) rows of tanker and receiver, and from when to when they were partners, or had time to part."""
    parting_s = goal.parting_s(recorded.scenario) if recorded.scenario else 0.0
    spans: list[tuple[int | None, int, float, float]] = []
    for decided, served in recorded.services:
        line = decided or served or {}
        since_s = line["t_s"] if decided else line["decided_at_s"]
        spans.append((line["tanker"], line["receiver"], since_s, served["t_s"] + parting_s if served else math.inf))
    # Of one whose decision was not kept, and that had not ended, the summary alone knows.
    under_way = {span[:2] for span in spans if span[3] == math.inf}
    for row in recorded.summary.refuelling if recorded.summary else ():
        if row.end_s is None and (row.tanker, row.receiver) not in under_way:
            spans.append((row.tanker, row.receiver, row.decided_at_s, math.inf))
    known = [(rows[t], rows[r], *times) for t, r, *times in spans if t is not None and {t, r} <= rows.keys()]
    return np.array(known, dtype=np.float64).reshape(-1, 4)
