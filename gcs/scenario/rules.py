"""By which rules a scenario flies: planner, formation, pursuit, competition, refuelling; shipped ones or one's own.

Frozen, strict, and NED (gcs/scenario/types.py).
"""

import re
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import AfterValidator, Field, WithJsonSchema, model_validator

from gcs.scenario.document import did_you_mean
from gcs.scenario.types import Coordinate, Flag, Fraction, Joules, Metres, NotNegative, Part, Positive, Seconds, Speed


def _one_of(*known: str) -> Any:
    """A shipped implementation's name, or MODULE:CLASS of somebody's own."""

    def check(value: str) -> str:
        if value not in known and not OWN.fullmatch(value):
            raise ValueError(f"must be {', '.join(known)} or MODULE:CLASS{did_you_mean(value, known)}")
        return value

    schema = {"anyOf": [{"enum": list(known)}, {"pattern": f"^{OWN.pattern}$"}]}
    return Annotated[str, AfterValidator(check), WithJsonSchema({"type": "string", **schema})]


OWN = re.compile(r"[A-Za-z_]\w*(\.[A-Za-z_]\w*)*:[A-Za-z_]\w*")
if TYPE_CHECKING:
    Method = str
    Policy = str
else:
    Method = _one_of("potential_field")
    Policy = _one_of("winner_take_all", "greedy_nearest", "most_empty_first", "optimal")


def _named(key: str, value: Any) -> Any:
    """`planner: MODULE:CLASS` is short for `planner: {method: MODULE:CLASS}`."""
    return {key: value} if isinstance(value, str) else value


class Planner(Part):
    """Potential field (model.md 6) [seed: k0, k1, a, b, ranges] and fuzzy escape (model.md 7); or one's own."""

    _short = model_validator(mode="before")(lambda value: _named("method", value))

    method: Method = "potential_field"
    """`potential_field`, or MODULE:CLASS of a planner for the pursuers (gcs/planner/custom.py)"""
    escape: Flag = True
    cruise_m_s: Speed = 1.5
    k0: Positive = 15.0
    k1: Positive = 2.0
    a: NotNegative = 0.5
    b: Annotated[float, Field(strict=True, gt=0, lt=1)] = 0.5
    attraction_range_m: Metres = 1.0
    repulsion_range_m: Metres = 1.0
    step_m: Metres = 0.1
    separation_m: Annotated[float, Field(strict=True, ge=0, le=1e5)] = 0.6
    """the least distance between any two vehicles that are not partners of a transfer"""
    vehicles_repel: Flag = True
    """false: each vehicle is planned as if it were alone, and may start where another does"""
    leash_m: Metres = 2.0
    """how far the planned point may run ahead of its vehicle"""


class Formation(Part):
    """A ring around the target, `height_m` above it; without `ring_m` the target itself attracts."""

    ring_m: Metres | None = None
    height_m: Coordinate = 0.0


class Pursuit(Part):
    """Who pursues: all, or for each target the winner of a competition by least predicted control effort."""

    by: Literal["all", "competition"] = "all"
    p: Annotated[float, Field(strict=True, ge=1, le=100)] = 2.0
    rate: Positive = 5.0
    share: Annotated[float, Field(strict=True, gt=0, lt=1)] = 0.9
    """of all states to the power p, less the floor's own, that a challenger must hold to take over"""
    hysteresis: NotNegative = 0.1
    """how much of its predicted effort the present pursuer is forgiven"""


class Competition(Part):
    """Winner-take-all (model.md 8): exponent p, rate c, values in [floor, high]; who competes, when it is decided."""

    _short = model_validator(mode="before")(lambda value: _named("policy", value))

    enabled: Flag = True
    policy: Policy = "winner_take_all"
    """the competition, one to compare it with, or MODULE:CLASS; others use need_from alone"""
    p: Annotated[float, Field(strict=True, ge=1, le=100)] = 2.0
    rate: Positive = 5.0
    floor: Positive = 0.01
    high: Positive = 1.0
    need_from: Fraction = 0.5
    share: Annotated[float, Field(strict=True, gt=0, lt=1)] = 0.9
    dwell_s: Seconds = 2.0
    decide_within_s: Seconds = 30.0


class Refuelling(Part):
    """Where the tanker stands (`height_m` above the receiver), when a transfer may run, and how much flows."""

    enabled: Flag = True
    height_m: Metres = 1.2
    capture_m: Metres = 1.5
    relative_speed_m_s: Speed = 0.5
    hold_s: Seconds = 1.0
    rate_w: Positive = 2000.0
    until: Annotated[float, Field(strict=True, gt=0, le=1)] = 0.9
    """of the receiver's capacity"""
    reserve_s: Seconds = 20.0
    """served first: who cannot last until the rendezvous and this long after it"""
    limit_j: Joules | None = None
