"""The vehicles that a session starts itself: the fork server's orders, and the link on which they answer.

It loads little of the station, so that vehicles come up while the rest of their supervisor is loaded.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from gcs.link.link import Key
from gcs.link.lockstep import LockstepLink
from gcs.mavlink.ids import AUTOPILOT, TRAFFIC
from gcs.processes.fork_server import Ended, ForkServer
from gcs.processes.vehicles import traffic_order, vehicle_orders
from gcs.scenario.model import Scenario


class OwnVehicles:
    """A session's own processes, from their start to their end; none where the scenario launches nothing."""

    def __init__(self, scenario: Scenario, folder: Path, drop: float = 0.0, server: ForkServer | None = None) -> None:
        """Write the files of what the scenario launches, and have it started.

        drop: the share of datagrams to lose, for tests. server: one that runs already. Raises LaunchError, OSError.
        """
        lockstep = scenario.clock.mode == "lockstep"
        self.keys: list[Key] = [(vehicle.sysid, AUTOPILOT) for vehicle in scenario.vehicles.launched]
        if scenario.traffic:
            self.keys.append(TRAFFIC)
        self.server = (server or ForkServer.of_vehicles()) if self.keys else None
        self.link = LockstepLink(drop=drop, seed=scenario.seed, unpaced=lockstep)
        connection = ("--supervised", f"udpout:{self.link.host}:{self.link.port}")
        try:
            self.orders = vehicle_orders(scenario, folder, connection, per_process=scenario.vehicles_per_process)
            if scenario.traffic:
                self.orders.append(traffic_order(scenario, folder, connection))
        except OSError:
            self.end()
            self.link.close()
            raise
        if self.server is not None:
            self.server.start([order.order(self.link.secret) for order in self.orders])

    @property
    def pids(self) -> Mapping[int, int]:
        """First system id of each process that runs."""
        return {} if self.server is None else self.server.pids

    def ended(self) -> list[Ended]:
        """Processes that have ended since the last call."""
        return [] if self.server is None else self.server.events()

    @property
    def died(self) -> bool:
        """Whether the fork server has died, and the vehicles with it."""
        return self.server is not None and not self.server.alive

    def end(self) -> None:
        """End all of them; returns when they are gone."""
        if self.server is not None:
            self.server.close()
