"""Assignment of one pursuer to each target, by the least control effort (paper, abstract).

Each target has a race of its own (docs/model/competition.md#target-assignment): every pursuer bids a control effort,
the least wins. That is the effort that it is predicted to need to reach the target, or the one that it has reported so
far. The winner pursues, the others hold. All is decided anew at each tick: a challenger takes over when its state holds
the share that the rules demand, while the present pursuer is forgiven some of its effort, so that near ties do not swap
back and forth [choice]. By prediction the least of a first tick pursues at once; measured efforts are alike then, so
none does before one has won. Targets choose in order of system id; a pursuer of one target races for no other.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from typing import Any

import numpy as np

from gcs.mavlink.autopilots import STEERABLE
from gcs.scenario.model import PursuitRules
from gcs.telemetry.state import GRAVITY_M_S2, FleetSnapshot, Vec3, VehicleView
from skytender import elementary
from skytender.winner_take_all import advance, normalise, revive, share

LOW, HIGH = 0.01, 1.0


def predicted_effort(p_ned: Vec3, v_ned: Vec3, target_p_ned: Vec3, target_v_ned: Vec3, speed_m_s: float) -> float:
    """Control effort to meet a target that flies on straight: g t + |Δv|, m/s
    (docs/model/competition.md#target-assignment) [choice].

    t is the time to the meeting at `speed_m_s`: thrust carries the weight for that long, and Δv turns the present
    velocity into the one that meets the target. A target that cannot be met costs as if it flew away for good: the time
    at which the distance would be flown at a tenth of the speed.
    """
    offset = way(p_ned, target_p_ned)
    distance_m = elementary.norm(offset)
    time_s = meeting_s(offset, target_v_ned, speed_m_s)
    if time_s is None:
        time_s = 10.0 * distance_m / speed_m_s
    wanted = list(target_v_ned)
    if distance_m != 0.0 and time_s != 0.0:
        wanted = [o / time_s + v for o, v in zip(offset, target_v_ned, strict=True)]
        share = min(1.0, speed_m_s / max(elementary.norm(wanted), 1e-12))
        wanted = [share * v for v in wanted]
    return GRAVITY_M_S2 * time_s + elementary.distance(wanted, v_ned)


def meeting_s(offset_ned: Vec3, v_ned: Vec3, speed_m_s: float) -> float | None:
    """The least t >= 0 with |offset + v t| = speed t; None where there is none."""
    a = _dot(v_ned, v_ned) - speed_m_s * speed_m_s
    b, c = 2.0 * _dot(offset_ned, v_ned), _dot(offset_ned, offset_ned)
    if c == 0.0:
        return 0.0
    if abs(a) < 1e-12:
        return -c / b if b < 0.0 else None
    root = b * b - 4.0 * a * c
    if root < 0.0:
        return None
    times = [(-b + sign * math.sqrt(root)) / (2.0 * a) for sign in (-1.0, 1.0)]
    return min((t for t in times if t >= 0.0), default=None)


def way(p_ned: Vec3, to_ned: Vec3) -> Vec3:
    """From one place to another, m."""
    return (to_ned[0] - p_ned[0], to_ned[1] - p_ned[1], to_ned[2] - p_ned[2])


def _dot(a: Vec3, b: Vec3) -> float:
    """By hand: the last bit of BLAS is another on another processor."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


class TargetAssignment:
    """The races' memory from tick to tick."""

    def __init__(
        self, rules: PursuitRules, pursuers: Collection[int], targets: Collection[int], speed_m_s: float
    ) -> None:
        self._rules = rules
        self._pursuers = frozenset(pursuers)
        self._targets = sorted(targets)
        self._speed_m_s = speed_m_s
        self._v: dict[int, dict[int, float]] = {target: {} for target in self._targets}
        self._pursuer: dict[int, int] = {}
        self._last_s: float | None = None
        self.records: list[dict[str, Any]] = []
        """decisions of the last tick: a target has a new pursuer"""

    def decide(self, snapshot: FleetSnapshot) -> dict[int, int]:
        """Target of each pursuer that is to pursue, by system id, at the snapshot's time."""
        dt_s = 0.0 if self._last_s is None else snapshot.time_s - self._last_s
        self._last_s = snapshot.time_s
        self.records = []
        mine = (view for view in snapshot.vehicles if view.sysid in self._pursuers)
        able = {view.sysid: view for view in mine if view.flying and view.mode in STEERABLE}
        for target in self._targets:
            if self._pursuer.get(target) not in able:
                self._pursuer.pop(target, None)
        for target in self._targets:
            view = snapshot.vehicle(target)
            if not view.flying:
                self._pursuer.pop(target, None)
                continue
            busy = {pursuer for other, pursuer in self._pursuer.items() if other != target}
            racing = [able[sysid] for sysid in sorted(able.keys() - busy)]
            if racing:
                self._race(view, racing, dt_s)
        return {pursuer: target for target, pursuer in self._pursuer.items()}

    def _effort(self, view: VehicleView, target: VehicleView) -> float:
        if self._rules.bids == "measured":
            return view.effort_now
        places = (view.p_now_ned(), view.v_ned, target.p_now_ned(), target.v_ned)
        return predicted_effort(*places, self._speed_m_s)

    def _race(self, target: VehicleView, racing: Sequence[VehicleView], dt_s: float) -> None:
        rules, present = self._rules, self._pursuer.get(target.sysid)
        efforts = {view.sysid: self._effort(view, target) for view in racing}
        bids = [effort / (1.0 + rules.hysteresis) if sysid == present else effort for sysid, effort in efforts.items()]
        tau = normalise(bids, low=LOW, high=HIGH, largest_wins=False)
        v = np.array([self._v[target.sysid].get(sysid, LOW) for sysid in efforts])
        v = revive(advance(v, tau, dt_s, p=rules.p, rate=rules.rate), LOW)
        sysids = list(efforts)
        self._v[target.sysid] = dict(zip(sysids, map(float, v), strict=True))
        chosen: int | None
        if present is None and rules.bids == "predicted":
            chosen = sysids[int(tau.argmax())]
        else:
            leads = share(v, rules.p, LOW) >= rules.share
            chosen = sysids[int(v.argmax())] if leads else present
        if chosen is not None and chosen != present:
            self._pursuer[target.sysid] = chosen
            by_sysid = {str(sysid): effort for sysid, effort in efforts.items()}
            self.records.append(
                {"kind": "pursuit", "target": target.sysid, "pursuer": chosen, "before": present, "efforts": by_sysid}
            )
