"""What a session does for vehicles that it has not launched, tick by tick; the frames are pymavlink's."""

import json
import struct
from typing import Any

import newer
import pytest
from metadata_vehicle import GENERAL, OUT, MetadataVehicle, crc32
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.mavlink import codec
from gcs.mavlink.command_protocol import CommandResult, CommandTarget
from gcs.mavlink.services.vehicle_events import ASK_AFTER_S
from gcs.scenario.model import Scenario
from gcs.supervisor.arming import Stage
from gcs.supervisor.external_fleet import ENDING, LOST_S, METADATA, SAY_AGAIN_S, ExternalFleet
from gcs.supervisor.services.vehicle_texts import VehicleTexts
from gcs.telemetry.fleet import Fleet, GlobalOrigin
from gcs.telemetry.track import Member

LAT, LON, ALT = 47.0, 8.0, 400.0


class Tower:
    """One external vehicle, 3, and what the session does about it; time is the test's."""

    def __init__(self, speed: float = 1.0, **rules: Any) -> None:
        block = {"connect": "udpin:127.0.0.1:14550", "sysid": 3, "capacity_j": 1e5, **rules}
        scenario = Scenario.model_validate({
            "schema": 1, "name": "tower", "axes": "ned", "origin": {"lat_deg": LAT, "lon_deg": LON, "alt_m": ALT},
            "clock": {"mode": "real", "speed": speed}, "goal": {"duration_s": 60.0},
            "vehicles": {"pursuers": [{"external": block}]},
        })  # fmt: skip
        self.externals = ExternalFleet(scenario)
        self.fleet = Fleet([Member(3, "pursuer", "pursuer 3", 1e5, 1e5, external=True)], GlobalOrigin(LAT, LON, ALT))
        self.sender = mav.MAVLink(None, srcSystem=3, srcComponent=1)

    def hear(
        self, now_s: float, *messages: Any, compid: int = 1, rebooted: tuple[int, ...] = (), offset_s: float = -100.0
    ) -> None:
        self.sender.srcComponent = compid
        frames = codec.split(b"".join(bytes(message.pack(self.sender)) for message in messages)).frames
        for frame in frames:
            self.fleet.ingest(frame, now_s)
        self.externals.receive({3: frames}, {3: offset_s}, rebooted, self.fleet, now_s)

    def decide(self, now_s: float) -> dict[str, int]:
        wishes, _ = self.externals.decide(self.fleet.snapshot(now_s))
        return {wish.token: wish.command for wish in wishes if wish.token != "uid"}

    def said(self) -> list[tuple[str, str]]:
        return [(event.level, event.text) for event in self.externals.pop_events()]

    def end(self, stage: Stage) -> list[tuple[int, tuple[float, ...]]]:
        wishes = self.externals.hand_back(self.fleet.snapshot(0.0), {3: stage})
        return [(wish.command, wish.params) for wish in wishes]


def heartbeat(autopilot: int = 12, custom_mode: int = 6 << 16, base_mode: int = 0x81) -> Any:
    return mav.MAVLink_heartbeat_message(2, autopilot, base_mode, custom_mode, 4, 3)


def landed(state: int) -> Any:
    return mav.MAVLink_extended_sys_state_message(0, state)


def origin() -> Any:
    return mav.MAVLink_gps_global_origin_message(round(1e7 * LAT), round(1e7 * LON), round(1e3 * ALT))


def result(token: str, outcome: str = "rejected") -> CommandResult:
    return CommandResult(400, CommandTarget(3, 1), outcome, 4, 1, token)  # type: ignore[arg-type]


def test_ten_seconds_of_silence_count_as_lost_until_it_is_heard() -> None:
    tower = Tower()
    tower.hear(0.0, heartbeat(), origin())
    tower.decide(0.0)
    tower.hear(LOST_S - 0.1)
    assert (tower.externals.lost, tower.said()) == (set(), [])
    tower.hear(LOST_S)
    assert tower.externals.lost == {3}
    assert not tower.fleet.snapshot(LOST_S).vehicle(3).alive
    assert tower.said() == [("critical", "No telemetry for 10 s: it is counted as lost until it is heard")]
    assert tower.decide(LOST_S) == {}
    tower.hear(LOST_S + 3.0, heartbeat())
    assert tower.externals.lost == set()
    assert tower.fleet.snapshot(LOST_S + 3.0).vehicle(3).alive
    assert tower.said() == [("warning", "Heard again: it is not lost")]
    assert "stream LOCAL_POSITION_NED" in tower.decide(LOST_S + 3.0)  # it may have booted meanwhile


def test_one_whose_process_died_is_lost_at_once_and_for_good() -> None:
    """Its last datagrams may come after its death."""
    tower = Tower()
    tower.hear(0.0, heartbeat(), origin())
    tower.externals.die(3)
    tower.externals.die(1)
    for time_s in (0.1, LOST_S, LOST_S + 5.0):
        tower.hear(time_s, *([heartbeat()] if time_s < 1.0 else []))
        assert (tower.externals.lost, tower.said()) == ({3}, [])


def test_the_words_of_its_gimbal_are_not_its_own() -> None:
    tower = Tower()
    tower.hear(0.0, heartbeat())
    tower.hear(LOST_S, heartbeat(), compid=mav.MAV_COMP_ID_GIMBAL)
    assert tower.externals.lost == {3}


def test_an_unknown_origin_is_told_once_and_so_is_that_it_is_known() -> None:
    tower = Tower()
    tower.hear(0.0, heartbeat())
    for k in range(60):
        tower.decide(0.1 * k)
    assert [text for _, text in tower.said() if "frame" in text] == [
        "Does not say where its frame lies (GPS_GLOBAL_ORIGIN, HOME_POSITION): it stays where it is"
    ]
    tower.hear(6.0, origin())
    tower.decide(6.0)
    assert ("info", "Its frame is known now") in tower.said()


def test_a_vehicle_that_boots_is_asked_for_its_streams_again() -> None:
    tower = Tower()
    tower.hear(0.0, heartbeat())
    tower.decide(0.0)
    assert "stream ATTITUDE" not in tower.decide(1.0)
    tower.hear(2.0, heartbeat(), rebooted=(3,))
    assert tower.said() == [("warning", "Its clock has begun anew: it has booted")]
    assert "stream ATTITUDE" in tower.decide(2.0)


def test_a_stream_that_does_not_come_is_a_warning_and_that_it_comes_again_is_none() -> None:
    tower = Tower()
    for k in range(111):
        attitude = [mav.MAVLink_attitude_message(100 * k, 0, 0, 0, 0, 0, 0)] if k > 50 else []
        tower.hear(0.1 * k, heartbeat(), *attitude)
        tower.decide(0.1 * k)
    said = [notice for notice in tower.said() if "ATTITUDE" in notice[1]]
    assert said == [("warning", "ATTITUDE does not come"), ("info", "ATTITUDE comes as it should now")]


def test_a_boot_is_no_clock_that_does_not_keep_the_speed() -> None:
    tower = Tower(speed=3.0)
    tower.hear(0.0, heartbeat())
    tower.hear(60.0, heartbeat(), rebooted=(3,), offset_s=58.0)
    assert tower.said() == [("warning", "Its clock has begun anew: it has booted")]
    tower.hear(61.0, heartbeat(), offset_s=60.5)
    assert tower.said() == [("warning", "Its clock has fallen 2.5 s behind the session's: it does not keep speed 3")]


def test_a_refused_stream_is_nobodys_news_and_a_refused_arming_is_once_in_a_while() -> None:
    tower = Tower()
    tower.decide(0.0)
    assert tower.externals.settles(3, result("stream ATTITUDE"), 1.0)
    assert tower.externals.settles(3, result("origin HOME_POSITION", "timeout"), 1.0)
    assert tower.decide(1.1) == {"origin home": mav.MAV_CMD_GET_HOME_POSITION}
    told = [not tower.externals.settles(3, result("pilot arm"), 1.0 + k) for k in range(12)]
    assert [k for k, said in enumerate(told) if said] == [0, int(SAY_AGAIN_S)]
    assert not tower.externals.settles(3, result("pilot arm", "accepted"), 20.0)
    assert not tower.externals.settles(4, result("pilot arm"), 20.0)  # one of ours


@pytest.mark.parametrize(
    ("autopilot", "custom_mode", "at_end", "command", "params"),
    [
        (12, 6 << 16, "hold", mav.MAV_CMD_DO_SET_MODE, (1.0, 4.0, 3.0)),
        (3, 4, "hold", mav.MAV_CMD_DO_SET_MODE, (1.0, 17.0)),
        (12, 6 << 16, "return", mav.MAV_CMD_NAV_RETURN_TO_LAUNCH, ()),
        (3, 4, "land", mav.MAV_CMD_NAV_LAND, ()),
    ],
)
def test_at_the_end_it_is_told_what_the_scenario_says_until_its_mode_shows_it(
    autopilot: int, custom_mode: int, at_end: str, command: int, params: tuple[float, ...]
) -> None:
    tower = Tower(at_end=at_end)
    tower.hear(0.0, heartbeat(autopilot, custom_mode), landed(mav.MAV_LANDED_STATE_IN_AIR))
    ((told, values),) = tower.end(Stage.FLY)
    assert (told, values[: len(params)]) == (command, params)
    assert tower.externals.awaits(tower.fleet.snapshot(0.0))
    tower.hear(1.0, heartbeat(autopilot, 17 if autopilot == 3 else 4 << 16 | 3 << 24))
    assert not tower.externals.awaits(tower.fleet.snapshot(1.0))


@pytest.mark.parametrize(
    ("outcome", "code", "said"),
    [
        ("rejected", mav.MAV_RESULT_DENIED, "it answered: denied"),
        ("rejected", mav.MAV_RESULT_TEMPORARILY_REJECTED, "it answered: temporarily rejected"),
        ("rejected", 77, "it answered: result 77"),
        ("timeout", None, "it has not answered 4 commands"),
        ("accepted", mav.MAV_RESULT_ACCEPTED, "it answered that it would"),
        (None, None, "it has not answered yet"),
    ],
)
def test_who_does_not_obey_at_the_end_is_named_with_its_answer(outcome: Any, code: Any, said: str) -> None:
    tower = Tower()
    tower.hear(0.0, heartbeat(), landed(mav.MAV_LANDED_STATE_IN_AIR))
    tower.end(Stage.FLY)
    if outcome is not None:
        tower.externals.settles(3, CommandResult(176, CommandTarget(3, 1), outcome, code, 4, ENDING), 1.0)
    tower.said()
    tower.externals.report_disobedience(tower.fleet.snapshot(1.0))
    text = f"Still in Offboard though it is no longer controlled ({said}): look after it"
    assert tower.said() == [("critical", text)]
    tower.hear(1.0, heartbeat(custom_mode=4 << 16 | 3 << 24))
    tower.externals.report_disobedience(tower.fleet.snapshot(1.0))
    assert tower.said() == []


def test_streams_that_do_not_come_are_named_of_external_vehicles_only() -> None:
    tower = Tower()
    for k in range(60):
        tower.hear(0.1 * k, heartbeat(), mav.MAVLink_attitude_message(100 * k, 0, 0, 0, 0, 0, 0))
        tower.decide(0.1 * k)
    assert tower.externals.missing_streams(3) == [
        "BATTERY_STATUS", "EXTENDED_SYS_STATE", "LOCAL_POSITION_NED", "SYS_STATUS",
    ]  # fmt: skip
    assert tower.externals.missing_streams(4) == []


def test_of_one_that_says_nothing_at_all_no_stream_is_said_to_be_missing() -> None:
    tower = Tower()
    streams = [
        mav.MAVLink_attitude_message(0, 0, 0, 0, 0, 0, 0), mav.MAVLink_local_position_ned_message(0, 0, 0, 0, 0, 0, 0),
        landed(mav.MAV_LANDED_STATE_IN_AIR), mav.MAVLink_battery_status_message(0, 0, 0, 0, [0] * 10, 0, 0, 0, 50),
        mav.MAVLink_sys_status_message(0, 0, 0, 0, 0, 0, 50, 0, 0, 0, 0, 0, 0),
    ]  # fmt: skip
    for k in range(300):
        tower.hear(0.1 * k, *(() if 72 <= k < 160 else (heartbeat(), *streams)))
        tower.decide(0.1 * k)
    assert tower.externals.missing_streams(3) == []
    assert not [text for _, text in tower.said() if "come" in text]


def test_at_the_end_one_on_the_ground_is_disarmed_and_one_that_is_somebody_elses_is_left_alone() -> None:
    tower = Tower()
    tower.hear(0.0, heartbeat(), landed(mav.MAV_LANDED_STATE_ON_GROUND))
    assert tower.end(Stage.TAKEOFF) == [(mav.MAV_CMD_COMPONENT_ARM_DISARM, (0.0,))]
    assert tower.end(Stage.YIELDED) == tower.end(Stage.DOWN) == []
    tower.hear(1.0, heartbeat(base_mode=0x01))
    assert tower.end(Stage.ARM) == []


def test_who_is_left_in_the_air_at_the_end_is_named() -> None:
    tower = Tower(at_end="land")
    tower.hear(0.0, heartbeat(), origin(), landed(2))
    tower.said()
    assert tower.end(Stage.YIELDED) == []
    assert tower.said() == [("warning", "Left in the air in Offboard: this session does not control it")]
    tower.externals.receive({}, {}, (), tower.fleet, 12.0)
    tower.said()
    wishes = tower.externals.hand_back(tower.fleet.snapshot(12.0), {3: Stage.FLY})
    assert [wish.command for wish in wishes] == [mav.MAV_CMD_NAV_LAND]  # it may hear it
    ((level, text),) = tower.said()
    assert level == "critical"
    assert text.startswith("May still be flying: not heard for 12 s, then in Offboard")


def available(index: int, custom_mode: int, standard: int = 0, name: bytes = b"", count: int = 2) -> Any:
    return mav.mavlink_map[435](count, index, standard, custom_mode, 4, name)


def asks(tower: Tower, now_s: float) -> bool:
    return tower.decide(now_s).get("modes") == mav.MAV_CMD_REQUEST_MESSAGE


def asked_modes(tower: Tower, now_s: float) -> list[float]:
    """Indices that it asks for, 0 for all."""
    wishes, _ = tower.externals.decide(tower.fleet.snapshot(now_s))
    return [wish.params[1] for wish in wishes if wish.token == "modes"]


def test_a_mode_that_nothing_names_is_asked_for_a_few_times_and_named_as_the_vehicle_names_it() -> None:
    tower = Tower()
    tower.hear(0.0, heartbeat(autopilot=0, custom_mode=77), origin())
    assert [asks(tower, k / 2.0) for k in range(20)] == [k in (0, 4, 8) for k in range(20)]
    tower.hear(10.0, heartbeat(autopilot=0, custom_mode=78))
    assert asks(tower, 10.0)
    assert tower.externals.settles(3, result("modes"), 10.0)
    assert tower.said() == []
    tower.hear(11.0, available(1, 77, name=b"Soar"), available(2, 78, standard=5))
    view = tower.fleet.snapshot(11.0).vehicle(3)
    assert (view.mode, view.mode_name) == ("return", "Return")
    tower.hear(12.0, heartbeat(autopilot=0, custom_mode=77))
    view = tower.fleet.snapshot(12.0).vehicle(3)
    assert (view.mode, view.mode_name) == ("other", "Soar")
    assert not asks(tower, 30.0)


@pytest.mark.parametrize("lost", [0, 3])
def test_modes_that_come_one_by_one_are_asked_for_so(lost: int) -> None:
    """An ArduCopter 4.8.0-dev answers a request for all with the first, and one for an index with that."""
    tower, asked, names = Tower(), [], [b"Stabilize", b"Soar", b"Dive", b"Perch"]
    tower.hear(0.0, heartbeat(autopilot=3, custom_mode=71))
    for k in range(120):
        for index in asked_modes(tower, 0.1 * k):
            asked.append(index)
            if index != lost or index == 0:
                at = max(int(index), 1)
                tower.hear(0.1 * k, available(at, 69 + at, name=names[at - 1], count=4))
    assert asked == ([0, 2, 3, 4] if lost == 0 else [0, 2, 3, 3, 3])
    assert tower.fleet.snapshot(12.0).vehicle(3).mode_name == "Soar"
    tower.hear(12.0, heartbeat(autopilot=3, custom_mode=73))
    assert tower.fleet.snapshot(12.0).vehicle(3).mode_name == ("Perch" if lost == 0 else "mode 73")


def test_modes_that_have_changed_are_asked_for_anew() -> None:
    tower = Tower()
    tower.hear(0.0, heartbeat(autopilot=0, custom_mode=77), available(1, 77, name=b"Soar"))
    assert not asks(tower, 0.0)
    tower.hear(1.0, mav.mavlink_map[437](1))
    assert tower.fleet.snapshot(1.0).vehicle(3).mode_name == "mode 77"
    assert asks(tower, 1.0)


def test_a_mode_of_the_table_is_never_asked_for_and_keeps_its_name() -> None:
    tower = Tower()
    tower.hear(0.0, heartbeat(custom_mode=4 << 16 | 4 << 24), available(1, 4 << 16 | 4 << 24, name=b"Task"))
    assert not asks(tower, 0.0)
    assert tower.fleet.snapshot(0.0).vehicle(3).mode_name == "Mission"


@pytest.mark.parametrize(("end", "standard"), [("return", 5), ("land", 7)])
def test_a_vehicle_with_numbers_of_its_own_ends_in_the_standard_mode_that_it_lists(end: str, standard: int) -> None:
    tower = Tower(at_end=end)
    tower.hear(0.0, heartbeat(autopilot=0, custom_mode=77), origin(), landed(2))
    tower.hear(0.1, available(1, 77, name=b"Soar"), available(2, 78, standard=standard))
    assert tower.end(Stage.FLY) == [(mav.MAV_CMD_DO_SET_STANDARD_MODE, (float(standard),))]
    px4 = Tower(at_end=end)
    px4.hear(0.0, heartbeat(), origin(), landed(2))
    px4.hear(0.1, available(1, 4 << 16 | 5 << 24, standard=5), available(2, 4 << 16 | 6 << 24, standard=7))
    ((command, _),) = px4.end(Stage.FLY)
    assert command == {"return": mav.MAV_CMD_NAV_RETURN_TO_LAUNCH, "land": mav.MAV_CMD_NAV_LAND}[end]


def version(uid: int) -> Any:
    return mav.MAVLink_autopilot_version_message(0, 0, 0, 0, 0, [0] * 8, [0] * 8, [0] * 8, 0, 0, uid)


def test_two_vehicles_with_one_id_behind_one_address_are_not_armed_and_named_by_their_uids() -> None:
    tower = Tower()
    tower.hear(0.0, heartbeat(), version(0xA1), version(0xA1))
    assert tower.externals.ambiguous == {}
    tower.hear(0.1, version(0xB2))
    tower.hear(0.2, version(0xA1))
    ((level, said),) = tower.said()
    assert level == "critical"
    assert said == tower.externals.ambiguous[3]
    assert said.startswith("Two vehicles say that they are 3, both at udpin:127.0.0.1:14550, with the uids a1 and b2")


def test_another_uid_after_a_reboot_and_none_at_all_are_no_twin() -> None:
    tower = Tower()
    tower.hear(0.0, heartbeat(), version(0xA1), version(0))
    tower.hear(5.0, heartbeat(), rebooted=(3,))
    tower.hear(5.1, version(0xB2))
    assert tower.externals.ambiguous == {}


def test_a_vehicle_is_asked_for_its_uid_three_times() -> None:
    tower = Tower()
    tower.hear(0.0, heartbeat())
    asked = [wish for k in range(80) for wish in tower.externals.decide(tower.fleet.snapshot(0.1 * k))[0]]
    assert [(one.command, one.params) for one in asked if one.token == "uid"] == [(512, (148.0,))] * 3


def definitions(**messages: str) -> bytes:
    """An autopilot's events by their numbers, with words."""
    events = {number[1:]: {"name": number, "message": text} for number, text in messages.items()}
    space = {"namespace": "px4", "event_groups": {"default": {"events": events}}}
    return json.dumps({"version": 2, "components": {"1": space}}).encode()


def test_what_was_said_in_a_flight_before_its_words_were_known_is_said_with_its_age() -> None:
    content = definitions(e1="Armed", e2="Takeoff detected")
    named = [{"type": 4, "uri": "mftp://events.json", "fileCrc": crc32(content)}]
    vehicle, tower = MetadataVehicle(named, {"events.json": content}), Tower()
    texts = VehicleTexts(tower.fleet, tower.externals, {})
    events = [newer.dialect.MAVLink_event_message(0, 0, 1 << 24 | k, 900, k, 0x66, b"\0" * 40) for k in (1, 2)]
    tower.hear(1.0, heartbeat(), *events, mav.MAVLink_statustext_message(6, b"Armed\t"))
    assert [one.text for one in texts.pop_events(1.0)] == ["Armed"]
    uri = f"mftp://{GENERAL}".encode()
    answers = [newer.dialect.MAVLink_component_metadata_message(1, vehicle.crc, uri)]
    now_s, said = 59.0, []
    while not said:
        now_s += 0.1
        assert now_s < 90.0
        tower.hear(now_s, heartbeat(base_mode=0x01), *answers)
        _, messages = tower.externals.decide(tower.fleet.snapshot(now_s))
        sent = [frame for message in messages[3] for frame in OUT.parse_buffer(codec.frame(message, 0, 255, 190)) or []]
        files = [message for message in sent if message.get_type() == "FILE_TRANSFER_PROTOCOL"]
        answers = [answer for message in files for answer in vehicle.hear(message)]
        said = [one.text for one in texts.pop_events(now_s)]
    assert said == [f"Takeoff detected ({now_s - 1.0:.0f} s ago)"]
    assert [one["text"] for one in texts.pop_records()] == said


def test_events_are_said_by_the_vehicles_own_metadata() -> None:
    content = json.dumps({"version": 2, "components": {"1": {"namespace": "px4", "event_groups": {"default": {
        "events": {"7": {"name": "denied", "message": "Arming denied: {1:.1}", "arguments": [
            {"name": "a", "type": "float"}]}}}}}}}).encode()  # fmt: skip
    named = [{"type": 4, "uri": "mftp://events.json", "fileCrc": crc32(content)}]
    vehicle, tower = MetadataVehicle(named, {"events.json": content}), Tower()
    tower.hear(0.0, heartbeat(base_mode=0x01))
    tower.decide(0.0)
    tower.hear(ASK_AFTER_S, heartbeat(base_mode=0x01))
    wishes, _ = tower.externals.decide(tower.fleet.snapshot(ASK_AFTER_S))
    (ask,) = [wish for wish in wishes if wish.token == METADATA]
    assert (ask.command, ask.params) == (mav.MAV_CMD_REQUEST_MESSAGE, (397.0,))
    uri = f"mftp://{GENERAL}".encode()
    arguments = struct.pack("<f", 2.25).ljust(40, b"\0")
    answers = [newer.dialect.MAVLink_component_metadata_message(1, vehicle.crc, uri)]
    answers += [newer.dialect.MAVLink_event_message(0, 0, 1 << 24 | 7, 900, k, 0x44, arguments) for k in (1, 3)]
    now_s, asked = ASK_AFTER_S, []
    while now_s < 30.0:
        now_s += 0.1
        number = newer.dialect.MAVLink_current_event_sequence_message(3, 0)
        tower.hear(now_s, heartbeat(base_mode=0x01), *answers, number)
        _, messages = tower.externals.decide(tower.fleet.snapshot(now_s))
        sent = [frame for message in messages[3] for frame in OUT.parse_buffer(codec.frame(message, 0, 255, 190)) or []]
        asked += [message.first_sequence for message in sent if message.get_type() == "REQUEST_EVENT"]
        files = [message for message in sent if message.get_type() == "FILE_TRANSFER_PROTOCOL"]
        answers = [answer for message in files for answer in vehicle.hear(message)]
    assert set(asked) == {2}  # which never comes
    assert [text for *text, _ in tower.externals.pop_texts()] == [[3, 4, "Arming denied: 2.2"]] * 2
    assert [text for _, text in tower.said() if "events" in text] == [
        "1 of its events did not arrive, nor when asked for"
    ]
    assert tower.externals.settles(3, result(METADATA), now_s)
