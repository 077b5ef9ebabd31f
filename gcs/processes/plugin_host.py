"""The process of a user's planner and policy: `python -m gcs.processes.plugin_host SOCKET TRACE PARENT`, started by the
supervisor, and before that by the command that reads the scenario (gcs/processes/plugin_process.py).

It answers questions on descriptor SOCKET (gcs/processes/plugin_channel.py) until that closes, and ends with process
PARENT, whatever it is at. Its stdout is for what the user's code prints. Descriptor TRACE takes where that code is when
it crashes, or on DUMPS, which then ends it: a signal's handler in C writes there, also within compiled code.
"""

from __future__ import annotations

import contextlib
import faulthandler
import json
import pickle
import signal
import socket
import sys
import time
from collections.abc import Mapping
from typing import Any

from setproctitle import setproctitle

from gcs.planner.request import GuardedPlanner
from gcs.processes.plugin_channel import PluginChannel, answer, planner_question, policy_question
from gcs.scenario import plugins
from gcs.scenario.document import ScenarioError
from gcs.scenario.guard import Guard
from gcs.scenario.model import Scenario
from gcs.scenario.plugins import PLANNER
from skytender.exit import DONE, leave
from skytender.processes import end_with

DUMPS = signal.SIGUSR1
WORD_EVERY_S = 0.5
"""A slow planner's answers are sent one by one: the supervisor waits for each of them, not for all."""


class PluginHost:
    """A planner and a policy that are asked."""

    def __init__(self, scenario: Scenario, channel: PluginChannel, given: Mapping[str, tuple[Any, Guard]]) -> None:
        """given: by key the implementation, and what guards its calls."""
        self._scenario, self._channel = scenario, channel
        self._made: dict[str, Any] = {}
        for key, (made, guard) in given.items():
            if key == PLANNER:
                self._made[key] = GuardedPlanner(made, guard)
            else:
                from gcs.refuelling.policies import GuardedPolicy  # noqa: PLC0415 - a planner alone needs none of it

                self._made[key] = GuardedPolicy(made, guard)

    @property
    def assigns(self) -> dict[str, bool]:
        """By key whether it has a method `assign`."""
        return {key: getattr(made, "assigns", False) for key, made in self._made.items()}

    def reply(self, key: str, content: tuple[Any, ...]) -> None:
        """Answer a question. Raises OSError."""
        (self._plan if key == PLANNER else self._choose)(key, content)

    def _plan(self, key: str, content: tuple[Any, ...]) -> None:
        planner = self._made[key]
        vehicles, situation = planner_question(content, self._scenario)
        rows: list[tuple[Any, ...]] = []
        word_s = time.monotonic()
        for vehicle in vehicles:
            planned = planner.plan(vehicle, situation)
            if planned is not None:
                rows.append((vehicle.sysid, *planned[0], *planned[1]))
            if time.monotonic() - word_s > WORD_EVERY_S:
                self._channel.send(answer(key, rows, planner.guard.pop_faults(), last=False))
                rows, word_s = [], time.monotonic()
        self._channel.send(answer(key, rows, planner.guard.pop_faults(), last=True))

    def _choose(self, key: str, content: tuple[Any, ...]) -> None:
        policy = self._made[key]
        pairs = policy.pairs(policy_question(content, self._scenario))
        self._channel.send(answer(key, pairs.items(), policy.pop_faults(), last=True))


def _given(scenario: Scenario) -> dict[str, tuple[Any, Guard]]:
    """The implementations that a scenario names, made. Raises ScenarioError where something cannot be made."""
    return {
        key: (plugins.make(key, name, method, scenario), Guard(plugins.policy_of(key, name)))
        for key, name, method in plugins.named(scenario)
    }


def serve(channel: PluginChannel) -> None:
    """Make what the first question names, or only look for it, and answer all others, until there are no more. Raises
    OSError."""
    host: PluginHost | None = None
    while True:
        while (frame := channel.pop()) is None:
            if not channel.read():
                return
        if host is not None:
            host.reply(*pickle.loads(frame))
            continue
        scenario, modules, makes = pickle.loads(frame)
        plugins.look_in(modules)
        if not makes:
            channel.send(json.dumps({"missing": plugins.missing(scenario)}).encode())
            return
        try:
            host = PluginHost(scenario, channel, _given(scenario))
        except ScenarioError as error:
            channel.send(json.dumps({"error": error.problems[0].message}).encode())
            return
        channel.send(json.dumps({"made": host.assigns}).encode())


def main() -> None:
    """Entry point."""
    number, trace, parent = map(int, sys.argv[1:])
    end_with(parent)
    setproctitle("gcs plug-ins")
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    faulthandler.enable(trace)
    faulthandler.register(DUMPS, trace, chain=True)
    if hasattr(sys.stdout, "reconfigure"):
        sys.stdout.reconfigure(line_buffering=True)
    with contextlib.suppress(BrokenPipeError, ConnectionResetError):  # the session has ended
        serve(PluginChannel(socket.socket(fileno=number)))
    leave(DONE)


if __name__ == "__main__":
    main()
