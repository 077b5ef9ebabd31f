"""A scenario: what flies, where, for how long and to what end, as typed, frozen objects.

`load` reads a YAML file, `dump` writes one. Units stand in the names; angles are in degrees. A file states its axes,
`ned` or `paper` (north, west, up; docs/protocol/frames.md#frames), and `load` converts once: every object here is NED.
"""

from collections.abc import Iterable, Iterator, Sequence
from typing import Annotated, Any, Literal, Self

from pydantic import AfterValidator, ConfigDict, Field, ValidationError, model_validator

from gcs.scenario import external
from gcs.scenario.document import Conflict, KeyPath, Problem, ScenarioError, conflict_error
from gcs.scenario.faults import Fault, fault_conflicts
from gcs.scenario.fence import NO_FENCE, FenceRules, fence_conflicts
from gcs.scenario.parts import mission
from gcs.scenario.parts.bases import Base, base_conflicts
from gcs.scenario.parts.radio import PERFECT, Blackout, Radio
from gcs.scenario.parts.reach import Shown
from gcs.scenario.parts.session import STEP_S, Clock, Goal, Origin, Pursue, Record, known_axes
from gcs.scenario.parts.surroundings import Attractor, Mover, Obstacle
from gcs.scenario.parts.vehicles import Battery, Pursuer, Tanker, Target, VehicleBase, Vehicles
from gcs.scenario.rules import (
    SURFACE_FLOOR_M,
    CompetitionRules,
    FormationRules,
    PlannerRules,
    PursuitRules,
    RefuellingRules,
)
from gcs.scenario.station import Forward, Station, station_conflicts
from gcs.scenario.types import Count, Exact, Flag, Part, Plane, explained, plain_numbers
from gcs.scenario.weather import CALM, Wind
from skytender import elementary

__all__ = [
    "Attractor",
    "Base",
    "Battery",
    "Blackout",
    "Clock",
    "CompetitionRules",
    "Fault",
    "FormationRules",
    "Goal",
    "Mover",
    "Obstacle",
    "Origin",
    "PlannerRules",
    "Problem",
    "Pursue",
    "Pursuer",
    "PursuitRules",
    "Radio",
    "Record",
    "RefuellingRules",
    "Scenario",
    "ScenarioError",
    "Tanker",
    "Target",
    "VehicleBase",
    "Vehicles",
    "Wind",
]

START_CLEARANCE_M = 0.3
LONGEST_RELAY_S = 0.2
SEA_LEVEL_KG_M3 = 1.225
TRANSFER_SILENCE_S = 1.0
TRANSFER_HOPS = 4
"""Giver, supervisor, receiver and back: within the silence the giver's joules must be seen to have arrived."""
MOST_MOVERS = 100
"""A tick holds at most 127 frames of one sender (docs/protocol/link.md#answer)."""
MOST_PEERS = 40
"""Vehicles whose reports fit a bundle together, twice a second (docs/protocol/onboard.md#peer-reports)."""
NO_PURSUIT = "a competition for targets needs a pursuer and a target"
NO_EFFORT = "external vehicles report no control effort: leave them out of the pursuers, or"


class Scenario(Part):
    """One session's world."""

    model_config = ConfigDict(populate_by_name=True)

    # Parts left out are constructed, not validated: for that each would have a validator of its own built here.

    schema_version: Annotated[int, Field(strict=True, ge=1, le=1, alias="schema")]
    """version of the file format; 1"""
    name: Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9._-]{0,63}$")]
    """also the session folder's"""
    description: Annotated[str, Shown()] = ""
    """free text, shown in reports"""
    axes: Annotated[Literal["paper", "ned"], AfterValidator(known_axes)]
    """of all geometry in the file; `ned` once loaded"""
    seed: Count = 1
    """of everything random (radio, faults, gusts, sensors); the same scenario and seed give the same session"""
    origin: Origin
    """where on the globe the common frame's zero lies"""
    clock: Clock = Clock.model_construct()
    """pace and planner period"""
    goal: Goal
    """when the session counts as met, and how long it is"""
    vehicles: Vehicles
    """pursuers, targets and tankers"""
    obstacles: tuple[Obstacle, ...] = ()
    """static obstacles; none by default"""
    attractors: tuple[Attractor, ...] = ()
    """points that draw pursuers; none by default"""
    traffic: tuple[Mover, ...] = ()
    """other aircraft, reported by ADSB_VEHICLE; none by default"""
    bases: tuple[Base, ...] = ()
    """places on the ground where vehicles are charged; none by default"""
    planner: PlannerRules = PlannerRules.model_construct()
    """potential field and fuzzy escape, or a planner of your own"""
    pursuit: PursuitRules = PursuitRules.model_construct()
    """which pursuers follow their target"""
    formation: FormationRules = FormationRules.model_construct()
    """the pursuers' places around their target"""
    competition: CompetitionRules = CompetitionRules.model_construct()
    """which vehicle is refuelled next"""
    refuelling: RefuellingRules = RefuellingRules.model_construct()
    """rendezvous and transfer of energy"""
    wind: Wind = CALM
    """wind and gusts on vehicles with `plant: rotors`; none by default"""
    air_density_kg_m3: Annotated[float, Exact(gt=0, le=2)] = 1.225
    """density of the air that rotors work in, kg/m³; by default that at sea level"""
    radio: Radio = PERFECT
    """loss, delay and blackouts of frames; none by default"""
    faults: tuple[Fault, ...] = ()
    """what goes wrong, at a time or by chance; nothing by default"""
    vehicles_per_process: Annotated[int, Exact(ge=1, le=254)] = 1
    """how many fly in one process; nothing else depends on it"""
    station: Station = Station.model_construct()
    """our own ids for external vehicles; 255/190 by default"""
    forward: Forward = Forward.model_construct()
    """other ground stations that hear the vehicles too; none by default"""
    fence: FenceRules = NO_FENCE
    """geofence that is uploaded to every vehicle before it is armed, and read back; none by default"""
    rally_m: tuple[Plane, ...] = ()
    """places to come down at in need, uploaded like the fence; the first two coordinates, m; none by default"""
    plan: Annotated[str, Shown()] | None = None
    """a .plan of QGroundControl or a QGC WPL 110 file, beside the scenario, that gives `fence` and `rally_m` instead"""
    preflight: Literal["enforce", "warn"] = "enforce"
    """a vehicle that fails its check list (fence, rally points, clock) is not armed, or is only warned of"""
    logs: Flag = False
    """after the flight the newest log of each external vehicle is downloaded into the session's folder"""
    record: Record = Record.model_construct()
    """files that the session leaves, and how large they become; everything in one file each by default"""
    truth: Flag = True
    """launched vehicles record what they themselves know (docs/protocol/folder.md#truth)"""

    @property
    def random_weather(self) -> bool:
        """Whether the seed decides what wind and sensors do."""
        rotors = [vehicle for vehicle in self.vehicles.launched if vehicle.on_rotors]
        return any(vehicle.sensors is not None for vehicle in rotors) or bool(rotors and self.wind.turbulence_m_s)

    def flown(
        self,
        *,
        lockstep: bool = False,
        speed: float | None = None,
        seed: int | None = None,
        key_file: str | None = None,
        forward: Sequence[str] = (),
        forward_control: bool = False,
        logs: bool = False,
    ) -> Self:
        """The same with another clock or seed, a signing key for all external vehicles, or further addresses to forward
        to; what is left out stays. ValueError where a value cannot be had."""
        clock: dict[str, Any] = {}
        speed, seed = plain_numbers(speed), plain_numbers(seed)
        if lockstep:
            clock = {"mode": "lockstep"}
        elif speed is not None:
            clock = {"mode": "real", "speed": speed}
        if (refusal := external.clock_refusal(self.vehicles.all, clock.get("mode", self.clock.mode))) is not None:
            raise ValueError(refusal)
        changed = self.model_dump(by_alias=True)
        changed["clock"] |= clock
        changed |= ({} if seed is None else {"seed": seed}) | ({"logs": True} if logs else {})
        if forward or forward_control:
            to = (*self.forward.to, *(text for text in forward if text not in self.forward.to))
            changed["forward"] = {"to": to, "control": forward_control or self.forward.control}
        if key_file is not None:
            external.give_key(changed["vehicles"], key_file)
        try:
            return type(self).model_validate(changed)
        except ValidationError as error:
            raise ValueError(explained(error, type(self), changed, "the scenario")) from None

    @model_validator(mode="after")
    def _agrees(self) -> Self:
        capture_m, pursuers = self.refuelling.capture_m, self.vehicles.pursuers
        grounded = base_conflicts(self.bases, pursuers, self.obstacles, capture_m=capture_m)
        faulty = fault_conflicts(self.faults, self.vehicles.all, self.goal.duration_s)
        fenced = fence_conflicts(self.fence, self.rally_m)
        known = station_conflicts(self.station, {vehicle.sysid for vehicle in self.vehicles.all})
        if conflicts := [*_conflicts(self), *_vehicle_conflicts(self), *grounded, *faulty, *fenced, *known]:
            raise conflict_error(conflicts)
        return self


def _conflicts(s: Scenario) -> Iterator[Conflict]:
    """Values that are right one by one but not together, the vehicles' own apart."""
    steps, sysids = s.clock.period_s / STEP_S, {vehicle.sysid for vehicle in s.vehicles.all}
    pursue, pursuers, targets, tankers = s.goal.pursue, s.vehicles.pursuers, s.vehicles.targets, s.vehicles.tankers
    refuels = s.refuelling.enabled and pursuers and (tankers or s.bases)
    mean_delay_s = s.radio.delay_s + 0.5 * s.radio.jitter_s
    longest_delay_s = max(TRANSFER_SILENCE_S - 2.0 * s.clock.period_s, 0.0) / TRANSFER_HOPS
    clock_refused = external.clock_refusal(s.vehicles.all, s.clock.mode)
    rules: list[tuple[Any, KeyPath, str]] = [
        (clock_refused, ("clock", "mode"), clock_refused or ""),
        (
            s.plan is not None,
            ("plan",),
            "plan is read with a scenario's file, beside which it lies: load the scenario by gcs.load",
        ),
        (not sysids, ("vehicles",), "there must be at least one vehicle"),
        (
            s.logs and not s.vehicles.external,
            ("logs",),
            "logs are fetched from external vehicles, and there is none: those of launched ones are in vehicles/",
        ),
        (abs(steps - round(steps)) > 1e-6, ("clock", "period_s"), f"period_s must be a multiple of {STEP_S} s"),
        (pursue and pursue.for_s > s.goal.duration_s, ("goal", "pursue", "for_s"), "for_s is longer than duration_s"),
        (pursue and not (pursuers and targets), ("goal", "pursue"), "pursue needs a pursuer and a target"),
        (
            s.goal.refuelled_at_least and not refuels,
            ("goal", "refuelled_at_least"),
            "refuelled_at_least needs a pursuer, a tanker or a base, and refuelling enabled",
        ),
        (s.pursuit.by == "competition" and not (pursuers and targets), ("pursuit", "by"), NO_PURSUIT),
        (
            s.planner.full_steps and s.planner.safety,
            ("planner", "full_steps"),
            "full_steps needs 'safety: false': the safety filter slows points down before their goals",
        ),
        (
            s.planner.b * s.planner.repulsion_range_m <= SURFACE_FLOOR_M,
            ("planner", "repulsion_range_m"),
            f"b times repulsion_range_m must be above {SURFACE_FLOOR_M} m, where the repulsion stops growing",
        ),
        (s.formation.ring_m and not targets, ("formation", "ring_m"), "a formation needs a target"),
        (
            refuels and s.clock.period_s > LONGEST_RELAY_S,
            ("clock", "period_s"),
            f"refuelling needs a period_s of at most {LONGEST_RELAY_S}: transfers break off after 1 s of silence",
        ),
        (
            refuels and mean_delay_s > longest_delay_s + 1e-9,
            ("radio", "delay_s"),
            f"refuelling needs delay_s + jitter_s / 2 of at most {longest_delay_s:g} s, not {mean_delay_s:g}: "
            "transfers break off after 1 s of silence; or set 'refuelling: {enabled: false}'",
        ),
        (
            len(s.traffic) > MOST_MOVERS,
            ("traffic",),
            f"one ADS-B receiver tells of at most {MOST_MOVERS} aircraft in time",
        ),
        (s.competition.floor >= s.competition.high, ("competition", "floor"), "floor must be below high"),
        (
            s.refuelling.height_m >= s.refuelling.capture_m,
            ("refuelling", "height_m"),
            "height_m must be below capture_m, or no transfer would begin",
        ),
    ]
    rules += _weather_rules(s)
    rules += _onboard_rules(s)
    silent = any(pursuer.external is not None for pursuer in pursuers)
    measured, by_effort = s.pursuit.bids == "measured", s.competition.bids == "effort"
    rules += [
        (s.pursuit.by == "competition" and measured and silent, ("pursuit", "bids"), f"{NO_EFFORT} bids: predicted"),
        (by_effort and silent, ("competition", "bids"), f"{NO_EFFORT} bids: need"),
    ]
    for i, silence in enumerate(s.radio.ground_blackouts):
        path: KeyPath = ("radio", "ground_blackouts", i, "to_s")
        rules.append((silence.from_s >= silence.to_s, path, "to_s must be after from_s"))
    for i, split in enumerate(s.radio.splits):
        rules.append((split.from_s >= split.to_s, ("radio", "splits", i, "to_s"), "to_s must be after from_s"))
        missing = sorted(set(split.sysids) - sysids)
        rules.append((missing, ("radio", "splits", i, "sysids"), f"there is no vehicle {missing[0] if missing else 0}"))
    rules += [
        (s.record.keep and not s.record.rotate_mb, ("record", "keep"), "keep needs rotate_mb"),
        (s.record.truth_hz and not s.truth, ("record", "truth_hz"), "truth_hz needs 'truth: true'"),
    ]
    for i, blackout in enumerate(s.radio.blackouts):
        path = ("radio", "blackouts", i)
        rules.append((blackout.sysid not in sysids, (*path, "sysid"), f"there is no vehicle {blackout.sysid}"))
        rules.append((blackout.from_s >= blackout.to_s, (*path, "to_s"), "to_s must be after from_s"))
    for i, obstacle in enumerate(s.obstacles):
        rules.append((obstacle.fault(), ("obstacles", i), obstacle.fault()))
    for i, mover in enumerate(s.traffic):
        yield from route_conflicts(("traffic", i, "path_m"), mover)
    yield from repeats("callsign", [(("traffic", i, "callsign"), mover.callsign) for i, mover in enumerate(s.traffic)])
    yield from (Conflict(path, sentence) for broken, path, sentence in rules if broken)


def _weather_rules(s: Scenario) -> list[tuple[Any, KeyPath, str]]:
    """Conditions of weather: (broken, where, sentence)."""
    blows = s.wind != CALM
    rotors = any(vehicle.on_rotors for vehicle in s.vehicles.launched)
    return [
        (blows and not rotors, ("wind",), "wind moves vehicles with 'plant: rotors', and there is none"),
        (
            s.air_density_kg_m3 != SEA_LEVEL_KG_M3 and not rotors,
            ("air_density_kg_m3",),
            "air_density_kg_m3 is for vehicles with 'plant: rotors', and there is none",
        ),
    ]


def keeps_apart(s: Scenario) -> bool:
    """Whether launched vehicles receive the places of each other and of aircraft, and keep apart on board while they
    fly by themselves."""
    ours = sum(vehicle.real is None for vehicle in s.vehicles.launched)
    return s.planner.safety and s.planner.vehicles_repel and ours > (0 if s.traffic else 1)


def _onboard_rules(s: Scenario) -> list[tuple[Any, KeyPath, str]]:
    """Conditions of a competition on board: (broken, where, sentence)."""
    where: KeyPath = ("competition", "where")
    if s.competition.where == "supervisor":
        alone = s.radio.splits and not keeps_apart(s)
        return [(alone, ("radio", "splits"), "splits need launched vehicles that the safety filter keeps apart")]
    rules, vehicles = s.competition, s.vehicles
    refuels = rules.enabled and s.refuelling.enabled and vehicles.pursuers and vehicles.tankers
    return [
        (
            not refuels,
            where,
            "vehicles compete on board for tankers: it needs a pursuer, a tanker, and refuelling enabled",
        ),
        (vehicles.external, where, "external vehicles do not compete on board: leave them out, or where: supervisor"),
        (
            set(vehicles.foreign) - set(vehicles.external),
            where,
            "real autopilots do not compete on board: leave them out, or where: supervisor",
        ),
        (s.bases, where, "bases are the supervisor's: leave them out, or where: supervisor"),
        (rules.policy != "winner_take_all", where, "on board there is the policy winner_take_all alone"),
        (
            rules.bids not in {"losses", "time"},
            where,
            "on board there are bids by losses and by time alone",
        ),
        (
            len(vehicles.all) > MOST_PEERS,
            where,
            f"at most {MOST_PEERS} vehicles compete on board: more reports do not fit the radio, 1,400 bytes a tick",
        ),
    ]


def _vehicle_conflicts(s: Scenario) -> Iterator[Conflict]:
    """Ids, names, starts, paths and batteries that do not go with each other or with the rest."""
    targets = {target.sysid for target in s.vehicles.targets}
    placed: list[tuple[KeyPath, VehicleBase]] = []
    for group in (s.vehicles.pursuers, s.vehicles.targets, s.vehicles.tankers):
        placed.extend((("vehicles", f"{vehicle.role}s", i), vehicle) for i, vehicle in enumerate(group))
    yield from repeats("sysid", [((*path, "sysid"), vehicle.sysid) for path, vehicle in placed])
    yield from repeats("name", [((*path, "name"), vehicle.name) for path, vehicle in placed if vehicle.name])
    yield from external.key_conflicts(placed)
    solids = [(j, obstacle) for j, obstacle in enumerate(s.obstacles) if not obstacle.fault()]
    for i, (path, vehicle) in enumerate(placed):
        yield from external.conflicts(path, vehicle)
        if vehicle.join_s >= s.goal.duration_s:
            yield Conflict((*path, "join_s"), f"{vehicle.label} would join after the end, duration_s")
        if isinstance(vehicle, Pursuer) and vehicle.target is not None and vehicle.target not in targets:
            yield Conflict((*path, "target"), f"{vehicle.label} follows {vehicle.target}, which is no target's sysid")
        if isinstance(vehicle, Pursuer) and vehicle.target is not None and vehicle.waypoints_m:
            yield Conflict((*path, "waypoints_m"), f"{vehicle.label} has waypoints_m and a target; leave one out")
        if isinstance(vehicle, Pursuer) and vehicle.mission is not None:
            yield from mission.conflicts(path, vehicle, s)
        if isinstance(vehicle, Tanker) and vehicle.reserve_j >= vehicle.battery.capacity_j:
            yield Conflict((*path, "reserve_j"), f"{vehicle.label} has a reserve_j above its capacity_j")
        if isinstance(vehicle, Target):
            yield from route_conflicts((*path, "path_m"), vehicle)
        yield from _plant_conflicts(path, vehicle)
        if vehicle.external is None:
            yield from _start_conflicts(s, path, vehicle, placed[:i], solids)


def _real_conflicts(path: KeyPath, vehicle: VehicleBase) -> Iterator[Conflict]:
    """Programs of a real autopilot, and keys that it has no use for."""
    if vehicle.real is not None and len(vehicle.real.programs) != 1:
        text = f"{vehicle.label} needs one program: 'autopilot: {{ardupilot: PATH}}' or 'autopilot: {{px4: PATH}}'"
        yield Conflict((*path, "autopilot"), text)
    if vehicle.airborne:
        text = f"{vehicle.label} has a real autopilot: airborne is for our own; leave it out"
        yield Conflict((*path, "airborne"), text)


def _plant_conflicts(path: KeyPath, vehicle: VehicleBase) -> Iterator[Conflict]:
    """Keys that only a vehicle on rotors can have."""
    if vehicle.real is not None:
        yield from _real_conflicts(path, vehicle)
    if vehicle.on_rotors:
        return
    for key, name in (("airframe", "an airframe"), ("sensors", "sensors")):
        if getattr(vehicle, key) is not None:
            yield Conflict((*path, key), f"{vehicle.label} has {name}; it needs 'plant: rotors'")
    if vehicle.battery.resistance_ohm is not None and vehicle.external is None:
        place = (*path, "battery", "resistance_ohm")
        yield Conflict(place, f"{vehicle.label} has a resistance_ohm; it needs 'plant: rotors'")


def _start_conflicts(
    s: Scenario,
    path: KeyPath,
    vehicle: VehicleBase,
    before: Iterable[tuple[KeyPath, VehicleBase]],
    solids: Iterable[tuple[int, Obstacle]],
) -> Iterator[Conflict]:
    """Start of a launched vehicle, and what stands there: `solids` of the obstacles, and those `before` it."""
    start = (*path, "start_m")
    if not vehicle.airborne:
        if any(vehicle.velocity_m_s):
            yield Conflict((*path, "velocity_m_s"), f"{vehicle.label} moves on the ground; it needs 'airborne: true'")
        if vehicle.start_m[2] < 0:
            yield Conflict(start, f"{vehicle.label} starts above the ground; it needs 'airborne: true'")
        if vehicle.start_m[2] > 0:
            yield Conflict(start, f"{vehicle.label} starts below the ground; in ned axes the third number is down")
    for j, obstacle in solids:
        if obstacle.clearance_m(vehicle.start_m) < START_CLEARANCE_M:
            what = obstacle.name or f"{obstacle.kind} {j + 1}"
            sentence = f"{vehicle.label} starts inside or within {START_CLEARANCE_M} m of the obstacle {what}"
            yield Conflict(start, sentence, ("obstacles", j))
    for other_path, other in before:
        if other.external is not None:
            continue
        distance_m = elementary.distance(vehicle.start_m, other.start_m)
        together = s.planner.vehicles_repel and vehicle.join_s == other.join_s
        if together and distance_m < s.planner.separation_m:
            sentence = f"{vehicle.label} starts {distance_m:.2f} m from {other.label}, below planner.separation_m"
            yield Conflict(start, sentence, (*other_path, "start_m"))


def repeats(key: str, values: Iterable[tuple[KeyPath, object]]) -> Iterator[Conflict]:
    """Values of `key`, by where they stand, that are given twice."""
    first: dict[object, KeyPath] = {}
    for path, value in values:
        if first.setdefault(value, path) != path:
            yield Conflict(path, f"the {key} {value} is given twice", first[value])


def route_conflicts(path: KeyPath, flier: Target | Mover) -> Iterator[Conflict]:
    """Paths that cannot be flown; `path` is where path_m stands."""
    points = flier.path_m
    if flier.closed and len(points) < 2:
        yield Conflict(path, "a closed path needs at least 2 points")
    for i in range(1, len(points)):
        if points[i] == points[i - 1] or (flier.closed and 1 < i == len(points) - 1 and points[i] == points[0]):
            yield Conflict((*path, i), "path_m repeats a point here and would stand still; leave the point out")
    if isinstance(flier, Target) and flier.laps > 1 and not flier.closed:
        yield Conflict((*path[:-1], "laps"), "more than one lap needs 'closed: true'")
