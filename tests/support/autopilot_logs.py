"""Logs of a flight in a circle as ArduPilot and PX4 write them, byte by byte after their descriptions: AP_Logger's
LogStructure.h, and https://docs.px4.io/main/en/dev_log/ulog_file_format.html."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Literal, NamedTuple

LAT_DEG, LON_DEG, ALT_M = 47.397742, 8.545594, 488.0
RADIUS_M, SPEED_M_S, HEIGHT_M = 20.0, 4.0, 10.0
SECONDS, RATE_HZ = 12, 10
START_US = 40_000_000
"""since the autopilot's start"""
UTC_US = 1_767_225_600_000_000
RATES_RAD_S = (0.01, -0.02, SPEED_M_S / RADIUS_M)
LONG_TEXT = "PreArm: battery 1 below minimum arming voltage, compasses off"


class Moment(NamedTuple):
    """Where the vehicle is, NED, m, m/s, rad."""

    t_us: int
    p_ned: tuple[float, float, float]
    v_ned: tuple[float, float, float]
    yaw_rad: float


def moments() -> Iterator[Moment]:
    for k in range(SECONDS * RATE_HZ):
        angle = SPEED_M_S / RADIUS_M * k / RATE_HZ
        place = (RADIUS_M * math.cos(angle), RADIUS_M * math.sin(angle), -HEIGHT_M)
        speed = (-SPEED_M_S * math.sin(angle), SPEED_M_S * math.cos(angle), 0.0)
        yaw_rad = math.remainder(angle + math.pi / 2.0, 2.0 * math.pi)
        yield Moment(START_US + 1_000_000 * k // RATE_HZ, place, speed, yaw_rad)


def _globe(p_ned: tuple[float, float, float]) -> tuple[float, float]:
    north, east = (math.degrees(axis / 6_378_137.0) for axis in p_ned[:2])
    return LAT_DEG + north, LON_DEG + east / math.cos(math.radians(LAT_DEG))


_DATAFLASH = {
    "FMT": (128, "BBnNZ", "Type,Length,Name,Format,Columns"),
    "PARM": (64, "QNf", "TimeUS,Name,Value"),
    "MSG": (91, "QZ", "TimeUS,Message"),
    "MODE": (98, "QMBB", "TimeUS,Mode,ModeNum,Rsn"),
    "EV": (85, "QB", "TimeUS,Id"),
    "GPS": (135, "QBBIHBcLLeffffB", "TimeUS,I,Status,GMS,GWk,NSats,HDop,Lat,Lng,Alt,Spd,GCrs,VZ,Yaw,U"),
    "ORGN": (153, "QBLLe", "TimeUS,Type,Lat,Lng,Alt"),
    "XKF1": (200, "QBffffff", "TimeUS,C,PN,PE,PD,VN,VE,VD"),
    "XKF4": (203, "QBb", "TimeUS,C,PI"),
    "NKF1": (204, "Qffffff", "TimeUS,PN,PE,PD,VN,VE,VD"),
    "NKF4": (205, "Qb", "TimeUS,PI"),
    "NKF6": (206, "Qffffff", "TimeUS,PN,PE,PD,VN,VE,VD"),
    "SIM2": (207, "Qffffff", "TimeUS,PN,PE,PD,VN,VE,VD"),
    "POS": (202, "QLLef", "TimeUS,Lat,Lng,Alt,RelAlt"),
    "ATT": (201, "QccC", "TimeUS,Roll,Pitch,Yaw"),
    "IMU": (208, "QBfff", "TimeUS,I,GyrX,GyrY,GyrZ"),
    "CMD": (93, "QHHHffffLLfB", "TimeUS,CTot,CNum,CId,Prm1,Prm2,Prm3,Prm4,Lat,Lng,Alt,Frame"),
    "MISE": (94, "QHHHffffLLfB", "TimeUS,CTot,CNum,CId,Prm1,Prm2,Prm3,Prm4,Lat,Lng,Alt,Frame"),
    "FNCE": (95, "QBBBLLBf", "TimeUS,Tot,Seq,Type,Lat,Lng,Count,Radius"),
    "RALY": (96, "QBBLLh", "TimeUS,Tot,Seq,Lat,Lng,Alt"),
    "BAT": (160, "QBffffB", "TimeUS,Inst,Volt,Curr,CurrTot,EnrgTot,RemPct"),
}
_C = {"Q": "Q", "B": "B", "M": "B", "I": "I", "H": "H", "f": "f", "n": "4s", "N": "16s", "Z": "64s", "c": "h", "C": "H",
      "b": "b", "L": "i", "e": "i", "h": "h"}  # fmt: skip
_SCALE = {"c": 100.0, "C": 100.0, "e": 100.0, "L": 1e7}


def _row(name: str, *values: object, more: str = "") -> bytes:
    number, form, _ = _DATAFLASH[name]
    form += more
    sent = [
        value.encode() if isinstance(value, str) else round(value * _SCALE[kind]) if kind in _SCALE else value  # type: ignore[operator]
        for kind, value in zip(form, values, strict=True)
    ]
    return b"\xa3\x95" + bytes([number]) + struct.pack("<" + "".join(_C[kind] for kind in form), *sent)


def _listed() -> Iterator[bytes]:
    """A mission with home, a fence and a rally point, and that item 2 has been begun."""
    second = (3, 2, 16, 0.0, 0.0, 0.0, 0.0, LAT_DEG + 0.001, LON_DEG, 25.0, 10)
    yield _row("CMD", START_US, 3, 0, 16, 0.0, 0.0, 0.0, 0.0, LAT_DEG, LON_DEG, ALT_M, 0)
    yield _row("CMD", START_US, 3, 1, 22, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 10.0, 3)
    yield _row("CMD", START_US, *second)
    for seq, (lat_deg, lon_deg) in enumerate([(47.0, 8.0), (47.9, 8.0), (47.9, 8.9)]):
        yield _row("FNCE", START_US, 4, seq, 98, lat_deg, lon_deg, 3, 0.0)
    yield _row("FNCE", START_US, 4, 3, 93, LAT_DEG, LON_DEG, 0, 30.0)
    yield _row("RALY", START_US, 1, 0, 47.4, 8.55, 40)
    yield _row("MISE", START_US, *second)


def _sent_later(items: Sequence[int], count: int) -> Iterator[bytes]:
    """Items of another mission, as they are begun."""
    for number in items:
        yield _row("CMD", START_US + number, count, number, 16, 0.0, 0.0, 0.0, 0.0, LAT_DEG, LON_DEG, 30.0 + number, 3)


class Estimate(NamedTuple):
    """A row of an estimate: its core, where the row says it, and whether it tells the flight or another place."""

    row: str
    core: int | None = None
    right: bool = False

    def told(self, at: Moment) -> bytes:
        place = at.p_ned if self.right else (900.0, 900.0, 0.0)
        speed = at.v_ned if self.right else (50.0, 0.0, 0.0)
        return _row(self.row, at.t_us, *(() if self.core is None else (self.core,)), *place, *speed)


def _estimates(_: int) -> tuple[Sequence[Estimate], Mapping[str, int]]:
    return (Estimate("XKF1", 0, right=True), Estimate("XKF1", 1)), {}


def dataflash(
    path: Path,
    *,
    sysid: int = 7,
    satellites: bool = True,
    mission: bool = False,
    program: str = "ArduCopter",
    mode: int = 4,
    events: Sequence[int] = (10, 28),
    later: tuple[Sequence[int], int] | None = None,
    active: int | None = 3,
    estimates: Callable[[int], tuple[Sequence[Estimate], Mapping[str, int]]] = _estimates,
    globe: bool = True,
    parameters: Mapping[str, float] = MappingProxyType({}),
) -> None:
    """`active` is ATT's AEKF; `estimates` gives each moment's rows, and the primary core by XKF4 or NKF4."""
    out = []
    formats = dict(_DATAFLASH)
    if active is not None:
        number, form, columns = formats["ATT"]
        formats["ATT"] = (number, form + "B", columns + ",AEKF")
    for name, (number, form, columns) in formats.items():
        length = 3 + struct.calcsize("<" + "".join(_C[kind] for kind in form))
        out.append(_row("FMT", number, length, name, form, columns))
    out.append(_row("PARM", START_US, "SYSID_THISMAV", float(sysid)))
    out += [_row("PARM", START_US, name, value) for name, value in parameters.items()]
    out.append(_row("MSG", START_US, f"{program} V4.6.0 (12345678)"))
    out.append(_row("MSG", START_US, LONG_TEXT))
    if globe:
        out.append(_row("ORGN", START_US, 0, LAT_DEG, LON_DEG, ALT_M))
    out += [_row("MODE", START_US, mode, mode, 1), *(_row("EV", START_US, event) for event in events)]
    out += _listed() if mission else ()
    out += _sent_later(*later) if later else ()
    week, ms = divmod((UTC_US // 1000 - 315_964_800_000 + 18_000), 7 * 86_400_000)
    for k, at in enumerate(moments()):
        since_ms = (at.t_us - START_US) // 1000
        if k % 2 == 0:
            gps = (at.t_us, 0, 3, ms + since_ms, week, 12, 0.8, LAT_DEG, LON_DEG, ALT_M + HEIGHT_M)
            if satellites:
                course_deg = math.degrees(math.atan2(at.v_ned[1], at.v_ned[0])) % 360.0
                out.append(_row("GPS", *gps, SPEED_M_S, course_deg, 0.0, 0.0, 1))
            out.append(_row("BAT", at.t_us, 0, 16.0, 20.0, 10.0 * k, 0.16 * k, 100 - k // 10))
        rows, primary = estimates(k)
        out += [_row(name, at.t_us, *((0,) if name == "XKF4" else ()), core) for name, core in primary.items()]
        out += [estimate.told(at) for estimate in rows]
        out += [_row("POS", at.t_us, *_globe(at.p_ned), ALT_M + HEIGHT_M, HEIGHT_M)] if globe else []
        out += [_row("IMU", at.t_us, number, *rates) for number, rates in enumerate((RATES_RAD_S, (9.0, 9.0, 9.0)))]
        attitude = (at.t_us, 2.0, -3.0, math.degrees(at.yaw_rad) % 360.0)
        out.append(_row("ATT", *attitude) if active is None else _row("ATT", *attitude, active, more="B"))
    path.write_bytes(b"".join(out))


_TOPICS = {
    "vehicle_local_position": (
        "uint64_t timestamp;double ref_lat;double ref_lon;float x;float y;float z;float vx;float vy;float vz;"
        "float ref_alt;bool xy_valid;bool z_valid;bool xy_global;", "<QddfffffffBBB",
    ),
    "vehicle_attitude": ("uint64_t timestamp;float[4] q;", "<Qffff"),
    "vehicle_status": ("uint64_t timestamp;uint8_t arming_state;uint8_t nav_state;uint8_t system_type;", "<QBBB"),
    "vehicle_land_detected": ("uint64_t timestamp;bool landed;", "<QB"),
    "battery_status": (
        "uint64_t timestamp;float voltage_v;float current_a;float discharged_mah;float remaining;", "<Qffff",
    ),
    "vehicle_gps_position": ("uint64_t timestamp;uint64_t time_utc_usec;", "<QQ"),
    "vehicle_global_position": ("uint64_t timestamp;double lat;double lon;float alt;", "<Qddf"),
}  # fmt: skip


def _message(kind: bytes, content: bytes) -> bytes:
    return struct.pack("<H", len(content)) + kind + content


def _parameter(key: str, value: float) -> bytes:
    packed = struct.pack("<f", value) if key.startswith("float") else struct.pack("<i", value)
    return _message(b"P", bytes([len(key)]) + key.encode() + packed)


def ulog(path: Path, *, sysid: int = 9, nav_state: int = 14, frame: Literal["local", "global"] = "local") -> None:
    out = [b"ULog\x01\x12\x35\x01" + struct.pack("<Q", START_US), _message(b"B", bytes(40))]
    out += [_message(b"F", f"{name}:{fields}".encode()) for name, (fields, _) in _TOPICS.items()]
    out += [_parameter("int32_t MAV_SYS_ID", sysid), _parameter("int32_t COM_FLTMODE1", -1)]
    out.append(_parameter("float MPC_XY_CRUISE", 5.1))
    names = list(_TOPICS)
    out += [_message(b"A", struct.pack("<BH", 0, number) + name.encode()) for number, name in enumerate(names)]

    def said(name: str, *values: object) -> None:
        out.append(_message(b"D", struct.pack("<H", names.index(name)) + struct.pack(_TOPICS[name][1], *values)))

    said("vehicle_gps_position", START_US, UTC_US)
    out.append(_message(b"L", b"6" + struct.pack("<Q", START_US) + "Ready for takeoff! 20 °C".encode()))
    out.append(_message(b"L", b"4" + struct.pack("<Q", START_US) + LONG_TEXT.encode()))
    for k, at in enumerate(moments()):
        where = (LAT_DEG, LON_DEG, *at.p_ned, *at.v_ned, ALT_M)
        if frame == "local":
            said("vehicle_local_position", at.t_us, *where, 1, 1, 1)
        else:
            said("vehicle_global_position", at.t_us, *_globe(at.p_ned), ALT_M - at.p_ned[2])
        said("vehicle_attitude", at.t_us, math.cos(at.yaw_rad / 2.0), 0.0, 0.0, math.sin(at.yaw_rad / 2.0))
        if k % RATE_HZ == 0:
            said("vehicle_land_detected", at.t_us, 0)
            said("vehicle_status", at.t_us, 2, nav_state, 2)
            said("battery_status", at.t_us, 16.0, 20.0, 10.0 * k, 1.0 - k / 1000.0)
    out.append(_parameter("int32_t COM_FLTMODE1", 4))
    path.write_bytes(b"".join(out))
