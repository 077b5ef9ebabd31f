"""`simvehicle ardupilot`: a real ArduPilot on our physics."""

from __future__ import annotations

from pathlib import Path

from simvehicle.cli.real_autopilot import fly_autopilot, real_autopilot


@real_autopilot("Fly a real ArduPilot on our physics.")
def ardupilot(file: Path, sysid: int, supervised: str | None, connect: str | None) -> int:
    """Start the ArduPilot of FILE and be its simulation, in the time that a supervisor grants, or on the wall clock.

    `gcs run` and `gcs launch` write FILE for a vehicle with `autopilot: {ardupilot: PATH}`.
    """
    from simvehicle.sitl.ardupilot import ArduPilotUnit  # noqa: PLC0415 - so that help costs no compiler's start

    return fly_autopilot(ArduPilotUnit, file, sysid, supervised, connect)
