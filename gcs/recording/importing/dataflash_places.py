"""Places and speeds of a DataFlash log, by the estimate that its vehicle flew by.

POS is the vehicle's own place in every version of ArduPilot (AP_AHRS::Write_POS); AHR2 is of another estimate. Rows of
the EKFs are written whether the vehicle flies by them or not: ATT's AEKF names the one that it flies by
(AP_AHRS::EKFType, since 4.1), XKF4's and NKF4's PI its core. Without AEKF places are POS's, as only that is sure.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from skytender.geodesy import half_turn_deg

DCM, EKF1, EKF2, EKF3, SIM, EXTERNAL = 0, 1, 2, 3, 10, 11
SPEEDS = {
    "EKF1": (EKF1, 0),
    **{"NKF1": (EKF2, 0), "NKF6": (EKF2, 1), "NKF11": (EKF2, 2)},
    **{"XKF1": (EKF3, 0), "XKF6": (EKF3, 1), "XKF11": (EKF3, 2)},
    **{"SIM2": (SIM, 0), "EAHR": (EXTERNAL, 0)},
}
"""Rows with VN, VE and VD → the estimate and its core, which C names instead since 4.1."""
EKFS = (EKF3, EKF2, EKF1)
"""Estimates whose rows tell places from the origin of ORGN too; the newest first."""
PRIMARY = {"NKF4": EKF2, "XKF4": EKF3}
TYPE_NAMES = ("AHRS_EKF_TYPE", "AHRS_EKF_USE")
"""Parameters that say which estimate is to be flown by; the second is that of 2014, EKF1 or DCM."""
EKF_ORIGIN = 0
"""Type of ORGN: the other is home."""
FIX_3D = 3
_M_PER_DEG = 1e7 * 0.011131884502145034
"""Location::LOCATION_SCALING_FACTOR, by which ArduPilot goes from degrees to its local frame."""
_LEAST_SCALE = 0.01
_Made = Iterator[tuple[str, dict[str, Any]]]
_Ned = tuple[float, float, float]


class LoggedPlaces:
    """The vehicle's place and speed by its log so far."""

    def __init__(self, reader: Any) -> None:
        """Look through a log of pymavlink's DFReader, which is rewound."""
        active = getattr(_first(reader, "ATT"), "AEKF", None)
        self._named = active is not None
        self._active: int | None = active
        logged = {SPEEDS[name][0] for name in SPEEDS if _first(reader, name) is not None}
        self._presumed = next((one for one in EKFS if one in logged), DCM)
        self._has_global = all(_first(reader, name) is not None for name in ("POS", "ORGN"))
        self._cores: dict[int, int] = {}
        self._v_ned: dict[int, _Ned] = {}
        self._origin: Any = None
        self._placed = False
        """whether an EKF's row has given the place since the last POS"""

    def read(self, boot_ms: int, row: Any) -> _Made:
        """Names and fields of the messages that one row gives."""
        name = row.get_type()
        if name in SPEEDS:
            yield from self._estimated(boot_ms, row, *SPEEDS[name])
        elif name in PRIMARY:
            self._cores[PRIMARY[name]] = getattr(row, "PI", 0)
        elif name == "ATT":
            self._active = getattr(row, "AEKF", self._active)
        elif name == "PARM" and row.Name in TYPE_NAMES:
            self._presumed = int(row.Value)
        elif name == "GPS" and not getattr(row, "I", 0):
            self._take_satellites(row)
        elif name == "ORGN" and row.Type == EKF_ORIGIN:
            self._origin = row
        elif name == "POS" and (row.Lat, row.Lng) != (0.0, 0.0):
            yield from self._placed_at(boot_ms, row)

    @property
    def _flown_by(self) -> int:
        return self._presumed if self._active is None else self._active

    def _estimated(self, boot_ms: int, row: Any, estimate: int, core: int) -> _Made:
        """A row of one estimate, which may not be the one flown by."""
        if getattr(row, "C", core) != self._cores.get(estimate, 0):
            return
        self._v_ned[estimate] = (row.VN, row.VE, row.VD)
        sure = self._named or not self._has_global
        if estimate == self._flown_by and estimate in EKFS and sure:
            self._placed = True
            yield "LOCAL_POSITION_NED", _local(boot_ms, (row.PN, row.PE, row.PD), self._v_ned[estimate])

    def _take_satellites(self, row: Any) -> None:
        """The speed that DCM tells (AP_AHRS_DCM::get_velocity_NED), while there is a fix."""
        self._v_ned.pop(DCM, None)
        if row.Status >= FIX_3D:
            course = math.radians(row.GCrs)
            self._v_ned[DCM] = (row.Spd * math.cos(course), row.Spd * math.sin(course), getattr(row, "VZ", 0.0))

    def _placed_at(self, boot_ms: int, row: Any) -> _Made:
        v_ned = self._v_ned.get(self._flown_by, self._v_ned.get(DCM))
        if self._origin is not None and v_ned is not None and not self._placed:
            yield "LOCAL_POSITION_NED", _local(boot_ms, _from_origin(self._origin, row), v_ned)
        self._placed = False
        speeds = (round(100.0 * axis) for axis in v_ned or (0.0, 0.0, 0.0))
        yield (
            "GLOBAL_POSITION_INT",
            {
                "time_boot_ms": boot_ms,
                "lat": round(1e7 * row.Lat),
                "lon": round(1e7 * row.Lng),
                "alt": round(1e3 * row.Alt),
                "relative_alt": round(1e3 * getattr(row, "RelHomeAlt", getattr(row, "RelAlt", 0.0))),
                **dict(zip(("vx", "vy", "vz"), speeds, strict=True)),
                "hdg": 65535,
            },
        )


def _first(reader: Any, name: str) -> Any:
    """The first row of a type, or None."""
    reader.rewind()
    row = reader.recv_match(type=name, strict=True)
    reader.rewind()
    return row


def _from_origin(origin: Any, row: Any) -> _Ned:
    """Place of POS, NED from the origin, m (Location::get_distance_NED)."""
    scale = max(math.cos(math.radians(0.5 * (origin.Lat + row.Lat))), _LEAST_SCALE)
    north_m = _M_PER_DEG * (row.Lat - origin.Lat)
    east_m = _M_PER_DEG * scale * half_turn_deg(row.Lng - origin.Lng)
    above_m = getattr(row, "RelOriginAlt", math.nan)
    return north_m, east_m, origin.Alt - row.Alt if math.isnan(above_m) else -above_m


def _local(boot_ms: int, p_ned: _Ned, v_ned: _Ned) -> dict[str, Any]:
    axes = ("x", "y", "z", "vx", "vy", "vz")
    return {"time_boot_ms": boot_ms, **dict(zip(axes, (*p_ned, *v_ned), strict=True))}
