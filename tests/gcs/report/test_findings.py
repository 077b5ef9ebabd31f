"""What a report says went wrong, and of what came of the goal; from decisions and summaries written by hand."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gcs.recording.session_folder import Recorded
from gcs.recording.summary import Summary
from gcs.report import page
from gcs.report.findings import Findings, few
from gcs.report.page import text
from gcs.scenario.model import Scenario


def summary(**changed: Any) -> Summary:
    energy = {"initial_j": 100.0, "drawn_j": 60.0, "received_j": 0.0, "given_j": 0.0, "remaining_j": 40.0}
    vehicle = {
        "role": "pursuer", "final_mode": "offboard", "max_tracking_error_m": 0.1, "path_length_m": 3.0,
        "control_effort": 1.0, "energy": {**energy, "lost_j": 0.0, "source": "energy_consumed"},
    }  # fmt: skip
    content: dict[str, Any] = {
        "schema": 1, "scenario": "hand", "seed": 3, "clock": "real", "speed": 2.0, "sim_time_s": 60.0,
        "wall_time_s": 30.0, "speed_achieved": 2.0, "lag_s": 0.0, "completed": True, "outcome": "met",
        "digest": "sha256:00", "versions": {"python": "3"}, "min_separation_m": None, "min_clearance_m": None,
        "vehicles": [{"sysid": 1, **vehicle}, {"sysid": 2, **vehicle}], "refuelling": [], "refuel_order": [],
        "link": {"received": 9, "sent": 9, "lost": 0, "malformed": 0, "overflowed": 0, "command_retries": 0},
    }  # fmt: skip
    return Summary.model_validate(content | changed)


def scenario() -> Scenario:
    battery = {"capacity_j": 20_000.0}
    return Scenario.model_validate({
        "schema": 1, "name": "hand", "axes": "ned", "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 400.0},
        "goal": {"duration_s": 60.0, "refuelled_at_least": 1},
        "vehicles": {"pursuers": [{"sysid": 1, "start_m": (0.0, 0.0, 0.0), "battery": battery},
                                  {"sysid": 2, "start_m": (9.0, 0.0, 0.0), "battery": battery}],
                     "tankers": [{"sysid": 201, "start_m": (-9.0, 0.0, 0.0), "battery": battery}]},
    })  # fmt: skip


def said(severity: int, *texts: tuple[float, int, str]) -> dict[str, Any]:
    dtype = [("t_s", "f8"), ("sysid", "u1"), ("compid", "u1"), ("severity", "u1"), ("text", "S50"), ("id", "u2"),
             ("chunk_seq", "u1")]  # fmt: skip
    rows = [(t_s, sysid, 1, severity, text.encode(), 0, 0) for t_s, sysid, text in texts]
    table = np.array(rows, dtype=dtype)
    empty = np.empty(0, dtype=dtype)
    names = ("LOCAL_POSITION_NED", "ATTITUDE", "HEARTBEAT", "EXTENDED_SYS_STATE", "GPS_GLOBAL_ORIGIN",
             "BATTERY_STATUS", "NAMED_VALUE_INT", "PARAM_VALUE")  # fmt: skip
    return {**dict.fromkeys(names, empty), "STATUSTEXT": table}


def found(**parts: Any) -> Findings:
    return Findings(Recorded(Path("hand"), **{"scenario": scenario(), "summary": summary(), "end_s": 60.0} | parts))


def sentences(findings: Findings) -> list[tuple[str, str]]:
    return [(problem.level, problem.text) for problem in findings.problems]


def test_what_was_not_reached_comes_first_and_counts_come_last() -> None:
    link = {"received": 9, "sent": 9, "lost": 4, "malformed": 0, "overflowed": 0, "command_retries": 2}
    findings = found(
        summary=summary(outcome="refuelled", outcome_text="not met: refuelled 0 of 1", link=link, lag_s=3.25)
    )
    assert sentences(findings) == [
        ("bad", "Not reached: at least 1 refuelled (0 of 1)."),
        ("warn", "4 frames were lost."),
        ("warn", "The session fell 3.2 s behind its pace: the machine was busy."),
        ("note", "2 commands had to be sent again."),
    ]
    assert findings.outcome == "The goal was not met: refuelled 0 of 1"
    told = {part.wanted: part.met for part in findings.parts}
    assert told["60 s are flown"] is True
    assert told["at least 1 refuelled"] is False


def test_a_vehicle_that_did_not_send_what_it_was_asked_for_is_named() -> None:
    one, two = summary().model_dump()["vehicles"]
    one["missing_streams"] = ["ATTITUDE", "SYS_STATUS"]
    text = "Vehicle 1 did not send ATTITUDE and SYS_STATUS as often as it was asked to."
    assert ("warn", text) in sentences(found(summary=summary(vehicles=[one, two])))
    assert not [said for _, said in sentences(found()) if "asked to" in said]


def test_alike_words_of_many_are_said_once() -> None:
    texts = [(float(k), k, "Failsafe: battery empty, land") for k in range(1, 13)]
    (problem,) = [p for p in sentences(found(tables=said(2, *texts))) if "Failsafe" in p[1]]
    words = (
        "“Failsafe: battery empty, land” said by 12 vehicles: 1, 2, 3, 4, 5, 6 and 6 more (12 times, first at 1.0 s)."
    )
    assert problem == ("bad", words)


def test_services_that_moved_nothing_and_broke_off_are_told() -> None:
    pair = {"receiver": 2, "tanker": 201}
    steps = {"decided_at_s": 5.0, "joined_at_s": None, "start_s": None, "end_s": 9.0}
    decisions = [
        {"t_s": 7.0, "kind": "broken off", **pair},
        {
            "t_s": 9.0,
            "kind": "served",
            **pair,
            **steps,
            "by": "urgency",
            "energy_j": 0,
            "bids": {},
            "reason": "too far",
        },
        {"t_s": 9.5, "kind": "death", "sysid": 2, "text": "vehicle 2 has died"},
    ]
    told = sentences(found(decisions=decisions))
    assert ("bad", "vehicle 2 has died (9.5 s)") in told
    assert ("warn", "Refuelling of 2 was interrupted (at 7.0 s).") in told
    assert ("warn", "Refuelling of 2 by tanker 201 moved no energy: too far (decided at 5.0 s).") in told


def test_a_service_that_the_end_cut_is_no_refuelling_of_the_page(tmp_path: Path) -> None:
    steps = {"tanker": 201, "by": "unopposed", "decided_at_s": 5.0, "joined_at_s": 8.0, "start_s": 8.0, "bids": {}}
    cut = {"receiver": 2, "end_s": None, "energy_j": 2200.0, **steps}
    ended = {"t_s": 9.0, "kind": "served", "receiver": 1, "end_s": 9.0, "energy_j": 800, "reason": "full", **steps}
    (tmp_path / "scenario.yaml").touch()
    shown = text(
        Findings(
            replace(
                found(decisions=[ended], summary=summary(refuelling=[cut], refuel_order=[1])).recorded, folder=tmp_path
            )
        )
    )
    assert "<dt>refuellings</dt><dd>1<small>3.0 kJ moved, 1 not ended</small></dd>" in shown


def test_a_service_that_vehicles_decided_before_the_session_knew_is_one() -> None:
    """They compete on board: the lines of 2 differ in when it was decided, and that of 1 has not ended."""
    pair, by = {"receiver": 2, "tanker": 201}, {"by": "unopposed", "bids": {}}
    steps = {"decided_at_s": 3.4, "joined_at_s": 8.5, "start_s": 8.5, "end_s": 16.0, "energy_j": 700}
    decisions = [
        {"t_s": 3.5, "kind": "decided", **pair, **by},
        {"t_s": 16.0, "kind": "served", "reason": "served", **pair, **by, **steps},
        {"t_s": 16.2, "kind": "decided", **pair, **by, "receiver": 1},
    ]
    services = found(decisions=decisions, summary=None).services
    assert [(s.receiver, s.decided_at_s, s.end_s, s.energy_j) for s in services] == [
        (2, 3.4, 16.0, 700),
        (1, 16.2, None, 0.0),
    ]


def test_code_that_a_scenario_names_stands_where_the_flight_is_to_be_reproduced(tmp_path: Path) -> None:
    (tmp_path / "scenario.yaml").touch()
    flown = scenario()
    named = flown.model_copy(
        update={
            "planner": flown.planner.model_copy(update={"method": "mine:Ring"}),
            "competition": flown.competition.model_copy(update={"policy": "mine:InTurn"}),
        }
    )
    with_code, without = (
        page.text(Findings(Recorded(tmp_path, scenario=one, summary=summary(), end_s=60.0))) for one in (named, flown)
    )
    assert "The scenario names code, planner mine:Ring and policy mine:InTurn, which is not in" in with_code
    assert "names code" not in without


def test_an_operators_orders_stand_where_the_flight_is_to_be_reproduced(tmp_path: Path) -> None:
    (tmp_path / "scenario.yaml").write_text("schema: 1 # <script>", encoding="utf-8")
    order = {"t_s": 4.0, "kind": "operator", "command": "hold", "sysid": 1, "taken": True, "text": "1 <holds>"}
    findings = Findings(Recorded(tmp_path, scenario=scenario(), summary=summary(), decisions=[order], end_s=60.0))
    text = page.text(findings)
    _, _, again = text.partition('id="again"')
    assert "An operator took part" in again
    assert "1 &lt;holds&gt;" in again
    assert "# &lt;script&gt;" in again


@pytest.mark.parametrize(
    ("sysids", "words"),
    [([3], "3"), ([1, 2], "1, 2"), (list(range(1, 9)), "1, 2, 3, 4, 5, 6, 7, 8"),
     (list(range(1, 10)), "1, 2, 3, 4, 5, 6 and 3 more")],
)  # fmt: skip
def test_few_are_named_and_of_many_the_first(sysids: list[int], words: str) -> None:
    assert few(sysids) == words
