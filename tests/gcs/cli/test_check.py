"""`gcs check` without a wire: what is asked, and how answers, silence and nonsense are judged. Frames by pymavlink."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import pytest
from pymavlink.dialects.v20 import common as mav

from gcs.cli.check.dialogue import CheckFinding, Dialogue
from gcs.cli.check.questions import questions
from gcs.cli.check.report import as_json, line, passed
from gcs.mavlink import codec

STEP_S = 0.01
PX4_LOITER = 4 << 16 | 3 << 24


class Scripted:
    """A vehicle that is nothing but what a test makes of it; pymavlink writes its frames."""

    def __init__(self, sysid: int = 7) -> None:
        self.link = mav.MAVLink(None, srcSystem=sysid, srcComponent=1)
        self.answers: dict[str, Callable[[Any], list[Any]]] = {}
        self.streams: list[tuple[float, Callable[[int], Any]]] = [(1.0, lambda _: self.heartbeat())]
        self.asked: list[Any] = []

    def heartbeat(self, **changes: Any) -> Any:
        values = {
            "type": mav.MAV_TYPE_QUADROTOR,
            "autopilot": mav.MAV_AUTOPILOT_PX4,
            "base_mode": mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED,
            "custom_mode": PX4_LOITER,
            "system_status": mav.MAV_STATE_STANDBY,
        }
        return mav.MAVLink_heartbeat_message(**values | changes, mavlink_version=3)

    def ack(self, command: int, result: int = mav.MAV_RESULT_ACCEPTED) -> Any:
        return mav.MAVLink_command_ack_message(command, result, 0, 0, 255, 190)

    def hear(self, message: codec.Message) -> list[Any]:
        asked = codec.fields(codec.split(codec.frame(message, 0, 255, 190)).frames[0])
        self.asked.append(asked)
        answer = self.answers.get(type(asked).__name__)
        return answer(asked) if answer else []

    def frame(self, message: Any) -> codec.Frame:
        return codec.split(message.pack(self.link)).frames[0]


def obeying(*more: Any, result: int = mav.MAV_RESULT_ACCEPTED) -> Scripted:
    """A vehicle that acknowledges each COMMAND_LONG so, and then says more."""
    vehicle = Scripted()
    vehicle.answers["COMMAND_LONG"] = lambda asked: [vehicle.ack(asked.command, result), *more]
    return vehicle


def examine(
    vehicle: Scripted, *keys: str, arm: bool = False, neighbour: Scripted | None = None, **more: Any
) -> dict[str, CheckFinding]:
    """The findings of some questions, by key, with the vehicle answering 10 ms after it was asked."""
    asked = [q for q in questions(arm=arm, **more) if q.key in ("heartbeat", *keys)]
    dialogue = Dialogue(asked)
    now_s, due_s = 0.0, [0.0] * len(vehicle.streams)
    pending: list[Any] = []
    while not dialogue.done:
        now_s += STEP_S
        for i, (period_s, made) in enumerate(vehicle.streams):
            if now_s >= due_s[i]:
                due_s[i] = now_s + period_s
                pending.append(made(round(1e3 * now_s)))
        for message in pending:
            dialogue.receive(vehicle.frame(message), now_s)
        messages = dialogue.poll(now_s)
        pending = [answer for message in messages for answer in vehicle.hear(message)]
        for answer in [answer for message in messages for answer in neighbour.hear(message)] if neighbour else ():
            dialogue.receive(neighbour.frame(answer), now_s)
        assert now_s < 120.0
    return {finding.question.key: finding for finding in dialogue.findings}


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


def mode(index: int, custom_mode: int, standard: int = 0, name: bytes = b"", count: int = 3) -> Any:
    return mav.mavlink_map[435](count, index, standard, custom_mode, 0, name)


@pytest.mark.parametrize(
    ("modes", "outcome", "words"),
    [
        ([mode(1, 7, 6), mode(2, PX4_LOITER, 0, b"Hold"), mode(3, 9, 0, b"Soar")], "ok", ""),
        ([mode(1, 7, 6), mode(3, PX4_LOITER, 0, b"Hold")], "wrong", "these of its modes never came: 2"),
        (
            [mode(1, 7, 6), mode(2, 8, 5), mode(3, 9, 0, b"Soar")],
            "wrong",
            f"custom_mode {PX4_LOITER}, which its HEARTBEAT",
        ),
        ([mode(1, 7), mode(2, PX4_LOITER, 0, b"Hold"), mode(3, 9, 7)], "wrong", "mode 7 has neither"),
    ],
)
def test_every_mode_is_to_be_listed_and_named(modes: list[Any], outcome: str, words: str) -> None:
    vehicle = Scripted()
    vehicle.answers["COMMAND_LONG"] = lambda asked: [
        vehicle.ack(asked.command), *(modes if (asked.param1, asked.param2) == (435.0, 0.0) else ()),
    ]  # fmt: skip
    finding = examine(vehicle, "available-modes")["available-modes"]
    assert (finding.outcome, words in finding.text) == (outcome, True)


def test_modes_that_come_one_by_one_are_late() -> None:
    """An ArduCopter 4.8.0-dev answers a request for all with the first, and one for an index with that."""
    vehicle, modes = Scripted(), [mode(1, 7, 6), mode(2, PX4_LOITER, 0, b"Hold"), mode(3, 9, 0, b"Soar")]
    vehicle.answers["COMMAND_LONG"] = lambda asked: [
        vehicle.ack(asked.command), *([modes[max(int(asked.param2), 1) - 1]] if asked.param1 == 435.0 else ()),
    ]  # fmt: skip
    finding = examine(vehicle, "available-modes")["available-modes"]
    assert (finding.outcome, finding.text) == ("late", "came only after it was asked 3 times")


TO_ALL = (0, 0, [0] * 20)
BASIC_ID = mav.MAVLink_open_drone_id_basic_id_message(*TO_ALL, 1, 2, [65] * 20)
WHERE = (
    mav.MAVLink_open_drone_id_location_message(*TO_ALL, *[1] * 16),
    mav.MAVLink_open_drone_id_system_message(*TO_ALL, *[1] * 12),
)
OPERATOR_ID = mav.MAVLink_open_drone_id_operator_id_message(*TO_ALL, 0, b"A1")


@pytest.mark.parametrize(
    ("sent", "outcome", "text"),
    [
        ((), "skipped", "it sends none of it"),
        (WHERE, "skipped", "it has no id, and says where it is to a transmitter that has one"),
        ((BASIC_ID, *WHERE), "missing", "OPERATOR_ID: not heard"),
        ((BASIC_ID, *WHERE, OPERATOR_ID), "ok", ""),
    ],
)
def test_remote_id_is_asked_of_a_vehicle_that_has_an_id(sent: tuple[Any, ...], outcome: str, text: str) -> None:
    vehicle = Scripted()
    vehicle.streams += [(0.5, lambda _, message=message: message) for message in sent]
    vehicle.answers["PING"] = lambda _: []  # a while in which all of it is heard
    finding = examine(vehicle, "ping", "remote-id")["remote-id"]
    assert (finding.outcome, text in finding.text) == (outcome, True)


@pytest.mark.parametrize(("flown", "outcome"), [(PX4_LOITER, "ok"), (6 << 16, "wrong")])
def test_the_current_mode_is_to_be_the_heartbeats(flown: int, outcome: str) -> None:
    assert examine(obeying(mav.mavlink_map[436](0, flown, 0)), "current-mode")["current-mode"].outcome == outcome


@pytest.mark.parametrize(("standard", "outcome"), [(7, "ok"), (5, "skipped")])
def test_a_standard_mode_is_set_where_one_is_listed(standard: int, outcome: str) -> None:
    vehicle = Scripted()
    modes = [mode(1, PX4_LOITER, 0, b"Hold", 2), mode(2, 9, standard, b"", 2)]
    vehicle.answers["COMMAND_LONG"] = lambda asked: [
        vehicle.ack(asked.command), *(modes if asked.param1 == 435.0 else ()),
    ]  # fmt: skip
    found = examine(vehicle, "available-modes", "standard-mode", arm=True)
    assert found["standard-mode"].outcome == outcome
    asked = [(one.command, one.param1) for one in vehicle.asked if type(one).__name__ == "COMMAND_LONG"]
    assert ((mav.MAV_CMD_DO_SET_STANDARD_MODE, 7.0) in asked) is (outcome == "ok")


@pytest.mark.parametrize(
    ("flags", "owner", "outcome"), [(3, 0, "ok"), (1, 255, "ok"), (0, 255, "wrong"), (None, 0, "ok")]
)
def test_operator_control_is_asked_of_a_vehicle_that_reports_its_owner(
    flags: int | None, owner: int, outcome: str
) -> None:
    vehicle = Scripted()
    status = mav.mavlink_map[512](flags or 0, owner, [0] * 10)

    def answer(asked: Any) -> list[Any]:
        if asked.command == mav.MAV_CMD_REQUEST_MESSAGE:
            return [vehicle.ack(asked.command, 3)] if flags is None else [vehicle.ack(asked.command), status]
        return [vehicle.ack(asked.command)]

    vehicle.answers["COMMAND_LONG"] = answer
    found = examine(vehicle, "control-status", "operator-control", "operator-control-released", arm=True)
    assert found["control-status"].outcome == outcome
    asked = [(one.param1, one.param4) for one in vehicle.asked if getattr(one, "command", 0) == 32100]
    assert asked == ([] if flags is None else [(1.0, 255.0), (0.0, 255.0)])
    assert (found["operator-control"].outcome == "skipped") is (flags is None)


@pytest.mark.parametrize(
    ("seen", "text"),
    [
        ({"a": 0xA1}, ""),
        ({"a": None}, ""),
        ({"a": 0xA1, "b": 0xB2}, "its system id comes from a (uid a1) and from b (uid b2)"),
        ({"a": 0xA1, "b": None}, "its system id comes from a (uid a1) and from b (uid not said)"),
    ],
)
def test_a_system_id_from_two_addresses_is_named_with_both_and_their_uids(
    seen: dict[str, int | None], text: str
) -> None:
    vehicle = Scripted()
    dialogue = Dialogue([q for q in questions() if q.key == "twin"])
    for at, uid in seen.items():
        dialogue.receive(vehicle.frame(vehicle.heartbeat()), 0.0, at)
        if uid is not None:
            version = mav.MAVLink_autopilot_version_message(0, 0, 0, 0, 0, [0] * 8, [0] * 8, [0] * 8, 0, 0, uid)
            dialogue.receive(vehicle.frame(version), 0.0, at)
    for k in range(3):
        dialogue.poll(0.1 * k)
    (finding,) = dialogue.findings
    assert (finding.outcome, finding.text) == ("wrong" if text else "ok", text)


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
