"""A session's own vehicles, ordered of its hatch: as soon as there is a link to answer on, so that they come up while
the supervisor is still being loaded."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from gcs.link.link import Key
from gcs.link.lockstep import LockstepLink
from gcs.mavlink.ids import AUTOPILOT, TRAFFIC
from gcs.processes.hatch import Hatch, ProcessSpec
from gcs.processes.vehicles import traffic_order, vehicle_orders
from gcs.scenario.model import Scenario


class Ordered(NamedTuple):
    """Orders that a hatch has been given, and the link on which their processes are to answer."""

    link: LockstepLink
    orders: list[ProcessSpec]


def own_keys(scenario: Scenario) -> list[Key]:
    """The vehicles, and the traffic, that a session starts itself."""
    keys = [(vehicle.sysid, AUTOPILOT) for vehicle in scenario.vehicles.launched]
    return [*keys, TRAFFIC] if scenario.traffic else keys


def make_link(scenario: Scenario, drop: float) -> LockstepLink:
    """The link of a session's own vehicles; drop: the share of datagrams to lose, for tests. Raises OSError."""
    lockstep = scenario.clock.mode == "lockstep"
    return LockstepLink(drop=drop, seed=scenario.seed, unpaced=lockstep)


def order(scenario: Scenario, folder: Path, link: LockstepLink, hatch: Hatch | None) -> Ordered:
    """Write the files of what a scenario launches, and have the hatch start it. Raises OSError."""
    connection = ("--supervised", f"udpout:{link.host}:{link.port}")
    orders = vehicle_orders(scenario, folder, connection, per_process=scenario.vehicles_per_process)
    if scenario.traffic:
        orders.append(traffic_order(scenario, folder, connection))
    if hatch is not None:
        hatch.start(orders, link.secret)
    return Ordered(link, orders)


def order_early(scenario: Scenario, folder: Path, drop: float, hatch: Hatch) -> Ordered | None:
    """The same with a link of its own; None where that cannot be: the session tries again, and says why."""
    try:
        link = make_link(scenario, drop)
    except OSError:
        return None
    try:
        return order(scenario, folder, link, hatch)
    except OSError:
        link.close()
        return None
