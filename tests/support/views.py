"""Vehicles as snapshots show them, for tests of what is made of them."""

from __future__ import annotations

from typing import Any

from gcs.mavlink.autopilots import PX4, FlightMode
from gcs.telemetry.state import FleetSnapshot, VehicleView


def view(sysid: int = 3, role: str = "pursuer", **changed: Any) -> VehicleView:
    """A vehicle that is well: in offboard at 4 m, heard at 100 s, with half of 10 kJ left; keys change it.

    The number of its mode is a PX4's for that mode, where PX4 has one.
    """
    well = VehicleView(
        sysid=sysid, role=role, label=f"{role} {sysid}", alive=True, profile=PX4, mode=FlightMode.OFFBOARD, armed=True,
        landed=False, last_received_s=100.0, p_ned=(1.0, 2.0, -4.0), v_ned=(0.0, 0.0, 0.0), age_s=0.0, heading_rad=0.5,
        origin_offset_ned=(0.0, 0.0, 0.0), ground_amsl_m=488.0, capacity_j=10_000.0, initial_j=10_000.0,
        battery_reported=True, drawn_j=5_000.0, received_j=0, given_j=0, given_reported_s=0.0, power_w=10.0,
        energy_source="energy_consumed", control_effort=0.0, last_message_s=100.0,
    )  # fmt: skip
    mode = changed.get("mode", well.mode)
    number = next((number for number, of in PX4.modes.items() if of is mode), 0)
    return well._replace(**{"custom_mode": number, **changed})


def snapshot(*views: VehicleView, time_s: float = 100.0) -> FleetSnapshot:
    return FleetSnapshot(time_s, tuple(sorted(views, key=lambda each: each.sysid)), ())
