"""A .plan of QGroundControl with twenty items, which ArduPilot, PX4 and vehicles of ours all take."""

from __future__ import annotations

from typing import Any

LAT_DEG, LON_DEG = 47.3977, 8.5456
TAKEOFF, WAYPOINT, LOITER_TIME, SPEED, DELAY, LAND = 22, 16, 19, 178, 93, 21


def item(command: int, *params: float | None, frame: int = 3) -> dict[str, Any]:
    """A simple item of a .plan; frame 3 is GLOBAL_RELATIVE_ALT, 2 MISSION."""
    return {"type": "SimpleItem", "command": command, "frame": frame, "params": params, "autoContinue": True}


def plan(shift_deg: float = 0.0, second_rally_m: float = 40.25) -> dict[str, Any]:
    """Twenty items, a fence of two areas, two rally points."""
    at = [(LAT_DEG + shift_deg + 1e-4 * k, LON_DEG - 7e-5 * k) for k in range(18)]
    ways = [
        item(WAYPOINT, k % 4, 2.0 * (k % 3), 0, [None, 0.0, -90.0][k % 3], *at[k], 20.0 + 0.25 * k) for k in range(13)
    ]
    items = [
        item(TAKEOFF, 15, 0, 0, None, *at[0], 20),
        item(SPEED, 1, 4.5, -1, None, None, None, None, frame=2),
        *ways[:6],
        item(LOITER_TIME, 5, 0, 0, 0, *at[14], 31.25),
        item(DELAY, 3, -1, -1, -1, 0, 0, 0, frame=2),
        *ways[6:],
        item(WAYPOINT, 0, 0, 0, None, *at[15], 500.0, frame=0),
        item(SPEED, 1, 2, -1, 0, 0, 0, 0, frame=2),
        item(LAND, 0, 0, 0, None, *at[16], 0),
    ]
    return {
        "fileType": "Plan", "version": 1, "groundStation": "QGroundControl",
        "mission": {
            "items": [one | {"doJumpId": number} for number, one in enumerate(items, 1)],
            "plannedHomePosition": [LAT_DEG, LON_DEG, 488.0], "version": 2,
            "firmwareType": 12, "vehicleType": 2, "cruiseSpeed": 15, "hoverSpeed": 5,
        },
        "geoFence": {
            "circles": [{"circle": {"center": at[0], "radius": 900.5}, "inclusion": True, "version": 1}],
            "polygons": [{"polygon": [at[14], at[16], at[17]], "inclusion": False, "version": 1}], "version": 2,
        },
        "rallyPoints": {"points": [[*at[1], 30.0], [*at[2], second_rally_m]], "version": 2},
    }  # fmt: skip
