"""Scenario families under several planners, for the comparisons in docs/campaigns/safety.md and dense.md."""

from __future__ import annotations

from typing import Any

from gcs.campaign.families.makers import family

PLANNERS: dict[str, dict[str, Any]] = {
    "skytender": {},
    "field": {"safety": False},
    "orca": {"safety": False, "method": "orca_planner:AStarOrca"},
    "orca3d": {"safety": False, "method": "orca3d_planner:AStarOrca3d"},
    "navground": {"safety": False, "method": "navground_planner:AStarNavground"},
}


def scenario(name: str, planner: str, seed: int) -> dict[str, Any]:
    """A family's scenario as `family` makes it, flown by one of `PLANNERS`."""
    document = family(name, seed)
    document["planner"] |= PLANNERS[planner]
    return document
