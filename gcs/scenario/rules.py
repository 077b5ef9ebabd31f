"""By which rules a scenario flies: planner, formation, pursuit, competition, refuelling; shipped ones or one's own.

Frozen, strict, and NED (gcs/scenario/types.py).
"""

import re
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import AfterValidator, WithJsonSchema, model_validator

from gcs.scenario import types
from gcs.scenario.document import did_you_mean
from gcs.scenario.parts.reach import Asks, is_foreign_code


def _one_of(*known: str) -> Any:
    """A shipped implementation's name, or MODULE:CLASS of a user's own."""

    def check(value: str) -> str:
        if value not in known and not OWN.fullmatch(value):
            raise ValueError(f"must be {', '.join(known)} or MODULE:CLASS{did_you_mean(value, known)}")
        return value

    schema = {"anyOf": [{"enum": list(known)}, {"pattern": f"^{OWN.pattern}$"}]}
    return Annotated[
        str, Asks("code", is_foreign_code), AfterValidator(check), WithJsonSchema({"type": "string", **schema})
    ]


SURFACE_FLOOR_M = 0.01
"""[choice] Nearer than this to a surface, and inside a volume, the repulsion keeps its size, so that it stays finite;
it is then 10⁵ times the strongest attraction and points out by the shortest way."""
OWN = re.compile(r"[A-Za-z_]\w*(\.[A-Za-z_]\w*)*:[A-Za-z_]\w*")
if TYPE_CHECKING:
    Method = str
    Policy = str
else:
    Method = _one_of("potential_field")
    Policy = _one_of(
        "winner_take_all",
        "optimal",
        "earliest_deadline",
        "hungarian",
        "auction",
        "greedy_nearest",
        "most_empty_first",
    )


def _named(key: str, value: Any) -> Any:
    """`planner: MODULE:CLASS` is short for `planner: {method: MODULE:CLASS}`."""
    return {key: value} if isinstance(value, str) else value


class PlannerRules(types.Part):
    """Potential field (docs/model/planner.md#potential-field) [seed: k0, k1, a, b, ranges] and fuzzy escape
    (docs/model/planner.md#fuzzy-escape); or one's own."""

    _short = model_validator(mode="before")(lambda value: _named("method", value))

    method: Method = "potential_field"
    """`potential_field`, or MODULE:CLASS of a planner for the pursuers (gcs/planner/custom.py)"""
    escape: types.Flag = True
    """fuzzy escape from local minima of the field"""
    cruise_m_s: types.Speed = 1.5
    """greatest speed of pursuers' planned points, m/s"""
    k0: types.Positive = 15.0
    """gain of the attraction, without unit"""
    k1: types.Positive = 2.0
    """gain of the repulsion, without unit"""
    a: types.NotNegative = 0.5
    """gain of the repulsion's inner term, without unit; 0 switches it off"""
    b: Annotated[float, types.Exact(gt=0, lt=1)] = 0.5
    """share of the repulsion range within which the inner term acts, above 0 and below 1"""
    attraction_range_m: types.Metres = 1.0
    """range of `attractors` and of traffic that attracts, m; a pursuer's own goal attracts at any distance"""
    repulsion_range_m: types.Metres = 1.0
    """how far from its surface an obstacle, vehicle or aircraft repels, m"""
    step_m: Annotated[float, types.Exact(ge=1e-3, le=1e5)] = 0.1
    """longest step of the planned point, and the distance at which a way point is reached, m"""
    full_steps: types.Flag = False
    """no step of the planned point shrinks near a goal but the last one, onto it: the paper's eq. 4 to the letter; it
    passes way points at full speed. Needs `safety: false`"""
    separation_m: Annotated[float, types.Exact(ge=0, le=1e5)] = 0.6
    """the least distance between any two vehicles that are not partners of a transfer"""
    vehicles_repel: types.Flag = True
    """false: each vehicle is planned as if it were alone, and may start where another does"""
    leash_m: types.Metres = 2.0
    """how far the planned point may run ahead of its vehicle"""
    safety: types.Flag = True
    """the safety filter behind the planner, which keeps everyone apart; false: planned points as they are"""
    guide: types.Flag = True
    """routes around obstacles that lie in the straight line, under the safety filter"""
    acceleration_m_s2: Annotated[float, types.Exact(ge=0.01, le=1e5)] = 4.0
    """greatest acceleration of planned points under the safety filter, m/s²; launched vehicles can do 5"""
    clearance_m: Annotated[float, types.Exact(ge=0, le=1e5)] = 0.2
    """distance that the safety filter keeps to obstacles' surfaces beside each vehicle's margin, m"""
    confidence: Annotated[float, types.Exact(ge=0.5, le=0.999999)] = 0.999
    """share of sessions in which errors of places that `sensors` allows bring no vehicle nearer than wanted: by it the
    safety filter keeps more than `separation_m` and `clearance_m`"""


class FormationRules(types.Part):
    """A ring around the target, `height_m` above it; without `ring_m` the target itself attracts."""

    ring_m: types.Metres | None = None
    """radius of the ring around the target, m; without it the pursuers' goal is the target itself"""
    height_m: types.Coordinate = 0.0
    """height of the ring above the target, m; negative: below"""


class PursuitRules(types.Part):
    """Choice of pursuers: all, or for each target the winner of a competition by least control effort."""

    by: Literal["all", "competition"] = "all"
    """`all`: every pursuer follows its target; `competition`: per target the one with the least control effort"""
    bids: Literal["predicted", "measured"] = "predicted"
    """`predicted`: the effort that it would take to meet the target, and the least pursues from the first tick on;
    `measured`: the effort that each has reported so far, the paper's, and no vehicle pursues before one has won"""
    p: Annotated[float, types.Exact(ge=1, le=100)] = 2.0
    """exponent of the competition, at least 1"""
    rate: types.Positive = 5.0
    """rate c of the competition, 1/s"""
    share: Annotated[float, types.Exact(gt=0, lt=1)] = 0.9
    """of all states to the power p, less the floor's own, that a challenger must hold to take over"""
    hysteresis: types.NotNegative = 0.1
    """how much of its effort the present pursuer is forgiven"""


class CompetitionRules(types.Part):
    """Winner-take-all (docs/model/competition.md#competition): exponent p, rate c, values in [floor, high]; which
    vehicles compete, when it is decided."""

    _short = model_validator(mode="before")(lambda value: _named("policy", value))

    enabled: types.Flag = True
    """false: no vehicle is refuelled unless an operator asks"""
    where: Literal["supervisor", "vehicles"] = "supervisor"
    """`supervisor`: it decides and commands; `vehicles`: they compete on board, call the tankers and command the
    transfers over the radio among themselves, and the supervisor watches"""
    policy: Policy = "winner_take_all"
    """the competition, one to compare it with, or MODULE:CLASS; others use need_from alone"""
    p: Annotated[float, types.Exact(ge=1, le=100)] = 2.0
    """exponent of the law, at least 1"""
    bids: Literal["losses", "time", "need", "effort"] = "losses"
    """`losses`: as many winners at once as tankers are free, by what is likely to be lost if another is served first;
    `time`: the same by the time that each has left; `need`: one winner after another by the share of the battery that
    is gone, stretched between the least and the greatest as in the paper; `effort`: the same by the control effort
    since energy last arrived, the paper's control energy"""
    horizon_s: types.Positive = 60.0
    """scale of the bids, s: with bids by time a vehicle with so long left beyond the time until it can be served bids
    `floor`"""
    tie_s: types.Seconds = 2.0
    """with bids by losses or time: vehicles tie whose bids differ by less, on the scale of `horizon_s`, s"""
    rate: types.Positive = 20.0
    """rate c of the law, 1/s; larger decides faster"""
    floor: types.Positive = 0.01
    """least bid, without unit, below `high`; and how far a state may fall behind the one before it"""
    high: types.Positive = 1.0
    """greatest bid, without unit"""
    need_from: types.Fraction = 0.5
    """share of the battery that must be gone before a vehicle competes, 0 to 1"""
    share: Annotated[float, types.Exact(gt=0, lt=1)] = 0.9
    """share of v^p that the last winner must hold against the next one, 0 to 1; with bids by need or effort, of the
    sum less the floor's own"""
    dwell_s: types.Seconds = 0.5
    """how long it must hold that share, s"""
    decide_within_s: types.Seconds = 30.0
    """after so long without a winner the greatest state is served, s"""


class RefuellingRules(types.Part):
    """Place of the tanker (`height_m` above the receiver), when a transfer may run, and how much flows."""

    enabled: types.Flag = True
    """false: no service at all"""
    height_m: types.Metres = 1.2
    """how far above its receiver the tanker flies, m; below `capture_m`"""
    capture_m: Annotated[float, types.Exact(ge=0.1, le=100)] = 1.5
    """greatest distance of tanker and receiver for a transfer, m"""
    relative_speed_m_s: Annotated[float, types.Exact(ge=0.05, le=10)] = 0.5
    """greatest relative speed for a transfer, m/s"""
    hold_s: types.Seconds = 1.0
    """how long both must hold before a transfer starts, s"""
    rate_w: types.Positive = 2000.0
    """power of a transfer in flight, W"""
    until: Annotated[float, types.Exact(gt=0, le=1)] = 0.9
    """of the receiver's capacity"""
    reserve_s: types.Seconds = 20.0
    """a vehicle that cannot last until the rendezvous and this long after it takes part before `need_from`; served
    first with bids by need or effort and with policies that do not look at the time left"""
    lands_at: types.Fraction = 0.05
    """share of its battery at which a vehicle lands by itself, 0 to 1"""
    tops_up: types.Flag = True
    """a tanker is ordered to give what its receiver draws meanwhile, too, so that `until` can be reached"""
    limit_j: types.Joules | None = None
    """most energy of one service, J; by default only `until` limits it"""
