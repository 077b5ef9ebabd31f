"""The battery of a vehicle that another autopilot flies: what it answers, leaves to the autopilot, and takes."""

from __future__ import annotations

from typing import Any

import pytest
from pymavlink.dialects.v20 import common

from simvehicle.autopilot.energy_transfer import Envelope
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.mavlink.codec import ReceivedFrame, split
from simvehicle.mavlink.real_autopilots.battery_component import BatteryComponent

FRAME = LocalFrame(47.0, 8.0, 400.0)
HERE, STILL = (0.0, 0.0, -5.0), (0.0, 0.0, 0.0)
GIVER = 201


class Cells:
    drawn_j, remaining_j = 1234.0, 5000.0
    electric = (15.2, 12.5)

    def charge(self, joules: float) -> None:
        self.remaining_j += joules


def frame(message: Any, sysid: int = 255, compid: int = 190) -> ReceivedFrame:
    (one,) = split(bytes(message.pack(common.MAVLink(None, sysid, compid))))
    return one


def command(role: int, limit_j: float = 3000.0, start_j: float = 700.0, number: int = common.MAV_CMD_USER_1) -> Any:
    return frame(common.MAVLink_command_long_message(7, 1, number, 0, GIVER, role, limit_j, 2000.0, 5, start_j, 0))


def follow(distance_m: float, east_m_s: float = 0.0) -> ReceivedFrame:
    lat, lon, alt = FRAME.to_global(distance_m, 0.0, -5.0)
    zeros, v_ned = [0.0, 0.0, 0.0], [0.0, east_m_s, 0.0]
    content = common.MAVLink_follow_target_message(
        0, 3, round(lat * 1e7), round(lon * 1e7), alt, v_ned, zeros, [1.0, 0.0, 0.0, 0.0], zeros, zeros, 0
    )
    return frame(content, GIVER, 1)


def counter(name: str, value: int) -> ReceivedFrame:
    return frame(common.MAVLink_named_value_int_message(0, name.encode(), value), GIVER, 1)


def battery(cells: Cells) -> BatteryComponent:
    return BatteryComponent(cells, 7, FRAME, Envelope(1.5, 0.5), capacity_j=10_000.0, initial_j=6000.0)


def test_it_leaves_to_the_autopilot_what_is_not_the_battery_s() -> None:
    one = battery(Cells())
    for other in (
        command(1, number=common.MAV_CMD_COMPONENT_ARM_DISARM),
        frame(common.MAVLink_param_request_read_message(7, 1, b"WPNAV_SPEED", -1)),
        frame(common.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3)),
    ):
        assert one.receive(other, 1.0, HERE, STILL) is None
    asked = frame(common.MAVLink_param_request_read_message(7, 1, b"SIM_BAT_CAP_J", -1))
    (answer,) = one.receive(asked, 1.0, HERE, STILL) or []
    assert (answer.param_id, answer.param_value) == ("SIM_BAT_CAP_J", 10_000.0)


def test_it_tells_what_the_plant_s_cells_have() -> None:
    one = battery(Cells())
    said = {type(content).__name__: content for content in one.move(0.1, 0.1, HERE)}
    status = said["BATTERY_STATUS"]
    assert (status.energy_consumed, status.battery_remaining, status.current_battery) == (12, 50, 1250)
    assert sum(status.voltages[:4]) == pytest.approx(15200, abs=4)
    assert (said["NAMED_VALUE_INT"].name, said["NAMED_VALUE_INT"].value) == ("XferIn", 0)
    assert one.move(0.2, 0.1, HERE) == []


@pytest.mark.parametrize(("east_m_s", "said"), [(0.99, []), (1.01, ["Received 0 J: the giver moves at 1.0 m/s"])])
def test_a_transfer_under_way_holds_at_up_to_twice_the_speed_at_which_it_may_begin(
    east_m_s: float, said: list[str]
) -> None:
    """Its giver flies on, as where the autopilot turns round a corner before it."""
    one = battery(Cells())
    one.receive(follow(0.5, east_m_s), 0.0, HERE, STILL)
    refused = one.receive(command(2), 0.1, HERE, STILL) or []
    assert refused[1].text == f"Transfer refused: the giver moves at {east_m_s:.1f} m/s"
    one.receive(follow(0.5, 0.49), 0.2, HERE, STILL)
    assert (one.receive(command(2), 0.3, HERE, STILL) or [])[0].result == common.MAV_RESULT_ACCEPTED
    one.receive(follow(0.5, east_m_s), 0.4, HERE, STILL)
    assert [content.text for content in one.move(0.4, 0.1, HERE) if hasattr(content, "text")] == said


def test_it_takes_what_a_giver_near_by_reports_and_not_a_joule_more() -> None:
    cells = Cells()
    one = battery(cells)
    refused = one.receive(command(2), 0.0, HERE, STILL) or []
    assert refused[0].result == common.MAV_RESULT_TEMPORARILY_REJECTED
    assert "the giver is silent" in refused[1].text
    assert one.receive(follow(1.0), 0.1, HERE, STILL) == []
    accepted = one.receive(command(2), 0.2, HERE, STILL) or []
    assert accepted[0].result == common.MAV_RESULT_ACCEPTED
    one.receive(counter("XferOut", 1700), 0.3, HERE, STILL)
    one.receive(follow(1.0), 0.3, HERE, STILL)
    one.move(0.3, 0.1, HERE)
    one.move(0.4, 0.1, HERE)
    assert (one.exchange.received_j, cells.remaining_j) == (1000, 6000.0)
    one.receive(follow(3.0), 0.5, HERE, STILL)
    ended = [content.text for content in one.move(0.5, 0.1, HERE) if hasattr(content, "text")]
    assert ended == ["Received 1000 J: the giver is 3.0 m away"]
    stopped = one.receive(command(0, 0.0), 0.6, HERE, STILL) or []
    assert stopped[0].result == common.MAV_RESULT_ACCEPTED
    assert (one.receive(command(1), 0.7, HERE, STILL) or [])[0].result == common.MAV_RESULT_DENIED
