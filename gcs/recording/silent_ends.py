"""Ends of launched vehicles of which nothing came any more: when their failsafes begin, and where they were at last."""

from __future__ import annotations

import math
from pathlib import Path
from typing import NamedTuple

import numpy as np

from gcs.planner.failsafes import foreign_returns_of
from gcs.recording import truth
from gcs.scenario.model import Scenario
from gcs.telemetry.proximity import GROUND_M
from skytender.safety.silence import Failsafe


class TrueEnd(NamedTuple):
    """A vehicle's end by its own truth."""

    t_s: float
    """of its last record"""
    landed_s: float | None
    """since when it has stood on the ground; None where it does not"""


def returns_after_s(scenario: Scenario) -> dict[int, float]:
    """Silence of the station, s, after which the failsafe of each launched vehicle takes it home, by system id.

    Inf where nothing says when: of vehicles that compete on board, which fly on while they receive a peer, and of real
    autopilots without a return that the session set.
    """
    on_board = scenario.competition.where == "vehicles"
    launched = scenario.vehicles.launched
    planned = foreign_returns_of(scenario) if any(vehicle.real is not None for vehicle in launched) else {}
    found = {}
    for vehicle in launched:
        if vehicle.real is not None:
            planned_return = planned.get(vehicle.sysid)
            found[vehicle.sysid] = math.inf if planned_return is None else planned_return.begins_after_s
        else:
            found[vehicle.sysid] = math.inf if on_board else vehicle.params.get("COM_DL_LOSS_T", Failsafe().loss_s)
    return found


def true_end(folder: Path, sysid: int, *, airborne: bool = False) -> TrueEnd | None:
    """The end of a vehicle by the truth in a session's folder; None where it left none. One that started `airborne` has
    no ground."""
    rows = truth.read(folder, sysid, truth.PLACE)
    if rows is None or not len(rows):
        return None
    up = np.flatnonzero(rows[:, 3] < -GROUND_M)
    down = int(up[-1]) + 1 if len(up) else 0
    landed_s = None if airborne or down == len(rows) else float(rows[down, 0])
    return TrueEnd(float(rows[-1, 0]), landed_s)
