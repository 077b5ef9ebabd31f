"""Check lists before the flight, tick by tick; the frames are pymavlink's."""

from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav
from views import snapshot, view

from gcs.mavlink import codec
from gcs.scenario.model import Scenario
from gcs.supervisor.arming import ArmingSequence, Stage
from gcs.supervisor.preflight import Preflight

NOON_US = 1_790_000_000_000_000


class Session:
    """An external vehicle, 3, and its check list; time is the test's."""

    def __init__(self, *, preflight: str = "enforce", speed: float = 1.0, mission: Any = None, **fence: Any) -> None:
        external = {"connect": "udpin:127.0.0.1:14550", "sysid": 3, "capacity_j": 1e5}
        scenario = Scenario.model_validate({
            "schema": 1, "name": "list", "axes": "ned", "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 400.0},
            "goal": {"duration_s": 60.0}, "vehicles": {"pursuers": [{"external": external, "mission": mission}]},
            "preflight": preflight, "fence": fence, "clock": {"mode": "real", "speed": speed},
        })  # fmt: skip
        self.preflight = Preflight(scenario)
        self.sender = mav.MAVLink(None, srcSystem=3, srcComponent=1)
        self.now_s = 0.0
        self.sent: list[str] = []

    def hear(self, *messages: Any, said_s: float | None = None) -> None:
        frames = codec.split(b"".join(bytes(message.pack(self.sender)) for message in messages)).frames
        said_s = self.now_s if said_s is None else said_s
        self.preflight.receive({3: frames}, NOON_US + round(1e6 * said_s), self.now_s, said_s)

    def go_on(self, for_s: float, **seen: Any) -> None:
        for _ in range(round(10 * for_s)):
            self.now_s += 0.1
            messages = self.preflight.decide(snapshot(view(3, **seen), time_s=self.now_s)).get(3, [])
            self.sent += [codec.name(message.msgid) for message in messages]

    def end(self) -> tuple[bool, str, list[tuple[str, str]]]:
        """Whether the list has ended, why it must not be armed, and what was told."""
        told = [(event.level, event.text) for event in self.preflight.pop_events()]
        return self.preflight.ended(3), self.preflight.failed(3), told


def system_time(off_s: float) -> Any:
    return mav.MAVLink_system_time_message(NOON_US + round(1e6 * off_s), 5000)


@pytest.mark.parametrize(
    ("off_s", "text"),
    [(-3.0, ""), (9.0, ""), (3600.5, "clock 3600 s ahead of ours"), (-86400.0, "clock 86400 s behind ours")],
)
def test_a_clock_that_is_far_off_fails(off_s: float, text: str) -> None:
    session = Session()
    session.go_on(0.5)
    assert session.sent == ["COMMAND_LONG"]
    session.hear(system_time(off_s))
    session.go_on(0.1)
    ended, failed, told = session.end()
    assert ended
    assert failed.startswith(f"Fails its check list and is not armed: {text} (") if text else not failed
    assert told == [("warning" if text else "info", f"Check list: {text or 'clock right'}")]


def test_who_has_no_time_or_does_not_tell_it_passes_and_is_asked_twice() -> None:
    for messages, text in (((), "clock not reported"), ([mav.MAVLink_system_time_message(0, 7)], "clock not set yet")):
        session = Session()
        session.go_on(1.0)
        session.hear(*messages)
        session.go_on(3.0)
        assert session.end() == (True, "", [("info", f"Check list: {text}")])
        assert session.sent == ["COMMAND_LONG"] * 2


def test_nobody_is_asked_before_it_has_been_received() -> None:
    session = Session(inside=[{"circle_m": [0, 0], "radius_m": 30.0}])
    session.go_on(5.0, last_received_s=float("-inf"))
    session.go_on(5.0, alive=False)
    assert session.sent == []
    assert not session.preflight.ended(3)


@pytest.mark.parametrize("preflight", ["enforce", "warn"])
def test_a_fence_that_is_not_answered_fails_where_that_is_enforced(preflight: str) -> None:
    session = Session(preflight=preflight, inside=[{"circle_m": [0, 0], "radius_m": 30.0}])
    session.hear(system_time(0.0))
    session.go_on(8.0)
    assert not session.preflight.ended(3)
    session.go_on(4.0)
    ended, failed, told = session.end()
    words = "fence not answered (no answer, though it was asked 6 times)"
    assert ended
    assert told == [("warning", f"Check list: clock right; {words}")]
    assert failed.startswith(f"Fails its check list and is not armed: {words}") == (preflight == "enforce")


def test_who_takes_no_fence_is_named_and_flies_without() -> None:
    session = Session(outside=[{"polygon_m": [[0, 0], [9, 0], [9, 9]]}])
    session.hear(system_time(0.0))
    session.go_on(0.2)
    session.hear(mav.MAVLink_mission_ack_message(255, 190, mav.MAV_MISSION_UNSUPPORTED, mav.MAV_MISSION_TYPE_FENCE))
    session.go_on(0.2)
    assert session.end() == (True, "", [("info", "Check list: clock right; fence not taken: it flies without")])


@pytest.mark.parametrize(("number", "note"), [(2.0, ""), (0.0, "; GF_ACTION is 0: by itself it keeps no fence")])
def test_one_that_keeps_no_fence_by_itself_is_named(number: float, note: str) -> None:
    session = Session(inside=[{"circle_m": [0, 0], "radius_m": 30.0}])
    session.hear(system_time(0.0))
    (item,) = session.preflight._lists[3].clients["fence"].items
    session.go_on(0.2)
    kind = mav.MAV_MISSION_TYPE_FENCE
    session.hear(mav.MAVLink_mission_count_message(255, 190, 1, kind))
    session.go_on(0.2)
    whole = (255, 190, 0, item.frame, item.command, 0, 1, item.param1, 0, 0, 0, item.x, item.y, item.z, kind)
    session.hear(mav.MAVLink_mission_item_int_message(*whole))
    session.go_on(0.2)
    assert session.sent[-1] == "PARAM_REQUEST_READ"
    assert not session.preflight.ended(3)
    session.hear(mav.MAVLink_param_value_message(b"GF_ACTION", number, mav.MAV_PARAM_TYPE_REAL32, 1, 0))
    session.go_on(0.2)
    assert session.end() == (True, "", [("info", f"Check list: clock right; fence there already{note}")])


def test_nobody_is_armed_before_its_list_has_ended_and_who_fails_is_left_out() -> None:
    arming, ground = ArmingSequence(3, 2.5), view(armed=False, landed=True, p_ned=(0.0, 0.0, 0.0))
    arming.checked = False
    for k in range(30):
        assert arming.decide(ground, 0.1 * k)[0] == []
    assert arming.stage is Stage.ARM
    arming.checked, arming.unfit = True, "Fails its check list"
    assert arming.decide(ground, 3.0)[0] == []
    assert (arming.stage, arming.left_out) == (Stage.DOWN, "Fails its check list")
    arming.unfit = ""
    arming.rejoin()
    commands = [command for k in range(30) for command in arming.decide(ground, 4.0 + 0.1 * k)[0]]
    assert commands[0].command == mav.MAV_CMD_COMPONENT_ARM_DISARM


@pytest.mark.parametrize(("runs", "passes"), [(3.0, True), (2.8, True), (2.6, False), (1.0, False), (9.0, False)])
def test_at_another_speed_its_own_time_must_keep_the_sessions(runs: float, passes: bool) -> None:
    """`runs` times real time, beside a session at three times."""
    session = Session(speed=3.0)
    for _ in range(60):
        boot_ms = round(1e3 * session.now_s * runs / 3.0)
        session.hear(mav.MAVLink_attitude_message(5000 + boot_ms, 0, 0, 0, 0, 0, 0))
        session.go_on(0.1)
    ended, failed, _ = session.end()
    assert ended
    (item,) = session.preflight.items(3)
    assert (item.key, item.passed) == ("pace", passes)
    assert item.text.startswith(f"runs {runs:.1f} times as fast as real time")
    assert bool(failed) is not passes
    assert session.sent == []  # no SYSTEM_TIME: at three times real time it is nobody's


def test_its_pace_is_that_of_the_wall_clock_where_the_session_falls_behind() -> None:
    """Four PX4s that start beside a busy session: its ticks took five times as long as they should."""
    session = Session(speed=3.0)
    for _ in range(60):
        said_s = 5.0 * session.now_s
        boot_ms = 5000 + round(1e3 * said_s)
        session.hear(mav.MAVLink_attitude_message(boot_ms, 0, 0, 0, 0, 0, 0), said_s=said_s)
        session.go_on(0.1)
    ended, failed, _ = session.end()
    assert (ended, failed) == (True, "")
    (item,) = session.preflight.items(3)
    assert (item.passed, item.text) == (True, "runs 3.0 times as fast as real time")


def test_who_does_not_tell_its_own_time_cannot_be_followed_at_another_speed() -> None:
    session = Session(speed=2.0)
    session.go_on(31.0)
    ended, failed, _ = session.end()
    assert ended
    assert "does not tell its own time" in failed


WAY = [
    {"command": mav.MAV_CMD_NAV_WAYPOINT, "params": [0.0, 0.0, 0.0, None, 47.0, 8.0 + 1e-4 * k, 5.0]} for k in (1, 2)
]
PLAN = mav.MAV_MISSION_TYPE_MISSION


def read_as(session: Session, height_m: float) -> None:
    """It says that it has two items, the second one at another height."""
    session.hear(mav.MAVLink_mission_count_message(255, 190, 2, PLAN))
    for seq in range(2):
        session.go_on(0.1)
        session.hear(mav.MAVLink_mission_item_int_message(
            255, 190, seq, 3, mav.MAV_CMD_NAV_WAYPOINT, 0, 1, 0.0, 0.0, 0.0, float("nan"), 470000000,
            80000000 + 1000 * (seq + 1), height_m if seq else 5.0, PLAN,
        ))  # fmt: skip
    session.go_on(0.1)


@pytest.mark.parametrize("preflight", ["enforce", "warn"])
def test_one_whose_mission_reads_otherwise_than_it_was_written_does_not_begin(preflight: str) -> None:
    session = Session(preflight=preflight, mission=WAY)
    session.hear(system_time(0.0))
    for _ in range(4):  # found, and written three times
        session.go_on(0.1)
        read_as(session, 7.0)
        session.hear(mav.MAVLink_mission_ack_message(255, 190, mav.MAV_MISSION_ACCEPTED, PLAN))
    session.go_on(0.1)
    ended, failed, _ = session.end()
    assert ended
    assert failed == (
        "Does not begin, and is not armed: mission not kept as it was written (read back, item 2 NAV_WAYPOINT: "
        "Altitude 5 is 7), the one before it is in plan-before-3.plan"
    )


def test_one_that_has_its_mission_already_passes() -> None:
    session = Session(mission=WAY)
    session.hear(system_time(0.0))
    session.go_on(0.1)
    read_as(session, 5.0)
    assert session.end()[:2] == (True, "")
    assert "MISSION_COUNT" not in session.sent
