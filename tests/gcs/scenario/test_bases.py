"""Bases in scenario files: what is read, and what is refused with which sentence."""

from __future__ import annotations

from pathlib import Path

import pytest

from gcs.scenario.file import dump, load
from gcs.scenario.model import ScenarioError

TEXT = """\
schema: 1
name: bases
axes: AXES
origin: {lat_deg: 47, lon_deg: 8, alt_m: 0}
goal: {duration_s: 10, refuelled_at_least: 1}
vehicles:
  pursuers:
    - {sysid: 1, start_m: [0, 0, 0], battery: {capacity_j: 1000}, transfer: false}
bases:
  - {name: pad, position_m: [4, 6, 0], stock_j: 5000}
"""


def written(path: Path, *changes: tuple[str, str], axes: str = "ned") -> Path:
    text = TEXT.replace("AXES", axes)
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    file = path / "s.yaml"
    file.write_text(text, encoding="utf-8")
    return file


def test_a_base_is_read_and_written(tmp_path: Path) -> None:
    scenario = load(written(tmp_path))
    (base,) = scenario.bases
    assert (base.name, base.position_m, base.stock_j, base.rate_w) == ("pad", (4.0, 6.0, 0.0), 5000.0, 2000.0)
    assert base.above_m == (4.0, 6.0, -2.5)
    (tmp_path / "again.yaml").write_text(dump(scenario), encoding="utf-8")
    assert load(tmp_path / "again.yaml") == scenario


def test_its_place_is_turned_from_paper_axes(tmp_path: Path) -> None:
    (base,) = load(written(tmp_path, axes="paper")).bases
    assert base.position_m == (4.0, -6.0, 0.0)
    assert base.above_m == (4.0, -6.0, -2.5)


@pytest.mark.parametrize(
    ("change", "line", "said"),
    [
        (("[4, 6, 0]", "[4, 6, -1]"), 10, "the base pad must stand on the ground"),
        (("stock_j: 5000}", "stock_j: 5000, radius_m: 9.0}"), 10, "radius_m is at most refuelling.capture_m, 1.5"),
        (("stock_j: 5000", "stock_j: 0"), 10, "stock_j"),
        (("battery: {", "airborne: true, battery: {"), 8, "pursuer 1 starts airborne, without a ground"),
        (
            ("5000}\n", "5000}\n  - {name: pad, position_m: [9, 9, 0], stock_j: 5}\n"), 11,
            "the name pad is given twice",
        ),
        (
            ("bases:", "obstacles: [{name: mast, point_m: [4, 6.2, -2.5]}]\nbases:"), 11,
            "the base pad lies inside or within 0.3 m of the obstacle mast",
        ),
    ],
)  # fmt: skip
def test_what_cannot_work_is_refused_where_it_stands(
    tmp_path: Path, change: tuple[str, str], line: int, said: str
) -> None:
    with pytest.raises(ScenarioError) as caught:
        load(written(tmp_path, change))
    assert said in str(caught.value)
    assert f"s.yaml:{line}" in str(caught.value)


def test_a_goal_of_refuellings_needs_a_tanker_or_a_base(tmp_path: Path) -> None:
    text = written(tmp_path).read_text(encoding="utf-8").partition("bases:\n")[0]
    (tmp_path / "none.yaml").write_text(text, encoding="utf-8")
    with pytest.raises(ScenarioError, match="a tanker or a base"):
        load(tmp_path / "none.yaml")
