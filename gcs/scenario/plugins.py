"""Planners and policies that a scenario names as MODULE:CLASS: found, imported, made; what is wrong is a sentence.

They are made and asked in a process of their own (gcs/processes/plugin_process.py).

Modules are looked for where Python looks, and then in the scenario's folder and in the current one: a file there can
stand for no module that is installed, and nothing there is found where a scenario names no code.
"""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any, Protocol

from gcs.scenario import plugin_source
from gcs.scenario.document import Problem, ScenarioError, did_you_mean, read
from gcs.scenario.guard import PluginFault
from gcs.scenario.model import Scenario

PLANNER, POLICY = "planner.method", "competition.policy"
"""Keys that may name an implementation that is not Skytender's own."""
METHODS = {PLANNER: "plan", POLICY: "choose"}
"""Methods that an implementation must have, by key."""


class PluginClient(Protocol):
    """Process of a scenario's own planner and policy, as those see it that ask them; `key` is PLANNER or POLICY."""

    @property
    def ended(self) -> bool:
        """Whether the process is no more: it answers nothing."""

    def made(self, key: str) -> bool:
        """Wait until the implementation is made; whether it has a method `assign`. Raises ScenarioError where it
        cannot be made."""

    def ask(self, key: str, question: Any) -> None:
        """Put a question, which is answered meanwhile: for a planner (system ids, Situation), for a policy a
        RefuellingRequest."""

    def answers(self, key: str) -> list[Any]:
        """Wait for the answers to the last question: (system id, n, e, d, v_n, v_e, v_d) for each vehicle that is
        planned for, or (tanker, receiver). There are none once the process has ended."""

    def pop_faults(self) -> list[PluginFault]:
        """The problems since the last call."""

    def pop_records(self) -> list[dict[str, Any]]:
        """Answers since the last call as decisions, where they cannot be had again from the recording alone."""
        return []


def named(scenario: Scenario) -> Iterator[tuple[str, str, str]]:
    """(key, MODULE:CLASS, method that it must have) of each implementation that is not Skytender's own."""
    if ":" in scenario.planner.method:
        yield PLANNER, scenario.planner.method, METHODS[PLANNER]
    if ":" in scenario.competition.policy:
        yield POLICY, scenario.competition.policy, METHODS[POLICY]


def clients(scenario: Scenario, process: PluginClient | None) -> dict[str, PluginClient]:
    """By key, the process that answers for what a scenario names."""
    return {} if process is None else dict.fromkeys((key for key, _, _ in named(scenario)), process)


def policy_of(key: str, name: str) -> str:
    """Name for people of what a key names: `planner my_planner:Ring`."""
    return f"{'planner' if key == PLANNER else 'policy'} {name}"


def look_in(folders: Iterable[str | Path]) -> None:
    """Let modules in these folders be found, after all others."""
    for folder in [str(Path(folder).resolve()) for folder in folders]:
        if folder not in sys.path:
            sys.path.append(folder)


def missing(scenario: Scenario) -> list[tuple[str, str]]:
    """(key, sentence) of each implementation that a scenario names and that cannot be used; they are imported, and
    not made."""
    problems = []
    for key, name, method in named(scenario):
        try:
            find(name, method)
        except ValueError as error:
            problems.append((key, str(error)))
    return problems


def check_sources(scenario: Scenario, file: Path | None, folders: Sequence[Path]) -> None:
    """See by their source files, of which nothing runs, that the implementations that a scenario, read from `file`,
    names are there.

    `folders` are looked into after the places where Python looks. Raises ScenarioError, at the lines that name them.
    """
    problems = []
    for key, name, _ in named(scenario):
        try:
            plugin_source.check(name, folders)
        except ValueError as error:
            problems.append((key, str(error)))
    refuse(scenario, file, problems)


def refuse(scenario: Scenario, file: Path | None, problems: Iterable[tuple[str, str]]) -> None:
    """Raise ScenarioError with these (key, sentence), at the lines of `file` that name the keys, if there are any."""
    found = []
    for key, sentence in problems:
        text = f"{key}: {sentence}"
        nowhere = Problem(scenario.name, None, None, text)
        found.append(nowhere if file is None else read(file).problem(tuple(key.split(".")), text))
    if found:
        raise ScenarioError(found)


def find(name: str, method: str) -> Any:
    """The class that MODULE:CLASS means. Raises ValueError: one sentence, why it cannot be used."""
    module_name, _, attribute = name.partition(":")
    try:
        module = importlib.import_module(module_name)
    except ModuleNotFoundError as error:
        if error.name is not None and (module_name == error.name or module_name.startswith(f"{error.name}.")):
            raise ValueError(
                f"there is no module {error.name!r}; put it beside the scenario or install its package"
            ) from None
        raise ValueError(
            f"{module_name} needs the package {error.name!r}, which is not installed: install it"
        ) from None
    except (Exception, SystemExit) as error:
        raise ValueError(f"{module_name} cannot be imported: {plugin_source.where(error)}") from None
    made = getattr(module, attribute, None)
    if made is None:
        near = did_you_mean(attribute, (word for word in dir(module) if not word.startswith("_")))
        raise ValueError(f"{module_name} ({getattr(module, '__file__', '?')}) has no {attribute!r}{near}")
    if not callable(made):
        raise ValueError(f"{name} is no class")
    if isinstance(made, type) and not callable(getattr(made, method, None)):
        raise ValueError(f"{name} has no method {method!r}")
    return made


def make(key: str, name: str, method: str, scenario: Scenario) -> Any:
    """The implementation itself, given the scenario. Raises ScenarioError where it cannot be made."""
    try:
        try:
            made = find(name, method)(scenario)
        except ValueError:
            raise
        except (Exception, SystemExit) as error:
            raise ValueError(f"{name} cannot be made: {plugin_source.where(error)}") from None
        if not callable(getattr(made, method, None)):
            raise ValueError(f"{name} makes something without the method {method!r}")
    except ValueError as error:
        raise ScenarioError([Problem(scenario.name, None, None, f"{key}: {error}")]) from None
    return made
