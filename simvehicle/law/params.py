"""Parameters of a vehicle: frozen airframe, gains, limits, battery and guidance, and the named sets of them.

Every object is checked when it is made; `pack` lays a set out as the flat vector that the compiled flight core reads.
An infinite limit is an absent one.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from simvehicle.law.rows import PARAMETERS, PARAMS_SIZE
from skytender import elementary

STEP_S = 0.004  # the law's period: 250 Hz
SOLVE_TOLERANCE = 1e-6  # rad/s², last correction of the differentiator's solve (differentiator.py)


def _require(holds: bool, name: str, value: float, condition: str) -> None:
    """Refuse a value that breaks its condition.

    Raises:
        ValueError: one sentence that names the parameter, its value and the condition.
    """
    if not holds:
        raise ValueError(f"{name} is {value!r}, but it must be {condition}")


def _require_positive(name: str, value: float, *, finite: bool = True) -> None:
    if finite:
        _require(0.0 < value < math.inf, name, value, "greater than 0 and finite")
    else:
        _require(value > 0.0, name, value, "greater than 0 (infinite switches the limit off)")


def _require_not_negative(name: str, value: float) -> None:
    _require(0.0 <= value < math.inf, name, value, "0 or greater, and finite")


@dataclass(frozen=True, kw_only=True)
class Airframe:
    """The body (docs/model/vehicle.md#rigid-body) [seed]: mass, arm L, gravity, drag Kx = Ky = Kz, Kφ = Kθ = Kψ and Iφ
    = Iθ = Iψ.

    Raises:
        ValueError: a mass, arm, gravity or inertia that is not positive, a drag that is negative.
    """

    mass_kg: float = 2.0
    arm_m: float = 0.2
    gravity_m_s2: float = 9.8
    drag_kg_s: float = 0.1
    rotational_drag: float = 0.015
    inertia: float = 1.25

    def __post_init__(self) -> None:
        _require_positive("airframe.mass_kg", self.mass_kg)
        _require_positive("airframe.arm_m", self.arm_m)
        _require_positive("airframe.gravity_m_s2", self.gravity_m_s2)
        _require_not_negative("airframe.drag_kg_s", self.drag_kg_s)
        _require_not_negative("airframe.rotational_drag", self.rotational_drag)
        _require_positive("airframe.inertia", self.inertia)

    @property
    def drag_1_s(self) -> float:
        """K/m, 1/s."""
        return self.drag_kg_s / self.mass_kg

    @property
    def rotational_drag_1_s(self) -> float:
        """L Kγ/Iγ, 1/s."""
        return self.arm_m * self.rotational_drag / self.inertia


@dataclass(frozen=True, kw_only=True)
class Gains:
    """Gains of the two loops (docs/model/control.md#control-law) and ε of the differentiators
    (docs/model/control.md#differentiator).

    `speed` is λ (1/s), `rate` Ap (1/s), `angle` Aq (1/s²), `epsilon` ε (s).

    Raises:
        ValueError: λ, Aq or ε is not positive. Ap is held against the airframe's drag in `VehicleParams`.
    """

    speed: float = 3.0
    rate: float = 12.0
    angle: float = 36.0
    epsilon: float = 0.04

    def __post_init__(self) -> None:
        _require_positive("gains.speed", self.speed)
        _require(math.isfinite(self.rate), "gains.rate", self.rate, "finite")
        _require_positive("gains.angle", self.angle)
        _require_positive("gains.epsilon", self.epsilon)


@dataclass(frozen=True, kw_only=True)
class Limits:
    """Limits of the vehicle: tilt, mass-normalised thrust u1, |tau_k| for k = 2..4, |v*|, and |q''| of the guidance.

    Raises:
        ValueError: a limit that is not positive, a tilt of 90° or more (other than infinite).
    """

    tilt_rad: float = math.inf
    thrust_m_s2: float = math.inf
    angular_acceleration_rad_s2: float = math.inf
    speed_m_s: float = 5.0
    acceleration_m_s2: float = 5.0

    def __post_init__(self) -> None:
        _require(
            0.0 < self.tilt_rad < math.pi / 2 or self.tilt_rad == math.inf,
            "limits.tilt_rad",
            self.tilt_rad,
            "greater than 0 and less than pi/2 (infinite switches the limit off)",
        )
        for name in ("thrust_m_s2", "angular_acceleration_rad_s2", "speed_m_s", "acceleration_m_s2"):
            _require_positive(f"limits.{name}", getattr(self, name), finite=False)

    @property
    def tilt_slope(self) -> float:
        """tan of the tilt limit: the most horizontal acceleration per vertical one."""
        return elementary.tan(self.tilt_rad) if math.isfinite(self.tilt_rad) else math.inf


@dataclass(frozen=True, kw_only=True)
class BatteryParams:
    """Battery and what is drawn from it (docs/model/vehicle.md#battery) [choice]. An infinite `initial_j`, the default,
    means full.

    Raises:
        ValueError: capacity not positive, initial charge outside 0..capacity, a negative power.
    """

    capacity_j: float = 24_000.0
    initial_j: float = math.inf
    hover_w: float = 200.0
    avionics_w: float = 10.0

    def __post_init__(self) -> None:
        _require_positive("battery.capacity_j", self.capacity_j)
        if self.initial_j == math.inf:
            object.__setattr__(self, "initial_j", self.capacity_j)
        in_range = 0.0 <= self.initial_j <= self.capacity_j
        _require(in_range, "battery.initial_j", self.initial_j, f"from 0 to the capacity, {self.capacity_j!r}")
        _require_not_negative("battery.hover_w", self.hover_w)
        _require_not_negative("battery.avionics_w", self.avionics_w)


@dataclass(frozen=True, kw_only=True)
class Guidance:
    """From set points to a reference (docs/model/control.md#guidance) [choice].

    `shaped` is the default's filtered reference; False is the paper's: v_d linear between set points, yaw constant.
    `gain` K (1/s) and `decel` a (m/s²) of the square-root controller, `velocity_gain` of q'' (1/s), `omega` ω of the
    lags (1/s), `reference_gain` of r - p (1/s), `yaw_rate_rad_s` the fastest turn of the yaw reference.

    Raises:
        ValueError: a value that is not positive, or a gain too fast for the law's period.
    """

    shaped: bool = True
    gain: float = 2.5
    decel: float = 2.5
    velocity_gain: float = 10.0
    omega: float = 10.0
    reference_gain: float = 1.0
    yaw_rate_rad_s: float = 1.0

    def __post_init__(self) -> None:
        _require_positive("guidance.decel", self.decel)
        _require_positive("guidance.yaw_rate_rad_s", self.yaw_rate_rad_s)
        for name in ("gain", "velocity_gain", "omega", "reference_gain"):
            value = getattr(self, name)
            fastest = 1.0 / STEP_S
            _require(0.0 < value <= fastest, f"guidance.{name}", value, f"greater than 0 and at most {fastest:g}")


@dataclass(frozen=True, kw_only=True)
class VehicleParams:
    """Everything the flight core knows of one vehicle.

    `bumpless` starts X1 of the differentiators at the first angle; False is the paper's X(0) = 0
    (docs/model/control.md#differentiator). `literal` flies the speed loop without its floor, with signed thrust
    (docs/model/control.md#speed-loop); limits of tilt and thrust do not go with it.

    Raises:
        ValueError: an inner loop that is unstable, by Remark 1 of the paper (Ap + L Kγ/Iγ > 0; Aq > 0 is checked in
            `Gains`) or because the law is sampled every `STEP_S` with its torque held, a thrust limit that cannot
            carry the weight, or limits beside `literal`.
    """

    airframe: Airframe = field(default_factory=Airframe)
    gains: Gains = field(default_factory=Gains)
    limits: Limits = field(default_factory=Limits)
    battery: BatteryParams = field(default_factory=BatteryParams)
    guidance: Guidance = field(default_factory=Guidance)
    bumpless: bool = True
    literal: bool = False

    def __post_init__(self) -> None:
        gains, airframe = self.gains, self.airframe
        drag = airframe.rotational_drag_1_s
        damping = gains.rate + drag
        _require(damping > 0.0, "gains.rate", gains.rate, f"greater than -L*K/I = {-drag:.6g}")
        # Jury's test of γ'' = -Ap γ' - Aq γ with the torque held for one step.
        fastest = 2.0 / STEP_S
        _require(damping < fastest, "gains.rate", gains.rate, f"less than {fastest:g} 1/s at {1 / STEP_S:g} Hz")
        stiffest = fastest * damping
        _require(
            gains.angle < stiffest, "gains.angle", gains.angle, f"less than {stiffest:.6g} 1/s^2 for this rate gain"
        )
        thrust, gravity = self.limits.thrust_m_s2, airframe.gravity_m_s2
        _require(thrust > gravity, "limits.thrust_m_s2", thrust, f"greater than gravity, {gravity:g}")
        if self.literal:
            _require(thrust == math.inf, "limits.thrust_m_s2", thrust, "infinite with the literal speed loop")
            _require(self.limits.tilt_rad == math.inf, "limits.tilt_rad", self.limits.tilt_rad, "infinite with it")


_PAPER = VehicleParams(
    gains=Gains(speed=3.0, rate=1.5, angle=1.5),
    limits=Limits(speed_m_s=math.inf, acceleration_m_s2=math.inf),
    guidance=Guidance(shaped=False),
    bumpless=False,
)
NAMED: Mapping[str, VehicleParams] = MappingProxyType(
    {
        "default": VehicleParams(
            limits=Limits(tilt_rad=math.radians(35.0), thrust_m_s2=19.6, angular_acceleration_rad_s2=30.0),
        ),
        "paper": _PAPER,
        "paper_literal": replace(_PAPER, literal=True),
    }
)


def pack(params: VehicleParams) -> NDArray[np.float64]:
    """Lay a set out for the flight core: shape (PARAMS_SIZE,), as rows.pxd has them, SI units."""
    airframe, gains, limits, battery = params.airframe, params.gains, params.limits, params.battery
    guidance = params.guidance
    packed = np.empty(PARAMS_SIZE)
    values = {
        "gravity": airframe.gravity_m_s2,
        "drag": airframe.drag_1_s,
        "rotational_drag": airframe.rotational_drag_1_s,
        "speed_gain": gains.speed,
        "rate_gain": gains.rate,
        "angle_gain": gains.angle,
        "epsilon": gains.epsilon,
        "tolerance": SOLVE_TOLERANCE,
        "tilt_slope": limits.tilt_slope,
        "thrust_max": limits.thrust_m_s2,
        "angular_max": limits.angular_acceleration_rad_s2,
        "speed_max": limits.speed_m_s,
        "acceleration_max": limits.acceleration_m_s2,
        "hover_w": battery.hover_w,
        "avionics_w": battery.avionics_w,
        "shaped": guidance.shaped,
        "guide_gain": guidance.gain,
        "guide_decel": guidance.decel,
        "velocity_gain": guidance.velocity_gain,
        "omega": guidance.omega,
        "reference_gain": guidance.reference_gain,
        "yaw_rate": guidance.yaw_rate_rad_s,
        "bumpless": params.bumpless,
        "literal": params.literal,
    }
    for name, value in values.items():
        packed[PARAMETERS[name]] = value
    return packed
