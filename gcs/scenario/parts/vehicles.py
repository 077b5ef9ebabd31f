"""Vehicles by role, with their batteries."""

from typing import Annotated, ClassVar, Literal, Self

from pydantic import ConfigDict, model_validator

from gcs.scenario import types
from gcs.scenario.document import conflict_error
from gcs.scenario.external import External, filled
from gcs.scenario.parts.mission import Mission
from gcs.scenario.parts.parameters import parameter_conflicts
from gcs.scenario.weather import RealAutopilot, Sensors

Airframe = Literal["iris", "hummingbird", "crazyflie"]


class Battery(types.Part):
    """P = hover_w (T/mg)^(3/2) + avionics_w (docs/model/vehicle.md#battery) [choice]."""

    capacity_j: Annotated[float, types.Exact(ge=1, le=1 << 24)]
    """energy of the full battery, J"""
    initial_percent: types.Percent = 100.0
    """charge at the start, % of the capacity"""
    hover_w: Annotated[float, types.Exact(gt=0, le=1e5)] = 200.0
    """power of the motors in hover, W"""
    avionics_w: Annotated[float, types.Exact(ge=0, le=1e4)] = 10.0
    """power of everything else, W; drawn with motors off too"""
    resistance_ohm: types.NotNegative | None = None
    """with `plant: rotors`: inner resistance, Ω; by default that of a typical battery of its capacity"""


class VehicleBase(types.Part):
    """Keys of every vehicle, whatever its role."""

    role: ClassVar[str]
    _external = model_validator(mode="before")(filled)

    sysid: types.SysId
    """MAVLink system id, 1 to 254; unique"""
    name: types.Label | None = None
    """shown in place of the role; by default `pursuer 3` and the like"""
    start_m: types.Vec3
    """position at the start, m, in the file's axes; on the ground its height is 0"""
    velocity_m_s: types.Vec3 = (0.0, 0.0, 0.0)
    """velocity at the start, m/s, in the file's axes; needs `airborne: true`"""
    attitude_deg: types.Angles = (0.0, 0.0, 0.0)
    """roll, pitch, yaw"""
    airborne: types.Flag = False
    """starts flying; there is then no ground"""
    join_s: types.Seconds = 0.0
    """session time at which it joins, s; its process waits until then"""
    takeoff_m: types.Metres = 2.5
    """the height above the ground to which it climbs first"""
    battery: Battery
    """capacity, charge and consumption"""
    autopilot: RealAutopilot | Literal["own"] = "own"
    """`own`: our law; `{ardupilot: PATH}` or `{px4: PATH}`: a real one, started by the session, on rotors"""
    plant: Literal["paper", "rotors"] = "paper"
    """`paper`: the plant of the paper's eq. 3; `rotors`: a rigid body on four rotors (docs/model/vehicle.md#rotors)"""
    airframe: Airframe | None = None
    """on rotors: whose mass, rotors and drag it has (docs/model/vehicle.md#airframes); by default `iris`"""
    sensors: Sensors | None = None
    """errors of what it knows of its motion; `{}` has typical ones; without it the vehicle knows exactly"""
    params: dict[types.ParamName, types.Number] = {}  # noqa: RUF012 - pydantic copies it
    """further MAVLink parameters"""
    external: External | None = None
    """expected there rather than launched; start_m then means nothing, it is where it is"""

    @model_validator(mode="after")
    def _takes_its_parameters(self) -> Self:
        if self.params and self.real is None and self.external is None:
            full_j = self.battery.capacity_j
            initial_j = full_j * self.battery.initial_percent / 100.0
            if found := [*parameter_conflicts(self.params, capacity_j=full_j, initial_j=initial_j)]:
                raise conflict_error(found)
        return self

    @property
    def real(self) -> RealAutopilot | None:
        """The autopilot that is not ours and that the session starts; None where there is none."""
        return None if self.autopilot == "own" else self.autopilot

    @property
    def on_rotors(self) -> bool:
        """Whether it flies on rotors."""
        return self.plant == "rotors" or self.real is not None

    @property
    def is_foreign(self) -> bool:
        """Whether its autopilot is not ours, launched or external."""
        return self.real is not None or self.external is not None

    @property
    def foreign(self) -> External | None:
        """Rules for a vehicle whose autopilot is not ours, launched or external; None where it is ours."""
        if self.real is None:
            return self.external
        return External(
            connect="udpin:127.0.0.1:1",
            sysid=self.sysid,
            autopilot=self.real.kind,
            capacity_j=self.battery.capacity_j,
            arm_within_s=self.real.arm_within_s,
            rejoins=True,
        )

    @property
    def label(self) -> str:
        """For messages: `NAME (3)`, or `pursuer 3`."""
        return f"{self.name} ({self.sysid})" if self.name else f"{self.role} {self.sysid}"


class Pursuer(VehicleBase):
    """A vehicle that follows a target, or its own way points, and that is refuelled."""

    role = "pursuer"

    target: types.SysId | None = None
    """the target's sysid; without it the first target"""
    waypoints_m: tuple[types.Vec3, ...] = ()
    """visited in order, within planner.step_m each, instead of a target; it stays at the last one"""
    mission: Mission = None
    """a .plan of QGroundControl or a QGC WPL 110 file, beside the scenario: its autopilot flies these items by itself,
    instead of a target, and is watched and kept apart"""
    transfer: types.Flag | None = None
    """whether it can take energy in the air, or only a base can serve it; without it external vehicles are asked"""

    @property
    def own_way(self) -> bool:
        """Whether it follows no target."""
        return bool(self.waypoints_m or self.mission)

    @property
    def transfer_capable(self) -> bool | None:
        """Whether it can take energy in the air; None where it is to be asked."""
        asked = self.transfer is None and self.is_foreign
        return None if asked else self.transfer is not False


class Target(VehicleBase):
    """A vehicle that flies a path and is followed."""

    role = "target"

    path_m: types.Route
    """corners of its path, m, in the file's axes; flown once all vehicles are in the air"""
    speed_m_s: types.Speed
    """speed along the path, m/s"""
    laps: Annotated[int, types.Exact(ge=1, le=1_000_000)] = 1
    """how often a closed path is flown"""
    closed: types.Flag = False
    """the path leads from its last point back to its first"""


class Tanker(VehicleBase):
    """A vehicle that refuels others in the air."""

    role = "tanker"

    reserve_j: types.NotNegative = 10_000.0
    """kept to get home"""
    speed_m_s: types.Speed = 5.0
    """greatest speed on the way to a receiver and home, m/s"""
    home_m: types.Vec3 | None = None
    """where it waits; without it above its start"""


class Vehicles(types.Part):
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
        if pursuer.own_way:
            return None
        if pursuer.target is not None:
            return pursuer.target
        return self.targets[0].sysid if self.targets else None

    @property
    def on_missions(self) -> tuple[Pursuer, ...]:
        """Pursuers that fly a mission, in order of system id."""
        return tuple(sorted((p for p in self.pursuers if p.mission), key=lambda pursuer: pursuer.sysid))

    @property
    def followed(self) -> dict[int, int]:
        """The target's system id by the pursuer's, of pursuers that follow one."""
        return {p.sysid: target for p in self.pursuers if (target := self.target_of(p)) is not None}

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
