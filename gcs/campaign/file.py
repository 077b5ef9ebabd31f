"""Campaign files: found by path or shipped name, read with places in the file, and written."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from gcs.campaign.model import CampaignRules
from gcs.campaign.plain_data import plain
from gcs.scenario.document import Document, Problem, ScenarioError, did_you_mean, emit, read
from gcs.scenario.file import CAMPAIGNS, shipped_folder


def shipped_names() -> tuple[str, ...]:
    """The shipped campaigns' names in alphabetical order."""
    return tuple(sorted(path.stem for path in (shipped_folder() / CAMPAIGNS).glob("*.yaml")))


def find(campaign: str) -> Path:
    """The file that `campaign` means: a file of that path, otherwise the shipped one. Raises ScenarioError."""
    path, shipped = Path(campaign), shipped_names()
    if path.is_file():
        return path
    if campaign in shipped:
        return shipped_folder() / CAMPAIGNS / f"{campaign}.yaml"
    near = did_you_mean(campaign, shipped)
    message = f"no such file, and no shipped campaign of that name ({', '.join(shipped)}){near}"
    raise ScenarioError([Problem(campaign, None, None, message)])


def load(path: str | os.PathLike[str]) -> CampaignRules:
    """The campaign in the YAML file at `path`. Raises ScenarioError: what is wrong, and where."""
    return checked(read(path))


def from_data(data: dict[str, Any], name: str = "campaign") -> CampaignRules:
    """A campaign from plain data. Raises ScenarioError."""
    return checked(Document(name, plain(data, name)))


def checked(document: Document) -> CampaignRules:
    """The campaign that a document says. Raises ScenarioError."""
    document.what = "the campaign"
    try:
        return CampaignRules.model_validate(document.data)
    except ValidationError as error:
        raise ScenarioError(document.explain(error, CampaignRules.model_json_schema())) from None


def dump(campaign: CampaignRules) -> str:
    """The campaign as YAML that `load` reads back equal."""
    return emit(campaign.model_dump(mode="json", by_alias=True, exclude_none=True))
