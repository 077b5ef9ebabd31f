"""A real PX4 as a process: its parameters, ports and start scripts (docs/protocol/autopilots.md#px4).

PX4 starts by a shell script that looks for parts of it on PATH first, which is its own way to be configured: three
stand in its folder, its parameters, its simulation and its MAVLink. From 1.16 on it reads no script of parameters, but
variables of its environment, which older ones pass over: each gets both. Its instance number gives it the port of its
simulation and that of its MAVLink, PX4's own ones, and in 1.17 its system id, whatever its environment says: so the
script of its simulation sets that, before any part of it has asked.
"""

from __future__ import annotations

import contextlib
import fcntl
import os
import socket
from pathlib import Path

from simvehicle.sitl.autopilot_process import (
    HOST,
    MOST_INSTANCES,
    AutopilotError,
    AutopilotProcess,
    AutopilotWanted,
)
from simvehicle.sitl.settings import Setting, given
from skytender.processes import environment_for_programs

SIMULATION_PORT, MAVLINK_PORT = 4560, 18570
LOCK = "/tmp/px4_lock"
"""How the names of PX4's locks begin."""
MODEL = "none_iris"
"""Airframe of PX4's for a simulation that it does not start: four rotors, numbered as ours."""
SETTINGS = (
    Setting("THR_MDL_FAC", 1.0),
    Setting("SIM_BAT_ENABLE", 0.0, until="1.17"),
    Setting("SIM_BAT_DRAIN", 0.0, since="1.18"),
    Setting("COM_LOW_BAT_ACT", 0.0),
    Setting("COM_RC_IN_MODE", 4.0),
    Setting("NAV_DLL_ACT", 0.0),
    Setting("EKF2_GPS_DELAY", 0.0, until="1.17"),
    Setting("SENS_GPS0_DELAY", 0.0, since="1.18"),
    Setting("SENS_GPS1_DELAY", 0.0, since="1.18"),
    Setting("EKF2_MULTI_IMU", 1.0),
    Setting("SDLOG_MODE", -1.0, until="1.16"),
    Setting("SDLOG_BACKEND", 0.0, since="1.17"),
    Setting("SYS_FAILURE_EN", 1.0),
)
"""Parameters that it starts with [choice]: thrust by the throttle squared, a battery that is ours and no flight home
by itself when it is low, in no want of a transmitter, GNSS without delay, one estimator in place of three, no log on
disk. Each version passes over names that it does not have."""


def simulation_port() -> tuple[socket.socket, int]:
    """A socket that listens where a PX4 of some instance number looks for its simulation, and that number: the first
    that is not in use. Raises AutopilotError."""
    for instance in range(MOST_INSTANCES):
        tcp = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
        try:
            tcp.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            tcp.bind((HOST, SIMULATION_PORT + instance))
            tcp.listen(1)
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as udp:
                udp.bind((HOST, MAVLINK_PORT + instance))
            if not _runs(instance):
                return tcp, instance
        except OSError:
            pass
        tcp.close()
    raise AutopilotError(
        f"no ports are free for an autopilot: TCP {SIMULATION_PORT}, UDP {MAVLINK_PORT}, and those after them"
    )


def _runs(instance: int) -> bool:
    """Whether a PX4 of that number lives on this machine: it holds a lock on a file."""
    with contextlib.suppress(FileNotFoundError), open(f"{LOCK}-{instance}", "r+b") as file:
        try:
            fcntl.lockf(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            return True
        fcntl.lockf(file, fcntl.LOCK_UN)
    return False


def program_of(path: Path) -> tuple[Path, Path]:
    """The program and its folder of start scripts, by a build's folder or by the program in it. Raises
    AutopilotError."""
    program = path / "bin" / "px4" if path.is_dir() else path
    scripts = program.resolve().parents[1] / "etc"
    if not program.is_file():
        raise AutopilotError(f"the autopilot {path} cannot be started: there is no {program}")
    if not (scripts / "init.d-posix" / "rcS").is_file():
        raise AutopilotError(f"the autopilot {path} is no build of PX4's for simulation: there is no {scripts}")
    return program.resolve(), scripts


def start_px4(wanted: AutopilotWanted, instance: int, *, hover_throttle: float, port: int) -> AutopilotProcess:
    """Start it: its MAVLink goes from its own UDP port to `port`. `hover_throttle`: share of the greatest thrust at
    which it hovers. Raises AutopilotError."""
    program, scripts = program_of(wanted.program)
    values = {**given(SETTINGS), "MPC_THR_HOVER": hover_throttle, **wanted.parameters}
    said = {name: f"{value:.9g}" for name, value in values.items()}
    lines = [f"param set {name} {value}\n" for name, value in said.items()]
    (wanted.folder / "px4-rc.params").write_text("".join(lines), encoding="utf-8")
    mavlink = f"mavlink start -x -u {MAVLINK_PORT + instance} -o {port} -t {HOST} -r 4000000\n"
    (wanted.folder / "px4-rc.mavlink").write_text(mavlink, encoding="utf-8")
    simulator = f"param set MAV_SYS_ID {wanted.sysid}\n. etc/init.d-posix/px4-rc.simulator\n"
    (wanted.folder / "px4-rc.simulator").write_text(simulator, encoding="utf-8")
    kept = {name: value for name, value in environment_for_programs().items() if not name.startswith("PX4_")}
    path = f".{os.pathsep}{kept.get('PATH', os.defpath)}"
    environment = {**kept, "PATH": path, "PX4_SIM_MODEL": MODEL, "PX4_SIM_HOSTNAME": HOST}
    environment |= {f"PX4_PARAM_{name}": value for name, value in said.items()}
    return AutopilotProcess(wanted, [str(program), "-i", str(instance), "-d", str(scripts)], environment)
