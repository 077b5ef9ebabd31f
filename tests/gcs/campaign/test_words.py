"""What a campaign's table, its status and its page say of its rows."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from gcs.campaign import file, report, statistics, table
from gcs.campaign.plan import Plan, make
from gcs.cli.campaign.command import campaign


def plan(vary: dict[str, list[Any]]) -> Plan:
    content = {"schema": 1, "name": "said", "scenario": "demo", "sessions": 3, "measure": ["lost"], "vary": vary}
    return make(file.from_data(content), [])


@pytest.mark.parametrize("errors", [0, 2])
def test_sessions_with_errors_are_counted_beside_the_rate(errors: int, tmp_path: Path) -> None:
    flown = plan({"competition.policy": ["winner_take_all", "optimal"]})
    flown.write(tmp_path)
    broken = {"ok": False, "error": "the session was killed by signal 9"}
    rows = [{"row": k, "session": k // 2, "combination": k % 2, "seed": k, "ok": True, "lost": 0.0} for k in range(6)]
    for row in rows[1 : 2 * errors : 2]:
        row.update(broken)
    table.Writer(tmp_path, flown.campaign).write(rows)
    good = 3 - errors
    shown = report.make(tmp_path, flown).read_text(encoding="utf-8")
    assert re.search(rf"<td>policy optimal</td><td>{good} of 3</td>.{{,60}}<td>{errors}</td></tr>", shown)
    assert re.search(r"<td>policy winner_take_all</td><td>3 of 3</td>.{,60}<td>0</td></tr>", shown)
    said = CliRunner().invoke(campaign, ["status", str(tmp_path)]).output
    assert re.search(rf"^policy optimal +{good} of 3 +\S+ to \S+ % +{errors} ", said, re.MULTILINE)
    for words in (shown, said):
        assert ("gcs campaign resume leaves them so" in words) == bool(errors)
    counts = json.loads(CliRunner().invoke(campaign, ["status", str(tmp_path), "--json"]).output)["combinations"]
    assert [(one["ok"], one["of"], one["errors"]) for one in counts] == [(3, 3, 0), (good, 3, errors)]


VEHICLE = "vehicles.pursuers.{}.battery.{}"


@pytest.mark.parametrize(
    ("vary", "name"),
    [
        (
            {VEHICLE.format(0, "capacity_j"): [20_000], VEHICLE.format(1, "capacity_j"): [10_000]},
            "pursuers.0.battery.capacity_j 20000, pursuers.1.battery.capacity_j 10000",
        ),
        (
            {VEHICLE.format(0, "capacity_j"): [20_000], VEHICLE.format(0, "hover_w"): [200]},
            "capacity_j 20000, hover_w 200",
        ),
        (
            {"vehicles.pursuers.0.start_m.1": [1.0], "vehicles.pursuers.0.start_m.2": [2.0], "radio.loss": [0.1]},
            "start_m.1 1.0, start_m.2 2.0, loss 0.1",
        ),
        (
            {VEHICLE.format("0", "capacity_j"): [9000], "vehicles.tankers.0.battery.capacity_j": [8000]},
            "pursuers.0.battery.capacity_j 9000, tankers.0.battery.capacity_j 8000",
        ),
        (
            {
                "vehicles.pursuers.0.battery": [{"capacity_j": 1, "hover_w": 5}, {"capacity_j": 2, "hover_w": 5}],
                "vehicles.pursuers.1.battery.capacity_j": [3],
            },
            "pursuers.0.battery.capacity_j 1, pursuers.1.battery.capacity_j 3",
        ),
    ],
)
def test_labels_have_as_much_of_the_key_path_as_tells_them_apart(vary: dict[str, list[Any]], name: str) -> None:
    assert statistics.name_of(plan(vary), 0) == name
