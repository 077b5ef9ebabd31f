"""One agent: a session as an Env of Gymnasium."""

from __future__ import annotations

import os
from typing import Any, ClassVar, Unpack

import gymnasium

from gcs.environments.episodes import Episodes, check_names
from gcs.environments.options import Options
from gcs.environments.parallel import LARGEST_DRAWN_SEED
from gcs.scenario.model import Scenario
from gcs.session.python import Session


class SessionEnv(gymnasium.Env[Any, Any]):
    """Sessions in lockstep as Gymnasium's Env: `skytender/Session-v0`.

    agent: system id of the vehicle that acts; the first pursuer without it. All others are the planner's. Seeds and
    infos are as of `gcs.parallel_env`.
    """

    metadata: ClassVar[dict[str, Any]] = {"render_modes": ["rgb_array"], "render_fps": 10}  # type: ignore[misc]

    def __init__(
        self,
        scenario: str | os.PathLike[str] | Scenario = "demo",
        agent: int | None = None,
        **options: Unpack[Options],
    ) -> None:
        check_names(options, "agent")
        self._episodes = Episodes(scenario, None if agent is None else (agent,), **options)
        self._agent = self._episodes.agents[0]
        if agent is None:
            self._episodes.agents = [self._agent]
        self.render_mode = options.get("render_mode")
        self.metadata = {**self.metadata, "render_fps": 1.0 / self._episodes.step_s}  # type: ignore[misc]
        self.action_space = self._episodes.action_space()
        self.observation_space = self._episodes.observation_space(self._agent)

    @property
    def session(self) -> Session:
        """The episode's session, for its truth, commands and faults. Raises SessionError before the first reset."""
        return self._episodes.session

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Begin an episode: observation and info. `options` is not used."""
        super().reset(seed=seed)
        flown = int(self.np_random.integers(LARGEST_DRAWN_SEED)) if seed is None else seed
        snapshot = self._episodes.begin(flown)
        return self._episodes.observe(self._agent), {"time_s": snapshot.time_s, "seed": flown}

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Fly one step. Raises ValueError for an action outside its space."""
        steps, ended = self._episodes.step({self._agent: action})
        step = steps[self._agent]
        reward, terminated = self._episodes.reward(step), self._episodes.terminated(step)
        info: dict[str, Any] = {"time_s": step.after.time_s}
        if ended or terminated:
            info["digest"] = self._episodes.digest()
        return self._episodes.observe(self._agent), reward, terminated, ended and not terminated, info

    def render(self) -> Any:
        """The fleet from above, an array (height, width, 3) of uint8; None with render_mode None."""
        return self._episodes.render()

    def close(self) -> None:
        """End the session and remove its folder, unless `out` asked for that."""
        self._episodes.close()
