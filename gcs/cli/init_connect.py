"""A scenario from the vehicles that are received at an address: `gcs init --connect`."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import pymap3d

from gcs.cli.fleet_options import fleet_at
from gcs.cli.options import Refused
from gcs.mavlink.ids import STATION
from gcs.mavlink.parameters.client import ParameterClient
from gcs.scenario.endpoint import Endpoint

if TYPE_CHECKING:
    from gcs.link.fleet_client import FleetClient

REPORTED_WITHIN_S = 8.0
CAPACITIES = ("SIM_BAT_CAP_J", "BATT_CAPACITY", "BAT1_CAPACITY")
"""Joules of a simulated vehicle of ours; mAh of ArduPilot; mAh of PX4."""
GUESS_J = 200_000
LEAST_MAH, J_PER_MAH_V = 10.0, 3.6
HEIGHT_M = 5.0
MESSAGES = ("HOME_POSITION", "GLOBAL_POSITION_INT", "SYS_STATUS")


def scenario(at: Endpoint, name: str, station: tuple[int, int]) -> str:
    """The scenario as YAML: each vehicle hovers above its home. `station`: our ids, which the scenario gets too where
    they are not the default ones. Raises click.ClickException where no vehicle is received, or none reports a
    position."""
    with fleet_at(at, station) as fleet:
        told = fleet.request(MESSAGES, REPORTED_WITHIN_S)
        capacities = {sysid: _capacity(fleet, sysid, messages) for sysid, messages in sorted(told.items())}
    homes = {sysid: home for sysid, messages in sorted(told.items()) if (home := _home(messages)) is not None}
    silent = sorted(told.keys() - homes.keys())
    if not homes:
        raise Refused(f"vehicle {', '.join(map(str, silent))} does not say where it is yet: wait for its GPS")
    first, (lat, lon, alt) = next(iter(homes.items()))
    lines = [
        f"# Vehicles heard at {at.text}. Next: gcs check, gcs validate, then gcs run",
        "schema: 1",
        f"name: {name}",
        "axes: ned",
        f"origin: {{lat_deg: {lat:.7f}, lon_deg: {lon:.7f}, alt_m: {alt:.2f}}}  # home of vehicle {first}",
        "clock: {mode: real, speed: 1}",
        "goal: {duration_s: 60}",
        *([] if station == STATION else [f"station: {{sysid: {station[0]}, compid: {station[1]}}}"]),
        "vehicles:",
        "  pursuers:",
    ]
    for sysid, home in homes.items():
        capacity_j, why = capacities[sysid]
        north, east, down = (float(x) for x in pymap3d.geodetic2ned(*home, lat, lon, alt))
        point = ", ".join(f"{x:.1f}" for x in (north, east, down - HEIGHT_M))
        lines.append(f'    - external: {{connect: "{at.text}", sysid: {sysid}, capacity_j: {capacity_j}}}  # {why}')
        lines.append(f"      waypoints_m: [[{point}]]  # {HEIGHT_M:g} m above its home")
    lines += [f"    # vehicle {sysid} is left out: it does not say where it is yet" for sysid in silent]
    return "\n".join(lines) + "\n"


def _home(messages: dict[str, Any]) -> tuple[float, float, float] | None:
    """Latitude and longitude, deg, and altitude, m, of a vehicle's home, else of where it stands."""
    home, here = messages.get("HOME_POSITION"), messages.get("GLOBAL_POSITION_INT")
    if home is not None and (home.latitude or home.longitude):
        return 1e-7 * home.latitude, 1e-7 * home.longitude, 1e-3 * home.altitude
    if here is not None and (here.lat or here.lon):
        return 1e-7 * here.lat, 1e-7 * here.lon, 1e-3 * here.alt
    return None


def _capacity(fleet: FleetClient, sysid: int, messages: dict[str, Any]) -> tuple[int, str]:
    """Capacity of its battery, J, and how that is known."""
    client = ParameterClient(sysid, 1, fleet.profiles[sysid])
    client.read(CAPACITIES)
    fleet.converse([client])
    known = {name: value.number for name, value in client.known.items() if math.isfinite(value.number)}
    kind = fleet.profiles[sysid].name
    if known.get(CAPACITIES[0], 0.0) >= 1.0:
        return round(known[CAPACITIES[0]]), f"{kind}; its {CAPACITIES[0]}"
    status = messages.get("SYS_STATUS")
    volts = 1e-3 * status.voltage_battery if status is not None and 0 < status.voltage_battery < 65535 else 0.0
    for name in CAPACITIES[1:]:
        if known.get(name, 0.0) >= LEAST_MAH and volts > 1.0:
            capacity_j = round(known[name] * J_PER_MAH_V * volts)
            return capacity_j, f"{kind}; its {name}, {known[name]:.0f} mAh, at {volts:.1f} V"
    return GUESS_J, f"{kind}; capacity_j is a guess: it does not say; put in mAh times V times 3.6"
