"""How far vehicles may be from where they say they are, and what that adds to the distances that are kept.

A vehicle with `sensors:` knows its place to a standard deviation s of each axis (docs/model/world.md#estimate-errors).
Along the line between two vehicles their errors differ by one of sqrt(s_1² + s_2²). Its spread is k times that, with k
of `planner: {confidence}`: the share of sessions in which no error of any two vehicles, or of a vehicle beside what
stands there, is greater than its spread, by the union bound over all of them and over the correlation times that the
session lasts [choice].
"""

from __future__ import annotations

from statistics import NormalDist

from gcs.scenario.model import Scenario
from gcs.scenario.weather import Sensors
from skytender import elementary


def spreads_m(scenario: Scenario) -> dict[int, float]:
    """Each vehicle's spread beside what stands, m, by system id; 0 for one that knows its place or says nothing."""
    sensors = {vehicle.sysid: vehicle.sensors for vehicle in scenario.vehicles.all}
    k = factor(scenario)
    return {sysid: 0.0 if one is None else k * one.position_m for sysid, one in sensors.items()}


def widest_m(scenario: Scenario) -> tuple[float, float]:
    """Greatest spread of any two vehicles, and of one, m."""
    other_m, widest_m = (0.0, 0.0, *sorted(spreads_m(scenario).values()))[-2:]
    return elementary.hypot(other_m, widest_m), widest_m


def factor(scenario: Scenario) -> float:
    """k, to two decimals: the C library's logarithm, which differs in its last bit between processors, is not flown."""
    count, every = len(scenario.vehicles.all), scenario.vehicles.all
    lasts_s = [vehicle.sensors.position_s for vehicle in every if vehicle.sensors is not None]
    times = 1.0 + scenario.goal.duration_s / min(lasts_s, default=Sensors().position_s)
    beyond = (1.0 - scenario.planner.confidence) / (times * count * (count + 1) / 2)
    return round(-NormalDist().inv_cdf(beyond), 2)
