"""How well vehicles know their places: what they report of it, and what their places show.

`separation_m`, and `sensors:` where they are given, are chosen for the accuracy that a vehicle has before it takes off.
In flight its place may become less certain: its accuracies grow (GPS_RAW_INT, ESTIMATOR_STATUS), its GPS has no fix any
more, or its place jumps. Each adds to the distance that the safety filter keeps (docs/model/safety.md#safety-layer).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.telemetry.state import FleetSnapshot
from skytender import elementary
from skytender import mavlink as mav

Floats = NDArray[np.float64]

GROWN = 1.2
"""[choice] An accuracy counts as worse from so many times its usual value on."""
LOST_M, DRIFT_M_S, MOST_DRIFT_M = 1.0, 0.3, 4.0
"""[choice] Without a fix a place is off by so much at once, and by so much more each second, up to the last."""
JUMP_M = 0.5
"""[choice] A place that is so far from where its velocity leads has jumped."""
CLOCK_S = 0.5
"""[choice] A vehicle on a clock of its own may have been at its place by so much earlier or later than it seems."""
LONG_S = 1e6
"""Of reports that have never come."""
MOST_JUMP_M = 10.0
"""[choice] No jump widens a distance by more."""


class ReportedAccuracy:
    """Accuracies that one vehicle reports. The last ones before it is armed are its usual ones."""

    def __init__(self) -> None:
        self.armed = False
        self.fix_lost_s = math.inf
        """session time at which its GPS lost its fix; infinity while it has one, or never had"""
        self.worse_m = 0.0
        """standard deviation that has come on top of the usual one, to a tenth of a metre"""
        self._had_fix = False
        self._usual_m: dict[str, float] = {}
        self._worse_m: dict[str, float] = {}

    def satellites(self, content: Any, time_s: float) -> None:
        """Take a GPS_RAW_INT."""
        fix = content.fix_type >= mav.GPS_FIX_TYPE_3D_FIX
        self._had_fix = fix or (self._had_fix and self.armed)
        if fix or not self._had_fix:
            self.fix_lost_s = math.inf
        else:
            self.fix_lost_s = min(self.fix_lost_s, time_s)
        if fix:
            self._take("gps", 1e-3 * max(content.h_acc, content.v_acc))

    def estimator(self, content: Any) -> None:
        """Take an ESTIMATOR_STATUS."""
        self._take("estimator", max(content.pos_horiz_accuracy, content.pos_vert_accuracy))

    def _take(self, source: str, deviation_m: float) -> None:
        if not 0.0 < deviation_m < math.inf:  # unknown
            return
        usual_m = self._usual_m.setdefault(source, deviation_m)
        if not self.armed:
            usual_m = self._usual_m[source] = deviation_m
        grown = deviation_m > GROWN * usual_m
        self._worse_m[source] = math.sqrt(deviation_m * deviation_m - usual_m * usual_m) if grown else 0.0
        self.worse_m = round(max(self._worse_m.values()), 1)


class Spreads:
    """How far vehicles may be from where they say they are, in every tick."""

    def __init__(
        self, usual_m: Sequence[float], factor: float, a_max_m_s2: Floats, external: NDArray[np.bool_]
    ) -> None:
        """Of n vehicles in order of system id: `usual_m` (n,), spreads by their `sensors:`; `factor` turns a standard
        deviation into a spread; `a_max_m_s2` (n,), how fast velocities change; `external` (n,), on clocks of their own.
        """
        n = len(usual_m)
        self._usual_m, self._factor, self._a_max_m_s2 = np.array(usual_m, np.float64), factor, a_max_m_s2
        self._clock_s = np.where(external, CLOCK_S, 0.0)
        self._reported_m, self._fix_lost_s = self._usual_m.copy(), np.full(n, math.inf)
        self._number = -1
        self._time_s, self._late_s = 0.0, -math.inf
        self._p_ned, self._v_ned, self._age_s = np.full((n, 3), np.nan), np.zeros((n, 3)), np.zeros(n)
        self._jump_ned = np.zeros((n, 3))

    def of(self, snapshot: FleetSnapshot, *, late: bool = False) -> Floats:
        """(n,), m, now. A report that is read in a tick that comes `late` is not dated well enough: neither from the
        report before it nor to the one after it does a place jump."""
        columns, age_s = snapshot.columns, np.minimum(snapshot.columns.age_s, LONG_S)
        for sysid in columns.changed_since(self._number):
            row, view = columns.row[sysid], snapshot.vehicle(sysid)
            self._reported_m[row] = elementary.hypot(float(self._usual_m[row]), self._factor * view.worse_m)
            self._fix_lost_s[row] = view.fix_lost_s if view.flying else math.inf
        self._number = columns.number
        self._follow_jumps(snapshot.time_s, columns.p_ned, columns.v_ned, age_s, columns.flying, late)
        off = self._jump_ned
        jumped_m = np.minimum(np.sqrt((off * off).sum(axis=1)), MOST_JUMP_M)
        lost_s = snapshot.time_s - self._fix_lost_s
        drifted_m = np.where(lost_s >= 0.0, np.minimum(LOST_M + DRIFT_M_S * lost_s, MOST_DRIFT_M), 0.0)
        return self._reported_m + jumped_m + drifted_m

    def _follow_jumps(
        self, time_s: float, p_ned: Floats, v_ned: Floats, age_s: Floats, flying: NDArray[np.bool_], late: bool
    ) -> None:
        """Add up the jumps of each flight: one that jumps back is where it was. Which of two places is true is not
        known."""
        after_s = self._age_s + (time_s - self._time_s) - age_s  # from one report to the next
        mean_ned = 0.5 * (v_ned + self._v_ned)
        moved_ned = p_ned - self._p_ned - mean_ned * after_s[:, np.newaxis]
        allowed_m = JUMP_M + 0.25 * self._a_max_m_s2 * after_s * after_s
        allowed_m += self._clock_s * np.sqrt((mean_ned * mean_ned).sum(axis=1))
        if late:
            self._late_s = time_s
        else:
            jumped = (moved_ned * moved_ned).sum(axis=1) > allowed_m * allowed_m  # never by NaN
            jumped &= self._time_s - self._age_s > self._late_s
            self._jump_ned[jumped] += moved_ned[jumped]
        self._jump_ned[~flying] = 0.0
        self._time_s, self._p_ned, self._v_ned, self._age_s = time_s, p_ned, v_ned, age_s
