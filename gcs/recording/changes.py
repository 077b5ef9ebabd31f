"""Which decisions a recording holds where it holds changes only: `record: {decisions: changes}`.

A set point that the one before it foretells, at its velocity, is left out; all other decisions are changes. The digest
counts every decision.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

NEAR_M = 0.05
NEAR_M_S = 0.05
LONGEST_S = 1.0
"""A set point is written so often at least."""
_ROUNDING_S = 1e-6


class ChangeFilter:
    """Of one session, in its order."""

    def __init__(self) -> None:
        self._last: dict[int, Mapping[str, Any]] = {}

    def is_change(self, decision: Mapping[str, Any]) -> bool:
        """Whether a decision is to be written."""
        if decision["kind"] != "set_point":
            return True
        sysid, last = decision["sysid"], self._last.get(decision["sysid"])
        if last is not None:
            elapsed_s = decision["t_s"] - last["t_s"]
            foretold = [p + v * elapsed_s for p, v in zip(last["p_ned"], last["v_ned"], strict=True)]
            same = math.dist(foretold, decision["p_ned"]) <= NEAR_M
            same = same and math.dist(last["v_ned"], decision["v_ned"]) <= NEAR_M_S
            if same and elapsed_s < LONGEST_S - _ROUNDING_S:
                return False
        self._last[sysid] = decision
        return True
