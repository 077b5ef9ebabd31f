"""Power of rotors and a battery with resistance, against momentum theory, circuit laws and a published curve."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from simvehicle.autopilot.body import Start
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.identity import IDENTITIES
from simvehicle.autopilot.parameters import Parameters
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.law.plants import RotorPlant
from simvehicle.mavlink.telemetry import message_of
from simvehicle.world import power
from simvehicle.world.airframes import AIRFRAMES, pack
from simvehicle.world.description import WorldVehicle


@pytest.mark.parametrize("name", AIRFRAMES)
def test_hover_costs_what_momentum_theory_says(name: str) -> None:
    airframe = AIRFRAMES[name]
    weight_n = airframe.mass_kg * 9.80665
    ideal_w = weight_n**1.5 / math.sqrt(2.0 * 1.225 * 4.0 * math.pi * airframe.rotor_radius_m**2)
    assert airframe.hover_shaft_w == pytest.approx(ideal_w / 0.7)
    for load in (0.5, 1.0, 1.7):
        speeds = np.full(4, airframe.hover_rad_s * math.sqrt(load))
        used_w = power.shaft_power(load * weight_n, speeds, 0.0, 0.0, pack(airframe))
        assert used_w == pytest.approx(airframe.hover_shaft_w * load**1.5)


def test_induced_speed_solves_glauert_and_climbing_costs_the_climb() -> None:
    random = np.random.default_rng(5)
    for _ in range(50):
        thrust, across, along = random.uniform(1, 30), random.uniform(0, 15), random.uniform(0, 8)
        v = power.induced_speed(thrust, across, along, 0.2, 1.225)
        root = brentq(lambda x: x * math.hypot(across, along + x) - thrust / (2 * 1.225 * 0.2), 0.0, 50.0, xtol=1e-12)  # noqa: B023
        assert v == pytest.approx(root, rel=1e-8)
    packed, speeds = pack(AIRFRAMES["iris"]), np.full(4, 794.0)
    fast = power.shaft_power(14.7, speeds, 0.0, 310.0, packed) - power.shaft_power(14.7, speeds, 0.0, 300.0, packed)
    assert fast == pytest.approx(14.7 * 10.0, rel=0.01)
    assert power.shaft_power(14.7, speeds, 8.0, 0.0, packed) < power.shaft_power(14.7, speeds, 0.0, 0.0, packed)


def test_the_battery_obeys_ohm_and_gives_off_all_that_it_loses() -> None:
    for charge in (0.1, 0.5, 1.0):
        for asked_w in (0.0, 50.0, 200.0):
            volts, amperes, taken_w = power.discharge(asked_w, charge, 0.15)
            open_v = power.CELLS * power.cell_v(charge)
            assert volts == pytest.approx(open_v - 0.15 * amperes)
            assert volts * amperes == pytest.approx(asked_w, abs=1e-9)
            assert taken_w == pytest.approx(asked_w + 0.15 * amperes**2, abs=1e-9)
    volts, amperes, taken_w = power.discharge(1000.0, 1.0, 1.0)
    assert (volts * amperes, taken_w) == pytest.approx((1000.0, 2000.0))
    assert power.cell_v(1.0) == pytest.approx(4.10, abs=0.01)
    assert power.cell_v(0.5) == pytest.approx(3.80, abs=0.01)
    assert quad(power.cell_v, 0.0, 1.0)[0] == pytest.approx(power.CELL_MEAN_V, abs=1e-3)


def test_voltage_and_current_are_on_the_wire_and_sag_under_load() -> None:
    plant = RotorPlant(WorldVehicle(AIRFRAMES["iris"], resistance_ohm=0.1))
    start = Start((0.0, 0.0, -20.0), airborne=True)
    one = Vehicle(IDENTITIES["px4"], Parameters(), LocalFrame(0.0, 0.0, 0.0), start, plant)
    rested = message_of(one, "SYS_STATUS")
    one.advance(5000)
    status, battery = message_of(one, "SYS_STATUS"), message_of(one, "BATTERY_STATUS")
    charge = one.remaining_j / one.capacity_j
    volts, amperes, taken_w = power.discharge(210.0, charge, 0.1)
    assert status.voltage_battery / 1e3 == pytest.approx(volts, abs=0.01)
    assert status.current_battery / 1e2 == pytest.approx(amperes, abs=0.05)
    assert battery.current_battery == status.current_battery
    assert sum(v for v in battery.voltages if v != 65535) / 1e3 == pytest.approx(volts, abs=0.01)
    assert rested.voltage_battery / 1e3 > volts + 1.0
    assert one.power_w == pytest.approx(taken_w, rel=1e-3)
    assert one.drawn_j + one.remaining_j == pytest.approx(24000.0, abs=1e-9)
