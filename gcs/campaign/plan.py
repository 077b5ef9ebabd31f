"""The sessions of a campaign: row by row what is flown. A row depends on the campaign and its own number alone."""

from __future__ import annotations

import functools
import itertools
import json
import pickle
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from gcs.campaign import draws
from gcs.campaign.file import dump, load
from gcs.campaign.model import ARGUMENTS, CampaignRules
from gcs.campaign.plain_data import plain
from gcs.processes import plugin_process
from gcs.processes.python import current_folders
from gcs.scenario import keys, plugin_source, plugins
from gcs.scenario.document import Document, Problem, ScenarioError, emit, parse
from gcs.scenario.file import GROUPS, find, resolve
from gcs.scenario.grid import expand
from gcs.scenario.model import Scenario
from gcs.scenario.parts.reach import Reached, is_foreign_code, reached
from gcs.scenario.parts.trust import digest, text

CHANGED = "was changed since its sessions were flown, and only sessions may grow: put it back, or fly it anew"


class RowError(Exception):
    """A row that cannot be flown; the text says why."""


class NotAllowed(RowError):
    """A row that names code, programs or addresses that are not to be used unasked: `named`."""

    def __init__(self, named: Sequence[Reached]) -> None:
        super().__init__(f"it names {text(named)}: let it use them with --trust")
        self.named = named


@dataclass(frozen=True)
class PlannedRow:
    """One session to be flown: `values` are what vary and draw gave it, by key path."""

    number: int
    session: int
    combination: int
    seed: int
    values: dict[str, Any]


@dataclass(frozen=True)
class Plan:
    """A campaign with the text of its scenario: all that a worker needs."""

    campaign: CampaignRules
    file: str
    """the scenario's name in messages"""
    text: str
    """the scenario as YAML; empty where it is generated"""
    modules: tuple[str, ...] = ()
    """folders in which planners, policies and generators are looked for"""
    trusted: bool = False
    """whether what its scenarios name beyond a session may be used"""
    is_search: bool = False
    """whether its rows are the trials of a search, which follow from those before them (search.py)"""
    sources: dict[str, str | None] = field(default_factory=dict)
    """hash of the source of each module that is not shipped and that its first sessions name; None of a missing one"""

    @property
    def rows(self) -> int:
        """Number of sessions."""
        return self.campaign.sessions * self.campaign.combinations

    @property
    def trusted_by(self) -> str:
        """Hash of all that says what it names (gcs/scenario/parts/trust.py)."""
        return digest(*self.modules, dump(self.campaign), self.text)

    @property
    def fingerprint(self) -> str:
        """Hash of all that the rows follow from, but for how many there are."""
        campaign = self.campaign.model_copy(update={"sessions": 1})
        return digest(dump(campaign), self.text)

    def refuse_other(self, since: str, name: str) -> None:
        """Raise ScenarioError, by the file's name, where rows of the fingerprint `since` follow from something else."""
        if since != self.fingerprint:
            raise ScenarioError([Problem(name, None, None, CHANGED)])

    def refuse_changed_code(self, since: Mapping[str, str | None]) -> None:
        """Raise ScenarioError, by the file's name, where a module has another source than the hash `since`."""
        for module, was in since.items():
            file, now = _source(module, self.modules)
            if now != was:
                raise ScenarioError([Problem(str(file or module), None, None, CHANGED)])

    def row(self, number: int) -> PlannedRow:
        """A row: sessions in turn, each with every combination, so that pairs are complete early."""
        campaign = self.campaign
        session, combination = divmod(number, campaign.combinations)
        chosen = next(itertools.islice(itertools.product(*campaign.vary.values()), combination, None))
        values: dict[str, Any] = dict(zip(campaign.vary, chosen, strict=True))
        row = PlannedRow(number, session, combination, draws.seed_of(campaign.seed, session), values)
        for key, draw in campaign.draw.items():
            if draw.random is None and (key.startswith(ARGUMENTS) or keys.EACH not in key or draw.together):
                values[key] = draws.value(draw, draws.stream(campaign.seed, session, key))
        return row

    def resolved(self, row: PlannedRow) -> tuple[Scenario, dict[str, Any]]:
        """Scenario of a row, on the lockstep clock, and all its values, including each `*`. Raises RowError."""
        try:
            return self._resolved(row)
        except NotAllowed:
            raise
        except ScenarioError as error:
            raise RowError(" / ".join(problem.message for problem in error.problems)) from None
        except ValueError as error:
            raise RowError(str(error)) from None

    def _resolved(self, row: PlannedRow) -> tuple[Scenario, dict[str, Any]]:
        campaign, values = self.campaign, dict(row.values)
        document = self._document(row)
        paper = document.data.get("axes") == "paper"
        settings: dict[str, Any] = {**campaign.set, "seed": row.seed}
        settings |= {key: value for key, value in values.items() if not key.startswith(ARGUMENTS)}
        for key, draw in campaign.draw.items():
            if key not in values and draw.random is None:  # one value for each place that a `*` means
                rng, places = draws.stream(campaign.seed, row.session, key), keys.expanded(document, key)
                values[key] = [draws.value(draw, rng) for _ in places]
                settings |= dict(zip(places, values[key], strict=True))
        scenario = resolve(document, settings)
        self._allowed(scenario)
        drawn = campaign.draw.get("obstacles")
        if drawn is not None and drawn.random is not None:
            rng = draws.stream(campaign.seed, row.session, "obstacles")
            made = draws.obstacles(drawn.random, rng, scenario, paper=paper)
            values["obstacles"] = [one.model_dump(mode="json", exclude_defaults=True) for one in made]
            changed = scenario.model_dump(by_alias=True, exclude={"obstacles"})
            try:
                scenario = Scenario.model_validate({**changed, "obstacles": (*scenario.obstacles, *made)})
            except ValidationError as error:
                found = Document(self.file, changed).explain(error, Scenario.model_json_schema())
                raise ScenarioError(found) from None
        limit_s = campaign.limits.session_s
        if scenario.goal.duration_s > limit_s:
            raise RowError(f"the session lasts {scenario.goal.duration_s:g} s, above limits.session_s, {limit_s:g} s")
        if scenario.vehicles.external:
            raise RowError("a campaign flies simulated vehicles alone, and the scenario has external ones")
        plugins.check_sources(scenario, None, [Path(folder) for folder in self.modules])
        return scenario.flown(lockstep=True), values

    def _allowed(self, part: CampaignRules | Scenario) -> None:
        """Raises NotAllowed where a part names something that may not be used."""
        if not self.trusted and (named := reached(part)):
            raise NotAllowed(named)

    def _document(self, row: PlannedRow) -> Document:
        """The scenario's data before anything is set, grids written out."""
        if self.campaign.generate is None:
            return pickle.loads(_parsed(self.text, self.file))
        self._allowed(self.campaign)
        arguments = dict(self.campaign.arguments)
        for key, value in row.values.items():
            if key.startswith(ARGUMENTS):
                arguments[key.removeprefix(ARGUMENTS)] = value
        function = _generator(self.campaign.generate, self.modules)
        try:
            data = function(seed=row.seed, **arguments)
        except (Exception, SystemExit) as error:
            what = " ".join(str(error).split())
            raise ValueError(f"{self.campaign.generate} failed: {type(error).__name__}: {what}") from None
        if not isinstance(data, dict):
            raise ValueError(f"{self.campaign.generate} returned no block of keys")
        return _written_out(parse(emit(plain(data, self.campaign.generate)), self.campaign.generate))

    def checked(self) -> Plan:
        """The plan with its `sources`, once the first session of every combination can be flown, with the planners and
        policies that they name, which are imported in a process of their own. Raises ScenarioError, or NotAllowed with
        all that they name, OSError."""
        used = dict.fromkeys(reached(self.campaign))
        problems: list[Problem] = []
        imported: set[tuple[tuple[str, str, str], ...]] = set()
        named: dict[Reached, None] = {}
        for combination in range(min(self.campaign.combinations, 64)):
            row = self.row(combination)
            try:
                scenario, _ = self.resolved(row)
                used |= dict.fromkeys(reached(scenario))
                plugged = tuple(plugins.named(scenario))
                if plugged not in imported:
                    imported.add(plugged)
                    plugin_process.check(scenario, None, [Path(folder) for folder in self.modules])
            except NotAllowed as asks:
                named |= dict.fromkeys(asks.named)
            except (RowError, ScenarioError) as error:
                listed = ", ".join(f"{key}={row.values[key]}" for key in self.campaign.vary)
                problems.append(
                    Problem(self.campaign.name, None, None, f"{f'with {listed}: ' if listed else ''}{error}")
                )
        if problems:
            raise ScenarioError(problems[:1])
        if named:
            raise NotAllowed(list(named))
        code = [one.value for one in used if one.reach == "code"]
        for key in plugins.METHODS:
            drawn = self.campaign.draw.get(key)
            code += [name for name in (drawn and drawn.choice) or () if is_foreign_code(name)]
        modules = dict.fromkeys(name.partition(":")[0] for name in code)
        return replace(self, sources={module: _source(module, self.modules)[1] for module in modules})

    def write(self, folder: Path) -> None:
        """Put the campaign into its folder, from which `read` makes the same plan; raises OSError."""
        (folder / "campaign.yaml").write_text(dump(self.campaign), encoding="utf-8")
        if self.campaign.generate is None:
            (folder / "scenario.yaml").write_text(self.text, encoding="utf-8")
        about = {"scenario": self.file, "modules": self.modules, "search": self.is_search, "sha256": self.fingerprint}
        about["sources"] = self.sources
        (folder / "plan.json").write_text(json.dumps(about, indent=2) + "\n", encoding="utf-8")


def make(campaign: CampaignRules, beside: Sequence[Path]) -> Plan:
    """The plan of a campaign; files and modules are looked for in the folders `beside`. Raises ScenarioError."""
    folders, name, text = [*beside, *current_folders()], campaign.scenario, ""
    if name is None:
        name = str(campaign.generate)
    else:
        near = [folder / name for folder in beside if (folder / name).is_file()]
        file = near[0] if near else find(name)
        folders.insert(0, file.parent)
        text = file.read_text(encoding="utf-8-sig")
    return Plan(campaign, name, text, tuple(dict.fromkeys(str(f.resolve()) for f in folders)))


def read(folder: Path) -> Plan:
    """The plan that `write` put into a campaign's folder, of which more sessions may be wanted by now. Raises
    ScenarioError, also where its files say something else than by which its rows were flown; OSError."""
    about = json.loads((folder / "plan.json").read_text(encoding="utf-8"))
    campaign = load(folder / "campaign.yaml")
    text = "" if campaign.generate is not None else (folder / "scenario.yaml").read_text(encoding="utf-8")
    plan = Plan(
        campaign,
        about["scenario"],
        text,
        tuple(about["modules"]),
        is_search=about.get("search", False),
        sources=dict(about.get("sources", {})),
    )
    plan.refuse_other(about.get("sha256", plan.fingerprint), str(folder / "campaign.yaml"))
    return plan


def _source(module: str, folders: Sequence[str]) -> tuple[Path | None, str | None]:
    """File of a module, and the hash of its content; None of what is not there."""
    file = plugin_source.source(module, [Path(folder) for folder in folders])
    try:
        return file, None if file is None else digest(file.read_bytes())
    except OSError:
        return file, None


@functools.lru_cache(4)
def _parsed(text: str, file: str) -> bytes:
    """The document, pickled: each row takes a copy, which is made sooner from that than from itself."""
    return pickle.dumps(_written_out(parse(text, file)))


def _written_out(document: Document) -> Document:
    for listed in GROUPS:
        expand(document, listed)
    return document


@functools.lru_cache(4)
def _generator(name: str, modules: tuple[str, ...]) -> Callable[..., Any]:
    plugins.look_in(modules)
    return plugins.find(name, "__call__")
