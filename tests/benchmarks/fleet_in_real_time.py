"""The fleet's session in a process of its own: `gcs.session.process` with two watchers, of late ticks and of CPU time.

python fleet_in_real_time.py FOLDER
"""

from __future__ import annotations

import json
import os
import sys
import time
from pathlib import Path

from measure import cpu_s_of, used_cpu_s
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.processes.pace import Pace
from gcs.scenario.file import load
from gcs.session.own_vehicles import OwnVehicles
from gcs.session.session_process import SessionProcess

HOT = ("HEARTBEAT", "LOCAL_POSITION_NED", "ATTITUDE", "GLOBAL_POSITION_INT", "BATTERY_STATUS", "NAMED_VALUE_FLOAT")
PERIOD_US = 100_000.0


class WatchedPace(Pace):
    """Remembers the latest tick."""

    latest_s = 0.0

    def next(self, period_s: float) -> int:
        before_s = self.lag_s
        periods = super().next(period_s)
        self.latest_s = max(self.latest_s, self.lag_s - before_s)
        return periods


class Watched(SessionProcess):
    """Asks every vehicle for the hot messages at 10 Hz, and measures the flight."""

    def _fly(self) -> None:
        self._pace = pace = WatchedPace(1.0, time.monotonic)
        for sysid in self._supervisor.arming:
            for name in HOT:
                request = codec.message(
                    "COMMAND_LONG", target_system=sysid, target_component=1,
                    command=mav.MAV_CMD_SET_MESSAGE_INTERVAL, confirmation=0, param1=float(codec.msgid(name)),
                    param2=PERIOD_US, param3=0.0, param4=0.0, param5=0.0, param6=0.0, param7=0.0,
                )  # fmt: skip
                self._supervisor.command_queue.put(sysid, [request])
        self._vehicles.ended()
        pids = list(self._vehicles.pids)
        own, theirs, wall_s = used_cpu_s(), sum(map(cpu_s_of, pids)), time.monotonic()
        super()._fly()
        wall_s = time.monotonic() - wall_s
        self.told = {
            "latest_s": pace.latest_s,
            "frames_s": self._supervisor.received / self._supervisor.time_s,
            "supervisor_cpu_s": used_cpu_s() - own,
            "vehicles_cpu_s": sum(map(cpu_s_of, pids)) - theirs,
        }
        self.told["supervisor"] = self.told["supervisor_cpu_s"] / wall_s
        self.told["vehicles"] = self.told["vehicles_cpu_s"] / wall_s


if __name__ == "__main__":
    os.set_blocking(0, False)
    folder = Path(sys.argv[1])
    scenario = load(folder / "scenario.yaml")
    session = Watched(folder, scenario, OwnVehicles(scenario, folder))
    session.run()
    print(json.dumps(session.told))
