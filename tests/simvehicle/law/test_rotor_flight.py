"""The law on rotors: it takes off, follows, lands and falls as on the paper's plant, and never writes its arguments."""

from __future__ import annotations

import pytest

from simvehicle.autopilot.body import Start
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.identity import IDENTITIES
from simvehicle.autopilot.maneuvers import OffboardSetPoint
from simvehicle.autopilot.modes import Mode, Trigger
from simvehicle.autopilot.parameters import Parameters
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.law import rotor_flight, rows
from simvehicle.law.params import NAMED
from simvehicle.law.plants import RotorPlant
from simvehicle.world import airframes
from simvehicle.world.airframes import AIRFRAMES
from simvehicle.world.description import WorldVehicle


def vehicle(name: str = "iris", *, yaw_ned: float = 0.0, **params: float) -> Vehicle:
    start, plant = Start(attitude_ned_rad=(0.0, 0.0, yaw_ned)), RotorPlant(WorldVehicle(AIRFRAMES[name]))
    return Vehicle(IDENTITIES["px4"], Parameters(params), LocalFrame(47.0, 8.0, 0.0), start, plant)


@pytest.mark.parametrize("name", AIRFRAMES)
def test_the_law_takes_rotors_to_a_place_and_stays(name: str) -> None:
    first, second = (vehicle(name, yaw_ned=-0.5, COM_OF_LOSS_T=60.0) for _ in range(2))
    for one in (first, second):
        one.armed, one.mode = True, Mode.OFFBOARD
        one.set_point(OffboardSetPoint((10.0, 4.0, -5.0), (0.0, 0.0, 0.0), (True, True, True), None, 0.0))
    first.advance(10_000)
    assert first.state[0, rows.TRUE_POSITION] == pytest.approx([10.0, -4.0, 5.0], abs=0.02)
    assert first.thrust_m_s2.shape == (1, 2500)
    assert first.thrust_m_s2[0, -1] == pytest.approx(airframes.GRAVITY_M_S2, rel=1e-3)
    second.advance(4000)
    second.advance(10_000)
    assert second.state.tobytes() == first.state.tobytes()


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
    assert one.trigger(Trigger.LAND)
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
