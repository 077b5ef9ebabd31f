"""Random scenarios in which tankers are barely enough: the order of services decides which vehicles are lost. Metres,
NED.

Pursuers hover each at a place of its own, with batteries for half a minute to two; how many there are follows from what
the tankers can carry to them, at a load drawn near 1. All is in the air from the beginning, and nothing else is in the
way, so that what is compared are policies.
"""

from __future__ import annotations

import math

import numpy as np

from gcs.campaign.families.parts import BATTERY, Document, rounded_m
from skytender import elementary

HOVER_W = 210.0
RATE_W = 2000.0
OVERHEAD_S = 6.0
"""Of a service beside the flow of energy, as measured."""
APART_M = 3.0
WIDE_M = 12.0
DURATION_S = 80.0
MOST_TANKERS = 3
FEWEST, MOST = 4, 12
MOST_WIND_M_S, LEAST_TURBULENCE_M_S, MOST_TURBULENCE_M_S = 6.0, 5.0, 12.0


def tight(rng: np.random.Generator) -> Document:
    """4 to 12 pursuers and 1 to 3 tankers of different speeds, stocks and reserves."""
    tankers = int(rng.integers(1, MOST_TANKERS + 1))
    capacity_j, load = float(rng.uniform(9e3, 24e3)), float(rng.uniform(0.75, 1.15))
    flies_s = 0.7 * capacity_j / HOVER_W
    serves_s = OVERHEAD_S + 0.7 * capacity_j / (RATE_W - HOVER_W)
    n = min(max(round(load * tankers * flies_s / serves_s), FEWEST), MOST)
    places = _places(rng, n)
    pursuers = []
    for i, place in enumerate(places):
        battery = {
            **BATTERY,
            "capacity_j": round(capacity_j * float(rng.uniform(0.8, 1.25))),
            "initial_percent": round(float(rng.uniform(28.0, 85.0)), 1),
        }
        at = rounded_m(place)
        pursuers.append({"sysid": i + 1, "start_m": at, "airborne": True, "waypoints_m": [at], "battery": battery})
    listed = []
    for i in range(tankers):
        angle = 2.0 * math.pi * (i + float(rng.uniform(0.0, 0.6))) / tankers
        home = rounded_m([10.0 * elementary.cos(angle), 10.0 * elementary.sin(angle), -11.0])
        listed.append(
            {
                "sysid": 201 + i,
                "start_m": home,
                "airborne": True,
                "home_m": home,
                "speed_m_s": round(float(rng.uniform(3.0, 6.0)), 2),
                "reserve_j": round(float(rng.uniform(5e3, 15e3))),
                "battery": {**BATTERY, "capacity_j": round(float(rng.uniform(1.2e5, 2.0e5)))},
            }
        )
    return {
        "goal": {"duration_s": DURATION_S},
        "vehicles": {"pursuers": pursuers, "tankers": listed},
        "vehicles_per_process": FEWEST + MOST,
        "truth": False,
        "planner": {"separation_m": 0.6},
        "competition": {"need_from": 0.4},
    }


def tight_gusts(rng: np.random.Generator) -> Document:
    """The same on rotors in wind and turbulence, so that consumption is random and differs between vehicles."""
    document = tight(rng)
    document["vehicles"]["defaults"] = {"plant": "rotors"}
    document["wind"] = {
        "speed_m_s": round(float(rng.uniform(0.0, MOST_WIND_M_S)), 1),
        "turbulence_m_s": round(float(rng.uniform(LEAST_TURBULENCE_M_S, MOST_TURBULENCE_M_S)), 1),
    }
    return document


def _places(rng: np.random.Generator, n: int) -> list[np.ndarray[tuple[int], np.dtype[np.float64]]]:
    found: list[np.ndarray[tuple[int], np.dtype[np.float64]]] = []
    while len(found) < n:
        place = np.array([*rng.uniform(-WIDE_M, WIDE_M, 2), rng.uniform(-6.0, -4.0)])
        if all(elementary.distance(place[:2], other[:2]) >= APART_M for other in found):
            found.append(place)
    return found
