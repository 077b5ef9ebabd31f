"""Warnings of a scenario that can be flown and is likely to go wrong.

Rules of thumb, said before anything flies; nothing here keeps a scenario from being flown.
"""

from __future__ import annotations

from gcs.scenario.model import Scenario
from gcs.scenario.warnings import distances, gaps, near_obstacles, room, slips, supplies
from gcs.scenario.warnings.warning import ScenarioWarning


def warnings(scenario: Scenario) -> list[ScenarioWarning]:
    """All warnings of a scenario; those about single figures first."""
    found: list[ScenarioWarning] = []
    for of in (slips, supplies, distances, near_obstacles, room, gaps):
        found += of.warnings(scenario)
    return found
