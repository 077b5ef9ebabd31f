"""The short form for many alike: counted out by hand, and its mistakes told where the file has them."""

from pathlib import Path

import pytest

from gcs.scenario.file import find, load
from gcs.scenario.model import Scenario, ScenarioError

HEAD = """schema: 1
name: g
axes: paper
origin: {lat_deg: 47, lon_deg: 8, alt_m: 400}
goal: {duration_s: 60}
"""


def read(tmp_path: Path, rest: str) -> Scenario:
    path = tmp_path / "g.yaml"
    path.write_text(HEAD + rest, encoding="utf-8")
    return load(path)


def test_rows_lie_along_the_first_axis_and_ids_count_up(tmp_path: Path) -> None:
    made = read(
        tmp_path,
        """vehicles:
  defaults: {battery: {capacity_j: 1000}}
  pursuers:
    - {sysid: 9, start_m: [-1, 0, 0]}
    - {sysid: 10, start_m: [0, 1, 2], airborne: true, grid: {count: 5, columns: 2, spacing_m: [10, 3]}}
obstacles:
  - {cylinder_m: [50, 0], radius_m: 1, bottom_m: 0, top_m: 9, grid: {count: 2, columns: 1, spacing_m: [4, 0]}}
  - {box_m: [[60, 0, 0], [61, 1, 1]], grid: {count: 2, columns: 2, spacing_m: [0, 5]}}
""",
    )
    assert [v.sysid for v in made.vehicles.pursuers] == [9, 10, 11, 12, 13, 14]
    starts = [(0, 1), (0, 4), (10, 1), (10, 4), (20, 1)]  # x, y in the file; east is -y
    assert [v.start_m for v in made.vehicles.pursuers[1:]] == [(x, -y, -2) for x, y in starts]
    assert [o.low_m[:2] for o in made.obstacles] == [(50, 0), (54, 0), (60, -1), (60, -6)]


@pytest.mark.parametrize(
    ("grid", "line", "words"),
    [
        ("{count: 0, columns: 2, spacing_m: [1, 1]}", 8, "grid must be"),
        ("{count: 2, columns: 2, spacing_m: 1}", 8, "grid must be"),
        ("{count: 2, colums: 2, spacing_m: [1, 1]}", 8, "grid must be"),
        ("{count: 2, columns: 2, spacing_m: [0, 0]}", 8, "starts 0.00 m from"),
        ("{count: 2, columns: 2, spacing_m: [3, 3]}, takof_m: 1", 8, "takeoff_m"),
    ],
)
def test_a_mistake_is_told_at_its_line(tmp_path: Path, grid: str, line: int, words: str) -> None:
    vehicle = (
        f"vehicles:\n  pursuers:\n    - {{sysid: 1, start_m: [0, 0, 0], battery: {{capacity_j: 9}}, grid: {grid}}}\n"
    )
    with pytest.raises(ScenarioError) as told:
        read(tmp_path, vehicle)
    assert told.value.problems[0].line == line
    assert words in str(told.value)


def test_the_fleet_holds_all_system_ids_and_a_hundred_obstacles() -> None:
    fleet = load(find("fleet"))
    vehicles = fleet.vehicles
    assert [len(group) for group in (vehicles.pursuers, vehicles.tankers, vehicles.targets)] == [245, 4, 5]
    assert [vehicle.sysid for vehicle in vehicles.all] == list(range(1, 255))
    assert len(fleet.obstacles) == 100
