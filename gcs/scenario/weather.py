"""Weather, and what a vehicle on rotors knows and is flown by: parts of a scenario."""

from itertools import pairwise
from typing import Annotated

from pydantic import AfterValidator, Field, model_validator

from gcs.scenario.external import REAL_KINDS, RealKind, Wait
from gcs.scenario.parts.reach import Asks
from gcs.scenario.types import Coordinate, Exact, NotNegative, Part, Positive, Seconds


def _ascending(axis: tuple[float, ...]) -> tuple[float, ...]:
    if any(b <= a for a, b in pairwise(axis)):
        raise ValueError("must ascend")
    return axis


class Sensors(Part):
    """Errors of what a vehicle knows of its own motion (docs/model/world.md#estimate-errors) [choice]: the standard
    deviation of each axis, and the time over which it is correlated. It needs `plant: rotors`. A real autopilot, which
    estimates by itself, has them as errors of its sensors (docs/model/world.md#sensors)."""

    position_m: NotNegative = 0.3
    """error of the position, m"""
    position_s: Positive = 60.0
    """correlation time of the position's error, s"""
    velocity_m_s: NotNegative = 0.05
    """error of the velocity, m/s"""
    velocity_s: Positive = 2.0
    """correlation time of the velocity's error, s"""
    attitude_deg: NotNegative = 0.3
    """error of roll, pitch and yaw, degrees"""
    attitude_s: Positive = 10.0
    """correlation time of the angles' error, s"""
    rate_deg_s: NotNegative = 0.3
    """error of the angular rates, degrees/s"""
    rate_s: Positive = 0.02
    """correlation time of the rates' error, s"""
    accel_m_s2: NotNegative = 0.1
    """error of the accelerometers of a real autopilot, m/s²; our own has none"""
    accel_s: Positive = 0.02
    """correlation time of the accelerometers' error, s"""


Compass = Annotated[float, Exact(ge=0, le=360)]
WindSpeed = Annotated[float, Exact(ge=0, le=60)]
AirSpeed = Annotated[float, Exact(ge=-60, le=60)]
Axis = Annotated[tuple[Coordinate, ...], Field(min_length=1, max_length=2000), AfterValidator(_ascending)]


class Gust(Part):
    """Discrete gust: it rises as (1 - cos)/2, holds, and falls as it rose (docs/model/world.md#wind)."""

    at_s: Seconds
    """begin, s of session time"""
    rise_s: Positive = 1.0
    """time from nothing to its whole speed, s"""
    hold_s: NotNegative = 0.0
    """time at its whole speed, s"""
    speed_m_s: WindSpeed
    """level speed, added to the wind, m/s"""
    from_deg: Compass = 0.0
    """where it comes from, degrees clockwise from north"""
    up_m_s: Annotated[float, Exact(ge=-60, le=60)] = 0.0
    """speed upwards, m/s"""


class WindTable(Part):
    """Wind by place, on a grid, added to the mean wind (docs/model/world.md#wind): between places in proportion, beyond
    the table as at its edge. An axis of one place has the same wind all along."""

    north_m: Axis = (0.0,)
    """places north of the origin, m, ascending"""
    east_m: Axis = (0.0,)
    """places east of the origin, m, ascending"""
    height_m: Axis = (0.0,)
    """heights above the scenario's height 0, m, ascending"""
    wind_m_s: Annotated[tuple[tuple[AirSpeed, AirSpeed, AirSpeed], ...], Field(min_length=1, max_length=2000)]
    """the air's velocity to north, east and up at each place, m/s: height changes first, north last"""

    @model_validator(mode="after")
    def _whole(self) -> "WindTable":
        places = len(self.north_m) * len(self.east_m) * len(self.height_m)
        if len(self.wind_m_s) != places:
            raise ValueError(
                f"wind_m_s has {len(self.wind_m_s)} rows, but {len(self.north_m)} x {len(self.east_m)} x "
                f"{len(self.height_m)} places need {places}"
            )
        return self


class Wind(Part):
    """Wind on vehicles that fly on rotors (docs/model/world.md#wind)."""

    speed_m_s: WindSpeed = 0.0
    """mean wind, m/s, the same at all heights"""
    from_deg: Compass = 0.0
    """where the mean wind comes from, degrees clockwise from north"""
    turbulence_m_s: WindSpeed = 0.0
    """gusts after Dryden, for a wind of this speed at 6 m; 7.7 is light, 15 moderate, 23 severe; 0 none"""
    gusts: tuple[Gust, ...] = ()
    """discrete gusts; none by default"""
    field: WindTable | None = None
    """wind by place, from a table; the same everywhere by default"""


CALM = Wind.model_construct()

ProgramPath = Annotated[str, Asks("program"), Field(min_length=1, max_length=4096)]


class RealAutopilot(Part):
    """An autopilot that is not ours, started with the session and flown by its clock, on our physics
    (docs/how-to/real-autopilots.md). It has one program."""

    ardupilot: ProgramPath | None = None
    """ArduCopter's program for its own simulation, `build/sitl/bin/arducopter`; a relative path counts from the
    scenario's folder, `~` is your home"""
    px4: ProgramPath | None = None
    """PX4's build for simulation, `build/px4_sitl_default`, or the program `bin/px4` in it; paths as above"""
    arm_within_s: Wait = 120.0
    """session time in which it must have found its place and let itself be armed, or it is left out"""

    @property
    def programs(self) -> dict[RealKind, str]:
        """Programs that are named, by kind: one, unless the file is wrong."""
        return {kind: path for kind in REAL_KINDS if (path := getattr(self, kind)) is not None}

    @property
    def kind(self) -> RealKind:
        """Which autopilot it is."""
        return next(iter(self.programs), "ardupilot")

    @property
    def program(self) -> str:
        """Its program, or its build's folder."""
        return self.programs[self.kind]

    @property
    def repeats(self) -> bool:
        """Whether it flies the same way again: PX4's threads take turns as the machine lets them."""
        return self.kind != "px4"
