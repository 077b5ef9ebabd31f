"""Real autopilots in their own simulators: ArduCopters where SKYTENDER_ARDUCOPTER names one, PX4s (SIH) where
SKYTENDER_PX4 names a build; and where they truly are."""

from __future__ import annotations

import os
import select
import socket
import threading
import time
from collections import defaultdict
from pathlib import Path
from typing import Any, Self

import numpy as np
import pymap3d
from ports import free_port
from pymavlink.dialects.v20 import ardupilotmega as mav

ARDUCOPTER = os.environ.get("SKYTENDER_ARDUCOPTER", "")
PX4 = os.environ.get("SKYTENDER_PX4", "")
DEFAULTS = Path("Tools", "autotest", "default_params", "copter.parm")
ORIGIN = (47.397742, 8.545594, 488.0)
PX4_PORT = 14549
"""Where every PX4 speaks to whose number is above 9; it knows no other way to be told."""
PX4_SECOND_PORT = 14550
"""Where every PX4 speaks to on its second link."""
FIRST_PX4 = 11
TRUTH_EVERY_US = 50_000


def defaults() -> Path:
    """The parameters that ArduPilot's own tests start with."""
    named = os.environ.get("SKYTENDER_ARDUCOPTER_DEFAULTS")
    known = [Path(named)] if named else [folder / DEFAULTS for folder in Path(ARDUCOPTER).resolve().parents]
    known += [folder / "ardupilot" / DEFAULTS for folder in Path(ARDUCOPTER).resolve().parents]
    found = next((path for path in known if path.is_file()), None)
    assert found is not None, f"no {DEFAULTS} around {ARDUCOPTER}: name it with SKYTENDER_ARDUCOPTER_DEFAULTS"
    return found.resolve()


def simulator(
    kind: str, sysid: int, port: int, folder: Path, east_m: float, speed: float, second: str = "none"
) -> list[str]:
    """Command of an `arducopter` that speaks to a port of this machine, or a `px4`, which has its own; each stands
    `east_m` east of ORIGIN, and has a new folder. `second`: where an ArduCopter's second link leads."""
    folder.mkdir()
    home = tuple(float(x) for x in pymap3d.ned2geodetic(0.0, east_m, 0.0, *ORIGIN))
    of_its_kind = _px4(sysid, home, speed) if kind == "px4" else _arducopter(sysid, port, home, speed, second)
    return ["env", "-C", str(folder), *of_its_kind]


def _arducopter(sysid: int, port: int, home: tuple[float, ...], speed: float, second: str) -> list[str]:
    lat, lon, alt = home
    return [
        ARDUCOPTER, "-w", "--model", "quad", "--speedup", f"{speed:g}", "--slave", "0",
        "--sysid", str(sysid), "-I", str(20 + sysid), "--defaults", str(defaults()),
        "--home", f"{lat:.7f},{lon:.7f},{alt:.2f},0", "--sim-address", "127.0.0.1", "--rc-in-port", str(free_port()),
        "--serial0", f"udpclient:127.0.0.1:{port}", "--serial1", second, "--serial2", "none",
    ]  # fmt: skip


def _px4(sysid: int, home: tuple[float, ...], speed: float) -> list[str]:
    names = {"PX4_SIM_MODEL": "sihsim_quadx", "PX4_SIM_SPEED_FACTOR": speed}
    names |= dict(zip(("PX4_HOME_LAT", "PX4_HOME_LON", "PX4_HOME_ALT"), home, strict=True))
    return [*(f"{name}={value}" for name, value in names.items()), f"{PX4}/bin/px4", "-d", "-i", str(sysid - 1),
            f"{PX4}/etc"]  # fmt: skip


class TrueWays(threading.Thread):
    """True places of all that speak to a port of this machine, NED of ORIGIN, with the wall time at which they came.

    It asks each for what its simulator knows (SIM_STATE, HIL_STATE_QUATERNION), and is no ground station to them: it
    says no HEARTBEAT.
    """

    def __init__(self, port: int) -> None:
        super().__init__(daemon=True)
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("127.0.0.1", port))
        self.port = int(self._socket.getsockname()[1])
        self._rows: dict[int, list[tuple[float, float, float, float]]] = defaultdict(list)
        self._ended = threading.Event()

    def __enter__(self) -> Self:
        self.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ended.set()
        self.join()
        self._socket.close()

    def run(self) -> None:
        link = mav.MAVLink(None, 254, 191)
        link.robust_parsing = True
        while not self._ended.is_set():
            if not select.select([self._socket], [], [], 0.1)[0]:
                continue
            data, address = self._socket.recvfrom(65536)
            now_s = time.monotonic()
            for m in link.parse_buffer(data) or []:
                kind, sysid = m.get_type(), m.get_srcSystem()
                if kind == "HEARTBEAT" and m.get_srcComponent() == 1:
                    arducopter = m.autopilot == mav.MAV_AUTOPILOT_ARDUPILOTMEGA
                    self._ask(link, sysid, address, 108 if arducopter else 115)
                elif kind == "SIM_STATE":
                    self._keep(now_s, sysid, m.lat_int / 1e7, m.lon_int / 1e7, m.alt)
                elif kind == "HIL_STATE_QUATERNION":
                    self._keep(now_s, sysid, m.lat / 1e7, m.lon / 1e7, m.alt / 1e3)

    def read(self) -> tuple[np.ndarray, np.ndarray]:
        """Common times, each 0.02 s, s of time.monotonic, (n,); places then, m, (vehicles, n, 3), by rising id."""
        found = [np.array(self._rows[sysid]) for sysid in sorted(self._rows)]
        times = np.arange(max(one[0, 0] for one in found), min(one[-1, 0] for one in found), 0.02)
        return times, np.array(
            [[np.interp(times, one[:, 0], one[:, 1 + i]) for i in range(3)] for one in found]
        ).swapaxes(1, 2)

    def _ask(self, link: Any, sysid: int, address: tuple[str, int], msgid: int) -> None:
        wanted = (msgid, TRUTH_EVERY_US, 0, 0, 0, 0, 0)
        asks = mav.MAVLink_command_long_message(sysid, 1, mav.MAV_CMD_SET_MESSAGE_INTERVAL, 0, *wanted)
        self._socket.sendto(asks.pack(link), address)

    def _keep(self, now_s: float, sysid: int, lat_deg: float, lon_deg: float, alt_m: float) -> None:
        self._rows[sysid].append((now_s, *map(float, pymap3d.geodetic2ned(lat_deg, lon_deg, alt_m, *ORIGIN))))
