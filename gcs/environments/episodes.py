"""Episodes: one session after the other, stepped by agents' actions. Both kinds of environments are made of it."""

from __future__ import annotations

import contextlib
import os
import shutil
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, Unpack

import numpy as np
from gymnasium import Space
from gymnasium.spaces import Box

from gcs.environments.drawing import FleetDrawing
from gcs.environments.options import Options
from gcs.environments.spaces import Observation, VelocityAction
from gcs.environments.transition import Transition, is_lost, nearness
from gcs.scenario.model import Scenario
from gcs.session.arrays import Snapshot
from gcs.session.program.acting import known
from gcs.session.program.turn import SessionError
from gcs.session.python import ScenarioSource, Session, source_of
from gcs.session.spawning.spawner import SessionSpawner

_ROUNDING_S = 1e-6


class Episodes:
    """The sessions of an environment, one at a time.

    Each begins once all agents' vehicles are in the air and are sent set points; until then the planner flies them. An
    action steers its agent's vehicle for one step, and vehicles without an agent in flight are the planner's.
    """

    def __init__(
        self, scenario: str | os.PathLike[str] | Scenario, agents: Iterable[int] | None, **options: Unpack[Options]
    ) -> None:
        """agents: system ids of vehicles that are agents; every pursuer without it. Raises ValueError, and what
        `gcs.Session` raises of the scenario."""
        for given, space in (("observation", "observation_space"), ("action", "action_space")):
            if (given in options) != (space in options):
                raise ValueError(f"{given} and {space} go together: give both, or neither")
        self._options = options
        self._source = source_of(scenario, trust=options.get("trust", False))
        self.scenario = self._new(self._source).scenario
        """the scenario before `vary` and the seed"""
        self.agents = _checked(agents, self.scenario)
        """system ids, in order"""
        self.step_s = options.get("every_s") or self.scenario.clock.period_s
        self._reward = options.get("reward", nearness)
        self._terminated = options.get("terminated", is_lost)
        self._observations = {sysid: Observation(self.scenario, sysid) for sysid in self.agents}
        self._action = VelocityAction(self.scenario, self.step_s)
        out = options.get("out")
        self._out = None if out is None else Path(out).absolute()
        mode = options.get("render_mode")
        if mode not in (None, "rgb_array"):
            raise ValueError(f"render_mode is {mode!r}; sessions are drawn as 'rgb_array', or not at all (None)")
        self._drawing = None if mode is None else FleetDrawing(self.scenario)
        self._flown, self._flies = 0, False
        self._stack = contextlib.ExitStack()
        self._spawner: SessionSpawner | None = None
        self._pid = os.getpid()
        self._session: Session | None = None
        self._snapshot: Snapshot | None = None

    @property
    def session(self) -> Session:
        """The present session, or the last one. Raises SessionError before the first reset."""
        if self._session is None:
            raise SessionError("the environment has no session before reset: call it first")
        return self._session

    @property
    def snapshot(self) -> Snapshot:
        """The newest one. Raises SessionError before the first reset."""
        if self._snapshot is None:
            raise SessionError("the environment has no session before reset: call it first")
        return self._snapshot

    def observation_space(self, sysid: int) -> Space[Any]:
        """Space of what an agent sees."""
        space = self._options.get("observation_space")
        return self._observations[sysid].space if space is None else space

    def action_space(self) -> Space[Any]:
        """Space of what an agent does."""
        space = self._options.get("action_space")
        return self._action.space if space is None else space

    def begin(self, seed: int) -> Snapshot:
        """End the present session, and fly the next one until every agent's vehicle is steered. Raises SessionError."""
        self.end()
        source = self._source
        if (vary := self._options.get("vary")) is not None:
            scenario = vary(self.scenario, np.random.default_rng(seed))
            if [one.sysid for one in scenario.vehicles.all] != [one.sysid for one in self.scenario.vehicles.all]:
                raise ValueError("vary has changed which vehicles there are: agents and spaces need the same ones")
            source = replace(source, scenario=source_of(scenario, trust=self._options.get("trust", False)).scenario)
        if self._spawner is None or not self._spawner.alive:
            self.close()
            self._spawner = SessionSpawner()
        self._flown += 1
        with contextlib.ExitStack() as stack:
            folder = (self._out or self._spawner.folder) / f"{self._flown}"
            if self._out is None:
                stack.callback(shutil.rmtree, folder, ignore_errors=True)
            session = self._new(source, seed, folder, self._spawner)
            self._observations = {
                sysid: Observation(session.scenario, sysid, self._observations[sysid].space) for sysid in self.agents
            }
            self._action = VelocityAction(session.scenario, self.step_s)
            self._session = stack.enter_context(session)
            snapshot = session.step()
            rows = [snapshot.row(sysid) for sysid in self.agents]
            while not np.isfinite(snapshot.set_point_p_ned[rows]).all():
                if self._is_last(snapshot):
                    raise SessionError(
                        f"the session of {session.scenario.name} ended before all agents flew: give it a longer "
                        "goal.duration_s, or let fewer vehicles be agents"
                    )
                snapshot = session.step()
            self._stack, self._flies = stack.pop_all(), True
        if self._drawing is not None:
            self._drawing.begin(session.scenario)
            self._drawing.add(snapshot)
        self._snapshot = snapshot
        return snapshot

    def _new(
        self,
        source: ScenarioSource,
        seed: int | None = None,
        out: Path | None = None,
        spawner: SessionSpawner | None = None,
    ) -> Session:
        every_s, duration_s = self._options.get("every_s"), source.scenario.goal.duration_s
        session = Session(source, lockstep=True, seed=seed, out=out, every_s=every_s, spawner=spawner)
        if every_s is not None and round(1e3 * duration_s) % round(1e3 * every_s):
            raise ValueError(
                f"every_s is {every_s!r}, of which the scenario's goal.duration_s, {duration_s:g}, is no multiple"
            )
        return session

    def _is_last(self, snapshot: Snapshot) -> bool:
        return snapshot.time_s + self.step_s > self.session.scenario.goal.duration_s + _ROUNDING_S

    def observe(self, sysid: int) -> Any:
        """The view that an agent has now."""
        observe = self._options.get("observation")
        return self._observations[sysid](self.snapshot) if observe is None else observe(self.snapshot, sysid)

    def step(self, actions: Mapping[int, Any]) -> tuple[dict[int, Transition], bool]:
        """Fly a step of these agents' actions: the transition of each, and whether the session has ended with it.
        Raises ValueError for an action outside its space, SessionError where no episode flies."""
        session, before = self.session, self.snapshot
        if not self._flies:
            raise SessionError("the episode has ended and cannot be stepped any more: call reset for the next one")
        set_points, act = {}, self._options.get("action", self._action)
        for sysid, action in actions.items():
            point = act(_inside(action, self.action_space(), sysid), before, sysid)
            if point is not None:
                set_points[sysid] = point
        after, ended = before, True
        try:
            after = session.step(set_points)
            ended = self._is_last(after)
        except SessionError:
            session.finish()  # raises where that is no end
        self._snapshot = after
        if self._drawing is not None:
            self._drawing.add(after)
        made = {
            sysid: Transition(session.scenario, sysid, after.row(sysid), action, before, after, session)
            for sysid, action in actions.items()
        }
        return made, ended

    def reward(self, step: Transition) -> float:
        """Reward of an agent for its step."""
        return float(self._reward(step))

    def terminated(self, step: Transition) -> bool:
        """Whether the agent's episode ends with its step."""
        return bool(self._terminated(step))

    def digest(self) -> str | None:
        """End the session, at its scenario's end or now, and return its digest. Raises SessionError where it broke."""
        session, self._flies = self.session, False
        return (session.finish() if self._is_last(self.snapshot) else session.stop()).digest

    def render(self) -> Any:
        """The fleet from above, an array (height, width, 3) of uint8; None where nothing is drawn."""
        return None if self._drawing is None else self._drawing.array(self.snapshot)

    def end(self) -> None:
        """End the present session; its folder is removed where none was asked for. In a fork of the process that began
        it, it is left to that one."""
        if self._pid != os.getpid():
            self._pid, self._spawner, self._session, self._snapshot = os.getpid(), None, None, None
            self._stack.pop_all()
        stack, self._stack, self._flies = self._stack, contextlib.ExitStack(), False
        stack.close()

    def close(self) -> None:
        """End the present session, and the processes from which sessions are forked."""
        self.end()
        if self._spawner is not None:
            self._spawner.close()
            self._spawner = None


def check_names(options: Iterable[str], agents: str) -> None:
    """See that an environment has these keywords; `agents`: its own for the agents. Raises TypeError."""
    names = {*Options.__optional_keys__, agents}
    if unknown := sorted(set(options) - names):
        raise TypeError(f"environments have no option {unknown[0]!r}: {', '.join(sorted(names))}")


def _inside(action: Any, space: Space[Any], sysid: int) -> Any:
    """The action as the space has it: numbers of a box may be of another type, such as Python's. Raises ValueError."""
    given = action
    try:
        if isinstance(space, Box):
            with np.errstate(over="ignore"):
                given = np.asarray(action).astype(space.dtype, casting="same_kind")
        inside = space.contains(given)
    except (TypeError, ValueError, OverflowError):
        inside = False
    if not inside:
        raise ValueError(f"the action {action!r:.80} of vehicle {sysid} is not in {space}")
    return given


def _checked(agents: Iterable[int] | None, scenario: Scenario) -> list[int]:
    """System ids of the agents in order. Raises ValueError."""
    there = sorted(vehicle.sysid for vehicle in scenario.vehicles.all)
    if agents is not None and not isinstance(agents, Iterable):
        raise ValueError(f"agents is {agents!r}, but it must be system ids of vehicles: [{agents!r}], say")
    if agents is None:
        chosen, none = [vehicle.sysid for vehicle in scenario.vehicles.pursuers], f"{scenario.name} has no pursuer"
    else:
        chosen, none = [known(sysid, there) for sysid in agents], "agents is empty"
    if not chosen:
        raise ValueError(f"there is no agent: {none}; name vehicles of {there} as agents")
    if twice := [sysid for sysid in chosen if chosen.count(sysid) > 1]:
        raise ValueError(f"vehicle {twice[0]} is named as an agent twice; name each once")
    return sorted(chosen)
