"""The picture is JSON with no number that is none, at every moment of a session, and says what the snapshot says."""

import json
from typing import Any

import msgspec
import numpy as np
import pytest

from gcs.session.arrays import Snapshot, from_message
from gcs.session.messages import snapshot_message
from gcs.session.program.fleet_message import fleet_message
from gcs.session.program.messages import FleetMessage
from gcs.telemetry.events import Event

HOLD, LAND = 4 << 16 | 3 << 24, 4 << 16 | 6 << 24
"""PX4's custom modes"""
REPORTED = ("p_ned", "v_ned", "speed_m_s", "height_m", "heading_rad", "roll_rad", "pitch_rad", "battery", "remaining_j",
            "power_w", "endurance_s", "age_s", "heard_s", "autopilot")  # fmt: skip
"""Keys that only messages of a vehicle can fill."""


def shown(session: Any, **changed: Any) -> dict[str, Any]:
    how: dict[str, Any] = {"phase": "flying", "speed": 5.0, "refuelled": 0, "events": []}
    content: dict[str, Any] = json.loads(
        json.dumps(snapshot_message(session.supervisor, **(how | changed)), allow_nan=False)
    )
    return content


def test_before_anything_is_known_it_says_so(scripted: Any) -> None:
    content = shown(scripted())
    assert [vehicle["sysid"] for vehicle in content["vehicles"]] == [1, 101, 201]
    first = content["vehicles"][0]
    assert (first["p_ned"], first["height_m"], first["target_m"], first["endurance_s"]) == (None, None, None, None)
    assert (first["stage"], first["note"], first["trouble"]) == ("identify", "", ["no telemetry yet"])
    assert {first[key] for key in REPORTED} == {None}


def test_arrays_have_nan_before_anything_is_known_and_for_the_endurance_of_the_dead(scripted: Any) -> None:
    session = scripted()

    def seen() -> Snapshot:
        line = msgspec.json.encode(fleet_message(session.supervisor, []))
        return from_message(msgspec.json.decode(line, type=FleetMessage))

    at_first = seen()
    assert np.isnan([*at_first.v_ned[0], *at_first.attitude_rad[0], at_first.endurance_s[0]]).all()
    assert np.isnan([at_first.battery[0], at_first.remaining_j[0]]).all()
    flown_on(session)
    in_flight = seen()
    assert np.isfinite([*in_flight.v_ned[0], *in_flight.attitude_rad[0], in_flight.endurance_s[0]]).all()
    session.supervisor.fleet.lost(1)
    session.fly(1)
    assert np.isnan(seen().endurance_s).tolist()[0]


def test_a_dead_vehicle_has_no_power_and_no_endurance_and_else_what_it_reported_last(scripted: Any) -> None:
    session = scripted()
    flown_on(session)
    before = shown(session)["vehicles"][0]
    assert before["power_w"] > 0.0
    assert before["endurance_s"] > 0.0
    session.link.leave((1, 1))
    session.supervisor.fleet.lost(1)
    session.fly(1)
    dead = shown(session)["vehicles"][0]
    assert (dead["alive"], dead["power_w"], dead["endurance_s"]) == (False, None, None)
    last = ("p_ned", "heading_rad", "remaining_j", "energy_source", "mode", "armed", "landed")
    assert [dead[key] for key in last] == [before[key] for key in last]


def flown_on(session: Any) -> None:
    """Two reports of its battery, between which it has drawn energy, and its attitude."""
    pursuer = session.link.vehicles[1, 1]
    angles = {"time_boot_ms": 0, "roll": 0.1, "pitch": 0.1, "yaw": 0.5}
    pursuer.more = [("ATTITUDE", angles | {"rollspeed": 0.0, "pitchspeed": 0.0, "yawspeed": 0.0})]
    for energy_hj in (10, 20):
        pursuer.energy_hj = energy_hj
        session.fly(10)


def test_in_flight_it_shows_place_distance_battery_and_goal(scripted: Any) -> None:
    session = scripted()
    session.link.vehicles[1, 1].energy_hj = 50
    session.fly(1)
    content = shown(session)
    first = content["vehicles"][0]
    assert first["p_ned"] == pytest.approx([3.0, 0.0, -4.0], abs=1e-3)
    assert (first["height_m"], first["target_m"]) == pytest.approx((4.0, 3.0), abs=1e-3)
    assert (first["mode"], first["armed"], first["stage"]) == ("offboard", True, "fly")
    assert (first["autopilot"], first["landed"], first["state"], first["severity"]) == ("px4", False, "idle", 0)
    assert (first["age_s"], first["heard_s"], first["lost"], first["lost_share"]) == (0.0, 0.0, 0, 0.0)
    assert (first["aim_ned"], first["energy_source"]) == (pytest.approx([3.0, 0.0, -4.0], abs=0.2), "energy_consumed")
    # 50 hJ of 20 kJ
    assert (first["battery"], first["remaining_j"]) == (0.75, 15_000.0)
    assert content["goal"] == {
        "pursue_within_m": 3.5, "pursue_for_s": 1.0, "pursue_held_s": 0.0, "refuelled_at_least": 1,
        "separation_m": 0.6, "clearance_m": None, "traffic_m": None, "broken": []}  # fmt: skip
    assert (content["t_s"], content["duration_s"]) == (0.0, 60.0)


def test_what_is_lost_is_trouble_whatever_was_ordered_before(scripted: Any) -> None:
    session = scripted()
    session.fly(3)
    vehicle = session.link.vehicles[1, 1]
    session.supervisor.obey({"command": "hold", "sysid": 1})
    vehicle.custom_mode = HOLD
    session.fly(2)
    assert shown(session)["vehicles"][0]["trouble"] == []
    vehicle.custom_mode = LAND
    session.fly(2)
    falls = shown(session)["vehicles"][0]
    assert (falls["condition"], falls["trouble"]) == ("failing", ["Land"])
    for order in ("", "hold", "land"):
        if order:
            session.supervisor.obey({"command": order, "sysid": 1})
            vehicle.custom_mode = HOLD
        vehicle.more = [("EXTENDED_SYS_STATE", {"vtol_state": 0, "landed_state": 1})]
        session.fly(1)
        lies = shown(session)["vehicles"][0]
        assert (lies["condition"], lies["trouble"]) == ("failing", ["not flying"] if order else ["Land"])


def test_a_hold_is_trouble_unless_it_was_ordered_or_another_station_flies_it(scripted: Any) -> None:
    session = scripted()
    session.fly(3)
    session.link.vehicles[1, 1].custom_mode = HOLD
    for order, wrong in (("", ["Hold without an order"]), ("hold", []), ("release", [])):
        if order:
            session.supervisor.obey({"command": order, "sysid": 1})
        session.fly(1)
        assert shown(session)["vehicles"][0]["trouble"] == wrong


def test_a_service_is_noted_on_both_sides(scripted: Any) -> None:
    session = scripted(competition={"need_from": 0.1, "bids": "need"})
    session.link.vehicles[1, 1].energy_hj = 80
    session.fly(1)
    competing = shown(session)["vehicles"][0]
    assert (competing["v"], competing["tau"]) == (0.01, 1.0)
    session.fly(40)
    content = shown(session)
    notes = {vehicle["sysid"]: vehicle["note"] for vehicle in content["vehicles"]}
    phase = content["services"][0]["phase"]
    assert notes == {1: f"served by 201: {phase}", 101: "", 201: f"serves 1: {phase}"}
    service = content["services"][0]
    assert (service["receiver"], service["by"], service["bids"]) == (1, "competition", {"1": 1.0})
    assert service["why"].startswith("Pursuer 1 is refuelled next: its need 0.40 is the largest")
    assert {vehicle["sysid"]: vehicle["state"] for vehicle in content["vehicles"]}[201] == "serves"


def test_events_phase_speed_and_services_are_passed_on(scripted: Any) -> None:
    content = shown(scripted(), phase="paused", refuelled=3, events=[Event(1.5, 7, "warning", "So", "link")])
    assert content["events"] == [{"t_s": 1.5, "sysid": 7, "level": "warning", "text": "So", "kind": "link"}]
    assert (content["phase"], content["speed"], content["refuelled"]) == ("paused", 5.0, 3)
