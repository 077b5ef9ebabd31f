"""summary.json: the contract's fields, and figures that a scripted session makes known."""

import json
from typing import Any

import pytest

from gcs.recording.summary import FILE, Summary
from gcs.supervisor.summarise import summarise

FIELDS = [
    "schema", "scenario", "seed", "clock", "speed", "sim_time_s", "wall_time_s", "speed_achieved", "lag_s",
    "completed", "outcome", "outcome_text", "goal", "unmet", "judged_by", "digest", "versions", "min_separation_m",
    "min_clearance_m", "min_traffic_m", "closest", "believed_min_separation_m", "believed_min_clearance_m",
    "believed_min_traffic_m", "vehicles", "refuelling", "refuel_order", "tanker_idle_s", "link", "faults", "bases",
]  # fmt: skip


def summary(session: Any, wall_time_s: float = 0.5) -> Summary:
    return summarise(
        session.supervisor, session.link, outcome="met", completed=True, wall_time_s=wall_time_s, lag_s=0.25
    )


def test_the_file_has_the_contracts_fields_in_order(scripted: Any) -> None:
    session = scripted()
    session.fly(30)
    summary(session).write(session.folder)
    content = json.loads((session.folder / FILE).read_text())
    assert list(content) == FIELDS
    assert [vehicle["sysid"] for vehicle in content["vehicles"]] == [1, 101, 201]
    assert list(content["vehicles"][0]) == [
        "sysid", "role", "final_mode", "final_mode_name", "max_tracking_error_m", "path_length_m", "control_effort",
        "energy", "missing_streams", "check_list", "refused_messages", "mission", "links",
    ]  # fmt: skip
    assert all(vehicle["missing_streams"] == [] for vehicle in content["vehicles"])
    assert (content["schema"], content["scenario"], content["clock"]) == (1, "scripted", "lockstep")
    assert (content["sim_time_s"], content["speed_achieved"], content["lag_s"]) == (3.0, 6.0, 0.25)
    assert content["digest"].startswith("sha256:")
    assert content["min_clearance_m"] is None  # there is nothing to hit


def test_a_session_that_never_began_is_summarised(scripted: Any) -> None:
    made = summary(scripted(), wall_time_s=0.0)
    assert (made.speed_achieved, made.min_separation_m, made.refuelling) == (0.0, None, [])
    assert made.vehicles[0].max_tracking_error_m is None


def test_every_vehicles_ledger_closes_and_lost_joules_are_the_givers(scripted: Any) -> None:
    session = scripted()
    for sysid, name, value in ((201, "XferOut", 900), (1, "XferIn", 640)):
        session.link.vehicles[sysid, 1].more = [("NAMED_VALUE_INT", {"name": name, "value": value, "time_boot_ms": 0})]
    session.link.vehicles[1, 1].energy_hj = 12
    session.link.vehicles[1, 1].more.append(
        ("NAMED_VALUE_FLOAT", {"name": "CtlEffort", "value": float("nan"), "time_boot_ms": 0})
    )
    session.fly(5)
    energies = {vehicle.sysid: vehicle.energy for vehicle in summary(session).vehicles}
    for energy in energies.values():
        assert energy.initial_j + energy.received_j == energy.drawn_j + energy.given_j + energy.remaining_j
    assert (energies[1].received_j, energies[1].drawn_j, energies[1].source) == (640, 1200, "energy_consumed")
    assert (energies[201].given_j, energies[201].lost_j) == (900, 900)  # no service of this session booked them


def test_the_dead_are_named_so_and_frames_are_counted(scripted: Any) -> None:
    session = scripted()
    session.fly(5)
    session.supervisor.lose((1, 1), "gone")
    made = summary(session)
    assert [vehicle.final_mode for vehicle in made.vehicles] == ["dead", "offboard", "offboard"]
    assert made.link.sent == sum(len(frames) for _, _, frames in session.link.bundles)
    assert made.link.received == sum(map(len, session.link.answered))
    assert (made.link.lost, made.link.malformed, made.link.command_retries) == (0, 0, 0)


def test_least_separation_is_that_of_the_scripted_places(scripted: Any) -> None:
    session = scripted(start_m=(2.5, 0.0, -4.0))
    session.fly(1)
    assert summary(session).min_separation_m == pytest.approx(2.5, abs=1e-3)


def test_where_it_cannot_be_written_it_is_named_and_nothing_is_left(scripted: Any) -> None:
    session = scripted()
    session.fly(1)
    (session.folder / FILE).mkdir()
    with pytest.raises(IsADirectoryError) as refused:
        summary(session).write(session.folder)
    assert refused.value.filename == str(session.folder / FILE)
    assert not list(session.folder.glob(f".{FILE}*"))
