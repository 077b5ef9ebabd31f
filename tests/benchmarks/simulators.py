"""Closed loops of other simulators, each as its documentation flies one: a set point of position, a controller, a body.

python simulators.py NAME VEHICLES

Run by an interpreter that has them; it prints one line of JSON. Skytender is not imported here.
"""

from __future__ import annotations

import importlib.metadata
import json
import math
import sys
import time
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

MEASURED_S = 3.0
HEIGHT_M, APART_M = 1.0, 3.0
SETTLING_S, NEAR_M = 8.0, 0.5


class Loop(NamedTuple):
    """A fleet that hovers."""

    fly: Callable[[], object]
    """flies `seconds` on"""
    seconds: float
    off_m: Callable[[], float]
    """how far the worst vehicle is from its set point"""


def crazyflow(n: int) -> Loop:
    """500 Hz, its state controller at 100 Hz, compiled for the processor; a second in each call, as it is fastest."""
    import jax  # noqa: PLC0415 - each is installed where it can be
    from crazyflow.control import Control  # noqa: PLC0415
    from crazyflow.sim import Sim  # noqa: PLC0415

    sim = Sim(n_worlds=n, n_drones=1, control=Control.state)
    sim.reset()
    wanted = np.zeros((n, 1, 16))
    wanted[..., 2], wanted[..., 12] = HEIGHT_M, 1.0

    def fly() -> None:
        sim.state_control(wanted)
        sim.step(sim.freq)
        jax.block_until_ready(sim.data)

    return Loop(fly, 1.0, lambda: float(np.abs(np.asarray(sim.data.states.pos)[:, 0] - wanted[:, 0, :3]).max()))


def rotorpy(n: int) -> Loop:
    """100 Hz as its `Environment` has it, SE(3) control in every step, Runge-Kutta of SciPy."""
    from rotorpy.controllers.quadrotor_control import SE3Control  # noqa: PLC0415
    from rotorpy.trajectories.hover_traj import HoverTraj  # noqa: PLC0415
    from rotorpy.vehicles.crazyflie_params import quad_params  # noqa: PLC0415
    from rotorpy.vehicles.multirotor import Multirotor  # noqa: PLC0415

    vehicles = [Multirotor(quad_params) for _ in range(n)]
    controllers, trajectory = [SE3Control(quad_params) for _ in range(n)], HoverTraj(np.array([0.0, 0.0, HEIGHT_M]))
    states = [dict(vehicle.initial_state) for vehicle in vehicles]
    steps, at, rate_hz = 10, 0, 100.0

    def fly() -> None:
        nonlocal at
        for _ in range(steps):
            for k, vehicle in enumerate(vehicles):
                control = controllers[k].update(at / rate_hz, states[k], trajectory.update(at / rate_hz))
                states[k] = vehicle.step(states[k], control, 1.0 / rate_hz)
            at += 1

    return Loop(fly, steps / rate_hz, lambda: max(float(np.abs(s["x"] - (0.0, 0.0, HEIGHT_M)).max()) for s in states))


def pyflyt(n: int) -> Loop:
    """Physics of Bullet at 240 Hz, its controller of positions at 120 Hz."""
    from PyFlyt.core import Aviary  # noqa: PLC0415

    places = _grid(n)
    env = Aviary(start_pos=places, start_orn=np.zeros((n, 3)), drone_type="quadx")
    env.set_mode(7)
    for k, place in enumerate(places):
        env.set_setpoint(k, np.array([place[0], place[1], 0.0, place[2]]))
    loops = env.update_period * 24

    def fly() -> None:
        for _ in range(24):
            env.step()

    return Loop(fly, loops, lambda: max(float(np.abs(env.state(k)[-1] - places[k]).max()) for k in range(n)))


def gym_pybullet_drones(n: int) -> Loop:
    """Physics of Bullet at 240 Hz, PID of positions at 48 Hz."""
    from gym_pybullet_drones.control.DSLPIDControl import DSLPIDControl  # noqa: PLC0415
    from gym_pybullet_drones.envs.CtrlAviary import CtrlAviary  # noqa: PLC0415
    from gym_pybullet_drones.utils.enums import DroneModel  # noqa: PLC0415

    places = _grid(n)
    env = CtrlAviary(num_drones=n, initial_xyzs=places, pyb_freq=240, ctrl_freq=48)
    controllers = [DSLPIDControl(drone_model=DroneModel.CF2X) for _ in range(n)]
    speeds = np.zeros((n, 4))
    seen, *_ = env.step(speeds)

    def fly() -> None:
        nonlocal seen
        for _ in range(12):
            for k, controller in enumerate(controllers):
                speeds[k], _, _ = controller.computeControlFromState(1.0 / 48.0, seen[k], places[k])
            seen, *_ = env.step(speeds)

    return Loop(fly, 12 / 48.0, lambda: float(np.abs(seen[:, :3] - places).max()))


def _grid(n: int) -> np.ndarray:
    """Places of n vehicles, (n, 3), m."""
    side = math.ceil(math.sqrt(n))
    return np.array([(APART_M * (k % side), APART_M * (k // side), HEIGHT_M) for k in range(n)])


LOOPS = {
    "crazyflow": crazyflow, "rotorpy": rotorpy, "pyflyt": pyflyt, "gym-pybullet-drones": gym_pybullet_drones,
}  # fmt: skip


def main() -> None:
    name, vehicles = sys.argv[1], int(sys.argv[2])
    try:
        version = importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        print(json.dumps({"missing": f"{name} is not installed"}))
        return
    loop = LOOPS[name](vehicles)
    for _ in range(math.ceil(SETTLING_S / loop.seconds)):
        loop.fly()
    if not loop.off_m() < NEAR_M:
        raise SystemExit(f"{name} {version} is {loop.off_m():.2f} m off its set point: it does not hover")
    begun_s, spent_s, flown_s = time.perf_counter(), time.process_time(), 0.0
    while time.perf_counter() - begun_s < MEASURED_S:
        loop.fly()
        flown_s += loop.seconds
    print(json.dumps({"version": version, "vehicle_seconds": vehicles * flown_s / (time.process_time() - spent_s)}))


if __name__ == "__main__":
    main()
