"""The world as a file describes it to the vehicles of a session: air, and what each flies on."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any

from simvehicle.world.airframes import AIRFRAMES, SEA_LEVEL_KG_M3, RotorAirframe
from simvehicle.world.estimate import EstimateErrors
from simvehicle.world.wind_field import WindField
from skytender import elementary


class WorldError(ValueError):
    """A world that cannot be used; the text says why."""


@dataclass(frozen=True)
class WorldVehicle:
    """One vehicle's own part of the world: what it flies on, how well it knows its motion (perfectly without errors),
    its battery's resistance (by its capacity where None)."""

    airframe: RotorAirframe
    errors: EstimateErrors | None = None
    resistance_ohm: float | None = None


@dataclass(frozen=True)
class Air:
    """Air of a session: density in kg/m³, mean wind in m/s, nwu, the wind at 20 ft that sets the turbulence, discrete
    gusts, DISCRETE_SIZE numbers each, and a table of what is added to the mean wind by place."""

    density_kg_m3: float = SEA_LEVEL_KG_M3
    mean_nwu: tuple[float, float, float] = (0.0, 0.0, 0.0)
    turbulence_m_s: float = 0.0
    gusts_nwu: tuple[tuple[float, ...], ...] = ()
    field: WindField | None = None

    def mean_at_nwu(self, p_nwu: Sequence[float]) -> tuple[float, float, float]:
        """Mean wind (nwu, m/s) at a place (nwu, m)."""
        if self.field is None:
            return self.mean_nwu
        (x, y, z), (dx, dy, dz) = self.mean_nwu, self.field.at_nwu(p_nwu)
        return x + dx, y + dy, z + dz


STILL_AIR = Air()


@dataclass(frozen=True)
class World:
    """Seed of what is random, the air, and the vehicles on rotors by system id; all others fly on the paper's plant."""

    vehicles: Mapping[int, WorldVehicle]
    air: Air = STILL_AIR
    seed: int = 0


def read_world(content: Any) -> World:
    """World from plain data, as a file holds it. Raises WorldError."""
    top = _mapping(content, "the world", {"vehicles", "air_density_kg_m3", "wind", "seed"})
    vehicles = {}
    for sysid, one in _mapping(top.get("vehicles", {}), "vehicles").items():
        if not isinstance(sysid, int):
            raise WorldError(f"vehicles: '{sysid}' is no system id")
        vehicles[sysid] = _vehicle(one, f"vehicle {sysid}")
    seed = top.get("seed", 0)
    if not isinstance(seed, int) or seed < 0:
        raise WorldError(f"seed is '{seed}', but it must be a whole number from 0")
    density_kg_m3 = _number(top, "air_density_kg_m3", SEA_LEVEL_KG_M3, above=0.0)
    return World(vehicles, _air(top.get("wind", {}), density_kg_m3), seed)


def _air(content: Any, density_kg_m3: float) -> Air:
    wind = _mapping(content, "wind", {"speed_m_s", "from_deg", "turbulence_m_s", "gusts", "field"})
    keys = {"at_s", "rise_s", "hold_s", "speed_m_s", "from_deg", "up_m_s"}
    gusts = []
    for one in wind.get("gusts", ()):
        gust = _mapping(one, "a gust", keys)
        rise_s = _number(gust, "rise_s", 1.0, above=0.0)
        x, y, _ = _blowing(gust)
        begin_s, hold_s = _number(gust, "at_s", 0.0), _number(gust, "hold_s", 0.0)
        gusts.append((begin_s, rise_s, hold_s, x, y, _number(gust, "up_m_s", 0.0)))
    field = None if wind.get("field") is None else _field(wind["field"])
    return Air(density_kg_m3, _blowing(wind), _number(wind, "turbulence_m_s", 0.0), tuple(gusts), field)


def _field(content: Any) -> WindField:
    table = _mapping(content, "field", {"north_m", "east_m", "height_m", "wind_m_s"})
    try:
        north_m, east_m, height_m = (tuple(map(float, table[name])) for name in ("north_m", "east_m", "height_m"))
        rows = tuple((float(north), float(east), float(up)) for north, east, up in table["wind_m_s"])
        return WindField(north_m, east_m, height_m, rows)
    except (KeyError, TypeError, ValueError) as error:
        raise WorldError(f"wind: {error}") from None


def _blowing(content: Mapping[Any, Any]) -> tuple[float, float, float]:
    """Velocity of the air, nwu, from its speed and the direction that it comes from, degrees clockwise from north."""
    speed, angle = _number(content, "speed_m_s", 0.0), math.radians(_number(content, "from_deg", 0.0))
    return -speed * elementary.cos(angle), speed * elementary.sin(angle), 0.0


def _vehicle(content: Any, where: str) -> WorldVehicle:
    own = _mapping(content, where, {"airframe", "sensors", "resistance_ohm"})
    name = own.get("airframe", "iris")
    if name not in AIRFRAMES:
        raise WorldError(f"{where}: there is no airframe '{name}'; choose from {', '.join(AIRFRAMES)}")
    errors = None
    if own.get("sensors") is not None:
        known = {one.name for one in fields(EstimateErrors)}
        sensors = _mapping(own["sensors"], f"{where}: sensors", known)
        try:
            errors = EstimateErrors(**{key: _number(sensors, key, 0.0) for key in sensors})
        except ValueError as error:
            raise WorldError(f"{where}: {error}") from None
    ohm = own.get("resistance_ohm")
    return WorldVehicle(AIRFRAMES[name], errors, None if ohm is None else _number(own, "resistance_ohm", 0.0))


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
