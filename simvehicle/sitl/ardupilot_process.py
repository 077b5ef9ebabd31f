"""A real ArduPilot as a process: its parameters, ports and flags (docs/protocol/autopilots.md#autopilots-of-others)."""

from __future__ import annotations

import socket

from simvehicle.mavlink.real_autopilots.analog_battery import DEFAULTS
from simvehicle.sitl.autopilot_process import (
    HOST,
    MOST_INSTANCES,
    AutopilotError,
    AutopilotProcess,
    AutopilotWanted,
)
from simvehicle.sitl.settings import Setting, given
from skytender.processes import environment_for_programs

JSON_PORT, SERIAL_PORT, APART = 9002, 5760, 10
STEP_MS = 5
"""[choice] It flew at 200, 250 and 400 Hz; each step is an exchange between two processes."""
_OF_ALL: dict[str, float] = {
    "FRAME_CLASS": 1,
    "FRAME_TYPE": 1,
    "AHRS_EKF_TYPE": 3,  # from 4.7 on it flies on the simulation's truth where its clock is its simulation's
    "SCHED_LOOP_RATE": 1000 // (2 * STEP_MS),  # 4.6 wants 1.8 samples of its gyro for each loop, and gets one a step
    "MOT_THST_EXPO": 1.0,
    "MOT_SPIN_MIN": 0.0,
    "MOT_SPIN_ARM": 0.0,
    "MOT_BAT_VOLT_MAX": 0.0,
    "BATT_MONITOR": 4,
    **DEFAULTS,
    "FS_THR_ENABLE": 0,
    "LOG_BACKEND_TYPE": 0,
    "EK3_YAW_M_NSE": 0.05,
    "EK3_GPS_CHECK": 0,
    "EK3_IMU_MASK": 1,  # all its IMUs sense the same motion: a second lane of its estimator estimates nothing else
    **{f"INS_ACC{i}OFFS_{axis}": 0.001 for i in ("", "2") for axis in "XYZ"},
    **{f"INS_ACC{i}SCAL_{axis}": 1.001 for i in ("", "2") for axis in "XYZ"},
    **{f"COMPASS_OFS{i}_{axis}": x for i in ("", "2", "3") for axis, x in zip("XYZ", (5, 13, -18), strict=True)},
    **{f"RC{i}_{end}": us for i in range(1, 5) for end, us in (("MIN", 1000), ("MAX", 2000), ("TRIM", 1500))},
    "RC3_TRIM": 1000,
}
SETTINGS = (
    *(Setting(name, value) for name, value in _OF_ALL.items()),
    Setting("GPS_TYPE", 100, until="4.5"),
    Setting("GPS1_TYPE", 100, since="4.6"),
)
"""Parameters that it starts with [choice]: calibrated, in no want of a transmitter, thrust by the throttle squared."""


def simulation_port() -> tuple[socket.socket, int]:
    """A socket where an autopilot of some instance number speaks to its simulation, and that number: the first whose
    ports are free."""
    for instance in range(MOST_INSTANCES):
        udp = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        try:
            udp.bind((HOST, JSON_PORT + APART * instance))
            with socket.socket(socket.AF_INET, socket.SOCK_STREAM) as tcp:
                tcp.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
                tcp.bind((HOST, SERIAL_PORT + APART * instance))
            return udp, instance
        except OSError:
            udp.close()
    raise AutopilotError(
        f"no ports are free for an autopilot: UDP {JSON_PORT} and TCP {SERIAL_PORT}, in steps of {APART}"
    )


def start_ardupilot(wanted: AutopilotWanted, instance: int) -> AutopilotProcess:
    """Start it. Raises AutopilotError."""
    defaults = wanted.folder / "defaults.parm"
    values = {**given(SETTINGS), **wanted.parameters}
    defaults.write_text("".join(f"{name} {value:g}\n" for name, value in values.items()), encoding="utf-8")
    place = ",".join(f"{number:.9g}" for number in wanted.home)
    argv = [
        *(str(wanted.program.resolve()), "--model", f"JSON:{HOST}", "-I", str(instance)),
        *("--home", f"{place},{wanted.yaw_deg:g}", "--defaults", str(defaults.resolve()), "-w"),
        *("--start-time", str(wanted.epoch_s), "--sysid", str(wanted.sysid)),
        *("--serial1", "none:1", "--serial2", "none:1"),
    ]
    return AutopilotProcess(wanted, argv, environment_for_programs())
