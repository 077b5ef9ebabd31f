"""Vehicles as processes: their command lines, for the fork server (docs/protocol/processes.md#processes)."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

import yaml

from gcs.mavlink.autopilots import PROFILES, Profile
from gcs.mavlink.parameters.renames import unknown_name
from gcs.planner.failsafes import failsafe_of, failsafes_of
from gcs.planner.leader_limits import acceleration_m_s2, speeds_m_s
from gcs.processes.fork_server import ProcessSpec
from gcs.refuelling.settlement import transfers_until_s
from gcs.scenario.accuracy import widest_m
from gcs.scenario.faults import COMMANDED
from gcs.scenario.model import Scenario, VehicleBase, keeps_apart
from gcs.scenario.weather import RealAutopilot
from skytender.safety.silence import Failsafe

SUPERVISED = "--supervised"
PEERS_A_TICK = 8
"""Reports of peers that a bundle holds beside everything else (docs/protocol/onboard.md#peer-reports)."""
REPORT_TICK_S, LEAST_REPORT_S = 0.1, 0.2


def vehicle_orders(
    scenario: Scenario, folder: Path, connection: Sequence[str], *, per_process: int = 1
) -> list[ProcessSpec]:
    """Commands that start what is to be launched, up to `per_process` vehicles in one process; writes their parameters.

    A block's system ids follow on each other, and all of it starts in the air or none. Whose process a fault befalls
    has one of its own. `connection` goes into argv.
    """
    blocks: list[list[VehicleBase]] = []
    failsafes = failsafes_of(scenario)
    launched = scenario.vehicles.launched
    alone = {fault.sysid for fault in scenario.faults if fault.fault in ("kill", "hang")}
    alone |= {vehicle.sysid for vehicle in launched if vehicle.real is not None}
    for vehicle in launched:
        last = blocks[-1][-1] if blocks and len(blocks[-1]) < per_process else None
        follows = last is not None and (last.sysid + 1, last.airborne) == (vehicle.sysid, vehicle.airborne)
        if follows and not alone & {vehicle.sysid - 1, vehicle.sysid}:
            blocks[-1].append(vehicle)
        else:
            blocks.append([vehicle])
    return [
        vehicle_order(block, scenario, folder, connection, failsafes)
        if block[0].real is None
        else autopilot_order(block[0], block[0].real, scenario, folder, connection)
        for block in blocks
    ]


def vehicle_order(
    block: Sequence[VehicleBase],
    scenario: Scenario,
    folder: Path,
    connection: Sequence[str],
    failsafes: Mapping[int, Failsafe],
) -> ProcessSpec:
    """Command that starts vehicles whose system ids follow on each other in one process; writes their parameters."""
    first, origin = block[0], scenario.origin
    argv = ["--sysid", str(first.sysid), *connection]
    if len(block) > 1:
        argv += ["--count", str(len(block))]
    for vehicle in block:
        params = folder / "vehicles" / f"{vehicle.sysid}.params.yaml"
        values = sorted(vehicle_parameters(vehicle, scenario, failsafes[vehicle.sysid]).items())
        params.write_text("".join(f"{name}: {value!r}\n" for name, value in values), encoding="utf-8")
        argv += [
            *("--position", _triple(vehicle.start_m)),
            *("--velocity", _triple(vehicle.velocity_m_s)),
            *("--attitude", _triple(vehicle.attitude_deg)),
            *("--params", str(params)),
        ]
        if scenario.truth:
            argv += ["--truth", str(folder / "vehicles" / f"{vehicle.sysid}.truth")]
    if any(vehicle.on_rotors for vehicle in block):
        argv += ["--world", _file_of_all("world.yaml", world, scenario, folder)]
    if scenario.competition.where == "vehicles":
        argv += ["--fleet", _file_of_all("fleet.yaml", fleet_rules, scenario, folder)]
    if keeps_apart(scenario) and SUPERVISED in connection:  # elsewhere nothing carries peers' places
        argv += ["--separation", _file_of_all("separation.json", separation_rules, scenario, folder)]
    if scenario.truth and scenario.record.truth_hz is not None:
        argv += ["--truth-hz", repr(scenario.record.truth_hz)]
    argv += ["--home", _triple((origin.lat_deg, origin.lon_deg, origin.alt_m))]
    if first.airborne:
        argv.append("--airborne")
    return ProcessSpec(
        tuple(vehicle.sysid for vehicle in block), tuple(argv), folder / "vehicles" / f"{first.sysid}.log"
    )


def autopilot_order(
    vehicle: VehicleBase, real: RealAutopilot, scenario: Scenario, folder: Path, connection: Sequence[str]
) -> ProcessSpec:
    """Command that starts a real autopilot with its physics; writes its file."""
    battery, origin, name = vehicle.battery, scenario.origin, str(vehicle.sysid)
    content = {
        "program": real.program,
        "folder": str((folder / "vehicles" / name).resolve()),
        "home": [origin.lat_deg, origin.lon_deg, origin.alt_m],
        "start_ned": list(vehicle.start_m),
        "yaw_deg": vehicle.attitude_deg[2],
        "epoch_s": int(scenario.clock.epoch.timestamp()),
        "battery": {
            "capacity_j": battery.capacity_j,
            "initial_j": battery.capacity_j * battery.initial_percent / 100.0,
            "hover_w": battery.hover_w,
            "avionics_w": battery.avionics_w,
        },
        "capture_m": scenario.refuelling.capture_m,
        "relative_speed_m_s": scenario.refuelling.relative_speed_m_s,
        "parameters": dict(vehicle.params),
        "renamed": _renamed(vehicle, PROFILES[real.kind]),
        "truth": str(folder / "vehicles" / f"{name}.truth") if scenario.truth else None,
        "world": world(scenario),
    }
    path = folder / "vehicles" / f"{name}.autopilot.yaml"
    path.write_text(yaml.safe_dump(content, sort_keys=True), encoding="utf-8")
    argv = (real.kind, str(path), "--sysid", name, *connection)
    return ProcessSpec((vehicle.sysid,), argv, folder / "vehicles" / f"{name}.log")


def _renamed(vehicle: VehicleBase, profile: Profile) -> dict[str, str]:
    """Clauses about a vehicle's parameters whose names differ between versions."""
    clauses = {name: unknown_name(name, profile.renamed_parameters) for name in vehicle.params}
    return {name: f"; {clause}" for name, clause in clauses.items() if clause}


def vehicle_parameters(vehicle: VehicleBase, scenario: Scenario, failsafe: Failsafe) -> dict[str, float]:
    """The MAVLink parameters that a scenario gives one of its vehicles."""
    battery = vehicle.battery
    fails = any(fault.sysid == vehicle.sysid and fault.fault in COMMANDED for fault in scenario.faults)
    return {
        "SIM_BAT_CAP_J": battery.capacity_j,
        "SIM_BAT_INIT_J": battery.capacity_j * battery.initial_percent / 100.0,
        "SIM_BAT_HOVER_W": battery.hover_w,
        "SIM_BAT_AVION_W": battery.avionics_w,
        "SIM_XFER_DIST": scenario.refuelling.capture_m,
        "SIM_XFER_SPEED": scenario.refuelling.relative_speed_m_s,
        **(_cautious(failsafe) if scenario.planner.safety else {}),
        **({"SYS_FAILURE_EN": 1.0} if fails else {}),
        **vehicle.params,
    }


def _file_of_all(name: str, content: Callable[[Scenario], dict[str, Any]], scenario: Scenario, folder: Path) -> str:
    """Path of a file that all vehicles of a scenario read, written once."""
    path = folder / "vehicles" / name
    if not path.exists():
        new = path.with_name(f"{name}.new")  # a full disk leaves no part of it under its name
        write = json.dumps if path.suffix == ".json" else yaml.safe_dump
        new.write_text(write(content(scenario), sort_keys=True), encoding="utf-8")
        new.replace(path)
    return str(path)


def world(scenario: Scenario) -> dict[str, Any]:
    """World that the vehicles of a scenario fly in: weather, and the vehicles on rotors in it."""
    return {
        "seed": scenario.seed,
        "air_density_kg_m3": scenario.air_density_kg_m3,
        "wind": scenario.wind.model_dump(mode="json"),
        "vehicles": {
            vehicle.sysid: {
                "airframe": vehicle.airframe or "iris",
                "sensors": None if vehicle.sensors is None else vehicle.sensors.model_dump(),
                "resistance_ohm": vehicle.battery.resistance_ohm,
            }
            for vehicle in scenario.vehicles.launched
            if vehicle.on_rotors
        },
    }


def fleet_rules(scenario: Scenario) -> dict[str, Any]:
    """Rules by which the vehicles of a scenario compete on board, NED."""
    vehicles, shares = scenario.vehicles, math.ceil(len(scenario.vehicles.all) / PEERS_A_TICK)
    transit_m = max((failsafe_of(vehicle, scenario).altitude_m for vehicle in vehicles.all), default=0.0)
    return {
        **scenario.competition.model_dump(exclude={"enabled", "where", "policy"}),
        **scenario.refuelling.model_dump(exclude={"enabled"}),
        "transfers_until_s": transfers_until_s(scenario),
        "separation_m": scenario.planner.separation_m,
        "clearance_m": scenario.planner.clearance_m,
        "transit_height_m": transit_m,
        "report_every_s": max(round(shares * REPORT_TICK_S, 3), LEAST_REPORT_S),
        "pursuers": [pursuer.sysid for pursuer in vehicles.pursuers if pursuer.transfer_capable],
        "tankers": [
            {
                "sysid": tanker.sysid,
                "reserve_j": tanker.reserve_j,
                "speed_m_s": tanker.speed_m_s,
                "home_ned": list(tanker.home_m or tanker.start_m),
            }
            for tanker in vehicles.tankers
        ],
        "obstacles": _solids(scenario),
    }


def separation_rules(scenario: Scenario) -> dict[str, Any]:
    """Rules by which launched vehicles of a scenario keep apart while they fly by themselves, NED."""
    speeds, failsafes = speeds_m_s(scenario), failsafes_of(scenario)
    pair_m, alone_m = widest_m(scenario)
    members = []
    for vehicle in scenario.vehicles.launched:
        if vehicle.real is None:
            failsafe = failsafes[vehicle.sysid]
            members.append(
                {
                    "sysid": vehicle.sysid,
                    "speed_m_s": max(speeds[vehicle.sysid], failsafe.speed_m_s),
                    "acceleration_m_s2": acceleration_m_s2(scenario, vehicle),
                    "home_ned": list(vehicle.start_m),
                    "failsafe": asdict(failsafe),
                }
            )
    return {
        "period_s": scenario.clock.period_s,
        "separation_m": scenario.planner.separation_m + pair_m,
        "clearance_m": scenario.planner.clearance_m + alone_m,
        "vehicles": members,
        "obstacles": _solids(scenario),
    }


def _solids(scenario: Scenario) -> list[dict[str, Any]]:
    return [
        {
            "kind": obstacle.kind,
            "low_ned": list(obstacle.low_m),
            "high_ned": list(obstacle.high_m),
            "radius_m": obstacle.radius_m,
        }
        for obstacle in scenario.obstacles
    ]


def _cautious(failsafe: Failsafe) -> dict[str, float]:
    """Failsafe parameters of a vehicle that finds no way around obstacles."""
    return {"RTL_RETURN_ALT": failsafe.altitude_m, "COM_OF_LOSS_T": failsafe.hold_s}


def traffic_order(scenario: Scenario, folder: Path, connection: Sequence[str]) -> ProcessSpec:
    """Command that starts the scenario's traffic; writes its file to the session's folder."""
    origin = scenario.origin
    content = {
        "origin": {"lat_deg": origin.lat_deg, "lon_deg": origin.lon_deg, "alt_m": origin.alt_m},
        "movers": [
            {
                "callsign": mover.callsign,
                "path_ned_m": [list(point) for point in mover.path_m],
                "speed_m_s": mover.speed_m_s,
                "closed": mover.closed,
                "start_s": mover.start_s,
            }
            for mover in scenario.traffic
        ],
    }
    path = folder / "vehicles" / "traffic.yaml"
    path.write_text(yaml.safe_dump(content), encoding="utf-8")
    return ProcessSpec((255,), ("traffic", str(path), *connection), folder / "vehicles" / "traffic.log")


def _triple(numbers: Sequence[float]) -> str:
    return ",".join(repr(float(number)) for number in numbers)
