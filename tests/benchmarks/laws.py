"""Figures 2, 6, 7 and 8: the flight law, the planner, the competition and the recorder, each by itself."""

from __future__ import annotations

import math
import tempfile
from collections.abc import Callable
from pathlib import Path

import arducopter_at_full_speed
import numpy as np
from codecs_of_a_tick import hot_frames
from measure import Figure, Scale, cpu_times
from scipy.integrate import solve_ivp

from gcs.planner import fuzzy_escape, leader, neighbours
from gcs.planner.potential_field import FieldConstants
from gcs.recording.recorder import TLOG, Recorder
from simvehicle.autopilot.body import Start
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.identity import IDENTITIES
from simvehicle.autopilot.parameters import Parameters
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.law import rows, step
from simvehicle.law.params import VehicleParams, pack
from simvehicle.law.plants import RotorPlant
from simvehicle.world.airframes import AIRFRAMES
from simvehicle.world.description import Air, WorldVehicle
from simvehicle.world.estimate import EstimateErrors
from skytender import geometry
from skytender.winner_take_all import advance as compete

GRANTS, SHORTEST = 100, 10
STEPS = 25


def _circle(n: int = 1) -> Callable[..., np.ndarray]:
    """The flight of n vehicles to be timed, as a function of the differentiator's tolerance, None for the usual one."""
    params = VehicleParams()
    start = step.initial_state(
        params, position_nwu=(0.0, 0.0, 5.0), velocity_nwu=(0.0, 0.0, 0.0), attitude_rad=(0.0,) * 3, airborne=True
    )
    grants = max(GRANTS // n, SHORTEST)
    angle = 0.05 * np.arange(grants)[:, np.newaxis] + np.linspace(0.0, 2.0 * math.pi, n, endpoint=False)
    commands = np.zeros((grants, n, rows.COMMAND_SIZE))
    commands[..., rows.CMD_USE_POSITION] = 1.0
    commands[..., rows.CMD_MOTORS] = 1.0
    commands[..., rows.CMD_SPEED_MAX], commands[..., rows.CMD_PERIOD_S] = 5.0, 0.1
    level = np.zeros_like(angle)
    commands[..., rows.CMD_POSITION] = np.stack([3.0 * np.cos(angle), 3.0 * np.sin(angle), level + 5.0], axis=-1)
    commands[..., rows.CMD_VELOCITY] = np.stack([-1.5 * np.sin(angle), 1.5 * np.cos(angle), level], axis=-1)
    commands[..., rows.CMD_TIME_S] = 0.1 * np.arange(grants)[:, np.newaxis]

    def fly(tolerance: float | None = None) -> np.ndarray:
        """Along a circle of 3 m, a set point every 0.1 s, as in a session; positions (grants, n, 3)."""
        state, packed = np.repeat(start[np.newaxis], n, axis=0), np.repeat(pack(params)[np.newaxis], n, axis=0)
        if tolerance is not None:
            packed[:, rows.PARAMETERS["tolerance"]] = tolerance
        path = []
        for k in range(grants):
            state, _ = step.advance(state, commands[k], packed, time_s=0.1 * k, steps=STEPS)
            path.append(state[:, rows.POSITION])
        return np.array(path)

    return fly


def weathered_seconds() -> float:
    """Vehicle-seconds per CPU second of a whole vehicle on rotors, in gusts and with sensors."""
    own, air = WorldVehicle(AIRFRAMES["iris"], EstimateErrors()), Air(mean_nwu=(8.0, 0.0, 0.0), turbulence_m_s=7.7)
    start = Start((0.0, 0.0, -5.0), airborne=True)
    given = Parameters({"SIM_BAT_CAP_J": 1e9})
    one = Vehicle(IDENTITIES["px4"], given, LocalFrame(0.0, 0.0, 0.0), start, RotorPlant(own, air, seed=1, sysid=1))
    (spent_s,) = cpu_times(lambda: one.advance(one.time_ms + 100 * GRANTS))
    return 0.1 * GRANTS / spent_s


def vehicle_seconds(n: int = 1) -> float:
    """Vehicle-seconds per CPU second of a fleet of n."""
    fly = _circle(n)
    (spent_s,) = cpu_times(fly)
    return 0.1 * fly().shape[0] * n / spent_s


def flying(scale: Scale) -> list[Figure]:
    fly, flown_s, copter_s = _circle(), vehicle_seconds(), arducopter_at_full_speed.vehicle_seconds()
    apart_m = float(np.abs(fly() - fly(1e-14)).max())
    return [
        Figure(
            2, "one vehicle, full law at 250 Hz", flown_s, "vehicle-s/CPU s", 2000.0 * scale.cpu,
            peer="ArduCopter SITL" if copter_s else "ArduCopter SITL: none is named", peer_value=copter_s,
        ),
        Figure(
            2, "  a whole vehicle on rotors, in gusts and with sensors", weathered_seconds(), "vehicle-s/CPU s",
            1000.0 * scale.cpu,
        ),
        Figure(2, "  farthest from the same flight solved to 1e-14", apart_m, "m", 1e-3, at_most=True),
    ]  # fmt: skip


def planning(scale: Scale) -> list[Figure]:
    field = FieldConstants(k0=15.0, k1=2.0, a=0.5, b=0.5, attraction_range_m=1.0, repulsion_range_m=1.0, step_m=0.1)
    made = []
    for n in (125, 250, 500, 1000, 2000):
        rng = np.random.default_rng(n)
        side_m = 5.0 * n ** (1 / 3)
        at, table = rng.uniform(0, side_m, (n, 3)), geometry.points(rng.uniform(0, side_m, (n, 3)))
        memory, nobody, still = fuzzy_escape.new_memory(n), np.zeros((n, n), dtype=bool), np.zeros((n, 3))

        def plan(at=at, table=table, memory=memory, nobody=nobody, still=still, n=n) -> None:
            leader.advance(
                at, memory, at[::-1], still, repulsors=table, moving=at, radii_m=0.6, ranges_m=np.ones(n),
                owner=np.arange(n), exempt=nobody, field=field, speed_m_s=1.5, period_s=0.1, escape=True,
            )  # fmt: skip

        def all_pairs(plan=plan) -> None:
            usual, neighbours.FEW = neighbours.FEW, 10**9
            try:
                plan()
            finally:
                neighbours.FEW = usual

        ours_s, pairs_s = cpu_times(plan, all_pairs)
        goal = 30.0 / scale.cpu if n == 1000 else None
        name = f"planner, {n} vehicles among {n} obstacles"
        made.append(Figure(6, name, 1e3 * ours_s, "CPU ms/tick", goal, True, False, "all pairs", 1e3 * pairs_s))
    return made


def competing() -> list[Figure]:
    n, p, rate = 1000, 2.0, 5.0
    rng = np.random.default_rng(7)
    tau, v = rng.uniform(0.01, 1.0, n), rng.uniform(0.01, 0.5, n)

    def law(_: float, x: np.ndarray) -> np.ndarray:
        return rate * x * (tau - np.sum(x**p))

    def peer() -> np.ndarray:
        return solve_ivp(law, (0.0, 1.0), v, rtol=1e-8, atol=1e-12).y[:, -1]

    assert np.allclose(compete(v, tau, 1.0, p=p, rate=rate), peer(), rtol=1e-5, atol=1e-9)
    ours_s, peer_s = cpu_times(lambda: compete(v, tau, 1.0, p=p, rate=rate), peer)
    name, ivp = "competition, 1000 competitors over 1 s", "solve_ivp, rtol 1e-8"
    return [
        Figure(7, name, 1e6 * ours_s, "CPU µs", 100.0, True, False, ivp, 1e6 * peer_s),
        Figure(7, "  times faster than the solver", 1e6 * ours_s, "CPU µs", 100.0, True, True, ivp, 1e6 * peer_s),
    ]


def recording(scale: Scale) -> list[Figure]:
    frames = hot_frames()
    with tempfile.TemporaryDirectory() as name:
        count = 0

        def tick() -> None:
            nonlocal count
            recorder.frames(1_767_225_600_000_000 + count, frames)
            count += 1

        with Recorder(Path(name)) as recorder:
            (spent_s,) = cpu_times(tick)
        whole = (Path(name) / TLOG).stat().st_size
        assert whole == count * sum(8 + len(frame) for frame in frames), "a frame is missing from the tlog"
    per_frame_us = 1e6 * spent_s / len(frames)
    return [Figure(8, "recorder, nothing lost at the end", per_frame_us, "CPU µs/frame", 5.0 / scale.cpu, True)]
