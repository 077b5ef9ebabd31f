"""Scenarios as text, and what is said of them."""

from __future__ import annotations

from pathlib import Path

import pytest

from gcs.scenario.file import load
from gcs.scenario.model import Scenario, ScenarioError

PAPER_OBSTACLES = [  # x north, y west, z up (docs/model/planner.md#potential-field) [seed]
    *((1, 2, 1.5), (2, 2, 1), (2, 2, 2), (4, 2.2, 2.1), (4.1, 3, 2.1), (3, 5, 2.1), (4, 5, 2.1), (5, 5, 2.3)),
    *((5.8, 5, 2.4), (8, 5, 2.6), (8.3, 6, 2.7), (8, 8, 2.6), (8.5, 8, 2.7)),
]
SMALL = """\
schema: 1
name: small
axes: ned
origin: {lat_deg: 47, lon_deg: 8, alt_m: 0}
goal: {duration_s: 10}
vehicles:
  pursuers:
    - {sysid: 1, start_m: [0, 0, 0], battery: {capacity_j: 1000}}
    - {sysid: 2, start_m: [5, 0, 0], battery: {capacity_j: 1000}}
  targets:
    - {sysid: 3, start_m: [9, 0, 0], battery: {capacity_j: 1000}, path_m: [[1, 2, -3], [4, 5, -6]], speed_m_s: 1}
"""


def loaded(path: Path, text: str) -> Scenario:
    """The scenario of this text, written to `path`."""
    path.write_text(text, encoding="utf-8")
    return load(path)


def refusal(path: Path, text: str) -> str:
    """What is said of `text`, without the folder."""
    with pytest.raises(ScenarioError) as caught:
        loaded(path, text)
    return str(caught.value).replace(f"{path.parent}/", "")


def changed(text: str, old: str, new: str) -> str:
    """The text with its first `old`, which is there, replaced."""
    assert old in text
    return text.replace(old, new, 1)
