"""What a session compiles, compiled before anyone waits: numba does so at a function's first call, once per machine.

In flight it would keep every vehicle waiting, longer than they wait for a supervisor that has fallen silent.
"""

from __future__ import annotations

from pymavlink.dialects.v20 import common as mav

from gcs.fleet import Fleet, GlobalOrigin, Member
from gcs.mavlink import codec
from gcs.metrics import PLAN_MEMORY, Metrics
from gcs.planner.plan import Planner
from gcs.scenario import Origin, Scenario, VehicleBase


def compile_ahead(scenario: Scenario) -> None:
    """Plan and measure for a fleet that flies at its starts; takes milliseconds where all is compiled."""
    vehicles, origin = scenario.vehicles.all, scenario.origin
    fleet = Fleet(
        [Member(v.sysid, v.role, v.label, 1.0, 1.0) for v in vehicles],
        GlobalOrigin(origin.lat_deg, origin.lon_deg, origin.alt_m),
    )
    for vehicle in vehicles:
        for frame in codec.split(_in_flight(vehicle, origin)).frames:
            fleet.ingest(frame, 0.0)
    snapshot = fleet.snapshot(0.0)
    planner = Planner(scenario)
    points = planner.plan(
        snapshot,
        frozenset(v.sysid for v in vehicles),
        rendezvous={},
        partners=(),
        targets_move=True,
        period_s=scenario.clock.period_s,
    )
    metrics = Metrics(scenario, planner.obstacles)
    for _ in range(PLAN_MEMORY):
        metrics.take(snapshot, points, ())


def _in_flight(vehicle: VehicleBase, origin: Origin) -> bytes:
    """What a vehicle says that flies at its start."""
    n, e, d = vehicle.start_m
    said = [
        codec.message(
            "HEARTBEAT",
            type=mav.MAV_TYPE_QUADROTOR,
            autopilot=mav.MAV_AUTOPILOT_GENERIC,
            base_mode=mav.MAV_MODE_FLAG_SAFETY_ARMED,
            custom_mode=0,
            system_status=mav.MAV_STATE_ACTIVE,
        ),
        codec.message(
            "GPS_GLOBAL_ORIGIN",
            latitude=round(1e7 * origin.lat_deg),
            longitude=round(1e7 * origin.lon_deg),
            altitude=round(1e3 * origin.alt_m),
        ),
        codec.message("EXTENDED_SYS_STATE", vtol_state=0, landed_state=mav.MAV_LANDED_STATE_IN_AIR),
        codec.message("LOCAL_POSITION_NED", time_boot_ms=0, x=n, y=e, z=d, vx=0.0, vy=0.0, vz=0.0),
    ]
    return b"".join(
        codec.frame(message, number, vehicle.sysid, mav.MAV_COMP_ID_AUTOPILOT1) for number, message in enumerate(said)
    )
