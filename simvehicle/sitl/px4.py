"""A real PX4 on our physics, through its HIL messages (docs/protocol/autopilots.md#px4).

Its time is that of the last HIL_SENSOR. It says what it wants of its motors in the HIL_ACTUATOR_CONTROLS that answers
one, and lives on with the next: so a grant ends by sending none.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from simvehicle.law.plants import Quaternion, Vec3
from simvehicle.mavlink.codec import encode
from simvehicle.mavlink.real_autopilots import hil
from simvehicle.mavlink.real_autopilots.autopilot_boot import PX4_BOOT
from simvehicle.mavlink.real_autopilots.battery_component import STATUS_EVERY_S
from simvehicle.sitl.autopilot_unit import AutopilotUnit, Sensed, Throttles
from simvehicle.sitl.px4_link import Px4Link
from simvehicle.world.airframes import GRAVITY_M_S2, SEA_LEVEL_KG_M3
from simvehicle.world.atmosphere import air_at
from simvehicle.world.magnetic_field import field_ned_t
from simvehicle.world.sensors import SensorNoise
from skytender import mavlink as mav

STEP_MS = 4
"""[choice] Of 200, 250 and 400 Hz it does not fly at the last."""
SLOW_STEPS = 5
"""Magnetometer and barometer are read at 50 Hz [choice]."""
GNSS_STEPS = 25
"""GNSS tells its place at 10 Hz [choice]."""
GNSS_EPH_M, GNSS_EPV_M, SATELLITES = 0.3, 0.4, 12
NO_FIX_M = 99.99
"""Deviations of a place that is none, as receivers tell them."""
SIMULATION = (0, 0)
"""System and component that say HIL messages: it asks for none."""


class Px4Unit(AutopilotUnit):
    """The PX4 with its physics."""

    boot_mode = PX4_BOOT
    step_ms = STEP_MS
    _link: Px4Link

    def _open(self) -> Px4Link:
        wanted, plant = self._wanted, self._plant
        self._field_ned_t = np.array(field_ned_t(*wanted.home, float(wanted.epoch_s)))
        self._noise = SensorNoise(seed=wanted.seed, sysid=wanted.sysid)
        self._battery_said_s = -STATUS_EVERY_S
        lift_m_s2 = plant.own.airframe.greatest_thrust_m_s2 * wanted.air_density_kg_m3 / SEA_LEVEL_KG_M3
        self._link = Px4Link(wanted, hover_throttle=GRAVITY_M_S2 / lift_m_s2)
        return self._link

    def _throttles(self) -> Throttles:
        return self._link.controls.throttles

    def _report_battery(self) -> None:
        if self._boot_s - self._battery_said_s < STATUS_EVERY_S - 1e-6:
            return
        self._battery_said_s = self._boot_s
        self._say(self._battery.status(), (self._wanted.sysid, mav.MAV_COMP_ID_BATTERY))

    def _answer(self, accel_body: Vec3) -> None:
        if self._time_ms is None:  # it boots, and a grant of its own takes no time
            self._report_battery()
        sensed = self._sense(accel_body)
        time_us = self._steps * STEP_MS * 1000
        noise = self._noise.step()
        slow = None
        if self._steps % SLOW_STEPS == 1:
            field = _to_body(sensed.quaternion, self._field_ned_t) + noise.field
            alt_m = self._wanted.home[2] - sensed.p_ned[2]
            air = air_at(alt_m)
            slow = (field.tolist(), air.pressure_pa + noise.pressure_pa, alt_m, air.celsius)
        accel = [a + e for a, e in zip(sensed.accel_body, noise.accel, strict=True)]
        rates = [r + e for r, e in zip(sensed.rates_body, noise.rates, strict=True)]
        said = [hil.sensor(time_us, accel_body=accel, rates_body=rates, slow=slow)]
        if self._steps % GNSS_STEPS == 1:
            said = [*self._gnss(sensed, time_us), *said]
        self._link.step(time_us, b"".join(self._encoded(content) for content in said))

    def _gnss(self, sensed: Sensed, time_us: int) -> list[object]:
        """Where GNSS has it, and where it is, for the autopilot's log."""
        lat_deg, lon_deg, alt_m = self._frame.to_global(*sensed.p_ned)
        lost = self._failures.gnss_lost
        fix = hil.gnss(
            self._wanted.epoch_s * 1_000_000 + time_us,
            lat_deg=lat_deg,
            lon_deg=lon_deg,
            alt_m=alt_m,
            v_ned=sensed.v_ned,
            eph_m=NO_FIX_M if lost else GNSS_EPH_M,
            epv_m=NO_FIX_M if lost else GNSS_EPV_M,
            satellites=0 if lost else SATELLITES,
            fix=not lost,
        )
        body = self._plant.body()
        lat_deg, lon_deg, alt_m = self._frame.to_global(*body.p_ned)
        there = hil.truth(
            time_us,
            quaternion=body.quaternion,
            rates_body=body.rates_body,
            lat_deg=lat_deg,
            lon_deg=lon_deg,
            alt_m=alt_m,
            v_ned=body.v_ned,
            accel_body=sensed.accel_body,
        )
        return [fix, there]

    def _encoded(self, content: object) -> bytes:
        sysid, compid = SIMULATION
        self._said += 1
        return encode(content, seq=self._said & 0xFF, sysid=sysid, compid=compid)


def _to_body(quaternion: Quaternion, ned: NDArray[np.float64]) -> NDArray[np.float64]:
    """A vector (3,) of NED in the body's axes: v - 2 w (u × v) + 2 u × (u × v), for the quaternion (w, u)."""
    w, u = quaternion[0], np.array(quaternion[1:])
    across = np.cross(u, ned)
    return ned - 2.0 * w * across + 2.0 * np.cross(u, across)
