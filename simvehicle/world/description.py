"""The world as a file describes it to the vehicles of a session: air, and what each flies on."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from simvehicle.world.airframes import AIRFRAMES, SEA_LEVEL_KG_M3, RotorAirframe


class WorldError(ValueError):
    """A world that cannot be used; the text says why."""


@dataclass(frozen=True)
class WorldVehicle:
    """One vehicle's own part of the world."""

    airframe: RotorAirframe


@dataclass(frozen=True)
class World:
    """Air density in kg/m³, and the vehicles on rotors by system id; all others fly on the paper's plant."""

    vehicles: Mapping[int, WorldVehicle]
    air_density_kg_m3: float = SEA_LEVEL_KG_M3


def read_world(content: Any) -> World:
    """World from plain data, as a file holds it. Raises WorldError."""
    top = _mapping(content, "the world", {"vehicles", "air_density_kg_m3"})
    vehicles = {}
    for sysid, one in _mapping(top.get("vehicles", {}), "vehicles").items():
        if not isinstance(sysid, int):
            raise WorldError(f"vehicles: '{sysid}' is no system id")
        vehicles[sysid] = _vehicle(one, f"vehicle {sysid}")
    return World(vehicles, _number(top, "air_density_kg_m3", SEA_LEVEL_KG_M3, above=0.0))


def _vehicle(content: Any, where: str) -> WorldVehicle:
    own = _mapping(content, where, {"airframe"})
    name = own.get("airframe", "iris")
    if name not in AIRFRAMES:
        raise WorldError(f"{where}: there is no airframe '{name}'; choose from {', '.join(AIRFRAMES)}")
    return WorldVehicle(AIRFRAMES[name])


def _mapping(content: Any, where: str, known: set[str] | None = None) -> Mapping[Any, Any]:
    if not isinstance(content, Mapping):
        raise WorldError(f"{where} must be keys with values")
    if known is not None and (unknown := sorted(set(map(str, content)) - known)):
        raise WorldError(f"{where} has an unknown key '{unknown[0]}'; known are {', '.join(sorted(known))}")
    return content


def _number(content: Mapping[Any, Any], key: str, default: float, *, above: float = -math.inf) -> float:
    try:
        value = float(content.get(key, default))
    except (TypeError, ValueError):
        raise WorldError(f"{key} is '{content[key]}', which is no number") from None
    if not above < value < math.inf:
        raise WorldError(f"{key} is {value:g}, but it must be finite and greater than {above:g}")
    return value
