"""`simvehicle px4`: a real PX4 on our physics."""

from __future__ import annotations

from pathlib import Path

from simvehicle.cli.real_autopilot import fly_autopilot, real_autopilot


@real_autopilot("Fly a real PX4 on our physics.")
def px4(file: Path, sysid: int, supervised: str | None, connect: str | None) -> int:
    """Start the PX4 of FILE and be its simulation, in the time that a supervisor grants, or on the wall clock.

    `gcs run` and `gcs launch` write FILE for a vehicle with `autopilot: {px4: PATH}`.
    """
    from simvehicle.sitl.px4 import Px4Unit  # noqa: PLC0415 - so that help costs no compiler's start

    return fly_autopilot(Px4Unit, file, sysid, supervised, connect)
