"""Messages of other ground stations: which reach a vehicle, which take it, and what is recorded."""

from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from gcs.link.forwarder import FromStation
from gcs.mavlink import codec
from gcs.mavlink.codec import Frame, Message
from gcs.refuelling.relay import Relay
from gcs.supervisor.forwarding import MOST_AT_ONCE, ForwardedControl, passed

VEHICLES = (1, 2)


def frame(message: Any, sysid: int = 245, compid: int = 190) -> Frame:
    (one,) = codec.split(bytes(message.pack(mav.MAVLink(None, srcSystem=sysid, srcComponent=compid)))).frames
    return one


def command(number: int, sysid: int = 1) -> Any:
    return mav.MAVLink_command_long_message(sysid, 1, number, 0, 0, 0, 0, 0, 0, 0, 0)


def point(sysid: int = 1) -> Any:
    return mav.MAVLink_set_position_target_local_ned_message(0, sysid, 1, 1, 3576, 1, 2, -3, 0, 0, 0, 0, 0, 0, 0, 0)


@pytest.mark.parametrize(
    ("message", "name", "takes"),
    [
        (command(mav.MAV_CMD_NAV_LAND), "NAV_LAND", True),
        (command(mav.MAV_CMD_DO_SET_MODE), "DO_SET_MODE", True),
        (command(mav.MAV_CMD_COMPONENT_ARM_DISARM), "COMPONENT_ARM_DISARM", True),
        (command(60_000), "command 60000", True),  # nobody knows what it does
        (command(mav.MAV_CMD_REQUEST_MESSAGE), "REQUEST_MESSAGE", False),
        (point(), "SET_POSITION_TARGET_LOCAL_NED", True),
        (mav.MAVLink_manual_control_message(1, 0, 0, 500, 0, 0), "MANUAL_CONTROL", True),
        (mav.MAVLink_param_request_list_message(1, 1), "PARAM_REQUEST_LIST", False),
        (mav.MAVLink_param_set_message(1, 1, b"RTL_ALT", 3.0, 9), "PARAM_SET", True),
    ],
)
def test_a_message_that_names_a_vehicle_passes_and_takes_it_if_it_flies(message: Any, name: str, takes: bool) -> None:
    one = passed(frame(message), VEHICLES)
    assert one is not None
    assert (one.sysid, one.name, one.takes) == (1, name, takes)
    assert isinstance(one.message, Relay)


@pytest.mark.parametrize(
    "message",
    [
        mav.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3),
        command(mav.MAV_CMD_NAV_LAND, sysid=0),
        command(mav.MAV_CMD_NAV_LAND, sysid=9),
        command(mav.MAV_CMD_SET_MESSAGE_INTERVAL),
        command(mav.MAV_CMD_USER_1),
        mav.MAVLink_request_data_stream_message(1, 1, 0, 4, 1),
        mav.MAVLink_setup_signing_message(1, 1, bytes(32), 1),
    ],
)
def test_what_names_nobody_or_would_be_fought_over_does_not_pass(message: Any) -> None:
    assert passed(frame(message), VEHICLES) is None


def test_who_pretends_to_be_a_vehicle_does_not_pass() -> None:
    assert passed(frame(command(mav.MAV_CMD_NAV_LAND), sysid=2), VEHICLES) is None


def test_a_station_with_our_own_id_speaks_in_our_numbers() -> None:
    """A vehicle on the supervised link waits for each number of its supervisor's."""
    one = passed(frame(command(mav.MAV_CMD_NAV_LAND), sysid=255), VEHICLES)
    assert one is not None
    assert isinstance(one.message, Message)
    raw = codec.frame(one.message, 7, 255, 190)
    assert codec.fields(codec.split(raw).frames[0]).command == mav.MAV_CMD_NAV_LAND


class Asked:
    """An operator that takes each release once, and notes."""

    def __init__(self, arming: dict[int, Any]) -> None:
        self.arming = arming
        self.noted: list[str] = []

    def obey(self, content: Any, _: Any) -> Any:
        self.arming[content["sysid"]].released = True
        return type("Reply", (), {"taken": True}), "released"

    def note(self, _: float, command: str, reply: Any, sysid: int) -> str:
        self.noted.append(f"{command} {sysid}: {reply.text}")
        return "noted"


def test_it_is_told_once_who_said_what_and_no_more_passes_than_a_tick_can_carry() -> None:
    arming = {1: type("Arming", (), {"released": False})()}
    operator = Asked(arming)
    view = type("View", (), {"alive": True, "label": "pursuer 1"})
    snapshot: Any = type("Snapshot", (), {"time_s": 5.0, "vehicle": staticmethod(lambda _: view)})
    control = ForwardedControl(arming, operator)  # type: ignore[arg-type]
    flood = [FromStation(frame(point()), "245/190 at udpin:127.0.0.1:14551")] * 500
    events = control.receive(flood, snapshot)
    assert events == ["released", "noted"]
    assert operator.noted == [
        "forward 1: SET_POSITION_TARGET_LOCAL_NED to pursuer 1 by 245/190 at udpin:127.0.0.1:14551"
    ]
    assert len(control.pop(1)) == MOST_AT_ONCE
    assert control.pop(1) == []
