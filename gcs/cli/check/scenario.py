"""`gcs check SCENARIO`: a scenario's check list over its external vehicles, driven by the wall clock."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from gcs.link.external import ExternalLink
from gcs.scenario.model import Scenario
from gcs.supervisor.ground_check import GroundCheck
from gcs.supervisor.preflight import CheckItem

TICK_S = 0.1
MOST_S = 60.0
"""Beside what is waited for: no dialogue of a check list takes longer."""


def check_scenario(
    scenario: Scenario, say: Callable[[str], object], *, ready_within_s: float = 0.0
) -> dict[int, list[CheckItem]]:
    """Check lists of the external vehicles, by system id; `say` gets what is waited for. Raises AddressRefused,
    KeyRefused."""
    begun_s, speed = time.monotonic(), scenario.clock.speed
    link = ExternalLink(scenario.vehicles.external, lambda: speed * (time.monotonic() - begun_s), scenario.station.ids)
    labels = {vehicle.sysid: vehicle.label for vehicle in scenario.vehicles.all}
    try:
        patience_s = max(rules.found_within_s for rules in scenario.vehicles.external.values())
        say(f"waiting for {', '.join(labels[sysid] for sysid in sorted(scenario.vehicles.external))} ...")
        waited_s = time.monotonic()
        while not link.settled and time.monotonic() - waited_s < patience_s:
            link.listen(TICK_S)
        waits = link.waits()
        begun_s = time.monotonic()
        link.begin()
        check = GroundCheck(scenario, link)
        while (now_s := time.monotonic() - begun_s) < MOST_S + ready_within_s:
            check.tick(speed * now_s, time.time_ns() // 1000)
            if check.done and (check.ready or now_s >= ready_within_s):
                break
            link.rest(TICK_S)
        return check.lists(waits)
    finally:
        link.close()


def lines(content: dict[str, Any]) -> list[str]:
    """A line by vehicle and entry, of what `as_json` gives."""
    return [
        f"{'ok' if item['passed'] else 'FAILS':<6} {vehicle['label']}: {item['text']}"
        for vehicle in content["vehicles"]
        for item in vehicle["check_list"]
    ]


def as_json(scenario: Scenario, found: dict[int, list[CheckItem]]) -> dict[str, Any]:
    """Everything as one object."""
    labels = {vehicle.sysid: vehicle.label for vehicle in scenario.vehicles.all}
    vehicles = [
        {
            "sysid": sysid,
            "label": labels[sysid],
            "passed": all(item.passed for item in items),
            "check_list": [item._asdict() for item in items],
        }
        for sysid, items in sorted(found.items())
    ]
    return {"scenario": scenario.name, "passed": all(one["passed"] for one in vehicles), "vehicles": vehicles}
