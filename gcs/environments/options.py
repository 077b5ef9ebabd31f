"""Keywords of environments beside their scenario; all of them may be left out."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any, Literal, TypedDict

import numpy as np
from gymnasium import Space

from gcs.environments.transition import Transition
from gcs.scenario.model import Scenario
from gcs.session.arrays import Snapshot

SetPoint = tuple[Any, Any]
"""(p_ned, v_ned), as of `gcs.Session.step`: three numbers each, m and m/s."""


class Options(TypedDict, total=False):
    """Keywords of `gcs.parallel_env` and of `gymnasium.make("gcs.environments:skytender/Session-v0", …)`."""

    reward: Callable[[Transition], float]
    """reward of an agent for a step; by default `gcs.environments.transition.nearness`"""
    terminated: Callable[[Transition], bool]
    """whether an agent's episode ends with a step; by default once its vehicle is lost,
    `gcs.environments.transition.is_lost`"""
    observation: Callable[[Snapshot, int], Any]
    """view of the agent of a system id sees at a snapshot, an element of `observation_space`; by default
    `gcs.environments.spaces.Observation`"""
    observation_space: Space[Any]
    """of all agents; goes with `observation`"""
    action: Callable[[Any, Snapshot, int], SetPoint | None]
    """the set point for the next snapshot that an action, an element of `action_space`, gives the vehicle of a system
    id; None leaves it to the planner for this step; by default `gcs.environments.spaces.VelocityAction`"""
    action_space: Space[Any]
    """of all agents; goes with `action`"""
    vary: Callable[[Scenario, np.random.Generator], Scenario]
    """the scenario of an episode, such as one with other starts, drawn from a generator that the episode's seed
    begins; with the same vehicles"""
    every_s: float
    """session time of a step, a multiple of the scenario's clock.period_s; one period by default"""
    render_mode: Literal["rgb_array"] | None
    """`rgb_array`: `render` draws the fleet from above, which needs the extra `plots`; by default nothing is drawn"""
    out: str | os.PathLike[str]
    """folder for the sessions: the first episode's folder is `1` in it, and so on; by default they are removed"""
    trust: bool
    """as of `gcs.Session`"""
