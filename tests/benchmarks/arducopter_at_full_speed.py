"""How fast a real ArduCopter simulates itself, where one is named: SKYTENDER_ARDUCOPTER=/path/to/bin/arducopter.

It is a whole autopilot with estimator and sensors at 400 Hz, ours a law and its rigid body: a scale, not a contest.
"""

from __future__ import annotations

import os
import socket
import subprocess
import tempfile
import time

from measure import cpu_s_of
from pymavlink.dialects.v20 import common as mav

PROGRAM = os.environ.get("SKYTENDER_ARDUCOPTER", "")
MEASURED_S, PATIENCE_S = 5.0, 30.0
SPEEDUP = 1000
"""More than it can hold, so that it never waits."""


def vehicle_seconds() -> float | None:
    """Vehicle-seconds per CPU second, of one that stands on the ground with its control and its model running; None
    where no program is named. Raises RuntimeError where it does not tell its time."""
    if not PROGRAM:
        return None
    with (
        tempfile.TemporaryDirectory() as folder,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as ground,
    ):
        ground.bind(("127.0.0.1", 0))
        ground.settimeout(1.0)
        options = ["-w", "--model", "quad", "--speedup", str(SPEEDUP), "--slave", "0", "--sim-address", "127.0.0.1"]
        options += ["--serial0", f"udpclient:127.0.0.1:{ground.getsockname()[1]}", "--serial1", "none"]
        quiet = subprocess.DEVNULL
        with subprocess.Popen(
            [PROGRAM, *options, "--serial2", "none"], cwd=folder, stdin=quiet, stdout=quiet, stderr=quiet
        ) as copter:
            try:
                begun_s, spent_s = _boot_s(ground), cpu_s_of(copter.pid)
                until_s = time.monotonic() + MEASURED_S
                while (now_s := _boot_s(ground)) <= begun_s or time.monotonic() < until_s:
                    pass
                return (now_s - begun_s) / (cpu_s_of(copter.pid) - spent_s)
            finally:
                copter.kill()


def _boot_s(ground: socket.socket) -> float:
    """Its time since its boot, asked for until it tells it."""
    link = mav.MAVLink(None, srcSystem=255)
    link.robust_parsing = True
    deadline_s = time.monotonic() + PATIENCE_S
    while time.monotonic() < deadline_s:
        try:
            datagram, vehicle = ground.recvfrom(65535)
        except TimeoutError:
            continue
        told = link.parse_buffer(datagram) or []
        for message in told:
            if message.get_type() == "SYSTEM_TIME":
                return float(message.time_boot_ms) / 1e3
        if any(message.get_type() == "HEARTBEAT" for message in told):
            wanted = (mav.MAVLINK_MSG_ID_SYSTEM_TIME, 1e5, 0, 0, 0, 0, 0)
            ask = link.command_long_encode(1, 1, mav.MAV_CMD_SET_MESSAGE_INTERVAL, 0, *wanted)
            ground.sendto(ask.pack(link), vehicle)
    raise RuntimeError(f"{PROGRAM} does not tell its SYSTEM_TIME")
