"""Recordings decided again: against the session that made them."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from commands import gcs
from sessions import Outcome, fly, merged, small, two_refuellings

from gcs.scenario.file import load
from gcs.supervisor.redecide import RedecideError, redecide


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    content = merged(two_refuellings(), {"goal": {"duration_s": 25.0}})
    return fly(content, tmp_path_factory.mktemp("flown"), "--plain")


def made(flown: Outcome) -> list[dict[str, Any]]:
    """The decisions that are made again: orders and deaths come from the recording."""
    return [record for record in flown.decisions if record["kind"] not in ("death", "operator")]


def test_an_unchanged_session_is_decided_the_same_to_the_last_digit(session: Outcome) -> None:
    again = gcs("replay", str(session.folder), "--decide")
    assert again.stdout == f"all {len(made(session))} decisions up to 24.9 s agree\n"
    assert (again.returncode, again.stderr) == (0, "")


def copy(session: Outcome, folder: Path) -> Path:
    folder.mkdir()
    for name in ("session.tlog", "summary.json"):
        (folder / name).symlink_to(session.folder / name)
    for name in ("scenario.yaml", "decisions.jsonl"):
        (folder / name).write_bytes((session.folder / name).read_bytes())
    return folder


def test_an_edited_set_point_is_the_one_difference(session: Outcome, tmp_path: Path) -> None:
    folder = copy(session, tmp_path / "edited")
    lines = (folder / "decisions.jsonl").read_text().splitlines()
    at = next(i for i, line in enumerate(lines) if '"kind":"set_point"' in line and json.loads(line)["t_s"] >= 12.3)
    edited = json.loads(lines[at])
    was = edited["p_ned"][0]
    edited["p_ned"][0] = was + 1e-9
    lines[at] = json.dumps(edited, sort_keys=True, separators=(",", ":"))
    (folder / "decisions.jsonl").write_text("\n".join(lines) + "\n")
    told = gcs("replay", str(folder), "--decide", "--json")
    assert told.returncode == 1
    difference, verdict = map(json.loads, told.stdout.splitlines())
    assert (difference["t_s"], difference["kind"]) == (edited["t_s"], "set_point")
    assert difference["today"]["p_ned"][0] == was
    assert verdict["differences"] == {"set_point": 1}


def test_another_need_from_differs_first_where_somebody_competed_below_it(session: Outcome, tmp_path: Path) -> None:
    """Whoever competes first needs less than 0.7, and then does not compete yet."""
    folder = copy(session, tmp_path / "changed")
    text = (folder / "scenario.yaml").read_text()
    assert load(folder / "scenario.yaml").competition.need_from < 0.7
    (folder / "scenario.yaml").write_text(re.sub(r"need_from: [\d.]+", "need_from: 0.7", text))
    first = next(record for record in session.decisions if record["kind"] == "decided")
    verdict = redecide(folder)
    assert not verdict.agrees
    assert (verdict.differences[0].t_s, verdict.differences[0].kind) == (first["t_s"], "decided")
    assert verdict.differences[0].sentence == f"{first['t_s']:.1f} s: decided (receiver 1, tanker 201): recorded only"


def test_orders_and_deaths_happen_again_where_they_are_recorded(session: Outcome, tmp_path: Path) -> None:
    """An order that was never given makes a difference from its own tick on; the order itself is none."""
    folder = copy(session, tmp_path / "ordered")
    lines = (folder / "decisions.jsonl").read_text().splitlines()
    at = next(i for i, line in enumerate(lines) if json.loads(line)["t_s"] >= 20.0)
    order = {"t_s": json.loads(lines[at])["t_s"], "kind": "operator", "command": "hold", "sysid": 1}
    order |= {"taken": True, "text": ""}
    lines.insert(at, json.dumps(order, sort_keys=True, separators=(",", ":")))
    (folder / "decisions.jsonl").write_text("\n".join(lines) + "\n")
    verdict = redecide(folder)
    assert verdict.differences[0].t_s >= order["t_s"]
    assert verdict.differences[0].t_s < order["t_s"] + 1.0
    assert (verdict.differences[0].kind, verdict.differences[0].today) == ("set_point", None)
    assert verdict.differences[0].recorded["sysid"] == 1


def test_a_session_that_was_killed_is_compared_up_to_there(session: Outcome, tmp_path: Path) -> None:
    folder = tmp_path / "killed"
    folder.mkdir()
    (folder / "scenario.yaml").symlink_to(session.folder / "scenario.yaml")
    for name, share in (("session.tlog", 0.5), ("decisions.jsonl", 0.45)):
        whole = (session.folder / name).read_bytes()
        (folder / name).write_bytes(whole[: int(share * len(whole))])
    verdict = redecide(folder)
    assert verdict.agrees
    assert 8.0 < verdict.until_s < 17.0
    assert any("did not end" in problem for problem in verdict.problems)


def test_decisions_that_end_inside_a_line_are_compared_up_to_there(session: Outcome, tmp_path: Path) -> None:
    folder = copy(session, tmp_path / "cut")
    content = (folder / "decisions.jsonl").read_bytes()
    half = content[: content.index(b"\n", len(content) // 2) + 20]
    (folder / "decisions.jsonl").write_bytes(half)
    verdict = redecide(folder)
    assert verdict.agrees
    assert 0 < verdict.compared <= half.count(b"\n")
    assert verdict.problems == [f"{folder / 'decisions.jsonl'} ends inside a line, and was compared up to there."]


def test_where_nothing_was_decided_nothing_agrees(session: Outcome, tmp_path: Path) -> None:
    folder = copy(session, tmp_path / "killed")
    (folder / "decisions.jsonl").write_text("")
    again = gcs("replay", str(folder), "--decide")
    assert again.returncode == 2
    assert "holds no decision to compare" in again.stderr


def test_a_log_of_another_scenario_is_not_decided(session: Outcome, tmp_path: Path) -> None:
    folder = copy(session, tmp_path / "other")
    text = (folder / "scenario.yaml").read_text()
    (folder / "scenario.yaml").write_text(re.sub(r"period_s: [\d.]+", "period_s: 0.2", text))
    with pytest.raises(RedecideError, match="not the recording of this scenario"):
        redecide(folder)


def test_only_a_whole_folder_is_decided_again(session: Outcome, tmp_path: Path) -> None:
    for missing in ("session.tlog", "decisions.jsonl", "scenario.yaml"):
        folder = copy(session, tmp_path / missing)
        (folder / missing).unlink()
        with pytest.raises(RedecideError, match=f"has no {missing}"):
            redecide(folder)
    folder = copy(session, tmp_path / "rotated")
    (folder / "session.0002.tlog").symlink_to(session.folder / "session.tlog")
    with pytest.raises(RedecideError, match="lacks its first parts"):
        redecide(folder)


def test_a_session_that_nobody_has_joined_at_first_is_decided_from_its_beginning(tmp_path: Path) -> None:
    content = small(goal={"duration_s": 6.0, "refuelled_at_least": 0})
    for group in content["vehicles"].values():
        group[0]["join_s"] = 3.0
    late = fly(content, tmp_path, "--plain")
    assert min(t_s for t_s, _ in late.messages()) > 2.0
    verdict = redecide(late.folder)
    assert verdict.agrees
    assert verdict.compared == len(made(late)) > 0


def test_a_session_over_a_bad_radio_is_decided_the_same(tmp_path: Path) -> None:
    """It ends in a transfer, which is stopped in time for its radio's sake; recorded frames come clear all the same."""
    goal = {"duration_s": 22.0, "pursue": {"within_m": 3.0, "for_s": 1.0}}
    content = merged(two_refuellings(), {"radio": {"loss": 0.2, "delay_s": 0.1}, "goal": goal})
    flown = fly(content, tmp_path, "--plain")
    verdict = redecide(flown.folder)
    assert verdict.agrees, [difference.sentence for difference in verdict.differences[:3]]


def test_a_session_goes_on_after_all_that_flew_have_died(tmp_path: Path) -> None:
    content = small(goal={"duration_s": 12.0, "refuelled_at_least": 0, "lost_at_most": 2})
    content["faults"] = [{"fault": fault, "sysid": sysid, "at_s": 3.0} for fault, sysid in (("kill", 1), ("hang", 101))]
    content["vehicles"]["tankers"][0]["join_s"] = 8.0
    flown = fly(content, tmp_path, "--plain")
    verdict = redecide(flown.folder)
    assert verdict.agrees
    assert verdict.compared == len(made(flown))
    assert verdict.until_s == pytest.approx(11.9)


def test_a_log_alone_holds_no_decisions(session: Outcome) -> None:
    refused = gcs("replay", str(session.folder / "session.tlog"), "--decide")
    assert refused.returncode == 2
    assert "no session's folder" in refused.stderr


@pytest.mark.parametrize(
    ("ends", "said"), [([7], "1 line is no decision and was"), ([7, 8], "2 lines are no decision")]
)
def test_lines_that_are_no_decisions_are_counted_in_words(
    session: Outcome, tmp_path: Path, ends: list[int], said: str
) -> None:
    folder = copy(session, tmp_path / "broken")
    lines = (folder / "decisions.jsonl").read_text().splitlines()
    for line in ends:
        lines[line] = lines[line][:9]
    (folder / "decisions.jsonl").write_text("\n".join(lines) + "\n")
    assert said in redecide(folder).problems[0]
