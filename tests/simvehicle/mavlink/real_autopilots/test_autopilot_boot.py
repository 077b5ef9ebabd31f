"""Boot of an ArduPilot: what it is asked, and when it counts as ready."""

from __future__ import annotations

from typing import Any

import pytest
from pymavlink.dialects.v20 import common

from simvehicle.mavlink.codec import ReceivedFrame, encode, split
from simvehicle.mavlink.real_autopilots.autopilot_boot import ARDUCOPTER_BOOT, PX4_BOOT, AutopilotBoot

COPTER = 7
PREARM = common.MAV_SYS_STATUS_PREARM_CHECK


def said(message: Any) -> ReceivedFrame:
    (frame,) = split(bytes(message.pack(common.MAVLink(None, COPTER, 1))))
    return frame


def heartbeat(mode: int, kind: int = 2, autopilot: int = 3) -> ReceivedFrame:
    return said(common.MAVLink_heartbeat_message(kind, autopilot, 1, mode, 3, 3))


def status(health: int, millivolts: int = 12600) -> ReceivedFrame:
    return said(common.MAVLink_sys_status_message(PREARM, PREARM, health, 0, millivolts, 0, -1, 0, 0, 0, 0, 0, 0))


def home() -> ReceivedFrame:
    return said(common.MAVLink_home_position_message(473977420, 85455940, 488000, 0, 0, 0, [1, 0, 0, 0], 0, 0, 0))


def asked(boot: AutopilotBoot, now_s: float) -> list[tuple[int, float, float]]:
    """(command, params 1 and 2) as pymavlink reads them."""
    link = common.MAVLink(None)
    frames = b"".join(encode(content, seq=0, sysid=255, compid=190) for content in boot.requests(now_s))
    messages = link.parse_buffer(frames) or []
    assert {m.target_system for m in messages} <= {COPTER}
    return [(m.command, m.param1, m.param2) for m in messages]


def test_it_is_asked_for_guided_and_its_home_until_it_has_them_and_for_its_checks_twice_a_second() -> None:
    boot = AutopilotBoot(COPTER, ARDUCOPTER_BOOT)
    place = (common.MAV_CMD_REQUEST_MESSAGE, float(common.MAVLINK_MSG_ID_HOME_POSITION), 0.0)
    checks = (common.MAV_CMD_REQUEST_MESSAGE, float(common.MAVLINK_MSG_ID_SYS_STATUS), 0.0)
    guided = (common.MAV_CMD_DO_SET_MODE, float(common.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED), 4.0)
    assert asked(boot, 0.0) == [checks, place, guided]
    assert asked(boot, 0.4) == []
    boot.receive(heartbeat(0))
    boot.receive(home())
    assert asked(boot, 0.5) == [checks, guided]
    boot.receive(heartbeat(4))
    assert asked(boot, 1.0) == [checks]


def test_it_is_ready_at_a_heartbeat_in_guided_at_home_with_its_checks_passed_and_not_before() -> None:
    boot = AutopilotBoot(COPTER, ARDUCOPTER_BOOT)
    boot.receive(status(PREARM, 30012))
    assert boot.volts == pytest.approx(30.012)
    boot.receive(heartbeat(0))
    assert not boot.ready
    boot.receive(heartbeat(4))
    assert not boot.ready
    boot.receive(home())
    assert not boot.ready
    boot.receive(heartbeat(4))
    assert boot.ready
    boot.receive(status(0))
    assert not boot.ready


def test_its_last_reasons_are_kept_each_once() -> None:
    boot = AutopilotBoot(COPTER, ARDUCOPTER_BOOT)
    assert boot.reasons == ""
    for text in ("PreArm: A", "PreArm: B", "Frame: QUAD", "PreArm: C", "PreArm: D", "PreArm: B"):
        boot.receive(said(common.MAVLink_statustext_message(2, text.encode())))
    assert boot.reasons == "C | D | B"


def test_a_px4_is_asked_into_hold_and_says_why_it_cannot_be_armed() -> None:
    boot, hold = AutopilotBoot(COPTER, PX4_BOOT), 4 << 16 | 3 << 24
    link = common.MAVLink(None)
    frames = b"".join(encode(content, seq=0, sysid=255, compid=190) for content in boot.requests(0.0))
    *_, mode = link.parse_buffer(frames) or []
    assert (mode.param1, mode.param2, mode.param3) == (1.0, 4.0, 3.0)
    boot.receive(heartbeat(4 << 16 | 1 << 24, 2, 12))
    boot.receive(status(PREARM))
    boot.receive(said(common.MAVLink_statustext_message(2, b"Preflight Fail: ekf2 missing data")))
    assert (boot.ready, boot.mismatch, boot.reasons) == (False, "", "ekf2 missing data")
    boot.receive(said(common.MAVLink_statustext_message(4, b"Preflight: not enough GPS Satellites")))
    assert boot.reasons == "ekf2 missing data | not enough GPS Satellites"
    boot.receive(home())
    boot.receive(heartbeat(hold, 2, 12))
    assert boot.ready
