"""A scenario: what flies, where, for how long and to what end, as typed, frozen objects.

`load` reads a YAML file, `dump` writes one. Units stand in the names; angles are in degrees. A file states its axes,
`ned` or `paper` (north, west, up; contract.md, Frames), and `load` converts once: every object here is NED.
"""

import math
import os
from collections.abc import Callable, Iterable, Iterator
from datetime import UTC, datetime
from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import (
    AfterValidator,
    AwareDatetime,
    BaseModel,
    ConfigDict,
    Field,
    ValidationError,
    ValidationInfo,
    model_validator,
)

from gcs.yaml_source import Conflict, Path, Problem, ScenarioError, conflict_error, emit, read

__all__ = ["Obstacle", "Problem", "Scenario", "ScenarioError", "dump", "load"]

START_CLEARANCE_M = 0.3
STEP_S = 0.004  # the vehicles' own step: a grant is a whole number of them


def _into_ned(value: Any, info: ValidationInfo) -> Any:
    """A height, or a vector of two or three (also roll, pitch, yaw): from paper axes it is half a turn about north."""
    if info.context != {"axes": "paper"}:
        return value
    return (value[0], *(0.0 - part for part in value[1:])) if isinstance(value, tuple) else 0.0 - value


def _known_axes(value: str, info: ValidationInfo) -> str:
    if value == "paper" and info.context != {"axes": "paper"}:
        raise ValueError("must be 'ned' here: only a file is converted from paper axes")
    return "ned"


Flag = Annotated[bool, Field(strict=True)]
Count = Annotated[int, Field(strict=True, ge=0, lt=1 << 63)]
SysId = Annotated[int, Field(strict=True, ge=1, le=254)]
Label = Annotated[str, Field(pattern=r"^[^\x00-\x1f\x7f-\x9f]{1,32}$")]
ParamName = Annotated[str, Field(pattern=r"^[A-Za-z][A-Za-z0-9_]{0,15}$")]
Number = Annotated[float, Field(strict=True)]
Positive = Annotated[float, Field(strict=True, gt=0)]
NotNegative = Annotated[float, Field(strict=True, ge=0)]
Fraction = Annotated[float, Field(strict=True, ge=0, le=1)]
Percent = Annotated[float, Field(strict=True, ge=0, le=100)]
Metres = Annotated[float, Field(strict=True, gt=0, le=1e5)]
Speed = Annotated[float, Field(strict=True, gt=0, le=100)]
Degrees = Annotated[float, Field(strict=True, ge=-180, le=180)]
Seconds = Annotated[float, Field(strict=True, ge=0, le=86_400)]
Joules = Annotated[float, Field(strict=True, gt=0, le=1e9)]  # whole joules travel as 32-bit integers
Coordinate = Annotated[float, Field(strict=True, ge=-1e5, le=1e5)]
Height = Annotated[Coordinate, AfterValidator(_into_ned)]
Plane = Annotated[tuple[Coordinate, Coordinate], AfterValidator(_into_ned)]
Vec3 = Annotated[tuple[Coordinate, Coordinate, Coordinate], AfterValidator(_into_ned)]
Angles = Annotated[tuple[Degrees, Degrees, Degrees], AfterValidator(_into_ned)]
Route = Annotated[tuple[Vec3, ...], Field(min_length=1)]
EARLIEST, LATEST = datetime(1970, 1, 1, tzinfo=UTC), datetime(2200, 1, 1, tzinfo=UTC)


class _Part(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False, use_attribute_docstrings=True)


class Origin(_Part):
    """Where the local frame's zero lies; the height is above mean sea level."""

    lat_deg: Annotated[float, Field(strict=True, ge=-89, le=89)]
    lon_deg: Degrees
    alt_m: Annotated[float, Field(strict=True, ge=-1000, le=20_000)]


class Clock(_Part):
    """lockstep: as fast as the machine can; real: paced at `speed`. `epoch` is the date of session time zero."""

    mode: Literal["lockstep", "real"] = "real"
    speed: Annotated[float, Field(strict=True, gt=0, le=1000)] = 1.0
    period_s: Annotated[float, Field(strict=True, ge=STEP_S, le=1)] = 0.1
    epoch: Annotated[AwareDatetime, Field(ge=EARLIEST, lt=LATEST)] = datetime(2026, 1, 1, tzinfo=UTC)


class Pursue(_Part):
    within_m: Metres
    for_s: Seconds


class Goal(_Part):
    """What makes the session a success."""

    pursue: Pursue | None = None
    refuelled_at_least: Count = 0
    duration_s: Annotated[float, Field(strict=True, gt=0, le=86_400)]


class Battery(_Part):
    """P = hover_w (T/mg)^(3/2) + avionics_w (model.md 9) [choice]."""

    capacity_j: Joules
    initial_percent: Percent = 100.0
    hover_w: Positive = 200.0
    avionics_w: NotNegative = 10.0


class VehicleBase(_Part):
    role: ClassVar[str]

    sysid: SysId
    name: Label | None = None
    start_m: Vec3
    velocity_m_s: Vec3 = (0.0, 0.0, 0.0)
    attitude_deg: Angles = (0.0, 0.0, 0.0)
    """roll, pitch, yaw"""
    airborne: Flag = False
    """starts flying; there is then no ground"""
    join_s: Seconds = 0.0
    takeoff_m: Metres = 2.5
    """the height above the ground to which it climbs first"""
    battery: Battery
    params: dict[ParamName, Number] = {}
    """further MAVLink parameters"""

    @property
    def label(self) -> str:
        """For messages: `NAME (3)`, or `pursuer 3`."""
        return f"{self.name} ({self.sysid})" if self.name else f"{self.role} {self.sysid}"


class Pursuer(VehicleBase):
    role = "pursuer"

    target: SysId | None = None
    """the target's sysid; without it the first target"""


class Target(VehicleBase):
    role = "target"

    path_m: Route
    speed_m_s: Speed
    laps: Annotated[int, Field(strict=True, ge=1, le=1_000_000)] = 1
    closed: Flag = False
    """the path leads from its last point back to its first"""


class Tanker(VehicleBase):
    role = "tanker"

    reserve_j: NotNegative = 10_000.0
    """kept to get home"""
    speed_m_s: Speed = 5.0
    home_m: Vec3 | None = None
    """where it waits; without it above its start"""


class Vehicles(_Part):
    """By role. A file may add `defaults`: keys that `load` gives to each vehicle that lacks them."""

    model_config = ConfigDict(json_schema_extra=lambda schema: schema["properties"].update(defaults={"type": "object"}))

    pursuers: tuple[Pursuer, ...] = ()
    targets: tuple[Target, ...] = ()
    tankers: tuple[Tanker, ...] = ()

    @property
    def all(self) -> tuple[Pursuer | Target | Tanker, ...]:
        """Every vehicle, in order of system id."""
        return tuple(sorted((*self.pursuers, *self.targets, *self.tankers), key=lambda vehicle: vehicle.sysid))


Kind = Literal["point", "sphere", "box", "cylinder"]
_KEYS: dict[Kind, set[str]] = {
    "point": set(),
    "box": set(),
    "sphere": {"radius_m"},
    "cylinder": {"radius_m", "bottom_m", "top_m"},
}


class Obstacle(_Part):
    """A point, a sphere round its centre, a box between two opposite corners, or an upright cylinder round (x, y).

    All are read alike, by `kind`, `low_m`, `high_m` and `radius_m` (0 for points and boxes).
    """

    name: Label | None = None
    point_m: Vec3 | None = None
    sphere_m: Vec3 | None = None
    box_m: tuple[Vec3, Vec3] | None = None
    cylinder_m: Plane | None = None
    radius_m: Annotated[float, Field(strict=True, ge=0, le=1e5)] = 0.0
    bottom_m: Height | None = None
    top_m: Height | None = None

    @property
    def kind(self) -> Kind:
        return next(kind for kind in _KEYS if getattr(self, f"{kind}_m") is not None)

    @property
    def low_m(self) -> Vec3:
        """NED; the least coordinates of the box, of the cylinder's axis, or the point or centre itself."""
        return self._corner(min)

    @property
    def high_m(self) -> Vec3:
        """NED; the greatest coordinates of the same."""
        return self._corner(max)

    def _corner(self, of: Callable[[float, float], float]) -> Vec3:
        a = b = self.point_m or self.sphere_m or (0.0, 0.0, 0.0)
        if self.box_m:
            a, b = self.box_m
        elif self.cylinder_m:
            a, b = (*self.cylinder_m, self.top_m or 0.0), (*self.cylinder_m, self.bottom_m or 0.0)
        return of(a[0], b[0]), of(a[1], b[1]), of(a[2], b[2])

    def clearance_m(self, p_ned: Vec3) -> float:
        """The distance in m from p_ned to the surface (a point's is its centre); negative inside."""
        beyond = [max(low - x, x - high) for low, x, high in zip(self.low_m, p_ned, self.high_m, strict=True)]
        if self.kind == "cylinder":
            beyond = [math.hypot(beyond[0], beyond[1]) - self.radius_m, beyond[2]]
        outside = math.hypot(*(max(distance, 0.0) for distance in beyond))
        return (outside or max(beyond)) - (self.radius_m if self.kind == "sphere" else 0.0)

    def fault(self) -> str:
        """What keeps the keys from being one solid, as a sentence; empty if nothing does."""
        kinds = [kind for kind in _KEYS if getattr(self, f"{kind}_m") is not None]
        if len(kinds) != 1:
            return f"an obstacle needs exactly one of {', '.join(f'{kind}_m' for kind in _KEYS)}"
        for key in ("radius_m", "bottom_m", "top_m"):
            given = getattr(self, key) is not None and (key != "radius_m" or self.radius_m > 0)
            if given != (key in _KEYS[kinds[0]]):
                return f"a {kinds[0]} {'has no' if given else 'needs'} {key}"
        if self.box_m and any(low == high for low, high in zip(*self.box_m, strict=True)):
            return "a box needs corners that differ in each direction"
        if self.bottom_m is not None and self.top_m is not None and self.top_m >= self.bottom_m:
            return "a cylinder's top_m must lie above its bottom_m"
        return ""


class Mover(_Part):
    """Traffic: flies its path from session time `start_s`, reported by ADSB_VEHICLE; nobody steers it."""

    callsign: Annotated[str, Field(pattern=r"^[A-Za-z0-9_-]{1,8}$")]
    path_m: Route
    speed_m_s: Speed
    closed: Flag = False
    start_s: Seconds = 0.0


class Planner(_Part):
    """Potential field (model.md 6) [seed: k0, k1, a, b, ranges] and fuzzy escape (model.md 7)."""

    method: Literal["potential_field"] = "potential_field"
    escape: Flag = True
    cruise_m_s: Speed = 1.5
    k0: Positive = 15.0
    k1: Positive = 2.0
    a: NotNegative = 0.5
    b: Annotated[float, Field(strict=True, gt=0, lt=1)] = 0.5
    attraction_range_m: Metres = 1.0
    repulsion_range_m: Metres = 1.0
    step_m: Metres = 0.1
    separation_m: Annotated[float, Field(strict=True, ge=0, le=1e5)] = 0.6
    """the least distance between any two vehicles that are not partners of a transfer"""
    leash_m: Metres = 2.0
    """how far the planned point may run ahead of its vehicle"""


class Formation(_Part):
    """A ring around the target, `height_m` above it; without `ring_m` the target itself attracts."""

    ring_m: Metres | None = None
    height_m: Coordinate = 0.0


class Competition(_Part):
    """Winner-take-all (model.md 8): exponent p, rate c, values in [floor, high]; who competes, when it is decided."""

    enabled: Flag = True
    p: Annotated[float, Field(strict=True, ge=1, le=100)] = 2.0
    rate: Positive = 5.0
    floor: Positive = 0.01
    high: Positive = 1.0
    need_from: Fraction = 0.5
    share: Annotated[float, Field(strict=True, gt=0, lt=1)] = 0.9
    dwell_s: Seconds = 2.0
    decide_within_s: Seconds = 30.0


class Refuelling(_Part):
    """Where the tanker stands (`height_m` above the receiver), when a transfer may run, and how much flows."""

    enabled: Flag = True
    height_m: Metres = 1.2
    capture_m: Metres = 1.5
    relative_speed_m_s: Speed = 0.5
    hold_s: Seconds = 1.0
    rate_w: Positive = 2000.0
    until: Annotated[float, Field(strict=True, gt=0, le=1)] = 0.9
    """of the receiver's capacity"""
    reserve_s: Seconds = 20.0
    """served first: who cannot last until the rendezvous and this long after it"""
    limit_j: Joules | None = None


class Blackout(_Part):
    sysid: SysId
    from_s: Seconds
    to_s: Seconds


class Radio(_Part):
    """What happens to frames on the air, each way: shares of all frames, and seconds (contract.md, Clock)."""

    loss: Fraction = 0.0
    delay_s: Seconds = 0.0
    jitter_s: Seconds = 0.0
    duplicate: Fraction = 0.0
    reorder: Fraction = 0.0
    blackouts: tuple[Blackout, ...] = ()


class Scenario(_Part):
    """One session's world."""

    model_config = ConfigDict(populate_by_name=True)

    schema_version: Annotated[int, Field(strict=True, ge=1, le=1, alias="schema")]
    name: Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9._-]{0,63}$")]
    """also the session folder's"""
    description: str = ""
    axes: Annotated[Literal["paper", "ned"], AfterValidator(_known_axes)]
    """of all geometry in the file; `ned` once loaded"""
    seed: Count = 1
    origin: Origin
    clock: Clock = Clock()
    goal: Goal
    vehicles: Vehicles
    obstacles: tuple[Obstacle, ...] = ()
    traffic: tuple[Mover, ...] = ()
    planner: Planner = Planner()
    formation: Formation = Formation()
    competition: Competition = Competition()
    refuelling: Refuelling = Refuelling()
    radio: Radio = Radio()
    truth: Flag = True
    """vehicles record what they themselves know (contract.md, A session's folder)"""

    @model_validator(mode="after")
    def _agrees(self) -> Self:
        if conflicts := [*_conflicts(self), *_vehicle_conflicts(self)]:
            raise conflict_error(conflicts)
        return self


def _conflicts(s: Scenario) -> Iterator[Conflict]:
    """Values that are right one by one but not together, the vehicles' own apart."""
    steps, sysids = s.clock.period_s / STEP_S, {vehicle.sysid for vehicle in s.vehicles.all}
    pursue, pursuers, targets, tankers = s.goal.pursue, s.vehicles.pursuers, s.vehicles.targets, s.vehicles.tankers
    refuels = s.refuelling.enabled and pursuers and tankers
    rules: list[tuple[Any, Path, str]] = [
        (not sysids, ("vehicles",), "there must be at least one vehicle"),
        (abs(steps - round(steps)) > 1e-6, ("clock", "period_s"), f"period_s must be a multiple of {STEP_S} s"),
        (pursue and pursue.for_s > s.goal.duration_s, ("goal", "pursue", "for_s"), "for_s is longer than duration_s"),
        (pursue and not (pursuers and targets), ("goal", "pursue"), "pursue needs a pursuer and a target"),
        (
            s.goal.refuelled_at_least and not refuels,
            ("goal", "refuelled_at_least"),
            "refuelled_at_least needs a pursuer, a tanker and refuelling enabled",
        ),
        (s.formation.ring_m and not targets, ("formation", "ring_m"), "a formation needs a target"),
        (s.competition.floor >= s.competition.high, ("competition", "floor"), "floor must be below high"),
        (
            s.refuelling.height_m >= s.refuelling.capture_m,
            ("refuelling", "height_m"),
            "height_m must be below capture_m, or no transfer would begin",
        ),
    ]
    for i, blackout in enumerate(s.radio.blackouts):
        path: Path = ("radio", "blackouts", i)
        rules.append((blackout.sysid not in sysids, (*path, "sysid"), f"there is no vehicle {blackout.sysid}"))
        rules.append((blackout.from_s >= blackout.to_s, (*path, "to_s"), "to_s must be after from_s"))
    for i, obstacle in enumerate(s.obstacles):
        rules.append((obstacle.fault(), ("obstacles", i), obstacle.fault()))
    for i, mover in enumerate(s.traffic):
        yield from _route_conflicts(("traffic", i, "path_m"), mover)
    yield from _repeats("callsign", [(("traffic", i, "callsign"), mover.callsign) for i, mover in enumerate(s.traffic)])
    yield from (Conflict(path, sentence) for broken, path, sentence in rules if broken)


def _vehicle_conflicts(s: Scenario) -> Iterator[Conflict]:
    """Ids, names, starts, paths and batteries that do not go with each other or with the rest."""
    targets = {target.sysid for target in s.vehicles.targets}
    placed: list[tuple[Path, VehicleBase]] = []
    for group in (s.vehicles.pursuers, s.vehicles.targets, s.vehicles.tankers):
        placed.extend((("vehicles", f"{vehicle.role}s", i), vehicle) for i, vehicle in enumerate(group))
    yield from _repeats("sysid", [((*path, "sysid"), vehicle.sysid) for path, vehicle in placed])
    yield from _repeats("name", [((*path, "name"), vehicle.name) for path, vehicle in placed if vehicle.name])
    for i, (path, vehicle) in enumerate(placed):
        start = (*path, "start_m")
        if vehicle.join_s >= s.goal.duration_s:
            yield Conflict((*path, "join_s"), f"{vehicle.label} would join after the end, duration_s")
        if any(vehicle.velocity_m_s) and not vehicle.airborne:
            yield Conflict((*path, "velocity_m_s"), f"{vehicle.label} moves on the ground; it needs 'airborne: true'")
        if vehicle.start_m[2] > 0 and not vehicle.airborne:
            yield Conflict(start, f"{vehicle.label} starts below the ground; in ned axes the third number is down")
        if isinstance(vehicle, Pursuer) and vehicle.target is not None and vehicle.target not in targets:
            yield Conflict((*path, "target"), f"{vehicle.label} follows {vehicle.target}, which is no target's sysid")
        if isinstance(vehicle, Tanker) and vehicle.reserve_j >= vehicle.battery.capacity_j:
            yield Conflict((*path, "reserve_j"), f"{vehicle.label} has a reserve_j above its capacity_j")
        if isinstance(vehicle, Target):
            yield from _route_conflicts((*path, "path_m"), vehicle)
            if vehicle.laps > 1 and not vehicle.closed:
                yield Conflict((*path, "laps"), "more than one lap needs 'closed: true'")
        for j, obstacle in enumerate(s.obstacles):
            if not obstacle.fault() and obstacle.clearance_m(vehicle.start_m) < START_CLEARANCE_M:
                what = obstacle.name or f"{obstacle.kind} {j + 1}"
                sentence = f"{vehicle.label} starts inside or within {START_CLEARANCE_M} m of the obstacle {what}"
                yield Conflict(start, sentence, ("obstacles", j))
        for other_path, other in placed[:i]:
            distance_m = math.dist(vehicle.start_m, other.start_m)
            if distance_m < s.planner.separation_m and vehicle.join_s == other.join_s:
                sentence = f"{vehicle.label} starts {distance_m:.2f} m from {other.label}, below planner.separation_m"
                yield Conflict(start, sentence, (*other_path, "start_m"))


def _repeats(key: str, values: Iterable[tuple[Path, object]]) -> Iterator[Conflict]:
    first: dict[object, Path] = {}
    for path, value in values:
        if first.setdefault(value, path) != path:
            yield Conflict(path, f"the {key} {value} is given twice", first[value])


def _route_conflicts(path: Path, flier: Target | Mover) -> Iterator[Conflict]:
    points = flier.path_m
    if flier.closed and len(points) < 2:
        yield Conflict(path, "a closed path needs at least 2 points")
    for i in range(1, len(points)):
        if points[i] == points[i - 1] or (flier.closed and 1 < i == len(points) - 1 and points[i] == points[0]):
            yield Conflict((*path, i), "path_m repeats a point here and would stand still; leave the point out")


def load(path: str | os.PathLike[str]) -> Scenario:
    """The scenario in the YAML file at `path`, in NED. Raises ScenarioError: what is wrong, and where."""
    document = read(path)
    vehicles = document.data.get("vehicles")
    if isinstance(vehicles, dict) and "defaults" in vehicles:
        defaults = ("vehicles", "defaults")
        if not isinstance(vehicles["defaults"], dict):
            raise ScenarioError([document.problem(defaults, "vehicles.defaults must be a block of keys")])
        for key in ("pursuers", "targets", "tankers"):
            group = vehicles.get(key)
            for i in range(len(group) if isinstance(group, list) else 0):
                document.inherit(defaults, ("vehicles", key, i))
        del vehicles["defaults"]
    try:
        return Scenario.model_validate(document.data, context={"axes": document.data.get("axes")})
    except ValidationError as error:
        raise ScenarioError(document.explain(error, Scenario.model_json_schema())) from None


def dump(scenario: Scenario) -> str:
    """The scenario as YAML in NED, every value written out, which `load` reads back equal."""
    return emit(scenario.model_dump(mode="json", by_alias=True, exclude_none=True))
