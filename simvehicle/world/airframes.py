"""Named airframes with published parameters (docs/model/vehicle.md#airframes), and the row that the compiled plant
reads.

Axes of a body are flu: x forward, y left, z up. Rotors are numbered as ArduPilot's and PX4's quad X: front right, back
left, front left, back right; the first two turn counter-clockwise as seen from above.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from simvehicle.world.rows import AIRFRAME, AIRFRAME_SIZE

GRAVITY_M_S2 = 9.80665
SEA_LEVEL_KG_M3 = 1.225
ROTORS = 4
SPIN = (1.0, 1.0, -1.0, -1.0)
"""+1: the rotor turns counter-clockwise from above, and its torque turns the body clockwise."""
INDUCED_FACTOR, FIGURE_OF_MERIT = 1.15, 0.7
"""κ and FM of docs/model/vehicle.md#rotor-power [choice]."""
HEADROOM = 0.85
"""Share of the greatest thrust that the law may ask for: the rest is left for turning [choice]."""
_SINGULAR = 1e-12
"""Pivot of rotors' effects, each scaled to 1, below which they depend on each other."""


@dataclass(frozen=True, kw_only=True)
class RotorAirframe:
    """A quadrotor (docs/model/vehicle.md#airframes). Coefficients hold at an air density of 1.225 kg/m³.

    `arms_m`: (x, y) of the four rotors, flu, from the centre of mass. `thrust_n_s2`: thrust over speed squared.
    `torque_nm_s2`: torque over speed squared. `rotor_drag_kg` and `inflow_drag_kg`: a rotor's force over speed times
    air speed, across and along its axis. `body_drag_kg_m`: force of the body over air speed squared, by axis.

    Raises:
        ValueError: a value that is not positive, rotors that cannot lift it or cannot turn it about each axis.
    """

    name: str
    mass_kg: float
    inertia_kg_m2: tuple[float, float, float]
    arms_m: tuple[tuple[float, float], ...]
    thrust_n_s2: float
    torque_nm_s2: float
    rotor_drag_kg: float
    inflow_drag_kg: float
    body_drag_kg_m: tuple[float, float, float]
    fastest_rad_s: float
    rotor_radius_m: float
    motor_lag_s: float = 0.05

    def __post_init__(self) -> None:
        positive = {
            "mass_kg": self.mass_kg,
            "inertia_kg_m2": min(self.inertia_kg_m2),
            "thrust_n_s2": self.thrust_n_s2,
            "torque_nm_s2": self.torque_nm_s2,
            "fastest_rad_s": self.fastest_rad_s,
            "rotor_radius_m": self.rotor_radius_m,
            "motor_lag_s": self.motor_lag_s,
        }
        for key, value in positive.items():
            if not 0.0 < value < math.inf:
                raise ValueError(f"{self.name}.{key} is {value!r}, but it must be greater than 0 and finite")
        if len(self.arms_m) != ROTORS or self.allocation is None:
            raise ValueError(f"{self.name}.arms_m must place four rotors that can lift and turn it about each axis")
        if self.greatest_thrust_m_s2 * HEADROOM <= GRAVITY_M_S2:
            raise ValueError(f"{self.name}'s rotors cannot lift it: their greatest thrust is too near its weight")

    @property
    def effectiveness(self) -> NDArray[np.float64]:
        """(4, 4), from the rotors' thrusts in N to total thrust in N and moments about x, y, z in N m."""
        x, y = np.array(self.arms_m).T
        ratio = self.torque_nm_s2 / self.thrust_n_s2
        return np.array([np.ones(ROTORS), y, -x, -ratio * np.array(SPIN)])

    @property
    def allocation(self) -> NDArray[np.float64] | None:
        """(4, 4), inverse of `effectiveness` after Gauss and Jordan; None where it has none."""
        left = self.effectiveness
        scale = np.abs(left).max(axis=1, keepdims=True)
        if not scale.all():
            return None
        left, made = left / scale, np.eye(ROTORS) / scale
        for k in range(ROTORS):
            pivot = k + int(np.abs(left[k:, k]).argmax())
            if not abs(left[pivot, k]) > _SINGULAR:
                return None
            left[[k, pivot]], made[[k, pivot]] = left[[pivot, k]], made[[pivot, k]]
            made[k] /= left[k, k]
            left[k] /= left[k, k]
            for row in range(ROTORS):
                if row != k:
                    made[row] -= left[row, k] * made[k]
                    left[row] -= left[row, k] * left[k]
        return made

    @property
    def greatest_thrust_m_s2(self) -> float:
        """Thrust per mass with all rotors at their fastest, at sea level."""
        return ROTORS * self.thrust_n_s2 * self.fastest_rad_s * self.fastest_rad_s / self.mass_kg

    @property
    def hover_rad_s(self) -> float:
        """Rotor speed at which the thrust equals the weight, at sea level."""
        return math.sqrt(self.mass_kg * GRAVITY_M_S2 / (ROTORS * self.thrust_n_s2))

    @property
    def hover_shaft_w(self) -> float:
        """Power at the rotors' shafts in hover at sea level, W: T √(T/(2 ρ A))/FM
        (docs/model/vehicle.md#rotor-power)."""
        weight_n = self.mass_kg * GRAVITY_M_S2
        disc_m2 = ROTORS * math.pi * self.rotor_radius_m * self.rotor_radius_m
        return weight_n * math.sqrt(weight_n / (2.0 * SEA_LEVEL_KG_M3 * disc_m2)) / FIGURE_OF_MERIT

    @property
    def hover_drag_1_s(self) -> float:
        """Deceleration over level air speed in hover, 1/s: what the law takes into account."""
        return ROTORS * self.hover_rad_s * self.rotor_drag_kg / self.mass_kg


def _x_arms(forward: float, aside: float) -> tuple[tuple[float, float], ...]:
    return ((forward, -aside), (-forward, aside), (forward, aside), (-forward, -aside))


AIRFRAMES: Mapping[str, RotorAirframe] = MappingProxyType(
    {
        airframe.name: airframe
        for airframe in (
            RotorAirframe(  # the model iris of PX4's Gazebo Classic worlds; its thrust falls by v/25 with the inflow
                name="iris",
                mass_kg=1.5,
                inertia_kg_m2=(0.029125, 0.029125, 0.055225),
                arms_m=((0.13, -0.22), (-0.13, 0.2), (0.13, 0.22), (-0.13, -0.2)),
                thrust_n_s2=5.84e-6,
                torque_nm_s2=0.06 * 5.84e-6,
                rotor_drag_kg=1.75e-4,
                inflow_drag_kg=1.85e-4,
                body_drag_kg_m=(0.0, 0.0, 0.0),
                fastest_rad_s=1100.0,
                rotor_radius_m=0.128,
            ),
            RotorAirframe(  # AscTec Hummingbird, as RotorPy has it
                name="hummingbird",
                mass_kg=0.5,
                inertia_kg_m2=(3.65e-3, 3.68e-3, 7.03e-3),
                arms_m=_x_arms(0.17 * math.sqrt(0.5), 0.17 * math.sqrt(0.5)),
                thrust_n_s2=5.57e-6,
                torque_nm_s2=1.36e-7,
                rotor_drag_kg=1.19e-4,
                inflow_drag_kg=2.32e-4,
                body_drag_kg_m=(0.5e-2, 0.5e-2, 1e-2),
                fastest_rad_s=1500.0,
                rotor_radius_m=0.1,
            ),
            RotorAirframe(  # Bitcraze Crazyflie 2, as RotorPy has it
                name="crazyflie",
                mass_kg=0.03,
                inertia_kg_m2=(1.43e-5, 1.43e-5, 2.89e-5),
                arms_m=_x_arms(0.043 * math.sqrt(0.5), 0.043 * math.sqrt(0.5)),
                thrust_n_s2=2.3e-8,
                torque_nm_s2=7.8e-10,
                rotor_drag_kg=10.2506e-7,
                inflow_drag_kg=7.553e-7,
                body_drag_kg_m=(0.0, 0.0, 0.0),
                fastest_rad_s=2500.0,
                rotor_radius_m=0.0225,
            ),
        )
    }
)


def pack(airframe: RotorAirframe, density_kg_m3: float = SEA_LEVEL_KG_M3) -> NDArray[np.float64]:
    """Row (AIRFRAME_SIZE,) of an airframe in air of a density: what air does grows with it in proportion."""
    share = density_kg_m3 / SEA_LEVEL_KG_M3
    x, y = np.array(airframe.arms_m).T
    ix, iy, iz = airframe.inertia_kg_m2
    allocation, hover_rad_s = airframe.allocation, airframe.hover_rad_s
    assert allocation is not None  # or there would be no such airframe
    profile_w = (1.0 - INDUCED_FACTOR * FIGURE_OF_MERIT) * airframe.hover_shaft_w
    values = {
        "mass": airframe.mass_kg,
        "gravity": GRAVITY_M_S2,
        "ix": ix,
        "iy": iy,
        "iz": iz,
        "thrust": share * airframe.thrust_n_s2,
        "torque": share * airframe.torque_nm_s2,
        "rotor_drag": share * airframe.rotor_drag_kg,
        "inflow_drag": share * airframe.inflow_drag_kg,
        "body_drag": share * np.array(airframe.body_drag_kg_m),
        "fastest": airframe.fastest_rad_s,
        "lag": airframe.motor_lag_s,
        "area": ROTORS * math.pi * airframe.rotor_radius_m * airframe.rotor_radius_m,
        "density": density_kg_m3,
        "x": x,
        "y": y,
        "spin": SPIN,
        "allocation": allocation.ravel(),
        "radius": airframe.rotor_radius_m,
        "profile": share * profile_w / (ROTORS * hover_rad_s * hover_rad_s * hover_rad_s),
        "hover_w": airframe.hover_shaft_w,
    }
    packed = np.empty(AIRFRAME_SIZE)
    for name, value in values.items():
        packed[AIRFRAME[name]] = value
    return packed
