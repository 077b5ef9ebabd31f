"""A swarm of our vehicles without a station, and the radio between them."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from typing import Any

import numpy as np

from simvehicle.autopilot.body import Start
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.identity import IDENTITIES
from simvehicle.autopilot.modes import Trigger
from simvehicle.autopilot.parameters import Parameters
from simvehicle.autopilot.vectors import Vec3
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.fleet.separation import Separation
from simvehicle.fleet.separation_rules import SeparationRules, read_separation
from simvehicle.mavlink.codec import ReceivedFrame, split
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.dispatcher import Services

FRAME = LocalFrame(47.0, 8.0, 400.0)
PERIOD_MS, SEPARATION_M = 100, 0.8
PLAN = {"level_after_s": 8.0, "down_after_s": 16.0, "again_after_s": 40.0, "descend_m": 5.0}


Radio = Callable[[int, int, float], bool]


def rules_of(
    homes: dict[int, Vec3], heights_m: dict[int, float], times: dict[str, float] | None = None, **changed: Any
) -> SeparationRules:
    """As a file has them; `times` of the timetable other than PLAN's."""
    members = [
        {
            "sysid": sysid,
            "speed_m_s": 5.0,
            "acceleration_m_s2": 4.0,
            "home_ned": list(home),
            "failsafe": {"altitude_m": heights_m[sysid], **PLAN, **(times or {})},
        }
        for sysid, home in homes.items()
    ]
    content = {
        "period_s": PERIOD_MS / 1e3,
        "separation_m": SEPARATION_M,
        "clearance_m": 0.2,
        "vehicles": members,
        "obstacles": [],
    }
    return read_separation(content | changed, homes)


class Swarm:
    """Vehicles, each with its services, and a radio between them: `passes` decides about each frame by its sender, its
    reader and the time in s."""

    def __init__(
        self, starts: dict[int, Vec3], rules: SeparationRules, passes: Radio, *, up: bool = False, delay: int = 0
    ) -> None:
        """`up`: they hover at their starts, over homes that are elsewhere. `delay`: of the radio, in periods."""
        self.passes, self.delay = passes, delay
        self.vehicles, self._services, self._connections = {}, {}, {}
        self._sent: list[dict[int, list[ReceivedFrame]]] = []
        self.least_m = math.inf
        for sysid, start in starts.items():
            parameters = Parameters({"RTL_RETURN_ALT": rules.vehicles[sysid].failsafe.altitude_m})
            vehicle = self.vehicles[sysid] = Vehicle(IDENTITIES["px4"], parameters, FRAME, Start(start, airborne=up))
            vehicle.period_s, vehicle.separation = rules.period_s, Separation(vehicle, sysid, rules)
            connection = self._connections[sysid] = Connection(sysid)
            self._services[sysid] = Services(vehicle, sysid, [connection])
            vehicle.set_clock(0, 0)
            vehicle.receive_gcs_heartbeat()
            if up:
                vehicle.home_ned = rules.vehicles[sysid].home_ned
                vehicle.trigger(Trigger.HOLD)
                continue
            vehicle.trigger(Trigger.ARM)
            vehicle.take_off(3.0)

    def receive(self, sysid: int, frame: ReceivedFrame) -> None:
        """Hand a vehicle a frame, of a sender that is no vehicle."""
        self._services[sysid].receive(frame, self._connections[sysid])

    def fly(self, until_s: float, each: Callable[[float], None] = lambda _: None) -> None:
        """Up to a time; `each` is called before every tick."""
        time_ms = next(iter(self.vehicles.values())).time_ms
        while time_ms < 1e3 * until_s:
            each(time_ms / 1e3)
            for reader, services in self._services.items():
                arriving = self._sent[-1 - self.delay] if len(self._sent) > self.delay else {}
                for sender, frames in arriving.items():
                    for frame in frames if sender != reader else ():
                        if self.passes(sender, reader, time_ms / 1e3):
                            services.receive(frame, self._connections[reader])
            time_ms += PERIOD_MS
            self._sent.append({})
            for sysid, services in self._services.items():
                self.vehicles[sysid].advance(time_ms)
                services.decide()
                services.report()
                self._sent[-1][sysid] = split(b"".join(self._connections[sysid].frames()))
            self._measure()

    def _measure(self) -> None:
        places = [np.array(vehicle.true_motion_ned[:3]) for vehicle in self.vehicles.values()]
        for a, b in itertools.combinations(places, 2):
            if min(a[2], b[2]) < -0.05:
                self.least_m = min(self.least_m, float(np.linalg.norm(a - b)))
