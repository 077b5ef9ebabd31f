"""The parameters of a vehicle of ours: one table of names, limits, defaults and meanings, plain data.

The vehicle answers by it (simvehicle/autopilot/parameters.py), the ground station checks a scenario's `params` by it.
Names are PX4's where PX4 has the same quantity, else SIM_*. Values are kept as float32 can hold them, because that is
how MAVLink carries them.
"""

from __future__ import annotations

import struct
from typing import NamedTuple

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
    ParameterRow("MPC_ACC_HOR", 0.5, 15.0, 5.0, "m/s2 of the guidance"),
    ParameterRow("MPC_LAND_SPEED", 0.1, 3.0, 0.7, "m/s of descent"),
    ParameterRow("MPC_THR_MAX_G", 1.1, 10.0, 2.0, "greatest thrust, in weights"),
    ParameterRow("MPC_TILTMAX_AIR", 5.0, 89.0, 35.0, "deg of greatest tilt"),
    ParameterRow("MPC_TKO_SPEED", 0.2, 5.0, 1.5, "m/s of climb"),
    ParameterRow("MPC_XY_CRUISE", 0.5, 20.0, 5.0, "m/s on the way home"),
    ParameterRow("MPC_XY_VEL_MAX", 0.5, 20.0, 5.0, "m/s, greatest speed of the guidance"),
    ParameterRow("NAV_ACC_RAD", 0.05, 200.0, 0.5, "m, how near to a waypoint that names no radius is there"),
    ParameterRow("RC_MAP_PITCH", 0, 18, 0, "no radio control, for ground stations that ask", whole=True),
    ParameterRow("RC_MAP_ROLL", 0, 18, 0, "no radio control, for ground stations that ask", whole=True),
    ParameterRow("RC_MAP_THROTTLE", 0, 18, 0, "no radio control, for ground stations that ask", whole=True),
    ParameterRow("RC_MAP_YAW", 0, 18, 0, "no radio control, for ground stations that ask", whole=True),
    ParameterRow("RTL_RETURN_ALT", 1.0, 150.0, 5.0, "m above home at which the vehicle returns"),
    ParameterRow("SIM_ANGACC_MAX", 5.0, 1000.0, 30.0, "rad/s2, greatest"),
    ParameterRow("SIM_BAT_AVION_W", 0.0, 1e4, 10.0, "W drawn by the avionics"),
    ParameterRow("SIM_BAT_CAP_J", 1.0, 1e9, 24_000.0, "J that the battery holds"),
    ParameterRow("SIM_BAT_HOVER_W", 0.0, 1e5, 200.0, "W drawn by hovering"),
    ParameterRow("SIM_BAT_INIT_J", 0.0, 1e9, 24_000.0, "J in the battery at start; read once, then fixed"),
    ParameterRow("SIM_GAIN_ANGLE", 1e-3, 1e4, 36.0, "Aq, angle gain of the inner loop"),
    ParameterRow("SIM_GAIN_RATE", 1e-3, 1e3, 12.0, "Ap, rate gain of the inner loop"),
    ParameterRow(
        "SIM_GAIN_SET",
        0,
        2,
        0,
        "0: gains and limits below; 1: the paper's gains, no limits; 2: so, signed thrust, no floor; fixed",
        whole=True,
    ),
    ParameterRow("SIM_GAIN_SPEED", 1e-3, 1e2, 3.0, "lambda, gain of the outer loop"),
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
ROWS: dict[str, ParameterRow] = {row.name: row for row in (*TABLE, *ALONE)}
"""Every row by its name."""


def float32(value: float) -> float:
    """The nearest number that 32 bits hold."""
    return float(struct.unpack("<f", struct.pack("<f", value))[0])
