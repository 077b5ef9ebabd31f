"""The switch by which an ArduPilot's receiver loses its fix."""

from __future__ import annotations

from typing import Any

from pymavlink.dialects.v20 import ardupilotmega as mav

from simvehicle.mavlink.codec import ReceivedFrame, split
from simvehicle.mavlink.real_autopilots.gnss_switch import GnssSwitch


def acknowledged(command: int) -> ReceivedFrame:
    (frame,) = split(bytes(mav.MAVLink_command_ack_message(command, 0).pack(mav.MAVLink(None, 7, 1))))
    return frame


def said(switch: GnssSwitch, *, lost: bool) -> list[tuple[Any, ...]]:
    found = switch.settings(lost=lost)
    return [(m.target_system, m.target_component, m.command, m.param1, m.param2) for m in found]


def test_it_is_turned_once_each_time_and_only_its_own_answers_are_kept_back() -> None:
    switch, command = GnssSwitch(7), mav.MAV_CMD_DO_AUX_FUNCTION
    assert said(switch, lost=False) == []
    assert not switch.answers(acknowledged(command))  # another's
    assert said(switch, lost=True) == [(7, 1, command, 65.0, 2.0)]
    assert said(switch, lost=True) == []
    assert not switch.answers(acknowledged(mav.MAV_CMD_COMPONENT_ARM_DISARM))
    assert switch.answers(acknowledged(command))
    assert said(switch, lost=False) == [(7, 1, command, 65.0, 0.0)]
    assert switch.answers(acknowledged(command))
    assert not switch.answers(acknowledged(command))
