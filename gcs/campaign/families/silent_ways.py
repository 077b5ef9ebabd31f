"""Ways of a vehicle that is alone with its failsafe: straight up from where it fell silent, and down over its home.

Lengths in metres, NED; [choice].
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from gcs.campaign.families.parts import OBSTACLE_M, Document, FloatArray
from skytender import geometry as shapes

SILENT_FROM_S, STOPS_WITHIN_S = 15.0, 1.5
"""[choice] When a vehicle falls silent, and how long it flies on."""
STARTS_WITHIN_S, TAKES_OFF_WITHIN_S = 2.0, 8.0
"""[choice] Until a target is under way that starts in the air, and on the ground."""


def floats_over(table: FloatArray, document: Document, pursuer: Document) -> bool:
    """Whether an obstacle hangs over a place in the ring where a pursuer may be when it falls silent: straight up from
    there it would come nearer to one than `OBSTACLE_M`, and nearer than it is."""
    target = document["vehicles"]["targets"][0]
    path, offset = np.array(target["path_m"]), np.subtract(pursuer["start_m"], target["start_m"])
    ways = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))])
    under_way_s = SILENT_FROM_S - (STARTS_WITHIN_S if target["airborne"] else TAKES_OFF_WITHIN_S)
    from_m, to_m = target["speed_m_s"] * under_way_s, target["speed_m_s"] * (SILENT_FROM_S + STOPS_WITHIN_S)
    flown = np.arange(from_m, to_m, 0.25)
    leg = np.clip(np.searchsorted(ways, flown) - 1, 0, len(path) - 2)
    share = np.clip((flown - ways[leg]) / (ways[leg + 1] - ways[leg]), 0.0, 1.0)
    places = path[leg] + share[:, None] * (path[leg + 1] - path[leg]) + offset
    here = shapes.clearance(table, places)
    return any(
        clearance_over(table, place[:2], -place[2]) < min(OBSTACLE_M, at - 1e-3)
        for place, at in zip(places, here, strict=True)
    )


def clearance_over(table: FloatArray, place: ArrayLike, from_m: float) -> float:
    """Clearance of the column over a place (north, east), from a height to above all obstacles."""
    heights = np.linspace(from_m, 15.0, 61)
    column = np.column_stack([np.broadcast_to(place, (61, 2)), -heights])
    return float(shapes.clearance(table, column).min())
