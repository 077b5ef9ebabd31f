"""The parts of a session's goal: what each wants of a scenario, and how it is judged over what was measured.

Everything that judges whether a goal is met uses these: the session while it flies and at its end, JUnit, replay,
report. A part that the scenario does not ask for is not there.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from gcs.scenario.model import Scenario
from gcs.scenario.parts.mission import items_of
from gcs.scenario.plugins import named

MET, INTERRUPTED = "met", "interrupted"
NAMED = 4
"""Of many vehicles so many are named."""
ROUNDING_S = 1e-6
PARTING_S = 3.0


@dataclass(frozen=True)
class Nearest:
    """Nearest approach: distance, vehicles and time."""

    m: float = math.inf
    """inf: nothing was there to come near"""
    sysids: tuple[int, ...] = ()
    t_s: float = 0.0
    what: str = ""
    """the obstacle or the aircraft; empty between vehicles"""

    def text(self, limit_m: float) -> str:
        """`0.02 m (3 and 5 at 12.4 s)`, held against a limit."""
        if not math.isfinite(self.m):
            return "nothing to come near"
        return f"{metres(self.m, limit_m)} ({self.who})"

    @property
    def who(self) -> str:
        """`3 and 5 at 12.4 s`."""
        names = [*map(str, self.sysids), *([self.what] if self.what else [])]
        return f"{' and '.join(names)} at {self.t_s:.1f} s"


@dataclass(frozen=True)
class Loss:
    """A vehicle that was lost, when and why; 255 is the traffic."""

    sysid: int
    t_s: float
    why: str


@dataclass(frozen=True)
class Measured:
    """Measures of a session, or of a recording of one, so far. None: not known."""

    time_s: float | None = None
    separation: Nearest | None = None
    clearance: Nearest | None = None
    traffic: Nearest | None = None
    ground: Nearest | None = None
    """the vehicle that touched the ground, its height as the distance"""
    lost: Sequence[Loss] | None = None
    missed: Mapping[int, int] | None = None
    """how many of its way points each pursuer that has some has not passed"""
    pursuit_held_s: float | None = None
    refuelled: int | None = None
    late: Sequence[tuple[float, str]] | None = None
    """when a planner or policy of the user's did not answer in time or its process ended, and how"""


@dataclass(frozen=True)
class Judgement:
    """Result of one part of the goal."""

    part: str
    wanted: str
    reached: str
    met: bool | None
    """None: not known"""
    limit: float
    unit: str
    value: float | None = None
    sysids: tuple[int, ...] = ()
    what: str = ""
    t_s: float | None = None

    @property
    def text(self) -> str:
        """`separation 0.02 m (3 and 5 at 12.4 s)`."""
        return f"{self.part} {self.reached}"


def is_refuelling(end_s: float | None, energy_j: float) -> bool:
    """Whether a service counts as a refuelling: it has ended, and energy came to its receiver. One that is under way
    when the session ends does not."""
    return end_s is not None and energy_j > 0


class GoalPart(NamedTuple):
    """One part: `limit` is what a scenario demands of it, None where it demands nothing; `wanted` a sentence of it, and
    `wanted_0` of a limit of 0; `judge` is called with what of the measures it is judged by, where that is known, the
    limit and the scenario."""

    name: str
    unit: str
    limit: Callable[[Scenario], float | None]
    wanted: str
    of: Callable[[Measured], Any]
    judge: Callable[[Any, float, Scenario], _Found]
    wanted_0: str = ""


class _Found(NamedTuple):
    met: bool | None
    reached: str
    value: float | None = None
    sysids: tuple[int, ...] = ()
    what: str = ""
    t_s: float | None = None


_UNKNOWN = _Found(None, "not known")


def separation_m(scenario: Scenario) -> float | None:
    """The least distance of two vehicles that the goal demands, m."""
    if len(scenario.vehicles.all) < 2:
        return None
    rules, asked = scenario.planner, scenario.goal.separation_m
    return _asked(asked, rules.separation_m if rules.vehicles_repel else 0.0)


def traffic_m(scenario: Scenario) -> float | None:
    """The least distance to traffic that the goal demands, m; None also where there is none to keep away from."""
    kept_off = any(not mover.attracts for mover in scenario.traffic)
    return _asked(scenario.goal.traffic_m, scenario.planner.separation_m) if kept_off else None


def clearance_m(scenario: Scenario) -> float | None:
    """The least distance to an obstacle's surface that the goal demands, m."""
    asked = scenario.goal.clearance_m
    if not scenario.obstacles or asked is False:
        return None
    return 0.1 if asked is None else float(asked)


def _asked(asked: float | None, default: float) -> float | None:
    value = default if asked is None else float(asked)
    return value if value > 0.0 else None


def _has_ground(scenario: Scenario) -> float | None:
    grounded = any(not vehicle.airborne for vehicle in scenario.vehicles.all)
    return 0.0 if scenario.goal.ground and grounded else None


def _waypoints(scenario: Scenario) -> float | None:
    some = any(pursuer.own_way for pursuer in scenario.vehicles.pursuers)
    return 0.0 if scenario.goal.waypoints == "all" and some else None


def _refuelled(scenario: Scenario) -> float | None:
    return float(scenario.goal.refuelled_at_least) or None


def _lost(scenario: Scenario) -> float:
    return float(scenario.goal.lost_at_most)


def _plugins(scenario: Scenario) -> float | None:
    return 0.0 if any(named(scenario)) else None


def _pursue_s(scenario: Scenario) -> float | None:
    return scenario.goal.pursue.for_s if scenario.goal.pursue is not None else None


# judging


def _judge_near(nearest: Nearest, limit: float, _: Scenario) -> _Found:
    if not math.isfinite(nearest.m):
        return _Found(True, nearest.text(limit))
    about = nearest.m, nearest.sysids, nearest.what, nearest.t_s
    return _Found(nearest.m >= limit, nearest.text(limit), *about)


def _judge_ground(touched: Nearest, _: float, __: Scenario) -> _Found:
    if not math.isfinite(touched.m):
        return _Found(True, "not touched")
    return _Found(False, f"touched ({touched.who})", touched.m, touched.sysids, "", touched.t_s)


def _judge_lost(lost: Sequence[Loss], limit: float, _: Scenario) -> _Found:
    if not lost:
        return _Found(True, "none", 0.0)
    listed = [f"{_name(loss.sysid)} at {loss.t_s:.1f} s: {loss.why}" for loss in lost[:NAMED]]
    more = f"; {len(lost) - NAMED} more" if len(lost) > NAMED else ""
    who = tuple(loss.sysid for loss in lost)
    text = f"{len(lost)} ({'; '.join(listed)}{more})"
    return _Found(len(lost) <= limit, text, float(len(lost)), who, "", lost[0].t_s)


def _judge_duration(time_s: float, limit_s: float, _: Scenario) -> _Found:
    done = time_s >= limit_s - ROUNDING_S
    return _Found(done, f"{time_s:.1f} s" + ("" if done else f" of {limit_s:g} s"), time_s)


def _judge_waypoints(missed_of: Mapping[int, int], _: float, scenario: Scenario) -> _Found:
    count = {pursuer.sysid: len(pursuer.waypoints_m or items_of(pursuer)) for pursuer in scenario.vehicles.pursuers}
    missed = {sysid: number for sysid, number in missed_of.items() if number}
    if not missed:
        return _Found(True, "all passed", 0.0)
    listed = [f"{sysid}: {number} of {count.get(sysid, number)}" for sysid, number in sorted(missed.items())]
    more = f" and {len(listed) - NAMED} more" if len(listed) > NAMED else ""
    text = f"missed (by {', '.join(listed[:NAMED])}{more})"
    return _Found(False, text, float(sum(missed.values())), tuple(sorted(missed)))


def _judge_pursue(held_s: float, limit_s: float, _: Scenario) -> _Found:
    return _Found(held_s >= limit_s - ROUNDING_S, progress_text(held_s, limit_s, " s", digits=1), held_s)


def _judge_refuelled(done: int, limit: float, _: Scenario) -> _Found:
    return _Found(done >= limit, progress_text(done, limit, ""), float(done))


def _judge_plugins(late: Sequence[tuple[float, str]], _: float, __: Scenario) -> _Found:
    if not late:
        return _Found(True, "answered", 0.0)
    listed = [f"{what} at {t_s:.1f} s" for t_s, what in late[:NAMED]]
    more = f"; {len(late) - NAMED} more" if len(late) > NAMED else ""
    return _Found(False, f"failed ({'; '.join(listed)}{more})", float(len(late)), t_s=late[0][0])


_SEPARATION = "separation at least {limit:g} m, except during a transfer"
_PURSUE = "every pursuer within {within_m:g} m of its target for {limit:g} s"
_WAYPOINTS = "every pursuer passes all its way points"
_PLUGINS = "planner and policy of the user's own answer in time, to the end"
PARTS: tuple[GoalPart, ...] = (
    GoalPart("lost", "1", _lost, "at most {limit:g} vehicles lost", lambda m: m.lost, _judge_lost, "no vehicle lost"),
    GoalPart(
        "duration", "s", lambda s: s.goal.duration_s, "{limit:g} s are flown", lambda m: m.time_s, _judge_duration
    ),
    GoalPart("separation", "m", separation_m, _SEPARATION, lambda m: m.separation, _judge_near),
    GoalPart("clearance", "m", clearance_m, "no obstacle nearer than {limit:g} m", lambda m: m.clearance, _judge_near),
    GoalPart("traffic", "m", traffic_m, "no traffic nearer than {limit:g} m", lambda m: m.traffic, _judge_near),
    GoalPart("ground", "m", _has_ground, "no ground contact in flight", lambda m: m.ground, _judge_ground),
    GoalPart("waypoints", "1", _waypoints, _WAYPOINTS, lambda m: m.missed, _judge_waypoints),
    GoalPart("pursue", "s", _pursue_s, _PURSUE, lambda m: m.pursuit_held_s, _judge_pursue),
    GoalPart("refuelled", "1", _refuelled, "at least {limit:g} refuelled", lambda m: m.refuelled, _judge_refuelled),
    GoalPart("plugins", "1", _plugins, _PLUGINS, lambda m: m.late, _judge_plugins),
)
"""In the order in which an outcome names them."""
BY_NAME = {part.name: part for part in PARTS}


def asked(scenario: Scenario) -> dict[str, float]:
    """The parts that a scenario asks for, and the limit of each."""
    limits = ((part.name, part.limit(scenario)) for part in PARTS)
    return {name: limit for name, limit in limits if limit is not None}


def parting_s(scenario: Scenario) -> float:
    """Time that a tanker and its receiver have to part after a refuelling, where they are nearer in it than the goal
    wants two vehicles to be."""
    return PARTING_S if scenario.refuelling.height_m < asked(scenario).get("separation", 0.0) else 0.0


def judge(scenario: Scenario, measured: Measured) -> list[Judgement]:
    """Result of each part that the scenario asks for."""
    found = []
    within_m = scenario.goal.pursue.within_m if scenario.goal.pursue is not None else 0.0
    for name, limit in asked(scenario).items():
        part = BY_NAME[name]
        about = part.of(measured)
        met, reached, value, sysids, what, t_s = _UNKNOWN if about is None else part.judge(about, limit, scenario)
        wanted = (part.wanted if limit else part.wanted_0 or part.wanted).format(limit=limit, within_m=within_m)
        found.append(Judgement(name, wanted, reached, met, limit, part.unit, value, sysids, what, t_s))
    return found


def verdict(judged: Sequence[Judgement]) -> tuple[str, str]:
    """(`met` or the first unmet part's name, the same as a sentence that names every unmet part)."""
    unmet = [one for one in judged if one.met is False]
    return (unmet[0].part if unmet else MET), outcome_text([one.text for one in unmet])


def outcome_text(unmet: Sequence[str]) -> str:
    """`met`, or `not met: ` and what of each part."""
    return f"not met: {'; '.join(unmet)}" if unmet else MET


def progress_text(have: float, need: float, unit: str, *, digits: int = 0) -> str:
    """Progress of a part that is gathered: `12 of 20 s`, and once there is enough `119 s (20 s wanted)`."""
    if have >= need - ROUNDING_S:
        return f"{have:.{digits}f}{unit} ({need:g}{unit} wanted)"
    return f"{math.floor(have * 10**digits) / 10**digits:.{digits}f} of {need:g}{unit}"


def metres(value: float, limit: float = -math.inf) -> str:
    """A distance for a person; what is below a limit does not read as if it were not."""
    for digits in (2, 3):
        text = f"{value:.{digits}f}"
        if (float(text) < limit) == (value < limit):
            return f"{text} m"
    return f"{value:.6f} m"


def _name(sysid: int) -> str:
    return "traffic" if sysid == 255 else str(sysid)
