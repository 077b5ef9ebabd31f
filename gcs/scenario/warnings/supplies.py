"""Warnings of batteries that are soon empty, of tankers that keep too little, and of radios and their faults that fit
no session."""

from __future__ import annotations

from collections.abc import Iterator

from gcs.scenario.model import Scenario
from gcs.scenario.warnings.warning import ScenarioWarning

LEAST_HOVER_S = 10.0
"""A full battery that keeps its vehicle in the air for less is warned of."""
J_PER_WH = 3600.0
SLOW_S = 5.0
"""With a delay of more a vehicle is where its set points were long ago, and counts as silent all the time."""


def warnings(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Those about batteries first."""
    yield from _of_batteries(scenario)
    yield from _of_reserves(scenario)
    yield from _of_the_radio(scenario)


def _of_batteries(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Capacities that are probably in Wh."""
    least_s, short = min(LEAST_HOVER_S, scenario.goal.duration_s), []
    for vehicle in scenario.vehicles.launched:
        battery = vehicle.battery
        hovers_s = battery.capacity_j / (battery.hover_w + battery.avionics_w)
        if hovers_s < least_s:
            short.append((hovers_s, vehicle.label, battery.capacity_j))
    if short:
        hovers_s, label, capacity_j = min(short)
        more = f", the shortest of {len(short)} such vehicles" if len(short) > 1 else ""
        yield ScenarioWarning(
            "battery",
            f"{label} hovers for {hovers_s:.1f} s with its full battery{more}: battery.capacity_j is in joules, and "
            f"{capacity_j:g} Wh are {capacity_j * J_PER_WH:g} J; raise it",
        )


def _of_reserves(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Tankers that can give, before the session's end, until they land by themselves."""
    rules, duration_s, short = scenario.refuelling, scenario.goal.duration_s, []
    launched = {vehicle.sysid for vehicle in scenario.vehicles.launched}
    for tanker in scenario.vehicles.tankers if rules.enabled else ():
        battery = tanker.battery
        share = float(tanker.params.get("BAT_EMERGEN_THR", rules.lands_at))
        lands_j, most_w = share * battery.capacity_j, battery.hover_w + battery.avionics_w + rules.rate_w
        least_j = 0.01 * battery.initial_percent * battery.capacity_j - most_w * duration_s
        if tanker.sysid in launched and tanker.reserve_j <= lands_j and least_j <= lands_j:
            short.append((tanker.label, tanker.reserve_j, lands_j, share))
    if short:
        label, reserve_j, lands_j, share = short[0]
        more = f", the first of {len(short)} such tankers" if len(short) > 1 else ""
        yield ScenarioWarning(
            "refuelling",
            f"{label} gives until it holds {reserve_j:g} J (reserve_j){more}, and lands by itself below {lands_j:g} J, "
            f"{100.0 * share:g} % of its battery: it is lost soon after that; raise reserve_j",
        )


def _of_the_radio(scenario: Scenario) -> Iterator[ScenarioWarning]:
    """Faults that never happen, and a delay with which no vehicle can be steered."""
    radio, duration_s = scenario.radio, scenario.goal.duration_s
    if radio.delay_s > SLOW_S:
        yield ScenarioWarning(
            "radio",
            f"radio.delay_s is {radio.delay_s:g} s each way, and with more than {SLOW_S:g} s no vehicle can be "
            "steered: lower it, or write seconds if these are milliseconds",
        )
    for key in ("blackouts", "ground_blackouts", "splits"):
        late = [fault.from_s for fault in getattr(radio, key) if fault.from_s >= duration_s]
        if late:
            which = f"{len(late)} of radio.{key} begin, the first" if len(late) > 1 else f"one of radio.{key} begins"
            yield ScenarioWarning(
                "radio",
                f"{which} at {min(late):g} s, and the session ends at {duration_s:g} s (goal.duration_s): it never "
                "happens; begin it sooner, or fly longer",
            )
