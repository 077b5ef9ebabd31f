"""What a tick leaves behind: told to people the same live and from the recording."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from pymavlink import mavutil

from gcs.mavlink import codec
from gcs.recording.decision_lines import decision_lines
from gcs.recording.digest import Digest
from gcs.recording.recorder import Recorder
from gcs.recording.tick_record import TickRecord, event_of, records_of_tick
from gcs.refuelling.bidding import CompetitionState
from gcs.refuelling.service import Decision
from gcs.scenario.guard import PluginFault
from gcs.telemetry.battery_account import Fact

BEAT = {"type": 2, "autopilot": 12, "base_mode": 0, "custom_mode": 0, "system_status": 3}
SERVED = {
    "kind": "served", "receiver": 2, "tanker": 201, "reason": "limit", "energy_j": 5.0, "joined_at_s": 1.0,
    "start_s": 2.0, "end_s": 3.0,
}  # fmt: skip


def test_what_is_told_of_a_tick_is_what_its_lines_tell_afterwards() -> None:
    nobody = CompetitionState({}, {}, {}, None, 0.0)
    records, events = records_of_tick(
        12.5,
        Decision(records=(SERVED,)),
        (),
        pursued=[{"kind": "pursuit", "pursuer": 1, "target": 101}],
        facts=[(3, Fact("A battery was swapped", 1000.0))],
        problems=[PluginFault(4, "planner a:B", "returned NaN")],
        competition_states=(nobody, nobody),
    )
    assert [event.text for event in events] == [
        "Refuelling of 2 by 201 ended: limit, 5 J",
        "Pursues 101 from now on",
        "A battery was swapped",
        "planner a:B returned NaN; the vehicle is held",
    ]
    assert [(event.t_s, event.sysid) for event in events] == [(12.5, 2), (12.5, 1), (12.5, 3), (12.5, 4)]
    lines = decision_lines(records)
    assert [event_of(json.loads(line)) for line in lines] == events


@pytest.mark.parametrize(
    ("record", "level", "text"),
    [
        ({"kind": "death", "sysid": 3, "text": "Killed"}, "critical", "Killed"),
        ({"kind": "boot", "sysid": 3, "text": "It has booted"}, "warning", "It has booted"),
        ({"kind": "operator", "sysid": 3, "taken": True, "text": "Holds"}, "info", "Operator: Holds"),
        (
            {"kind": "operator", "sysid": 3, "command": "hold", "taken": False, "text": "No"},
            "warning",
            "Operator: hold refused: No",
        ),
        ({"kind": "of a later version", "sysid": 3}, "info", "of a later version"),
    ],
)
def test_what_comes_from_outside_a_tick_is_told_too(record: dict[str, Any], level: str, text: str) -> None:
    event = event_of({"t_s": 1.0, **record})
    assert (event.t_s, event.sysid, event.level, event.text) == (1.0, 3, level, text)


def test_what_came_late_in_a_tick_is_recorded_at_its_own_time(tmp_path: Path) -> None:
    frames = [codec.encode("HEARTBEAT", 0, sysid, 1, **BEAT) for sysid in (1, 3, 255)]
    with Recorder(tmp_path) as recorder:
        TickRecord(1500, frames[:1], frames[2:], [], frames[1:2], 600).write(recorder, Digest(), 10**15)
    log = mavutil.mavlogfile(str(tmp_path / "session.tlog"))
    read = [(message.get_srcSystem(), round(message._timestamp - 1e9, 3)) for message in iter(log.recv_msg, None)]
    log.close()
    assert read == [(1, 1.5), (255, 1.5), (3, 2.1)]
