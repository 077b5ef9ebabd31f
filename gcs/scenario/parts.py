"""The parts that a scenario is made of: clock, goal, vehicles, bases, obstacles, traffic, radio.

Frozen, strict, and NED (gcs/scenario/types.py).
"""

import math
from collections.abc import Callable, Iterator, Sequence
from datetime import UTC, datetime
from typing import Annotated, ClassVar, Literal

from pydantic import AwareDatetime, ConfigDict, Field, ValidationInfo, model_validator

from gcs.scenario.document import Conflict
from gcs.scenario.external import External, filled
from gcs.scenario.types import (
    Angles,
    Count,
    Degrees,
    Flag,
    Fraction,
    Height,
    Joules,
    Label,
    Limit,
    Metres,
    NotNegative,
    Number,
    ParamName,
    Part,
    Percent,
    Plane,
    Positive,
    Route,
    Seconds,
    Speed,
    SysId,
    Vec3,
)
from gcs.scenario.weather import RealAutopilot, Sensors

Airframe = Literal["iris", "hummingbird", "crazyflie"]
LEAST_BASE_CLEARANCE_M = 0.3
STEP_S = 0.004  # the vehicles' own step: a grant is a whole number of them


def known_axes(value: str, info: ValidationInfo) -> str:
    if value == "paper" and info.context != {"axes": "paper"}:
        raise ValueError("must be 'ned' here: only a file is converted from paper axes")
    return "ned"


EARLIEST, LATEST = datetime(1970, 1, 1, tzinfo=UTC), datetime(2200, 1, 1, tzinfo=UTC)


class Origin(Part):
    """Place of the local frame's zero; the height is above mean sea level."""

    lat_deg: Annotated[float, Field(strict=True, ge=-89, le=89)]
    """latitude, degrees north, WGS 84"""
    lon_deg: Degrees
    """longitude, degrees east, WGS 84"""
    alt_m: Annotated[float, Field(strict=True, ge=-1000, le=20_000)]
    """height above mean sea level, m"""


class Clock(Part):
    """lockstep: as fast as the machine can; real: paced at `speed`. `epoch` is the date of session time zero."""

    mode: Literal["lockstep", "real"] = "real"
    """`lockstep`: as fast as the machine can; `real`: paced at `speed`"""
    speed: Annotated[float, Field(strict=True, gt=0, le=1000)] = 1.0
    """session seconds per wall second, with mode `real`; 1 with external vehicles"""
    period_s: Annotated[float, Field(strict=True, ge=STEP_S, le=1)] = 0.1
    """period of planning, set points and grants, s; a multiple of 0.004, at most 0.2 with refuelling"""
    epoch: Annotated[AwareDatetime, Field(ge=EARLIEST, lt=LATEST)] = datetime(2026, 1, 1, tzinfo=UTC)
    """date and time of session time zero, with time zone; the times in session.tlog count from it"""


class Pursue(Part):
    """Distance of each pursuer, or in a competition of one, to its target, and for how long without a
    break."""

    within_m: Metres
    """greatest distance from pursuer to target, m"""
    for_s: Seconds
    """how long without a break, s of session time"""


class Goal(Part):
    """Goal of the session (docs/protocol.md#goal): every part must be met. No vehicle collides, falls out or
    misses a way point unless the scenario says that this does not matter."""

    pursue: Pursue | None = None
    """pursuit that is demanded; none by default"""
    refuelled_at_least: Count = 0
    """number of services that must have delivered energy; 0 demands none"""
    duration_s: Annotated[float, Field(strict=True, gt=0, le=604_800)]
    """length of the session, s of session time"""
    separation_m: Limit = None
    """least distance of two vehicles in flight, m, partners of a transfer aside; by default planner.separation_m where
    planner.vehicles_repel; `false` or 0 demands none"""
    traffic_m: Limit = None
    """least distance of a vehicle in flight to traffic, m, except traffic that attracts; by default
    planner.separation_m; `false` or 0 demands none"""
    clearance_m: Limit = 0.1
    """least distance of a vehicle in flight to an obstacle's surface (a point's is its centre), m; nearer counts as
    touched; 0: only inside counts; `false` demands none"""
    ground: Flag = True
    """whether touching the ground, other than to take off and land, fails the goal; not of vehicles that start
    `airborne`, which have no ground"""
    lost_at_most: Count = 0
    """how many vehicles may be lost: dead, run dry, landed by a failsafe without an order, or never in the air"""
    waypoints: Literal["all", "none"] = "all"
    """`all`: every pursuer with waypoints_m passes all of them in order; `none`: none need"""
    waypoint_within_m: Metres = 1.0
    """how near a pursuer must pass a way point, m; at least planner.step_m"""


class Battery(Part):
    """P = hover_w (T/mg)^(3/2) + avionics_w (docs/model.md#battery) [choice]."""

    capacity_j: Joules
    """energy of the full battery, J"""
    initial_percent: Percent = 100.0
    """charge at the start, % of the capacity"""
    hover_w: Positive = 200.0
    """power of the motors in hover, W"""
    avionics_w: NotNegative = 10.0
    """power of everything else, W; drawn with motors off too"""
    resistance_ohm: NotNegative | None = None
    """with `plant: rotors`: inner resistance, Ω; by default that of a usual battery of its capacity"""


class VehicleBase(Part):
    """Keys of every vehicle, whatever its role."""

    role: ClassVar[str]
    _external = model_validator(mode="before")(filled)

    sysid: SysId
    """MAVLink system id, 1 to 254; unique"""
    name: Label | None = None
    """shown in place of the role; by default `pursuer 3` and the like"""
    start_m: Vec3
    """position at the start, m, in the file's axes; on the ground its height is 0"""
    velocity_m_s: Vec3 = (0.0, 0.0, 0.0)
    """velocity at the start, m/s, in the file's axes; needs `airborne: true`"""
    attitude_deg: Angles = (0.0, 0.0, 0.0)
    """roll, pitch, yaw"""
    airborne: Flag = False
    """starts flying; there is then no ground"""
    join_s: Seconds = 0.0
    """session time at which it joins, s; its process waits until then"""
    takeoff_m: Metres = 2.5
    """the height above the ground to which it climbs first"""
    battery: Battery
    """capacity, charge and consumption"""
    autopilot: RealAutopilot | Literal["own"] = "own"
    """`own`: our law; `{ardupilot: PATH}` or `{px4: PATH}`: a real one, started by the session, on rotors"""
    plant: Literal["paper", "rotors"] = "paper"
    """`paper`: the plant of the paper's eq. 3; `rotors`: a rigid body on four rotors (docs/model.md#rotors)"""
    airframe: Airframe | None = None
    """on rotors: whose mass, rotors and drag it has (docs/model.md#airframes); by default `iris`"""
    sensors: Sensors | None = None
    """errors of what it knows of its motion; `{}` has usual ones; without it the vehicle knows exactly"""
    params: dict[ParamName, Number] = {}  # noqa: RUF012 - pydantic copies it
    """further MAVLink parameters"""
    external: External | None = None
    """expected there rather than launched; start_m then means nothing, it is where it is"""

    @property
    def real(self) -> RealAutopilot | None:
        """The autopilot that is not ours and that the session starts; None where there is none."""
        return None if self.autopilot == "own" else self.autopilot

    @property
    def on_rotors(self) -> bool:
        """Whether it flies on rotors."""
        return self.plant == "rotors" or self.real is not None

    @property
    def foreign(self) -> External | None:
        """Rules for a vehicle whose autopilot is not ours, whoever started it; None where it is ours."""
        if self.real is None:
            return self.external
        return External(
            connect="udpin:127.0.0.1:1",
            sysid=self.sysid,
            autopilot=self.real.kind,
            capacity_j=self.battery.capacity_j,
            arm_within_s=self.real.arm_within_s,
        )

    @property
    def label(self) -> str:
        """For messages: `NAME (3)`, or `pursuer 3`."""
        return f"{self.name} ({self.sysid})" if self.name else f"{self.role} {self.sysid}"


class Pursuer(VehicleBase):
    """A vehicle that follows a target, or its own way points, and that is refuelled."""

    role = "pursuer"

    target: SysId | None = None
    """the target's sysid; without it the first target"""
    waypoints_m: tuple[Vec3, ...] = ()
    """visited in order, within planner.step_m each, instead of a target; it stays at the last one"""
    transfer: Flag | None = None
    """whether it can take energy in the air, or only a base can serve it; without it external vehicles are asked"""

    @property
    def transfer_capable(self) -> bool | None:
        """Whether it can take energy in the air; None where it is to be asked."""
        asked = self.transfer is None and self.foreign is not None
        return None if asked else self.transfer is not False


class Target(VehicleBase):
    """A vehicle that flies a path and is followed."""

    role = "target"

    path_m: Route
    """corners of its path, m, in the file's axes; flown once all vehicles are in the air"""
    speed_m_s: Speed
    """speed along the path, m/s"""
    laps: Annotated[int, Field(strict=True, ge=1, le=1_000_000)] = 1
    """how often a closed path is flown"""
    closed: Flag = False
    """the path leads from its last point back to its first"""


class Tanker(VehicleBase):
    """A vehicle that refuels others in the air."""

    role = "tanker"

    reserve_j: NotNegative = 10_000.0
    """kept to get home"""
    speed_m_s: Speed = 5.0
    """greatest speed on the way to a receiver and home, m/s"""
    home_m: Vec3 | None = None
    """where it waits; without it above its start"""


class Vehicles(Part):
    """By role. A file may add `defaults`: keys that `load` gives to each vehicle that lacks them."""

    model_config = ConfigDict(json_schema_extra=lambda schema: schema["properties"].update(defaults={"type": "object"}))

    pursuers: tuple[Pursuer, ...] = ()
    """vehicles that follow a target or way points, and are refuelled"""
    targets: tuple[Target, ...] = ()
    """vehicles that fly a path and are followed"""
    tankers: tuple[Tanker, ...] = ()
    """vehicles that refuel pursuers in flight"""

    def target_of(self, pursuer: Pursuer) -> int | None:
        """The system id of the target that a pursuer follows: the one it names, else the first; None without any."""
        if pursuer.waypoints_m:
            return None
        if pursuer.target is not None:
            return pursuer.target
        return self.targets[0].sysid if self.targets else None

    @property
    def all(self) -> tuple[Pursuer | Target | Tanker, ...]:
        """Every vehicle, in order of system id."""
        return tuple(sorted((*self.pursuers, *self.targets, *self.tankers), key=lambda vehicle: vehicle.sysid))

    @property
    def launched(self) -> tuple[Pursuer | Target | Tanker, ...]:
        """Vehicles that a session starts itself, in order of system id."""
        return tuple(vehicle for vehicle in self.all if vehicle.external is None)

    @property
    def external(self) -> dict[int, External]:
        """External vehicles, by system id."""
        return {vehicle.sysid: vehicle.external for vehicle in self.all if vehicle.external is not None}

    @property
    def repeat(self) -> bool:
        """Whether all of them fly the same way again."""
        return not self.external and all(vehicle.real is None or vehicle.real.repeats for vehicle in self.all)

    @property
    def foreign(self) -> dict[int, External]:
        """Rules for the vehicles whose autopilot is not ours, by system id."""
        return {vehicle.sysid: rules for vehicle in self.all if (rules := vehicle.foreign) is not None}


Kind = Literal["point", "sphere", "box", "cylinder"]
_KEYS: dict[Kind, set[str]] = {
    "point": set(),
    "box": set(),
    "sphere": {"radius_m"},
    "cylinder": {"radius_m", "bottom_m", "top_m"},
}


class Obstacle(Part):
    """A point, a sphere round its centre, a box between two opposite corners, or an upright cylinder round (x, y).

    All are read alike, by `kind`, `low_m`, `high_m` and `radius_m` (0 for points and boxes).
    """

    name: Label | None = None
    """shown in messages and plots; by default `sphere 2` and the like"""
    point_m: Vec3 | None = None
    """a point obstacle: its position, m, in the file's axes"""
    sphere_m: Vec3 | None = None
    """a sphere: its centre, m, in the file's axes; with `radius_m`"""
    box_m: tuple[Vec3, Vec3] | None = None
    """a box: two opposite corners, m, in the file's axes"""
    cylinder_m: Plane | None = None
    """an upright cylinder: its axis as the first two coordinates, m; with `radius_m`, `bottom_m` and `top_m`"""
    radius_m: Annotated[float, Field(strict=True, ge=0, le=1e5)] = 0.0
    """radius of a sphere or cylinder, m"""
    bottom_m: Height | None = None
    """lower end of a cylinder, m, third coordinate in the file's axes"""
    top_m: Height | None = None
    """upper end of a cylinder, m, third coordinate in the file's axes"""

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
        """Fault that keeps the keys from being one solid, as a sentence; empty without one."""
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


class Mover(Part):
    """Traffic: flies its path from session time `start_s`, reported by ADSB_VEHICLE; it is not steered."""

    callsign: Annotated[str, Field(pattern=r"^[A-Za-z0-9_-]{1,8}$")]
    """ADSB_VEHICLE's callsign, 1 to 8 letters, digits, - or _; unique"""
    path_m: Route
    """corners of its path, m, in the file's axes; an open path is flown to its end and back"""
    speed_m_s: Speed
    """speed along the path, m/s"""
    closed: Flag = False
    """the path leads from its last point back to its first"""
    start_s: Seconds = 0.0
    """session time at which it starts to move, s; until then it waits at its first point"""
    attracts: Flag = False
    """pursuers within planner.attraction_range_m are drawn to it, instead of repelled"""


class Attractor(Part):
    """A point that draws pursuers within its range, beside what they follow (docs/model.md#potential-field; paper eq.
    5) [choice], range [seed]."""

    name: Label | None = None
    """shown in plots"""
    point_m: Vec3
    """its position, m, in the file's axes"""
    range_m: Metres | None = None
    """without it planner.attraction_range_m"""


class Blackout(Part):
    """From when to when no frame from or to a vehicle arrives."""

    sysid: SysId
    """system id of the vehicle"""
    from_s: Seconds
    """begin, s of session time"""
    to_s: Seconds
    """end, s of session time; after `from_s`"""


class GroundBlackout(Part):
    """From when to when the ground station's own radio is dead: it neither sends nor receives."""

    from_s: Seconds
    """begin, s of session time"""
    to_s: Seconds
    """end, s of session time; after `from_s`"""


class RadioSplit(Part):
    """From when to when some vehicles and all others do not receive each other; the ground station receives all."""

    sysids: Annotated[tuple[SysId, ...], Field(min_length=1)]
    """system ids of the vehicles on one side"""
    from_s: Seconds
    """begin, s of session time"""
    to_s: Seconds
    """end, s of session time; after `from_s`"""


class Radio(Part):
    """Faults of the radio link, each way: shares of all frames, and seconds
    (docs/protocol.md#radio-impairment)."""

    loss: Fraction = 0.0
    """share of frames lost, 0 to 1"""
    delay_s: Seconds = 0.0
    """delay of every frame, s"""
    jitter_s: Seconds = 0.0
    """additional random delay, uniform from 0 to this, s"""
    duplicate: Fraction = 0.0
    """share of frames that arrive twice, 0 to 1"""
    reorder: Fraction = 0.0
    """share of frames that arrive after the one sent next, 0 to 1"""
    blackouts: tuple[Blackout, ...] = ()
    """times at which nothing from or to a vehicle arrives"""
    ground_blackouts: tuple[GroundBlackout, ...] = ()
    """times at which the ground station's own radio is dead; vehicles that compete on board go on receiving each
    other"""
    splits: tuple[RadioSplit, ...] = ()
    """times at which a part of the vehicles and the rest do not receive each other; with vehicles that compete on
    board"""

    @property
    def random(self) -> bool:
        """Whether the seed decides what happens to frames."""
        return any((self.loss, self.jitter_s, self.duplicate, self.reorder))


class Record(Part):
    """Files that a session leaves on disk, and how large they become (docs/protocol.md#rotation)."""

    rotate_mb: Annotated[int, Field(strict=True, ge=1, le=1_000_000)] | None = None
    """once session.tlog and decisions.jsonl are larger together, they go on in new files; MB; never without it"""
    keep: Annotated[int, Field(strict=True, ge=1, le=9999)] | None = None
    """so many of the files that were full are kept, the oldest go; all without it"""
    decisions: Literal["all", "changes"] = "all"
    """`changes`: a set point that the one before it foretells to 5 cm and 5 cm/s is not written, for 1 s at most"""
    truth_hz: Annotated[float, Field(strict=True, gt=0, le=250)] | None = None
    """vehicles record their truth so often, without the thrust of each step; every grant without it"""


class Base(Part):
    """A giver on the ground, with a rate and a stock; it serves one vehicle at a time."""

    name: Label
    """name in messages and records; unique"""
    position_m: Vec3
    """where vehicles land"""
    rate_w: Positive = 2000.0
    """charging power, W"""
    stock_j: Annotated[float, Field(strict=True, gt=0, lt=1 << 31)]
    """whole joules of it are given"""
    radius_m: Metres = 1.0
    """how far from its place a vehicle may stand and still be charged"""
    height_m: Metres = 2.5
    """the height above it from which vehicles come down"""

    @property
    def above_m(self) -> tuple[float, float, float]:
        """NED; where vehicles come down from."""
        n, e, d = self.position_m
        return (n, e, d - self.height_m)


def base_conflicts(
    bases: Sequence[Base], pursuers: Sequence[Pursuer], obstacles: Sequence[Obstacle], *, capture_m: float
) -> Iterator[Conflict]:
    """Fault that keeps bases and the vehicles that need them from working together; `capture_m` is refuelling's."""
    launched = any(pursuer.external is None for pursuer in pursuers)
    for i, base in enumerate(bases):
        place = ("bases", i, "position_m")
        if launched and base.position_m[2] != 0.0:
            yield Conflict(place, f"the base {base.name} must stand on the ground: its third number is 0")
        if launched and base.radius_m > capture_m:
            sentence = f"radius_m is at most refuelling.capture_m, {capture_m:g}: vehicles take nothing from beyond it"
            yield Conflict(("bases", i, "radius_m"), sentence)
        for j, obstacle in enumerate(obstacles):
            if obstacle.fault():
                continue
            if min(map(obstacle.clearance_m, (base.position_m, base.above_m))) < LEAST_BASE_CLEARANCE_M:
                what = obstacle.name or f"{obstacle.kind} {j + 1}"
                sentence = (
                    f"the base {base.name} lies inside or within {LEAST_BASE_CLEARANCE_M} m of the obstacle {what}"
                )
                yield Conflict(place, sentence, ("obstacles", j))
        for other in range(i):
            if bases[other].name == base.name:
                yield Conflict(("bases", i, "name"), f"the name {base.name} is given twice", ("bases", other, "name"))
    for i, pursuer in enumerate(pursuers):
        if bases and pursuer.transfer is False and pursuer.airborne:
            sentence = f"{pursuer.label} starts airborne, without a ground, and so cannot land at a base"
            yield Conflict(("vehicles", "pursuers", i, "airborne"), sentence)
