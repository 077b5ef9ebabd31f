"""Frames of any fleet become the messages of the socket. Frames are pymavlink's; places are worked out with pymap3d."""

from __future__ import annotations

import json
import math
from typing import Any

import pymap3d
import pytest
from pymavlink.dialects.v20 import ardupilotmega as mav

from gcs.mavlink import codec
from gcs.mavlink.gaps import MOST_SENDERS
from gcs.session.observer import MOST_EVENTS, Observer
from gcs.telemetry.events import Event

LAT, LON, ALT = 47.0, 8.0, 400.0
PX4, ARDUPILOT = mav.MAV_AUTOPILOT_PX4, mav.MAV_AUTOPILOT_ARDUPILOTMEGA
QUADROTOR = mav.MAV_TYPE_QUADROTOR
_SEQ: dict[tuple[int, int], int] = {}


def frame(kind: str, sysid: int = 1, compid: int = 1, **fields: Any) -> codec.Frame:
    """One message as pymavlink sends it, numbered by its sender."""
    sender = mav.MAVLink(None, srcSystem=sysid, srcComponent=compid)
    sender.seq = _SEQ.get((sysid, compid), 0)
    _SEQ[sysid, compid] = (sender.seq + 1) % 256
    cls = getattr(mav, f"MAVLink_{kind.lower()}_message")
    content = dict.fromkeys(cls.fieldnames, 0) | {"mavlink_version": 3} | fields
    raw = cls(**{name: content[name] for name in cls.fieldnames}).pack(sender)
    return codec.split(bytes(raw)).frames[0]


def beat(sysid: int = 1, *, autopilot: int = PX4, kind: int = QUADROTOR, mode: int = 4 << 16 | 3 << 24,
         armed: bool = False, status: int = 3, compid: int = 1) -> codec.Frame:  # fmt: skip
    base = 0x81 if armed else 0x01
    return frame("HEARTBEAT", sysid, compid, type=kind, autopilot=autopilot, base_mode=base, custom_mode=mode,
                 system_status=status)  # fmt: skip


def local(n: float, e: float, d: float, sysid: int = 1, t_ms: int = 0) -> codec.Frame:
    return frame("LOCAL_POSITION_NED", sysid, time_boot_ms=t_ms, x=n, y=e, z=d, vx=0.5, vy=0.0, vz=0.0)


def placed(kind: str, n: float, e: float, d: float, sysid: int = 1, **fields: Any) -> codec.Frame:
    """A message about the place at (n, e, d) of the test's own frame."""
    lat, lon, alt = (float(x) for x in pymap3d.ned2geodetic(n, e, d, LAT, LON, ALT))
    lat_e7, lon_e7, alt_mm = round(1e7 * lat), round(1e7 * lon), round(1e3 * alt)
    if kind == "GLOBAL_POSITION_INT":
        return frame(kind, sysid, lat=lat_e7, lon=lon_e7, alt=alt_mm, **fields)
    more = {"q": [1.0, 0.0, 0.0, 0.0]} if kind == "HOME_POSITION" else {}
    return frame(kind, sysid, latitude=lat_e7, longitude=lon_e7, altitude=alt_mm, **more, **fields)


@pytest.fixture
def observer() -> Observer:
    return Observer("monitor", "udpin:127.0.0.1:14550")


def shown(observer: Observer, t_s: float) -> dict[str, Any]:
    observer.look(t_s)
    return observer.snapshot(t_s, speed=1.0, phase="flying")


def rows(observer: Observer, t_s: float) -> dict[int, dict[str, Any]]:
    snapshot = shown(observer, t_s)
    json.dumps(snapshot, allow_nan=False)
    return {row["sysid"]: row for row in snapshot["vehicles"]}


def test_a_vehicle_is_who_sends_a_vehicles_heartbeat(observer: Observer) -> None:
    observer.receive(local(1.0, 2.0, 3.0, sysid=9), 0.0)
    observer.receive(beat(255, kind=mav.MAV_TYPE_GCS, autopilot=mav.MAV_AUTOPILOT_INVALID, compid=190), 0.0)
    observer.receive(beat(1, kind=mav.MAV_TYPE_CAMERA, autopilot=mav.MAV_AUTOPILOT_INVALID, compid=100), 0.0)
    observer.receive(beat(40, kind=mav.MAV_TYPE_ADSB, autopilot=mav.MAV_AUTOPILOT_INVALID, compid=156), 0.0)
    observer.receive(beat(1), 0.1)
    observer.receive(beat(2, autopilot=ARDUPILOT, kind=mav.MAV_TYPE_FIXED_WING), 0.2)
    observer.receive(beat(3, kind=mav.MAV_TYPE_GROUND_ROVER, autopilot=mav.MAV_AUTOPILOT_GENERIC), 0.2)
    observer.receive(beat(1, kind=mav.MAV_TYPE_GIMBAL, autopilot=mav.MAV_AUTOPILOT_INVALID, compid=154), 0.3)
    found = rows(observer, 0.5)
    told = {sysid: (row["role"], row["label"], row["autopilot"]) for sysid, row in found.items()}
    assert told == {
        1: ("copter", "copter 1", "px4"),
        2: ("plane", "plane 2", "ardupilot"),
        3: ("rover", "rover 3", "generic"),
    }
    assert [v["sysid"] for v in observer.session()["vehicles"]] == [1, 2, 3]


def test_a_vehicle_of_system_id_0_is_named_once(observer: Observer) -> None:
    for t_s in (0.1, 1.1):
        observer.receive(beat(0), t_s)
        observer.receive(local(1.0, 2.0, -3.0, sysid=0), t_s)
    observer.receive(frame("HEARTBEAT", 0, 190, type=mav.MAV_TYPE_GCS, autopilot=8), 1.2)
    snapshot = shown(observer, 2.0)
    assert snapshot["vehicles"] == []
    (event,) = snapshot["events"]
    assert event["text"].startswith("A vehicle sends with system id 0")


def test_the_session_is_told_anew_when_somebody_joins(observer: Observer) -> None:
    assert observer.changed
    assert observer.session()["vehicles"] == []
    assert not observer.changed
    observer.receive(beat(7), 0.0)
    assert observer.changed
    assert observer.session()["vehicles"][0] == {
        "sysid": 7, "role": "copter", "label": "copter 7", "capacity_j": None, "path_ned": [],
        "colour": 6}  # fmt: skip


def test_a_vehicle_that_tells_only_global_positions_has_a_place_and_a_speed(observer: Observer) -> None:
    observer.receive(beat(5, autopilot=ARDUPILOT, mode=3, armed=True, status=4), 0.0)
    observer.receive(placed("GLOBAL_POSITION_INT", 0.0, 0.0, -10.0, 5, relative_alt=10_000), 0.5)
    assert rows(observer, 0.5)[5]["p_ned"] is None  # its own origin may still come
    observer.receive(placed("GLOBAL_POSITION_INT", 0.0, 0.0, -10.0, 5, relative_alt=10_000), 4.0)
    observer.receive(placed("GLOBAL_POSITION_INT", 6.0, 8.0, -12.0, 5, relative_alt=12_000, vx=300, vy=400, vz=0), 4.5)
    row = rows(observer, 4.6)[5]
    assert row["p_ned"] == pytest.approx((6.0, 8.0, -12.0), abs=0.03)
    assert (row["speed_m_s"], row["height_m"]) == (5.0, pytest.approx(12.0, abs=0.03))
    assert row["age_s"] == pytest.approx(0.1)


def test_a_zero_of_heights_that_was_taken_too_soon_is_decided_again_and_the_page_is_told(observer: Observer) -> None:
    """An ArduPilot before its estimate has begun: alt is the barometer's height above where it was switched on."""
    lat_e7, lon_e7 = round(1e7 * LAT), round(1e7 * LON)
    early = {"lat": lat_e7, "lon": lon_e7, "alt": 420, "relative_alt": 410}
    for t_s in (0.1, 3.5):
        observer.receive(beat(1, autopilot=ARDUPILOT, mode=4), t_s)
        observer.receive(frame("GLOBAL_POSITION_INT", **early), t_s)
    observer.receive(
        frame("ADSB_VEHICLE", sysid=255, ICAO_address=7, lat=lat_e7, lon=lon_e7, altitude=450_000, callsign=b"x"), 3.5
    )
    first = shown(observer, 3.5)
    assert first["vehicles"][0]["height_m"] == pytest.approx(0.41)
    assert first["vehicles"][0]["trouble"] == ["position uncertain"]
    assert observer.session()["origin"] == pytest.approx((LAT, LON, 0.0), abs=0.02)
    observer.receive(frame("GLOBAL_POSITION_INT", **early | {"alt": 400_400, "relative_alt": 400}), 4.0)
    then = shown(observer, 4.0)
    assert then["vehicles"][0]["height_m"] == pytest.approx(0.4)
    assert then["vehicles"][0]["trouble"] == []
    assert then["traffic"][0]["p_ned"] == pytest.approx((0.0, 0.0, -50.0), abs=0.02)
    texts = [event["text"] for event in first["events"] + then["events"] if event["kind"] == "link"]
    assert texts[1:] == [
        "Its position is uncertain: it does not know its height above the sea yet",
        "Knows its height above the sea: heights begin at 400 m, not at 0 m",
        "Its position is certain now",
    ]
    assert observer.changed
    assert observer.session()["origin"] == pytest.approx((LAT, LON, ALT))


def test_a_zero_at_a_mere_place_moves_to_where_the_vehicle_says_that_it_begins(observer: Observer) -> None:
    """An ArduPilot without a fix drifts around 0, 0; its home comes with the fix."""
    adrift = {"lat": 5, "lon": 35, "alt": 120, "relative_alt": 123}
    for t_s in (0.1, 3.5):
        observer.receive(beat(1, autopilot=ARDUPILOT, mode=4), t_s)
        observer.receive(frame("GLOBAL_POSITION_INT", **adrift), t_s)
    assert observer.session()["origin"] == pytest.approx((0.0, 0.0, 0.0), abs=0.02)
    observer.receive(placed("HOME_POSITION", 0.0, 0.0, 0.0), 4.0)
    observer.receive(frame("ADSB_VEHICLE", sysid=255, ICAO_address=7, lat=round(1e7 * LAT), lon=round(1e7 * LON),
                           altitude=450_000, callsign=b"x"), 4.1)  # fmt: skip
    for k in range(40):
        observer.receive(placed("GLOBAL_POSITION_INT", 3.0, 4.0, -2.0, relative_alt=2000), 4.2 + 0.2 * k)
    then = shown(observer, 12.0)
    assert then["vehicles"][0]["p_ned"] == pytest.approx((3.0, 4.0, -2.0), abs=0.02)
    assert then["traffic"] == [] or then["traffic"][0]["p_ned"] == pytest.approx((0.0, 0.0, -50.0), abs=0.02)
    assert observer.session()["origin"] == pytest.approx((LAT, LON, ALT))
    assert any(event["text"].startswith("Says where it begins: ") for event in then["events"])


def test_heights_begin_where_the_vehicle_says_not_where_its_heights_once_differed(observer: Observer) -> None:
    """The two heights of GLOBAL_POSITION_INT are filtered apart: one pair of them may be metres off."""
    for t_s, above_home in ((0.1, 0), (3.5, 2152)):
        observer.receive(beat(1, autopilot=ARDUPILOT, mode=4), t_s)
        observer.receive(placed("GLOBAL_POSITION_INT", 0.0, 0.0, 0.0, relative_alt=above_home), t_s)
    assert rows(observer, 3.6)[1]["height_m"] == pytest.approx(2.152)
    observer.receive(placed("HOME_POSITION", 0.0, 0.0, 0.0), 4.0)
    assert rows(observer, 4.1)[1]["height_m"] == pytest.approx(0.0, abs=1e-6)
    observer.receive(placed("HOME_POSITION", 50.0, 0.0, -7.0), 5.0)
    assert observer.session()["origin"] == pytest.approx((LAT, LON, ALT)), "an operator moves home; the zero stays"


@pytest.mark.parametrize(
    ("satellites_m", "fix", "trouble"),
    [
        (0.6, 3, []),
        (0.6, 2, ["position uncertain"]),
        (27.2, 3, ["position uncertain"]),
        (None, 0, ["position uncertain"]),
    ],
)
def test_satellites_tell_a_home_at_the_coast_from_a_height_that_is_not_known(
    observer: Observer, satellites_m: float | None, fix: int, trouble: list[str]
) -> None:
    lat_e7, lon_e7 = round(1e7 * LAT), round(1e7 * LON)
    for k in range(30):
        t_s = 0.1 + 0.2 * k
        observer.receive(beat(1, autopilot=ARDUPILOT, mode=4), t_s)
        if satellites_m is not None and k < 20:  # what they have said once counts on
            fields = {"lat": lat_e7, "lon": lon_e7, "alt": round(1e3 * (satellites_m + 2.0))}
            observer.receive(frame("GPS_RAW_INT", fix_type=fix, **fields), t_s)
        fields = {"lat": lat_e7, "lon": lon_e7, "alt": 2000, "relative_alt": 2000}
        observer.receive(frame("GLOBAL_POSITION_INT", **fields), t_s)
    row = rows(observer, 6.0)[1]
    assert row["trouble"] == trouble
    assert row["height_m"] == pytest.approx(2.0)


def test_another_vehicles_home_moves_no_zero(observer: Observer) -> None:
    for t_s in (0.1, 3.5):
        observer.receive(beat(1, autopilot=ARDUPILOT, mode=4), t_s)
        observer.receive(beat(2, autopilot=ARDUPILOT, mode=4), t_s)
        observer.receive(placed("GLOBAL_POSITION_INT", 0.0, 0.0, -2.0, relative_alt=2000), t_s)
    observer.receive(placed("HOME_POSITION", 5000.0, 0.0, -90.0, sysid=2), 4.0)
    assert observer.session()["origin"] == pytest.approx((LAT, LON, ALT))


def test_an_aim_in_a_frame_whose_origin_comes_later_stands_where_it_is(observer: Observer) -> None:
    observer.receive(beat(1), 0.0)
    observer.receive(placed("GPS_GLOBAL_ORIGIN", 0.0, 0.0, 0.0), 0.0)
    observer.receive(beat(2), 0.0)
    aim = {"coordinate_frame": mav.MAV_FRAME_LOCAL_NED, "type_mask": 0, "x": 1.0, "y": 2.0, "z": -3.0}
    observer.receive(frame("POSITION_TARGET_LOCAL_NED", 2, **aim), 0.1)
    observer.receive(placed("GLOBAL_POSITION_INT", 40.0, 0.0, -3.0, 2), 0.1)
    assert rows(observer, 0.1)[2]["aim_ned"] is None
    observer.receive(placed("GPS_GLOBAL_ORIGIN", 30.0, -20.0, -5.0, 2), 0.2)
    assert rows(observer, 0.2)[2]["aim_ned"] == pytest.approx((31.0, -18.0, -8.0), abs=0.02)


def test_an_attitude_of_another_boot_makes_the_place_uncertain_until_the_frame_is_told(observer: Observer) -> None:
    observer.receive(beat(1), 0.0)
    observer.receive(placed("GPS_GLOBAL_ORIGIN", 0.0, 0.0, 0.0), 0.0)
    observer.receive(frame("ATTITUDE", time_boot_ms=60_000), 0.0)
    observer.receive(local(1.0, 0.0, 0.0, t_ms=60_000), 0.0)
    assert rows(observer, 0.0)[1]["trouble"] == []
    observer.receive(frame("ATTITUDE", time_boot_ms=1_000), 5.0)
    observer.receive(beat(1), 5.1)
    observer.receive(local(1.0, 0.0, 0.0, t_ms=1_100), 5.1)
    assert rows(observer, 5.1)[1]["trouble"] == ["position uncertain"]
    observer.receive(placed("GPS_GLOBAL_ORIGIN", 30.0, 0.0, 0.0), 5.2)
    observer.receive(local(1.0, 0.0, 0.0, t_ms=1_300), 5.3)
    row = rows(observer, 5.3)[1]
    assert (row["trouble"], row["p_ned"]) == ([], pytest.approx((31.0, 0.0, 0.0), abs=0.02))


def test_a_change_of_mode_is_an_event_and_no_failsafe_since_nobody_here_commands(observer: Observer) -> None:
    observer.receive(beat(1, autopilot=ARDUPILOT, mode=3, armed=True), 0.0)
    rows(observer, 0.0)
    observer.receive(beat(1, autopilot=ARDUPILOT, mode=6, armed=True), 1.0)
    events = shown(observer, 1.0)["events"]
    assert [(e["kind"], e["level"], e["text"]) for e in events] == [("mode", "info", "AUTO -> RTL")]


def test_a_landing_is_a_failsafe_where_the_autopilot_says_so_since_nobody_here_commands(observer: Observer) -> None:
    land = 4 << 16 | 6 << 24
    for sysid, status in ((1, mav.MAV_STATE_ACTIVE), (2, mav.MAV_STATE_CRITICAL)):
        observer.receive(beat(sysid, mode=land, armed=True, status=status), 0.1)
        observer.receive(placed("GLOBAL_POSITION_INT", 0.0, 0.0, -5.0, sysid), 0.2)
    found = rows(observer, 0.3)
    assert (found[1]["condition"], "Land" in found[1]["trouble"]) == ("warned", True)
    assert (found[2]["condition"], "failsafe: Land" in found[2]["trouble"]) == ("failing", True)


def test_a_battery_of_unknown_capacity_is_a_share_and_no_joules(observer: Observer) -> None:
    """11.5 V and 10 A are 115 W; 8 % is trouble."""
    observer.receive(beat(1, autopilot=ARDUPILOT, mode=4), 0.0)
    observer.receive(frame("BATTERY_STATUS", voltages=[11_500, *[65535] * 9], voltages_ext=[0] * 4,
                        current_battery=1000, energy_consumed=-1, current_consumed=-1,
                        battery_remaining=8), 0.1)  # fmt: skip
    row = rows(observer, 0.2)[1]
    assert (row["battery"], row["remaining_j"], row["endurance_s"]) == (0.08, None, None)
    assert (row["power_w"], row["energy_source"]) == (pytest.approx(115.0), "battery_remaining")
    assert row["trouble"][0] == "battery 8 %"
    assert row["severity"] == 2


def test_a_capacity_that_the_vehicle_tells_makes_joules_of_it(observer: Observer) -> None:
    observer.receive(beat(1), 0.0)
    for name, value in (("SIM_BAT_CAP_J", 24_000.0), ("SIM_BAT_INIT_J", 18_000.0)):
        observer.receive(frame("PARAM_VALUE", param_id=name.encode(), param_value=value, param_type=9), 0.1)
    observer.receive(frame("BATTERY_STATUS", voltages=[65535] * 10, voltages_ext=[0] * 4, current_battery=-1,
                        current_consumed=-1, energy_consumed=60, battery_remaining=50), 0.2)  # fmt: skip
    row = rows(observer, 0.2)[1]
    assert (row["remaining_j"], row["battery"]) == (12_000.0, 0.5)


def test_without_a_word_about_landing_the_system_status_tells(observer: Observer) -> None:
    for status, armed, landed in ((3, False, True), (3, True, True), (4, True, False)):
        observer.receive(beat(1, autopilot=ARDUPILOT, mode=4, armed=armed, status=status), 0.0)
        assert rows(observer, 0.0)[1]["landed"] is landed
    observer.receive(frame("EXTENDED_SYS_STATE", landed_state=mav.MAV_LANDED_STATE_ON_GROUND), 0.1)
    assert rows(observer, 0.1)[1]["landed"] is True


def test_where_a_vehicle_flies_to_is_its_target_or_what_it_was_sent(observer: Observer) -> None:
    observer.receive(beat(1), 0.0)
    observer.receive(placed("GPS_GLOBAL_ORIGIN", 0.0, 0.0, 0.0), 0.0)
    observer.receive(local(0.0, 0.0, 0.0), 0.0)
    target = {"coordinate_frame": 1, "type_mask": 0, "x": 4.0, "y": 5.0, "z": -6.0}
    observer.receive(frame("POSITION_TARGET_LOCAL_NED", **target), 0.1)
    assert rows(observer, 0.1)[1]["aim_ned"] == pytest.approx((4.0, 5.0, -6.0))
    observer.receive_sent(frame("SET_POSITION_TARGET_LOCAL_NED", 255, 190, target_system=1, **(target | {"x": 9.0})))
    assert rows(observer, 0.2)[1]["aim_ned"][0] == pytest.approx(9.0)


def test_what_is_inspected_is_told_in_mavlinks_own_units(observer: Observer) -> None:
    observer.receive(beat(1), 0.0)
    observer.inspection.want({1})
    for i in range(5):
        observer.receive(placed("GLOBAL_POSITION_INT", 0.0, 0.0, 0.0, 1, vx=125), 1.0 + 0.2 * i)
    told = shown(observer, 2.0)["inspected"]["1"]["GLOBAL_POSITION_INT"]
    assert (told["count"], told["fields"]["vx"]) == (5, 125)
    assert told["rate_hz"] == pytest.approx(5.0)


def test_silence_is_told_and_its_end(observer: Observer) -> None:
    observer.receive(beat(1), 0.0)
    observer.receive(placed("GPS_GLOBAL_ORIGIN", 0.0, 0.0, 0.0), 0.0)
    observer.receive(local(0.0, 0.0, 0.0), 0.0)
    rows(observer, 0.1)
    row = rows(observer, 6.0)[1]
    assert row["trouble"][0] == "no telemetry for 6 s"
    assert (row["severity"], row["condition"], row["figure"], row["urgency"]) == (2, "silent", "6 s", 6.0)
    observer.receive(beat(1), 7.0)
    observer.receive(local(0.0, 0.0, 0.0), 7.0)
    events = shown(observer, 7.0)["events"]
    assert [e["text"] for e in events if e["kind"] == "link"] == ["Heard again"]


def test_seldom_positions_of_a_vehicle_that_is_heard_are_no_silence(observer: Observer) -> None:
    """HEARTBEAT each second, ATTITUDE each half, a place each two seconds; from 12 s on ATTITUDE alone, from 18 s
    nothing."""
    texts, troubles = [], set()
    for half in range(48):
        t_s = 0.5 * half
        if half % 2 == 0 and t_s < 12.0:
            observer.receive(beat(1), t_s)
        if half % 4 == 0 and t_s < 12.0:
            observer.receive(placed("GPS_GLOBAL_ORIGIN", 0.0, 0.0, 0.0), t_s)
            observer.receive(local(0.0, 0.0, 0.0), t_s)
        if t_s < 18.0:
            observer.receive(frame("ATTITUDE"), t_s)
        snapshot = shown(observer, t_s + 0.2)
        texts += [event["text"] for event in snapshot["events"] if event["kind"] == "link"]
        (row,) = snapshot["vehicles"]
        troubles |= {(text, t_s < 12.0, t_s < 18.0) for text in map(str.rstrip, (t[:8] for t in row["trouble"]))}
        assert row["heard_s"] == pytest.approx(0.2 + max(0.0, t_s - 17.5))
    assert texts == [
        "First heard of: px4 autopilot",
        "No position for 1.7 s, though it is heard",
        "No telemetry for 1.7 s",
    ]
    assert troubles == {
        ("position", True, True), ("position", False, True), ("no HEART", False, True),
        ("no HEART", False, False), ("position", False, False), ("no telem", False, False),
    }  # fmt: skip


def test_numbers_that_are_none_do_no_harm(observer: Observer) -> None:
    observer.receive(beat(1), 0.0)
    observer.receive(frame("GPS_GLOBAL_ORIGIN"), 0.0)
    observer.receive(frame("GLOBAL_POSITION_INT"), 4.0)
    observer.receive(local(math.nan, 0.0, math.inf), 4.0)
    observer.receive(frame("ATTITUDE", yaw=math.nan), 4.0)
    observer.receive(placed("HOME_POSITION", 0.0, 0.0, 0.0, 1, x=math.nan), 4.0)
    observer.receive(frame("AHRS2"), 4.1)
    assert rows(observer, 4.2)[1]["p_ned"] is None


def test_a_flood_of_texts_makes_a_bounded_snapshot_and_says_how_many_were_left_out(observer: Observer) -> None:
    observer.receive(beat(), 0.0)
    for n in range(3 * MOST_EVENTS):
        observer.receive(frame("STATUSTEXT", severity=4, text=f"text {n}".encode()), 0.1)
    events = shown(observer, 0.2)["events"]
    assert len(events) == MOST_EVENTS + 1
    assert events[-1]["text"] == f"{2 * MOST_EVENTS + 1} further events are left out"
    assert shown(observer, 0.3)["events"] == []


def test_invented_components_cost_a_bounded_room(observer: Observer) -> None:
    for sysid in range(1, 21):
        observer.receive(beat(sysid), 0.0)
        for compid in range(256):
            observer.receive(codec.Frame(sysid, compid, 0, 9_999, b""), 0.0)
    assert len(observer._gaps._missing_of) == MOST_SENDERS


@pytest.mark.parametrize("lie", [{"x": 1e38}, {"z": -3e38}, {"altitude": 2**31 - 1}, {"altitude": -(2**31)}])
def test_a_home_that_cannot_be_is_no_origin(lie: dict[str, float]) -> None:
    observer = Observer("monitor", "udpin:0.0.0.0:14550")
    beat = {"type": 2, "autopilot": 12, "base_mode": 0, "custom_mode": 0, "system_status": 4}
    home = {"latitude": 474_000_000, "longitude": 85_000_000, "altitude": 488_000, "x": 0.0, "y": 0.0, "z": 0.0,
            "q": (1.0, 0.0, 0.0, 0.0), "approach_x": 0.0, "approach_y": 0.0, "approach_z": 0.0}  # fmt: skip
    place = {"time_boot_ms": 1000, "x": 1.0, "y": 2.0, "z": -3.0, "vx": 0.0, "vy": 0.0, "vz": 0.0}
    for name, fields in (("HEARTBEAT", beat), ("HOME_POSITION", home | lie), ("LOCAL_POSITION_NED", place)):
        (frame,) = codec.split(codec.encode(name, 0, 7, 1, **fields)).frames
        observer.receive(frame, 1.0)
    json.dumps(shown(observer, 1.0), allow_nan=False)


def test_events_are_shown_in_the_order_of_their_times(observer: Observer) -> None:
    """As a replay adds what was decided to what it has found meanwhile."""
    for late in (5.0, 7.0):
        observer.add_event(Event(late, 0, "info", "found", "session"))
    observer.add_event(Event(6.0, 0, "info", "ordered", "operator"))
    assert [event["t_s"] for event in shown(observer, 8.0)["events"]] == [5.0, 6.0, 7.0]
