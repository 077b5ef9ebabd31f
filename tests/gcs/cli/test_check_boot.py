"""`gcs check` of a vehicle that still boots: the wait until it is ready, and what is counted from then on."""

from __future__ import annotations

from typing import Any, cast

import pytest
from pymavlink.dialects.v20 import common as mav
from scripted_vehicle import Scripted, examine

from gcs.cli.check.dialogue import CheckFinding, Dialogue, Outcome
from gcs.cli.check.questions import questions
from gcs.cli.check.readiness import hint


@pytest.mark.parametrize(("from_s", "outcome"), [(4.0, "ok"), (1e9, "missing")])
def test_a_vehicle_that_has_just_started_is_waited_for_and_its_reasons_are_told(from_s: float, outcome: str) -> None:
    bit = mav.MAV_SYS_STATUS_PREARM_CHECK
    unready, ready = (mav.MAVLink_sys_status_message(b, b, b, 0, 0, -1, -1, 0, 0, 0, 0, 0, 0) for b in (0, bit))
    vehicle = booting(Scripted(), healthy_s=0.0, place_s=0.0)
    vehicle.streams[1] = (0.5, lambda ms: ready if ms >= 1e3 * from_s else unready)
    vehicle.streams.append((0.5, lambda _: mav.MAVLink_statustext_message(2, b"PreArm: GPS: no fix")))
    finding = examine(vehicle, "ready", ready_within_s=10.0)["ready"]
    assert finding.outcome == outcome
    assert finding.text == ("" if outcome == "ok" else "not ready yet: PreArm: GPS: no fix")


def place(ms: int) -> Any:
    return mav.MAVLink_local_position_ned_message(ms, 0, 0, 0, 0, 0, 0)


def booting(vehicle: Scripted, *, healthy_s: float, place_s: float) -> Scripted:
    """It sends HEARTBEAT alone at first; then its checks pass, and then it sends all else, each once a second."""
    bit = mav.MAV_SYS_STATUS_PREARM_CHECK
    status = mav.MAVLink_sys_status_message(bit, bit, bit, 0, 0, -1, -1, 0, 0, 0, 0, 0, 0)
    attitude = mav.MAVLink_attitude_message(0, 0, 0, 0, 0, 0, 0)
    vehicle.streams += [
        (1.0, lambda ms: status if ms >= 1e3 * healthy_s else vehicle.heartbeat()),
        (1.0, lambda ms: attitude if ms >= 1e3 * place_s else vehicle.heartbeat()),
        (1.0, lambda ms: place(ms) if ms >= 1e3 * place_s else vehicle.heartbeat()),
    ]
    return vehicle


@pytest.mark.parametrize(("healthy_s", "place_s"), [(0.0, 0.0), (17.0, 29.0), (30.0, 12.0)])
def test_rates_of_one_that_was_waited_for_count_from_when_it_was_ready_and_told_its_place(
    healthy_s: float, place_s: float
) -> None:
    streams = ("stream-sys-status", "stream-attitude", "stream-local-position-ned")
    found = examine(booting(Scripted(), healthy_s=healthy_s, place_s=place_s), "ready", *streams, ready_within_s=60.0)
    assert {key: found[key].outcome for key in ("ready", *streams)} == dict.fromkeys(("ready", *streams), "ok")
    assert (found["ready"].after_s or 0.0) == pytest.approx(max(healthy_s, place_s), abs=1.1)


@pytest.mark.parametrize(("from_s", "outcome"), [(10.0, "ok"), (30.2, "wrong")])
def test_a_pause_in_a_boot_that_was_waited_for_is_none_of_its_flight(from_s: float, outcome: str) -> None:
    """An ArduCopter says nothing for some seconds of its boot; one that is ready does not."""
    vehicle = booting(Scripted(), healthy_s=30.0, place_s=30.0)
    attitude = mav.MAVLink_attitude_message(0, 0, 0, 0, 0, 0, 0)
    before = vehicle.streams
    vehicle.streams = [
        (period_s, lambda ms, made=made: attitude if from_s <= 1e-3 * ms < from_s + 3.3 else made(ms))
        for period_s, made in before
    ]
    found = examine(vehicle, "ready", "heartbeat-steady", ready_within_s=60.0)
    assert (found["ready"].outcome, found["heartbeat-steady"].outcome) == ("ok", outcome)


def test_one_that_could_be_armed_but_tells_no_place_is_named_as_that() -> None:
    found = examine(booting(Scripted(), healthy_s=2.0, place_s=1e9), "ready", ready_within_s=10.0)
    assert found["ready"].outcome == "missing"
    assert found["ready"].text == "its pre-arm checks pass, but it does not tell its place (LOCAL_POSITION_NED)"


def asked_too_soon(*, running_s: float, prearm: bool, placed: bool, armed: bool = False, **outcomes: str) -> str:
    """The hint after a check of a vehicle that had run for so long, with these outcomes of its questions."""
    vehicle, dialogue = Scripted(), Dialogue([])
    flags = mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED | (mav.MAV_MODE_FLAG_SAFETY_ARMED if armed else 0)
    bits = mav.MAV_SYS_STATUS_PREARM_CHECK if prearm else 0
    said = [
        vehicle.heartbeat(base_mode=flags),
        mav.MAVLink_attitude_message(round(1e3 * running_s), 0, 0, 0, 0, 0, 0),
        mav.MAVLink_sys_status_message(bits, bits, bits, 0, 0, -1, -1, 0, 0, 0, 0, 0, 0),
        *([place(round(1e3 * running_s) + 9000)] if placed else ()),
    ]
    for message in said:
        dialogue.receive(vehicle.frame(message), 0.0)
    asked = {question.key: question for question in questions()}
    dialogue.findings = [
        CheckFinding(asked[key.replace("_", "-")], cast("Outcome", outcome), "", None)
        for key, outcome in outcomes.items()
    ]
    return hint(dialogue)


def test_one_that_was_asked_too_soon_after_its_start_is_named_with_what_helps() -> None:
    assert asked_too_soon(running_s=5.0, prearm=False, placed=True, health_prearm="wrong") == (
        "not ready yet: vehicle 7 had run for 5 s, and its pre-arm checks did not pass; "
        "with --wait-ready 60 the check waits for that first"
    )
    meanwhile_ready = asked_too_soon(running_s=5.0, prearm=True, placed=True, health_prearm="wrong")
    assert "pre-arm checks" in meanwhile_ready
    for placed in (False, True):
        missed = asked_too_soon(running_s=5.0, prearm=True, placed=placed, stream_local_position_ned="missing")
        assert "it did not tell its place (LOCAL_POSITION_NED)" in missed


@pytest.mark.parametrize(
    "told",
    [
        {"running_s": 5.0, "prearm": True, "placed": True, "ping": "missing"},
        {"running_s": 500.0, "prearm": False, "placed": False, "health_prearm": "wrong"},
        {"running_s": 5.0, "prearm": False, "placed": True, "armed": True, "health_prearm": "wrong"},
        {"running_s": 5.0, "prearm": True, "placed": False, "ping": "ok"},
    ],
    ids=["ready", "runs for long", "armed", "passes"],
)
def test_any_other_is_not_advised_to_wait(told: dict[str, Any]) -> None:
    assert asked_too_soon(**told) == ""
