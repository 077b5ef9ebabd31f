"""Control energies of the paper's vehicles under what the paper does not print: how long a step of the planned point
takes, the form of eq. 17, which yaw is kept, whether steps shrink before goals; and which energy, up to when.

Planned velocities are given, one for each step of the planned point, since planning is the ground station's. Every
flight is the flight core's own, and every energy is kept after each step, so that any duration can be read off later.
"""

from __future__ import annotations

import itertools
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from simvehicle.law import rows, step
from simvehicle.law.params import NAMED, STEP_S, pack

Floats = NDArray[np.float64]

FILE = "energies.npz"
STEP_TIMES_S = (0.06, 0.1, 0.14, 0.2)  # of one step of the planned point, which is 0.1 m; whole steps of the law
GAIN_SETS = ("paper", "paper_literal")
YAWS_RAD = (1.0, 0.0)  # that of the start, or none
ATTITUDE_RAD = (1.0, 1.0, 1.0)  # the paper's start
STILL_STEPS = 40
"""So many steps each flight goes on after its plan has ended."""
MEASURES = (
    "thrust and torques",
    "thrust",
    "torques",
    "thrust squared",
    "thrust beyond the weight",
    "thrust to three halves",
    "force and moments",
)
"""∫ of: |u1| + Σ|τ|, |u1|, Σ|τ|, u1², |u1 - g|, |u1|^(3/2), m |u1| + I Σ|τ|."""


@dataclass(frozen=True)
class Plans:
    """Plans by name, each a velocity (k, 3) nwu m/s of every vehicle's step k at 1 m/s; starting velocities (n, 3)."""

    names: tuple[str, ...]
    velocities: Floats
    """(plans, n, k, 3)"""
    starts: Floats
    """(n, 3), m/s"""


def read(path: Path) -> Plans:
    """Plans that the ground station wrote. Raises OSError, ValueError where the file holds something else."""
    try:
        content: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
        velocities = np.array([plan["velocity_nwu"] for plan in content["plans"]], dtype=np.float64)
        starts = np.array(content["start_velocity_nwu"], dtype=np.float64)
        names = tuple(str(plan["name"]) for plan in content["plans"])
    except (json.JSONDecodeError, UnicodeDecodeError, KeyError, TypeError, ValueError) as error:
        raise ValueError(f"{path} holds no plans: {error}") from None
    if velocities.ndim != 4 or velocities.shape[3] != 3 or starts.shape != (velocities.shape[1], 3):
        raise ValueError(f"{path} holds no plans: velocities {velocities.shape}, starts {starts.shape}")
    return Plans(names, velocities, starts)


def write(plans: Plans, out: Path) -> str:
    """Fly every variant and write FILE into the folder `out`; its name. Raises OSError.

    The file holds `energy` (variants, n, MEASURES, k), after each step of the plan; `step_s`, `plan`, `gain_set` and
    `yaw_rad` of each variant (variants,), and `measures`.
    """
    variants = list(itertools.product(STEP_TIMES_S, range(len(plans.names)), GAIN_SETS, YAWS_RAD))
    energies: list[Floats] = []
    for step_s, group in itertools.groupby(variants, key=lambda variant: variant[0]):
        energies += list(fly(plans, step_s, [(plan, gains, yaw) for _, plan, gains, yaw in group]))
    out.mkdir(parents=True, exist_ok=True)
    np.savez(
        out / FILE,
        energy=np.array(energies, dtype=np.float64),
        step_s=np.array([step_s for step_s, *_ in variants]),
        plan=np.array([plans.names[plan] for _, plan, *_ in variants]),
        gain_set=np.array([gains for *_, gains, _ in variants]),
        yaw_rad=np.array([yaw for *_, yaw in variants]),
        measures=np.array(MEASURES),
    )
    return FILE


def fly(plans: Plans, step_s: float, variants: list[tuple[int, str, float]]) -> Floats:
    """Energies (variants, n, MEASURES, k) of variants (plan, gain set, yaw) whose steps take as long, `step_s`."""
    n, steps = plans.starts.shape[0], plans.velocities.shape[2] + STILL_STEPS
    law_steps = round(step_s / STEP_S)
    airframe = NAMED["paper"].airframe
    flights = [
        step.initial_state(
            NAMED[gains],
            position_nwu=(0.0, 0.0, 0.0),
            velocity_nwu=velocity,
            attitude_rad=ATTITUDE_RAD,
            airborne=True,
        )
        for _, gains, _ in variants
        for velocity in plans.starts.tolist()
    ]
    state = np.array(flights)
    packed = np.repeat([pack(NAMED[gains]) for _, gains, _ in variants], n, axis=0)
    # A plan is given for 1 m/s, at which a step takes 0.1 s.
    wanted = np.concatenate([plans.velocities[plan] * (0.1 / step_s) for plan, *_ in variants])
    command = np.zeros((len(flights), rows.COMMAND_SIZE))
    command[:, rows.CMD_MOTORS] = 1.0
    command[:, rows.CMD_YAW] = np.repeat([yaw for *_, yaw in variants], n)
    command[:, rows.CMD_PERIOD_S] = step_s
    kept = np.zeros((len(flights), len(MEASURES), steps))
    total, effort_before = np.zeros((len(flights), len(MEASURES))), np.zeros(len(flights))
    for k in range(steps):
        command[:, rows.CMD_VELOCITY] = wanted[:, k] if k < wanted.shape[1] else 0.0
        command[:, rows.CMD_TIME_S] = k * step_s
        state, u1 = step.advance(state, command, packed, time_s=k * step_s, steps=law_steps)
        effort = state[:, rows.EFFORT] - effort_before
        effort_before = state[:, rows.EFFORT].copy()
        thrust = np.abs(u1).sum(axis=1) * STEP_S
        torque = effort - thrust
        total += np.column_stack(
            [
                effort,
                thrust,
                torque,
                np.square(u1).sum(axis=1) * STEP_S,
                np.abs(u1 - airframe.gravity_m_s2).sum(axis=1) * STEP_S,
                (np.abs(u1) ** 1.5).sum(axis=1) * STEP_S,
                airframe.mass_kg * thrust + airframe.inertia * torque,
            ]
        )
        kept[:, :, k] = total
    return kept.reshape(len(variants), n, len(MEASURES), steps)
