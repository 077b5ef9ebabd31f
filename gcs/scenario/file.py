"""Scenario files, by path or by the name of a shipped one (`demo` is a name, `./demo.yaml` a file): read, written.

Shipped ones stand in `configs/`: beside the packages in a checkout, inside `gcs` in an installed wheel.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from gcs.scenario import external, keys
from gcs.scenario.document import Conflict, Document, KeyPath, Problem, ScenarioError, did_you_mean, emit, read
from gcs.scenario.grid import expand
from gcs.scenario.json_schema import editor_schema
from gcs.scenario.model import Scenario, repeats
from gcs.scenario.parts import mission, plan_file

CURRENT = 1
CAMPAIGNS = "campaigns"
"""The folder among the shipped scenarios that holds campaigns instead."""
CHANGED: dict[int, str] = {0: "this is the number of drafts; the first published format is 1, which `gcs init` writes"}
"""By version, what came after it: what to do to a file of that version to make it one of the next."""
GROUPS = (("vehicles", "pursuers"), ("vehicles", "targets"), ("vehicles", "tankers"), ("obstacles",))
"""Lists whose entries may be a grid."""


def shipped_folder() -> Path:
    """Folder of the shipped scenarios."""
    package = Path(__file__).resolve().parents[1]
    inside = package / "configs"
    return inside if inside.is_dir() else package.parent / "configs"


def shipped_names() -> tuple[str, ...]:
    """The shipped scenarios' names in alphabetical order, such as `demo` and `paper/example1`."""
    root = shipped_folder()
    files = (path.relative_to(root).with_suffix("") for path in root.rglob("*.yaml"))
    return tuple(sorted(path.as_posix() for path in files if path.parts[0] != CAMPAIGNS))


def find(scenario: str) -> Path:
    """The file that `scenario` means: a file of that path if there is one, otherwise the shipped one of that name.

    Whatever else is there (a directory, a device) is returned as it is, for `load` to say what is wrong with it.
    Raises ScenarioError where nothing is.
    """
    path, shipped = Path(scenario), shipped_names()
    try:
        if path.is_file():
            return path
        if scenario in shipped:
            return shipped_folder() / f"{scenario}.yaml"
        if scenario and path.exists():
            return path
    except (OSError, ValueError):  # a name that the system cannot even look up
        pass
    near = did_you_mean(scenario, shipped)
    message = f"no such file, and no shipped scenario of that name ({', '.join(shipped)}){near}"
    raise ScenarioError([Problem(scenario, None, None, message)])


def refusal(version: Any) -> str | None:
    """Why a file of this version cannot be read, as a sentence; None where it can, or where it is no version at all."""
    if isinstance(version, bool) or not isinstance(version, int) or version == CURRENT:
        return None
    if version > CURRENT:
        return f"schema {version} is newer than this program, which reads {CURRENT}: install a newer Skytender"
    steps = [f"{old} to {old + 1}: {CHANGED[old]}" for old in range(version, CURRENT) if old in CHANGED]
    if not steps:
        return None
    return f"schema {version} is an older format; change the file, then write 'schema: {CURRENT}'. {'; '.join(steps)}"


def load(path: str | os.PathLike[str], *, set: Mapping[str, Any] | None = None) -> Scenario:
    """The scenario in the YAML file at `path`, in NED. Raises ScenarioError: what is wrong, and where.

    set: values by key path (gcs/scenario/keys.py) instead of the file's, in the file's axes.
    """
    return resolve(read(path), set or {})


def resolve(document: Document, settings: Mapping[str, Any]) -> Scenario:
    """The scenario that a document says, with these key paths set; the document is used up. Raises ScenarioError."""
    if (unread := refusal(document.data.get("schema"))) is not None:
        raise ScenarioError([document.problem(("schema",), unread)])
    for listed in GROUPS:
        expand(document, listed)
    if settings:
        keys.apply(document, settings)
        for listed in GROUPS:
            expand(document, listed)
    vehicles = document.data.get("vehicles")
    if isinstance(vehicles, dict) and "defaults" in vehicles:
        defaults = ("vehicles", "defaults")
        if not isinstance(vehicles["defaults"], dict):
            raise ScenarioError([document.problem(defaults, "vehicles.defaults must be a block of keys")])
        for path, vehicle in _vehicles(document.data):
            own = tuple(vehicle)
            document.inherit(defaults, path)
            external.inherited(vehicle, own)
        del vehicles["defaults"]
    plan_file.fill(document)
    mission.fill(document, _vehicles(document.data))
    external.absolute_paths((keys for _, keys in _vehicles(document.data)), Path(document.file).parent)
    try:
        return Scenario.model_validate(document.data, context={"axes": document.data.get("axes")})
    except ValidationError as error:
        problems = document.explain(error, editor_schema())
        whole = [details["type"] for details in error.errors() if not details["loc"]]
        if "conflict" not in whole:  # they were not looked for
            problems += [document.disagreement(repeated) for repeated in _repeated_ids(document.data)]
        raise ScenarioError(sorted(problems, key=lambda problem: (problem.line or 0, problem.column or 0))) from None


def _repeated_ids(data: dict[str, Any]) -> Iterator[Conflict]:
    """System ids that a file gives twice, whatever else is wrong with it."""
    given: list[tuple[KeyPath, object]] = []
    for path, vehicle in _vehicles(data):
        for where, place in ((vehicle, ()), (vehicle.get("external"), ("external",))):
            if isinstance(where, dict) and type(where.get("sysid")) is int:
                given.append(((*path, *place, "sysid"), where["sysid"]))
                break
    return repeats("sysid", given)


def _vehicles(data: dict[str, Any]) -> Iterator[tuple[KeyPath, dict[str, Any]]]:
    """The vehicles' keys as a file has them, each with its key path; what is no block of keys is passed over."""
    vehicles = data.get("vehicles")
    groups = vehicles if isinstance(vehicles, dict) else {}
    for key in ("pursuers", "targets", "tankers"):
        for i, vehicle in enumerate(groups[key] if isinstance(groups.get(key), list) else ()):
            if isinstance(vehicle, dict):
                yield ("vehicles", key, i), vehicle


def dump(scenario: Scenario) -> str:
    """The scenario as YAML in NED, every value written out, which `load` reads back equal."""
    return emit(scenario.model_dump(mode="json", by_alias=True, exclude_none=True))
