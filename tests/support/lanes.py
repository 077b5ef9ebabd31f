"""Vehicles that a session did not start, each of which goes back and forth on a line of its own, 4 m from the next."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import pymap3d

LAT, LON, ALT = 47.397742, 8.545594, 488.0


def lanes(connects: Mapping[int, str], goal: Mapping[str, Any], reach_m: float = 3.0) -> dict[str, Any]:
    """A scenario of pursuers, by system id and the address that each comes by; each starts `reach_m` from both ends."""
    return {
        "schema": 1, "name": "lanes", "axes": "ned", "origin": {"lat_deg": LAT, "lon_deg": LON, "alt_m": ALT},
        "goal": dict(goal),
        "vehicles": {
            "pursuers": [
                {"external": {"connect": connect, "sysid": sysid, "capacity_j": 250_000, "found_within_s": 60,
                              "rejoins": True},
                 "waypoints_m": [[reach_m, 4 * sysid, -3], [-reach_m, 4 * sysid, -3]]}
                for sysid, connect in connects.items()
            ],
        },
    }  # fmt: skip


def start(sysid: int) -> str:
    """Latitude, longitude and altitude of where a vehicle stands, beneath its line."""
    lat, lon, alt = pymap3d.ned2geodetic(0.0, 4.0 * sysid, 0.0, LAT, LON, ALT)
    return f"{lat:.7f},{lon:.7f},{alt:.2f}"
