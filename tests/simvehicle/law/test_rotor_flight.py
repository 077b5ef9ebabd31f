"""The law on rotors: it takes off, follows, lands and falls as on the paper's plant, and never writes its arguments."""

from __future__ import annotations

import numpy as np
import pytest

from simvehicle.autopilot.body import Start
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.identity import IDENTITIES
from simvehicle.autopilot.modes import Mode
from simvehicle.autopilot.parameters import Parameters
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.law import rotor_flight, rows
from simvehicle.law.params import NAMED
from simvehicle.law.plants import RotorPlant
from simvehicle.world import airframes
from simvehicle.world.airframes import AIRFRAMES
from simvehicle.world.description import WorldVehicle


def vehicle(name: str = "iris", *, airborne: bool = False) -> Vehicle:
    start = Start((0.0, 0.0, -5.0 if airborne else 0.0), airborne=airborne)
    return Vehicle(
        IDENTITIES["px4"], Parameters(), LocalFrame(47.0, 8.0, 0.0), start, RotorPlant(WorldVehicle(AIRFRAMES[name]))
    )


def command(north_m: float, west_m: float, up_m: float) -> np.ndarray:
    row = np.zeros((1, rows.COMMAND_SIZE))
    row[0, rows.CMD_POSITION] = north_m, west_m, up_m
    row[0, rows.CMD_USE_POSITION] = row[0, rows.CMD_MOTORS] = row[0, rows.CMD_GROUND] = 1.0
    row[0, rows.CMD_SPEED_MAX] = 5.0
    return row


@pytest.mark.parametrize("name", AIRFRAMES)
def test_the_law_takes_rotors_to_a_place_and_stays(name: str) -> None:
    plants = [RotorPlant(WorldVehicle(AIRFRAMES[name])) for _ in range(2)]
    for plant in plants:
        plant.tune(NAMED["default"])
        plant.start(
            NAMED["default"],
            position_nwu=(0, 0, 0),
            velocity_nwu=(0, 0, 0),
            attitude_rad=(0, 0, 0.5),
            airborne=False,
        )
    wanted = command(10.0, -4.0, 5.0)
    given = (plants[0].state, wanted)
    before = [array.copy() for array in given]
    thrust = plants[0].advance(wanted, time_s=0.0, steps=2500)
    assert all(np.array_equal(*pair) for pair in zip(given, before, strict=True))
    flown = plants[0].state
    assert flown[0, rows.TRUE_POSITION] == pytest.approx([10.0, -4.0, 5.0], abs=0.02)
    assert thrust[0, -1] == pytest.approx(airframes.GRAVITY_M_S2, rel=1e-3)
    plants[1].advance(wanted, time_s=0.0, steps=1000)
    plants[1].advance(wanted, time_s=4.0, steps=1500)
    assert plants[1].state.tobytes() == flown.tobytes()


def test_a_vehicle_on_rotors_takes_off_and_lands() -> None:
    one = vehicle()
    one.armed = True
    assert one.landed
    assert one.take_off(3.0)
    for t_ms in range(100, 8100, 100):
        one.receive_gcs_heartbeat()
        one.advance(t_ms)
    assert one.p_ned[2] == pytest.approx(-3.0, abs=0.1)
    assert not one.landed
    one.mode = Mode.LAND
    one._enter(Mode.LAND)
    for t_ms in range(8100, 18100, 100):
        one.receive_gcs_heartbeat()
        one.advance(t_ms)
    assert one.landed
    assert not one.armed
    assert one.true_motion_ned[2:6] == (0.0, 0.0, 0.0, 0.0)


def test_its_ledger_closes_and_an_empty_battery_stops_its_rotors() -> None:
    start = Start((0.0, 0.0, -500.0), airborne=True)
    given = {"SIM_BAT_CAP_J": 1000.0}
    one = Vehicle(
        IDENTITIES["px4"],
        Parameters(given),
        LocalFrame(0.0, 0.0, 0.0),
        start,
        RotorPlant(WorldVehicle(AIRFRAMES["iris"])),
    )
    one.advance(10_000)
    assert one.drawn_j + one.remaining_j == pytest.approx(1000.0, abs=1e-9)
    assert one.remaining_j == 0.0
    assert one.plant.state[0, rows.ROTOR_SPEEDS].max() < 1.0
    assert one.v_ned[2] > 10.0


def test_air_too_thin_to_fly_in_is_refused() -> None:
    with pytest.raises(ValueError, match="thrust_m_s2"):
        rotor_flight.on_rotors(NAMED["default"], AIRFRAMES["iris"], 0.6)
