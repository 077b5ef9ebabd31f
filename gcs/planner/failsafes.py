"""Failsafes of launched vehicles, by which they come home when the ground station is lost [choice]."""

from __future__ import annotations

import functools
import math

import numpy as np

from gcs.scenario.model import Obstacle, Scenario, VehicleBase
from skytender.geometry import bounds, of_scenario
from skytender.safety.silence import MOST_LOST_S, Failsafe

LOST_AFTER_PERIODS, LEAST_LOST_S = 5, 0.1
"""[choice] Periods without a set point after which a launched vehicle holds; the shortest wait that it can be set
to."""
GONE_AFTER_PERIODS = 2
"""[choice] The same where none is lost or late by itself: two that are missing were kept from it."""
OVER_M = 1.5
"""[choice] Above the highest obstacle a launched vehicle returns, where its parameters do not say how high."""
MOST_ALTITUDE_M = 150.0
"""Greatest RTL_RETURN_ALT of our vehicles."""


def failsafe_of(vehicle: VehicleBase, scenario: Scenario) -> Failsafe:
    """Failsafe of a launched vehicle: by its parameters, and else one for who knows of no obstacle.

    It returns above all of them. Without set points it flies on as it did, where the next one might have led it around
    something, so that it waits no longer than for a few that were lost, or for the radio's jitter.
    """
    params, usual = vehicle.params, Failsafe()
    altitude_m = params.get("RTL_RETURN_ALT")
    if altitude_m is None:
        over_m = _highest_m(scenario.obstacles) + OVER_M + vehicle.start_m[2]
        altitude_m = min(max(usual.altitude_m, math.ceil(over_m)), MOST_ALTITUDE_M)
    radio, lockstep = scenario.radio, scenario.clock.mode == "lockstep"
    frames_go_missing = (
        radio.loss or radio.reorder or any(fault.fault in ("loss", "delay") for fault in scenario.faults)
    )
    flies_itself = scenario.competition.where == "vehicles"  # and begins to a moment before it would hold
    sure = lockstep and not frames_go_missing and not flies_itself
    periods = GONE_AFTER_PERIODS if sure else LOST_AFTER_PERIODS
    waits_s = periods * scenario.clock.period_s + radio.jitter_s
    return Failsafe(
        params.get("COM_DL_LOSS_T", usual.loss_s),
        params.get("COM_OF_LOSS_T", min(max(waits_s, LEAST_LOST_S), MOST_LOST_S)),
        altitude_m,
        params.get("MPC_XY_CRUISE", usual.speed_m_s),
        params.get("MPC_LAND_SPEED", usual.sink_m_s),
    )


@functools.lru_cache(4)
def _highest_m(obstacles: tuple[Obstacle, ...]) -> float:
    """Height of the highest obstacle's top above the scenario's height 0; 0 without any."""
    low, _ = bounds(of_scenario(obstacles)) if obstacles else (np.zeros((1, 3)), None)
    return -float(low[:, 2].min())
