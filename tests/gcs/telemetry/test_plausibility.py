"""Vehicles that tell what cannot be: not taken in, named, and of no weight in any decision."""

from __future__ import annotations

import math
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.telemetry.changes import ChangeDetector
from gcs.telemetry.fleet import Fleet, GlobalOrigin
from gcs.telemetry.health import ACT, HealthIssue, health_issues
from gcs.telemetry.plausibility import DOUBTED_S, FASTEST_M_S, JUMP_M
from gcs.telemetry.state import VehicleView
from gcs.telemetry.track import Member
from skytender.safety.traffic import MOST_TRAFFIC, TRAFFIC_FORGOTTEN_S

ORIGIN = GlobalOrigin(47.397742, 8.545594, 488.0)
HERE = {"latitude": 473977420, "longitude": 85455940, "altitude": 488000}
HUGE = 3.4e38


def frame(kind: str, **fields: Any) -> codec.Frame:
    """A message of vehicle 7 as pymavlink sends it."""
    cls = getattr(mav, f"MAVLink_{kind.lower()}_message")
    arrays = {"voltages": [65535] * 10, "voltages_ext": [0] * 4} if kind == "BATTERY_STATUS" else {}
    arrays |= {"q": [1.0, 0.0, 0.0, 0.0]} if kind == "HOME_POSITION" else {}
    content = dict.fromkeys(cls.fieldnames, 0) | {"mavlink_version": 3} | arrays | fields
    raw = cls(**{name: content[name] for name in cls.fieldnames}).pack(mav.MAVLink(None, 7, 1))
    return codec.split(bytes(raw)).frames[0]


def place(n: float, e: float = 0.0, d: float = -5.0, vn: float = 0.0) -> codec.Frame:
    return frame("LOCAL_POSITION_NED", x=n, y=e, z=d, vx=vn)


@pytest.fixture
def fleet() -> Fleet:
    """Vehicle 7, external, in the air at (1, 0, -5), its battery and its frame known."""
    made = Fleet([Member(7, "pursuer", "pursuer 7", 20_000.0, 18_000.0, external=True)], ORIGIN)
    for one in (
        frame("HEARTBEAT", type=2, autopilot=12, base_mode=0x81, custom_mode=6 << 16),
        frame("GPS_GLOBAL_ORIGIN", **HERE), place(1.0), frame("EXTENDED_SYS_STATE", landed_state=2),
        frame("BATTERY_STATUS", energy_consumed=10, battery_remaining=90, current_battery=-1),
    ):  # fmt: skip
        made.ingest(one, 0.0)
    return made


def view(fleet: Fleet, at_s: float) -> VehicleView:
    return fleet.snapshot(at_s).vehicle(7)


LIES = [
    (place(HUGE), "its position is more than 1000 km away"),
    (place(math.nan), "its position is no number"),
    (place(1.0, vn=HUGE), "its velocity is above 300 m/s"),
    (place(1.0 + JUMP_M + FASTEST_M_S * 0.1 + 1.0), "its position jumps by 41 m"),
    (frame("BATTERY_STATUS", energy_consumed=2**31 - 1, battery_remaining=50, current_battery=-1), "drawn 2.15e+11 J"),
    (frame("BATTERY_STATUS", energy_consumed=-1, voltages=[65534] * 10, current_battery=32767), "draws 2.15e+05 W"),
    (frame("NAMED_VALUE_INT", name=b"XferIn", value=2**31 - 1), "received 2.15e+09 J"),
    (frame("NAMED_VALUE_INT", name=b"XferOut", value=-5), "given -5 J"),
    (frame("PARAM_VALUE", param_id=b"SIM_BAT_CAP_J", param_value=1e-6, param_type=9), "its battery holds 1e-06 J"),
    (frame("PARAM_VALUE", param_id=b"SIM_BAT_INIT_J", param_value=HUGE, param_type=9), "its battery holds 3.4e+38 J"),
    (frame("GPS_GLOBAL_ORIGIN", **HERE | {"latitude": 2**31 - 1}), "its origin lies on no globe"),
    (frame("HOME_POSITION", **HERE | {"longitude": -(2**31)}), "its origin lies on no globe"),
]  # fmt: skip


@pytest.mark.parametrize(("lie", "words"), LIES)
def test_what_cannot_be_is_not_taken_in_and_its_teller_is_named(fleet: Fleet, lie: codec.Frame, words: str) -> None:
    before = view(fleet, 0.1)
    assert before.fresh
    watch = ChangeDetector()
    watch.look(fleet.snapshot(0.1), {})
    fleet.ingest(lie, 0.1)
    after = view(fleet, 0.1)
    assert words in after.doubt
    assert after._replace(doubt="", last_message_s=before.last_message_s) == before
    assert not after.fresh
    (event,) = watch.look(fleet.snapshot(0.1), {})
    assert (event.level, event.kind, event.text) == ("critical", "link", f"Is not believed: {after.doubt}")
    assert HealthIssue("not believed", ACT) in health_issues(after, 0.1)
    assert watch.look(fleet.snapshot(0.2), {}) == []
    fleet.ingest(place(1.0), 0.1 + DOUBTED_S)
    assert view(fleet, 0.1 + DOUBTED_S).fresh
    assert [event.text for event in watch.look(fleet.snapshot(0.1 + DOUBTED_S), {})] == ["Is believed again"]


def test_a_vehicle_whose_armed_frame_moves_is_doubted_until_it_lies_where_it_lay(fleet: Fleet) -> None:
    """Its positions may be of the one frame or of the other: no time makes that certain."""
    moved = frame("GPS_GLOBAL_ORIGIN", **HERE | {"latitude": 473987420})
    before = view(fleet, 0.1)
    fleet.ingest(moved, 0.1)
    for second in range(1, 60):
        fleet.ingest(place(1.0), float(second))
        after = view(fleet, float(second))
        assert after.doubt == "its origin moves while it is armed"
        assert (after.p_ned, after.fresh) == (before.p_ned, False)
    fleet.ingest(frame("GPS_GLOBAL_ORIGIN", **HERE), 60.0)
    fleet.ingest(frame("HEARTBEAT", type=2, autopilot=12, base_mode=0x81, custom_mode=6 << 16), 60.0)
    fleet.ingest(place(1.0), 60.0)
    assert view(fleet, 60.0).fresh
    fleet.ingest(moved, 61.0)
    fleet.ingest(frame("HEARTBEAT", type=2, autopilot=12, base_mode=0x01, custom_mode=6 << 16), 62.0)
    fleet.ingest(moved, 62.0)
    fleet.ingest(place(1.0), 68.0)
    assert view(fleet, 68.0).fresh
    assert view(fleet, 68.0).p_ned == pytest.approx((1.0 + 111.18, 0.0, -5.0), abs=0.1)


def test_a_jump_is_believed_when_a_vehicle_could_have_flown_it(fleet: Fleet) -> None:
    for tenth in range(1, 40):
        fleet.ingest(place(1001.0), 0.1 * tenth)
    assert view(fleet, 3.9).p_ned == pytest.approx((1001.0, 0.0, -5.0), abs=1e-6)
    assert view(fleet, 0.1).doubt


def test_messages_that_each_can_be_and_together_cannot_are_doubted(fleet: Fleet) -> None:
    for second in range(9):
        fleet.ingest(frame("NAMED_VALUE_INT", name=b"XferIn", value=9_000 * second), float(second))
    assert view(fleet, 9.0).doubt == "by its messages its battery would hold 450 %"


def test_a_sky_full_of_invented_aircraft_costs_a_bounded_room(fleet: Fleet) -> None:
    def aircraft(icao: int) -> codec.Frame:
        return frame("ADSB_VEHICLE", ICAO_address=icao, lat=HERE["latitude"], lon=HERE["longitude"], callsign=b"x")

    for icao in range(4 * MOST_TRAFFIC):
        fleet.ingest(aircraft(icao), 0.0)
    assert len(fleet.snapshot(0.0).traffic) == MOST_TRAFFIC
    later_s = TRAFFIC_FORGOTTEN_S + 1.0
    fleet.ingest(aircraft(1 << 20), later_s)
    assert len(fleet._traffic) == len(fleet.snapshot(later_s).traffic) == 1
