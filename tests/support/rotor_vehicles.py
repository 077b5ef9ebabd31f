"""Vehicles on rotors, in the air or on the ground, in this process."""

from __future__ import annotations

from simvehicle.autopilot.body import Start
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.identity import IDENTITIES
from simvehicle.autopilot.parameters import Parameters
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.law.plants import RotorPlant
from simvehicle.world.airframes import AIRFRAMES
from simvehicle.world.description import Air, WorldVehicle

IN_THE_AIR = Start((0.0, 0.0, -20.0), airborne=True)


def on_rotors(
    own: WorldVehicle | str = "iris",
    air: Air | None = None,
    start: Start = IN_THE_AIR,
    *,
    seed: int = 1,
    sysid: int = 1,
    **params: float,
) -> Vehicle:
    """A PX4 with this airframe, or all of this description, in some air; `params`: other than by default."""
    own = WorldVehicle(AIRFRAMES[own]) if isinstance(own, str) else own
    plant = RotorPlant(own, air or Air(), seed=seed, sysid=sysid)
    return Vehicle(IDENTITIES["px4"], Parameters(params), LocalFrame(0.0, 0.0, 0.0), start, plant)
