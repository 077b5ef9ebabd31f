"""Plans of QGroundControl for vehicles of a test, written by hand from its file format; geodesy by pymap3d."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pymap3d

ORIGIN = (47.397742, 8.545594, 488.0)
Place = tuple[float, float, float]
WAYPOINT, SPEED, TAKEOFF = 16, 178, 22


def item(command: int, params: Sequence[float | None], frame: int = 3) -> dict[str, Any]:
    """A simple item of a plan."""
    return {"autoContinue": True, "command": command, "doJumpId": 1, "frame": frame, "params": list(params),
            "type": "SimpleItem"}  # fmt: skip


def waypoint(north_m: float, east_m: float, height_m: float, hold_s: float = 0.0) -> dict[str, Any]:
    """A way point, its height above home."""
    lat, lon, _ = pymap3d.ned2geodetic(north_m, east_m, 0.0, *ORIGIN)
    return item(WAYPOINT, [hold_s, 0, 0, None, float(lat), float(lon), height_m])


def speed(m_s: float) -> dict[str, Any]:
    """A change of the ground speed."""
    return item(SPEED, [1, m_s, -1, 0, 0, 0, 0], 2)


def write_plan(path: Path, items: Sequence[dict[str, Any]]) -> str:
    """Write a .plan; its name."""
    content = {
        "fileType": "Plan", "version": 1, "groundStation": "QGroundControl",
        "geoFence": {"circles": [], "polygons": [], "version": 2}, "rallyPoints": {"points": [], "version": 2},
        "mission": {"cruiseSpeed": 15, "firmwareType": 12, "globalPlanAltitudeMode": 1, "hoverSpeed": 5,
                    "items": list(items), "plannedHomePosition": list(ORIGIN), "vehicleType": 2, "version": 2},
    }  # fmt: skip
    path.write_text(json.dumps(content), encoding="utf-8")
    return path.name
