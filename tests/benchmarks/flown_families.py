"""Scenario families under three planners, for the comparison in docs/campaigns/safety.md."""

from __future__ import annotations

from typing import Any

from gcs.campaign.families.makers import family

PLANNERS: dict[str, dict[str, Any]] = {
    "skytender": {},
    "field": {"safety": False},
    "orca": {"safety": False, "method": "orca_planner:AStarOrca"},
}


def scenario(name: str, planner: str, seed: int) -> dict[str, Any]:
    """A family's scenario as `family` makes it, flown by one of `PLANNERS`."""
    document = family(name, seed)
    document["planner"] |= PLANNERS[planner]
    return document
