"""Many agents: a session as a ParallelEnv of PettingZoo."""

from __future__ import annotations

import copy
import os
from collections.abc import Iterable
from typing import Any, Unpack

import numpy as np
from gymnasium import Space
from gymnasium.utils.seeding import np_random
from numpy.typing import NDArray
from pettingzoo import ParallelEnv

from gcs.environments.episodes import Episodes, check_names
from gcs.environments.options import Options
from gcs.scenario.model import Scenario
from gcs.session.python import Session

LARGEST_DRAWN_SEED = 2**31 - 1


class ParallelSessionEnv(ParallelEnv[str, Any, Any]):  # type: ignore[misc]  # it has no types
    """Sessions in lockstep as PettingZoo's ParallelEnv; `gcs.parallel_env` makes it.

    Agents are named by role and system id, such as `pursuer_1`. `reset(seed=…)` gives the seed to the scenario: equal
    seeds and actions make equal episodes, byte for byte; without one it is drawn, and stands in each agent's info as
    `seed`. Infos have `time_s`, and at the end of an agent's episode, once it is the session's too, `digest`.
    """

    def __init__(
        self,
        scenario: str | os.PathLike[str] | Scenario,
        agents: Iterable[int] | None = None,
        **options: Unpack[Options],
    ) -> None:
        check_names(options, "agents")
        self._episodes = Episodes(scenario, agents, **options)
        roles = {vehicle.sysid: vehicle.role for vehicle in self._episodes.scenario.vehicles.all}
        self._sysids = {f"{roles[sysid]}_{sysid}": sysid for sysid in self._episodes.agents}
        self.possible_agents = list(self._sysids)
        self.agents: list[str] = []
        self.render_mode = options.get("render_mode")
        self.metadata = {
            "name": "skytender_session_v0",
            "render_modes": ["rgb_array"],
            "render_fps": 1.0 / self._episodes.step_s,
            "is_parallelizable": True,
        }
        self.action_spaces = {agent: _own(self._episodes.action_space()) for agent in self._sysids}
        self.observation_spaces = {
            agent: _own(self._episodes.observation_space(sysid)) for agent, sysid in self._sysids.items()
        }
        self._random: np.random.Generator | None = None

    @property
    def session(self) -> Session:
        """The episode's session, for its truth, commands and faults. Raises SessionError before the first reset."""
        return self._episodes.session

    def observation_space(self, agent: str) -> Space[Any]:
        """Space of what an agent sees."""
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> Space[Any]:
        """Space of what an agent does."""
        return self.action_spaces[agent]

    def reset(
        self, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, Any], dict[str, dict[str, Any]]]:
        """Begin an episode: observations and infos by agent. `options` is not used."""
        if seed is not None or self._random is None:
            self._random, _ = np_random(seed)
        flown = int(self._random.integers(LARGEST_DRAWN_SEED)) if seed is None else seed
        snapshot = self._episodes.begin(flown)
        self.agents = list(self.possible_agents)
        return self._observed(self.agents), {a: {"time_s": snapshot.time_s, "seed": flown} for a in self.agents}

    def step(
        self, actions: dict[str, Any]
    ) -> tuple[dict[str, Any], dict[str, float], dict[str, bool], dict[str, bool], dict[str, dict[str, Any]]]:
        """Fly one step, with an action of each agent of `agents`; one of an agent that has ended is left out. Raises
        ValueError for a missing action, one outside its space, and an unknown agent."""
        acting = {agent: self._sysids[agent] for agent in self.agents}
        if unknown := sorted(actions.keys() - set(self.possible_agents)):
            raise ValueError(f"there is no agent {unknown[0]!r}; the agents are {', '.join(self.possible_agents)}")
        if missing := [agent for agent in acting if agent not in actions]:
            raise ValueError(f"there is no action of {missing[0]}: step takes one of each agent of `agents`")
        if not acting:
            return {}, {}, {}, {}, {}
        steps, ended = self._episodes.step({sysid: actions[agent] for agent, sysid in acting.items()})
        rewards = {agent: self._episodes.reward(steps[sysid]) for agent, sysid in acting.items()}
        ends = {agent: self._episodes.terminated(steps[sysid]) for agent, sysid in acting.items()}
        cut = {agent: ended and not ends[agent] for agent in acting}
        seen = self._observed(acting)
        self.agents = [agent for agent in acting if not (ends[agent] or cut[agent])]
        infos: dict[str, dict[str, Any]] = {agent: {"time_s": self._episodes.snapshot.time_s} for agent in acting}
        if not self.agents:
            digest = self._episodes.digest()
            for info in infos.values():
                info["digest"] = digest
        return seen, rewards, ends, cut, infos

    def _observed(self, agents: Iterable[str]) -> dict[str, Any]:
        return {agent: self._episodes.observe(self._sysids[agent]) for agent in agents}

    def state(self) -> NDArray[np.float64]:
        """Place and velocity of all vehicles by system id, (6 n,), m and m/s, common NED frame; 0 where not known."""
        snapshot = self._episodes.snapshot
        return np.nan_to_num(np.concatenate([snapshot.p_ned, snapshot.v_ned], axis=1), nan=0.0).ravel()

    def render(self) -> Any:
        """The fleet from above, an array (height, width, 3) of uint8; None with render_mode None."""
        return self._episodes.render()

    def close(self) -> None:
        """End the session and remove its folder, unless `out` asked for that."""
        self.agents = []
        self._episodes.close()


def _own(space: Space[Any]) -> Space[Any]:
    """A copy, so that each agent's sampling is its own."""
    return copy.deepcopy(space)
