"""Steps a second of environments, ours beside others', each called as its documentation says: a table for
docs/how-to/train.md.

python tests/benchmarks/environments_beside.py Skytender PyFlyt=PYTHON RotorPy=PYTHON …

The others are installed elsewhere; PYTHON is the interpreter that has them.
"""

from __future__ import annotations

import importlib.metadata
import importlib.util
import json
import subprocess
import sys
import time
from typing import Any, NamedTuple

FOR_S, RESETS = 5.0, 3


class Called(NamedTuple):
    """How an environment is made and stepped: code, with what a step is in the end."""

    package: str
    setup: str
    step: str
    vehicles: str
    """expression: how many a step flies"""
    period_s: str
    """expression: how much time it flies"""
    reset: str = "env.reset()"
    """code; empty where a step resets"""


GYM = "if any(env.step(env.action_space.sample())[2:4]): env.reset()"
PARALLEL = """\
if env.agents: env.step({a: env.action_space(a).sample() for a in env.agents})
else: env.reset()"""
OURS = """\
import gcs, environment_steps
env = gcs.parallel_env(environment_steps.hovering({})); env.reset(seed=1)"""
CRAZYFLOW = """\
import jax, numpy as np
from crazyflow.sim import Sim
from crazyflow.control import Control
sim = Sim(n_worlds={}, n_drones=1, control=Control.state)
sim.reset()
cmd = np.zeros(({}, 1, 16)); cmd[..., 12] = 1.0; cmd[..., 2] = 0.5"""
CRAZYFLOW_STEP = "sim.state_control(cmd); sim.step(sim.freq // sim.control_freq); jax.block_until_ready(sim.data)"
ROTORPY = """\
from rotorpy.environments import Environment
from rotorpy.vehicles.multirotor import Multirotor
from rotorpy.vehicles.crazyflie_params import quad_params
from rotorpy.controllers.quadrotor_control import SE3Control
from rotorpy.trajectories.hover_traj import HoverTraj
env = Environment(vehicle=Multirotor(quad_params), controller=SE3Control(quad_params), trajectory=HoverTraj(),
                  sim_rate=100)"""
ROTORPY_STEP = """\
env.run(t_final=1.0, use_mocap=False, terminate=False, plot=False, plot_mocap=False, plot_estimator=False,
        plot_imu=False, animate_bool=False, verbose=False); steps += 99"""
PYBULLET = """\
from gym_pybullet_drones.envs.HoverAviary import HoverAviary
from gym_pybullet_drones.utils.enums import ObservationType, ActionType
env = HoverAviary(obs=ObservationType('kin'), act=ActionType('one_d_rpm')); env.reset()"""
PYFLYT = "import gymnasium, PyFlyt.gym_envs; env = gymnasium.make('PyFlyt/QuadX-Hover-v4'); env.reset()"
CALLS = {
    "Skytender": [Called("skytender", OURS.format(n), PARALLEL, str(n), "0.1") for n in (1, 25)],
    "PyFlyt": [
        Called("pyflyt", PYFLYT, GYM, "1", "1.0 / 40"),
    ],
    "RotorPy": [Called("rotorpy", ROTORPY, ROTORPY_STEP, "1", "0.01", "")],
    "gym-pybullet-drones": [Called("gym-pybullet-drones", PYBULLET, GYM, "1", "1.0 / env.CTRL_FREQ")],
    "crazyflow": [
        Called(
            "crazyflow",
            CRAZYFLOW.format(n, n),
            CRAZYFLOW_STEP,
            str(n),
            "1.0 / sim.control_freq",
            "sim.reset(); jax.block_until_ready(sim.data)",
        )
        for n in (1, 1024)
    ],
}


def _cpu_s() -> float:
    """Processor time of this process and, where psutil is there to ask, of those that it has begun."""
    own_s = time.process_time()
    if importlib.util.find_spec("psutil") is None:
        return own_s
    import psutil  # noqa: PLC0415 - ours alone has other processes

    return own_s + sum(sum(one.cpu_times()[:2]) for one in psutil.Process().children(recursive=True))


def measured(called: Called) -> dict[str, Any]:
    """Steps in a second of processor and of wall time, after a second that does not count, and the time of a reset."""
    names: dict[str, Any] = {"steps": 0}
    exec(called.setup, names)
    code = compile(called.step, "step", "exec")
    for for_s in (1.0, FOR_S):
        names["steps"], begun_s, begun_cpu_s = 0, time.perf_counter(), _cpu_s()
        while time.perf_counter() - begun_s < for_s:
            exec(code, names)
            names["steps"] += 1
        took_s, took_cpu_s = time.perf_counter() - begun_s, _cpu_s() - begun_cpu_s
    vehicles, period_s = eval(called.vehicles, names), eval(called.period_s, names)
    steps_s = names["steps"] / took_s
    begun_s = time.perf_counter()
    for _ in range(RESETS):
        exec(called.reset, names)
    reset_s = (time.perf_counter() - begun_s) / RESETS
    exec("if hasattr(env, 'close'): env.close()" if "env" in names else "", names)
    return {
        "version": importlib.metadata.version(called.package), "vehicles": vehicles, "period_s": period_s,
        "reset": f"{1e3 * reset_s:,.0f} ms" if called.reset else "",
        "steps_cpu_s": names["steps"] / took_cpu_s, "steps_s": steps_s,
    }  # fmt: skip


def main() -> None:
    if sys.argv[1] == "--one":
        print(json.dumps(measured(CALLS[sys.argv[2]][int(sys.argv[3])])))
        return
    print("| environment | vehicles | a step | steps a second of processor time | by the clock | flown | a reset |")
    print("|---|---|---|---|---|---|---|")
    for word in sys.argv[1:]:
        name, _, python = word.partition("=")
        for number in range(len(CALLS[name])):
            command = [python or sys.executable, __file__, "--one", name, f"{number}"]
            said = subprocess.run(command, capture_output=True, text=True, check=True)
            m = json.loads(said.stdout.splitlines()[-1])
            print(
                f"| {name} {m['version']} | {m['vehicles']:,} | {1e3 * m['period_s']:.3g} ms | "
                f"{m['steps_cpu_s']:,.0f} | "
                f"{m['steps_s']:,.0f} | {m['steps_cpu_s'] * m['vehicles'] * m['period_s']:,.3g} s | "
                f"{m['reset']} |",
                flush=True,
            )


if __name__ == "__main__":
    main()
