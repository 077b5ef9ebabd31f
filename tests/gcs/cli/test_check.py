"""`gcs check` without a wire: what is asked, and how answers, silence and nonsense are judged. Frames by pymavlink."""

from __future__ import annotations

from typing import Any, NamedTuple

import pytest
from pymavlink.dialects.v20 import common as mav
from scripted_vehicle import PX4_LOITER, Scripted, examine, obeying

from gcs.cli.check.dialogue import Dialogue
from gcs.cli.check.questions import questions
from gcs.cli.check.report import as_json, line, passed

ECHO = mav.MAVLink_ping_message(1, 4711, 255, 190)


@pytest.mark.parametrize(
    ("answers", "outcome", "asked"),
    [
        ([], "missing", 3),
        ([None, ECHO], "late", 2),
        ([mav.MAVLink_ping_message(1, 4711, 3, 1)] * 3, "missing", 3),  # to another
    ],
)
def test_an_echo_is_late_at_the_second_asking_and_missing_after_three(
    answers: list[Any], outcome: str, asked: int
) -> None:
    vehicle, left = Scripted(), iter(answers)
    vehicle.answers["PING"] = lambda _: [echo] if (echo := next(left, None)) else []
    finding = examine(vehicle, "ping")["ping"]
    assert (finding.outcome, passed([finding])) == (outcome, outcome == "late")
    assert [type(m).__name__ for m in vehicle.asked].count("PING") == asked
    assert outcome == "late" or "MAVSDK" in line(finding)
    assert outcome != "late" or 0.5 < (finding.after_s or 0.0) < 0.6


@pytest.mark.parametrize(
    ("result", "outcomes"),
    [
        (
            mav.MAV_RESULT_ACCEPTED,
            {"home-position": "wrong", "available-modes": "wrong", "other-target": "wrong", "unknown-command": "wrong"},
        ),
        (
            mav.MAV_RESULT_UNSUPPORTED,
            {"home-position": "wrong", "available-modes": "ok", "unknown-command": "ok"},
        ),
    ],
)
def test_what_is_accepted_is_to_be_met_and_what_is_optional_may_be_refused(
    result: int, outcomes: dict[str, str]
) -> None:
    """Commands that it does not know, or that are to others, are to be refused."""
    vehicle = obeying(result=result)
    found = examine(vehicle, *outcomes)
    assert {key: found[key].outcome for key in outcomes} == outcomes
    assert ("HOME_POSITION never came" in found["home-position"].text) == (result == mav.MAV_RESULT_ACCEPTED)
    targets = {m.target_system for m in vehicle.asked if type(m).__name__ == "COMMAND_LONG"}
    assert targets == ({7, 8} if "other-target" in outcomes else {7})


LONG = "PreArm: battery 1 below minimum arming voltage, and compasses are inconsistent"


@pytest.mark.parametrize(
    ("chunks", "text"),
    [
        (
            [(b"Arm: Need Alt Estimate", 0, 0), (b"Arm: EKF attitude is bad", 0, 0)],
            "Arm: Need Alt Estimate; Arm: EKF attitude is bad",
        ),
        ([(LONG.encode()[50 * seq : 50 * seq + 50], 9, seq) for seq in range(2)], LONG),
    ],
)
def test_the_reasons_of_a_refusal_may_follow_its_acknowledgement_and_come_in_chunks(
    chunks: list[tuple[bytes, int, int]], text: str
) -> None:
    """As ArduPilot's do: the refusal first, and then a text now and then."""
    vehicle = Scripted()
    left: list[tuple[bytes, int, int]] = []

    def refuse(asked: Any) -> list[Any]:
        left[:] = chunks
        return [vehicle.ack(asked.command, mav.MAV_RESULT_FAILED)]

    vehicle.answers["COMMAND_LONG"] = refuse
    vehicle.streams.append(
        (0.1, lambda _: mav.MAVLink_statustext_message(2, *left.pop(0)) if left else vehicle.heartbeat())
    )
    finding = examine(vehicle, "arm", arm=True)["arm"]
    assert (finding.outcome, finding.text) == ("wrong", f"refused: FAILED, {text}")


def test_streams_are_counted_over_the_time_that_was_listened() -> None:
    vehicle = Scripted()
    vehicle.streams += [
        (0.1, lambda ms: mav.MAVLink_attitude_message(ms, 0, 0, 0, 0, 0, 0)),
        (2.5, lambda ms: mav.MAVLink_local_position_ned_message(ms, 0, 0, 0, 0, 0, 0)),
    ]
    found = examine(vehicle, "stream-attitude", "stream-local-position-ned", "stream-gps-raw-int")
    outcomes = {key: finding.outcome for key, finding in found.items()}
    assert outcomes["stream-attitude"] == "ok"
    assert outcomes["stream-local-position-ned"] == "late"
    assert outcomes["stream-gps-raw-int"] == "missing"


class Raw(NamedTuple):
    """A frame as it stood on somebody else's wire."""

    frame: bytes

    def pack(self, _: mav.MAVLink) -> bytes:
        return self.frame


def test_a_message_that_our_dialect_lacks_counts_by_its_id() -> None:
    """A PX4 1.17 sends PROTOCOL_VERSION (300), and the acknowledgement after it; this frame is one of its own."""
    own = bytes.fromhex("fd1600006501012c0100c8006400cb000000000000000000198e38627fa149886427")
    vehicle = Scripted(sysid=1)
    vehicle.answers["COMMAND_LONG"] = lambda asked: [Raw(own), vehicle.ack(asked.command)]
    assert examine(vehicle, "protocol-version")["protocol-version"].outcome == "ok"


@pytest.mark.parametrize(("bits", "outcome"), [(0, "late"), (mav.MAV_SYS_STATUS_GEOFENCE, "wrong")])
def test_a_px4_that_says_nothing_of_its_fence_passes_and_one_whose_fence_is_broken_does_not(
    bits: int, outcome: str
) -> None:
    vehicle = Scripted()
    status = mav.MAVLink_sys_status_message(bits, bits, 0, 500, 16000, -100, 80, 0, 0, 0, 0, 0, 0)
    vehicle.streams.append((1.0, lambda _: status))
    assert examine(vehicle, "health-geofence")["health-geofence"].outcome == outcome


def test_ardupilot_is_asked_for_its_streams_and_px4_is_not() -> None:
    for autopilot, mode in ((mav.MAV_AUTOPILOT_PX4, PX4_LOITER), (mav.MAV_AUTOPILOT_ARDUPILOTMEGA, 5)):
        vehicle = Scripted()
        beat = vehicle.heartbeat(autopilot=autopilot, custom_mode=mode)
        vehicle.streams = [(1.0, lambda _, beat=beat: beat)]
        found = examine(vehicle, "mode")
        requests = [m for m in vehicle.asked if type(m).__name__ == "REQUEST_DATA_STREAM"]
        assert len(requests) == (autopilot == mav.MAV_AUTOPILOT_ARDUPILOTMEGA)
        assert found["mode"].outcome == "ok"


def test_a_heartbeat_whose_mode_means_nothing_is_wrong() -> None:
    vehicle = Scripted()
    beat = vehicle.heartbeat(base_mode=0, custom_mode=77)
    vehicle.streams = [(1.0, lambda _: beat)]
    found = examine(vehicle, "mode")
    assert found["heartbeat"].outcome == "wrong"
    assert found["mode"].outcome == "wrong"


def test_a_pause_in_the_heartbeat_and_a_clock_that_goes_back_are_seen_at_the_end() -> None:
    vehicle = Scripted()
    clock = iter((5000, 6000, 900, 7000, 8000, 9000, 10000))
    vehicle.streams = [
        (3.6, lambda _: vehicle.heartbeat()),
        (0.7, lambda _: mav.MAVLink_attitude_message(next(clock), 0, 0, 0, 0, 0, 0)),
    ]
    found = examine(vehicle, "heartbeat-steady", "clock")
    assert found["heartbeat-steady"].outcome == "wrong"
    assert found["clock"].outcome == "wrong"
    assert "ATTITUDE" in found["clock"].text


def parameters(vehicle: Scripted, told: list[tuple[bytes, float, int]], *, hidden: tuple[int, ...] = ()) -> None:
    """Let the vehicle have these parameters; `hidden` indices are left out of the list and told when asked for."""

    def value(index: int) -> Any:
        name, number, kind = told[index]
        return mav.MAVLink_param_value_message(name, number, kind, len(told), index)

    shown = [index for index in range(len(told)) if index not in hidden]
    vehicle.answers["PARAM_REQUEST_LIST"] = lambda _: [value(index) for index in shown]
    vehicle.answers["PARAM_REQUEST_READ"] = lambda asked: [value(asked.param_index)] if asked.param_index >= 0 else []


@pytest.mark.parametrize(("told_again", "outcome", "text"), [(True, "late", ""), (False, "missing", "1 of 2 came")])
def test_missing_parameters_are_asked_for_one_by_one(told_again: bool, outcome: str, text: str) -> None:
    vehicle = Scripted()
    told = [(b"A", 1.5, mav.MAV_PARAM_TYPE_REAL32), (b"B", 2.5, mav.MAV_PARAM_TYPE_REAL32)]
    parameters(vehicle, told, hidden=(1,))
    if not told_again:
        del vehicle.answers["PARAM_REQUEST_READ"]
    finding = examine(vehicle, "parameter-list")["parameter-list"]
    assert finding.outcome == outcome
    assert text in finding.text
    assert {m.param_index for m in vehicle.asked if type(m).__name__ == "PARAM_REQUEST_READ"} == {1}


@pytest.mark.parametrize(
    ("capability", "number", "outcome"),
    [
        (mav.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_C_CAST, 3.0, "ok"),
        (mav.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_C_CAST, 4.2e-45, "wrong"),
        (mav.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_BYTEWISE, 4.2e-45, "ok"),
        (mav.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_BYTEWISE, 3.0, "wrong"),
        (0, 3.0, "wrong"),
    ],
)
def test_integers_must_be_encoded_as_the_capabilities_say(capability: int, number: float, outcome: str) -> None:
    """4.2e-45 is what the bytes of the integer 3 are as a float."""
    vehicle = Scripted()
    parameters(vehicle, [(b"N", number, mav.MAV_PARAM_TYPE_INT32)])
    version = mav.MAVLink_autopilot_version_message(
        mav.MAV_PROTOCOL_CAPABILITY_MISSION_INT | mav.MAV_PROTOCOL_CAPABILITY_MAVLINK2 | capability,
        0x010E00FF, 0, 0, 0, bytes(8), bytes(8), bytes(8), 0, 0, 0,
    )  # fmt: skip
    vehicle.answers["COMMAND_LONG"] = lambda asked: [vehicle.ack(asked.command), version]
    found = examine(vehicle, "autopilot-version", "parameter-list", "parameter-encoding")
    assert found["autopilot-version"].outcome == "ok"
    assert found["parameter-encoding"].outcome == outcome


def test_nothing_arms_or_changes_the_mode_unless_it_is_allowed() -> None:
    vehicle = Scripted()
    examine(vehicle, *(question.key for question in questions()))
    commands = {m.command for m in vehicle.asked if type(m).__name__ in ("COMMAND_LONG", "COMMAND_INT")}
    assert len(commands) > 3
    assert not commands & {mav.MAV_CMD_COMPONENT_ARM_DISARM, mav.MAV_CMD_DO_SET_MODE, mav.MAV_CMD_NAV_TAKEOFF}
    assert not {type(m).__name__ for m in vehicle.asked} & {"SET_MODE", "SET_POSITION_TARGET_LOCAL_NED", "PARAM_SET"}


def test_another_vehicle_is_named_and_its_answers_are_not_taken() -> None:
    vehicle, other = Scripted(7), Scripted(8)
    dialogue = Dialogue([q for q in questions() if q.key in ("heartbeat", "ping")])
    now_s = 0.0
    while not dialogue.done:
        now_s += 0.05
        for scripted in (vehicle, other):
            dialogue.receive(scripted.frame(scripted.heartbeat()), now_s)
        dialogue.receive(other.frame(mav.MAVLink_ping_message(1, 4711, 255, 190)), now_s)
        dialogue.poll(now_s)
    assert dialogue.vehicle is not None
    told = as_json(dialogue.vehicle, dialogue.others, dialogue.findings)
    assert told["others"] == [8]
    assert {f["key"]: f["outcome"] for f in told["findings"]}["ping"] == "missing"


def test_a_ground_station_or_a_camera_is_no_vehicle() -> None:
    stranger = Scripted(9)
    dialogue = Dialogue(questions())
    for kind in (mav.MAV_TYPE_GCS, mav.MAV_TYPE_CAMERA):
        dialogue.receive(stranger.frame(stranger.heartbeat(type=kind)), 0.0)
    dialogue.receive(stranger.frame(stranger.heartbeat(autopilot=mav.MAV_AUTOPILOT_INVALID)), 0.0)
    assert dialogue.vehicle is None


ARDUPILOT = {"autopilot": mav.MAV_AUTOPILOT_ARDUPILOTMEGA, "custom_mode": 4}
UNINDEXED = 65535
"""PARAM_VALUE.param_index of what ArduPilot tells unasked, and of its answers to a name."""


def ardupilot() -> Scripted:
    """A vehicle with ArduPilot's parameters, as its 4.6 answers for them; one it tells by itself."""
    vehicle = Scripted()
    vehicle.streams = [
        (1.0, lambda _: vehicle.heartbeat(**ARDUPILOT)),
        (0.5, lambda _: told("STAT_RUNTIME", UNINDEXED)),
    ]
    real, int32 = mav.MAV_PARAM_TYPE_REAL32, mav.MAV_PARAM_TYPE_INT32
    values = {"PILOT_THR_FILT": real, "PILOT_TKOFF_ALT": real, "STAT_RUNTIME": int32}
    names = list(values)

    def told(name: str, index: int) -> Any:
        return mav.MAVLink_param_value_message(name.encode(), 2.0, values[name], len(names), index)

    vehicle.answers["PARAM_REQUEST_LIST"] = lambda _: [told(name, i) for i, name in enumerate(names)]
    vehicle.answers["PARAM_REQUEST_READ"] = lambda asked: (
        [told(asked.param_id, UNINDEXED)] if asked.param_id in values else []
    )
    vehicle.answers["PARAM_SET"] = vehicle.answers["PARAM_REQUEST_READ"]
    return vehicle


def test_answers_to_a_name_need_no_index_and_one_that_came_unasked_is_no_list() -> None:
    found = examine(ardupilot(), "parameter-list", "parameter-read", "parameter-set")
    assert {key: finding.outcome for key, finding in found.items() if key.startswith("parameter")} == {
        "parameter-list": "ok", "parameter-read": "ok", "parameter-set": "ok",
    }  # fmt: skip


def test_what_ardupilot_lacks_and_its_peers_know_to_go_without_is_no_fault() -> None:
    """Its 4.6 claims neither encoding, says nothing of a parameter that it lacks, and MAVSDK does not ping it."""
    vehicle = ardupilot()
    version = mav.MAVLink_autopilot_version_message(
        mav.MAV_PROTOCOL_CAPABILITY_PARAM_FLOAT, 0, 0, 0, 0, [0] * 8, [0] * 8, [0] * 8, 0, 0, 0
    )
    vehicle.answers["COMMAND_LONG"] = lambda asked: [vehicle.ack(asked.command), version]
    keys = ("autopilot-version-520", "ping", "parameter-list", "parameter-encoding", "parameter-unknown")
    found = examine(vehicle, *keys)
    assert {key: found[key].outcome for key in keys} == dict(
        zip(keys, ("ok", "skipped", "ok", "ok", "late"), strict=True)
    )
    assert passed(found.values())


def test_each_file_request_has_a_number_of_its_own_and_its_repetition_the_same() -> None:
    """ArduPilot takes a request whose answer would have the last answer's number for a repetition, and repeats that."""
    vehicle, number, opcode = Scripted(), slice(0, 2), 3
    last: list[Any] = []

    def answer(asked: Any) -> list[Any]:
        payload = list(asked.payload)
        follows = int.from_bytes(bytes(payload[number]), "little") + 1
        if not last or int.from_bytes(bytes(last[0].payload[number]), "little") != follows:
            said = [*follows.to_bytes(2, "little"), payload[2], 128, 0, payload[opcode], *[0] * 245]
            last[:] = [mav.MAVLink_file_transfer_protocol_message(0, 255, 190, said)]
        return last

    vehicle.answers["FILE_TRANSFER_PROTOCOL"] = answer
    found = examine(vehicle, "ftp", "ftp-reset")
    assert (found["ftp"].outcome, found["ftp-reset"].outcome) == ("ok", "ok")


@pytest.mark.parametrize("streams_from_s", [0.0, 1.1])
@pytest.mark.parametrize(("by_request", "by_410", "outcome"), [
    (True, True, "ok"), (True, False, "ok"), (False, True, "ok"), (False, False, "wrong"),
])  # fmt: skip
def test_home_the_old_way_is_judged_by_what_was_said_to_it_and_not_by_a_stream(
    streams_from_s: float, by_request: bool, by_410: bool, outcome: str
) -> None:
    """A stream of it, at half a hertz as PX4 1.18's, comes before, in or after the question."""
    vehicle = Scripted()
    home = mav.MAVLink_home_position_message(0, 0, 0, 0.0, 0.0, 0.0, [1.0, 0.0, 0.0, 0.0], 0.0, 0.0, 0.0)
    known = {mav.MAV_CMD_REQUEST_MESSAGE: by_request, mav.MAV_CMD_GET_HOME_POSITION: by_410}

    def answer(asked: Any) -> list[Any]:
        if known[asked.command]:
            return [vehicle.ack(asked.command), home]
        return [vehicle.ack(asked.command, mav.MAV_RESULT_UNSUPPORTED)]

    vehicle.answers["COMMAND_LONG"] = answer
    if by_request or by_410:
        vehicle.streams.append((2.0, lambda ms: home if ms >= 1e3 * streams_from_s else vehicle.heartbeat()))
    finding = examine(vehicle, "home-position", "home-position-410")["home-position-410"]
    assert finding.outcome == outcome
    assert finding.text == ("" if by_410 else "refused: UNSUPPORTED")
    without = examine(vehicle, "home-position", "home-position-410", peers=["MAVProxy"])["home-position-410"]
    assert without.outcome == outcome


def test_logs_are_asked_for_where_the_autopilot_tells_of_them() -> None:
    vehicle = Scripted()
    none = mav.MAVLink_log_entry_message(0, 0, 0, 0, 0)
    vehicle.answers["LOG_REQUEST_LIST"] = lambda _: [none]
    assert examine(vehicle, "log-list")["log-list"].outcome == "ok"
    armed = vehicle.heartbeat(autopilot=mav.MAV_AUTOPILOT_ARDUPILOTMEGA, base_mode=0x81, custom_mode=4)
    vehicle.streams = [(1.0, lambda _: armed)]
    assert examine(vehicle, "log-list")["log-list"].outcome == "skipped"
    silent = Scripted()
    assert examine(silent, "log-list")["log-list"].outcome == "missing"


@pytest.mark.parametrize(
    ("told_s", "outcome", "words"),
    [(1.8e9 + 3.0, "ok", ""), (0.0, "ok", ""), (1.8e9 - 3600.0, "wrong", "3600 s behind ours")],
)
def test_its_clock_is_compared_with_ours(told_s: float, outcome: str, words: str) -> None:
    vehicle = obeying(mav.MAVLink_system_time_message(round(1e6 * told_s), 1000))
    finding = examine(vehicle, "system-time", now_unix_s=lambda: 1.8e9)["system-time"]
    assert (finding.outcome, finding.text) == (outcome, words)


def test_over_a_link_with_a_key_an_unsigned_command_is_to_be_refused() -> None:
    vehicle = Scripted()
    assert examine(vehicle, "signing")["signing"].outcome == "skipped"
    assert examine(vehicle, "signing", signed=True)["signing"].outcome == "ok"
    assert examine(obeying(), "signing", signed=True)["signing"].outcome == "wrong"


def test_a_neighbour_behind_the_same_address_that_obeys_too_is_named() -> None:
    vehicle, neighbour = obeying(), Scripted(8)
    assert examine(vehicle, "home-position", "neighbours", neighbour=neighbour)["neighbours"].outcome == "ok"
    neighbour.answers["COMMAND_LONG"] = lambda asked: [neighbour.ack(asked.command)]
    finding = examine(vehicle, "home-position", "neighbours", neighbour=neighbour)["neighbours"]
    assert (finding.outcome, finding.text) == ("wrong", "acknowledged too by vehicle 8 (MAV_CMD_REQUEST_MESSAGE)")
    told_apart = examine(vehicle, "other-target", "neighbours", neighbour=neighbour)["neighbours"]
    assert told_apart.outcome == "ok"  # that command was the neighbour's
