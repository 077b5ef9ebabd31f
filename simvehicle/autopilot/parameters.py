"""The vehicle's parameters: one table of names, limits and meanings; changing a value changes the flight.

Names are PX4's where PX4 has the same quantity, else SIM_*. Values are kept as float32 can hold them, because that is
how MAVLink carries them. The wire's two encodings of integers (bytewise as PX4, by value as ArduPilot) stand last.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator
from dataclasses import replace
from difflib import get_close_matches
from typing import NamedTuple

from simvehicle.law.params import NAMED, BatteryParams, Gains, Limits, VehicleParams
from skytender import mavlink as mav

UNKNOWN: int = mav.MAV_PARAM_ERROR_DOES_NOT_EXIST
OUT_OF_RANGE: int = mav.MAV_PARAM_ERROR_VALUE_OUT_OF_RANGE
READ_ONLY: int = mav.MAV_PARAM_ERROR_READ_ONLY
WRONG_TYPE = 7
"""MAV_PARAM_ERROR_TYPE_MISMATCH, which is younger than pymavlink's dialect."""


class ParameterError(ValueError):
    """An unknown name or a value that the parameter cannot take; the text names both, `code` is PARAM_ERROR's."""

    def __init__(self, text: str, code: int) -> None:
        super().__init__(text)
        self.code = code


UNITS = frozenset({"J", "W", "deg", "m", "m/s", "m/s2", "rad/s2", "s"})


class ParameterRow(NamedTuple):
    """One parameter: its least and greatest value, its default and what it is; `whole`: an INT32 on the wire."""

    name: str
    least: float
    most: float
    default: float
    meaning: str
    whole: bool = False

    @property
    def units(self) -> str:
        """The unit with which its meaning begins; empty where it has none."""
        first = self.meaning.split()[0].rstrip(",")
        return first if first in UNITS else ""


GAIN_SETS = ("default", "paper", "paper_literal")
"""Names of the flight law's sets, by SIM_GAIN_SET."""
_FLIGHT = NAMED["default"]
_DEG = 180.0 / math.pi

TABLE: tuple[ParameterRow, ...] = (
    ParameterRow(
        "ARMING_CHECK", 0, 1, 1, "1: refuse to arm with a fault or an empty battery, 0: arm anyway", whole=True
    ),
    ParameterRow("BAT_EMERGEN_THR", 0.0, 1.0, 0.05, "battery share below which the vehicle lands"),
    ParameterRow("CAL_ACC0_ID", 0, 2**24, 1310988, "accelerometer's id, for ground stations that ask", whole=True),
    ParameterRow("CAL_GYRO0_ID", 0, 2**24, 1310988, "gyroscope's id, for ground stations that ask", whole=True),
    ParameterRow("CAL_MAG0_ID", 0, 2**24, 197388, "magnetometer's id, for ground stations that ask", whole=True),
    ParameterRow(
        "COM_DL_LOSS_T", 1.0, 300.0, 5.0, "s without the ground station's HEARTBEAT before the vehicle returns"
    ),
    ParameterRow("COM_OF_LOSS_T", 0.1, 60.0, 1.0, "s without a set point before offboard falls back to hold"),
    ParameterRow("COM_RC_IN_MODE", 0, 4, 1, "1: no radio control, for ground stations that ask", whole=True),
    ParameterRow("FLW_TGT_ALT_M", 0, 2, 0, "following: 0 and 1 height above home, 2 above the target", whole=True),
    ParameterRow("FLW_TGT_DST", 1.0, 100.0, 8.0, "m from the target on the ground when following"),
    ParameterRow("FLW_TGT_FA", -180.0, 180.0, 180.0, "deg from the target's course: 0 ahead of it, 180 behind"),
    ParameterRow("FLW_TGT_HT", 1.0, 100.0, 8.0, "m of height when following"),
    ParameterRow("FLW_TGT_MAX_VEL", 0.5, 20.0, 5.0, "m/s, greatest speed of following"),
    ParameterRow("FLW_TGT_RS", 0.0, 0.99, 0.1, "share of a followed target's old velocity in the new one"),
    ParameterRow(
        "GF_ACTION", 0, 3, 2, "when the geofence is breached: 0 nothing, 1 warn, 2 hold, 3 return", whole=True
    ),
    ParameterRow("MIS_TAKEOFF_ALT", 0.5, 80.0, 2.5, "m above home that a take-off without altitude climbs to"),
    ParameterRow("MPC_ACC_HOR", 0.5, 15.0, _FLIGHT.limits.acceleration_m_s2, "m/s2 of the guidance"),
    ParameterRow("MPC_LAND_SPEED", 0.1, 3.0, 0.7, "m/s of descent"),
    ParameterRow("MPC_THR_MAX_G", 1.1, 10.0, 2.0, "greatest thrust, in weights"),
    ParameterRow("MPC_TILTMAX_AIR", 5.0, 89.0, _FLIGHT.limits.tilt_rad * _DEG, "deg of greatest tilt"),
    ParameterRow("MPC_TKO_SPEED", 0.2, 5.0, 1.5, "m/s of climb"),
    ParameterRow("MPC_XY_CRUISE", 0.5, 20.0, 5.0, "m/s on the way home"),
    ParameterRow("MPC_XY_VEL_MAX", 0.5, 20.0, _FLIGHT.limits.speed_m_s, "m/s, greatest speed of the guidance"),
    ParameterRow("NAV_ACC_RAD", 0.05, 200.0, 0.5, "m, how near to a waypoint that names no radius is there"),
    ParameterRow("RC_MAP_PITCH", 0, 18, 0, "no radio control, for ground stations that ask", whole=True),
    ParameterRow("RC_MAP_ROLL", 0, 18, 0, "no radio control, for ground stations that ask", whole=True),
    ParameterRow("RC_MAP_THROTTLE", 0, 18, 0, "no radio control, for ground stations that ask", whole=True),
    ParameterRow("RC_MAP_YAW", 0, 18, 0, "no radio control, for ground stations that ask", whole=True),
    ParameterRow("RTL_RETURN_ALT", 1.0, 150.0, 5.0, "m above home at which the vehicle returns"),
    ParameterRow("SIM_ANGACC_MAX", 5.0, 1000.0, _FLIGHT.limits.angular_acceleration_rad_s2, "rad/s2, greatest"),
    ParameterRow("SIM_BAT_AVION_W", 0.0, 1e4, _FLIGHT.battery.avionics_w, "W drawn by the avionics"),
    ParameterRow("SIM_BAT_CAP_J", 1.0, 1e9, _FLIGHT.battery.capacity_j, "J that the battery holds"),
    ParameterRow("SIM_BAT_HOVER_W", 0.0, 1e5, _FLIGHT.battery.hover_w, "W drawn by hovering"),
    ParameterRow(
        "SIM_BAT_INIT_J", 0.0, 1e9, _FLIGHT.battery.initial_j, "J in the battery at start; read once, then fixed"
    ),
    ParameterRow("SIM_GAIN_ANGLE", 1e-3, 1e4, _FLIGHT.gains.angle, "Aq, angle gain of the inner loop"),
    ParameterRow("SIM_GAIN_RATE", 1e-3, 1e3, _FLIGHT.gains.rate, "Ap, rate gain of the inner loop"),
    ParameterRow(
        "SIM_GAIN_SET",
        0,
        2,
        0,
        "0: gains and limits below; 1: the paper's gains, no limits; 2: so, signed thrust, no floor; fixed",
        whole=True,
    ),
    ParameterRow("SIM_GAIN_SPEED", 1e-3, 1e2, _FLIGHT.gains.speed, "lambda, gain of the outer loop"),
    ParameterRow("SIM_XFER_DIST", 0.1, 100.0, 1.5, "m, greatest distance of a giver"),
    ParameterRow("SIM_XFER_SPEED", 0.05, 10.0, 0.5, "m/s, greatest relative speed of a giver"),
    ParameterRow("SYS_AUTOSTART", 0, 99999, 4001, "airframe number, for ground stations that ask", whole=True),
    ParameterRow("SYS_FAILURE_EN", 0, 1, 0, "1 lets MAV_CMD_INJECT_FAILURE make things fail", whole=True),
)
ALONE: tuple[ParameterRow, ...] = (
    ParameterRow("DID_ENABLE", 0, 1, 0, "1: send Remote ID, the Open Drone ID messages", whole=True),
    ParameterRow("RTL_LAND_DELAY", 0.0, 300.0, 0.0, "s over home, as high as it returned, before the vehicle lands"),
)
"""Rows behind the table's, of a vehicle that no session has launched: a launched one returns by its fleet's
timetable."""
_ROWS = {row.name: row for row in (*TABLE, *ALONE)}
READ_ONCE = frozenset({"SIM_BAT_INIT_J", "SIM_GAIN_SET"})
"""Names of parameters that can only be given at start."""


def float32(value: float) -> float:
    """The nearest number that 32 bits hold."""
    return float(struct.unpack("<f", struct.pack("<f", value))[0])


class Parameters:
    """The values of one vehicle, by name, in the table's order."""

    def __init__(self, given: dict[str, float] | None = None, *, alone: bool = False) -> None:
        """`given` overrides defaults; `alone`: no session has launched the vehicle. Raises ParameterError."""
        self.alone = alone
        self.table = (*TABLE, *ALONE) if alone else TABLE
        """rows that it tells, and lets be changed"""
        self._values = {row.name: float32(row.default) for row in (*TABLE, *ALONE)}
        given = given or {}
        self._given = dict(given)
        for name, value in given.items():
            self._values[name] = self._checked(name, value)
        if "SIM_BAT_INIT_J" not in given:
            self._values["SIM_BAT_INIT_J"] = self._values["SIM_BAT_CAP_J"]
        if self._values["SIM_BAT_INIT_J"] > self._values["SIM_BAT_CAP_J"]:
            text = "SIM_BAT_INIT_J is above SIM_BAT_CAP_J: a battery cannot start fuller than full"
            raise ParameterError(text, OUT_OF_RANGE)

    def __getitem__(self, name: str) -> float:
        return self._values[name]

    def __iter__(self) -> Iterator[tuple[ParameterRow, float]]:
        return ((row, self._values[row.name]) for row in self.table)

    def __len__(self) -> int:
        return len(self.table)

    def row_at(self, key: str | int) -> tuple[int, ParameterRow] | None:
        """Index and row of a parameter by name or by its place in the table; None where there is none."""
        if isinstance(key, int):
            return (key, self.table[key]) if 0 <= key < len(self.table) else None
        return next(((index, row) for index, row in enumerate(self.table) if row.name == key), None)

    @staticmethod
    def _checked(name: str, value: float) -> float:
        row = _ROWS.get(name)
        if row is None:
            near = get_close_matches(name.upper(), _ROWS, 1)
            raise ParameterError(f"unknown parameter {name}" + (f", did you mean {near[0]}?" if near else ""), UNKNOWN)
        if not (math.isfinite(value) and row.least <= value <= row.most):
            raise ParameterError(f"{name} = {value:g} is outside {row.least:g} .. {row.most:g}", OUT_OF_RANGE)
        return float(round(value)) if row.whole else float32(value)

    def set(self, name: str, value: float) -> float:
        """Change a value while the vehicle runs; returns what is now in force; raises ParameterError, value kept."""
        if name in READ_ONCE:
            raise ParameterError(f"{name} can only be given at start", READ_ONLY)
        before = self._values.get(name)
        self._values[name] = self._checked(name, value)
        try:
            self.flight()
        except ValueError as error:
            assert before is not None
            self._values[name] = before
            raise ParameterError(f"{name} = {value:g} is refused: {error}", OUT_OF_RANGE) from error
        return self._values[name]

    def values(self) -> dict[str, float]:
        """All values by name."""
        return dict(self._values)

    def with_kept(self, kept: dict[str, float]) -> Parameters:
        """These values with others that were kept from an earlier life; raises ParameterError."""
        return Parameters({**self._given, **kept}, alone=self.alone)

    def restore(self, values: dict[str, float]) -> None:
        """Put values back that were in force before."""
        self._values.update(values)

    def flight(self) -> VehicleParams:
        """Flight law's parameters by these values; the paper's sets keep their gains and have no limits."""
        base = NAMED[GAIN_SETS[int(self["SIM_GAIN_SET"])]]
        battery = BatteryParams(
            capacity_j=self["SIM_BAT_CAP_J"],
            initial_j=min(self["SIM_BAT_INIT_J"], self["SIM_BAT_CAP_J"]),
            hover_w=self["SIM_BAT_HOVER_W"],
            avionics_w=self["SIM_BAT_AVION_W"],
        )
        if self["SIM_GAIN_SET"] != 0:
            return replace(base, battery=battery)
        gains = Gains(
            speed=self["SIM_GAIN_SPEED"],
            rate=self["SIM_GAIN_RATE"],
            angle=self["SIM_GAIN_ANGLE"],
            epsilon=base.gains.epsilon,
        )
        limits = Limits(
            tilt_rad=self["MPC_TILTMAX_AIR"] / _DEG,
            thrust_m_s2=self["MPC_THR_MAX_G"] * base.airframe.gravity_m_s2,
            angular_acceleration_rad_s2=self["SIM_ANGACC_MAX"],
            speed_m_s=self["MPC_XY_VEL_MAX"],
            acceleration_m_s2=self["MPC_ACC_HOR"],
        )
        return replace(base, gains=gains, limits=limits, battery=battery)
