"""A program's own planner and policy, which it gives its session as objects: made and called in the program's process,
while that waits for the session (gcs/session/program/object_client.py)."""

from __future__ import annotations

import json
import math
import pickle
import socket
from collections.abc import Callable, Mapping
from typing import Any

from gcs.processes.plugin_channel import PluginChannel, answer
from gcs.processes.plugin_host import PluginHost
from gcs.scenario.guard import Guard
from gcs.scenario.model import CompetitionRules, PlannerRules, Scenario
from gcs.scenario.plugins import METHODS, PLANNER, POLICY, policy_of


def without(scenario: Scenario, given: Mapping[str, Any]) -> Scenario:
    """The scenario without the planner and policy that it names, where objects take their place."""
    changed: dict[str, Any] = {}
    if PLANNER in given:
        method = PlannerRules.model_fields["method"].default
        changed["planner"] = scenario.planner.model_copy(update={"method": method})
    if POLICY in given:
        if scenario.competition.where == "vehicles":
            raise ValueError("policy is for a scenario whose supervisor decides the refuelling, not `where: vehicles`")
        policy = CompetitionRules.model_fields["policy"].default
        changed["competition"] = scenario.competition.model_copy(update={"policy": policy})
    return scenario.model_copy(update=changed)


def made(key: str, given: Any, scenario: Scenario) -> Any:
    """The object itself: as it is, or made as CLASS(scenario). Raises TypeError where it is none of these."""
    method, one = METHODS[key], given
    if isinstance(given, type) or (not hasattr(given, method) and isinstance(given, Callable)):  # type: ignore[arg-type]
        one = given(scenario)
    if not callable(getattr(one, method, None)):
        raise TypeError(f"{_name(given)} has no method {method!r}, which a {key.split('.', maxsplit=1)[0]} needs")
    return one


def _name(given: Any) -> str:
    return str(getattr(given, "__name__", None) or type(given).__name__)


class Objects:
    """The objects, and the end of their socket pair that the program keeps."""

    def __init__(self, given: Mapping[str, Any], scenario: Scenario) -> None:
        """given: by key of gcs/scenario/plugins.py a class, or an object of it."""
        self._guards = {key: Guard(policy_of(key, _name(one)), math.inf) for key, one in given.items()}
        pairs = {key: (made(key, one, scenario), self._guards[key]) for key, one in given.items()}
        self._ours, self.theirs = socket.socketpair()
        self._channel = PluginChannel(self._ours)
        self._host = PluginHost(scenario, self._channel, pairs)
        about = {key: {"name": _name(given[key]), "assigns": self._host.assigns[key]} for key in given}
        self._channel.send(json.dumps(about).encode())

    def fileno(self) -> int:
        """Readable when the session asks something, or has ended."""
        return self._ours.fileno()

    def reply(self) -> bool:
        """Answer what the session has asked; False once it asks no more.

        What the objects raise is remembered, but for KeyboardInterrupt, which leaves the question with a bad answer.
        """
        try:
            if not self._channel.read():
                return False
            while (frame := self._channel.pop()) is not None:
                try:
                    self._host.reply(*pickle.loads(frame))
                except BaseException:
                    self._channel.send(answer(PLANNER, (), (), last=True))  # without rows it is the same of all
                    raise
        except OSError:
            return False
        return True

    def pop_raised(self) -> tuple[str, BaseException] | None:
        """The first exception since the last call, and who raised it."""
        found = None
        for guard in self._guards.values():
            if guard.raised is not None:
                found = found or (guard.policy, guard.raised)
                guard.raised = None
        return found

    def close(self) -> None:
        """Answer nothing any more."""
        self._ours.close()
        self.theirs.close()
